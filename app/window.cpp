// The real window: GLFW for the system's side, Dear ImGui's backends for the interface's. Our own callbacks
// come first and pass everything on, so that shortcuts are queued and a key tapped within one slow frame is
// not lost.
#include "app/window.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <deque>
#include <glm/common.hpp>
#include <set>
#include <utility>

#include "assets/assets.h"
#include "core/base/error.h"
#include "core/base/image.h"
#include "render/gl.h"

namespace netwright {
namespace {

constexpr glm::ivec2 kSmallestSize{640, 480};

std::string last_glfw_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text != nullptr ? text : "no reason given";
}

Error no_window(const std::string& why) {
  return Error(ErrorKind::Usage,
               "Netwright cannot open a window (" + why +
                   "): start it from a desktop session with OpenGL 3.3, or draw without a window "
                   "with --screenshot OUT.png, or unfold with netwright-cli.");
}

/// GLFW itself: started once, ended with the window.
class GlfwLibrary {
 public:
  GlfwLibrary() {
    if (glfwInit() != GLFW_TRUE) throw no_window(last_glfw_error());
  }
  ~GlfwLibrary() { glfwTerminate(); }
  GlfwLibrary(const GlfwLibrary&) = delete;
  GlfwLibrary& operator=(const GlfwLibrary&) = delete;
};

struct WindowDeleter {
  void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};

/// Can the window still be taken by its upper edge? Screens come and go.
bool is_on_screen(const WindowPlacement& placement) {
  const glm::ivec2 handle = placement.position + glm::ivec2(placement.size.x / 2, 0);
  int n = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&n);
  for (int i = 0; i < n; ++i) {
    glm::ivec2 corner(0);
    glm::ivec2 size(0);
    glfwGetMonitorWorkarea(monitors[i], &corner.x, &corner.y, &size.x, &size.y);
    const glm::ivec2 inside = handle - corner;
    if (inside.x >= 0 && inside.y >= 0 && inside.x < size.x && inside.y < size.y) return true;
  }
  return false;
}

/// For window lists; desktops that know the program's entry take theirs.
void set_icon(GLFWwindow* window) {
  std::array<Image, 3> pictures{decode_image(asset_text("assets/icons/netwright-16.png")),
                                decode_image(asset_text("assets/icons/netwright-48.png")),
                                decode_image(asset_text("assets/icons/netwright-128.png"))};
  std::array<GLFWimage, 3> icons{};
  for (std::size_t i = 0; i < icons.size(); ++i)
    icons[i] = {pictures[i].width, pictures[i].height, pictures[i].rgba.data()};
  glfwSetWindowIcon(window, static_cast<int>(icons.size()), icons.data());
}

std::unique_ptr<GLFWwindow, WindowDeleter> create(const WindowOptions& options) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SAMPLES, 0);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "netwright");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "netwright");
  const bool is_known =
      options.placement.size.x >= kSmallestSize.x && options.placement.size.y >= kSmallestSize.y;
  const glm::ivec2 wanted = is_known ? options.placement.size : options.size;
  if (is_known) glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_FALSE);  // the size is that on its screen
  glfwWindowHint(GLFW_MAXIMIZED, options.placement.is_maximized ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);  // it should not be seen jumping
  std::unique_ptr<GLFWwindow, WindowDeleter> window(
      glfwCreateWindow(wanted.x, wanted.y, options.title.c_str(), nullptr, nullptr));
  if (!window) throw no_window(last_glfw_error());
  if (is_known && !options.placement.is_maximized && is_on_screen(options.placement))
    glfwSetWindowPos(window.get(), options.placement.position.x, options.placement.position.y);
  glfwShowWindow(window.get());
  glfwSetWindowSizeLimits(window.get(), kSmallestSize.x, kSmallestSize.y, GLFW_DONT_CARE, GLFW_DONT_CARE);
  set_icon(window.get());
  glfwMakeContextCurrent(window.get());
  glfwSwapInterval(1);
  if (gladLoadGL(glfwGetProcAddress) == 0) throw no_window("the graphics driver offers no OpenGL 3.3");
  return window;
}

int to_modifier_bits(int glfw_modifiers) {
  int bits = 0;
  if ((glfw_modifiers & GLFW_MOD_SHIFT) != 0) bits |= kShift;
  if ((glfw_modifiers & GLFW_MOD_CONTROL) != 0) bits |= kControl;
  if ((glfw_modifiers & GLFW_MOD_ALT) != 0) bits |= kAlt;
  if ((glfw_modifiers & GLFW_MOD_SUPER) != 0) bits |= kSuper;
  return bits;
}

