// Saving, autosaving and recovering, through the session that the window drives.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <limits>
#include <thread>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/project/keeper.h"
#include "core/project/session.h"
#include "tests/project_same.h"
#include "tests/project_support.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

namespace fs = std::filesystem;
using testing::TemporaryFolder;

constexpr double kMinute = 61;

/// An editor without a window, with a clock that the test turns.
class Editor {
 public:
  explicit Editor(const fs::path& state = {}) {
    if (!state.empty()) session.keep_changes_in(state);
  }

  template <class Condition>
  bool until(Condition condition) {
    for (int i = 0; i < 300000; ++i) {
      session.poll();
      for (Message& message : session.take_messages()) said.push_back(std::move(message));
      if (condition()) return true;
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    return false;
  }
  [[nodiscard]] bool until_idle() {
    return until([this] {
      return session.state() == RunState::Idle && (!session.project().tree || session.sheets()) &&
             !session.chore();
    });
  }
  void open(const PolygonSoup& soup) {
    session.open_bytes(soup.name + ".obj", shapes::to_obj(soup));
    ASSERT_TRUE(until_idle());
  }
  void open_file(const fs::path& file) {
    session.open(file);
    ASSERT_TRUE(until_idle());
  }
  void unfold() {
    session.unfold();
    ASSERT_TRUE(until([this] {
      session.skip_replay();
      return session.state() == RunState::Idle && session.sheets();
    }));
  }
  void save(const fs::path& file) {
    session.save(file);
    ASSERT_TRUE(until([this] { return !session.is_saving(); }));
  }
  void let_a_minute_pass() {
    ASSERT_TRUE(until_idle());  // with one look at what has changed
    now += kMinute;
  }
  void set_height(double height_mm) { session.set_size({PrintSize::Kind::Height, height_mm}); }
  [[nodiscard]] double height() const { return session.project().size.height_mm; }
  [[nodiscard]] bool was_told(Message::Kind kind, const std::string& words) const {
    return std::any_of(said.begin(), said.end(), [&](const Message& message) {
      return message.kind == kind && message.text.find(words) != std::string::npos;
    });
  }

  double now = 0;
  Session session{[this] { return now; }};
  std::vector<Message> said;
};

/// The autosaved projects in a folder.
std::vector<fs::path> kept(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (has_project_name(entry.path())) found.push_back(entry.path());
  return found;
}

TEST(Session, SavesAProjectAndOpensItAsItWas) {
  const TemporaryFolder folder;
  Editor editor;
  editor.open(shapes::icosphere(2));
  EXPECT_FALSE(editor.session.is_modified()) << "a model that was only opened is no work to lose";
  EXPECT_TRUE(editor.session.file().empty());
  editor.unfold();
  editor.session.pin_root(FaceId(7));
  editor.set_height(123);
  EXPECT_TRUE(editor.session.is_modified());
  editor.save(folder / "ball.netwright");
  EXPECT_TRUE(editor.was_told(Message::Kind::Good, "Saved ball.netwright"));
  EXPECT_FALSE(editor.session.is_modified());
  EXPECT_EQ(editor.session.file(), folder / "ball.netwright");

  Editor again;
  again.open_file(folder / "ball.netwright");
  testing::expect_same(editor.session.project(), again.session.project());
  EXPECT_FALSE(again.session.is_modified());
  EXPECT_EQ(again.session.file(), folder / "ball.netwright");
  ASSERT_TRUE(again.session.shown());
  EXPECT_TRUE(again.session.shown()->is_proved);
  EXPECT_NE(again.session.sheets(), nullptr);
  again.session.simplify_to(40, false);
  ASSERT_TRUE(again.until([&] { return again.session.project().recipe.faces == 40; }))
      << "the recipe goes on working after opening";
}

TEST(Session, UndoingBackToWhatWasSavedLeavesNothingToSave) {
  const TemporaryFolder folder;
  Editor editor;
  editor.open(shapes::cube());
  editor.set_height(50);
  editor.save(folder / "cube.netwright");
  editor.set_height(60);
  EXPECT_TRUE(editor.session.is_modified());
  editor.session.undo();
  EXPECT_FALSE(editor.session.is_modified());
  editor.session.undo();
  EXPECT_TRUE(editor.session.is_modified());
}

TEST(Session, AModelTakesThePlaceOfAProjectAndHasNoFile) {
  const TemporaryFolder folder;
  Editor editor;
  editor.open(shapes::cube());
  editor.set_height(50);
  editor.save(folder / "cube.netwright");
  editor.open(shapes::octahedron());
  EXPECT_TRUE(editor.session.file().empty());
  EXPECT_FALSE(editor.session.is_modified());
}

TEST(Session, ADamagedProjectIsRefusedAndThePresentOneStays) {
  const TemporaryFolder folder;
  Editor editor;
  editor.open(shapes::cube());
  editor.set_height(50);
  write_file(folder / "bad.netwright", project_bytes(testing::project_of(shapes::cube())).substr(0, 900));
  editor.session.open(folder / "bad.netwright");
  ASSERT_TRUE(editor.until([&] { return editor.session.state() == RunState::Idle; }));
  EXPECT_TRUE(editor.was_told(Message::Kind::Error, "bad.netwright is damaged"));
  EXPECT_TRUE(editor.session.is_modified());
  EXPECT_EQ(editor.height(), 50);
}

TEST(Session, ASaveThatFailsKeepsTheProjectOpenAndUnsaved) {
  const TemporaryFolder folder;
  Editor editor;
  editor.open(shapes::cube());
  editor.set_height(50);
  editor.save(folder / "stick" / "cube.netwright");  // was pulled out
  EXPECT_TRUE(editor.was_told(Message::Kind::Error, "plug in the disk it is on. Nothing is lost"));
  EXPECT_TRUE(editor.session.is_modified());
  EXPECT_TRUE(editor.session.file().empty());
  editor.save(folder / "cube.netwright");
  EXPECT_FALSE(editor.session.is_modified());
}

TEST(Session, ChangesMadeWhileSavingAreNotTakenForSaved) {
  const TemporaryFolder folder;
  Editor editor;
  editor.open(shapes::icosphere(3));
  editor.set_height(50);
  editor.session.save(folder / "ball.netwright");
  editor.set_height(60);
  ASSERT_TRUE(editor.until([&] { return !editor.session.is_saving(); }));
  EXPECT_TRUE(editor.session.is_modified());
  EXPECT_EQ(load_project(folder / "ball.netwright").project.size.height_mm, 50);
}

TEST(Session, SavingTwiceInARowSavesTheLatest) {
  const TemporaryFolder folder;
  Editor editor;
  editor.open(shapes::icosphere(3));
  editor.set_height(50);
  editor.session.save(folder / "ball.netwright");
  editor.set_height(60);
  editor.session.save(folder / "ball.netwright");
  ASSERT_TRUE(editor.until([&] { return !editor.session.is_saving(); }));
  EXPECT_FALSE(editor.session.is_modified());
  EXPECT_EQ(load_project(folder / "ball.netwright").project.size.height_mm, 60);
}

TEST(Autosave, KeepsChangesWithinAMinuteAndOnlyThen) {
  const TemporaryFolder folder;
  Editor editor(folder / "state");
  editor.open(shapes::cube());
  editor.set_height(50);
  ASSERT_TRUE(editor.until([&] { return true; }));
  EXPECT_NEAR(editor.session.wait_seconds(), Keeper::kAutosaveSeconds, 1e-9);
  editor.now += 59;
  ASSERT_TRUE(editor.until_idle());
  EXPECT_TRUE(kept(folder / "state").empty());
  editor.now += 2;
  ASSERT_TRUE(editor.until([&] { return !kept(folder / "state").empty(); }));
  EXPECT_EQ(load_project(kept(folder / "state").front()).project.size.height_mm, 50);
}

TEST(Autosave, WaitsAsLongAsItWasToldAndForEver) {
  const TemporaryFolder folder;
  Editor editor(folder / "state");
  editor.session.set_autosave_minutes(3);
  editor.open(shapes::cube());
  editor.set_height(50);
  editor.let_a_minute_pass();
  EXPECT_NEAR(editor.session.wait_seconds(), 120 - 1, 1e-9);
  editor.session.set_autosave_minutes(0);
  for (int i = 0; i < 5; ++i) editor.let_a_minute_pass();
  EXPECT_TRUE(kept(folder / "state").empty());
  EXPECT_EQ(editor.session.wait_seconds(), std::numeric_limits<double>::infinity());
}

TEST(Autosave, KeepsEveryFinishedRunAtOnce) {
  const TemporaryFolder folder;
  Editor editor(folder / "state");
  editor.open(shapes::cube());
  editor.unfold();
  ASSERT_TRUE(editor.until([&] { return !kept(folder / "state").empty(); }));
  EXPECT_TRUE(load_project(kept(folder / "state").front()).project.tree);
}

TEST(Autosave, GoesWhenTheProjectIsSavedOrGivenUp) {
  const TemporaryFolder folder;
  {
    Editor editor(folder / "state");
    editor.open(shapes::cube());
    editor.set_height(50);
    editor.let_a_minute_pass();
    ASSERT_TRUE(editor.until([&] { return kept(folder / "state").size() == 1; }));
    editor.save(folder / "cube.netwright");
    ASSERT_TRUE(editor.until([&] { return kept(folder / "state").empty(); }));
    editor.set_height(60);
    editor.let_a_minute_pass();
    ASSERT_TRUE(editor.until([&] { return kept(folder / "state").size() == 1; }));
    editor.session.give_up_changes();
  }
  EXPECT_TRUE(fs::is_empty(folder / "state"));
}

TEST(Autosave, IsThereToRecoverAfterTheEditorDied) {
  const TemporaryFolder folder;
  const fs::path state = folder / "state";
  {
    Editor editor(state);
    editor.open(shapes::cube());
    editor.set_height(50);
    editor.save(folder / "cube.netwright");
    editor.set_height(60);
    editor.let_a_minute_pass();
    ASSERT_TRUE(editor.until([&] { return kept(state).size() == 1; }));
    Editor other(state);
    ASSERT_TRUE(other.until([&] { return other.session.chore() == nullptr; }));
    EXPECT_TRUE(find_leftovers(state).empty()) << "as long as it lives nobody may take it";
  }
  Editor editor(state);
  ASSERT_TRUE(editor.until([&] { return !editor.session.leftovers().empty(); }));
  const Leftover leftover = editor.session.leftovers().front();
  EXPECT_EQ(leftover.outline.name, "cube.obj");
  EXPECT_EQ(leftover.outline.belongs_to, folder / "cube.netwright");
  EXPECT_FALSE(leftover.thumbnail.is_empty());
  editor.session.recover(leftover.file);
  ASSERT_TRUE(editor.until([&] { return editor.session.has_model(); }));
  EXPECT_EQ(editor.height(), 60);
  EXPECT_TRUE(editor.session.is_modified());
  EXPECT_EQ(editor.session.file(), folder / "cube.netwright");
  EXPECT_TRUE(editor.session.leftovers().empty());
  EXPECT_EQ(kept(state).size(), 1U) << "it stays until the work is saved";
  editor.save(editor.session.file());
  ASSERT_TRUE(editor.until([&] { return kept(state).empty(); }));
  EXPECT_EQ(load_project(folder / "cube.netwright").project.size.height_mm, 60);
}

TEST(Autosave, OfTwoEditorsEachHasItsOwn) {
  const TemporaryFolder folder;
  const fs::path state = folder / "state";
  {
    Editor a(state);
    Editor b(state);
    for (Editor* editor : {&a, &b}) {
      editor->open(shapes::cube());
      editor->set_height(editor == &a ? 50 : 60);
      editor->let_a_minute_pass();
    }
    ASSERT_TRUE(a.until([&] { return kept(state).size() == 1; }));
    ASSERT_TRUE(b.until([&] { return kept(state).size() == 2; }));
  }
  Editor c(state);
  Editor d(state);
  for (Editor* editor : {&c, &d})
    ASSERT_TRUE(editor->until([&] { return editor->session.leftovers().size() == 2; }));
  const fs::path first = c.session.leftovers()[0].file;
  const fs::path second = c.session.leftovers()[1].file;
  c.session.recover(first);
  d.session.recover(first);
  ASSERT_TRUE(d.until([&] { return d.was_told(Message::Kind::Notice, "Another window"); }));
  EXPECT_FALSE(d.session.has_model());
  d.session.discard(second);
  ASSERT_TRUE(c.until([&] { return c.session.has_model(); }));
  EXPECT_EQ(kept(state), std::vector<fs::path>{first});
}

TEST(Autosave, AllWhoLookAtTheSameTimeSeeALeftover) {
  const TemporaryFolder folder;
  save_project(testing::project_of(shapes::cube()), folder / "1.netwright");
  write_file(folder / "1.lock", "");
  std::atomic<int> n_seen = 0;
  constexpr int kLooks = 200;
  const auto look = [&] {
    for (int i = 0; i < kLooks; ++i) n_seen += static_cast<int>(find_leftovers(folder / "").size());
  };
  std::thread other(look);
  look();
  other.join();
  EXPECT_EQ(n_seen, 2 * kLooks);
  const std::optional<AutosaveSlot> slot = AutosaveSlot::take(folder / "1.netwright");
  ASSERT_TRUE(slot);
  EXPECT_TRUE(find_leftovers(folder / "").empty()) << "somebody has it now";
}

TEST(Autosave, ALeftoverKnowsWhetherItsFileWasSavedLater) {
  const TemporaryFolder folder;
  const fs::path own = folder / "work.netwright";
  const Project project = testing::project_of(shapes::cube());
  save_project(project, own);
  save_project(project, folder / "1.netwright", own);
  const auto is_outdated_when_saved_after = [&](std::chrono::seconds later) {
    fs::last_write_time(own, fs::last_write_time(folder / "1.netwright") + later);
    const std::vector<Leftover> all = find_leftovers(folder / "");
    const auto one = std::find_if(all.begin(), all.end(),
                                  [](const Leftover& it) { return it.file.filename() == "1.netwright"; });
    return one != all.end() && one->is_outdated;
  };
  EXPECT_FALSE(is_outdated_when_saved_after(std::chrono::seconds(-60)));
  EXPECT_TRUE(is_outdated_when_saved_after(std::chrono::seconds(60)));
}

TEST(Autosave, ALeftoverThatCannotBeReadIsLeftAlone) {
  const TemporaryFolder folder;
  const fs::path state = folder / "state";
  fs::create_directories(state);
  write_file(state / "1.netwright", "not a project");
  EXPECT_TRUE(find_leftovers(state).empty());
  Editor editor(state);
  editor.open(shapes::cube());
  editor.set_height(50);
  editor.let_a_minute_pass();
  ASSERT_TRUE(editor.until([&] { return fs::exists(state / "2.netwright"); }));
  EXPECT_EQ(read_file(state / "1.netwright", 100), "not a project");
}

TEST(Autosave, SaysOnceThatItCannotKeepChanges) {
  const TemporaryFolder folder;
  write_file(folder / "state", "a file where the folder should be");
  Editor editor(folder / "state");
  editor.open(shapes::cube());
  for (int i = 0; i < 3; ++i) {
    editor.set_height(50 + i);
    editor.let_a_minute_pass();
    ASSERT_TRUE(editor.until_idle());
  }
  const auto n = std::count_if(editor.said.begin(), editor.said.end(), [](const Message& message) {
    return message.text.find("Changes cannot be kept") != std::string::npos;
  });
  EXPECT_EQ(n, 1);
}

/// For as long as it lives, no file of this process may grow beyond so many bytes.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    before_ = signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &old_);
    signal(SIGXFSZ, before_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit old_{};
  sighandler_t before_ = SIG_DFL;
};

TEST(Crashes, FiftyWritesThatFailHalfwayLoseNothing) {
  const TemporaryFolder folder;
  const fs::path state = folder / "state";
  Editor editor(state);
  editor.open(shapes::icosphere(2));
  editor.set_height(1);
  editor.save(folder / "ball.netwright");
  editor.set_height(2);
  editor.let_a_minute_pass();
  ASSERT_TRUE(editor.until([&] { return kept(state).size() == 1; }));
  const auto size = fs::file_size(folder / "ball.netwright");
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    editor.set_height(10 + i);
    editor.said.clear();
    {
      const FileSizeLimit limit(static_cast<rlim_t>(random.below(static_cast<int>(size))));
      if (i % 2 == 0) {
        editor.save(folder / "ball.netwright");
        ASSERT_TRUE(editor.was_told(Message::Kind::Error, "cannot be written")) << i;
      } else {
        editor.let_a_minute_pass();
        ASSERT_TRUE(editor.until([&] { return editor.session.wait_seconds() > 1; }));
      }
    }
    ASSERT_TRUE(editor.session.is_modified());
    ASSERT_EQ(load_project(folder / "ball.netwright").project.size.height_mm, 1);
    ASSERT_EQ(load_project(kept(state).front()).project.size.height_mm, 2);
    ASSERT_EQ(folder.files().size(), 2U) << "nothing half written is left";
  }
  editor.save(folder / "ball.netwright");
  EXPECT_EQ(load_project(folder / "ball.netwright").project.size.height_mm, 59);
}

}  // namespace
}  // namespace netwright
