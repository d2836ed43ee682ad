// All steps of repair in the order that works: points first, then faces that are none, then edges and
// points, which way faces run, and at last what the user may want besides.
#include <algorithm>
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
  void turn() {
    try {
      const Repaired step = orient_faces(start_.soup);
      if (step.count == 0) return;
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
    note("Split " + counted(parts.n_split, "face that is", "faces that are") +
         " not flat into triangles" +
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

RepairResult repair_all(const PolygonSoup& soup, const RepairOptions& options, Progress& progress) {
  Way way(soup);
  const bool is_left_apart = options.weld_tolerance < 0 && soup.is_joined;
  const double tolerance = options.weld_tolerance >= 0 ? options.weld_tolerance
                                                       : kWeldDistance * repair::used_box(soup).diagonal();
  const Repaired welded = is_left_apart ? repair::unchanged(soup) : weld_points(soup, tolerance);
  way.go(welded);
  if (welded.count == 0) way.take(opened(soup));
  using Step = std::function<void()>;
  const auto go = [&way](auto step) { return [&way, step] { way.go(step(way.soup())); }; };
  std::vector<Step> steps{go(drop_degenerate_faces), go(drop_doubled_faces), go(split_non_manifold),
                          [&] { way.turn(); }};
  if (options.min_part_share > 0)
    steps.push_back(go([&](const PolygonSoup& s) { return drop_small_parts(s, options.min_part_share); }));
  if (options.drops_inner_parts) steps.push_back(go(drop_inner_parts));
  if (options.max_hole_edges > 0) {
    steps.push_back(go([&](const PolygonSoup& s) { return close_holes(s, options.max_hole_edges); }));
    steps.emplace_back([&] { way.turn(); });  // what is closed now has an outside
  }
  steps.push_back(go(drop_isolated_points));
  progress.set_phase("repairing " + soup.name);
  for (std::size_t i = 0; i < steps.size() && !progress.is_cancelled(); ++i) {
    steps[i]();
    progress.set_fraction(static_cast<double>(i + 1) / static_cast<double>(steps.size() + 1));
  }
  PreparedModel prepared = way.has_done_nothing() ? prepare(soup) : way.prepared();
  if (prepared.mesh && prepared.report.n_uneven_faces > 0 && options.splits_uneven_faces &&
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

}  // namespace netwright
