// Counting as section 4.7 of the paper does it, for its own setting of the search and as a check on the fast
// way: few moved faces are tried against everything, otherwise all overlaps are found anew by a sweep.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/solve/search_state.h"

namespace netwright {

int SearchState::count_as_paper(const Exchange& exchange) {
  side_first_ = exchange.first;
  side_last_ = exchange.last;
  motion_ = exchange.motion;
  const int n = model_->n_faces;
  if (exchange.last - exchange.first < std::log(static_cast<double>(n))) return count_naively();
  return count_by_sweep();
}

int SearchState::count_naively() {
  int count = 0;
  for (int i = side_first_; i < side_last_; ++i) {
    const int face = order_[at(i)];
    move_query(face);
    for (int j = 0; j < model_->n_faces; ++j) {
      const bool is_rest = j < side_first_ || j >= side_last_;
      count += is_rest && faces_overlap(moved_.data(), face, order_[at(j)]) ? 1 : 0;
    }
  }
  return count;
}

// Lays the moved side out, sweeps over all faces and takes off what the move could not change.
int SearchState::count_by_sweep() {
  const std::vector<glm::dvec2> world = world_;
  const std::vector<BoxF> boxes = box_;
  for (int i = side_first_; i < side_last_; ++i) {
    const int face = order_[at(i)];
    box_[at(face)] = move_query(face);
    std::copy(moved_.begin(), moved_.end(), world_.begin() + model_->first_vert(face));
  }
  const auto in_side = [&](int f) { return position(f) >= side_first_ && position(f) < side_last_; };
  const auto found = sweep();
  const auto changed = std::count_if(found.begin(), found.end(),
                                     [&](const auto& p) { return in_side(p.first) != in_side(p.second); });
  world_ = world;
  box_ = boxes;
  return static_cast<int>(changed);
}

// The paper's Algorithm 2 on the float boxes.
std::vector<std::pair<int, int>> SearchState::sweep() const {
  std::vector<int> swept(at(model_->n_faces));
  std::iota(swept.begin(), swept.end(), 0);
  std::sort(swept.begin(), swept.end(), [this](int a, int b) {
    return box_[at(a)].min_x != box_[at(b)].min_x ? box_[at(a)].min_x < box_[at(b)].min_x : a < b;
  });
  std::vector<std::pair<int, int>> found;
  for (std::size_t i = 0; i < swept.size(); ++i) {
    const int a = swept[i];
    const BoxF& box = box_[at(a)];
    for (std::size_t j = i + 1; j < swept.size() && box_[at(swept[j])].min_x <= box.max_x; ++j) {
      const int b = swept[j];
      if (box_[at(b)].min_y > box.max_y || box.min_y > box_[at(b)].max_y) continue;
      if (faces_overlap(&world_[at(model_->first_vert(a))], a, b))
        found.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace netwright
