// All steps of repair in the order that works: points first, then faces that are none, then edges and
// points, which way faces run, and at last what the user may want besides.
#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "core/base/error.h"
#include "core/base/predicates.h"
#include "core/mesh/repair.h"
#include "core/mesh/repair_topology.h"
#include "core/mesh/split_faces.h"

namespace netwright {
namespace {

/// The soup on its way through the steps, with where its faces came from.
class Way {
 public:
  explicit Way(const PolygonSoup& soup) : start_(repair::unchanged(soup)) {}

  void go(const Repaired& step) {
    if (step.count == 0) return;
    note(step.sentence);
    take(step);
  }

  /// Faces may be turned more than once; what comes of it is told in one sentence.
  void turn(RepairSurvey* survey = nullptr) {
    try {
      const Repaired step = orient_faces(start_.soup);
      if (step.count == 0) return;
      if (survey != nullptr) survey->counts.push_back({RepairStep::Turn, step.count, 0, step.sentence});
      take(step);
      if (!has_turned_) turn_place_ = done_.size();
      has_turned_ = true;
    } catch (const Error&) {  // one-sided: prepare() finds the words
    }
  }

  /// The step's soup without a word about it.
  void take(const Repaired& step) {
    std::vector<int> sources;
    std::vector<bool> turned;
    for (std::size_t f = 0; f < step.face_source.size(); ++f) {
      const int before = step.face_source[f];
      const auto at = static_cast<std::size_t>(before);
      sources.push_back(before < 0 ? -1 : start_.face_source[at]);
      turned.push_back(before >= 0 && start_.is_turned[at] != step.is_turned[f]);
    }
    start_.soup = step.soup;
    start_.face_source = std::move(sources);
    start_.is_turned = std::move(turned);
  }

  void split(const Mesh& mesh) {
    SplitFaces parts = netwright::split_uneven_faces(mesh);
    note("Split " + counted(parts.n_split, "face that is", "faces that are") + " not flat into triangles" +
         repair::before_after(static_cast<int>(mesh.n_faces()), parts.soup.n_faces(), "faces") + ".");
    parts.soup.notices = std::move(start_.soup.notices);
    parts.soup.is_joined = true;
    start_.soup = std::move(parts.soup);
    start_.face_source.clear();
    for (const FaceId f : parts.split_from) start_.face_source.push_back(mesh.face_source(f));
    start_.is_turned = std::move(parts.is_flipped);
  }

  [[nodiscard]] const PolygonSoup& soup() const { return start_.soup; }
  [[nodiscard]] PreparedModel prepared() const {
    return repair::prepare_from(start_.soup, start_.face_source, start_.is_turned);
  }
  [[nodiscard]] bool has_done_nothing() const { return done_.empty() && n_turned() == 0; }

  [[nodiscard]] RepairResult result(PreparedModel prepared) && {
    if (n_turned() > 0) {
      done_.insert(done_.begin() + static_cast<std::ptrdiff_t>(turn_place_),
                   repair::turned_sentence(n_turned()));
    }
    return {std::move(start_.soup),
            std::move(start_.face_source),
            std::move(start_.is_turned),
            std::move(done_),
            {},
            std::move(prepared)};
  }

 private:
  void note(std::string sentence) { done_.push_back(std::move(sentence)); }

  [[nodiscard]] std::ptrdiff_t n_turned() const {
    return has_turned_ ? std::ranges::count(start_.is_turned, true) : 0;
  }

