#include "dalembert/solvers/error.hpp"

#include <array>

#include "dalembert/output/numbers.hpp"

namespace dalembert {

namespace {

struct Words {
  std::string_view name, sentence, values;  // values: title of the list of values
};

// The order is that of FailureReason.
constexpr std::array<Words, 17> words{{
    {"", "no failure", ""},
    {"newton", "Newton's method did not converge", "largest residuals"},
    {"openConstraints", "the step leaves gaps that cannot be closed", "largest gaps"},
    {"singularMatrix", "the system matrix is singular", ""},
    {"freeDirection", "the system matrix is singular: something can move without inertia or stiffness", ""},
    {"contradictoryConstraints", "constraints contradict each other", "what the closest fit leaves open"},
    {"massMatrix", "the mass matrix is singular", ""},
    {"discontinuousIteration", "the discontinuous iteration (contact, friction) did not settle", ""},
    {"eventChatter", "events follow each other ever faster", ""},
    {"errorControl", "the error stays above the tolerances at the smallest step size",
     "largest errors, in units of the tolerances"},
    {"stiffForMethod", "the system is stiff for this method: steps of the smallest size are not stable",
     "largest errors, in units of the tolerances"},
    {"singularPosition",
     "the mechanism does not get away from a singular position, in which it could go on in more ways than one",
     "largest residuals, or errors in units of the tolerances"},
    {"toleranceBelowRoundOff", "the tolerances are below round-off", "largest errors, in units of the tolerances"},
    {"notFinite", "a value is not finite", "not finite"},
    {"unbounded", "the solution grows without bound", "largest values"},
    {"pathTooLong", "the path of equilibria has not met one of its ends", ""},
    {"timeLimit", "the time limit is reached", ""},
}};

const Words& words_of(FailureReason reason) { return words[static_cast<std::size_t>(reason)]; }

std::string line_of(const NamedValue& v) {
  const std::string name = v.vector == "equation" ? v.vector + " " + std::to_string(v.index)
                                                  : v.vector + "[" + std::to_string(v.index) + "]";
  return name + ": " + format_number(v.value) + (v.items.empty() ? "" : "  (" + v.items + ")");
}

void add_list(std::string& text, std::string_view title, const std::vector<std::string>& lines,
              const char* mark = "\n    ") {
  if (lines.empty()) return;
  text += "\n  " + std::string(title) + ":";
  for (const std::string& line : lines) text += mark + line;
}

}  // namespace

std::string_view name_of(FailureReason reason) { return words_of(reason).name; }

std::string Diagnosis::headline() const {
  std::string t = solver + ": " + std::string(words_of(reason).sentence);
  if (step == 0) return t + " at the start, time " + format_number(time);
  t += " in step " + std::to_string(step) + " at time " + format_number(time) + " (step size " +
       format_number(step_size) + ")";
  if (load_factor != 1) t += ", load factor " + format_number(load_factor);
  return t;
}

std::string Diagnosis::text() const {
  std::string t = headline() + ".";
  if (reason == FailureReason::discontinuous) {
    t += "\n  error " + format_number(residual) + " after " + std::to_string(newton_iteration) +
         " iterations (allowed " + format_number(tolerance_absolute) + ")";
  }
  if (reason == FailureReason::newton) {
    t += "\n  residual " + format_number(residual) + " after " + std::to_string(newton_iteration) +
         " iterations; relative " + format_number(relative_residual) + " (allowed " +
         format_number(tolerance_relative) + ", or absolute " + format_number(tolerance_absolute) + ")";
  }
  if (singular_row >= 0) {
    t += "\n  singular at unknown " + std::to_string(singular_row);
    if (!singular_items.empty()) t += ": " + singular_items;
  }
  add_list(t,
           reason == FailureReason::contradiction ? "apart, if all others are fulfilled"
                                                  : "equations that depend on each other",
           dependent);
  add_list(t, "what can move freely", free);
  std::vector<std::string> lines;
  for (const NamedValue& v : values) lines.push_back(line_of(v));
  add_list(t, words_of(reason).values, lines);
  add_list(t, "values that are not finite come from", sources);
  add_list(t, "what to try", advice, "\n    - ");
  return t;
}

}  // namespace dalembert
