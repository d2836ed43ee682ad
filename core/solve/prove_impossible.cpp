// First the regions, which need no luck and no small model, then every hinge of every small component.
#include "core/solve/prove_impossible.h"

#include "core/solve/prove_hinges.h"
#include "core/solve/prove_regions.h"
#include "core/unfold/flat_net.h"
#include "core/unfold/verify.h"

namespace netwright {
namespace {

std::vector<std::vector<FaceId>> components(const Mesh& mesh) {
  std::vector<std::vector<FaceId>> all(mesh.n_components());
  for (const FaceId f : mesh.faces()) all[static_cast<std::size_t>(mesh.component(f))].push_back(f);
  return all;
}

bool take_proof(const Mesh& mesh, ImpossibilityProof proof, ProveResult& result) {
  if (!verify_impossible(mesh, proof).is_proved) return false;
  result.answer = ProveAnswer::Proved;
  result.proof = std::move(proof);
  return true;
}

void search_every_hinge(const std::shared_ptr<const DualGraph>& dual, const ProveLimits& limits,
                        const Progress& progress, ProveResult& result) {
  const Mesh& mesh = dual->mesh();
  IdVector<EdgeId, char> is_fold(mesh.n_edges(), 0);
  bool is_complete = true;
  for (const std::vector<FaceId>& component : components(mesh)) {
    if (component.size() > limits.hinge_faces) {
      is_complete = false;
      continue;
    }
    HingeSearch search = search_hinges(*dual, component, 1, limits.hinge_steps, progress);
    result.hinge_steps += search.steps;
    if (search.proof && take_proof(mesh, std::move(*search.proof), result)) return;
    is_complete &= search.is_found;
    for (const EdgeId e : search.folds) is_fold[e] = 1;
  }
  if (!is_complete) return;
  Net net = layout(dual, tree_from_folds(mesh, is_fold));
  if (!verify(to_flat_net(net, 1), static_cast<int>(mesh.n_components())).is_net) return;
  result.answer = ProveAnswer::NetFound;
  result.net = std::move(net);
}

}  // namespace

ProveResult prove_impossible(const std::shared_ptr<const DualGraph>& dual, const ProveLimits& limits,
                             const Progress& progress) {
  ProveResult result;
  if (auto proof = search_regions(*dual, limits.region_steps, progress))
    if (take_proof(dual->mesh(), std::move(*proof), result)) return result;
  search_every_hinge(dual, limits, progress, result);
  return result;
}

std::string impossible_sentence(const Mesh& mesh) {
  return mesh.name() +
         " has no net in one piece: that is proved. Allow several pieces, or make its steep places flatter "
         "in a "
         "modelling program.";
}

}  // namespace netwright
