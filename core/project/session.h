// An open Project with its history, its derived data, its running search and the worker: the one object that
// the editor's ui and app talk to. Owned by the main thread; nothing here blocks it for more than a few ms.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/mesh/mesh_report.h"
#include "core/mesh/read.h"
#include "core/project/autosave.h"
#include "core/project/print_job.h"
#include "core/project/project.h"
#include "core/project/real_size.h"
#include "core/project/replace_model.h"
#include "core/project/run_figures.h"
#include "core/project/run_list.h"
#include "core/project/shown_net.h"
#include "core/project/soften.h"
#include "core/sheet/buildability.h"
#include "core/sheet/cutter_package.h"
#include "core/sheet/pages.h"
#include "core/sheet/sheet.h"
#include "core/solve/fewest_pieces.h"
#include "core/solve/solve.h"
#include "core/solve/trouble.h"
#include "core/unfold/hand_edits.h"

namespace netwright {

enum class RunState {
  Empty,      ///< no model
  Opening,    ///< a file is being read
  Idle,       ///< a model, nothing running
  Running,    ///< the search is running
  Paused,     ///< it waits: step or resume
  Replaying,  ///< it is over and its recorded moves are played back
};

struct Message {
  enum class Kind { Good, Notice, Error };
  Kind kind = Kind::Notice;
  std::string text;
  std::uint64_t number = 0;
};

class Session {
 public:
  using Clock = std::function<double()>;  ///< seconds, steady; injected so that tests can turn it

  explicit Session(Clock clock);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Takes in what the worker finished and moves a replay on; call once per frame. True when anything
  /// changed.
  bool poll();
  /// Called from worker threads when there is something to poll (the window's loop wakes up).
  void set_wake(std::function<void()> wake);
  /// How long the loop may sleep when nothing wakes it: a replay and a running clock move on by themselves.
  /// Infinity when nothing does.
  [[nodiscard]] double wait_seconds() const;

  // Models. Reading happens on the chores lane; errors arrive as messages, the present model stays.
  /// A model or a project, by its content. What is unsaved goes when the new one is there.
  void open(const std::filesystem::path& path);
  /// Opens a bundled model from memory; `name` tells the format by its extension, `companions` finds the
  /// files it refers to (a material library, a picture) and is called on the worker.
  void open_bytes(const std::string& name, std::string bytes, CompanionLookup companions = {});
  /// Gives up reading a file; the present model stays.
  void cancel_opening();
  [[nodiscard]] bool has_model() const { return project().dual != nullptr; }

  /// A file that was read but cannot be unfolded as it is, until the user has decided about it. Nothing is
  /// repaired without being asked.
  struct Pending {
    std::string name;
    MeshReport report;                      ///< of the file
    std::string refusal;                    ///< why it cannot be unfolded, one sentence
    Recipe recipe;                          ///< which repairs are wanted; usual_repair() at first
    std::shared_ptr<const MadeModel> made;  ///< what comes of them, with a survey; by the recipe before
                                            ///< while is_making()
    [[nodiscard]] bool is_fit() const { return made->dual != nullptr; }
  };
  [[nodiscard]] const Pending* pending() const;  ///< null when there is none
  void try_pending(const Recipe& recipe);        ///< tries other repairs, as a chore
  /// Opens what has come of them, if that is fit. Repairing is the first undo step then; taking it back leads
  /// to the question again, with no model, and redoing it, or agreeing again, to the repaired one.
  void repair_pending();
  void drop_pending();
  /// The file that is open but not repaired, since that was undone: its name and why it cannot be unfolded.
  struct Unrepaired {
    std::string name;
    std::string refusal;
  };
  [[nodiscard]] std::optional<Unrepaired> unrepaired() const;
  void ask_again();  ///< brings the question about it back

  /// A changed version of the model in the present one's place, as one undo step "replace model": pins,
  /// recipe and settings go over to it (see replace_model.h), and where there is a net, the search goes on
  /// from what is left of it; its net is part of the step. Reading and comparing is a chore: chore() tells
  /// how far it is, cancel_opening() gives it up. A version that needs repair is pending() first.
  void replace_model(const std::filesystem::path& path);
  [[nodiscard]] bool is_replacing() const;
  /// What came of the work on the version before the present one; null when the present model replaced none.
  [[nodiscard]] std::shared_ptr<const ReplaceReport> replacement() const;

