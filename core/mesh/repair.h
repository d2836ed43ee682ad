// From a soup to a Mesh that can be unfolded. prepare() does what is harmless on opening (equal points become
// one, faces are turned outward) and tells it; everything that drops, cuts or adds is a step of its own, done
// only when asked for, and repair_all() does them in the order that works.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_report.h"

namespace netwright {

/// Makes corners at one place use one point, the first of them, wherever their faces meet along an edge;
/// parts that merely touch stay apart. Unused points stay in the soup, so point numbers in messages remain
/// those of the file. Equal points always count as one place; where the file gave each face points of its own
/// (!is_indexed) also points within kWeldDistance of the model's diagonal. Returns how many points merged
/// into others.
int weld(PolygonSoup& soup);

/// Turns faces until neighbours run the same way and each closed component's volume is positive; open
/// components keep the way that most of their faces had. Returns one flag per face: turned or not.
/// Throws Error(Unfit), naming an edge and its two faces, when the surface has only one side.
std::vector<bool> orient(PolygonSoup& soup);

/// A model as it is after reading: the report always, the mesh when there can be one.
struct PreparedModel {
  std::shared_ptr<const Mesh> mesh;  ///< null when the model is no orientable manifold
  MeshReport report;
  std::string refusal;  ///< why it cannot be unfolded, one sentence with the cure; empty when it can
  [[nodiscard]] bool is_fit() const { return refusal.empty(); }
};

/// Weld, orient, build, report. Never throws for a bad model; face f of the mesh is face f of the file.
/// Closed parts that have points of their own in the file and merely touch are kept apart.
PreparedModel prepare(const PolygonSoup& soup);

/// What one step of repair made of a soup. Texture coordinates and materials go along.
struct Repaired {
  PolygonSoup soup;              ///< the input itself when count is 0
  std::vector<int> face_source;  ///< per face: the input's face it came from, -1 for a face that fills a hole
  std::vector<bool> is_turned;   ///< per face: it runs against the input's face
  int count = 0;                 ///< how many things were put right
  std::string sentence;          ///< "Dropped 4 doubled faces (36 → 32 faces)."; empty when count is 0
};

/// The steps, each a pure function that starts from the connectivity that weld() gives (so files without
/// shared points work too) and changes nothing but what it is named for.
///
/// Joins open edges whose ends lie within `tolerance` (model units; 0 = equal) of each other.
Repaired weld_points(const PolygonSoup& soup, double tolerance);
/// Takes corners named twice out of faces, and drops faces without area: their neighbours take over the
/// corners between, so that no gap opens.
Repaired drop_degenerate_faces(const PolygonSoup& soup);
/// Of faces with the same corners the first one stays.
Repaired drop_doubled_faces(const PolygonSoup& soup);
/// Parts edges with more than two faces, and points where several fans meet, into manifold pieces: the faces
/// that bound the same stretch of a part stay together. Points are doubled, nothing moves.
Repaired split_non_manifold(const PolygonSoup& soup);
/// orient() as a step. Throws Error(Unfit) when the surface has only one side.
Repaired orient_faces(const PolygonSoup& soup);
/// Fills borders of at most `max_edges` edges: a flat one with one face, others with triangles that bend as
/// little as possible. Expects neighbours that run the same way (orient_faces); other borders stay open.
Repaired close_holes(const PolygonSoup& soup, int max_edges);
/// How many edges each border has that close_holes() could close, smallest first.
std::vector<int> hole_sizes(const PolygonSoup& soup);
/// Drops parts whose diagonal is below this share of the whole model's; the largest part always stays.
Repaired drop_small_parts(const PolygonSoup& soup, double min_share);
/// Drops parts that lie wholly inside a closed part.
Repaired drop_inner_parts(const PolygonSoup& soup);
/// Drops points that no face uses.
Repaired drop_isolated_points(const PolygonSoup& soup);

/// Which steps are wanted; as it comes, all that change nothing but faults. Turning faces (orient) is not
/// among them: without it there is no mesh, so it is always done, and told.
struct Repairs {
  bool welds = true;                   ///< weld_points()
  double weld_tolerance = -1;          ///< for it, in model units; negative: kWeldDistance of the diagonal
  bool drops_degenerate_faces = true;  ///< drop_degenerate_faces()
  bool drops_doubled_faces = true;     ///< drop_doubled_faces()
  bool splits_non_manifold = true;     ///< split_non_manifold()
  int max_hole_edges = 0;              ///< close_holes(); 0: borders stay open, as masks and shells want it
  bool drops_isolated_points = true;   ///< drop_isolated_points()
  bool operator==(const Repairs&) const = default;
};
inline constexpr Repairs kNoRepairs{false, -1, false, false, false, 0, false};

/// The steps in the order in which they are done.
enum class RepairStep {
  Weld,
  DegenerateFaces,
  DoubledFaces,
  NonManifold,
  Turn,
  Holes,
  IsolatedPoints,
  UnevenFaces
};

struct RepairResult {
  PolygonSoup soup;               ///< repaired; equal to the input when there was nothing to do
  std::vector<int> face_source;   ///< per face: the input's face, -1 for a face that fills a hole
  std::vector<bool> is_turned;    ///< per face: it runs against the input's face
  std::vector<std::string> done;  ///< what was done, one sentence with counts each; empty when nothing was
  std::string verdict;            ///< one sentence: fit to unfold now, or why not
  PreparedModel prepared;         ///< of the repaired soup; its mesh's face_source speaks of the input
  [[nodiscard]] bool is_fit() const { return prepared.is_fit(); }
};

/// The steps that are wanted in the order that works, then prepare(), then uneven faces split into triangles
/// (split_faces.h) unless they will be planarized. Repairing a sound model changes nothing, so doing it twice
/// is doing it once. Never throws for a bad model: what cannot be repaired is said in `verdict`. When
/// cancelled, the steps that were done stand.
RepairResult repair_all(const PolygonSoup& soup, const Repairs& repairs, Progress& progress,
                        bool splits_uneven_faces = true);

/// What one step finds when its turn comes, after the wanted ones before it.
struct RepairCount {
  RepairStep step;
  int found = 0;         ///< points, faces, edges and points, borders: what the step is about
  int left = 0;          ///< of them afterwards; `found` where the step is not wanted
  std::string sentence;  ///< what it does or would do: "Dropped 4 doubled faces (36 → 32 faces)."
  bool operator==(const RepairCount&) const = default;
};

/// A look at what each step has to do, also those that are not wanted, before one decides. Steps that find
/// nothing are left out.
struct RepairSurvey {
  std::vector<RepairCount> counts;  ///< in the order of the steps
  std::vector<int> hole_sizes;      ///< edges around each border when holes are closed, smallest first
  double weld_tolerance = 0;        ///< model units: the one wanted, or the usual one
  bool can_weld = false;            ///< there are open edges that a larger tolerance could join
  [[nodiscard]] const RepairCount* find(RepairStep step) const;
};
RepairSurvey survey_repairs(const PolygonSoup& soup, const Repairs& repairs, Progress& progress);

}  // namespace netwright
