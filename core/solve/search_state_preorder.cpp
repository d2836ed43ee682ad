// The preorder of the search's tree: made once per start tree, mended after every move. Only the moved side
// is walked again; what lies between its old and its new place is shifted.
#include <algorithm>

#include "core/solve/search_state.h"

namespace netwright {

void SearchState::build_preorder() {
  up_[0] = -1;
  traverse(0, order_);
  for (std::size_t i = 0; i < order_.size(); ++i) position_[at(order_[i])] = static_cast<int>(i);
}

// The subtree below `top`, whose way up is known, in preorder, with every face's way up and number of
// descendants.
void SearchState::traverse(int top, std::vector<int>& order) {
  const SearchModel& m = *model_;
  order.clear();
  stack_.clear();
  stack_.push_back(top);
  while (!stack_.empty()) {
    const int f = stack_.back();
    stack_.pop_back();
    order.push_back(f);
    size_[at(f)] = 1;
    const int up = up_[at(f)];
    for (int h = m.face_begin[at(f)]; h < m.face_begin[at(f) + 1]; ++h) {
      if (!is_fold_[at(h)] || h == up) continue;
      const int t = m.twin[at(h)];
      up_[at(m.face_of[at(t)])] = t;
      stack_.push_back(m.face_of[at(t)]);
    }
  }
  for (std::size_t i = order.size(); i-- > 1;) size_[at(m.beyond(up_[at(order[i])]))] += size_[at(order[i])];
}

void SearchState::find_path(int from, int to, std::vector<PathStep>& path) const {
  path.clear();
  while (!in_subtree(to, from)) {
    const int parent = model_->beyond(up_[at(from)]);
    path.push_back({from, parent, from, true});
    from = parent;
  }
  const auto turn = static_cast<std::ptrdiff_t>(path.size());
  while (to != from) {
    const int parent = model_->beyond(up_[at(to)]);
    path.push_back({parent, to, to, false});
    to = parent;
  }
  std::reverse(path.begin() + turn, path.end());
}

// Where in the preorder the side may go below its new parent: the boundary between two of its children (or
// its end) that is nearest to where the side is now, so that little has to be shifted.
int SearchState::insertion_place(int parent, const Exchange& exchange) const {
  if (position(parent) >= exchange.last) return position(parent) + 1;
  if (end(parent) <= exchange.first) return end(parent);
  int child = order_[at(exchange.first)];  // the parent is above the side: find its child that holds the side
  for (int above = model_->beyond(up_[at(child)]); above != parent; above = model_->beyond(up_[at(child)]))
    child = above;
  return exchange.first - position(child) < end(child) - exchange.last ? position(child) : end(child);
}

// Mends the preorder: the side hangs below another face now, by another of its own faces.
void SearchState::relink(const Exchange& exchange) {
  const SearchModel& m = *model_;
  const int n_moved = exchange.last - exchange.first;
  const int old_parent = m.beyond(up_[at(order_[at(exchange.first)])]);
  const int own = m.face_of[at(exchange.inserted)];
  const bool own_is_in_side = position(own) >= exchange.first && position(own) < exchange.last;
  const int link = own_is_in_side ? exchange.inserted : m.twin[at(exchange.inserted)];
  const int parent = m.beyond(link);
  const int place = insertion_place(parent, exchange);
  for (const int h : {exchange.removed, exchange.inserted})
    is_fold_[at(h)] = is_fold_[at(m.twin[at(h)])] = h == exchange.inserted ? 1 : 0;

  const auto add_to_sizes = [&](int f, int change) {
    for (; f >= 0; f = up_[at(f)] < 0 ? -1 : m.beyond(up_[at(f)])) size_[at(f)] += change;
  };
  add_to_sizes(old_parent, -n_moved);
  add_to_sizes(parent, n_moved);
  up_[at(m.face_of[at(link)])] = link;
  traverse(m.face_of[at(link)], moved_order_);

  const auto put = [&](int i, int f) {
    order_[at(i)] = f;
    position_[at(f)] = i;
  };
  if (place <= exchange.first) {
    for (int i = exchange.first - 1; i >= place; --i) put(i + n_moved, order_[at(i)]);
    for (int i = 0; i < n_moved; ++i) put(place + i, moved_order_[at(i)]);
    gather_boxes(place, exchange.last);
  } else {
    for (int i = exchange.last; i < place; ++i) put(i - n_moved, order_[at(i)]);
    for (int i = 0; i < n_moved; ++i) put(place - n_moved + i, moved_order_[at(i)]);
    gather_boxes(exchange.first, place);
  }
}

}  // namespace netwright
