// Amestoy, Davis, Duff: An approximate minimum degree ordering algorithm, SIAM J. Matrix Analysis 17 (1996), with
// eligibility of the unknowns by counting.
#include "elimination_order.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "dalembert/math/stretch.hpp"

namespace dalembert {

namespace {

constexpr std::uint64_t mixing_factor = 0x9E3779B97F4A7C15u;  // of hashes

// The quotient graph: vertices are groups of unknowns with the same neighbours, elements are groups that have been
// eliminated, with the vertices they have made neighbours of each other.
class QuotientGraph {
 public:
  QuotientGraph(const Pattern& pattern, const PivotSurplus& surplus);
  EliminationOrder order();

 private:
  enum class State : char { vertex, element, gone };
  struct Node {
    State state = State::vertex;
    int weight = 0;  // unknowns; for an element: of its vertices
    int surplus = 0;  // unknowns with a pivot minus those without; for an element: of all eliminated unknowns
    int degree = 0;
    int previous = -1, next = -1, key = -1;  // links in the list of vertices with the same key
    Stretch vertices, elements;              // neighbours, in vertices_ and elements_
    int first_member = -1, last_member = -1;  // unknowns
  };

  void group_equal_columns(const Pattern& pattern, const PivotSurplus& surplus);
  void connect(const Pattern& pattern);
  void insert(int i);
  void remove(int i);
  int take_first();
  void eliminate(int i);
  void gather(int pivot);
  void measure_elements();
  void update_vertex(int i, int pivot);
  void eliminate_inner(int pivot);
  void merge_equal();
  bool equal(int i, int j);
  bool eligible(const Node& node) const;
  bool is_gone(int i) const { return nodes_[i].state == State::gone; }
  // Keeps the order of the other entries.
  template <class F>
  static void erase_if(std::vector<int>& numbers, Stretch& list, F&& f) {
    const auto begin = numbers.begin() + list.first;
    list.count = static_cast<std::uint32_t>(std::remove_if(begin, begin + list.count, f) - begin);
  }
  void forget_gone_elements(Node& node) {
    erase_if(elements_, node.elements, [&](int e) { return is_gone(e); });
  }
  void forget_gone_of_reach() {
    std::erase_if(reach_, [&](int i) { return is_gone(i); });
  }
  template <class F>
  void for_each_member(const Node& node, F&& f) const {
    for (int j = node.first_member; j >= 0; j = next_member_[j]) f(j);
  }

