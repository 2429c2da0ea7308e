// Where everything goes in a repeated factorization.
#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "multifrontal_lu.hpp"

namespace dalembert {

namespace {

// Gives places in a buffer to things that come and go.
class Places {
 public:
  std::size_t take(std::size_t size) {
    std::size_t place = 0;
    for (const auto& [start, end] : taken_) {
      if (start - place >= size) break;
      place = end;
    }
    taken_.emplace(place, place + size);
    size_ = std::max(size_, place + size);
    return place;
  }
  void release(std::size_t place) { taken_.erase(place); }
  std::size_t size() const { return size_; }

 private:
  std::map<std::size_t, std::size_t> taken_;  // end by start
  std::size_t size_ = 0;
};

constexpr std::size_t line = 8;  // numbers per line of a cache
std::size_t lines(std::size_t numbers) { return (numbers + line - 1) / line; }

}  // namespace

void MultifrontalLu::plan(PivotSearch search) {
  std::vector<PivotedFront>& fronts = search.fronts;
  std::vector<std::vector<int>> children(fronts.size());
  for (int f = 0; f < static_cast<int>(fronts.size()); ++f) {
    if (tree_[f].parent >= 0) children[tree_[f].parent].push_back(f);
  }
  sort_updates(fronts, children);
  fronts_.assign(fronts.size(), {});
  std::size_t end = 0;
  int longest = 0;
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    Front& front = fronts_[f];
    front.pivots = fronts[f].pivots;
    front.updates = static_cast<int>(fronts[f].rows.size()) - front.pivots;
    front.length = padded(front.pivots + front.updates);
    longest = std::max(longest, front.length);
    front.panel = end;
    front.upper = end + static_cast<std::size_t>(front.length) * front.pivots;
    end = front.upper + static_cast<std::size_t>(padded(front.pivots)) * front.updates;
  }
  number_steps(fronts);
  place_entries(fronts);
  place_updates(fronts, children);
  place_columns();
  factors_.resize(lines(end));
  work_.resize(static_cast<std::size_t>(longest));
  others_.resize(static_cast<std::size_t>(longest));
  statistics_.entries = end;
}

// The updates of each front in the order in which its parent has them.
void MultifrontalLu::sort_updates(std::vector<PivotedFront>& fronts, const std::vector<std::vector<int>>& children) const {
  std::vector<int> place(static_cast<std::size_t>(size_));
  const auto sort = [&](std::size_t parent, std::vector<int> PivotedFront::*list) {
    const std::vector<int>& order = fronts[parent].*list;
    for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
    for (const int c : children[parent]) {
      std::vector<int>& sorted = fronts[c].*list;
      std::sort(sorted.begin() + fronts[c].pivots, sorted.end(), [&](int a, int b) { return place[a] < place[b]; });
    }
  };
  for (std::size_t f = fronts.size(); f-- > 0;) {
    sort(f, &PivotedFront::rows);
    sort(f, &PivotedFront::columns);
  }
}

void MultifrontalLu::number_steps(const std::vector<PivotedFront>& fronts) {
  row_of_step_.clear();
  column_of_step_.clear();
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    const PivotedFront& front = fronts[f];
    fronts_[f].first_step = static_cast<int>(row_of_step_.size());
    row_of_step_.insert(row_of_step_.end(), front.rows.begin(), front.rows.begin() + front.pivots);
    column_of_step_.insert(column_of_step_.end(), front.columns.begin(), front.columns.begin() + front.pivots);
  }
  inverse_pivot_.resize(row_of_step_.size() + front_chunk);
  left_out_ = size_ - static_cast<int>(row_of_step_.size());
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    if (tree_[f].parent >= 0) continue;
    const PivotedFront& front = fronts[f];
    row_of_step_.insert(row_of_step_.end(), front.rows.begin() + front.pivots, front.rows.end());
    column_of_step_.insert(column_of_step_.end(), front.columns.begin() + front.pivots, front.columns.end());
  }
  steps_.resize(static_cast<std::size_t>(size_));
  row_scale_.clear();
  column_scale_.clear();
  for (const int row : row_of_step_) row_scale_.push_back(scaling_.row(row));
  for (const int column : column_of_step_) column_scale_.push_back(scaling_.column(column));
}

