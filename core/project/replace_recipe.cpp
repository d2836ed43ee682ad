// Parts go by their boxes, since a part's faces may all be new ones; groups that were split again go by their
// faces, which must all be where they were.
#include "core/project/replace_recipe.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "core/base/counted.h"

namespace netwright {

namespace {

struct PartPlace {
  Box3 box;
  const ModelPart* part = nullptr;
};

std::vector<PartPlace> places_of(const Mesh& mesh, const std::vector<ModelPart>& parts,
                                 const ModelFrame& frame) {
  std::vector<PartPlace> places;
  for (const ModelPart& part : parts) {
    PartPlace place{{}, &part};
    for (const int f : part.faces)
      for (const HalfedgeId h : mesh.halfedges(FaceId(f))) place.box.add(frame(mesh.position(h)));
    places.push_back(place);
  }
  return places;
}

/// How little two boxes are alike, as a share of the larger one.
double unlikeness(const Box3& one, const Box3& other) {
  const double larger = std::max(one.diagonal(), other.diagonal());
  const double apart = glm::length(one.centre() - other.centre()) + glm::length(one.size() - other.size());
  return larger > 0 ? apart / larger : 0;
}

bool is_left_out(const Mesh& mesh, const ModelPart& part, const std::vector<int>& left_out) {
  return std::ranges::any_of(part.faces, [&](int f) {
    return std::ranges::find(left_out, mesh.face_source(FaceId(f))) != left_out.end();
  });
}

/// The new parts that stand where a part stood that was left out.
std::vector<int> carry_left_out(const Project& old, const Mesh& whole, const ModelFrame& frame, int& n_lost) {
  constexpr double kAlike = 0.3;
  const std::vector<int>& wanted = old.recipe.left_out;
  n_lost = static_cast<int>(wanted.size());
  const std::shared_ptr<const Mesh>& before = old.made->stages->whole;
  if (wanted.empty() || !before) return {};
  const std::vector<ModelPart> old_parts = parts_of(*before);
  const std::vector<ModelPart> parts = parts_of(whole);
  std::vector<int> left_out;
  std::vector<const ModelPart*> found;
  const std::vector<PartPlace> old_places = places_of(*before, old_parts, frame);
  for (const PartPlace& place : places_of(whole, parts, {})) {
    const auto nearest = std::ranges::min_element(
        old_places, {}, [&](const PartPlace& other) { return unlikeness(other.box, place.box); });
    const bool is_it = unlikeness(nearest->box, place.box) <= kAlike &&
                       is_left_out(*before, *nearest->part, wanted) && place.part->first_face >= 0;
    if (!is_it) continue;
    left_out.push_back(place.part->first_face);
    if (std::ranges::find(found, nearest->part) == found.end()) found.push_back(nearest->part);
  }
  if (left_out.size() == parts.size()) return {};  // one has to stay
  std::ranges::sort(left_out);
  n_lost = static_cast<int>(std::ranges::count_if(old_parts, [&](const ModelPart& part) {
    return is_left_out(*before, part, wanted) && std::ranges::find(found, &part) == found.end();
  }));
  return left_out;
}

/// The groups whose faces are all where they were, as faces of the new file.
std::vector<std::vector<int>> carry_groups(const Project& old, const Mesh& mesh, const ModelFrame& frame) {
  std::vector<std::vector<int>> groups;
  if (old.recipe.apart.empty()) return groups;
  const Mesh& before = *old.made->stages->mesh;
  const MeshMatch match = match_meshes(before, mesh, frame, {});
  std::unordered_map<int, int> heirs;
  for (const FaceId f : before.faces())
    if (match.is_face_same[f] != 0) heirs[before.face_source(f)] = mesh.face_source(match.faces[f]);
  for (const std::vector<int>& group : old.recipe.apart) {
    std::vector<int> faces;
    for (const int face : group)
      if (const auto heir = heirs.find(face); heir != heirs.end()) faces.push_back(heir->second);
    if (faces.size() == group.size()) groups.push_back(std::move(faces));
  }
  return groups;
}

MeshReport::Line problem(std::string text) { return {MeshReport::Line::Kind::Problem, std::move(text)}; }

}  // namespace

CarriedRecipe carry_recipe(const Project& old, const Recipe& wanted, const MadeModel& made,
                           const ModelFrame& frame) {
  CarriedRecipe carried{wanted, {}};
  int n_lost = 0;
  carried.recipe.left_out = carry_left_out(old, *made.stages->whole, frame, n_lost);
  if (n_lost > 0)
    carried.lines.push_back(
        problem(counted(n_lost, "part that was left out is", "parts that were left out are") +
                " not there any more."));
  carried.recipe.apart = carry_groups(old, *made.stages->mesh, frame);
  const std::size_t n_groups = old.recipe.apart.size() - carried.recipe.apart.size();
  if (n_groups > 0)
    carried.lines.push_back(
        problem(counted(static_cast<std::int64_t>(n_groups), "merged face that was split again is",
                        "merged faces that were split again are") +
                " not there any more."));
  return carried;
}

}  // namespace netwright
