// The scale at which a net fits, and its picture, which is filled row by row with several samples a pixel.
#include "core/project/net_measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/best_angle.h"
#include "core/base/error.h"
#include "core/base/polygon2.h"
#include "core/sheet/page_frame.h"
#include "core/unfold/net_size.h"

namespace netwright {

namespace {

using Hull = std::vector<glm::dvec2>;

double area_of(glm::dvec2 size) { return size.x * size.y; }

std::vector<glm::dvec2> corners_of(const Net& net, FaceId f) {
  std::vector<glm::dvec2> corners;
  for (const HalfedgeId h : net.mesh().halfedges(f)) corners.push_back(net.corner(h));
  return corners;
}

/// The largest scale at which the hull fits the room.
double fitting_scale(const Hull& hull, glm::dvec2 room) {
  const auto cost = [&](glm::dvec2 size) { return std::max(size.x / room.x, size.y / room.y); };
  return 1 / cost(turned_box(hull, best_angle(hull, cost)).size());
}

double print_scale(const NetMeasures& measures, const PaperSetup& paper, const PrintSize& size) {
  if (size.kind == PrintSize::Kind::Height) return size.height_mm / measures.model_height;
  if (size.kind == PrintSize::Kind::Scale) return size.scale;
  if (size.kind != PrintSize::Kind::FitPage) return 0;
  double scale = 0;
  for (const PageFrame& frame : possible_frames(paper))
    scale = std::max(scale, fitting_scale(measures.hulls.front(), frame.net.size()));
  return scale;
}

/// Samples on a fine grid, taken together to pixels at the end.
class Canvas {
 public:
  Canvas(int width_px, int height_px, const Box2& box)
      : width_px_(width_px),
        height_px_(height_px),
        width_(width_px * kSamples),
        height_(height_px * kSamples) {
    const glm::dvec2 size = box.size();
    const double margin = 2.0 * kSamples;
    scale_ =
        std::min((width_ - margin) / std::max(size.x, 1e-300), (height_ - margin) / std::max(size.y, 1e-300));
    origin_ = box.centre() - glm::dvec2(width_, height_) / (2 * scale_);
    samples_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0);
  }

  /// Fills the samples whose middle lies inside, by the even-odd rule.
  void fill(const std::vector<glm::dvec2>& corners) {
    Box2 box;
    for (const glm::dvec2 p : corners) box.add(to_grid(p));
    const int first = std::max(0, static_cast<int>(std::ceil(box.min.y - 0.5)));
    const int last = std::min(height_ - 1, static_cast<int>(std::floor(box.max.y - 0.5)));
    for (int row = first; row <= last; ++row) fill_row(corners, row);
  }

  [[nodiscard]] Image image() const {
    Image image{width_px_, height_px_, {}};
    for (int y = 0; y < height_px_; ++y)
      for (int x = 0; x < width_px_; ++x) {
        const auto opacity = static_cast<std::uint8_t>(255 * count(x, y) / (kSamples * kSamples));
        image.rgba.insert(image.rgba.end(), {255, 255, 255, opacity});
      }
    return image;
  }

 private:
  static constexpr int kSamples = 4;  ///< per pixel, each way

  [[nodiscard]] glm::dvec2 to_grid(glm::dvec2 p) const {
    const glm::dvec2 q = (p - origin_) * scale_;
    return {q.x, height_ - q.y};
  }

  void fill_row(const std::vector<glm::dvec2>& corners, int row) {
    const double y = row + 0.5;
    crossings_.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const glm::dvec2 a = to_grid(corners[i]);
      const glm::dvec2 b = to_grid(corners[(i + 1) % corners.size()]);
      if ((a.y > y) != (b.y > y)) crossings_.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
    }
    std::sort(crossings_.begin(), crossings_.end());
    for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2) {
      const int from = std::max(0, static_cast<int>(std::ceil(crossings_[i] - 0.5)));
      const int to = std::min(width_ - 1, static_cast<int>(std::floor(crossings_[i + 1] - 0.5)));
      for (int x = from; x <= to; ++x) samples_[index(x, row)] = 1;
    }
  }

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  [[nodiscard]] int count(int x, int y) const {
    int n = 0;
    for (int i = 0; i < kSamples * kSamples; ++i)
      n += samples_[index(x * kSamples + i % kSamples, y * kSamples + i / kSamples)];
    return n;
  }

  int width_px_;
  int height_px_;
  int width_;
  int height_;
  double scale_;
  glm::dvec2 origin_{0, 0};
  std::vector<char> samples_;
  std::vector<double> crossings_;
};

}  // namespace

NetMeasures measure(const Net& net) {
  const Mesh& mesh = net.mesh();
  NetMeasures measures;
  measures.n_pieces = net.n_pieces;
  measures.model_height = mesh.height();
  measures.hulls = piece_hulls(net);
  measures.cut_length = cut_length(net);
  double paper = 0;
  for (const FaceId f : mesh.faces()) paper += std::abs(signed_area(corners_of(net, f)));
  const double rectangles = paper_area(measures.hulls);
  measures.fill = rectangles > 0 ? std::min(1.0, paper / rectangles) : 0;
  return measures;
}

std::optional<glm::dvec2> size_on_paper(const NetMeasures& measures, const PaperSetup& paper,
                                        const PrintSize& size) {
  if (measures.n_pieces != 1) return std::nullopt;
  double scale = 0;
  try {
    scale = print_scale(measures, paper, size);
  } catch (const Error&) {
    return std::nullopt;  // the paper's own panel says what is wrong with it
  }
  if (!std::isfinite(scale) || scale <= 0) return std::nullopt;
  const Hull& hull = measures.hulls.front();
  const glm::dvec2 box = turned_box(hull, best_angle(hull, area_of)).size() * scale;
  return glm::dvec2(std::max(box.x, box.y), std::min(box.x, box.y));
}

Image net_picture(const Net& net, int width_px, int height_px) {
  const Net spread = spread_pieces(net);
  Hull points;
  for (const FaceId f : spread.mesh().faces())
    for (const HalfedgeId h : spread.mesh().halfedges(f)) points.push_back(spread.corner(h));
  const Hull hull = convex_hull(std::move(points));
  // Lying: what is longest goes from left to right.
  const double angle = best_angle(hull, area_of);
  const glm::dvec2 size = turned_box(hull, angle).size();
  const Rigid2 turn = Rigid2::rotation(angle + (size.y > size.x ? std::acos(-1.0) / 2 : 0));
  Box2 box;
  for (const glm::dvec2 p : hull) box.add(turn(p));
  Canvas canvas(width_px, height_px, box);
  for (const FaceId f : spread.mesh().faces()) {
    std::vector<glm::dvec2> corners = corners_of(spread, f);
    for (glm::dvec2& p : corners) p = turn(p);
    canvas.fill(corners);
  }
  return canvas.image();
}

}  // namespace netwright
