// The session's way from one version of the model to the next: the chore works for the project as it was when
// it began, and begins again when that has changed meanwhile.
#include <algorithm>

#include "core/project/commands.h"
#include "core/project/session_impl.h"

namespace netwright {

namespace {

using Kind = Message::Kind;

}  // namespace

void Session::Impl::begin_replacing(const std::filesystem::path& path,
                                    std::shared_ptr<const PolygonSoup> source,
                                    const std::optional<Recipe>& repairs) {
  cancel_replacing();
  Project old = project();
  if (is_unfinished && settled) old.tree = std::make_shared<const UnfoldTree>(settled->net.tree);
  replacing = std::make_shared<Chore<Replaced>>(bell);
  replacing->progress =
      worker.submit(Worker::Lane::Chores, [chore = replacing, before = project(), old = std::move(old), path,
                                           source = std::move(source), repairs](Progress& progress) {
        auto replaced = std::make_shared<Replaced>();
        replaced->before = before;
        replaced->path = path;
        replaced->repairs = repairs;
        try {
          progress.set_phase("Reading " + path.filename().string());
          replaced->source = source ? source : std::make_shared<const PolygonSoup>(read_soup(path));
          replaced->work_out(old, progress);
        } catch (...) {
          replaced->fault = sentence_for_current_exception("Replacing the model");
        }
        if (!progress.is_cancelled()) chore->result.post(std::move(replaced));
      });
}

void Session::Impl::Replaced::work_out(const Project& old, Progress& progress) {
  replacement = netwright::replace_model(old, path, source, repairs, progress);
  if (replacement.refusal.empty() || progress.is_cancelled()) return;
  auto with_repairs = std::make_shared<MadeModel>(make_model(source, usual_repair(), nullptr, progress));
  if (!with_repairs->dual) {
    fault = with_repairs->refusal;
    return;
  }
  add_survey(*with_repairs, progress);
  repaired = std::move(with_repairs);
}

void Session::Impl::cancel_replacing() {
  if (replacing) replacing->progress->cancel();
  replacing = nullptr;
}

bool Session::Impl::take_replaced() {
  const std::shared_ptr<const Replaced> done = replacing ? replacing->result.take() : nullptr;
  if (!done) return false;
  replacing = nullptr;
  if (!done->fault.empty()) {
    say(Kind::Error, done->fault);
  } else if (done->repaired) {
    OpenedModel model;
    model.path = done->path;
    model.source = done->source;
    model.made = *done->replacement.project.made;
    model.repaired = done->repaired;
    ask_about({{}, std::move(model), usual_repair(), true});
  } else if (done->before != project()) {
    begin_replacing(done->path, done->source, done->repairs);
  } else {
    put_in_place(done->replacement);
  }
  return true;
}

void Session::Impl::put_in_place(const Replacement& replacement) {
  const bool was_running = run != nullptr;
  cancel_making();
  come_to_rest();
  asked_size.reset();
  history.push("replace model", replacement.project);
  runs.keep([this](const std::shared_ptr<const DualGraph>& dual) { return history.holds(dual); });
  std::erase_if(replace_news, [this](const ReplaceNews& news) { return !history.holds(news.dual); });
  replace_news.push_back({project().dual, std::make_shared<const ReplaceReport>(replacement.report)});
  derived = nullptr;
  drop_result();
  derive_again();
  say(Kind::Notice, replacement.report.summary);
  if (!replacement.start && !was_running) return;
  start_run(SearchRun::Start::Running, replacement.start, replacement.start != nullptr);
  if (run) step_of_run = history.position();
}

void Session::replace_model(const std::filesystem::path& path) {
  if (has_model()) impl_->begin_replacing(path, nullptr, std::nullopt);
}

bool Session::is_replacing() const { return impl_->replacing != nullptr; }

std::shared_ptr<const ReplaceReport> Session::replacement() const {
  const auto news = std::ranges::find(impl_->replace_news, project().dual, &Impl::ReplaceNews::dual);
  return has_model() && news != impl_->replace_news.end() ? news->report : nullptr;
}

}  // namespace netwright
