// Saving and autosaving. Both write on the chores lane, one after the other, so they never meet in a file.
#include "core/project/keeper.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/project/open_model.h"

namespace netwright {

Keeper::~Keeper() {
  if (!is_given_up_) return;
  if (keeping_) keeping_->slot->give_up();
  if (slot_) slot_->give_up();
}

std::shared_ptr<Keeper::Job> Keeper::write(const Project& project, const std::filesystem::path& file,
                                           const std::filesystem::path& belongs_to) {
  auto job = std::make_shared<Job>(bell_, project, file, n_adopted_);
  worker_.submit(Worker::Lane::Chores,
                 [job, belongs_to, pictures = pictures_,
                  runs = runs_of_ ? runs_of_(project) : std::vector<KeptRun>()](Progress& progress) {
                   const std::string name = job->file.filename().string();
                   progress.set_phase("Saving " + name);
                   auto written = std::make_shared<Written>();
                   try {
                     save_project(job->project, job->file, belongs_to, pictures.get(), runs);
                   } catch (...) {
                     written->fault = sentence_for_current_exception("Saving " + name);
                   }
                   job->result.post(std::move(written));
                 });
  return job;
}

void Keeper::adopt(const Project& saved, std::filesystem::path file) {
  ++n_adopted_;
  saved_ = saved;
  file_ = std::move(file);
  next_save_.reset();
  due_.reset();
  is_urgent_ = false;
}

void Keeper::adopt_saved(const Project& project, std::filesystem::path file) {
  adopt(project, std::move(file));
  if (slot_) slot_->clear();
  kept_.reset();
}

void Keeper::adopt_unsaved(const Project& project, std::filesystem::path file, AutosaveSlot slot) {
  adopt({}, std::move(file));
  if (slot_ && !keeping_) slot_->give_up();  // else when that chore is done
  slot_ = std::make_shared<AutosaveSlot>(std::move(slot));
  kept_ = project;
}

bool Keeper::is_modified(const Project& project) const { return project.dual && project != saved_; }

void Keeper::save(const Project& project, const std::filesystem::path& file) {
  if (!project.dual) return;
  if (saving_) {
    next_save_ = file;
  } else {
    saving_ = write(project, file, {});
  }
}

void Keeper::give_up() {
  is_given_up_ = true;
  folder_.clear();
  if (slot_) slot_->clear();
}

void Keeper::take_save(const Project& project, std::vector<News>& news) {
  const std::shared_ptr<const Written> written = saving_ ? saving_->result.take() : nullptr;
  if (!written) return;
  const std::shared_ptr<Job> done = std::exchange(saving_, nullptr);
  if (written->fault.empty()) {
    news.push_back({true, false, "Saved " + done->file.filename().string()});
    if (done->owner == n_adopted_) {
      saved_ = done->project;
      file_ = done->file;
    }
  } else {
    news.push_back({false, true, written->fault + " Nothing is lost: the project is still open."});
  }
  if (next_save_) save(project, *std::exchange(next_save_, std::nullopt));
}

void Keeper::take_autosave(double now, std::vector<News>& news) {
  const std::shared_ptr<const Written> written = keeping_ ? keeping_->result.take() : nullptr;
  if (!written) return;
  const std::shared_ptr<Job> done = std::exchange(keeping_, nullptr);
  if (!written->fault.empty()) {
    due_ = now + autosave_s_;
    if (!std::exchange(has_complained_, true))
      news.push_back(
          {false, false, "Changes cannot be kept while you work, so save often: " + written->fault});
    return;
  }
  has_complained_ = false;
  if (done->owner == n_adopted_) {
    kept_ = done->project;
  } else if (done->slot != slot_) {
    done->slot->give_up();
  } else if (!kept_) {
    slot_->clear();  // it was of a project that is gone
  }
}

void Keeper::begin_autosave(const Project& project, std::vector<News>& news) {
  due_.reset();
  is_urgent_ = false;
  try {
    if (!slot_) slot_ = std::make_shared<AutosaveSlot>(AutosaveSlot::make(folder_));
  } catch (const Error& error) {
    if (!std::exchange(has_complained_, true)) news.push_back({false, false, error.what()});
    kept_ = project;  // no use in trying again before the next change
    return;
  }
  keeping_ = write(project, slot_->file(), file_);
  keeping_->slot = slot_;
}

std::vector<Keeper::News> Keeper::poll(const Project& project, double now) {
  std::vector<News> news;
  take_save(project, news);
  take_autosave(now, news);
  if (folder_.empty() || keeping_ || saving_) return news;
  if (!is_modified(project) || autosave_s_ <= 0) {
    if (slot_ && kept_) slot_->clear();
    kept_.reset();
    due_.reset();
    is_urgent_ = false;
    return news;
  }
  if (kept_ && *kept_ == project) {
    due_.reset();
    return news;
  }
  if (!due_) due_ = now + autosave_s_;
  if (is_urgent_ || now >= *due_) begin_autosave(project, news);
  return news;
}

double Keeper::wait_seconds(double now) const {
  return due_ && !keeping_ ? std::max(*due_ - now, 0.0) : std::numeric_limits<double>::infinity();
}

}  // namespace netwright
