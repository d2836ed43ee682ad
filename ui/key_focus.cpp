// The order is that of the last frame, since the next control may not have been drawn yet when Tab comes.
#include "ui/key_focus.h"

#include <algorithm>
#include <utility>

namespace netwright {

void KeyFocus::begin_frame(bool is_modal) {
  before_ = std::exchange(order_, {});
  if (std::exchange(is_modal_, is_modal) != is_modal) hide();
  // What went with its panel or was disabled has no focus any more.
  const auto is_it = [this](const Control& control) { return control.name == name_; };
  if (!before_.empty() && is_shown() && std::none_of(before_.begin(), before_.end(), is_it)) hide();
}

bool KeyFocus::offer(const std::string& name, Kind kind, bool is_enabled, bool is_in_dialog) {
  if (!is_enabled || is_in_dialog != is_modal_) return false;
  order_.push_back({name, kind});
  return is_shown() && name == name_;
}

bool KeyFocus::has_arrived(const std::string& name) {
  return name == name_ && std::exchange(has_arrived_, false);
}

bool KeyFocus::take_press(const std::string& name) {
  return name == name_ && std::exchange(is_pressed_, false);
}

int KeyFocus::take_steps(const std::string& name) { return name == name_ ? std::exchange(steps_, 0) : 0; }

void KeyFocus::go(int direction) {
  const auto& controls = order_.empty() ? before_ : order_;
  if (controls.empty()) return;
  const auto n = static_cast<std::ptrdiff_t>(controls.size());
  const auto at =
      std::find_if(controls.begin(), controls.end(), [this](const Control& c) { return c.name == last_; });
  std::ptrdiff_t next = direction > 0 ? 0 : n - 1;
  if (at != controls.end()) next = (at - controls.begin() + direction + n) % n;
  const Control& control = controls[static_cast<std::size_t>(next)];
  name_ = last_ = control.name;
  kind_ = control.kind;
  has_arrived_ = true;
  is_pressed_ = false;
  steps_ = 0;
}

bool KeyFocus::press() {
  if (!is_shown() || kind_ != Kind::Press) return false;
  is_pressed_ = true;
  return true;
}

bool KeyFocus::slide(int steps) {
  if (!is_shown() || kind_ != Kind::Slide) return false;
  steps_ += steps;
  return true;
}

}  // namespace netwright
