// What a Session is made of. Included by the session's own sources only.
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/mailbox.h"
#include "core/base/worker.h"
#include "core/project/bell.h"
#include "core/project/derived.h"
#include "core/project/history.h"
#include "core/project/keeper.h"
#include "core/project/open_model.h"
#include "core/project/replay.h"
#include "core/project/search_run.h"
#include "core/project/session.h"

namespace netwright {

struct Session::Impl {
  /// A chore under way: its result lies in the mailbox when it is done, and nobody looks at it any more when
  /// the chore was replaced by a newer one.
  template <class Result>
  struct Chore {
    explicit Chore(std::shared_ptr<const Bell> bell) : result([bell] { bell->ring(); }) {}
    Mailbox<Result> result;
    std::shared_ptr<Progress> progress;
  };
  struct Opened {
    std::optional<OpenedModel> model;
    std::optional<StoredProject> stored;
    std::vector<FinishedRun> runs;  ///< of the stored project
    std::string fault;
  };
  struct Made {
    std::shared_ptr<const MadeModel> model;
    std::string fault;
  };
  struct Split {
    std::shared_ptr<const UnfoldTree> of;
    HandEdit edit;
    std::shared_ptr<const ShownNet> shown;
    std::string fault;
  };
  struct Measured {
    std::shared_ptr<const MadeModel> made;
    double deviation;
  };
  /// What the mesh is being made anew for.
  struct Making {
    Recipe recipe;
    std::string label;
    bool unfolds = false;         ///< start a search on the new mesh
    bool continues_step = false;  ///< same gesture: no undo step of its own
  };
  /// A file waiting for the user's word.
  struct Waiting {
    Pending shown;
    OpenedModel model;
    Recipe tried;           ///< what shown.made was made by
    bool replaces = false;  ///< it is another version of the present model
  };
  /// Another version of the model, worked out for the project as it was then.
  struct Replaced {
    void work_out(const Project& old, Progress& progress);
    Project before;
    std::filesystem::path path;
    std::shared_ptr<const PolygonSoup> source;
    std::optional<Recipe> repairs;
    Replacement replacement;
    std::shared_ptr<const MadeModel> repaired;  ///< by usual_repair(), where it needs repair
    std::string fault;
  };
  struct ReplaceNews {
    std::shared_ptr<const DualGraph> dual;
    std::shared_ptr<const ReplaceReport> report;
  };
  /// A replay being shown, and since when.
  struct Playing {
    Replay replay;
    double started;
    double last_picture;
  };

  /// A finished run being looked at: its own net, or a moment of its moves.
  struct Viewing {
    Viewing();  // out of line: whether it can be made is asked before this class is complete
    RunList::Entry run;
    std::shared_ptr<Replay> replay;  ///< used by one chore at a time; null when the moves are gone
    int home = 0;                    ///< the position at which the run's own net is reached
    double position = 0;             ///< between two pictures while it plays
    bool is_playing = false;
    double speed = 30;
    double last_tick = 0;
    int asked = -1;  ///< the position that `chore` works on, then that `picture` shows
    std::shared_ptr<const ShownNet> picture;
    std::shared_ptr<Chore<ShownNet>> chore;
    [[nodiscard]] int at() const { return static_cast<int>(position); }
  };

  /// A search that ended without a net, and what was tried since.
  struct Failed {
    std::shared_ptr<const DualGraph> dual;
    Constraints pins;   ///< the project's then,
    Constraints edits;  ///< likewise
    SolveOptions options;
    std::shared_ptr<const Trouble> trouble;
    std::shared_ptr<const Releases> releases;
    std::shared_ptr<const PiecesResult> pieces;
    bool is_impossible = false;  ///< proved
    std::shared_ptr<const Softening> softening = {};
  };

  /// What the choices of a PiecesResult measure when they are printed so.
  struct PrintedPieces {
    std::shared_ptr<const PiecesResult> pieces;
    PaperSetup paper;
    PrintSize size;
    TabSettings tabs;
    std::vector<double> cut_mm = {};
    [[nodiscard]] bool is_of(const std::shared_ptr<const PiecesResult>& found, const Project& project) const {
      return pieces == found && paper == project.paper && size == project.size && tabs == project.tabs;
    }
  };

