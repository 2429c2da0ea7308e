// Hairer, Norsett, Wanner: Solving Ordinary Differential Equations I, 2nd edition: classical methods table II.1.2, Dormand
//   and Prince table II.5.2, Verner table II.5.4.
// Butcher: On Runge-Kutta processes of high order, Journal of the Australian Mathematical Society 4 (1964).
// Bogacki, Shampine: A 3(2) pair of Runge-Kutta formulas, Applied Mathematics Letters 2 (1989).
#include "dalembert/solvers/runge_kutta.hpp"

#include <cmath>

namespace dalembert {

namespace {

RungeKuttaMethod make(int order, std::vector<double> c, std::vector<std::vector<double>> rows, std::vector<double> b,
                      std::vector<double> b_error = {}) {
  RungeKuttaMethod m;
  m.stages = static_cast<int>(b.size());
  m.order = order;
  m.b = std::move(b);
  m.c = std::move(c);
  m.b_error = std::move(b_error);
  m.a.assign(static_cast<std::size_t>(m.stages * m.stages), 0.0);
  for (int i = 1; i < m.stages; ++i) {
    for (int j = 0; j < i; ++j) m.a[static_cast<std::size_t>(i * m.stages + j)] = rows[i - 1][j];
  }
  return m;
}

RungeKuttaMethod butcher_6() {
  const double r = std::sqrt(5.0), low = 0.5 - r / 10, high = 0.5 + r / 10;
  return make(6, {0, low, high, low, high, low, 1},
              {{low},
               {-r / 10, 0.5 + r / 5},
               {7 * r / 20 - 0.75, r / 4 - 0.25, 1.5 - 7 * r / 10},
               {1.0 / 12 - r / 60, 0, 1.0 / 6, 7 * r / 60 + 0.25},
               {1.0 / 12 + r / 60, 0, 0.75 - 5 * r / 12, 1.0 / 6, 3 * r / 10 - 0.5},
               {1.0 / 6, 0, 25 * r / 12 - 55.0 / 12, -7 * r / 12 - 25.0 / 12, 5 - 2 * r, 2.5 + r / 2}},
              {1.0 / 12, 0, 0, 0, 5.0 / 12, 5.0 / 12, 1.0 / 12});
}

RungeKuttaMethod bogacki_shampine() {
  return make(3, {0, 1.0 / 2, 3.0 / 4, 1}, {{1.0 / 2}, {0, 3.0 / 4}, {2.0 / 9, 1.0 / 3, 4.0 / 9}},
              {2.0 / 9, 1.0 / 3, 4.0 / 9, 0}, {7.0 / 24, 1.0 / 4, 1.0 / 3, 1.0 / 8});
}

RungeKuttaMethod dormand_prince() {
  return make(5, {0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1},
              {{1.0 / 5},
               {3.0 / 40, 9.0 / 40},
               {44.0 / 45, -56.0 / 15, 32.0 / 9},
               {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
               {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
               {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}},
              {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84, 0},
              {5179.0 / 57600, 0, 7571.0 / 16695, 393.0 / 640, -92097.0 / 339200, 187.0 / 2100, 1.0 / 40});
}

RungeKuttaMethod verner() {
  return make(6, {0, 1.0 / 6, 4.0 / 15, 2.0 / 3, 5.0 / 6, 1, 1.0 / 15, 1},
              {{1.0 / 6},
               {4.0 / 75, 16.0 / 75},
               {5.0 / 6, -8.0 / 3, 5.0 / 2},
               {-165.0 / 64, 55.0 / 6, -425.0 / 64, 85.0 / 96},
               {12.0 / 5, -8, 4015.0 / 612, -11.0 / 36, 88.0 / 255},
               {-8263.0 / 15000, 124.0 / 75, -643.0 / 680, -81.0 / 250, 2484.0 / 10625, 0},
               {3501.0 / 1720, -300.0 / 43, 297275.0 / 52632, -319.0 / 2322, 24068.0 / 84065, 0, 3850.0 / 26703}},
              {3.0 / 40, 0, 875.0 / 2244, 23.0 / 72, 264.0 / 1955, 0, 125.0 / 11592, 43.0 / 616},
              {13.0 / 160, 0, 2375.0 / 5984, 5.0 / 16, 12.0 / 85, 3.0 / 44, 0, 0});
}

}  // namespace

RungeKuttaMethod runge_kutta_method(DynamicSolverType type) {
  switch (type) {
    case DynamicSolverType::ExplicitEuler: return make(1, {0}, {}, {1});
    case DynamicSolverType::ExplicitMidpoint: return make(2, {0, 0.5}, {{0.5}}, {0, 1});
    case DynamicSolverType::RK33: return make(3, {0, 1.0 / 3, 2.0 / 3}, {{1.0 / 3}, {0, 2.0 / 3}}, {0.25, 0, 0.75});
    case DynamicSolverType::RK44:
      return make(4, {0, 0.5, 0.5, 1}, {{0.5}, {0, 0.5}, {0, 0, 1}}, {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6});
    case DynamicSolverType::RK67: return butcher_6();
    case DynamicSolverType::ODE23: return bogacki_shampine();
    case DynamicSolverType::DOPRI5: return dormand_prince();
    case DynamicSolverType::DVERK6: return verner();
    default: return {};
  }
}

}  // namespace dalembert
