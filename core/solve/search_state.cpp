// Keeps placements and overlaps in step with the tree. A move changes only overlaps between its two sides, so
// the smaller side asks and the larger answers: boxes of 256 and of 16 neighbours in preorder, then boxes of
// faces, then the separating-axis test. A side is an interval of the preorder, so belonging to it is a bit
// mask.
#include "core/solve/search_state.h"

#include <algorithm>
#include <bit>

namespace netwright {

namespace {

// Does b reach deeper than `depth` to the inner side of every edge line of a? See convex_overlap in
// unfold/overlap.h.
bool reaches_into(const glm::dvec2* a, int n_a, const glm::dvec2* b, int n_b, double depth) {
  for (int i = 0; i < n_a; ++i) {
    const glm::dvec2 p = a[i];
    const glm::dvec2 q = a[i + 1 < n_a ? i + 1 : 0];
    const double dx = q.x - p.x;
    const double dy = q.y - p.y;
    const double least = depth * (std::abs(dx) + std::abs(dy));
    bool reaches = false;
    for (int j = 0; j < n_b; ++j) reaches = reaches || dx * (b[j].y - p.y) - dy * (b[j].x - p.x) > least;
    if (!reaches) return false;
  }
  return true;
}

BoxF box_around(const glm::dvec2* first, const glm::dvec2* last) {
  double min_x = first->x;
  double max_x = first->x;
  double min_y = first->y;
  double max_y = first->y;
  for (const glm::dvec2* p = first + 1; p < last; ++p) {
    min_x = std::min(min_x, p->x);
    max_x = std::max(max_x, p->x);
    min_y = std::min(min_y, p->y);
    max_y = std::max(max_y, p->y);
  }
  return BoxF::around(min_x, min_y, max_x, max_y);
}

// The box of a moved box.
BoxF moved_box(const BoxF& box, const Rigid2& m) {
  const glm::dvec2 centre = m({0.5 * (static_cast<double>(box.min_x) + box.max_x),
                               0.5 * (static_cast<double>(box.min_y) + box.max_y)});
  const double ex = 0.5 * (static_cast<double>(box.max_x) - box.min_x);
  const double ey = 0.5 * (static_cast<double>(box.max_y) - box.min_y);
  const double w = std::abs(m.cos) * ex + std::abs(m.sin) * ey;
  const double h = std::abs(m.sin) * ex + std::abs(m.cos) * ey;
  return BoxF::around(centre.x - w, centre.y - h, centre.x + w, centre.y + h);
}

// Bits of a block's positions that lie in first … last-1.
unsigned range_mask(int block, int first, int last) {
  const int low = std::clamp(first - 16 * block, 0, 16);
  const int high = std::clamp(last - 16 * block, 0, 16);
  return high > low ? ((1U << high) - 1U) & ~((1U << low) - 1U) : 0U;
}

}  // namespace

SearchState::SearchState(const SearchModel& model, double depth, const BoxKernel& kernel, bool uses_killers)
    : model_(&model), depth_(depth), kernel_(&kernel), uses_killers_(uses_killers) {
  const auto n = at(model.n_faces);
  placement_.resize(n);
  world_.resize(model.verts.size());
  box_.resize(n);
  n_overlaps_.assign(n, 0);
  overlapping_index_.assign(n, -1);
  order_.resize(n);
  position_.resize(n);
  size_.resize(n);
  up_.resize(n);
  lanes_.resize(model.n_faces);
  block_lanes_.resize((model.n_faces + 15) / 16);
  group_lanes_.resize((model.n_faces + 255) / 256);
  hit_groups_.resize(group_lanes_.min_x.size());
  hit_blocks_.resize(block_lanes_.min_x.size());
  killers_.assign(at(model.n_halfedges), -1);
}

void SearchState::set_tree(std::vector<char> is_fold) {
  is_fold_ = std::move(is_fold);
  placement_[0] = Rigid2();
  recompute();
}

void SearchState::recompute() {
  place_from_tree();
  find_all_pairs();
}

void SearchState::place_face(int f, const Rigid2& placement) {
  placement_[at(f)] = placement;
  const int first = model_->first_vert(f);
  const int last = model_->last_vert(f);
  for (int v = first; v < last; ++v) world_[at(v)] = placement(model_->verts[at(v)]);
  box_[at(f)] = box_around(&world_[at(first)], world_.data() + last);
}

void SearchState::place_from_tree() {
  build_preorder();
  for (const int f : order_) {
    if (up_[at(f)] < 0) {
      place_face(f, placement_[at(f)]);
    } else {
      const int down = model_->twin[at(up_[at(f)])];
      place_face(f, placement_[at(model_->face_of[at(down)])] * model_->unroll[at(down)]);
    }
  }
  gather_boxes(0, model_->n_faces);
}

void SearchState::gather_boxes(int first, int last) {
  const int n = model_->n_faces;
  for (int b = first / 16; b * 16 < last; ++b) {
    BoxF all;
    for (int i = b * 16; i < std::min(n, b * 16 + 16); ++i) {
      const BoxF& box = box_[at(order_[at(i)])];
      lanes_.set(i, box);
      all.add(box);
    }
    block_lanes_.set(b, all);
  }
  for (int g = first / 256; g * 256 < last; ++g) {
    BoxF all;
    for (int b = g * 16; b < std::min((n + 15) / 16, g * 16 + 16); ++b) all.add(block_lanes_.get(b));
    group_lanes_.set(g, all);
  }
}

bool SearchState::faces_overlap(const glm::dvec2* moved, int moved_face, int face) const {
  const SearchModel& m = *model_;
  const int base = m.first_vert(moved_face);
  for (int i = m.part_begin[at(moved_face)]; i < m.part_begin[at(moved_face) + 1]; ++i) {
    const glm::dvec2* a = moved + (m.vert_begin[at(i)] - base);
    const int n_a = m.vert_begin[at(i) + 1] - m.vert_begin[at(i)];
    for (int j = m.part_begin[at(face)]; j < m.part_begin[at(face) + 1]; ++j) {
      const glm::dvec2* b = world_.data() + m.vert_begin[at(j)];
      const int n_b = m.vert_begin[at(j) + 1] - m.vert_begin[at(j)];
      if (reaches_into(a, n_a, b, n_b, depth_) && reaches_into(b, n_b, a, n_a, depth_)) return true;
    }
  }
  return false;
}

unsigned SearchState::side_mask(int block) const {
  const unsigned side = range_mask(block, side_first_, side_last_);
  return queries_side_ ? ~side & 0xFFFFU : side;
}

// The face's vertices where the motion brings them, and the box around them.
BoxF SearchState::move_query(int face) {
  const int first = model_->first_vert(face);
  const int last = model_->last_vert(face);
  moved_.resize(at(last - first));
  for (int v = first; v < last; ++v) moved_[at(v - first)] = motion_(world_[at(v)]);
  return box_around(moved_.data(), moved_.data() + moved_.size());
}

void SearchState::find_hit_blocks(const BoxF& box) {
  n_hit_blocks_ = 0;
  const int n = kernel_->find(group_lanes_, box, hit_groups_.data());
  for (int i = 0; i < n; ++i) {
    const int group = hit_groups_[at(i)];
    for (unsigned hits = kernel_->hits(block_lanes_, group, box); hits != 0; hits &= hits - 1) {
      const int block = 16 * group + std::countr_zero(hits);
      if (side_mask(block) != 0) hit_blocks_[at(n_hit_blocks_++)] = block;
    }
  }
}

template <class Visit>
bool SearchState::visit_query_face(int face, Visit&& visit) {
  const BoxF box = move_query(face);
  for (int i = 0; i < n_hit_blocks_; ++i) {
    const int b = hit_blocks_[at(i)];
    unsigned hits = kernel_->hits(lanes_, b, box) & side_mask(b);
    while (hits != 0) {
      const int other = order_[at(16 * b + std::countr_zero(hits))];
      hits &= hits - 1;
      if (faces_overlap(moved_.data(), face, other) && !visit(face, other)) return false;
    }
  }
  return true;
}

template <class Visit>
bool SearchState::visit_query_block(int block, unsigned members, int killer, Visit&& visit) {
  find_hit_blocks((members & (members - 1)) == 0
                      ? moved_box(lanes_.get(16 * block + std::countr_zero(members)), motion_)
                      : moved_box(block_lanes_.get(block), motion_));
  if (n_hit_blocks_ == 0) return true;
  for (; members != 0; members &= members - 1) {
    const int face = order_[at(16 * block + std::countr_zero(members))];
    if (face != killer && !visit_query_face(face, visit)) return false;
  }
  return true;
}

template <class Visit>
bool SearchState::visit_killer(int face, Visit&& visit) {
  find_hit_blocks(move_query(face));
  return visit_query_face(face, visit);
}

// Calls visit(a, b) for every face a of the asking side that overlaps a face b of the other one after the
// motion, until it returns false. The killer, when it is on the asking side, comes first.
template <class Visit>
void SearchState::visit_meetings(const Exchange& exchange, int killer, Visit&& visit) {
  const int n = model_->n_faces;
  side_first_ = exchange.first;
  side_last_ = exchange.last;
  queries_side_ = 2 * (exchange.last - exchange.first) <= n;
  motion_ = queries_side_ ? exchange.motion : exchange.motion.inverse();
  if (killer >= 0) {
    const bool is_in_side = position(killer) >= side_first_ && position(killer) < side_last_;
    if (is_in_side != queries_side_) killer = -1;
  }
  if (killer >= 0 && !visit_killer(killer, visit)) return;
  for (int b = queries_side_ ? side_first_ / 16 : 0; 16 * b < (queries_side_ ? side_last_ : n); ++b) {
    const unsigned side = range_mask(b, side_first_, side_last_);
    const unsigned members = queries_side_ ? side : ~side & range_mask(b, 0, n);
    if (members != 0 && !visit_query_block(b, members, killer, visit)) return;
  }
}

Exchange SearchState::exchange(int child, int removed, int inserted) const {
  const SearchModel& m = *model_;
  const int face = m.face_of[at(inserted)];
  const int twin = m.twin[at(inserted)];
  const Rigid2 there = placement_[at(m.face_of[at(twin)])] * m.unroll[at(twin)];
  Exchange exchange;
  exchange.first = position(child);
  exchange.last = end(child);
  exchange.motion =
      in_subtree(face, child) ? there * placement(face).inverse() : placement(face) * there.inverse();
  exchange.removed = removed;
  exchange.inserted = inserted;
  return exchange;
}

int SearchState::count_after(const Exchange& exchange, int limit) {
  int count = 0;
  int& killer = killers_[at(exchange.inserted)];
  visit_meetings(exchange, uses_killers_ ? killer : -1, [&](int asking, int) {
    if (++count < limit) return true;
    killer = asking;
    return false;
  });
  return count;
}

void SearchState::apply(const Exchange& exchange) {
  std::vector<std::pair<int, int>> gained;
  visit_meetings(exchange, -1, [&](int a, int b) {
    gained.emplace_back(std::min(a, b), std::max(a, b));
    return true;
  });
  drop_crossing_pairs(exchange);
  std::sort(gained.begin(), gained.end());  // so that nothing depends on the order in which blocks were asked
  for (const auto& pair : gained) {
    pairs_.push_back(pair);
    count_face(pair.first, 1);
    count_face(pair.second, 1);
  }
  const int n = model_->n_faces;
  for (int i = queries_side_ ? exchange.first : 0; i < (queries_side_ ? exchange.last : n); ++i) {
    if (!queries_side_ && i == exchange.first) i = exchange.last;
    if (i < n) place_face(order_[at(i)], motion_ * placement_[at(order_[at(i)])]);
  }
  relink(exchange);
  if (!queries_side_) gather_boxes(0, n);
}

void SearchState::drop_crossing_pairs(const Exchange& exchange) {
  const auto in_side = [&](int f) {
    return position_[at(f)] >= exchange.first && position_[at(f)] < exchange.last;
  };
  std::size_t kept = 0;
  for (const auto& pair : pairs_) {
    if (in_side(pair.first) == in_side(pair.second)) {
      pairs_[kept++] = pair;
    } else {
      count_face(pair.first, -1);
      count_face(pair.second, -1);
    }
  }
  pairs_.resize(kept);
}

void SearchState::count_face(int f, int change) {
  int& n = n_overlaps_[at(f)];
  int& index = overlapping_index_[at(f)];
  n += change;
  if (n > 0 && index < 0) {
    index = static_cast<int>(overlapping_.size());
    overlapping_.push_back(f);
  } else if (n == 0 && index >= 0) {
    const int last = overlapping_.back();
    overlapping_[at(index)] = last;
    overlapping_index_[at(last)] = index;
    overlapping_.pop_back();
    overlapping_index_[at(f)] = -1;
  }
}

void SearchState::set_pairs(std::vector<std::pair<int, int>> pairs) {
  for (const int f : overlapping_) {
    n_overlaps_[at(f)] = 0;
    overlapping_index_[at(f)] = -1;
  }
  overlapping_.clear();
  pairs_ = std::move(pairs);
  for (const auto& pair : pairs_) {
    count_face(pair.first, 1);
    count_face(pair.second, 1);
  }
}

void SearchState::find_all_pairs() { set_pairs(sweep()); }

}  // namespace netwright