  // How the mesh is made of the file; each change is one undo step with a name, made as a chore on the
  // worker. A net of the old mesh goes; where there was one, or a search runs, the new mesh is unfolded at
  // once.
  [[nodiscard]] const Recipe& recipe() const { return project().recipe; }
  /// A mesh is being made, for pending() or by a new recipe; chore() tells how far it is, cancel_opening()
  /// gives it up (then the repairs tried before are wanted again).
  [[nodiscard]] bool is_making() const;
  /// Pages and sheets of the present net are being made.
  [[nodiscard]] bool is_laying_out() const;
  /// The recipe as it will be when the chore in hand is done: what switches and sliders should show.
  [[nodiscard]] Recipe wanted_recipe() const;
  void set_recipe(const Recipe& recipe, const std::string& label);  ///< label as in "Undo <label>"
  /// The simplify slider: at most so many faces, 0 = all. While `is_dragging`, every new mesh is unfolded at
  /// once, the latest wish waits until the mesh in hand is shown, and the whole drag is one undo step;
  /// the net found at its end is another one.
  void simplify_to(int faces, bool is_dragging);
  /// Faces before simplifying, 0 without a model.
  [[nodiscard]] int n_faces_before_simplifying() const;
  /// How far simplifying moved the surface at most, in mm of the guessed unit; none while it is being
  /// measured, which happens when the mesh is there and nothing more urgent is to be made.
  [[nodiscard]] std::optional<double> deviation_mm() const;
  [[nodiscard]] const MeshReport* report() const;

  [[nodiscard]] RunState state() const;
  [[nodiscard]] const Project& project() const;
  [[nodiscard]] std::shared_ptr<const ShownNet> shown() const;  ///< null before the first run
  [[nodiscard]] RunFigures figures() const;
  /// Fraction and phase of the chore in hand (reading, exporting), null when there is none.
  [[nodiscard]] std::shared_ptr<const Progress> chore() const;

  // The search.
  void unfold();  ///< start, or resume when paused; contradicting pins are told as an error instead
  // Editing the net by hand: `edit` comes from the functions of unfold/hand_edits.h, made for the shown tree.
  // One undo step each; the result may overlap itself and fall into pieces, and is proved like any net when
  // it does not. A running search is ended first.
  void edit_by_hand(const HandEdit& edit, const std::string& label);
  /// The same net with the edit made, as it would be shown, laid out from the same roots.
  [[nodiscard]] std::shared_ptr<const ShownNet> preview(const HandEdit& edit) const;
  /// Pins and the folds joined by hand may not be cut to make way.
  [[nodiscard]] bool may_cut(EdgeId edge) const;
  /// There are edges joined or cut by hand since the last run.
  [[nodiscard]] bool has_hand_edits() const { return !project().edits.are_free(); }

  /// Starts from the present net (finished, unfinished or cut up by hand) and changes only what overlaps and
  /// pins ask for; edges joined and cut by hand stay
  /// so. Like unfold() when there is no net.
  void unfold_from_here();
  void pause();
  void step();      ///< one move, then paused; starts when nothing runs
  void stop();      ///< the best so far stays shown, not accepted unless proved
  void new_seed();  ///< next seed, runs again
  void set_seed(std::uint64_t seed);
  void skip_replay();
  /// Moves a second for the eyes; infinity = full speed. Takes effect at once.
  void set_speed(double moves_per_second);
  [[nodiscard]] double speed() const;
  /// How many streams search (from the next run on) and how long at most (seconds, pauses left out; 0 = no
  /// limit).
  void set_streams(int streams);
  [[nodiscard]] int streams() const;
  void set_time_limit(double seconds);
  [[nodiscard]] double time_limit() const;
  /// What nets are polished for and how long, from the next run on; at first not at all.
  void set_polish(const PolishSettings& settings);
  [[nodiscard]] const PolishSettings& polish() const;
  /// How many threads run the streams, from the next run on; 0 = all the machine has. Never decides the net.
  void set_threads(int threads);

