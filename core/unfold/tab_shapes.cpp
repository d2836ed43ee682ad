// In a side's own frame (side along x, its outside upwards) a trapezoid is told by its height and the two
// angles at its base. What stands in the way is a set of segments; each has to stay left of the one slanted
// end or right of the other, so the best pair of angles for a height is found by sorting.
#include "core/unfold/tab_shapes.h"

#include <algorithm>
#include <cmath>
#include <glm/vector_relational.hpp>

namespace netwright {

namespace {

constexpr double kStepsOfWidth = 6;     ///< between the wished width and the least one
constexpr double kSameCornerMm = 1e-6;  ///< two ends of sides are one corner of the paper
constexpr double kLeastRim = 0.1;       ///< mm; a shorter rim becomes a point
constexpr double kPi = 3.14159265358979323846;

/// An obstacle in the frame of the side, and the steepest angles that pass it on either hand.
struct Obstacle {
  double left = kPi;   ///< the tab's angle at the beginning must not exceed this for the obstacle to lie left
  double right = kPi;  ///< likewise at the end
};

struct Angles {
  double from = 0;
  double to = 0;
};

struct Frame {
  glm::dvec2 origin;
  glm::dvec2 along;
  glm::dvec2 out;
  double length;

  explicit Frame(const SideGrid::Side& side)
      : origin(side.from), along(side.to - side.from), out(0), length(glm::length(along)) {
    along /= length;
    out = {along.y, -along.x};
  }
  [[nodiscard]] glm::dvec2 local(glm::dvec2 p) const {
    return {glm::dot(p - origin, along), glm::dot(p - origin, out)};
  }
  [[nodiscard]] glm::dvec2 world(double x, double y) const { return origin + x * along + y * out; }
};

struct LocalSegment {
  glm::dvec2 a;
  glm::dvec2 b;
};

/// A wedge between two sides that meet in a corner is not used to its last bit: one cut would serve two rims.
double within_wedge(double opening_rad) { return opening_rad - std::min(0.01, 0.1 * opening_rad); }

class ShapeMaker {
 public:
  ShapeMaker(const Frame& frame, const TabWish& wish) : frame_(frame), wish_(wish) {}

  void add_obstacle(glm::dvec2 a, glm::dvec2 b) { segments_.push_back({frame_.local(a), frame_.local(b)}); }

  /// Shapes of all widths; at each, with the whole wedge at both ends or half of it at one or both.
  void make(bool lands_inside, std::vector<TabShape>& shapes) const {
    const double most = std::min(wish_.width_mm, frame_.length / 2);
    if (most < kLeastTabWidth * (1 - 1e-9)) return;
    for (int step = 0; step <= kStepsOfWidth; ++step) {
      const double width = most + (kLeastTabWidth - most) * step / kStepsOfWidth;
      for (const Angles& share : {Angles{1, 1}, Angles{1, 0.5}, Angles{0.5, 1}, Angles{0.5, 0.5}})
        add_shape(width, share, lands_inside, shapes);
      if (most <= kLeastTabWidth) return;
    }
  }

  /// Is there one of kLeastTabWidth?
  [[nodiscard]] bool has_narrowest() const {
    std::vector<TabShape> shapes;
    add_shape(kLeastTabWidth, {1, 1}, true, shapes);
    return !shapes.empty();
  }

