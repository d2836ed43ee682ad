// Reaching every control by keyboard: Tab goes from one to the next in the order they are drawn, Space and
// Enter press, arrows move sliders. Shown as a ring only while the keyboard is used for it.
#pragma once

#include <string>
#include <vector>

namespace netwright {

class KeyFocus {
 public:
  enum class Kind { Press, Slide, Type };

  /// Before the controls of a frame are drawn. While `is_modal`, only controls of the dialog count.
  void begin_frame(bool is_modal);

  /// For the control just to be drawn: does it have the focus? `is_in_dialog` tells where it stands.
  bool offer(const std::string& name, Kind kind, bool is_enabled, bool is_in_dialog);
  /// Once, when the focus came to this control by a key: it should scroll into view and begin to be typed in.
  bool has_arrived(const std::string& name);
  /// Once, when the focused control was pressed by a key.
  bool take_press(const std::string& name);
  /// How far the arrows moved the focused slider, in steps; 0 for others.
  int take_steps(const std::string& name);

  // What the keyboard and the mouse do.
  void go(int direction);  ///< +1 to the next control, -1 back; shows the focus when it was not
  bool press();            ///< false when nothing is focused, or something that is typed in
  bool slide(int steps);   ///< false unless a slider is focused
  void hide() { name_.clear(); }
  [[nodiscard]] bool is_shown() const { return !name_.empty(); }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  struct Control {
    std::string name;
    Kind kind;
  };
  std::vector<Control> before_;  ///< of the last frame, in the order they were drawn
  std::vector<Control> order_;   ///< of this one so far
  std::string name_;             ///< what has the focus; empty while hidden
  std::string last_;             ///< what had it last, so that Tab goes on from there
  Kind kind_ = Kind::Press;
  bool is_modal_ = false;
  bool has_arrived_ = false;
  bool is_pressed_ = false;
  int steps_ = 0;
};

}  // namespace netwright