  // When a search has ended without a net.
  /// Why, as far as the search tells; null unless its best is shown.
  [[nodiscard]] std::shared_ptr<const Trouble> trouble() const;
  /// Tries on the search's lane which pins stand in the way (see find_releases); a search ends it.
  void look_for_releases();
  /// What came of it; null before and when other pins were set since.
  [[nodiscard]] std::shared_ptr<const Releases> releases() const;
  /// It is proved that there is no net in one piece.
  [[nodiscard]] bool is_impossible() const;
  /// Looks on the search's lane for nets of several pieces (see fewest_pieces) that keep all pins; a search
  /// or another trial ends it.
  void look_for_pieces();
  /// What came of it; null before and when other pins were set since.
  [[nodiscard]] std::shared_ptr<const PiecesResult> pieces() const;
  /// How long the cuts of each choice are as paper and size would have it printed, in mm; empty while that is
  /// worked out, and where the paper has no room.
  [[nodiscard]] std::vector<double> pieces_cut_mm() const;
  /// The net of one of the choices becomes the project's; one undo step.
  void take_pieces(std::size_t choice);
  /// How far something is that is tried after a search without a net; null when nothing is.
  [[nodiscard]] std::shared_ptr<const Progress> trial() const;
  void stop_trial();
  /// Looks likewise for the least change of shape that gives a net (see soften), up to a tenth of the model's
  /// diagonal; what came of it, null before.
  void look_for_softening();
  [[nodiscard]] std::shared_ptr<const Softening> softening() const;
  /// Changes the model so and unfolds it; the shape is one undo step.
  void take_softening();
  /// Takes these pins back, also where they are edges joined or cut by hand, and unfolds again; one undo
  /// step.
  void release(const std::vector<Pin>& pins);

  // Finished runs of the present mesh. Looking at one changes nothing; taking its net is one undo step.
  [[nodiscard]] std::vector<RunList::Entry> runs() const;  ///< oldest first
  [[nodiscard]] int best_run() const;                      ///< its number; 0 without runs
  [[nodiscard]] int accepted_run() const;                  ///< whose net is the project's; 0 for none
  [[nodiscard]] int viewed_run() const;                    ///< 0 while the project's own net is shown
  void view_run(int number);                               ///< 0 goes back to the project's own net
  /// One sentence, empty when the run's net may become the project's: it is proved and keeps all pins.
  [[nodiscard]] std::string why_not_accept(int number) const;
  void accept_run(int number);
  void delete_run(int number);
  /// Writes a proved run's net as export_to() does the project's; also while a search goes on.
  void export_run(int number, const std::filesystem::path& path);

  /// The recorded moves of the run that is looked at.
  struct Timeline {
    int position = 0;  ///< 0 … n_steps - 1
    int n_steps = 0;
    int home = 0;  ///< where the run's own net is reached
    bool is_playing = false;
    double speed = 0;  ///< moves a second
  };
  [[nodiscard]] std::optional<Timeline> timeline() const;  ///< none without a run or when its moves are gone
  void seek(int position);
  void play();  ///< from the present position, at the end from the beginning
  void hold();
  void set_play_speed(double moves_per_second);

  // Edits: each is one undo step with a name.
  void pin_root(FaceId face);  ///< an invalid face removes the pin
  /// Pins as a whole; `label` as in "Undo <label>". A running search goes on from where it is under the new
  /// pins; an accepted net stays until the next run, even where it does not keep them.
  void set_pins(const Constraints& pins, const std::string& label);
  /// Why the pins cannot all be kept; null when they can, as far as that shows before a search.
  [[nodiscard]] const Contradiction* contradiction() const;
  /// Does the shown net keep all pins? True without a net.
  [[nodiscard]] bool keeps_pins() const;
  void set_paper(const PaperSetup& paper);
  /// The paper of models to come, and of an empty project at once; no undo step.
  void set_desk_paper(const std::string& format);
  void set_size(const PrintSize& size);
  /// `label` names the undo step: "tab width", "line styles" …
  void set_tabs(const TabSettings& tabs, const std::string& label);
  void set_sheet(const SheetSettings& sheet, const std::string& label);
  /// Which seams are glued already; one undo step.
  void set_glued(std::vector<EdgeId> glued, const std::string& label);
  void set_exports(const ExportSettings& exports, const std::string& label);
  /// How large the model is by its file, as long as that can hardly be meant and the user has not said what
  /// is: asked once for each model that is opened. Answered by set_size() or leave_size().
  [[nodiscard]] const std::optional<RealSize>& asked_size() const;
  void leave_size();
  [[nodiscard]] bool can_undo() const;
  [[nodiscard]] bool can_redo() const;
  /// "Undo pin root", ready for a menu; just "Undo" when there is nothing to undo.
  [[nodiscard]] std::string undo_label() const;
  [[nodiscard]] std::string redo_label() const;
  void undo();  ///< a search that runs is stopped first; an unfinished net that is shown goes first, too
  void redo();
  /// The names of all steps that can be undone or redone, oldest first, after an empty one for the beginning.
  [[nodiscard]] std::vector<std::string> history() const;
  /// The file that the history begins with; empty in an empty project.
  [[nodiscard]] std::string first_name() const;
  [[nodiscard]] std::size_t history_position() const;
  void go_to_step(std::size_t position);

