// How the editor feels while a search runs, drawn in software at 1600x1000: the time of a frame with 800
// faces and a new net in every frame, that of a frame in which the fold slider moves while searches run at
// full speed, how long Stop takes, and what finished sheets cost: until they are laid out, and to move them.
// The promise is a median frame under 120 ms with one in a hundred over 400 ms, under 400 ms at 12 000 faces,
// and a stop within 100 ms.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/application.h"
#include "app/window_headless.h"
#include "core/base/image.h"
#include "core/mesh/shapes.h"

namespace {

using namespace netwright;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void open_shape(Application& app, const PolygonSoup& soup) {
  app.session().open_bytes("shape.obj", shapes::to_obj(soup));
  while (app.session().state() != RunState::Idle) app.turn(0.01);
  for (int i = 0; i < 5; ++i) app.draw();
}

void report(const char* what, std::vector<double> values) {
  if (values.empty()) {
    std::printf("%-28s no values\n", what);
    return;
  }
  std::sort(values.begin(), values.end());
  const std::size_t last_hundredth = std::min(values.size() - 1, values.size() * 99 / 100);
  std::printf("%-28s median %6.1f ms   p99 %6.1f ms   worst %6.1f ms   of %zu\n", what,
              values[values.size() / 2] * 1000, values[last_hundredth] * 1000, values.back() * 1000,
              values.size());
}

void measure_frames(Application& app) {
  constexpr int kFrames = 60;
  open_shape(app, shapes::bumpy_patch(20, 20));
  app.session().set_speed(60);  // a move, and so a new net, in nearly every frame
  app.session().unfold();
  std::vector<double> times;
  std::vector<double> times_of_new_nets;
  while (static_cast<int>(times.size()) < kFrames && app.session().state() == RunState::Running) {
    const auto before_net = app.session().shown();
    app.session().poll();
    const bool is_new = app.session().shown() != before_net;
    const double before = seconds();
    app.draw();
    times.push_back(seconds() - before);
    if (is_new) times_of_new_nets.push_back(times.back());
  }
  report("frame, 800 faces, searching", times);
  report("  of these, with a new net", times_of_new_nets);
  app.session().stop();
  while (app.session().state() != RunState::Idle) app.turn(0.01);
}

/// Begins the next search when one is over, which at full speed may be soon.
void keep_searching(Session& session) {
  session.skip_replay();
  if (session.state() == RunState::Idle) session.new_seed();
}

/// The slider moves in every frame while searches run at full speed, one after the other.
void measure_folding(Application& app, const char* what, const PolygonSoup& soup, int n_frames) {
  open_shape(app, soup);
  app.session().set_speed(std::numeric_limits<double>::infinity());
  app.session().unfold();
  while (app.session().shown() == nullptr) app.turn(0.01);
  std::vector<double> times;
  for (int i = 0; i < n_frames; ++i) {
    app.ui().folding.amount = static_cast<double>(i) / n_frames;
    app.session().poll();
    keep_searching(app.session());
    const double before = seconds();
    app.draw();
    times.push_back(seconds() - before);
  }
  report(what, times);
  app.ui().folding.amount = 1;
  app.session().stop();
  app.session().skip_replay();
  while (app.session().state() != RunState::Idle) app.turn(0.01);
}

void measure_stops(Application& app, const char* what, const PolygonSoup& soup, double speed) {
  constexpr int kStops = 10;
  open_shape(app, soup);
  app.session().set_speed(speed);
  std::vector<double> times;
  for (int i = 0; i < kStops; ++i) {
    app.session().set_seed(static_cast<std::uint64_t>(i));
    app.session().unfold();
    const double start = seconds();
    while (seconds() - start < 0.3 && app.session().state() == RunState::Running) app.turn(0.01);
    if (app.session().state() != RunState::Running) continue;
    const double before = seconds();
    app.session().stop();
    while (app.session().state() == RunState::Running) {
      app.session().poll();
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    times.push_back(seconds() - before);
    app.session().skip_replay();
  }
  report(what, times);
}

/// A torus of 800 faces with a picture laid over it from above.
void open_textured(Application& app) {
  constexpr int kSize = 2048;
  PolygonSoup soup = shapes::torus(25, 16);
  Box3 box;
  for (const glm::dvec3& p : soup.points) box.add(p);
  for (const int corner : soup.corners) {
    const glm::dvec3 share = (soup.points[static_cast<std::size_t>(corner)] - box.min) / box.size();
    soup.corner_uv.emplace_back(share.x, share.z);
  }
  Image picture{kSize, kSize, {}};
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x)
      for (const int value : {x / 8, y / 8, (x ^ y) & 255, 255})
        picture.rgba.push_back(static_cast<std::uint8_t>(value));
  const std::string library = "newmtl " + soup.name + "\nmap_Kd picture.png\n";
  const std::string png = encode_png(picture);
  app.session().open_bytes("torus.obj", shapes::to_obj(soup, "torus.mtl"), [=](const std::string& name) {
    return std::optional(name == "torus.mtl" ? library : png);
  });
  while (app.session().state() != RunState::Idle) app.turn(0.01);
}

/// To a net on its sheets, as fast as it goes; how long the slowest look at the session took, frame
/// included, and how long the pages were on their way behind the net.
void measure_pages(Application& app, const char* what) {
  app.session().set_speed(std::numeric_limits<double>::infinity());
  app.session().unfold();
  while (app.session().state() != RunState::Idle) {
    app.session().skip_replay();
    app.turn(0.005);
  }
  const double before = seconds();
  std::vector<double> times;
  while (app.session().sheets() == nullptr && app.session().is_laying_out()) {
    const double start = seconds();
    app.session().poll();
    app.draw();
    times.push_back(seconds() - start);
  }
  const auto sheets = app.session().sheets();
  std::printf("%-28s %zu sheets after %.0f ms\n", what, sheets ? sheets->size() : 0,
              (seconds() - before) * 1000);
  report("  frames meanwhile", times);
  const double start = seconds();
  app.draw();
  std::printf("%-28s %.1f ms\n", "  first frame with them", (seconds() - start) * 1000);
}

/// The printed sheets are moved under the pointer, zoomed in so that letters are seen.
void measure_printed(Application& app, HeadlessWindow& window, const char* what) {
  constexpr int kFrames = 60;
  for (int i = 0; i < 3; ++i) app.draw();
  window.move_mouse({1200, 500});
  for (int i = 0; i < 6; ++i) {
    window.scroll({0, 1});
    app.turn(0);
    app.draw();
  }
  window.press_mouse(1);
  std::vector<double> times;
  for (int i = 0; i < kFrames; ++i) {
    window.move_mouse({1200 + 2 * (i % 30), 500 + i % 20});
    const double before = seconds();
    app.turn(0);
    app.draw();
    times.push_back(seconds() - before);
  }
  window.release_mouse(1);
  report(what, times);
}

}  // namespace

int main() {
  HeadlessWindow window({"Netwright", {1600, 1000}});
  Application app(window, seconds, {});
  measure_frames(app);
  measure_folding(app, "fold slider, 800 faces", shapes::bumpy_patch(20, 20), 400);
  measure_folding(app, "fold slider, 12 000 faces", shapes::bumpy_patch(78, 78), 100);
  measure_stops(app, "stop, 800 faces, watched", shapes::bumpy_patch(20, 20), 60);
  measure_stops(app, "stop, 3200 faces, full speed", shapes::bumpy_patch(40, 40),
                std::numeric_limits<double>::infinity());
  open_textured(app);
  measure_pages(app, "800 faces with a texture");
  measure_printed(app, window, "  sheets moved");
  open_shape(app, shapes::torus(100, 60));
  measure_pages(app, "12 000 faces");
  measure_printed(app, window, "  sheets moved");
  return 0;
}
