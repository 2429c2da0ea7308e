#include "constraints/sparse_kernel.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "dalembert/math/decompositions.hpp"

namespace dalembert {

namespace {

using Block = Eigen::MatrixXd;

// Combinations of columns, and what they leave in rows that have not been eliminated.
struct Front {
  std::vector<int> groups;     // one after the other in `rest`
  Block rest;
  std::vector<int> columns;    // that are combined
  Block combinations;
};

class Elimination {
 public:
  Elimination(int columns, std::span<const int> groups, std::span<const SparseEntry> entries, double dependent, double independent)
      : dependent_(dependent), independent_(independent) {
    const int count = groups.empty() ? 0 : *std::ranges::max_element(groups) + 1;
    size_.assign(static_cast<std::size_t>(count), 0);
    fronts_of_.resize(size_.size());
    degree_.assign(size_.size(), 0);
    std::vector<int> place;  // of a row in its group
    for (const int g : groups) place.push_back(size_[static_cast<std::size_t>(g)]++);
    std::vector<std::vector<const SparseEntry*>> of_column(static_cast<std::size_t>(columns));
    for (const SparseEntry& e : entries) of_column[static_cast<std::size_t>(e.column)].push_back(&e);
    for (int k = 0; k < columns; ++k) {
      std::vector<int> own;
      for (const SparseEntry* e : of_column[static_cast<std::size_t>(k)]) own.push_back(groups[static_cast<std::size_t>(e->row)]);
      std::ranges::sort(own);
      own.erase(std::unique(own.begin(), own.end()), own.end());
      Front front{own, Block::Zero(rows_of(own), 1), {k}, Block::Ones(1, 1)};
      for (const SparseEntry* e : of_column[static_cast<std::size_t>(k)])
        front.rest(first_row(own, groups[static_cast<std::size_t>(e->row)]) + place[static_cast<std::size_t>(e->row)], 0) = e->value;
      add(std::move(front));
    }
  }

  std::optional<Block> kernel(int columns) {
    for (int g = 0; g < static_cast<int>(size_.size()); ++g)
      if (size_[static_cast<std::size_t>(g)] > 0) set_degree(g);
    while (!by_degree_.empty())
      if (!eliminate(by_degree_.begin()->second)) return {};
    Block all = Block::Zero(columns, count_);
    Eigen::Index first = 0;
    for (const Front& front : found_) {
      for (std::size_t i = 0; i < front.columns.size(); ++i)
        all.row(front.columns[i]).segment(first, front.combinations.cols()) = front.combinations.row(static_cast<Eigen::Index>(i));
      first += front.combinations.cols();
    }
    return all;
  }

 private:
  Eigen::Index rows_of(const std::vector<int>& groups) const {
    Eigen::Index rows = 0;
    for (const int g : groups) rows += size_[static_cast<std::size_t>(g)];
    return rows;
  }
  Eigen::Index first_row(const std::vector<int>& groups, int wanted) const {
    Eigen::Index row = 0;
    for (const int g : groups) {
      if (g == wanted) break;
      row += size_[static_cast<std::size_t>(g)];
    }
    return row;
  }

  void take(std::vector<int> columns, Block combinations) {
    if (combinations.cols() == 0) return;
    count_ += combinations.cols();
    found_.push_back({{}, {}, std::move(columns), std::move(combinations)});
  }

  void add(Front front) {
    if (front.groups.empty()) return take(std::move(front.columns), std::move(front.combinations));
    for (const int g : front.groups) fronts_of_[static_cast<std::size_t>(g)].push_back(static_cast<int>(fronts_.size()));
    fronts_.push_back(std::move(front));
  }

  // How many others its elimination would bring together.
  void set_degree(int group) {
    std::vector<int> others;
    for (const int f : fronts_of_[static_cast<std::size_t>(group)])
      others.insert(others.end(), fronts_[static_cast<std::size_t>(f)].groups.begin(), fronts_[static_cast<std::size_t>(f)].groups.end());
    std::ranges::sort(others);
    const auto degree = static_cast<int>(std::unique(others.begin(), others.end()) - others.begin());
    by_degree_.erase({degree_[static_cast<std::size_t>(group)], group});
    degree_[static_cast<std::size_t>(group)] = degree;
    by_degree_.emplace(degree, group);
  }

