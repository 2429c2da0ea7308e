// Hairer, Norsett, Wanner: Solving Ordinary Differential Equations I, 2nd edition: classical methods table II.1.2, Dormand
//   and Prince table II.5.2, Verner table II.5.4; the method of order 8 with its two estimates: section II.10.
// Butcher: On Runge-Kutta processes of high order, Journal of the Australian Mathematical Society 4 (1964).
// Bogacki, Shampine: A 3(2) pair of Runge-Kutta formulas, Applied Mathematics Letters 2 (1989).
#include "dalembert/solvers/runge_kutta.hpp"

#include <cmath>

namespace dalembert {

namespace {

RungeKuttaMethod make(int order, std::vector<double> c, std::vector<std::vector<double>> rows, std::vector<double> b,
                      std::vector<double> b_error = {}, std::vector<double> b_third = {}) {
  RungeKuttaMethod m;
  m.stages = static_cast<int>(b.size());
  m.order = order;
  m.b = std::move(b);
  m.c = std::move(c);
  m.b_error = std::move(b_error);
  m.b_third = std::move(b_third);
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

RungeKuttaMethod dormand_prince_8() {
  return make(8,
              {0, 0.05260015195876773, 0.0789002279381516, 0.1183503419072274, 0.2816496580927726, 0.3333333333333333,
               0.25, 0.3076923076923077, 0.6512820512820513, 0.6, 0.8571428571428571, 1},
              {{0.05260015195876773},
               {0.0197250569845379, 0.0591751709536137},
               {0.02958758547680685, 0, 0.08876275643042054},
               {0.2413651341592667, 0, -0.8845494793282861, 0.924834003261792},
               {0.037037037037037035, 0, 0, 0.17082860872947386, 0.12546768756682242},
               {0.037109375, 0, 0, 0.17025221101954405, 0.06021653898045596, -0.017578125},
               {0.03709200011850479, 0, 0, 0.17038392571223998, 0.10726203044637328, -0.015319437748624402,
                0.008273789163814023},
               {0.6241109587160757, 0, 0, -3.3608926294469414, -0.868219346841726, 27.59209969944671,
                20.154067550477894, -43.48988418106996},
               {0.47766253643826434, 0, 0, -2.4881146199716677, -0.590290826836843, 21.230051448181193,
                15.279233632882423, -33.28821096898486, -0.020331201708508627},
               {-0.9371424300859873, 0, 0, 5.186372428844064, 1.0914373489967295, -8.149787010746927,
                -18.52006565999696, 22.739487099350505, 2.4936055526796523, -3.0467644718982196},
               {2.273310147516538, 0, 0, -10.53449546673725, -2.0008720582248625, -17.9589318631188, 27.94888452941996,
                -2.8589982771350235, -8.87285693353063, 12.360567175794303, 0.6433927460157636}},
              {0.054293734116568765, 0, 0, 0, 0, 4.450312892752409, 1.8915178993145003, -5.801203960010585,
               0.3111643669578199, -0.1521609496625161, 0.20136540080403034, 0.04471061572777259},
              {0.04117368912237389, 0, 0, 0, 0, 5.675469339128614, 2.3872768489717506, -7.465581142465571,
               0.6614932157077935, -0.48634006837553356, 0.11944219431891463, 0.06706592359165889},
              {0.2440944881889764, 0, 0, 0, 0, 0, 0, 0, 0.7338466882816118, 0, 0, 0.022058823529411766});
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
    case DynamicSolverType::DOP853: return dormand_prince_8();
    case DynamicSolverType::DVERK6: return verner();
    default: return {};
  }
}

}  // namespace dalembert
