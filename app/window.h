// A window as the application sees it, real or without a screen: its size, its events, and the frame around
// each drawing of the interface. The window owns the OpenGL context and Dear ImGui's context with its
// backends.
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/base/image.h"

namespace netwright {

/// Modifier keys, as bits.
inline constexpr int kShift = 1;
inline constexpr int kControl = 2;
inline constexpr int kAlt = 4;
inline constexpr int kSuper = 8;

/// Key numbers are GLFW's: letters, digits and punctuation are their capital ASCII character ('A', '1', ' ').
/// In the headless window too, and in ImGui's arrays.
namespace keys {
inline constexpr int kSpace = 32;
inline constexpr int kEscape = 256;
inline constexpr int kEnter = 257;
inline constexpr int kTab = 258;
inline constexpr int kBackspace = 259;
inline constexpr int kInsert = 260;
inline constexpr int kDelete = 261;
inline constexpr int kRight = 262;
inline constexpr int kLeft = 263;
inline constexpr int kDown = 264;
inline constexpr int kUp = 265;
inline constexpr int kPageUp = 266;
inline constexpr int kPageDown = 267;
inline constexpr int kHome = 268;
inline constexpr int kEnd = 269;
inline constexpr int kF1 = 290;
inline constexpr int kF9 = 298;
inline constexpr int kF11 = 300;
inline constexpr int kF12 = 301;
inline constexpr int kKeypadEnter = 335;
inline constexpr int kLeftShift = 340;
inline constexpr int kLeftControl = 341;
inline constexpr int kLeftAlt = 342;
inline constexpr int kLeftSuper = 343;
}  // namespace keys

struct WindowEvent {
  enum class Kind {
    Key,          ///< pressed (or repeated): key, modifiers, is_repeat
    Text,         ///< one typed character: code_point
    MouseButton,  ///< button (0 left, 1 right, 2 middle), is_pressed, modifiers
    MouseMove,    ///< the pointer moved, came or left
    Scroll,       ///< amount
    Drop,         ///< files dropped on the window: paths
    Close,        ///< the user asked to close it
    Resize,
  };
  Kind kind = Kind::Key;
  int key = 0;
  int modifiers = 0;
  bool is_repeat = false;
  char32_t code_point = 0;
  int button = 0;
  bool is_pressed = false;
  glm::dvec2 amount{0};
  std::vector<std::filesystem::path> paths;
};

/// Where a window lies on the desktop, in screen units; a size of 0 is not known.
struct WindowPlacement {
  glm::ivec2 position{0, 0};
  glm::ivec2 size{0, 0};
  bool is_maximized = false;
};

/// One frame is: wait_events, take_events, begin_frame, ImGui::NewFrame … ImGui::Render, present. Mouse and
/// text reach ImGui by themselves; shortcuts should be taken from the event queue, which loses no key on slow
/// frames, unless io.WantTextInput.
class Window {
 public:
  Window() = default;
  virtual ~Window() = default;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Of the framebuffer.
  [[nodiscard]] virtual glm::ivec2 size_px() const = 0;
  /// How much larger than at 96 dpi everything should be drawn.
  [[nodiscard]] virtual double content_scale() const = 0;
  /// Sleeps until an event, a wake() or the timeout; 0 only looks.
  virtual void wait_events(double timeout_s) = 0;
  /// Everything since the last call, oldest first.
  std::vector<WindowEvent> take_events();
  /// Ends a wait_events; the one function that other threads may call.
  virtual void wake() = 0;

  /// Tells ImGui's backends that a frame begins; ImGui::NewFrame is up to the caller.
  virtual void begin_frame() = 0;
  /// Draws ImGui's draw data over a cleared window and shows it.
  virtual void present() = 0;
  /// Takes over a changed font atlas before the next frame.
  virtual void refresh_fonts() = 0;
  /// The frame presented last, or being shown; rows from top to bottom.
  [[nodiscard]] virtual Image read_pixels() const = 0;
  [[nodiscard]] virtual WindowPlacement placement() const = 0;
  virtual void set_title(const std::string& title) = 0;
  /// Is drawing done by the processor? Then multisampling and other luxuries are off.
  [[nodiscard]] virtual bool is_software() const = 0;

 protected:
  [[nodiscard]] bool has_events() const { return !events_.empty(); }
  void push(WindowEvent event) { events_.push_back(std::move(event)); }

 private:
  std::vector<WindowEvent> events_;
};

struct WindowOptions {
  std::string title = "Netwright";
  glm::ivec2 size{1440, 900};
  WindowPlacement
      placement{};  ///< of the last time; taken where its size is known and it is still on a screen
};

/// Opens a real window. Throws Error(Usage) with one sentence and a cure when there is no display, no window
/// system or no OpenGL 3.3.
std::unique_ptr<Window> open_window(const WindowOptions& options);

}  // namespace netwright
