// A kernel between any number of markers is refused when a member is missing, misspelt or has another signature.
#include <vector>

#include "dalembert/contracts/many_ports.hpp"

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
  static int output(const Parameters&, const Context&, const Exchange<double>&, OutputVariableType,
                    std::vector<double>&) {
    return 0;
  }
};
static_assert(!ManyPortsKernel<WrongSignature>);

}  // namespace

int main() { return 0; }
