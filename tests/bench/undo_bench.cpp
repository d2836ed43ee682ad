// How fast the editor goes through its history and through a run's moves at 12 000 faces: the switch itself,
// which is the call of undo(), redo() or go_to_step(), and a leap in a log of 500 000 moves, with and without
// the net laid out. The promises are 16 ms for a switch and 30 ms for a leap, whose picture is a chore.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <thread>
#include <vector>

#include "core/base/predicates.h"
#include "core/base/random.h"
#include "core/project/replay.h"
#include "core/project/session.h"
#include "core/project/shown_net.h"
#include "tests/support.h"

namespace {

using namespace netwright;

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <class Work>
double time_of(const Work& work) {
  const double before = seconds();
  work();
  return seconds() - before;
}

void report(const char* what, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  std::printf("%-36s median %7.3f ms   worst %7.3f ms   of %zu\n", what, values[values.size() / 2] * 1000,
              values.back() * 1000, values.size());
}

void wait_for(Session& session, const std::function<bool()>& holds) {
  while (!holds()) {
    session.poll();
    if (session.state() == RunState::Replaying) session.skip_replay();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void settle(Session& session) {
  wait_for(session,
           [&] { return session.state() == RunState::Idle && !session.chore() && !session.is_making(); });
}

void measure_switches() {
  Session session(seconds);
  session.open_bytes("patch.obj", shapes::to_obj(shapes::bumpy_patch(78, 78)));
  wait_for(session, [&] { return session.has_model(); });
  session.unfold();
  settle(session);
  for (const int face : {5, 5000, 9000}) session.pin_root(FaceId(face));
  session.set_paper({.format = "A3"});
  session.simplify_to(6000, false);
  settle(session);
  std::vector<double> switches;
  for (int round = 0; round < 10; ++round) {
    while (session.can_undo()) switches.push_back(time_of([&] { session.undo(); }));
    while (session.can_redo()) switches.push_back(time_of([&] { session.redo(); }));
    switches.push_back(time_of([&] { session.go_to_step(1); }));
    for (int i = 0; i < 50; ++i) session.poll();
  }
  report("a switch, 12 168 and 6000 faces", switches);
}

/// A log that goes back and forth over the last exchange of a real one.
std::shared_ptr<const RunLog> long_log(int n_moves) {
  Progress progress;
  const auto dual = testing::make_dual(shapes::bumpy_patch(78, 78));
  for (std::uint64_t seed = 0;; ++seed) {
    SolveResult result = solve(dual, {.seed = seed}, progress);
    if (result.log.empty() || result.log.back().moves.empty()) continue;
    std::vector<MoveRecord>& moves = result.log.back().moves;
    MoveRecord back = moves.back();
    const MoveRecord move = moves.back();
    std::swap(back.removed, back.inserted);
    while (static_cast<int>(moves.size()) < n_moves) moves.insert(moves.end(), {back, move});
    result.moves = n_moves;
    return std::make_shared<const RunLog>(result);
  }
}

void measure_leaps() {
  const auto log = long_log(500000);
  Replay replay(log);
  Random random(1);
  std::vector<double> leaps;
  std::vector<double> pictures;
  for (int i = 0; i < 40; ++i) {
    const int goal = random.below(log->n_steps());
    leaps.push_back(time_of([&] { replay.seek(goal); }));
    pictures.push_back(time_of([&] {
      Net net = replay.net();
      std::vector<Overlap> overlaps = find_overlaps(net, kShownDepth);
      make_shown_net(std::move(net), std::move(overlaps), false);
    }));
  }
  report("a leap among 500 000 moves", leaps);
  report("its picture, 12 168 faces (chore)", pictures);
}

}  // namespace

int main() {
  measure_switches();
  measure_leaps();
  return 0;
}