void MultifrontalLu::place_entries(const std::vector<PivotedFront>& fronts) {
  const FrontEntries all(pattern_, tree_);
  std::vector<int> row_place(static_cast<std::size_t>(size_)), column_place(row_place);
  std::vector<Entry> others;
  entries_.clear();
  const double r = scaling_.row_factor, c = scaling_.column_factor;
  std::copy_n(std::array{1.0, r, c, r * c}.begin(), 4, scales_);
  for (int f = 0; f < static_cast<int>(fronts.size()); ++f) {
    const PivotedFront& order = fronts[f];
    for (int k = 0; k < static_cast<int>(order.rows.size()); ++k) {
      row_place[order.rows[k]] = k;
      column_place[order.columns[k]] = k;
    }
    Front& front = fronts_[f];
    front.panel_entries = static_cast<int>(entries_.size());
    others.clear();
    all.for_each(f, [&](int i, int j, int slot) {
      const int target = column_place[j] * front.length + row_place[i], right = target - front.pivots * front.length;
      const unsigned scale = (scaling_.multiplier[i] ? 1 : 0) + (scaling_.multiplier[j] ? 2 : 0);
      (right < 0 ? entries_ : others).push_back({slot, static_cast<unsigned>(right < 0 ? target : right), scale});
    });
    front.right_entries = static_cast<int>(entries_.size());
    entries_.insert(entries_.end(), others.begin(), others.end());
    front.end_of_entries = static_cast<int>(entries_.size());
  }
}

void MultifrontalLu::place_updates(const std::vector<PivotedFront>& fronts, const std::vector<std::vector<int>>& children) {
  std::vector<int> row_step(static_cast<std::size_t>(size_)), column_step(row_step), row_place(row_step), column_place(row_step);
  for (int k = 0; k < size_; ++k) {
    row_step[row_of_step_[k]] = k;
    column_step[column_of_step_[k]] = k;
  }
  children_.clear();
  updates_.clear();
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    fronts_[f].first_update = updates_.size();
    for (std::size_t k = static_cast<std::size_t>(fronts[f].pivots); k < fronts[f].rows.size(); ++k) {
      updates_.push_back({0, 0, row_step[fronts[f].rows[k]], column_step[fronts[f].columns[k]]});
    }
  }
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    Front& front = fronts_[f];
    for (int k = 0; k < static_cast<int>(fronts[f].rows.size()); ++k) {
      row_place[fronts[f].rows[k]] = k;
      column_place[fronts[f].columns[k]] = k;
    }
    front.children = static_cast<int>(children_.size());
    children_.insert(children_.end(), children[f].begin(), children[f].end());
    front.end_of_children = static_cast<int>(children_.size());
    for (const int c : children[f]) {
      Front& child = fronts_[c];
      for (int k = 0; k < child.updates; ++k) {
        Update& update = updates_[child.first_update + k];
        const int place = column_place[fronts[c].columns[child.pivots + k]];
        child.updates_in_panel += place < front.pivots;
        update.row = row_place[fronts[c].rows[child.pivots + k]];
        update.column = (place < front.pivots ? place : place - front.pivots) * front.length;
      }
    }
  }
}

void MultifrontalLu::place_columns() {
  Places places;
  for (Front& front : fronts_) {
    if (front.updates > 0) front.right = line * places.take(lines(static_cast<std::size_t>(front.length) * front.updates));
    for (int k = front.children; k < front.end_of_children; ++k) {
      if (const Front& child = fronts_[children_[k]]; child.updates > 0) places.release(child.right / line);
    }
    if (front.updates > 0 && tree_[&front - fronts_.data()].parent < 0) places.release(front.right / line);
  }
  columns_.resize(places.size());
}

}  // namespace dalembert