 private:
  /// What of a segment is level with a tab of this height.
  [[nodiscard]] bool obstacle_of(const LocalSegment& segment, double width, Obstacle& obstacle) const {
    const double high = width + kTabGap;
    glm::dvec2 a = segment.a;
    glm::dvec2 b = segment.b;
    if (a.y > b.y) std::swap(a, b);
    if (a.y >= high) return false;
    if (b.y <= kSameCornerMm) {
      // A side that lies on this one and runs against it leaves no room at all.
      const bool is_against = segment.a.x > segment.b.x && std::max(-a.y, -b.y) <= kSameCornerMm;
      const bool is_clear = segment.a.x <= kSameCornerMm || segment.b.x >= frame_.length - kSameCornerMm;
      obstacle = {0, 0};
      return is_against && !is_clear;
    }
    const bool starts_at_from = glm::length(a) < kSameCornerMm;
    const bool starts_at_to = glm::length(a - glm::dvec2(frame_.length, 0)) < kSameCornerMm;
    const auto at_height = [&](double y) { return a + (b - a) * ((y - a.y) / (b.y - a.y)); };
    const glm::dvec2 low = a.y < 0 ? at_height(0) : a;
    const glm::dvec2 top = b.y > high ? at_height(high) : b;
    obstacle.left = left_angle(top, starts_at_from);
    obstacle.right = right_angle(top, starts_at_to);
    if (!starts_at_from) obstacle.left = std::min(obstacle.left, left_angle(low, false));
    if (!starts_at_to) obstacle.right = std::min(obstacle.right, right_angle(low, false));
    return true;
  }
  [[nodiscard]] static double left_angle(glm::dvec2 p, bool is_wedge) {
    return is_wedge ? within_wedge(std::atan2(p.y, p.x)) : std::atan2(std::max(p.y, 0.0), p.x + kTabGap);
  }
  [[nodiscard]] double right_angle(glm::dvec2 p, bool is_wedge) const {
    const double x = frame_.length - p.x;
    return is_wedge ? within_wedge(std::atan2(p.y, x)) : std::atan2(std::max(p.y, 0.0), x + kTabGap);
  }

  [[nodiscard]] std::vector<Obstacle> obstacles_at(double width) const {
    std::vector<Obstacle> obstacles;
    for (const LocalSegment& segment : segments_)
      if (Obstacle obstacle; obstacle_of(segment, width, obstacle)) obstacles.push_back(obstacle);
    std::ranges::sort(obstacles, {}, &Obstacle::left);
    return obstacles;
  }

  /// The angles that leave the longest rim at this height; zero when there are none.
  [[nodiscard]] Angles best_angles(double width, const Angles& share) const {
    const std::vector<Obstacle> obstacles = obstacles_at(width);
    Angles best;
    double best_slant = std::numeric_limits<double>::infinity();
    double right = wish_.to_angle_rad;
    // With the first k obstacles on the right, all others have to be on the left.
    for (std::size_t k = 0; k <= obstacles.size(); ++k) {
      if (k > 0) right = std::min(right, obstacles[k - 1].right * share.to);
      double left = wish_.from_angle_rad;
      if (k < obstacles.size()) left = std::min(left, obstacles[k].left * share.from);
      if (left < 1e-3 || right < 1e-3) continue;
      const double slant = 1 / std::tan(left) + 1 / std::tan(right);
      if (slant < best_slant) {
        best_slant = slant;
        best = {left, right};
      }
    }
    return best;
  }

  void add_shape(double width, const Angles& share, bool lands_inside, std::vector<TabShape>& shapes) const {
    const Angles angles = best_angles(width, share);
    if (angles.from == 0) return;
    const double left = width / std::tan(angles.from);
    const double right = frame_.length - width / std::tan(angles.to);
    if (right < left - 1e-9 * frame_.length) return;
    TabShape shape;
    shape.width_mm = width;
    shape.rim_share = std::max(0.0, right - left) / frame_.length;
    shape.lands_inside = lands_inside;
    shape.n_points = right - left < kLeastRim ? 3 : 4;
    shape.points = {frame_.world(frame_.length, 0), frame_.world(0, 0), frame_.world(left, width),
                    frame_.world(right, width)};
    if (shape.n_points == 3) shape.points[2] = frame_.world((left + right) / 2, width);
    const auto is_same = [&](const TabShape& other) {
      return other.width_mm == width && other.lands_inside == lands_inside &&
             other.points[2] == shape.points[2] && other.points[3] == shape.points[3];
    };
    if (std::ranges::none_of(shapes, is_same)) shapes.push_back(shape);
  }

  const Frame& frame_;
  const TabWish& wish_;
  std::vector<LocalSegment> segments_;
};

}  // namespace

SideGrid::SideGrid(std::vector<Side> sides, double cell_mm) : sides_(std::move(sides)), cell_mm_(cell_mm) {
  for (const Side& side : sides_) {
    box_.add(side.from);
    box_.add(side.to);
  }
  constexpr double kMostCells = 1000;
  cell_mm_ = std::max(cell_mm_, std::max(box_.size().x, box_.size().y) / kMostCells);
  n_cells_ = glm::ivec2(box_.size() / cell_mm_) + 1;
  buckets_.resize(bucket(0, n_cells_.y));
  for (int i = 0; i < static_cast<int>(sides_.size()); ++i) {
    const glm::ivec2 low = cell_of(glm::min(side(i).from, side(i).to));
    const glm::ivec2 high = cell_of(glm::max(side(i).from, side(i).to));
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) buckets_[bucket(x, y)].push_back(i);
  }
}

