// Which of some things belong together, as more and more of them are joined. Path halving keeps every
// question next to free.
#pragma once

#include <numeric>
#include <utility>
#include <vector>

namespace netwright {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }

  [[nodiscard]] int find(int i) {
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
  }
  /// False when they were together already.
  bool join(int a, int b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    parent(std::max(a, b)) = std::min(a, b);
    return true;
  }

 private:
  int& parent(int i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<int> parent_;
};

}  // namespace netwright
