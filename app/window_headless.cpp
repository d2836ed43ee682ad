// The window without a screen: an EGL context on Mesa's surfaceless platform and a framebuffer in place of
// the screen. Dear ImGui's input arrays are filled by hand, with GLFW's key numbers, as its GLFW backend
// would.
#include "app/window_headless.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <utility>

#include "core/base/error.h"
#include "render/gl.h"
#include "render/gl_objects.h"

namespace netwright {
namespace {

constexpr std::size_t kButtons = 3;
constexpr float kFrameSeconds = 1.0F / 60;  // always the same, so that pictures and tests repeat

Error no_context(const std::string& what) {
  return Error(ErrorKind::Usage, "Netwright cannot draw without a display here (" + what +
                                     "): install libegl1, libegl-mesa0 and libgl1-mesa-dri, or run it under "
                                     "xvfb-run.");
}

/// Display and context of EGL, current on this thread while the object lives.
class EglContext {
 public:
  EglContext() {
    display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) != EGL_TRUE)
      throw no_context("EGL has no surfaceless platform");
    const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                       EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglBindAPI(EGL_OPENGL_API);
    if (eglChooseConfig(display_, wanted.data(), &config, 1, &count) != EGL_TRUE || count == 0)
      fail("EGL offers no OpenGL");
    const std::array<EGLint, 7> version{EGL_CONTEXT_MAJOR_VERSION,
                                        3,
                                        EGL_CONTEXT_MINOR_VERSION,
                                        3,
                                        EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                        EGL_NONE};
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version.data());
    if (context_ == EGL_NO_CONTEXT) fail("EGL offers no OpenGL 3.3");
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE ||
        gladLoadGL(eglGetProcAddress) == 0)
      fail("OpenGL 3.3 does not start");
  }
  ~EglContext() { end(); }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

 private:
  [[noreturn]] void fail(const std::string& what) {
    end();
    throw no_context(what);
  }
  void end() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    eglTerminate(display_);
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

void map_keys(ImGuiIO& io) {
  constexpr std::array<std::pair<int, int>, 22> kMap{{{ImGuiKey_Tab, keys::kTab},
                                                      {ImGuiKey_LeftArrow, keys::kLeft},
                                                      {ImGuiKey_RightArrow, keys::kRight},
                                                      {ImGuiKey_UpArrow, keys::kUp},
                                                      {ImGuiKey_DownArrow, keys::kDown},
                                                      {ImGuiKey_PageUp, keys::kPageUp},
                                                      {ImGuiKey_PageDown, keys::kPageDown},
                                                      {ImGuiKey_Home, keys::kHome},
                                                      {ImGuiKey_End, keys::kEnd},
                                                      {ImGuiKey_Insert, keys::kInsert},
                                                      {ImGuiKey_Delete, keys::kDelete},
                                                      {ImGuiKey_Backspace, keys::kBackspace},
                                                      {ImGuiKey_Space, keys::kSpace},
                                                      {ImGuiKey_Enter, keys::kEnter},
                                                      {ImGuiKey_Escape, keys::kEscape},
                                                      {ImGuiKey_KeyPadEnter, keys::kKeypadEnter},
                                                      {ImGuiKey_A, 'A'},
                                                      {ImGuiKey_C, 'C'},
                                                      {ImGuiKey_V, 'V'},
                                                      {ImGuiKey_X, 'X'},
                                                      {ImGuiKey_Y, 'Y'},
                                                      {ImGuiKey_Z, 'Z'}}};
  for (const auto& [imgui_key, key] : kMap) io.KeyMap[imgui_key] = key;
}

/// The characters of a UTF-8 text; what is not valid is left out.
std::u32string code_points(const std::string& utf8) {
  std::u32string out;
  for (std::size_t k = 0; k < utf8.size();) {
    const auto lead = static_cast<unsigned char>(utf8[k]);
    const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    if (k + length > utf8.size()) break;
    auto c = static_cast<char32_t>(length == 1 ? lead : lead & (0x7F >> length));
    for (std::size_t i = 1; i < length; ++i) c = (c << 6) | (static_cast<unsigned char>(utf8[k + i]) & 0x3FU);
    out.push_back(c);
    k += length;
  }
  return out;
}

}  // namespace

struct HeadlessWindow::Impl {
  EglContext context;
  std::unique_ptr<Framebuffer> screen;
  double content_scale = 1;
  std::string title;
  bool is_software = true;

  glm::vec2 mouse{-1, -1};
  std::array<bool, kButtons> is_down{};
  std::array<bool, kButtons> was_pressed{};  ///< since the last frame: a quick click is seen for one frame
  glm::vec2 wheel{0};
  std::vector<int> tapped;  ///< keys for the coming frame
  std::vector<int> to_lift;
  int tapped_modifiers = 0;
  int held_modifiers = 0;
  std::string text;

  std::mutex mutex;
  std::condition_variable rung;
  bool is_woken = false;
};

HeadlessWindow::HeadlessWindow(const WindowOptions& options, double content_scale)
    : impl_(std::make_unique<Impl>()) {
  impl_->screen = std::make_unique<Framebuffer>();
  impl_->screen->resize(options.size);
  impl_->content_scale = content_scale;
  impl_->title = options.title;
  const char* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  impl_->is_software = renderer == nullptr || std::strstr(renderer, "llvmpipe") != nullptr ||
                       std::strstr(renderer, "softpipe") != nullptr;
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.BackendPlatformName = "netwright_headless";
  map_keys(io);
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

HeadlessWindow::~HeadlessWindow() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
  impl_->screen.reset();
}