glm::ivec2 SideGrid::cell_of(glm::dvec2 p) const {
  const glm::dvec2 cell = glm::floor((p - box_.min) / cell_mm_);
  return {static_cast<int>(glm::clamp(cell.x, 0.0, n_cells_.x - 1.0)),
          static_cast<int>(glm::clamp(cell.y, 0.0, n_cells_.y - 1.0))};
}

std::size_t SideGrid::bucket(int x, int y) const {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(n_cells_.x) + static_cast<std::size_t>(x);
}

std::vector<int> SideGrid::near(const Box2& box) const {
  const glm::ivec2 low = cell_of(box.min);
  const glm::ivec2 high = cell_of(box.max);
  std::vector<int> found;
  for (int y = low.y; y <= high.y; ++y)
    for (int x = low.x; x <= high.x; ++x) {
      const std::vector<int>& here = buckets_[bucket(x, y)];
      found.insert(found.end(), here.begin(), here.end());
    }
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

namespace {

/// All that stands near the side.
ShapeMaker with_obstacles(const SideGrid& sides, const SideGrid::Side& side, const Frame& frame,
                          const TabWish& wish, double width) {
  Box2 reach;
  for (const double y : {-kTabGap, width + kTabGap}) {
    reach.add(frame.world(-kTabGap, y));
    reach.add(frame.world(frame.length + kTabGap, y));
  }
  ShapeMaker maker(frame, wish);
  for (const int i : sides.near(reach))
    if (sides.side(i).h != side.h) maker.add_obstacle(sides.side(i).from, sides.side(i).to);
  return maker;
}

bool is_long_enough(const Frame& frame) { return frame.length >= 2 * kLeastTabWidth * (1 - 1e-9); }

}  // namespace

std::vector<TabShape> tab_shapes(const SideGrid& sides, const SideGrid::Side& side, const TabWish& wish,
                                 std::span<const glm::dvec2> partner) {
  const Frame frame(side);
  std::vector<TabShape> shapes;
  if (!is_long_enough(frame)) return shapes;
  const ShapeMaker anywhere =
      with_obstacles(sides, side, frame, wish, std::min(wish.width_mm, frame.length / 2));
  ShapeMaker inside = anywhere;
  for (std::size_t k = 1; k < partner.size(); ++k)
    inside.add_obstacle(partner[k], partner[(k + 1) % partner.size()]);
  inside.make(true, shapes);
  if (shapes.empty() && !partner.empty()) anywhere.make(false, shapes);
  return shapes;
}

bool has_room_for_tab(const SideGrid& sides, const SideGrid::Side& side, const TabWish& wish) {
  const Frame frame(side);
  if (!is_long_enough(frame)) return false;
  return with_obstacles(sides, side, frame, wish, kLeastTabWidth).has_narrowest();
}

bool tabs_collide(const TabShape& a, const TabShape& b) {
  bool is_joined = false;
  for (const int i : {0, 1})
    for (const int j : {0, 1})
      is_joined = is_joined || glm::length(a.points[static_cast<std::size_t>(i)] -
                                           b.points[static_cast<std::size_t>(j)]) < kSameCornerMm;
  const double least = is_joined ? -1e-9 : kTabGap;
  const auto is_apart = [&](std::span<const glm::dvec2> p, std::span<const glm::dvec2> q) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      const glm::dvec2 d = p[(i + 1) % p.size()] - p[i];
      const glm::dvec2 out = glm::dvec2(d.y, -d.x) / glm::length(d);
      double distance = std::numeric_limits<double>::infinity();
      for (const glm::dvec2 x : q) distance = std::min(distance, glm::dot(x - p[i], out));
      if (distance >= least) return true;
    }
    return false;
  };
  return !is_apart(a.polygon(), b.polygon()) && !is_apart(b.polygon(), a.polygon());
}

}  // namespace netwright