  explicit Impl(Clock clock_function);
  ~Impl();

  // Taking in what the worker finished (session_poll.cpp); each tells whether anything changed.
  bool poll();
  bool take_opened();
  void take_stored(const StoredProject& stored, const std::vector<FinishedRun>& finished);
  bool take_leftovers();
  bool watch_files();
  bool take_made();
  bool take_measured();
  void take_tried(const Made& made);
  void settle_on(std::shared_ptr<const ShownNet> net);
  bool take_derived();
  bool take_exports();
  bool take_split();
  bool take_printers();
  bool take_run();
  bool show_replay();
  void watch_clock();
  void finish_run(const SearchRun::Outcome& outcome);
  void accept(const SolveResult& result, const RunSummary& summary);
  void show_unfinished(const SolveResult& result, const SolveOptions& options);
  // What is tried after that (session_why.cpp).
  [[nodiscard]] const Failed* failure() const;  ///< null unless its best is shown
  [[nodiscard]] bool has_pins_of(const Failed& failure) const;
  bool take_releases();
  bool take_found_pieces();  // session_pieces.cpp
  bool measure_pieces();
  bool take_found_softening();
  void stop_trial();
  void start_replay(const SearchRun::Outcome& outcome);
  void end_replay();

  // Finished runs (session_runs.cpp).
  void keep_run(const SearchRun::Outcome& outcome, const RunSummary& summary);
  void view_run(int number);
  void leave_view();
  bool take_view();
  bool show_view();
  void ask_for_view();
  [[nodiscard]] RunList::Entry accepted_run() const;  ///< null when the project's net is of none
  [[nodiscard]] RunFigures view_figures() const;

  // Chores.
  void open(ModelSource source);
  void adopt(const OpenedModel& model, const Recipe& recipe, const std::shared_ptr<const MadeModel>& made);
  void replace(Project next);  ///< takes the present project's place, with a history of its own
  void ask_about(Waiting question);
  void repair(Waiting agreed);
  [[nodiscard]] bool is_unrepaired() const { return !project().dual && project().source != nullptr; }
  // Another version of the model (session_replace.cpp).
  void begin_replacing(const std::filesystem::path& path, std::shared_ptr<const PolygonSoup> source,
                       const std::optional<Recipe>& repairs);
  void cancel_replacing();
  bool take_replaced();
  void put_in_place(const Replacement& replacement);
  void tell_about(const OpenedModel& model, const MadeModel& made);
  void make(Making wanted);
  void cancel_making();
  void stop_measuring();
  void measure_when_idle();
  void part_net_from_step();
  bool take_mesh(const std::shared_ptr<const MadeModel>& made);  ///< true when a drag is back where it began
  void derive_again();                                           ///< after every change of the project
  void export_to(const std::filesystem::path& path, const Project& source,
                 std::shared_ptr<const Derived> before);
  void export_for_cutter(const std::filesystem::path& folder, CutterPreset preset);
  /// Has the net derived on the chores lane and says the sentence that `write` returns.
  void export_by(const std::string& name, const Project& source, std::shared_ptr<const Derived> before,
                 std::function<std::string(const Derived&)> write);

  // Changes of the project and of what is shown.
  [[nodiscard]] const Project& project() const { return history.present(); }
  void edit(std::string label, Project next);
  void come_to_rest();  ///< nothing runs, plays or is looked at any more
  void move_in_history(std::size_t position);
  void drop_result();  ///< back to what the project itself says
  void relay_unfinished(FaceId root);
  /// `from` may be null: then the search starts anew. Says why when the pins contradict each other.
  void start_run(SearchRun::Start start, std::shared_ptr<const UnfoldTree> from = nullptr,
                 bool stays_near = false);
  void check_pins();
  void discard_run();
  void say(Message::Kind kind, std::string text);
  std::shared_ptr<ShownNet> stamp(std::shared_ptr<ShownNet> net);
  [[nodiscard]] RunFigures replay_figures() const;
  [[nodiscard]] RunFigures settled_figures() const;