void HeadlessWindow::move_mouse(glm::dvec2 position_px) { impl_->mouse = glm::vec2(position_px); }

void HeadlessWindow::press_mouse(int button, int modifiers) {
  impl_->is_down.at(static_cast<std::size_t>(button)) = true;
  impl_->was_pressed.at(static_cast<std::size_t>(button)) = true;
  impl_->tapped_modifiers |= modifiers;
  WindowEvent event;
  event.kind = WindowEvent::Kind::MouseButton;
  event.button = button;
  event.is_pressed = true;
  event.modifiers = modifiers | impl_->held_modifiers;
  push(std::move(event));
}

void HeadlessWindow::release_mouse(int button) {
  impl_->is_down.at(static_cast<std::size_t>(button)) = false;
  WindowEvent event;
  event.kind = WindowEvent::Kind::MouseButton;
  event.button = button;
  event.modifiers = impl_->held_modifiers;
  push(std::move(event));
}

void HeadlessWindow::scroll(glm::dvec2 amount) {
  impl_->wheel += glm::vec2(amount);
  WindowEvent event;
  event.kind = WindowEvent::Kind::Scroll;
  event.amount = amount;
  push(std::move(event));
}

void HeadlessWindow::press_key(int key, int modifiers) {
  impl_->tapped.push_back(key);
  impl_->tapped_modifiers |= modifiers;
  WindowEvent event;
  event.key = key;
  event.modifiers = modifiers | impl_->held_modifiers;
  push(std::move(event));
}

void HeadlessWindow::type_text(const std::string& utf8) {
  impl_->text += utf8;
  for (const char32_t c : code_points(utf8)) {
    WindowEvent event;
    event.kind = WindowEvent::Kind::Text;
    event.code_point = c;
    push(std::move(event));
  }
}

void HeadlessWindow::drop(std::vector<std::filesystem::path> paths) {
  WindowEvent event;
  event.kind = WindowEvent::Kind::Drop;
  event.paths = std::move(paths);
  push(std::move(event));
}

void HeadlessWindow::request_close() {
  WindowEvent event;
  event.kind = WindowEvent::Kind::Close;
  push(std::move(event));
}

void HeadlessWindow::resize(glm::ivec2 size_px) {
  impl_->screen->resize(size_px);
  WindowEvent event;
  event.kind = WindowEvent::Kind::Resize;
  push(std::move(event));
}

void HeadlessWindow::hold_modifiers(int modifiers) { impl_->held_modifiers = modifiers; }

glm::ivec2 HeadlessWindow::size_px() const { return impl_->screen->size_px(); }
double HeadlessWindow::content_scale() const { return impl_->content_scale; }

void HeadlessWindow::wait_events(double timeout_s) {
  if (has_events()) return;
  std::unique_lock lock(impl_->mutex);
  impl_->rung.wait_for(lock, std::chrono::duration<double>(timeout_s), [this] { return impl_->is_woken; });
  impl_->is_woken = false;
}

void HeadlessWindow::wake() {
  const std::lock_guard lock(impl_->mutex);
  impl_->is_woken = true;
  impl_->rung.notify_one();
}

void HeadlessWindow::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  ImGuiIO& io = ImGui::GetIO();
  const glm::ivec2 size = size_px();
  io.DisplaySize = ImVec2(static_cast<float>(size.x), static_cast<float>(size.y));
  io.DisplayFramebufferScale = ImVec2(1, 1);
  io.DeltaTime = kFrameSeconds;
  io.MousePos = ImVec2(impl_->mouse.x, impl_->mouse.y);
  for (std::size_t k = 0; k < kButtons; ++k) io.MouseDown[k] = impl_->is_down[k] || impl_->was_pressed[k];
  impl_->was_pressed = {};
  io.MouseWheelH += impl_->wheel.x;
  io.MouseWheel += impl_->wheel.y;
  impl_->wheel = {0, 0};
  for (const int key : impl_->to_lift) io.KeysDown[key] = false;
  for (const int key : impl_->tapped) io.KeysDown[key] = true;
  impl_->to_lift = std::exchange(impl_->tapped, {});
  const int modifiers = std::exchange(impl_->tapped_modifiers, 0) | impl_->held_modifiers;
  io.KeyShift = (modifiers & kShift) != 0;
  io.KeyCtrl = (modifiers & kControl) != 0;
  io.KeyAlt = (modifiers & kAlt) != 0;
  io.KeySuper = (modifiers & kSuper) != 0;
  io.AddInputCharactersUTF8(std::exchange(impl_->text, {}).c_str());
}

void HeadlessWindow::present() {
  const glm::ivec2 size = size_px();
  impl_->screen->bind();
  glViewport(0, 0, size.x, size.y);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  if (ImDrawData* data = ImGui::GetDrawData()) ImGui_ImplOpenGL3_RenderDrawData(data);
}

void HeadlessWindow::refresh_fonts() {
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  ImGui_ImplOpenGL3_CreateFontsTexture();
}

Image HeadlessWindow::read_pixels() const {
  Image image = impl_->screen->read_pixels();
  // A screen has no transparency, whatever blending left in the alpha channel.
  for (std::size_t k = 3; k < image.rgba.size(); k += 4) image.rgba[k] = 255;
  return image;
}

WindowPlacement HeadlessWindow::placement() const { return {{0, 0}, size_px(), false}; }

void HeadlessWindow::set_title(const std::string& title) { impl_->title = title; }
bool HeadlessWindow::is_software() const { return impl_->is_software; }
const std::string& HeadlessWindow::title() const { return impl_->title; }

}  // namespace netwright