  // Where the pieces lie on the pages.
  /// One undo step, `label` as in "Undo <label>"; for the net of shown(), when it is on pages().
  void place_pieces(const HandLayout& placed, const std::string& label);
  /// Back to the layout that is made by itself; one undo step.
  void rearrange_pieces();
  /// Cuts a net that is larger than the paper into the fewest pieces that fit it: edits by hand, one undo
  /// step, made when a chore has worked them out. That nothing is to be cut, or cannot be, is told as a
  /// message.
  void split_to_fit();
  [[nodiscard]] bool has_placed_pieces() const { return !project().placed.is_automatic(); }
  /// What of pages() cannot be printed as it lies; null when nothing is wrong or there are no pages.
  [[nodiscard]] const Misplaced* misplaced() const;

  /// How well the net of pages() can be built; null without pages.
  [[nodiscard]] std::shared_ptr<const Buildability> buildability() const;

  // Printing. Sheets exist only for a proved net on which nothing is misplaced; null otherwise.
  [[nodiscard]] std::shared_ptr<const std::vector<Sheet>> sheets() const;
  /// Cuts whose numbers find no room on them, sorted; null without sheets.
  [[nodiscard]] std::shared_ptr<const std::vector<EdgeId>> unnumbered() const;
  /// The page with instructions that goes with them, where the exports have one; else null.
  [[nodiscard]] std::shared_ptr<const Sheet> instructions() const;
  /// How the net of shown() lies on its pages, be it proved or edited by hand; null while there are none or
  /// another net is shown.
  [[nodiscard]] std::shared_ptr<const PageLayout> pages() const;
  /// Sends sheets, and the instructions that go with them, to a printer, as a chore; success or failure
  /// arrives as a message.
  void print(const PrintJob& job);
  /// Asks the system for its printers, as a chore.
  void look_for_printers();
  /// Null until they are known; empty where the system has none or cannot print.
  [[nodiscard]] const std::vector<std::string>* printers() const;
  /// Writes by the path's extension on the chores lane; success or failure arrives as a message.
  void export_to(const std::filesystem::path& path);
  /// Writes all that a cutting machine needs into a folder, likewise. Pages whose margins are too narrow for
  /// the machine's marks are laid out again with wider ones.
  void export_for_cutter(const std::filesystem::path& folder, CutterPreset preset);

  // The project's file. Saving is a chore; success or failure arrives as a message.
  /// Empty until the project was saved or when it was opened from a model.
  [[nodiscard]] const std::filesystem::path& file() const;
  /// Is there anything that would be lost?
  [[nodiscard]] bool is_modified() const;
  void save(const std::filesystem::path& file);  ///< which is the project's file from then on
  [[nodiscard]] bool is_saving() const;

  // Never losing work: with a folder for it, unsaved changes are kept there within a minute and after every
  // run, until they are saved or given up. What an editor that died has left there can be recovered.
  void keep_changes_in(const std::filesystem::path& folder);
  /// How many minutes changes may wait for that, 1 unless told otherwise; 0 = they are not kept at all.
  void set_autosave_minutes(int minutes);
  /// As found when the folder was named, newest first; without those recovered or discarded since.
  [[nodiscard]] const std::vector<Leftover>& leftovers() const;
  void recover(const std::filesystem::path& leftover);
  void discard(const std::filesystem::path& leftover);
  /// The user quits and has decided about unsaved changes: nothing of them is left to recover.
  void give_up_changes();

  /// Messages since the last call, oldest first.
  std::vector<Message> take_messages();

 private:
  [[nodiscard]] bool may_export();  ///< else it has been said why not

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace netwright