  int size_;
  std::vector<Node> nodes_;
  // Neighbours of all nodes. A vertex has no more elements than it has lost vertices: they take as much room at most.
  std::vector<int> vertices_, elements_;
  std::vector<int> next_member_;  // per unknown: the next one of its node
  std::vector<int> group_;  // per unknown: its node
  std::vector<int> first_;        // vertices by key: the degree, and `size_` more if not eligible
  int lowest_ = 0;                // no smaller key is in use
  int left_;                      // unknowns that are not eliminated
  std::vector<int> mark_, outside_, outside_mark_;
  int stamp_ = 0;
  std::vector<int> reach_;        // vertices of the new element
  std::vector<std::pair<std::uint64_t, int>> hashes_;
  EliminationOrder order_;
};

QuotientGraph::QuotientGraph(const Pattern& pattern, const PivotSurplus& surplus)
    : size_(pattern.size()),
      next_member_(size_, -1),
      group_(size_),
      first_(2 * static_cast<std::size_t>(size_) + 1, -1),
      left_(size_) {
  group_equal_columns(pattern, surplus);
  const auto count = nodes_.size();
  mark_.assign(count, 0);
  outside_.assign(count, 0);
  outside_mark_.assign(count, 0);
  connect(pattern);
  for (int i = 0; i < static_cast<int>(count); ++i) insert(i);
  order_.reserve(static_cast<std::size_t>(size_));
}

// The first unknown with the same column as each one.
std::vector<int> equal_columns(const Pattern& pattern) {
  const auto starts = pattern.column_start(), rows = pattern.row_index();
  const auto column = [&](int j) { return rows.subspan(starts[j], starts[j + 1] - starts[j]); };
  const auto size = static_cast<std::size_t>(pattern.size());
  const int bits = std::bit_width(2 * size);
  std::vector<int> table(std::size_t{1} << bits, -1), leader(size);
  std::vector<std::uint64_t> hash(size, 0);
  for (int j = 0; j < pattern.size(); ++j) {
    for (const int i : column(j)) hash[j] = (std::rotl(hash[j], 5) ^ static_cast<std::uint64_t>(i)) * mixing_factor;
    const auto same = [&](int k) { return hash[k] == hash[j] && std::ranges::equal(column(k), column(j)); };
    std::size_t place = hash[j] * mixing_factor >> (64 - bits);
    while (table[place] >= 0 && !same(table[place])) place = (place + 1) % table.size();
    if (table[place] < 0) table[place] = j;
    leader[j] = table[place];
  }
  return leader;
}

void QuotientGraph::group_equal_columns(const Pattern& pattern, const PivotSurplus& surplus) {
  const std::vector<int> leader = equal_columns(pattern);
  for (int j = 0; j < size_; ++j) {
    if (leader[j] == j) {
      group_[j] = static_cast<int>(nodes_.size());
      nodes_.emplace_back().first_member = j;
    } else {
      group_[j] = group_[leader[j]];
      next_member_[nodes_[group_[j]].last_member] = j;
    }
    Node& node = nodes_[group_[j]];
    ++node.weight;
    node.surplus += surplus[j];
    node.last_member = j;
  }
}

void QuotientGraph::connect(const Pattern& pattern) {
  const auto starts = pattern.column_start(), rows = pattern.row_index();
  for (int i = 0; i < static_cast<int>(nodes_.size()); ++i) {
    ++stamp_;
    mark_[i] = stamp_;
    Node& node = nodes_[i];
    node.vertices.first = node.elements.first = static_cast<std::uint32_t>(vertices_.size());
    const int j = node.first_member;
    for (int k = starts[j]; k < starts[j + 1]; ++k) {
      const int other = group_[rows[k]];
      if (mark_[other] == stamp_) continue;
      mark_[other] = stamp_;
      vertices_.push_back(other);
      node.degree += nodes_[other].weight;
    }
    node.vertices.count = static_cast<std::uint32_t>(vertices_.size()) - node.vertices.first;
  }
  elements_.resize(vertices_.size());
}

// Pivots for all unknowns of the vertex are available in itself and in adjacent eliminated unknowns.
bool QuotientGraph::eligible(const Node& node) const {
  int surplus = node.surplus;
  for (const int e : node.elements.of(elements_)) surplus += nodes_[e].surplus;
  return surplus >= 0;
}

void QuotientGraph::insert(int i) {
  Node& node = nodes_[i];
  node.key = node.degree + (eligible(node) ? 0 : size_);
  node.previous = -1;
  node.next = first_[node.key];
  if (node.next >= 0) nodes_[node.next].previous = i;
  first_[node.key] = i;
  lowest_ = std::min(lowest_, node.key);
}

void QuotientGraph::remove(int i) {
  const Node& node = nodes_[i];
  (node.previous >= 0 ? nodes_[node.previous].next : first_[node.key]) = node.next;
  if (node.next >= 0) nodes_[node.next].previous = node.previous;
}

int QuotientGraph::take_first() {
  while (first_[lowest_] < 0) ++lowest_;
  const int i = first_[lowest_];
  remove(i);
  return i;
}

EliminationOrder QuotientGraph::order() {
  while (left_ > 0) {
    const int pivot = take_first();
    gather(pivot);
    eliminate(pivot);
    nodes_[pivot].state = State::element;
    measure_elements();
    for (const int i : reach_) update_vertex(i, pivot);
    eliminate_inner(pivot);
    merge_equal();
    Node& element = nodes_[pivot];
    element.vertices = {static_cast<std::uint32_t>(vertices_.size()), static_cast<std::uint32_t>(reach_.size())};
    vertices_.insert(vertices_.end(), reach_.begin(), reach_.end());
    for (const int i : reach_) {
      Node& node = nodes_[i];
      node.degree = std::min(node.degree + element.weight, left_) - node.weight;
      insert(i);
    }
  }
  return std::move(order_);
}

void QuotientGraph::eliminate(int i) {
  Node& node = nodes_[i];
  for_each_member(node, [&](int j) { order_.push_back(j); });
  left_ -= node.weight;
  node.state = State::gone;
}

// The vertices that the elimination of the pivot makes neighbours; the elements around it are part of the new one.
void QuotientGraph::gather(int pivot) {
  reach_.clear();
  mark_[pivot] = ++stamp_;
  const auto add = [&](int i) {
    if (nodes_[i].state != State::vertex || mark_[i] == stamp_) return;
    mark_[i] = stamp_;
    reach_.push_back(i);
  };
  Node& node = nodes_[pivot];
  for (const int e : node.elements.of(elements_)) {
    Node& element = nodes_[e];
    if (element.state != State::element) continue;
    std::ranges::for_each(element.vertices.of(vertices_), add);
    node.surplus += element.surplus;
    element.state = State::gone;
  }
  std::ranges::for_each(node.vertices.of(vertices_), add);
  node.elements.count = 0;
  for (const int i : reach_) remove(i);
}

// Unknowns of each element around the new one that are not in the new one.
void QuotientGraph::measure_elements() {
  for (const int i : reach_) {
    for (const int e : nodes_[i].elements.of(elements_)) {
      if (nodes_[e].state != State::element) continue;
      if (outside_mark_[e] != stamp_) {
        outside_mark_[e] = stamp_;
        outside_[e] = nodes_[e].weight;
      }
      outside_[e] -= nodes_[i].weight;
    }
  }
}

// Neighbours of a vertex of the new element, its degree outside of it, and a hash of its neighbours.
void QuotientGraph::update_vertex(int i, int pivot) {
  Node& node = nodes_[i];
  node.degree = 0;
  for (const int e : node.elements.of(elements_)) {
    if (nodes_[e].state != State::element) continue;
    if (outside_[e] == 0) {  // all of it is in the new element
      nodes_[pivot].surplus += nodes_[e].surplus;
      nodes_[e].state = State::gone;
    } else {
      node.degree += outside_[e];
    }
  }
  forget_gone_elements(node);
  elements_[node.elements.first + node.elements.count++] = pivot;
  erase_if(vertices_, node.vertices, [&](int j) { return is_gone(j) || mark_[j] == stamp_; });
  for (const int j : node.vertices.of(vertices_)) node.degree += nodes_[j].weight;
}

// Vertices without other neighbours follow the pivot at once.
void QuotientGraph::eliminate_inner(int pivot) {
  Node& element = nodes_[pivot];
  for (bool again = true; again;) {
    again = false;
    for (const int i : reach_) {
      Node& node = nodes_[i];
      forget_gone_elements(node);
      const bool inner = node.vertices.count == 0 && node.elements.count == 1;
      if (node.state != State::vertex || !inner || element.surplus + node.surplus < 0) continue;
      element.surplus += node.surplus;
      eliminate(i);
      again = true;
    }
  }
  forget_gone_of_reach();
  element.weight = 0;
  for (const int i : reach_) element.weight += nodes_[i].weight;
}

void QuotientGraph::merge_equal() {
  hashes_.clear();
  for (const int i : reach_) {
    std::uint64_t hash = 0;
    for (const int e : nodes_[i].elements.of(elements_)) hash += static_cast<std::uint64_t>(e) + 1;
    for (const int j : nodes_[i].vertices.of(vertices_)) hash += (static_cast<std::uint64_t>(j) + 1) * mixing_factor;
    hashes_.emplace_back(hash, i);
  }
  std::sort(hashes_.begin(), hashes_.end());
  for (std::size_t a = 0; a < hashes_.size(); ++a) {
    const int i = hashes_[a].second;
    if (nodes_[i].state != State::vertex) continue;
    for (std::size_t b = a + 1; b < hashes_.size() && hashes_[b].first == hashes_[a].first; ++b) {
      const int j = hashes_[b].second;
      if (nodes_[j].state != State::vertex || !equal(i, j)) continue;
      Node &to = nodes_[i], &from = nodes_[j];
      to.weight += from.weight;
      to.surplus += from.surplus;
      next_member_[to.last_member] = from.first_member;
      to.last_member = from.last_member;
      from.weight = from.surplus = 0;
      from.state = State::gone;
    }
  }
  forget_gone_of_reach();
}

bool QuotientGraph::equal(int i, int j) {
  const Node &a = nodes_[i], &b = nodes_[j];
  if (a.elements.count != b.elements.count || a.vertices.count != b.vertices.count) return false;
  ++stamp_;
  for (const int e : a.elements.of(elements_)) mark_[e] = stamp_;
  for (const int v : a.vertices.of(vertices_)) mark_[v] = stamp_;
  const auto marked = [&](int k) { return mark_[k] == stamp_; };
  return std::ranges::all_of(b.elements.of(elements_), marked) && std::ranges::all_of(b.vertices.of(vertices_), marked);
}

}  // namespace

PivotSurplus pivot_surplus(const Pattern& pattern, std::span<const double> values, std::span<const int> dependent) {
  const auto starts = pattern.column_start(), rows = pattern.row_index();
  PivotSurplus surplus(static_cast<std::size_t>(pattern.size()));
  for (int j = 0; j < pattern.size(); ++j) surplus[j] = values[pattern.slot(j, j)] != 0 ? 1 : -1;
  std::vector<int> partner(surplus.size(), -1);
  for (int j = 0; j < pattern.size(); ++j) {
    if (surplus[j] > 0) continue;
    double largest = 0;
    for (int k = starts[j]; k < starts[j + 1]; ++k) {
      if (surplus[rows[k]] > 0 || !(std::abs(values[k]) > largest)) continue;
      largest = std::abs(values[k]);
      partner[j] = rows[k];
    }
  }
  for (int j = 0; j < pattern.size(); ++j)
    if (partner[j] > j && partner[partner[j]] == j) surplus[j] = 1;
  for (const int j : dependent)
    if (surplus[j] < 0) surplus[j] = 0;
  return surplus;
}

EliminationOrder minimum_degree_order(const Pattern& pattern, const PivotSurplus& surplus) {
  return QuotientGraph(pattern, surplus).order();
}

}  // namespace dalembert