class GlfwWindow final : public Window {
 public:
  explicit GlfwWindow(const WindowOptions& options) : window_(create(options)) {
    const char* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    const auto names = [renderer](const char* what) {
      return renderer != nullptr && std::strstr(renderer, what) != nullptr;
    };
    is_software_ = names("llvmpipe") || names("softpipe") || names("SWR");
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    glfwSetWindowUserPointer(window_.get(), this);
    set_callbacks();
    ImGui_ImplGlfw_InitForOpenGL(window_.get(), false);
    ImGui_ImplOpenGL3_Init("#version 330 core");
  }

  ~GlfwWindow() override {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }

  [[nodiscard]] glm::ivec2 size_px() const override {
    glm::ivec2 size(1);
    glfwGetFramebufferSize(window_.get(), &size.x, &size.y);
    return glm::max(size, glm::ivec2(1));
  }

  [[nodiscard]] double content_scale() const override {
    float x = 1;
    float y = 1;
    glfwGetWindowContentScale(window_.get(), &x, &y);
    return std::clamp(static_cast<double>(x), 0.5, 4.0);
  }

  void wait_events(double timeout_s) override {
    if (timeout_s > 0)
      glfwWaitEventsTimeout(timeout_s);
    else
      glfwPollEvents();
  }

  void wake() override { glfwPostEmptyEvent(); }

  void begin_frame() override {
    // A key pressed and released since the last frame stays down for this one, and comes up before the next.
    for (const auto& [key, scancode, modifiers] : due_releases_)
      ImGui_ImplGlfw_KeyCallback(window_.get(), key, scancode, GLFW_RELEASE, modifiers);
    due_releases_ = std::move(late_releases_);
    late_releases_.clear();
    fresh_keys_.clear();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    take_press();
  }

  void present() override {
    draw_interface();
    glfwSwapBuffers(window_.get());
  }

  void refresh_fonts() override {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
  }

