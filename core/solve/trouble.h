// Why a search found no net: the faces it met in collision most often, the corners near them that have more
// paper around them than lies flat, and the pins without which there would be a net.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/solve/constraints.h"
#include "core/solve/solve.h"

namespace netwright {

/// A corner whose angles add up to more than a full turn (negative curvature): its faces cannot lie around it
/// in the plane, so a cut has to end there however the net is made.
struct ExcessPoint {
  VertexId vertex;
  double angle_rad = 0;  ///< of all faces around it, together
  double share = 0;      ///< 0 … 1: of all collisions, those of the faces around it
};

struct Trouble {
  bool is_impossible = false;       ///< it is proved that there is no net, whatever is pinned
  IdVector<FaceId, float> heat;     ///< 0 … 1, one per face: its collisions by those of the hottest face
  std::vector<FaceId> hot;          ///< the hottest first, until they make up four fifths of all collisions
  std::vector<ExcessPoint> points;  ///< at hot faces, those with the largest share first
};

/// What a search that found no net was stuck at. Empty lists where there was no collision at all.
[[nodiscard]] Trouble find_trouble(const SolveResult& result);

/// One pin by itself, the root apart.
struct Pin {
  enum class Kind { MustFold, MustCut, Patch };
  Kind kind = Kind::MustFold;
  EdgeId edge;                ///< of a must-fold or a must-cut
  std::vector<FaceId> faces;  ///< of a patch
  bool operator==(const Pin&) const = default;
};

[[nodiscard]] std::vector<Pin> pins_in(const Constraints& pins);
[[nodiscard]] Constraints without(Constraints pins, const std::vector<Pin>& released);
/// The faces that a pin is about.
[[nodiscard]] std::vector<FaceId> faces_of(const Mesh& mesh, const Pin& pin);

/// What releasing pins would bring.
struct Releases {
  /// Each of these gives a net: single pins, the hottest first; where no single one does, one group of which
  /// none can stay.
  std::vector<std::vector<Pin>> ways;
  bool are_innocent = false;  ///< no net was found without any pins either
  bool was_cancelled = false;
};

/// Tries what happens without each of the pins `options` has, by short searches: those of the hottest faces
/// first. The answers are proved nets, so what it lists helps; what it does not list might.
[[nodiscard]] Releases find_releases(const std::shared_ptr<const DualGraph>& dual,
                                     const SolveOptions& options, const Trouble& trouble, Progress& progress);

/// How many iterations a stream gets when something is only tried: several times what models of that size
/// usually need.
[[nodiscard]] std::int64_t iterations_for_a_try(const Mesh& mesh);

/// How faces are numbered for people.
using NumberOfFace = std::function<int(FaceId)>;
/// "the must-fold between faces 3 and 7", "the patch of 4 faces at face 12".
[[nodiscard]] std::string pin_words(const Mesh& mesh, const Pin& pin, const NumberOfFace& number);
/// "the must-fold between … and the must-cut between …"
[[nodiscard]] std::string pins_words(const Mesh& mesh, const std::vector<Pin>& pins,
                                     const NumberOfFace& number);

}  // namespace netwright
