// The session's models: opening a file, asking what to do about a broken one, and making the mesh anew when
// the recipe changes.
#include <cmath>

#include "core/base/counted.h"
#include "core/mesh/mesh_report.h"
#include "core/project/carry_pins.h"
#include "core/project/commands.h"
#include "core/project/session_impl.h"

namespace netwright {

void Session::Impl::open(ModelSource source) {
  if (opening) opening->progress->cancel();
  opening_slot.reset();
  opening_file = source.path;
  opening = std::make_shared<Chore<Opened>>(bell);
  opening->progress =
      worker.submit(Worker::Lane::Chores, [chore = opening, model = std::move(source)](Progress& progress) {
        auto opened = std::make_shared<Opened>();
        if (progress.is_cancelled()) return;
        try {
          if (is_project_file(model.path)) {
            progress.set_phase("Reading " + model.path.filename().string());
            opened->stored = load_project(model.path);
            Project& project = opened->stored->project;
            MadeModel made = *project.made;
            add_survey(made, progress);
            project.made = std::make_shared<const MadeModel>(std::move(made));
            opened->runs = finished_again(project.dual, opened->stored->runs, progress);
          } else {
            opened->model = open_model(model, progress);
          }
        } catch (...) {
          opened->fault = sentence_for_current_exception("Opening the model");
        }
        if (!progress.is_cancelled()) chore->result.post(std::move(opened));
      });
}

bool Session::Impl::take_opened() {
  const std::shared_ptr<const Opened> opened = opening ? opening->result.take() : nullptr;
  if (!opened) return false;
  opening = nullptr;
  waiting.reset();
  if (opened->stored) {
    take_stored(*opened->stored, opened->runs);
    return true;
  }
  opening_slot.reset();
  if (!opened->model) {
    say(Message::Kind::Error, opened->fault);
    return true;
  }
  const OpenedModel& model = *opened->model;
  if (model.made.dual) {
    adopt(model, {}, std::make_shared<const MadeModel>(model.made));
    return true;
  }
  ask_about({{}, model, usual_repair()});
  return true;
}

void Session::Impl::ask_about(Waiting question) {
  cancel_making();
  Pending& shown = question.shown;
  shown.name = question.model.source->name;
  shown.report = report_on(*question.model.source);
  shown.refusal = question.model.made.refusal;
  shown.recipe = question.tried;
  shown.made = question.model.repaired;
  waiting = std::move(question);
}

void Session::Impl::replace(Project next) {
  cancel_making();
  cancel_replacing();
  answered.reset();
  replace_news.clear();
  discard_run();
  playing.reset();
  asked_size.reset();
  leave_view();
  runs.clear();
  history = History(std::move(next));
  derived = nullptr;
  drop_result();
  derive_again();
}

void Session::Impl::adopt(const OpenedModel& model, const Recipe& recipe,
                          const std::shared_ptr<const MadeModel>& made) {
  Project next = new_project(project(), model.path, made->dual);
  if (!desk_paper.empty()) next.paper.format = desk_paper;
  next.source = model.source;
  next.recipe = recipe;
  next.made = made;
  if (model.made.dual) {
    replace(std::move(next));
  } else {  // taking the repair back leads to the file as it was
    Project unrepaired = next;
    unrepaired.recipe = {};
    unrepaired.dual = nullptr;
    unrepaired.made = std::make_shared<const MadeModel>(model.made);
    replace(std::move(unrepaired));
    history.push("repair", std::move(next));
  }
  keeper.adopt_saved(project(), {});
  tell_about(model, *made);
  const RealSize size = real_size(*model.source, made->dual->mesh());
  asked_size = size.is_worth_asking() ? std::optional(size) : std::nullopt;
}

// The sentences stay to be read in the model's report; what fades after some seconds says no more than that.
void Session::Impl::tell_about(const OpenedModel& model, const MadeModel& made) {
  const std::string& name = model.source->name;
  if (!made.done.empty()) {
    say(Message::Kind::Notice,
        name + " was repaired: " + counted(model.source->n_faces(), "face", "faces") + " before, " +
            grouped(static_cast<std::int64_t>(made.dual->mesh().n_faces())) + " after.");
  } else if (model.notices.size() == 1) {
    say(Message::Kind::Notice, model.notices.front());
  } else if (!model.notices.empty()) {
    say(Message::Kind::Notice, name + ": its report has " +
                                   counted(static_cast<std::int64_t>(model.notices.size()), "note", "notes") +
                                   ".");
  }
}

void Session::Impl::make(Making wanted) {
  if (chore_making) chore_making->progress->cancel();
  stop_measuring();
  making = std::move(wanted);
  chore_making = std::make_shared<Chore<Made>>(bell);
  chore_making->progress =
      worker.submit(Worker::Lane::Chores, [chore = chore_making, recipe = making.recipe,
                                           source = waiting ? waiting->model.source : project().source,
                                           before = waiting ? nullptr : project().made](Progress& progress) {
        auto made = std::make_shared<Made>();
        try {
          MadeModel model = make_model(source, recipe, before ? before->stages : nullptr, progress);
          add_survey(model, progress);
          made->model = std::make_shared<const MadeModel>(std::move(model));
        } catch (...) {
          made->fault = sentence_for_current_exception("Changing the model");
        }
        if (!progress.is_cancelled()) chore->result.post(std::move(made));
      });
}

void Session::Impl::cancel_making() {
  if (chore_making) chore_making->progress->cancel();
  chore_making = nullptr;
  queued.reset();
}

// While the slider is held, mesh and net are one entry that the next mesh takes over. Afterwards the net is a
// step like any other net, whether it was found before the hand let go or after.
void Session::Impl::part_net_from_step() {
  if (!std::exchange(has_net_in_step, false) || !project().tree) return;
  Project with_net = project();
  Project without_net = with_net;
  without_net.tree = nullptr;
  without_net.run.reset();
  history.amend(std::move(without_net));
  history.push("unfold", std::move(with_net));
}

// For a waiting file the mesh is only a proposal.
void Session::Impl::take_tried(const Made& made) {
  if (made.model) {
    waiting->shown.made = made.model;
    waiting->tried = making.recipe;
  } else {
    waiting->shown.recipe = waiting->tried;
    say(Message::Kind::Error, made.fault);
  }
}

void Session::Impl::stop_measuring() {
  if (measuring) measuring->progress->cancel();
  measuring = nullptr;
}

// The next mesh is worth more than a figure about this one: nothing is measured while one is being made.
void Session::Impl::measure_when_idle() {
  const std::shared_ptr<const MadeModel>& made = project().made;
  if (measuring || chore_making || queued || !made || !made->dual || made->deviation) return;
  if (measured && measured->made == made) return;
  measuring = std::make_shared<Chore<Measured>>(bell);
  measuring->progress = worker.submit(Worker::Lane::Chores, [chore = measuring, made](Progress& progress) {
    if (progress.is_cancelled()) return;
    const double deviation = measure_deviation(*made, progress);
    if (!progress.is_cancelled()) chore->result.post(std::make_shared<Measured>(Measured{made, deviation}));
  });
}

bool Session::Impl::take_measured() {
  const std::shared_ptr<const Measured> news = measuring ? measuring->result.take() : nullptr;
  if (!news) return false;
  measuring = nullptr;
  measured = news;
  return true;
}

// All meshes of a drag come from the project as it was when the hand took hold: carried from mesh to mesh,
// pins would wander, and what a coarse mesh has no place for would not come back with the finer one.
bool Session::Impl::take_mesh(const std::shared_ptr<const MadeModel>& made) {
  const bool continues = making.continues_step && history.position() == drag_step && drag_step > 0;
  const Project& before = continues ? history.at(drag_step - 1) : project();
  std::shared_ptr<const MadeModel> model = made;
  const bool is_back = continues && before.recipe == making.recipe;
  if (is_back) {  // the very mesh, so that its net and its runs are there again
    auto same = std::make_shared<MadeModel>(*made);
    same->dual = before.dual;
    model = std::move(same);
  }
  const CarriedPins carried = carry_pins(before.pins, before.dual->mesh(), model->dual->mesh());
  if (carried.n_lost > 0) say(Message::Kind::Notice, carried.sentence());
  Project next = is_back ? before : remake(before, making.recipe, model);
  next.made = model;
  if (continues) {
    history.amend(std::move(next));
  } else {
    history.push(making.label, std::move(next));
    making.continues_step = true;
    drag_step = history.position();
  }
  return is_back;
}

bool Session::Impl::take_made() {
  const std::shared_ptr<const Made> made = chore_making ? chore_making->result.take() : nullptr;
  if (!made) return false;
  chore_making = nullptr;
  if (waiting) {
    take_tried(*made);
    return true;
  }
  if (!made->model || !made->model->dual) {
    queued.reset();
    say(Message::Kind::Error, made->model ? made->model->refusal : made->fault);
    return true;
  }
  const bool was_running = run != nullptr;
  end_replay();
  discard_run();
  const bool is_back = take_mesh(made->model);
  leave_view();
  runs.keep([this](const std::shared_ptr<const DualGraph>& dual) { return history.holds(dual); });
  derived = nullptr;
  drop_result();
  derive_again();
  has_net_in_step = false;
  const bool has_net_again = is_back && project().tree;
  if ((making.unfolds || was_running) && !has_net_again) start_run(SearchRun::Start::Running);
  if (queued) {
    Making latest = *std::exchange(queued, std::nullopt);
    latest.continues_step = true;
    make(std::move(latest));
  }
  return true;
}

// Agreed to for a new file, for another version of the present model, or again after the repair was undone:
// the same repairs are redone then, with all that came after them.
void Session::Impl::repair(Waiting agreed) {
  if (agreed.replaces) {
    begin_replacing(agreed.model.path, agreed.model.source, agreed.tried);
    return;
  }
  const bool is_asked_again = is_unrepaired() && project().source == agreed.model.source;
  if (!is_asked_again) {
    adopt(agreed.model, agreed.tried, agreed.shown.made);
  } else if (history.can_redo() && history.at(history.position() + 1).recipe == agreed.tried) {
    move_in_history(history.position() + 1);
  } else {
    Project next = project();
    next.recipe = agreed.tried;
    next.made = agreed.shown.made;
    next.dual = next.made->dual;
    edit("repair", std::move(next));
  }
  waiting.reset();
  answered = std::move(agreed);
}

std::optional<Session::Unrepaired> Session::unrepaired() const {
  if (!impl_->is_unrepaired()) return std::nullopt;
  return Unrepaired{project().source->name, project().made->refusal};
}

void Session::ask_again() {
  if (impl_->is_unrepaired() && !impl_->waiting) impl_->waiting = impl_->answered;
}

void Session::open(const std::filesystem::path& path) { impl_->open({path, {}, {}, {}}); }

void Session::open_bytes(const std::string& name, std::string bytes, CompanionLookup companions) {
  impl_->open({{}, name, std::move(bytes), std::move(companions)});
}

void Session::cancel_opening() {
  if (impl_->opening) impl_->opening->progress->cancel();
  impl_->opening = nullptr;
  impl_->opening_slot.reset();
  impl_->cancel_replacing();
  impl_->cancel_making();
  if (impl_->waiting) impl_->waiting->shown.recipe = impl_->waiting->tried;
}

const MeshReport* Session::report() const { return has_model() ? &project().made->report : nullptr; }

const Session::Pending* Session::pending() const { return impl_->waiting ? &impl_->waiting->shown : nullptr; }

void Session::try_pending(const Recipe& recipe) {
  if (!impl_->waiting || recipe == impl_->waiting->shown.recipe) return;
  impl_->waiting->shown.recipe = recipe;
  impl_->make({recipe, "", false, false});
}

void Session::repair_pending() {
  if (!impl_->waiting || is_making() || !impl_->waiting->shown.is_fit()) return;
  Impl::Waiting agreed = std::move(*impl_->waiting);
  impl_->waiting.reset();
  impl_->repair(std::move(agreed));
}

void Session::drop_pending() {
  if (impl_->waiting) cancel_opening();
  impl_->waiting.reset();
}

bool Session::is_making() const { return impl_->chore_making != nullptr; }

Recipe Session::wanted_recipe() const {
  if (impl_->queued) return impl_->queued->recipe;
  return impl_->chore_making && !impl_->waiting ? impl_->making.recipe : project().recipe;
}

void Session::set_recipe(const Recipe& recipe, const std::string& label) {
  if (!has_model() || recipe == wanted_recipe()) return;
  impl_->queued.reset();
  Recipe turned_only = project().recipe;
  turned_only.up = recipe.up;
  const bool loses_net = project().tree != nullptr && recipe != turned_only;
  impl_->make({recipe, label, loses_net, false});
}

void Session::simplify_to(int faces, bool is_dragging) {
  if (!has_model()) return;
  const bool is_same_gesture = std::exchange(impl_->is_dragging, is_dragging);
  Recipe recipe = wanted_recipe();
  if (faces == recipe.faces) {
    if (!is_dragging && !impl_->chore_making) impl_->part_net_from_step();
    return;
  }
  recipe.faces = faces;
  const bool continues = is_same_gesture && impl_->making.continues_step;
  Impl::Making wanted{recipe, "simplify", true, continues};
  if (impl_->chore_making && is_same_gesture) {
    // Breaking off what is nearly done would leave a steadily moved slider without any picture.
    impl_->queued = std::move(wanted);
  } else {
    impl_->queued.reset();
    impl_->make(std::move(wanted));
  }
}

int Session::n_faces_before_simplifying() const {
  return has_model() ? static_cast<int>(project().made->stages->mesh->n_faces()) : 0;
}

std::optional<double> Session::deviation_mm() const {
  if (!has_model()) return 0;
  const std::shared_ptr<const MadeModel>& made = project().made;
  std::optional<double> deviation = made->deviation;
  if (!deviation && impl_->measured && impl_->measured->made == made) deviation = impl_->measured->deviation;
  return deviation ? std::optional(*deviation * guess_unit(*project().source).in_mm) : std::nullopt;
}

}  // namespace netwright
