// Preferences, hints for newcomers, the keyboard's way through all controls, and the desktop's file dialog.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <set>

#include "tests/gui_support.h"
#include "tests/support.h"
#include "ui/desktop_picker.h"
#include "ui/key_focus.h"

namespace netwright::testing {
namespace {

/// Tab, with as few frames as it takes.
void tab(Gui& gui) {
  gui.window.press_key(keys::kTab);
  gui.frames(1);
}

/// An environment variable with another value for as long as this lives.
class Environment {
 public:
  Environment(std::string name, const std::string& value) : name_(std::move(name)) {
    const char* before = std::getenv(name_.c_str());
    if (before != nullptr) before_ = before;
    setenv(name_.c_str(), value.c_str(), 1);
  }
  ~Environment() {
    if (before_) {
      setenv(name_.c_str(), before_->c_str(), 1);
    } else {
      unsetenv(name_.c_str());
    }
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  std::string name_;
  std::optional<std::string> before_;
};

/// A folder with a program of this name that does what the lines of shell say.
void write_program(const TemporaryFolder& folder, const std::string& name, const std::string& lines) {
  const auto program = folder.write(name, "#!/bin/sh\n" + lines + "\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
}

TEST(PreferencesDialog, ChangesTakeEffectAtOnce) {
  Gui gui({1024, 700});
  gui.key(',', kControl);
  ASSERT_TRUE(gui.widgets.find("preferences/theme/Dark").has_value());
  gui.click("preferences/theme/Dark");
  EXPECT_TRUE(gui.ui().look.colours.is_dark);
  gui.click("preferences/unit/Inches");
  EXPECT_EQ(gui.ui().settings.unit, LengthUnit::Inch);
  gui.enter("preferences/threads", "1");
  EXPECT_EQ(gui.ui().settings.threads, 1);
  gui.click("preferences/autosave");
  EXPECT_EQ(gui.ui().settings.autosave_minutes, 0);
  gui.click("preferences/autosave");
  gui.enter("preferences/autosave-minutes", "500");
  EXPECT_EQ(gui.ui().settings.autosave_minutes, 60);
  gui.click("preferences/paper");
  gui.click("preferences/paper/Letter");
  EXPECT_EQ(gui.session().project().paper.format, "Letter") << "nothing is open yet";
  gui.click("dialog/accept");
  EXPECT_FALSE(gui.widgets.find("preferences/theme/Dark").has_value());
  gui.open_sample("Cube");
  EXPECT_EQ(gui.session().project().paper.format, "Letter");
}

TEST(PreferencesDialog, ScalesTheInterfaceWithItselfOpen) {
  Gui gui({1440, 900});
  gui.key(',', kControl);
  gui.click("preferences/scale/200 %");
  gui.frames(3);
  EXPECT_EQ(gui.ui().look.scale, 2);
  for (const char* name : {"preferences/scale/200 %", "preferences/dialogs/The desktop's", "dialog/accept"}) {
    const WidgetRect rect = gui.rect(name);
    EXPECT_GE(rect.min.x, 0) << name;
    EXPECT_LE(rect.max.x, 1440) << name;
    EXPECT_LE(rect.max.y, 900) << name;
  }
}

TEST(Lengths, AreTypedInTheUnitThatIsChosen) {
  Gui gui({1024, 700});
  gui.open_sample("Cube");
  gui.ui().settings.unit = LengthUnit::Inch;
  gui.ui().settings.is_open(Section::Solve) = false;
  gui.frames(3);
  gui.enter("paper/margin", "0.5");
  EXPECT_NEAR(gui.session().project().paper.margin_mm, 12.7, 1e-9);
  gui.ui().settings.unit = LengthUnit::Millimetre;
  gui.frames(2);
  gui.enter("paper/margin", "8");
  EXPECT_NEAR(gui.session().project().paper.margin_mm, 8, 1e-9);
}

TEST(Settings, ComeBackWithTheNextStart) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "settings.conf";
  HeadlessWindow window({"Netwright", {900, 600}, {}});
  {
    Application app(
        window, [] { return 0.0; }, file);
    app.draw();
    app.ui().settings.splitter = 0.3F;
    app.ui().settings.paper = "A3";
    app.ui().settings.streams = 5;
    app.ui().settings.is_open(Section::Model) = true;
  }
  Application app(
      window, [] { return 0.0; }, file);
  EXPECT_FLOAT_EQ(app.ui().settings.splitter, 0.3F);
  EXPECT_TRUE(app.ui().settings.is_open(Section::Model));
  EXPECT_EQ(app.session().project().paper.format, "A3");
  EXPECT_EQ(app.session().streams(), 5);
  EXPECT_EQ(placement_of(app.ui().settings).size, glm::ivec2(900, 600));
}

TEST(Settings, AreWrittenWhileTheEditorRuns) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "settings.conf";
  HeadlessWindow window({"Netwright", {900, 600}, {}});
  double now = 100;
  Application app(
      window, [&now] { return now; }, file);
  app.ui().settings.threads = 3;
  app.turn(0);
  now += 10;
  app.turn(0);
  EXPECT_EQ(load_settings(file).threads, 3);
}

TEST(Settings, AMaximizedWindowKeepsTheSizeItHadBefore) {
  Settings settings;
  remember_placement(settings, {{40, 50}, {1200, 800}, false});
  remember_placement(settings, {{0, 0}, {2560, 1440}, true});
  const WindowPlacement placement = placement_of(settings);
  EXPECT_TRUE(placement.is_maximized);
  EXPECT_EQ(placement.size, glm::ivec2(1200, 800));
  EXPECT_EQ(placement.position, glm::ivec2(40, 50));
}

TEST(FirstHints, GoAwayForGoodWhenClosedOrFollowed) {
  Gui gui({1024, 700});
  gui.ui().settings.hints_done = {};
  gui.frames(2);
  EXPECT_FALSE(gui.widgets.find("hint/close").has_value())
      << "without a model the window says itself what to do";
  gui.open_sample("Cube");
  EXPECT_TRUE(gui.widgets.find("hint/close").has_value());
  gui.click("hint/close");
  EXPECT_FALSE(gui.widgets.find("hint/close").has_value());
  EXPECT_TRUE(gui.ui().settings.is_done(FirstHint::Views));
  gui.ui().settings.hints_done = {};
  ASSERT_TRUE(gui.unfold());
  EXPECT_TRUE(gui.ui().settings.is_done(FirstHint::Views)) << "the model was unfolded, as the hint says";
  EXPECT_FALSE(gui.widgets.find("hint/close").has_value());
  gui.session().set_seed(1);
  ASSERT_TRUE(gui.unfold());
  ASSERT_EQ(gui.session().runs().size(), 2U);
  EXPECT_TRUE(gui.widgets.find("hint/close").has_value()) << "now there are runs to compare";
  gui.session().view_run(1);
  gui.frames(2);
  EXPECT_TRUE(gui.ui().settings.is_done(FirstHint::Runs));
  EXPECT_FALSE(gui.widgets.find("hint/close").has_value());
}

TEST(Keyboard, TabReachesEveryControlOfThePanels) {
  Gui gui({700, 1400});
  gui.open_sample("Bunny");
  ASSERT_TRUE(gui.unfold());
  for (bool& is_open : gui.ui().settings.open_sections) is_open = true;
  gui.frames(3);
  std::set<std::string> reached;
  for (int i = 0; i < 200; ++i) {
    tab(gui);
    reached.insert(gui.ui().focus->name());
  }
  for (const auto& [name, rect] : gui.widgets.all()) {
    const bool is_control = name.starts_with("section/") || name.starts_with("toolbar/") ||
                            name.starts_with("solve/") || name.starts_with("runs/") ||
                            name.starts_with("paper/") || name.starts_with("history/");
    EXPECT_TRUE(!is_control || !rect.is_enabled || reached.contains(name)) << name;
  }
}

TEST(Keyboard, PressesTheLinesOfTheReport) {
  Gui gui({1024, 700});
  PolygonSoup box = shapes::cube();
  box.face_begin.pop_back();
  box.corners.resize(static_cast<std::size_t>(box.face_begin.back()));
  gui.session().open_bytes("box.obj", shapes::to_obj(box));
  ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); }));
  gui.ui().settings.is_open(Section::Model) = true;
  gui.frames(3);
  for (int i = 0; i < 80 && !gui.ui().focus->name().starts_with("report/borders"); ++i) tab(gui);
  gui.key(keys::kSpace);
  EXPECT_EQ(gui.ui().lit.edges.size(), 4U);
  EXPECT_EQ(gui.session().state(), RunState::Idle);
}