  [[nodiscard]] Image read_pixels() const override {
    // What was shown is gone from the back buffer, but the interface's drawing list is still there.
    draw_interface();
    const glm::ivec2 size = size_px();
    Image image{size.x, size.y, {}};
    const std::size_t row = static_cast<std::size_t>(size.x) * 4;
    std::vector<std::uint8_t> rows(row * static_cast<std::size_t>(size.y));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
    for (int y = size.y - 1; y >= 0; --y) {
      const auto from = rows.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * row);
      image.rgba.insert(image.rgba.end(), from, from + static_cast<std::ptrdiff_t>(row));
    }
    return image;
  }

  [[nodiscard]] WindowPlacement placement() const override {
    WindowPlacement placement;
    glfwGetWindowPos(window_.get(), &placement.position.x, &placement.position.y);
    glfwGetWindowSize(window_.get(), &placement.size.x, &placement.size.y);
    placement.is_maximized = glfwGetWindowAttrib(window_.get(), GLFW_MAXIMIZED) == GLFW_TRUE;
    return placement;
  }

  void set_title(const std::string& title) override { glfwSetWindowTitle(window_.get(), title.c_str()); }
  [[nodiscard]] bool is_software() const override { return is_software_; }

 private:
  struct Release {
    int key;
    int scancode;
    int modifiers;
  };

  struct Press {
    int button;
    bool is_down;
    ImVec2 at;
  };

  static GlfwWindow& self(GLFWwindow* window) {
    return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window));
  }

  void draw_interface() const {
    const glm::ivec2 size = size_px();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, size.x, size.y);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    if (ImDrawData* data = ImGui::GetDrawData()) ImGui_ImplOpenGL3_RenderDrawData(data);
  }

  void on_key(int key, int scancode, int action, int modifiers) {
    const bool is_known = key >= 0;
    if (action == GLFW_RELEASE && is_known && fresh_keys_.count(key) > 0) {
      late_releases_.push_back({key, scancode, modifiers});
      return;
    }
    if (action != GLFW_RELEASE && is_known) {
      fresh_keys_.insert(key);
      WindowEvent event;
      event.key = key;
      event.modifiers = to_modifier_bits(modifiers);
      event.is_repeat = action == GLFW_REPEAT;
      push(std::move(event));
    }
    ImGui_ImplGlfw_KeyCallback(window_.get(), key, scancode, action, modifiers);
  }

  void on_text(unsigned int code_point) {
    WindowEvent event;
    event.kind = WindowEvent::Kind::Text;
    event.code_point = code_point;
    push(std::move(event));
    ImGui_ImplGlfw_CharCallback(window_.get(), code_point);
  }

  void on_button(int button, int action, int modifiers) {
    WindowEvent event;
    event.kind = WindowEvent::Kind::MouseButton;
    event.button = button;
    event.is_pressed = action == GLFW_PRESS;
    event.modifiers = to_modifier_bits(modifiers);
    push(std::move(event));
    ImGui_ImplGlfw_MouseButtonCallback(window_.get(), button, action, modifiers);
    if (button < 0 || button >= static_cast<int>(is_down_.size())) return;
    presses_.push_back({button, action == GLFW_PRESS, pointer_});
  }

  /// The backend asks where the pointer is by now. Who clicks and moves on within one slow frame has meant
  /// the place of the click: buttons go down and up one at a frame, each where that was.
  void take_press() {
    ImGuiIO& io = ImGui::GetIO();
    if (!presses_.empty()) {
      const Press press = presses_.front();
      presses_.pop_front();
      is_down_.at(static_cast<std::size_t>(press.button)) = press.is_down;
      io.MousePos = press.at;
      if (!presses_.empty()) on_simple(WindowEvent::Kind::MouseMove);  // another frame
      if (!presses_.empty()) glfwPostEmptyEvent();
    }
    for (std::size_t k = 0; k < is_down_.size(); ++k) io.MouseDown[k] = is_down_.at(k);
  }

  void on_scroll(double x, double y) {
    WindowEvent event;
    event.kind = WindowEvent::Kind::Scroll;
    event.amount = {x, y};
    push(std::move(event));
    ImGui_ImplGlfw_ScrollCallback(window_.get(), x, y);
  }

  void on_drop(int count, const char** paths) {
    WindowEvent event;
    event.kind = WindowEvent::Kind::Drop;
    for (int k = 0; k < count; ++k) event.paths.emplace_back(paths[k]);
    push(std::move(event));
  }

  void on_simple(WindowEvent::Kind kind) {
    WindowEvent event;
    event.kind = kind;
    push(std::move(event));
  }

  void set_callbacks() {
    GLFWwindow* w = window_.get();
    glfwSetKeyCallback(w, [](GLFWwindow* window, int key, int scancode, int action, int modifiers) {
      self(window).on_key(key, scancode, action, modifiers);
    });
    glfwSetCharCallback(w, [](GLFWwindow* window, unsigned int c) { self(window).on_text(c); });
    glfwSetMouseButtonCallback(w, [](GLFWwindow* window, int button, int action, int modifiers) {
      self(window).on_button(button, action, modifiers);
    });
    glfwSetScrollCallback(w, [](GLFWwindow* window, double x, double y) { self(window).on_scroll(x, y); });
    glfwSetDropCallback(
        w, [](GLFWwindow* window, int n, const char** paths) { self(window).on_drop(n, paths); });
    glfwSetWindowCloseCallback(w, [](GLFWwindow* window) {
      // Whether it closes is the application's decision.
      glfwSetWindowShouldClose(window, GLFW_FALSE);
      self(window).on_simple(WindowEvent::Kind::Close);
    });
    glfwSetFramebufferSizeCallback(
        w, [](GLFWwindow* window, int, int) { self(window).on_simple(WindowEvent::Kind::Resize); });
    glfwSetWindowRefreshCallback(
        w, [](GLFWwindow* window) { self(window).on_simple(WindowEvent::Kind::Resize); });
    glfwSetWindowFocusCallback(w, ImGui_ImplGlfw_WindowFocusCallback);
    glfwSetCursorPosCallback(w, [](GLFWwindow* window, double x, double y) {
      self(window).pointer_ = ImVec2(static_cast<float>(x), static_cast<float>(y));
      self(window).on_simple(WindowEvent::Kind::MouseMove);
    });
    glfwSetCursorEnterCallback(w, [](GLFWwindow* window, int has_entered) {
      self(window).on_simple(WindowEvent::Kind::MouseMove);
      ImGui_ImplGlfw_CursorEnterCallback(window, has_entered);
    });
  }

  GlfwLibrary library_;
  std::unique_ptr<GLFWwindow, WindowDeleter> window_;
  bool is_software_ = false;
  std::set<int> fresh_keys_;            ///< pressed since the last frame
  std::vector<Release> late_releases_;  ///< of fresh keys
  std::vector<Release> due_releases_;   ///< to be delivered with the next frame
  ImVec2 pointer_{-1, -1};         ///< at the event in hand; asking the system would tell where it is by now
  std::deque<Press> presses_;      ///< of mouse buttons, for the coming frames
  std::array<bool, 3> is_down_{};  ///< as the interface knows them
};

}  // namespace

std::vector<WindowEvent> Window::take_events() { return std::exchange(events_, {}); }

std::unique_ptr<Window> open_window(const WindowOptions& options) {
  return std::make_unique<GlfwWindow>(options);
}

}  // namespace netwright
