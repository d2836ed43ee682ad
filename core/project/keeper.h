// Sees to it that no work is lost: knows what of the open project is saved and where, saves it when asked to,
// and keeps unsaved changes in a file of its own. Belongs to the session; all writing is done as chores.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/mailbox.h"
#include "core/base/worker.h"
#include "core/project/autosave.h"
#include "core/project/bell.h"
#include "core/project/project.h"
#include "core/project/project_file.h"

namespace netwright {

class Keeper {
 public:
  /// Changes are kept at most this many seconds after they were made, unless told otherwise.
  static constexpr double kAutosaveSeconds = 60;

  /// What poll() has to tell; `good` is about a save that worked.
  struct News {
    bool is_good = false;
    bool is_failure = false;
    std::string text;
  };

  /// The worker need not be alive yet, and must be when anything but this is called.
  Keeper(Worker& worker, std::shared_ptr<const Bell> bell) : worker_(worker), bell_(std::move(bell)) {}
  ~Keeper();  ///< to be called when the worker is gone
  /// Asked at every writing for the runs that go with the project.
  void set_runs(std::function<std::vector<KeptRun>(const Project&)> runs_of) {
    runs_of_ = std::move(runs_of);
  }
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;

  /// Another project has taken the place of the one before; unsaved changes of that one are given up.
  void adopt_saved(const Project& project, std::filesystem::path file);
  /// The same for a recovered one, which is not saved yet; `slot` holds it.
  void adopt_unsaved(const Project& project, std::filesystem::path file, AutosaveSlot slot);

  [[nodiscard]] bool is_modified(const Project& project) const;
  /// The project's own file; empty while it has none.
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

  /// Saves a copy; afterwards that is the project's file. A wish while a save is under way waits for it.
  void save(const Project& project, const std::filesystem::path& file);
  [[nodiscard]] bool is_saving() const { return saving_ != nullptr || next_save_.has_value(); }

  /// From now on unsaved changes are kept in this folder.
  void set_folder(std::filesystem::path folder) { folder_ = std::move(folder); }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  /// How long changes may wait to be kept; 0 = they never are.
  void set_autosave(double seconds) { autosave_s_ = seconds; }
  /// Keep the changes at once instead of within a minute: something was made that took time.
  void hurry() { is_urgent_ = true; }
  /// The editor is about to be closed and nobody wants what is unsaved: nothing is left to recover.
  void give_up();

  /// Takes in what was written and begins what is due; `now` in seconds.
  std::vector<News> poll(const Project& project, double now);
  /// Seconds until the next autosave is due, infinity when none is.
  [[nodiscard]] double wait_seconds(double now) const;

 private:
  struct Written {
    std::string fault;  ///< empty when it worked
  };
  struct Job {
    Job(const std::shared_ptr<const Bell>& bell, Project what, std::filesystem::path where, int number)
        : project(std::move(what)), file(std::move(where)), owner(number), result([bell] { bell->ring(); }) {}
    const Project project;
    const std::filesystem::path file;
    const int owner;                     ///< n_adopted_ when it began
    std::shared_ptr<AutosaveSlot> slot;  ///< held as long as somebody writes into it; null for a save
    Mailbox<Written> result;
  };

  std::shared_ptr<Job> write(const Project& project, const std::filesystem::path& file,
                             const std::filesystem::path& belongs_to);
  void take_save(const Project& project, std::vector<News>& news);
  void take_autosave(double now, std::vector<News>& news);
  void begin_autosave(const Project& project, std::vector<News>& news);
  void adopt(const Project& saved, std::filesystem::path file);

  Worker& worker_;
  std::shared_ptr<const Bell> bell_;
  std::function<std::vector<KeptRun>(const Project&)> runs_of_;
  std::shared_ptr<PictureCache> pictures_ = std::make_shared<PictureCache>();  ///< used by the chores alone
  int n_adopted_ = 0;
  Project saved_;  ///< as it is in file_, or as it was when its model was opened
  std::filesystem::path file_;
  std::shared_ptr<Job> saving_;
  std::optional<std::filesystem::path> next_save_;

  std::filesystem::path folder_;
  double autosave_s_ = kAutosaveSeconds;
  std::shared_ptr<AutosaveSlot> slot_;
  std::optional<Project> kept_;  ///< as it is in the slot
  std::shared_ptr<Job> keeping_;
  std::optional<double> due_;  ///< when what is not kept yet has to be
  bool is_urgent_ = false;
  bool has_complained_ = false;
  bool is_given_up_ = false;
};

}  // namespace netwright
