// The session's commands: what the user asks for. What comes back from the worker is taken in by
// session_poll.cpp.
#include "core/project/session.h"

#include <cmath>

#include "core/project/commands.h"
#include "core/project/polish_aim.h"
#include "core/project/session_impl.h"
#include "core/project/tab_aim.h"

namespace netwright {

Session::Impl::Impl(Clock clock_function) : clock(std::move(clock_function)) {
  keeper.set_runs([this](const Project& saved) { return runs_to_keep(runs, saved.dual); });
}

Session::Impl::~Impl() {
  bell->set_listener({});
  run.reset();  // a search that waits at its gate would keep the worker from joining
}

void Session::Impl::say(Message::Kind kind, std::string text) {
  messages.push_back({kind, std::move(text), ++n_messages});
}

std::shared_ptr<ShownNet> Session::Impl::stamp(std::shared_ptr<ShownNet> net) {
  net->version = ++n_versions;
  return net;
}

void Session::Impl::check_pins() {
  if (checked_dual == project().dual && checked_pins == project().pins) return;
  checked_dual = project().dual;
  checked_pins = project().pins;
  contradiction = checked_dual ? find_contradiction(*checked_dual, checked_pins) : std::nullopt;
}

void Session::Impl::start_run(SearchRun::Start start, std::shared_ptr<const UnfoldTree> from,
                              bool stays_near) {
  check_pins();
  const std::optional<Contradiction> of_edits =
      stays_near && !contradiction ? find_contradiction(*project().dual, pins_with_edits(project()))
                                   : std::nullopt;
  if (contradiction || of_edits) {
    run.reset();
    say(Message::Kind::Error, contradiction ? contradiction->sentence : of_edits->sentence);
    return;
  }
  SolveOptions options;
  options.seed = project().seed;
  options.streams = streams;
  options.threads = threads;
  options.pins = stays_near ? pins_with_edits(project()) : project().pins;
  options.from = std::move(from);
  options.stays_near = stays_near;
  options.polish = polish_aim(project(), polish);
  options.tabs = tab_aim(project().paper, project().size, project().tabs);
  is_timed_out = false;
  step_of_run.reset();
  leave_view();
  stop_trial();
  run.reset();  // its job is told to end before the new one is queued
  run = std::make_unique<SearchRun>(worker, project().dual, options, bell, start, speed, clock());
}

void Session::Impl::discard_run() {
  run.reset();
  moving = nullptr;
}

void Session::Impl::edit(std::string label, Project next) {
  if (next.tree != project().tree || next.dual != project().dual) leave_view();
  history.push(std::move(label), std::move(next));
  derive_again();
}

void Session::Impl::come_to_rest() {
  end_replay();
  leave_view();
  discard_run();
  has_net_in_step = false;
}

void Session::Impl::move_in_history(std::size_t position) {
  come_to_rest();
  const std::shared_ptr<const UnfoldTree> tree = project().tree;
  const std::shared_ptr<const DualGraph> dual = project().dual;
  history.go_to(position);
  waiting = is_unrepaired() ? answered : std::nullopt;
  if (project().dual != dual) derived = nullptr;
  if (project().tree != tree || project().dual != dual) drop_result();
  derive_again();
}

void Session::Impl::drop_result() {
  is_unfinished = false;
  last_figures.reset();
  settled = project().tree && derived ? derived->shown : nullptr;
}

void Session::Impl::relay_unfinished(FaceId root) {
  if (!is_unfinished || !root.is_valid()) return;
  const ShownNet& old = *settled;
  auto shown = std::make_shared<ShownNet>(
      make_shown_net(layout_from(old.net.dual, old.net.tree, {root}), old.overlaps, false));
  settled = stamp(std::move(shown));
}

Session::Session(Clock clock) : impl_(std::make_unique<Impl>(std::move(clock))) {}
Session::~Session() = default;

bool Session::poll() { return impl_->poll(); }

void Session::set_wake(std::function<void()> wake) { impl_->bell->set_listener(std::move(wake)); }

double Session::wait_seconds() const {
  constexpr double kFrame = 1.0 / 60;
  constexpr double kTenth = 0.1;
  if (impl_->playing || (impl_->viewing && impl_->viewing->is_playing)) return kFrame;
  if (impl_->run && !impl_->run->is_paused()) return kTenth;
  return impl_->keeper.wait_seconds(impl_->clock());
}

RunState Session::state() const {
  if (impl_->run) return impl_->run->is_paused() ? RunState::Paused : RunState::Running;
  if (impl_->playing) return RunState::Replaying;
  if (impl_->opening) return RunState::Opening;
  return has_model() ? RunState::Idle : RunState::Empty;
}

const Project& Session::project() const { return impl_->project(); }

std::shared_ptr<const ShownNet> Session::shown() const {
  if (impl_->moving) return impl_->moving;
  return impl_->viewing && impl_->viewing->picture ? impl_->viewing->picture : impl_->settled;
}

RunFigures Session::figures() const {
  if (impl_->run) return impl_->run->figures();
  if (impl_->viewing) return impl_->view_figures();
  return impl_->playing ? impl_->replay_figures() : impl_->settled_figures();
}

std::shared_ptr<const Progress> Session::chore() const {
  if (impl_->opening) return impl_->opening->progress;
  if (impl_->replacing) return impl_->replacing->progress;
  if (impl_->chore_making) return impl_->chore_making->progress;
  return impl_->exports.empty() ? nullptr : impl_->exports.front()->progress;
}

void Session::unfold() {
  if (!has_model()) return;
  if (impl_->run) {
    impl_->run->resume(impl_->clock());
  } else if (impl_->playing) {
    impl_->end_replay();
  } else {
    impl_->start_run(SearchRun::Start::Running);
  }
}

void Session::unfold_from_here() {
  const std::shared_ptr<const ShownNet> here = shown();
  if (!has_model() || impl_->run || !here || here->net.dual != project().dual) {
    unfold();
    return;
  }
  impl_->end_replay();
  impl_->start_run(SearchRun::Start::Running, std::make_shared<const UnfoldTree>(here->net.tree), true);
}

void Session::pause() {
  if (impl_->run) impl_->run->pause(impl_->clock());
}

void Session::step() {
  if (!has_model()) return;
  impl_->end_replay();
  if (!impl_->run) impl_->start_run(SearchRun::Start::Paused);
  if (impl_->run) impl_->run->step(impl_->clock());
}

void Session::stop() {
  impl_->end_replay();
  if (impl_->run) impl_->run->cancel();
}

void Session::new_seed() {
  set_seed((impl_->run ? impl_->run->options().seed : project().seed) + 1);
  if (!has_model()) return;
  impl_->end_replay();
  impl_->start_run(SearchRun::Start::Running);
}

void Session::set_seed(std::uint64_t seed) { impl_->history.amend(netwright::set_seed(project(), seed)); }

void Session::skip_replay() { impl_->end_replay(); }

void Session::set_speed(double moves_per_second) {
  impl_->speed =
      std::isnan(moves_per_second) ? PaceGate::kSlowest : std::max(moves_per_second, PaceGate::kSlowest);
  if (impl_->run) impl_->run->set_speed(impl_->speed);
}

double Session::speed() const { return impl_->speed; }
void Session::set_threads(int threads) { impl_->threads = std::max(threads, 0); }
void Session::set_streams(int streams) { impl_->streams = std::max(streams, 1); }
int Session::streams() const { return impl_->streams; }
void Session::set_polish(const PolishSettings& settings) { impl_->polish = settings; }
const PolishSettings& Session::polish() const { return impl_->polish; }
void Session::set_time_limit(double seconds) { impl_->time_limit_s = std::max(seconds, 0.0); }
double Session::time_limit() const { return impl_->time_limit_s; }

void Session::pin_root(FaceId face) {
  Constraints pins = project().pins;
  pins.root = face;
  set_pins(pins, face.is_valid() ? "pin root" : "unpin root");
}

void Session::set_pins(const Constraints& pins, const std::string& label) {
  if (!has_model() || pins == project().pins) return;
  impl_->end_replay();
  const bool is_running = impl_->run != nullptr;
  const bool is_paused = is_running && impl_->run->is_paused();
  const std::shared_ptr<const ShownNet> reached = is_running ? impl_->moving : nullptr;
  impl_->discard_run();
  if (pins.root != project().pins.root) impl_->relay_unfinished(pins.root);
  impl_->edit(label, netwright::set_pins(project(), pins));
  if (is_running)
    impl_->start_run(is_paused ? SearchRun::Start::Paused : SearchRun::Start::Running,
                     reached ? std::make_shared<const UnfoldTree>(reached->net.tree) : nullptr);
}

const Contradiction* Session::contradiction() const {
  impl_->check_pins();
  return impl_->contradiction ? &*impl_->contradiction : nullptr;
}

bool Session::keeps_pins() const {
  const std::shared_ptr<const ShownNet> net = shown();
  return !net || !has_model() || net->net.dual != project().dual ||
         netwright::keeps_pins(project().dual->mesh(), net->net.tree, project().pins);
}

void Session::set_paper(const PaperSetup& paper) {
  if (paper != project().paper) impl_->edit("paper", netwright::set_paper(project(), paper));
}

const std::optional<RealSize>& Session::asked_size() const { return impl_->asked_size; }
void Session::leave_size() { impl_->asked_size.reset(); }
void Session::set_desk_paper(const std::string& format) {
  impl_->desk_paper = format;
  if (has_model()) return;
  PaperSetup paper = project().paper;
  paper.format = format;
  impl_->history.amend(netwright::set_paper(project(), paper));
}

void Session::set_size(const PrintSize& size) {
  leave_size();
  if (size != project().size) impl_->edit("print size", netwright::set_size(project(), size));
}

bool Session::can_undo() const {
  return impl_->history.can_undo() || (impl_->is_unfinished && project().tree != nullptr);
}
bool Session::can_redo() const { return impl_->history.can_redo(); }

std::string Session::undo_label() const {
  if (impl_->is_unfinished && project().tree) return "Undo unfinished run";
  const std::string label = impl_->history.undo_label();
  return label.empty() ? "Undo" : "Undo " + label;
}

std::string Session::redo_label() const {
  const std::string label = impl_->history.redo_label();
  return label.empty() ? "Redo" : "Redo " + label;
}

void Session::undo() {
  const bool is_first_change = impl_->chore_making && !impl_->making.continues_step;
  impl_->cancel_making();
  if (is_first_change) return;  // what was asked for last has not come yet: it never will
  if (impl_->is_unfinished && project().tree) {
    impl_->come_to_rest();
    impl_->drop_result();
  } else if (can_undo()) {
    impl_->move_in_history(impl_->history.position() - 1);
  }
}

void Session::redo() {
  impl_->cancel_making();
  if (can_redo()) impl_->move_in_history(impl_->history.position() + 1);
}

std::vector<std::string> Session::history() const {
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < impl_->history.size(); ++i) labels.push_back(impl_->history.label(i));
  return labels;
}

