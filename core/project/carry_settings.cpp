// Which face an edge begins with may differ between two meshes. Both are oriented alike, so an edge that runs
// the other way begins with its other face.
#include "core/project/carry_settings.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace netwright {

namespace {

glm::dvec3 along(const Mesh& mesh, EdgeId e) {
  const HalfedgeId h = mesh.halfedge(e);
  return mesh.position(mesh.to(h)) - mesh.position(mesh.from(h));
}

void carry_folds(std::vector<EdgeId>& folds, const EdgeHeir& heir) {
  std::vector<EdgeId> carried;
  for (const EdgeId e : folds)
    if (const EdgeId place = heir(e); place.is_valid()) carried.push_back(place);
  std::ranges::sort(carried);
  const auto rest = std::ranges::unique(carried);
  carried.erase(rest.begin(), rest.end());
  folds = std::move(carried);
}

}  // namespace

TabEdit seen_from_twin(TabEdit edit) {
  if (edit.side == TabSide::First)
    edit.side = TabSide::Second;
  else if (edit.side == TabSide::Second)
    edit.side = TabSide::First;
  std::swap(edit.first_angle_rad, edit.second_angle_rad);
  return edit;
}

void carry_settings(TabSettings& tabs, SheetSettings& sheet, const Mesh& from, const Mesh& to,
                    const EdgeHeir& heir, const TurnedAlong& turned) {
  std::vector<TabEdit> edits;
  for (const TabEdit& edit : tabs.edits) {
    const EdgeId place = heir(edit.edge);
    if (!place.is_valid()) continue;
    const bool is_reversed = glm::dot(turned(along(from, edit.edge)), along(to, place)) < 0;
    edits.push_back(is_reversed ? seen_from_twin(edit) : edit);
    edits.back().edge = place;
  }
  std::ranges::stable_sort(edits, {}, &TabEdit::edge);
  const auto rest = std::ranges::unique(edits, {}, &TabEdit::edge);
  edits.erase(rest.begin(), rest.end());
  tabs.edits = std::move(edits);
  carry_folds(sheet.hidden_folds, heir);
  carry_folds(sheet.shown_folds, heir);
  std::erase_if(sheet.shown_folds,
                [&](EdgeId e) { return std::ranges::binary_search(sheet.hidden_folds, e); });
}

}  // namespace netwright
