// Skyline packing: each page remembers the upper edge of what lies on it as steps, and every rectangle, the
// largest first, goes where its own upper edge ends lowest.
#include "core/sheet/pack.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace netwright {

namespace {

class Skyline {
 public:
  explicit Skyline(glm::dvec2 page) : page_(page), steps_{{0, 0, page.x}} {}

  struct Spot {
    glm::dvec2 at{0, 0};
    double top = std::numeric_limits<double>::infinity();
    bool is_turned = false;
  };

  [[nodiscard]] std::optional<Spot> find(glm::dvec2 size) const {
    Spot best;
    for (const bool is_turned : {false, true}) {
      const glm::dvec2 s = is_turned ? glm::dvec2(size.y, size.x) : size;
      for (std::size_t i = 0; i < steps_.size(); ++i) {
        const double y = height_over(i, s.x);
        if (y + s.y <= page_.y && y + s.y < best.top) best = {{steps_[i].x, y}, y + s.y, is_turned};
      }
    }
    return best.top <= page_.y ? std::optional(best) : std::nullopt;
  }

  void fill(const Spot& spot, glm::dvec2 size) {
    const double width = spot.is_turned ? size.y : size.x;
    const double end = spot.at.x + width;
    std::vector<Step> steps;
    for (const Step& step : steps_)
      if (step.x < spot.at.x) steps.push_back({step.x, step.y, std::min(step.width, spot.at.x - step.x)});
    steps.push_back({spot.at.x, spot.top, width});
    for (const Step& step : steps_) {
      const double start = std::max(step.x, end);
      if (step.x + step.width > start) steps.push_back({start, step.y, step.x + step.width - start});
    }
    steps_ = std::move(steps);
  }

 private:
  struct Step {
    double x;
    double y;
    double width;
  };

  /// How low a rectangle of this width can lie when it starts at step i.
  [[nodiscard]] double height_over(std::size_t i, double width) const {
    const double end = steps_[i].x + width;
    if (end > page_.x) return std::numeric_limits<double>::infinity();
    double y = 0;
    for (; i < steps_.size() && steps_[i].x < end; ++i) y = std::max(y, steps_[i].y);
    return y;
  }

  glm::dvec2 page_;
  std::vector<Step> steps_;
};

}  // namespace

std::vector<Packed> pack(const std::vector<glm::dvec2>& sizes, glm::dvec2 page, double gap) {
  // Every rectangle carries its gap along two sides; the page grows by the gap that its border does not need.
  const glm::dvec2 room = page + gap + 1e-9;
  std::vector<std::size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::max(sizes[a].x, sizes[a].y) > std::max(sizes[b].x, sizes[b].y);
  });
  std::vector<Packed> result(sizes.size());
  std::vector<Skyline> pages;
  for (const std::size_t i : order) {
    const glm::dvec2 size = sizes[i] + gap;
    for (std::size_t p = 0;; ++p) {
      const bool is_new = p == pages.size();
      if (is_new) pages.emplace_back(room);
      if (const auto spot = pages[p].find(size)) {
        pages[p].fill(*spot, size);
        result[i] = {static_cast<int>(p), spot->at, spot->is_turned};
        break;
      }
      if (is_new) throw std::logic_error("a rectangle to be packed is larger than the page");
    }
  }
  return result;
}

}  // namespace netwright