TEST(Keyboard, SpacePressesWhatHasTheFocusAndEscapeLetsGo) {
  Gui gui({1024, 700});
  gui.open_sample("Cube");
  const auto tab_to = [&](const std::string& name) {
    for (int i = 0; i < 80 && gui.ui().focus->name() != name; ++i) tab(gui);
    EXPECT_EQ(gui.ui().focus->name(), name);
  };
  const bool was_open = gui.ui().settings.is_open(Section::Model);
  tab_to("section/Model");
  gui.key(keys::kSpace);
  EXPECT_NE(gui.ui().settings.is_open(Section::Model), was_open);
  EXPECT_EQ(gui.session().state(), RunState::Idle) << "Space did not start the search";
  tab_to("toolbar/speed");
  const double before = gui.session().speed();
  gui.key(keys::kLeft);
  gui.key(keys::kLeft);
  EXPECT_LT(gui.session().speed(), before);
  tab_to("solve/seed");
  gui.frames(2);
  gui.window.type_text("42");
  gui.frames(2);
  tab(gui);
  EXPECT_NE(gui.session().project().seed, 0U) << "leaving the field takes over what was typed";
  gui.key(keys::kEscape);
  EXPECT_FALSE(gui.ui().focus->is_shown());
  gui.key(keys::kSpace);
  EXPECT_TRUE(gui.until([&] { return !gui.session().runs().empty(); })) << "Space is the search's again";
}

