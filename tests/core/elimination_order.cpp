// Multipliers of equations that follow from others (linear/elimination_order.hpp) need no pivot of others: fronts
// of a ladder are no larger than a loop and the rung below, and smaller than if nobody had said so.
#include "../../core/src/linear/assembly_tree.cpp"
#include "../../core/src/linear/elimination_order.cpp"
#include "../../core/src/model/errors.cpp"
#include "../../core/src/system/pattern.cpp"

#include <cstdio>
#include <set>
#include <utility>

using namespace dalembert;

namespace {

constexpr int body = 6, joint = 5,
              redundant =
                  3;  // coordinates; equations of a revolute joint; the redundant ones of a planar loop in space

struct Ladder {
  std::vector<std::set<int>> columns;  // rows of each
  std::vector<double> diagonal;
  std::vector<int> dependent;

  // Each loop stands on the rung below with two posts, which carry the next rung.
  explicit Ladder(int loops) {
    int below = -1;
    for (int k = 0; k < loops; ++k) {
      const int left = add_body(), right = add_body(), rung = add_body();
      const int last = (add_joint(below, left), add_joint(below, right), add_joint(left, rung), add_joint(right, rung));
      for (int i = 0; i < redundant; ++i) dependent.push_back(last + i);
      below = rung;
    }
  }

  int add(int unknowns, double entry) {
    const int first = static_cast<int>(columns.size());
    for (int i = 0; i < unknowns; ++i) {
      columns.push_back({first + i});
      diagonal.push_back(entry);
    }
    return first;
  }
  int add_body() {
    const int first = add(body, 1);
    couple(first, body, first, body);
    return first;
  }
  int add_joint(int one, int other) {
    const int first = add(joint, 0);
    for (const int at : {one, other})
      if (at >= 0) couple(at, body, first, joint);
    return first;
  }
  void couple(int i, int rows, int j, int count) {
    for (int r = i; r < i + rows; ++r)
      for (int c = j; c < j + count; ++c) {
        columns[static_cast<std::size_t>(c)].insert(r);
        columns[static_cast<std::size_t>(r)].insert(c);
      }
  }

  std::size_t largest_front(std::span<const int> known_to_depend) const {
    std::vector<int> starts{0}, rows;
    std::vector<double> values;
    for (std::size_t j = 0; j < columns.size(); ++j) {
      for (const int i : columns[j]) {
        rows.push_back(i);
        values.push_back(i == static_cast<int>(j) ? diagonal[j] : 1);
      }
      starts.push_back(static_cast<int>(rows.size()));
    }
    const Pattern pattern = Pattern::sparse(std::move(starts), std::move(rows));
    const PivotSurplus surplus = pivot_surplus(pattern, values, known_to_depend);
    std::size_t largest = 0;
    for (const FrontStructure& front : assembly_tree(pattern, minimum_degree_order(pattern, surplus)))
      largest = std::max(largest, front.pivots.size() + front.updates.size());
    return largest;
  }
};

int check(bool good, const char* what) {
  if (!good) std::printf("%s\n", what);
  return good ? 0 : 1;
}

}  // namespace

int main() {
  const Ladder few(20), many(80);
  const std::size_t unknowns_of_loop = 3 * body + 4 * joint;
  int failures = check(many.largest_front(many.dependent) <= unknowns_of_loop + body,
                       "fronts are larger than a loop and the rung below");
  failures += check(many.largest_front(many.dependent) == few.largest_front(few.dependent),
                    "fronts grow with the number of loops");
  failures += check(many.largest_front(many.dependent) < many.largest_front({}),
                    "it makes no difference what depends on others");
  return failures;
}
