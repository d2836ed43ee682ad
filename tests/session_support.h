// A session as the window drives it: real worker, real search, a clock that the test turns, and the models
// that tests of the session open.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "core/project/session.h"
#include "tests/support.h"

namespace netwright::testing {

inline constexpr double kFullSpeed = std::numeric_limits<double>::infinity();
inline constexpr double kAMoveInTenSeconds = 0.1;

inline std::string bumpy() { return shapes::to_obj(shapes::bumpy_patch(6, 6)); }
inline std::string ball() { return shapes::to_obj(shapes::icosphere(4)); }
/// Nearly flat terrain, full of saddles: a search of thousands of moves.
inline std::string terrain() {
  PolygonSoup soup = shapes::bumpy_patch(16, 16);
  Random random(1);
  for (glm::dvec3& p : soup.points) p.y = 0.05 * random.unit();
  return shapes::to_obj(soup);
}
/// A box with one face twice: nothing that paper can be.
inline std::string broken_box() {
  PolygonSoup soup = shapes::cuboid({1, 2, 3});
  soup.add_face(std::vector<int>(soup.face(0).begin(), soup.face(0).end()));
  return shapes::to_obj(soup);
}
/// A box with a corner pulled out: three quads that are not flat.
inline std::string bent_box() {
  PolygonSoup soup = shapes::cuboid({2, 1, 3});
  soup.points.back() += glm::dvec3(0.1, 0.2, 0.15);
  return shapes::to_obj(soup);
}
/// A search that goes on until it is told to end.
inline std::string endless() { return shapes::to_obj(endless_search()); }

class SessionTest : public ::testing::Test {
 protected:
  /// The test's clock does not wait for the search: on a slow machine a minute of it is over before the first
  /// move. Tests of the time limit set their own.
  void SetUp() override { session_.set_time_limit(0); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// One frame of the window: 10 ms of fake time and some of the worker's.
  void frame() {
    now_ += 0.01;
    session_.poll();
    if (skips_replays_ && session_.state() == RunState::Replaying) session_.skip_replay();
    for (Message& message : session_.take_messages()) messages_.push_back(std::move(message));
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  /// Frames until it is so; the number bounds the test, not the product.
  template <class Condition>
  [[nodiscard]] bool frames_until(Condition condition) {
    for (int i = 0; i < 300000; ++i) {
      if (condition()) return true;
      frame();
    }
    return false;
  }
  [[nodiscard]] bool frames_until_idle() {
    return frames_until([this] {
      return session_.state() == RunState::Idle && (!session_.project().tree || session_.sheets()) &&
             !session_.chore();
    });
  }
  void open(const std::string& bytes, const std::string& name = "model.obj") {
    session_.open_bytes(name, bytes);
    ASSERT_TRUE(frames_until([this] { return session_.state() == RunState::Idle; }));
    ASSERT_TRUE(session_.has_model());
  }
  void open_and_unfold(const std::string& bytes) {
    open(bytes);
    session_.unfold();
    ASSERT_TRUE(frames_until_idle());
    ASSERT_TRUE(session_.shown() && session_.shown()->is_proved);
  }
  /// The run is over before the clock moves on, as a fast one is.
  void open_and_unfold_between_two_frames(const std::string& bytes) {
    open(bytes);
    session_.unfold();
    while (session_.state() == RunState::Running) session_.poll();
    ASSERT_EQ(session_.state(), RunState::Replaying);
  }
  /// The net that solve() finds with the session's options, called without any session.
  [[nodiscard]] SolveResult solved_directly() const {
    SolveOptions options;
    options.seed = session_.project().seed;
    options.streams = session_.streams();
    options.pins.root = session_.project().pins.root;
    Progress progress;
    return solve(session_.project().dual, options, progress);
  }
  [[nodiscard]] bool has_message(Message::Kind kind, const std::string& words) const {
    for (const Message& message : messages_)
      if (message.kind == kind && message.text.find(words) != std::string::npos) return true;
    return false;
  }
  std::filesystem::path in_folder(const std::string& name) {
    std::filesystem::create_directories(folder_);
    return folder_ / name;
  }

  bool skips_replays_ = false;
  double now_ = 100;
  Session session_{[this] { return now_; }};
  std::vector<Message> messages_;
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("netwright_session_" + std::to_string(getpid()));
};

}  // namespace netwright::testing