TEST(Keyboard, StaysInsideADialog) {
  Gui gui({1024, 700});
  gui.key(',', kControl);
  std::set<std::string> reached;
  for (int i = 0; i < 40; ++i) {
    tab(gui);
    reached.insert(gui.ui().focus->name());
  }
  EXPECT_TRUE(reached.contains("preferences/threads"));
  EXPECT_TRUE(reached.contains("preferences/paper"));
  EXPECT_TRUE(reached.contains("dialog/accept"));
  EXPECT_FALSE(reached.contains("toolbar/Open…"));
  while (gui.ui().focus->name() != "preferences/theme/Dark") tab(gui);
  gui.key(keys::kEnter);
  EXPECT_TRUE(gui.ui().look.colours.is_dark);
  EXPECT_TRUE(gui.widgets.find("dialog/accept").has_value())
      << "Enter pressed the button, not the dialog's own";
}

TEST(Keyboard, F10OpensTheMenusForTheArrows) {
  Gui gui({1024, 700});
  gui.key(keys::kF1 + 9);
  gui.frames(3);
  ASSERT_TRUE(gui.widgets.find("menu/Open…").has_value());
  gui.key(keys::kEscape);
  gui.frames(3);
  EXPECT_FALSE(gui.widgets.find("menu/Open…").has_value());
}