std::string Session::first_name() const {
  const auto& source = impl_->history.at(0).source;
  return source ? source->name : "";
}

std::size_t Session::history_position() const { return impl_->history.position(); }

void Session::go_to_step(std::size_t position) {
  if (position == impl_->history.position() || position >= impl_->history.size()) return;
  impl_->cancel_making();
  impl_->drop_result();  // an unfinished net on top of the steps goes, too
  impl_->move_in_history(position);
}

std::shared_ptr<const std::vector<Sheet>> Session::sheets() const {
  if (impl_->run || impl_->is_unfinished || !impl_->derived) return nullptr;
  const bool is_of_this_net = impl_->derived->source.tree == project().tree;
  return is_of_this_net ? impl_->derived->sheets : nullptr;
}

std::shared_ptr<const std::vector<EdgeId>> Session::unnumbered() const {
  return sheets() ? impl_->derived->unnumbered : nullptr;
}

std::shared_ptr<const Sheet> Session::instructions() const {
  return sheets() ? impl_->derived->instructions : nullptr;
}

bool Session::may_export() {
  const bool has_run = impl_->run != nullptr;
  if (has_run || impl_->is_unfinished || !project().tree) {
    impl_->say(Message::Kind::Notice,
               has_run ? "The search is still going: the net can be saved when it is done."
                       : "There is no net without overlaps yet: unfold the model first, then save.");
    return false;
  }
  const Misplaced* const wrong = misplaced();
  if (wrong != nullptr) impl_->say(Message::Kind::Error, misplaced_sentence(*wrong));
  return wrong == nullptr;
}

void Session::export_to(const std::filesystem::path& path) {
  if (may_export()) impl_->export_to(path, project(), impl_->derived);
}

void Session::export_for_cutter(const std::filesystem::path& folder, CutterPreset preset) {
  if (may_export()) impl_->export_for_cutter(folder, preset);
}

std::vector<Message> Session::take_messages() { return std::exchange(impl_->messages, {}); }

}  // namespace netwright
