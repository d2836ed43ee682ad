// A reason why no net in one piece can exist, where it can be read off a single face.
#pragma once

#include <string>

#include "core/mesh/dual_graph.h"
#include "core/unfold/impossibility.h"

namespace netwright {

/// A face that overlaps every neighbour it could be joined to, or none. In one piece every face is joined to
/// some neighbour, and how two joined faces lie does not depend on the rest of the net: so such a face proves
/// that its component has no net. (A star whose notches are narrower than the corners of the sides that would
/// stand in them.)
FaceId find_isolated_face(const DualGraph& dual);

/// What such a face proves, for the checker: every way to join it, and none.
ImpossibilityProof isolated_face_proof(const Mesh& mesh, FaceId face);

/// The same as one sentence for people, with the cure.
std::string isolated_face_sentence(const Mesh& mesh, FaceId face);

}  // namespace netwright
