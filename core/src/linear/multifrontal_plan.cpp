// Memory layout of a repeated factorization.
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
  // Releases a block; only its end is kept, if there is one.
  void release(std::size_t place, std::size_t kept_from) {
    const auto taken = taken_.find(place);
    const std::size_t end = taken->second;
    taken_.erase(taken);
    if (kept_from < end) taken_.emplace(kept_from, end);
  }
  void release(std::size_t place) { taken_.erase(place); }
  std::size_t size() const { return size_; }

 private:
  std::map<std::size_t, std::size_t> taken_;  // end by start
  std::size_t size_ = 0;
};

}  // namespace

void MultifrontalLu::plan(std::vector<PivotedFront> fronts) {
  std::vector<std::vector<int>> children(fronts.size());
  for (int f = 0; f < static_cast<int>(fronts.size()); ++f) {
    if ((*tree_)[f].parent >= 0) children[(*tree_)[f].parent].push_back(f);
  }
  sort_updates(fronts, children);
  place_factors(fronts);
  const std::vector<int> slot_of_row = number_slots(fronts);
  place_entries(fronts);
  place_updates(fronts, children, slot_of_row);
  place_columns();
}

// Lower factors from the first front on, upper ones from the last front on.
void MultifrontalLu::place_factors(const std::vector<PivotedFront>& fronts) {
  fronts_.assign(fronts.size(), {});
  sizes_.clear();
  std::size_t end = 0, most_updates = 0;
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    Front& front = fronts_[f];
    front.pivots = fronts[f].pivots;
    front.updates = static_cast<int>(fronts[f].rows.size()) - front.pivots;
    front.length = padded(front.pivots + front.updates);
    front.lower = end;
    sizes_.push_back({front.pivots, front.updates});
    end += stream_sizes(sizes_.back()).lower;
    most_updates = std::max(most_updates, static_cast<std::size_t>(front.updates));
  }
  first_upper_ = end;
  for (std::size_t f = fronts.size(); f-- > 0;) {
    fronts_[f].upper = end;
    end += stream_sizes(sizes_[f]).upper;
  }
  factors_ = NumberStorage(end);
  work_.resize(most_updates + front_chunk);
  statistics_.entries = end;
}

// The updates of each front in the order in which its parent has them.
void MultifrontalLu::sort_updates(std::vector<PivotedFront>& fronts,
                                  const std::vector<std::vector<int>>& children) const {
  std::vector<int> place(static_cast<std::size_t>(size_));
  const auto sort = [&](std::size_t parent, std::vector<int> PivotedFront::* list) {
    const std::vector<int>& order = fronts[parent].*list;
    for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<int>(k);
    for (const int c : children[parent]) {
      const std::span updates = std::span(fronts[c].*list).subspan(static_cast<std::size_t>(fronts[c].pivots));
      const auto place_of = [&](int k) { return place[k]; };
      if (!std::ranges::is_sorted(updates, {}, place_of)) std::ranges::sort(updates, {}, place_of);
    }
  };
  for (std::size_t f = fronts.size(); f-- > 0;) {
    sort(f, &PivotedFront::rows);
    sort(f, &PivotedFront::columns);
  }
}

// Returns the slot of each row.
std::vector<int> MultifrontalLu::number_slots(const std::vector<PivotedFront>& fronts) {
  std::vector<int> slot_of_row(static_cast<std::size_t>(size_));
  row_of_slot_.clear();
  row_scale_.clear();
  least_pivot_.clear();
  slot_of_column_.resize(static_cast<std::size_t>(size_));
  column_scale_.resize(static_cast<std::size_t>(size_));
  const auto add = [&](int row, int column) {
    slot_of_row[row] = slot_of_column_[column] = static_cast<int>(row_of_slot_.size());
    row_of_slot_.push_back(row);
    row_scale_.push_back(scaling_.row(row));
    column_scale_[column] = scaling_.column(column);
    least_pivot_.push_back(options_.pivot_threshold * (scaling_.row(row) * scaling_.column(column)));
  };
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    const PivotedFront& front = fronts[f];
    fronts_[f].first_slot = static_cast<int>(row_of_slot_.size());
    for (int k = 0; k < front.pivots; ++k) add(front.rows[k], front.columns[k]);
    const auto end = static_cast<std::size_t>(fronts_[f].first_slot + slots(front.pivots));
    row_of_slot_.resize(end, 0);
    row_scale_.resize(end, 0.0);
    least_pivot_.resize(end, 0.0);
  }
  pivot_slots_ = static_cast<int>(row_of_slot_.size());
  inverse_pivot_.assign(row_of_slot_.size(), 0.0);
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    if ((*tree_)[f].parent >= 0) continue;
    for (std::size_t k = static_cast<std::size_t>(fronts[f].pivots); k < fronts[f].rows.size(); ++k) {
      add(fronts[f].rows[k], fronts[f].columns[k]);
    }
  }
  unknowns_.resize(row_of_slot_.size());
  return slot_of_row;
}

