// A kernel between any number of markers is refused when a member is missing, misspelt or has another signature. Data of pairs
// live as long as the pairs do.
#include <vector>

#include "dalembert/contracts/many_ports.hpp"
#include "dalembert/system/system_term.hpp"

using namespace dalembert;

namespace {

struct Parameters {
  bool activeConnector = true;
};

struct Complete : AllMarkersAct, NoAlgebraicEquations, NoHistory, NoOutputs {
  using Parameters = ::Parameters;
  template <class S>
  static void evaluate(const Parameters&, const Context&, Exchange<S>&) {}
  static void check(const Parameters&, const Connections&) {}
};
static_assert(ManyPortsKernel<Complete>);

struct MissesCheck : AllMarkersAct, NoAlgebraicEquations, NoHistory, NoOutputs {
  using Parameters = ::Parameters;
  template <class S>
  static void evaluate(const Parameters&, const Context&, Exchange<S>&) {}
};
static_assert(!ManyPortsKernel<MissesCheck>);

struct Misspelt : AllMarkersAct, NoAlgebraicEquations, NoSwitches, NoOutputs {
  using Parameters = ::Parameters;
  template <class S>
  static void evaluate(const Parameters&, const Context&, Exchange<S>&) {}
  static void check(const Parameters&, const Connections&) {}
  static constexpr bool has_history = true;
  static PostNewton updates(const Parameters&, const Context&, const Exchange<double>&, const History&) { return {}; }
};
static_assert(!ManyPortsKernel<Misspelt>);

struct WrongSignature : Complete {
  static int output(const Parameters&, const Context&, const Exchange<double>&, OutputVariableType, std::vector<double>&) { return 0; }
};
static_assert(!ManyPortsKernel<WrongSignature>);

int data_of_pairs() {
  using Pairs = PairList<int>;
  Pairs pairs;
  std::vector<Pairs::Pair> found{{2, 3}, {0, 1}};
  int failures = !pairs.renew(found);
  pairs.data(0) = 7;
  pairs.keep();
  pairs.data(0) = 8;
  pairs.data(1) = 9;
  found = {{2, 3}, {0, 1}, {1, 2}};
  failures += !pairs.renew(found) || pairs.size() != 3;
  failures += pairs.data(0) != 8 || pairs.data(1) != 0 || pairs.data(2) != 9;
  pairs.restore();
  failures += pairs.data(0) != 7 || pairs.data(1) != 0 || pairs.data(2) != 0;
  found = {{1, 2}, {0, 1}, {2, 3}};
  failures += pairs.renew(found);
  found = {{1, 2}};
  failures += !pairs.renew(found) || pairs.contains({0, 1}) || !pairs.contains({1, 2});
  return failures;
}

}  // namespace

int main() { return data_of_pairs(); }
