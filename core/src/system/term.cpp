#include "dalembert/system/term.hpp"

#include <algorithm>
#include <limits>

namespace dalembert {

void Term::poses(int first, int count, const Evaluation& evaluation, double* rows) const {
  for (int i = first; i < first + count; ++i, rows += 12) {
    Motion<double> m;
    if (motion(i, evaluation, {}, m)) {
      write_pose(m.position, m.rotation, rows);
    } else {
      std::fill(rows, rows + 12, std::numeric_limits<double>::quiet_NaN());
    }
  }
}

}  // namespace dalembert