  // All that act on a group, which is the first one.
  Front together(int group) {
    const std::vector<int> parts = std::exchange(fronts_of_[static_cast<std::size_t>(group)], {});
    Front all;
    Eigen::Index columns = 0;
    for (const int f : parts) {
      const Front& part = fronts_[static_cast<std::size_t>(f)];
      all.groups.insert(all.groups.end(), part.groups.begin(), part.groups.end());
      all.columns.insert(all.columns.end(), part.columns.begin(), part.columns.end());
      columns += part.rest.cols();
    }
    all.groups.push_back(group);
    std::ranges::sort(all.groups);
    all.groups.erase(std::unique(all.groups.begin(), all.groups.end()), all.groups.end());
    std::ranges::rotate(all.groups.begin(), std::ranges::find(all.groups, group), std::ranges::find(all.groups, group) + 1);
    all.rest = Block::Zero(rows_of(all.groups), columns);
    all.combinations = Block::Zero(static_cast<Eigen::Index>(all.columns.size()), columns);
    Eigen::Index column = 0, place = 0;
    for (const int f : parts) {
      Front part = std::exchange(fronts_[static_cast<std::size_t>(f)], {});
      const Eigen::Index width = part.rest.cols();
      all.combinations.block(place, column, part.combinations.rows(), width) = part.combinations;
      Eigen::Index row = 0;
      for (const int g : part.groups) {
        const int size = size_[static_cast<std::size_t>(g)];
        all.rest.block(first_row(all.groups, g), column, size, width) = part.rest.middleRows(row, size);
        row += size;
        std::erase(fronts_of_[static_cast<std::size_t>(g)], f);
      }
      place += part.combinations.rows();
      column += width;
    }
    return all;
  }

  // Combinations that leave nothing in its rows go on.
  bool eliminate(int group) {
    by_degree_.erase(by_degree_.begin());
    if (fronts_of_[static_cast<std::size_t>(group)].empty()) return true;
    Front front = together(group);
    const Eigen::Index rows = size_[static_cast<std::size_t>(group)];
    if (const auto turned = turned_apart(front.rest.topRows(rows).transpose(), independent_, dependent_)) {
      const Eigen::Index others = front.rest.cols() - turned->rank;
      front.combinations = front.combinations * turned->basis.rightCols(others);
      front.rest = front.rest.bottomRows(front.rest.rows() - rows) * turned->basis.rightCols(others);
    } else {
      return false;
    }
    front.groups.erase(front.groups.begin());
    const std::vector<int> neighbours = front.groups;
    if (!neighbours.empty() && front.rest.cols() >= front.rest.rows()) take_what_vanishes(front);
    if (front.combinations.cols() > 0) add(std::move(front));
    for (const int g : neighbours) set_degree(g);
    return true;
  }

  // Combinations that leave nothing anywhere would be carried along.
  void take_what_vanishes(Front& front) {
    const auto turned = turned_apart(front.rest.transpose(), independent_, dependent_);
    if (!turned || turned->rank == front.rest.cols()) return;
    take(front.columns, front.combinations * turned->basis.rightCols(front.rest.cols() - turned->rank));
    front.combinations = front.combinations * turned->basis.leftCols(turned->rank);
    front.rest = front.rest * turned->basis.leftCols(turned->rank);
  }

  double dependent_, independent_;
  std::vector<int> size_, degree_;  // of groups
  std::vector<std::vector<int>> fronts_of_;
  std::vector<Front> fronts_, found_;
  std::set<std::pair<int, int>> by_degree_;  // with the group
  Eigen::Index count_ = 0;
};

}  // namespace

std::optional<Eigen::MatrixXd> sparse_kernel(int columns, std::span<const int> groups, std::span<const SparseEntry> entries, double dependent, double independent) {
  return Elimination(columns, groups, entries, dependent, independent).kernel(columns);
}

}  // namespace dalembert