  Clock clock;
  std::shared_ptr<Bell> bell = std::make_shared<Bell>();
  History history;

  std::unique_ptr<SearchRun> run;
  bool is_timed_out = false;
  std::optional<Playing> playing;
  RunList runs;
  std::optional<Viewing> viewing;
  std::string good_news;                    ///< said when the replay is over
  std::shared_ptr<const ShownNet> moving;   ///< the picture of the run or the replay that goes on
  std::shared_ptr<const ShownNet> settled;  ///< what stays when nothing runs
  bool is_unfinished = false;               ///< `settled` is the best of a run that wasn't proved
  std::optional<Failed> failed_run;         ///< that run
  std::shared_ptr<Chore<PrintedPieces>> printing_pieces;
  std::shared_ptr<const PrintedPieces> printed_pieces;
  std::optional<RunFigures> last_figures;  ///< of the run that led to `settled`
  std::shared_ptr<const Derived> derived;
  std::optional<Contradiction> contradiction;  ///< of these pins,
  Constraints checked_pins;                    ///< on this mesh
  std::shared_ptr<const DualGraph> checked_dual;

  std::shared_ptr<Chore<Opened>> opening;
  std::optional<Waiting> waiting;
  std::optional<Waiting> answered;  ///< the question that the history's first step answered
  std::shared_ptr<Chore<Replaced>> replacing;
  std::vector<ReplaceNews> replace_news;
  std::optional<std::size_t> step_of_run;  ///< the step that the running search's net belongs to
  std::optional<RealSize> asked_size;      ///< until the user has said how tall the model shall be
  std::shared_ptr<Chore<Made>> chore_making;
  std::shared_ptr<Chore<Measured>> measuring;  ///< how far the present mesh is from the file's
  std::shared_ptr<const Measured> measured;    ///< no part of the project: knowing it is no change to save
  Making making;
  std::optional<Making> queued;  ///< the slider's latest wish; the mesh in hand is shown first
  bool is_dragging = false;      ///< the simplify slider is held
  std::size_t drag_step = 0;     ///< where in the history the drag's one step is
  bool has_net_in_step =
      false;  ///< a net was found meanwhile; when the hand lets go it gets its own undo step
  /// The net is there before its pages are.
  struct Deriving : Chore<Derived> {
    explicit Deriving(const std::shared_ptr<const Bell>& rung)
        : Chore<Derived>(rung), net([rung] { rung->ring(); }) {}
    Mailbox<ShownNet> net;
  };
  std::shared_ptr<Deriving> deriving;
  std::vector<std::shared_ptr<Chore<Message>>> exports;
  std::shared_ptr<Chore<Split>> splitting;
  std::shared_ptr<Chore<Releases>> releasing;
  std::shared_ptr<Chore<PiecesResult>> piecing;
  std::shared_ptr<Chore<Softening>> softening;
  std::shared_ptr<Chore<std::vector<std::string>>> searching_printers;
  std::shared_ptr<const std::vector<std::string>> printers;

  Keeper keeper{worker, bell};
  std::filesystem::path opening_file;        ///< of the project that is being read
  std::optional<AutosaveSlot> opening_slot;  ///< it is being recovered from
  std::shared_ptr<Chore<std::vector<Leftover>>> searching_leftovers;
  std::vector<Leftover> leftovers;

  std::vector<Message> messages;
  std::uint64_t n_messages = 0;
  std::uint64_t n_versions = 0;
  double speed = std::numeric_limits<double>::infinity();
  int streams = SolveOptions{}.streams;
  int threads = 0;
  PolishSettings polish{.effort = 0};
  std::string desk_paper;  ///< empty: that of the model before
  double time_limit_s = 60;
  int shown_tenths = -1;  ///< of the running clock, when poll() last told of a change

  Worker worker;  ///< last: its jobs end before anything they use goes
};

}  // namespace netwright
