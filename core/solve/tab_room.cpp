// Collects the outline of the state's net and asks every cut for room on either side.
#include "core/solve/tab_room.h"

namespace netwright {

TabRoom::TabRoom(const DualGraph& dual, const SearchModel& model, double scale, const TabSettings& settings)
    : model_(&model),
      mm_per_length_(scale * dual.mesh().mean_edge()),
      wish_{settings.width_mm, settings.angle_rad, settings.angle_rad} {
  for (const HalfedgeId h : model.mesh_halfedge) {
    corners_.push_back(dual.flat(h) / dual.mesh().mean_edge());
    next_.push_back(0);
  }
  for (int f = 0; f < model.n_faces; ++f) {
    const int first = model.face_begin[static_cast<std::size_t>(f)];
    const int last = model.face_begin[static_cast<std::size_t>(f) + 1];
    for (int h = first; h < last; ++h) next_[static_cast<std::size_t>(h)] = h + 1 < last ? h + 1 : first;
  }
}

glm::dvec2 TabRoom::corner(const SearchState& state, int h) const {
  const auto i = static_cast<std::size_t>(h);
  return state.placement(model_->face_of[i])(corners_[i]) * mm_per_length_;
}

Judgement TabRoom::operator()(const SearchState& state) const {
  std::vector<SideGrid::Side> sides;
  std::vector<int> index(static_cast<std::size_t>(model_->n_halfedges), -1);
  for (int h = 0; h < model_->n_halfedges; ++h) {
    if (state.is_fold(h)) continue;
    index[static_cast<std::size_t>(h)] = static_cast<int>(sides.size());
    sides.push_back({HalfedgeId(h), corner(state, h), corner(state, next_[static_cast<std::size_t>(h)])});
  }
  const SideGrid grid(std::move(sides), 2 * wish_.width_mm);
  Judgement judgement;
  for (int h = 0; h < model_->n_halfedges; ++h) {
    const int twin = model_->twin[static_cast<std::size_t>(h)];
    if (twin < h || index[static_cast<std::size_t>(h)] < 0) continue;
    const auto has_room = [&](int side) {
      return has_room_for_tab(grid, grid.side(index[static_cast<std::size_t>(side)]), wish_);
    };
    if (has_room(h) || has_room(twin)) continue;
    judgement.cost += 1;
    judgement.trouble.push_back(h);
  }
  return judgement;
}

}  // namespace netwright
