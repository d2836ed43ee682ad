// Files (.proof) that hold a model together with the proof that it has no net in one piece, so that anybody
// can check it later.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/mesh/mesh.h"
#include "core/unfold/impossibility.h"

namespace netwright {

inline constexpr std::string_view kProofExtension = "proof";

struct ProofFile {
  Mesh mesh;
  ImpossibilityProof proof;  ///< as it was read: whether it holds is for verify_impossible to say
};

bool has_proof_name(const std::filesystem::path& path);

/// One JSON object: points and faces of the mesh, the regions and the steps of the proof, edges told by a
/// face and the corner where they begin. Faces and corners count from 0. Throws Error(Write).
void write_proof(const std::filesystem::path& path, const Mesh& mesh, const ImpossibilityProof& proof);

/// Throws Error(Read) where the file is not one of these or is damaged.
ProofFile read_proof(const std::filesystem::path& path);

}  // namespace netwright
