// Switching functions of items.
#pragma once

#include <cstddef>
#include <vector>

namespace dalembert {

class SystemTerm;

// A switch of an item, from contact to separation or from stick to slip: a function of the state that is not negative
// as long as its data coordinates are valid.
struct Switch {
  const char* what;    // "contact"
  double value = 1;
  bool kink = false;  // forces have one where it changes its sign, either way, and data coordinates stay as they are
  double noise = 0;  // numbers below this size are meaningless just after the item has switched
  int direction = 0;  // 1: contact, friction that slides, or the like begins there; -1: it ends
  int item = -1;  // object
  const SystemTerm* owner = nullptr;  // owner of a term that is not an item,
  int part = -1;  // and which of its parts
};

// The switches of an item: their number and order are constant.
class Switches {
 public:
  explicit Switches(std::vector<Switch>& found) : found_(found) {}
  void of(int item) {
    item_ = item;
    owner_ = nullptr;
  }
  void of_part(const SystemTerm& owner, int part) {
    owner_ = &owner;
    part_ = part;
  }
  // `now`: it touches or slides, as long as the value is not negative; or it does not.
  void holds(const char* what, bool now, double value, double noise = 0) {
    found_.push_back({what, value, false, noise, now ? -1 : 1, item_, owner_, part_});
  }
  // Transition to another state of the same kind.
  void passes(const char* what, double value, double noise = 0) {
    found_.push_back({what, value, false, noise, 0, item_, owner_, part_});
  }
  void kink(const char* what, double value) { found_.push_back({what, value, true, 0, 0, item_, owner_, part_}); }
  // Placeholders for switches that cannot occur.
  void none(int count = 1) {
    found_.insert(found_.end(), static_cast<std::size_t>(count), {.what = "", .item = item_});
  }

 private:
  std::vector<Switch>& found_;
  int item_ = -1, part_ = -1;
  const SystemTerm* owner_ = nullptr;
};

}  // namespace dalembert