  Repaired start_;
  std::vector<std::string> done_;
  bool has_turned_ = false;
  std::size_t turn_place_ = 0;  ///< where in done_ its sentence belongs
};

/// The soup with its points joined as on opening, so that no later step has to.
Repaired opened(const PolygonSoup& soup) {
  PolygonSoup work = repair::joined(soup);
  work.is_joined = true;
  if (!soup.is_indexed) work = drop_isolated_points(work).soup;  // the points that joining left over
  work.is_indexed = true;
  return repair::unchanged(work);
}

double tolerance_of(const PolygonSoup& soup, const Repairs& repairs) {
  return repairs.weld_tolerance >= 0 ? repairs.weld_tolerance
                                     : kWeldDistance * repair::used_box(soup).diagonal();
}

int n_open_edges(const PolygonSoup& soup) {
  int n = 0;
  const std::vector<repair::Side> sides = repair::sorted_sides(soup);
  repair::for_each_edge(sides, [&](std::span<const repair::Side> edge) { n += edge.size() == 1 ? 1 : 0; });
  return n;
}

/// Points come first, since all that follows goes by which faces share them.
void weld_on(Way& way, const PolygonSoup& soup, const Repairs& repairs, RepairSurvey* survey) {
  // A repaired soup holds points apart on purpose: only a tolerance that was asked for joins them again.
  const bool is_left_apart = repairs.weld_tolerance < 0 && soup.is_joined;
  const bool is_looked_at = repairs.welds || survey != nullptr;
  const Repaired welded = is_looked_at && !is_left_apart ? weld_points(soup, tolerance_of(soup, repairs))
                                                         : repair::unchanged(soup);
  if (repairs.welds) way.go(welded);
  const bool is_welded = repairs.welds && welded.count > 0;
  if (!is_welded) way.take(opened(soup));
  if (survey == nullptr) return;
  PolygonSoup joined = soup;
  const int n_equal = soup.is_indexed ? weld(joined) : 0;  // these are joined on opening in any case
  survey->counts.push_back({RepairStep::Weld, welded.count,
                            repairs.welds ? 0 : welded.count - std::min(n_equal, welded.count),
                            welded.sentence});
  survey->can_weld = welded.count > n_equal || n_open_edges(way.soup()) > 0;
}

void close_on(Way& way, int max_edges, RepairSurvey* survey) {
  if (survey != nullptr) survey->hole_sizes = hole_sizes(way.soup());
  const Repaired closed = max_edges > 0 ? close_holes(way.soup(), max_edges) : repair::unchanged(way.soup());
  if (survey != nullptr) {
    const auto n_holes = static_cast<int>(survey->hole_sizes.size());
    survey->counts.push_back({RepairStep::Holes, n_holes, n_holes - closed.count, closed.sentence});
  }
  if (closed.count == 0) return;
  way.go(closed);
  way.turn();  // what is closed now has an outside
}

/// All steps but the split of uneven faces; a survey also learns what those find that are not wanted.
void walk(Way& way, const Repairs& repairs, Progress& progress, RepairSurvey* survey) {
  const auto step = [&](RepairStep what, bool is_wanted, auto repair) {
    if (!is_wanted && survey == nullptr) return;
    const Repaired done = repair(way.soup());
    if (survey != nullptr)
      survey->counts.push_back({what, done.count, is_wanted ? 0 : done.count, done.sentence});
    if (is_wanted) way.go(done);
  };
  const std::array<std::function<void()>, 7> steps{
      [&] { weld_on(way, way.soup(), repairs, survey); },
      [&] { step(RepairStep::DegenerateFaces, repairs.drops_degenerate_faces, drop_degenerate_faces); },
      [&] { step(RepairStep::DoubledFaces, repairs.drops_doubled_faces, drop_doubled_faces); },
      [&] { step(RepairStep::NonManifold, repairs.splits_non_manifold, split_non_manifold); },
      [&] { way.turn(survey); },
      [&] { close_on(way, repairs.max_hole_edges, survey); },
      [&] { step(RepairStep::IsolatedPoints, repairs.drops_isolated_points, drop_isolated_points); }};
  for (std::size_t i = 0; i < steps.size() && !progress.is_cancelled(); ++i) {
    steps[i]();
    progress.set_fraction(static_cast<double>(i + 1) / static_cast<double>(steps.size() + 1));
  }
}

std::string verdict(const PolygonSoup& soup, const RepairResult& result) {
  const std::string name = soup.name.empty() ? "The model" : soup.name;
  if (result.is_fit()) {
    return result.done.empty() ? name + " is sound: there is nothing to repair."
                               : name + " is sound now and fit to unfold.";
  }
  std::string why = result.prepared.refusal;
  if (why.starts_with(name + ": ")) why = why.substr(name.size() + 2);
  return name + " cannot be repaired: " + why;
}

}  // namespace

RepairResult repair_all(const PolygonSoup& soup, const Repairs& repairs, Progress& progress,
                        bool splits_uneven_faces) {
  Way way(soup);
  progress.set_phase("repairing " + soup.name);
  walk(way, repairs, progress, nullptr);
  PreparedModel prepared = way.has_done_nothing() ? prepare(soup) : way.prepared();
  if (prepared.mesh && prepared.report.n_uneven_faces > 0 && splits_uneven_faces &&
      !progress.is_cancelled()) {
    way.split(*prepared.mesh);
    way.go(drop_degenerate_faces(way.soup()));  // a split may pass through a corner
    way.go(split_non_manifold(way.soup()));     // a diagonal may be an edge elsewhere
    way.turn();                                 // and flat faces tell better what is outside
    prepared = way.prepared();
  }
  const bool is_untouched = way.has_done_nothing();
  RepairResult result = std::move(way).result(std::move(prepared));
  if (is_untouched) result.soup = soup;
  result.verdict = verdict(soup, result);
  progress.set_fraction(1);
  return result;
}

RepairSurvey survey_repairs(const PolygonSoup& soup, const Repairs& repairs, Progress& progress) {
  Way way(soup);
  RepairSurvey survey;
  survey.weld_tolerance = tolerance_of(soup, repairs);
  walk(way, repairs, progress, &survey);
  int n_uneven = 0;
  for (int f = 0; f < way.soup().n_faces(); ++f)
    n_uneven += repair::measure_face(way.soup(), f).side_unevenness > kFlatness ? 1 : 0;
  survey.counts.push_back({RepairStep::UnevenFaces, n_uneven, n_uneven, {}});
  std::erase_if(survey.counts, [](const RepairCount& count) { return count.found == 0; });
  return survey;
}

const RepairCount* RepairSurvey::find(RepairStep step) const {
  const auto found = std::ranges::find(counts, step, &RepairCount::step);
  return found == counts.end() ? nullptr : &*found;
}

}  // namespace netwright