// Entries of one front that are contiguous in a column of the matrix and in a column of the front.
class MultifrontalLu::RunsOfEntries {
 public:
  explicit RunsOfEntries(int size) : last_(static_cast<std::size_t>(size), -1) {}
  // The next entry in a column.
  void add(int column, const Entry& entry) {
    const int last = last_[column] - earlier_;
    if (last >= 0 && runs_[last].continued_by(entry)) {
      ++runs_[last].length;
    } else {
      last_[column] = earlier_ + static_cast<int>(runs_.size());
      runs_.push_back({entry, 1});
    }
  }
  // Appends them by length, and begins with another front.
  void move_to(std::vector<Entry>& entries, int* ends) {
    for (int length = longest_run; length > 0; --length) {
      for (const Run& run : runs_)
        if (run.length == length) entries.push_back(run.first);
      *ends++ = static_cast<int>(entries.size());
    }
    earlier_ += static_cast<int>(runs_.size());
    runs_.clear();
  }

 private:
  struct Run {
    Entry first;
    int length;
    bool continued_by(const Entry& e) const {
      return length < longest_run && e.slot == first.slot + length && e.target == first.target + length;
    }
  };

  std::vector<Run> runs_;
  std::vector<int> last_;  // per column, counted over all fronts
  int earlier_ = 0;  // number in other fronts
};

void MultifrontalLu::place_entries(const std::vector<PivotedFront>& fronts) {
  const FrontEntries all(pattern_, *tree_);
  std::vector<int> row_place(static_cast<std::size_t>(size_)), column_place(row_place);
  RunsOfEntries runs(size_);
  std::array<std::vector<Entry>, 3> by_scale;
  entries_.clear();
  scales_ = {scaling_.row_factor, scaling_.column_factor, scaling_.row_factor * scaling_.column_factor};
  for (int f = 0; f < static_cast<int>(fronts.size()); ++f) {
    const PivotedFront& order = fronts[f];
    Front& front = fronts_[f];
    for (int k = 0; k < static_cast<int>(order.rows.size()); ++k) {
      row_place[order.rows[k]] = k;
      column_place[order.columns[k]] = k * front.length;
    }
    front.first_entry = static_cast<int>(entries_.size());
    all.for_each(f, [&](int i, int j, int slot) {
      const Entry entry{slots_.empty() ? slot : slots_[slot], column_place[j] + row_place[i]};
      const int scale = (scaling_.multiplier[i] ? 1 : 0) + (scaling_.multiplier[j] ? 2 : 0);
      if (scale == 0)
        runs.add(j, entry);
      else
        by_scale[scale - 1].push_back(entry);
    });
    runs.move_to(entries_, front.end_of_entries.data());
    for (std::size_t k = 0; k < by_scale.size(); ++k) {
      entries_.insert(entries_.end(), by_scale[k].begin(), by_scale[k].end());
      front.end_of_entries[longest_run + k] = static_cast<int>(entries_.size());
      by_scale[k].clear();
    }
  }
}

void MultifrontalLu::place_updates(const std::vector<PivotedFront>& fronts,
                                   const std::vector<std::vector<int>>& children, const std::vector<int>& slot_of_row) {
  std::vector<int> row_place(static_cast<std::size_t>(size_)), column_place(row_place);
  children_.clear();
  row_slot_.clear();
  column_slot_.clear();
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    fronts_[f].first_update = row_slot_.size();
    for (std::size_t k = static_cast<std::size_t>(fronts[f].pivots); k < fronts[f].rows.size(); ++k) {
      row_slot_.push_back(slot_of_row[fronts[f].rows[k]]);
      column_slot_.push_back(slot_of_column_[fronts[f].columns[k]]);
    }
  }
  places_.resize(row_slot_.size());
  runs_.clear();
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
      child.runs = runs_.size();
      for (int k = child.pivots; k < child.pivots + child.updates; ++k) {
        const int row = row_place[fronts[c].rows[k]], column = column_place[fronts[c].columns[k]];
        const bool continues = k > child.pivots && row == runs_.back().to + runs_.back().length;
        if (!continues) runs_.push_back({k, row, 0});
        ++runs_.back().length;
        places_[child.first_update + k - child.pivots] = column * front.length;
      }
      child.end_of_runs = runs_.size();
    }
  }
}

// The columns of a front take their place before it takes over those of its children; afterwards its panel is free.
void MultifrontalLu::place_columns() {
  Places places;
  for (Front& front : fronts_) {
    const auto panel = static_cast<std::size_t>(front.length) * front.pivots;
    front.columns = places.take(panel + static_cast<std::size_t>(front.length) * front.updates);
    for (int k = front.children; k < front.end_of_children; ++k) {
      const Front& child = fronts_[children_[k]];
      places.release(child.columns + static_cast<std::size_t>(child.length) * child.pivots);
    }
    places.release(front.columns, front.columns + panel);
    const bool left_out = (*tree_)[&front - fronts_.data()].parent < 0 && front.updates > 0;
    if (left_out) places.release(front.columns + panel);
  }
  columns_ = NumberStorage(places.size() + front_slack);
}

}  // namespace dalembert
