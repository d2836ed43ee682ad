// Local search with chains of replacements. Collisions are only ever between neighbours, so a chain of a few
// cuts sees everything that a better choice could change.
#include "core/unfold/tab_choice.h"

#include <algorithm>
#include <array>
#include <glm/vector_relational.hpp>
#include <map>

namespace netwright {

namespace {

constexpr int kLongestChain = 4;
constexpr int kMostSweeps = 20;
constexpr int kMostLooks = 3000;  ///< options looked at for one cut and all that follows from it

Box2 box_of(const TabShape& shape) {
  Box2 box;
  for (const glm::dvec2 p : shape.polygon()) box.add(p);
  return box;
}

bool do_meet(const Box2& a, const Box2& b) {
  return glm::all(glm::lessThanEqual(a.min, b.max + kTabGap)) &&
         glm::all(glm::lessThanEqual(b.min, a.max + kTabGap));
}

class Choice {
 public:
  explicit Choice(const std::vector<std::vector<TabOption>>& cuts)
      : cuts_(cuts), chosen_(cuts.size(), -1), is_in_chain_(cuts.size(), 0) {
    find_neighbours();
    for (int cut = 0; cut < n_cuts(); ++cut) order_by_value(cut);
  }

  std::vector<int> run() {
    bool is_better = true;
    for (int sweep = 0; is_better && sweep < kMostSweeps; ++sweep) {
      is_better = false;
      for (int cut = 0; cut < n_cuts(); ++cut) is_better = improve(cut) || is_better;
    }
    return chosen_;
  }

 private:
  [[nodiscard]] int n_cuts() const { return static_cast<int>(cuts_.size()); }
  [[nodiscard]] const std::vector<TabOption>& options(int cut) const {
    return cuts_[static_cast<std::size_t>(cut)];
  }
  [[nodiscard]] int& chosen(int cut) { return chosen_[static_cast<std::size_t>(cut)]; }
  [[nodiscard]] double value(int cut, int option) const {
    return option < 0 ? 0 : options(cut)[static_cast<std::size_t>(option)].value;
  }

  /// Cuts of which some options' boxes meet, by a sweep from left to right.
  void find_neighbours() {
    neighbours_.resize(cuts_.size());
    std::vector<std::pair<Box2, int>> boxes;
    for (int cut = 0; cut < n_cuts(); ++cut) {
      // The options of one side lie in one place, those of the other elsewhere.
      std::map<HalfedgeId, Box2> by_side;
      for (const TabOption& option : options(cut)) by_side[option.side].add(box_of(option.shape));
      for (const auto& [side, box] : by_side) boxes.emplace_back(box, cut);
    }
    std::ranges::sort(boxes, {}, [](const auto& entry) { return entry.first.min.x; });
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t j = i + 1; j < boxes.size(); ++j) {
        if (boxes[j].first.min.x > boxes[i].first.max.x + kTabGap) break;
        if (boxes[i].second == boxes[j].second || !do_meet(boxes[i].first, boxes[j].first)) continue;
        neighbours_[static_cast<std::size_t>(boxes[i].second)].push_back(boxes[j].second);
        neighbours_[static_cast<std::size_t>(boxes[j].second)].push_back(boxes[i].second);
      }
    for (std::vector<int>& list : neighbours_) {
      std::ranges::sort(list);
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
  }

  void order_by_value(int cut) {
    std::vector<int> order(options(cut).size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::ranges::stable_sort(order, [&](int a, int b) { return value(cut, a) > value(cut, b); });
    by_value_.push_back(std::move(order));
  }

  bool do_collide(int a, int option_a, int b, int option_b) {
    const std::array<int, 4> key =
        a < b ? std::array{a, b, option_a, option_b} : std::array{b, a, option_b, option_a};
    const auto [entry, is_new] = collisions_.try_emplace(key, false);
    if (is_new)
      entry->second = tabs_collide(options(a)[static_cast<std::size_t>(option_a)].shape,
                                   options(b)[static_cast<std::size_t>(option_b)].shape);
    return entry->second;
  }

  std::vector<int> cuts_in_the_way(int cut, int option) {
    std::vector<int> found;
    for (const int other : neighbours_[static_cast<std::size_t>(cut)])
      if (chosen(other) >= 0 && do_collide(cut, option, other, chosen(other))) found.push_back(other);
    return found;
  }

  /// The best that the cut can do while it is in the chain: an option that gains more than it costs the cuts
  /// in its way, which look for something else themselves. Leaves the best choice in place; returns the sum
  /// of values won.
  double settle(int cut, int length) {
    const int before = chosen(cut);
    is_in_chain_[static_cast<std::size_t>(cut)] = 1;
    double best_gain = 0;
    std::vector<std::pair<int, int>> best_changes;
    chosen(cut) = -1;
    const double lost = value(cut, before);
    for (const int option : by_value_[static_cast<std::size_t>(cut)]) {
      if (value(cut, option) - lost <= best_gain || n_looks_ >= kMostLooks) break;
      ++n_looks_;
      const std::vector<int> in_the_way = cuts_in_the_way(cut, option);
      const bool is_open = length > 1 || in_the_way.empty();
      if (!is_open || std::ranges::any_of(in_the_way, [&](int other) { return is_fixed(other); })) continue;
      const std::size_t mark = trail_.size();
      set(cut, option);
      double gain = value(cut, option) - lost;
      for (const int other : in_the_way) {
        gain -= value(other, chosen(other));
        set(other, -1);
      }
      for (const int other : in_the_way) gain += settle(other, length - 1);
      if (gain > best_gain + 1e-9) {
        best_gain = gain;
        best_changes.assign(trail_.begin() + static_cast<std::ptrdiff_t>(mark), trail_.end());
        for (auto& [changed, to] : best_changes) to = chosen(changed);
      }
      take_back(mark);
    }
    chosen(cut) = before;
    for (const auto& [changed, to] : best_changes) set(changed, to);
    is_in_chain_[static_cast<std::size_t>(cut)] = 0;
    return best_gain;
  }
  [[nodiscard]] bool is_fixed(int cut) const { return is_in_chain_[static_cast<std::size_t>(cut)] != 0; }

  void set(int cut, int option) {
    trail_.emplace_back(cut, chosen(cut));
    chosen(cut) = option;
  }
  void take_back(std::size_t mark) {
    while (trail_.size() > mark) {
      chosen(trail_.back().first) = trail_.back().second;
      trail_.pop_back();
    }
  }

  bool improve(int cut) {
    trail_.clear();
    n_looks_ = 0;
    if (options(cut).empty()) return false;
    if (chosen(cut) >= 0 && chosen(cut) == by_value_[static_cast<std::size_t>(cut)].front()) return false;
    return settle(cut, kLongestChain) > 1e-9;
  }

  const std::vector<std::vector<TabOption>>& cuts_;
  std::vector<int> chosen_;
  std::vector<char> is_in_chain_;
  std::vector<std::vector<int>> neighbours_;
  std::vector<std::vector<int>> by_value_;
  std::map<std::array<int, 4>, bool> collisions_;
  int n_looks_ = 0;
  std::vector<std::pair<int, int>> trail_;  ///< what was chosen before, newest last
};

}  // namespace

std::vector<int> choose_tabs(const std::vector<std::vector<TabOption>>& cuts) { return Choice(cuts).run(); }

}  // namespace netwright