TEST(PreferencesDialog, OffersTheDesktopsFileDialogOnlyWhereThereIsOne) {
  const TemporaryFolder folder;
  {
    const Environment path("PATH", folder.path().string());
    Gui gui({1024, 700});
    gui.key(',', kControl);
    EXPECT_FALSE(gui.rect("preferences/dialogs/The desktop's").is_enabled);
    gui.click("preferences/dialogs/The desktop's");
    EXPECT_FALSE(gui.ui().settings.uses_desktop_dialogs);
  }
  write_program(folder, "kdialog", "exit 1");
  const Environment path("PATH", folder.path().string());
  Gui gui({1024, 700});
  gui.key(',', kControl);
  gui.click("preferences/dialogs/The desktop's");
  EXPECT_TRUE(gui.ui().settings.uses_desktop_dialogs);
}

TEST(DesktopPicker, StartsBothProgramsWithWhatTheyUnderstand) {
  const PickRequest open{false, "Open a model", "/home/a", {"obj", "stl"}};
  const auto zenity = picker_arguments("/usr/bin/zenity", open);
  EXPECT_EQ(zenity, (std::vector<std::string>{"--file-selection", "--title=Open a model",
                                              "--filename=/home/a/", "--file-filter=*.obj *.stl"}));
  const auto kdialog = picker_arguments("/usr/bin/kdialog", {true, "Export", "/home/a/net.pdf", {"pdf"}});
  EXPECT_EQ(kdialog,
            (std::vector<std::string>{"--title", "Export", "--getsavefilename", "/home/a/net.pdf", "*.pdf"}));
}

TEST(DesktopPicker, OpensWhatTheDesktopsDialogAnswers) {
  const TemporaryFolder folder;
  const auto model = folder.write("my cube.obj", shapes::to_obj(shapes::cube()));
  // Not before the window has gone to sleep: the answer has to wake it.
  write_program(folder, "zenity", "sleep 0.5; echo '" + model.string() + "'");
  const Environment path("PATH", folder.path().string() + ":/usr/bin:/bin");
  Gui gui({1024, 700});
  gui.ui().settings.uses_desktop_dialogs = true;
  gui.key('O', kControl);
  EXPECT_FALSE(gui.widgets.find("dialog/accept").has_value()) << "ours stays away";
  ASSERT_TRUE(gui.until([&] { return gui.session().has_model(); })) << gui.ui().error;
  EXPECT_EQ(gui.session().project().path, model);
}

TEST(DesktopPicker, CancellingThereOpensNothing) {
  const TemporaryFolder folder;
  write_program(folder, "zenity", "exit 1");
  const Environment path("PATH", folder.path().string() + ":/usr/bin:/bin");
  Gui gui({1024, 700});
  gui.ui().settings.uses_desktop_dialogs = true;
  gui.key('O', kControl);
  ASSERT_TRUE(gui.until([&] {
    gui.frames(1);
    return gui.ui().dialog == Dialog::None;
  }));
  EXPECT_FALSE(gui.session().has_model());
}

TEST(DesktopPicker, OursComesUpWhereTheirsFails) {
  const TemporaryFolder folder;
  write_program(folder, "zenity", "exit 7");
  const Environment path("PATH", folder.path().string() + ":/usr/bin:/bin");
  Gui gui({1024, 700});
  gui.ui().settings.uses_desktop_dialogs = true;
  gui.key('O', kControl);
  EXPECT_TRUE(gui.until([&] {
    gui.frames(1);
    return gui.widgets.find("dialog/accept").has_value();
  }));
}

TEST(DesktopPicker, EscapeClosesADialogThatNeverAnswers) {
  const TemporaryFolder folder;
  write_program(folder, "zenity", "exec sleep 1000");
  const Environment path("PATH", folder.path().string() + ":/usr/bin:/bin");
  Gui gui({1024, 700});
  gui.ui().settings.uses_desktop_dialogs = true;
  gui.key('O', kControl);
  EXPECT_EQ(gui.ui().dialog, Dialog::Open);
  gui.key(keys::kEscape);
  EXPECT_EQ(gui.ui().dialog, Dialog::None);
}

}  // namespace
}  // namespace netwright::testing
