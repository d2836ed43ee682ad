// Faces are rasterised side by side without any blending at their edges, so no seam can show. What lies past
// the outline takes the colour of the nearest painted pixel, which grows outwards pixel by pixel.
#include "core/sheet/piece_pictures.h"

#include <algorithm>
#include <cmath>

#include "core/base/polygon2.h"
#include "core/sheet/picture_canvas.h"

namespace netwright {

namespace {

constexpr double kMmPerInch = 25.4;
constexpr double kMostBleed = 3;
constexpr double kMostPixels = 120e6;  // on a page: A1 at 300 dpi has 70 million

/// As many as asked for, fewer on paper so large that its picture would not fit into memory.
double pixels_per_mm(const PictureSettings& settings, const PageFrame& frame) {
  const glm::dvec2 size = frame.net.size();
  return std::min(settings.dpi / kMmPerInch, std::sqrt(kMostPixels / std::max(size.x * size.y, 1.0)));
}

double twice_area(const std::array<glm::dvec2, 3>& p) { return std::abs(cross(p[1] - p[0], p[2] - p[0])); }

/// A polygon with its sides moved outwards; its corners may run on by twice that.
std::vector<glm::dvec2> grown(std::vector<glm::dvec2> polygon, double by) {
  if (signed_area(polygon) < 0) std::ranges::reverse(polygon);
  const std::size_t n = polygon.size();
  std::vector<glm::dvec2> result;
  const auto normal = [&](std::size_t i) {
    const glm::dvec2 d = glm::normalize(polygon[(i + 1) % n] - polygon[i]);
    return glm::dvec2(d.y, -d.x);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 before = normal((i + n - 1) % n);
    const glm::dvec2 after = normal(i);
    const glm::dvec2 sum = before + after;
    const double reach = std::min(2 / std::max(glm::dot(sum, sum), 1e-9), 2.0);
    result.push_back(polygon[i] + sum * (by * reach));
  }
  return result;
}

}  // namespace

PictureArtist::PictureArtist(const Net& net, const PageLayout& layout, const SheetSettings& settings)
    : net_(net),
      layout_(layout),
      settings_(settings.pictures),
      is_grey_(settings.is_grey),
      paint_(net_.mesh()),
      has_pictures_(settings.pictures.is_on && !paint_.is_plain()),
      pixels_per_mm_(pixels_per_mm(settings.pictures, layout.frame)) {
  if (!has_pictures_) return;
  settings_.bleed_mm = std::clamp(settings_.bleed_mm, 0.0, kMostBleed);
  const Mesh& mesh = net.mesh();
  faces_.resize(static_cast<std::size_t>(net.n_pieces));
  tabs_.resize(faces_.size());
  triangles_.resize(mesh.n_faces());
  for (const FaceId f : mesh.faces()) {
    faces_[static_cast<std::size_t>(net.piece[f])].push_back(f);
    std::vector<glm::dvec2> polygon;
    for (const HalfedgeId h : mesh.halfedges(f)) polygon.push_back(net.corner(h));
    triangles_[f] = triangulate(polygon);
  }
  for (const GlueTab& tab : layout_.tabs.tabs)
    tabs_[static_cast<std::size_t>(net.piece[mesh.face(tab.side)])].push_back(&tab);
}

Box2 PictureArtist::reach(int piece, const Box2& part) const {
  const auto p = static_cast<std::size_t>(piece);
  Box2 whole;
  const auto add = [&](Box2 box) {
    box.min = glm::max(box.min - settings_.bleed_mm, part.min);
    box.max = glm::min(box.max + settings_.bleed_mm, part.max);
    if (box.min.x < box.max.x && box.min.y < box.max.y) whole.add(box);
  };
  for (const FaceId f : faces_[p]) {
    Box2 box;
    for (const HalfedgeId h : net_.mesh().halfedges(f)) box.add(layout_.on_canvas(piece, net_.corner(h)));
    add(box);
  }
  for (const GlueTab* const tab : tabs_[p]) {
    Box2 box;
    for (const glm::dvec2 point : tab->points) box.add(layout_.on_canvas_mm(piece, point));
    add(box);
  }
  return whole;
}

std::shared_ptr<const Image> PictureArtist::paint(const Window& window) const {
  const Mesh& mesh = net_.mesh();
  const int piece = window.piece;
  const auto p = static_cast<std::size_t>(piece);
  const auto pixel = [&](glm::dvec2 on_canvas) { return (on_canvas - window.corner) * pixels_per_mm_; };
  PictureCanvas canvas(window.width, window.height);
  for (const FaceId f : faces_[p])
    for (const std::array<int, 3>& triangle : triangles_[f]) {
      std::array<glm::dvec2, 3> at{};
      std::array<glm::dvec2, 3> uv{};
      for (std::size_t i = 0; i < 3; ++i) {
        const HalfedgeId h(mesh.first(f).value + triangle[i]);
        at[i] = pixel(layout_.on_canvas(piece, net_.corner(h)));
        if (mesh.has_uv()) uv[i] = mesh.uv(h);
      }
      const ImageSize size = paint_.texture_size(f);
      const double texels = twice_area(uv) * size.width * size.height;
      const double area = std::max(twice_area(at), 1e-12);
      canvas.paint_triangle(at, uv, paint_.coat(f, std::sqrt(texels / area)));
    }
  using OnTabs = PictureSettings::OnTabs;
  if (settings_.on_tabs != OnTabs::White)
    for (const GlueTab* const tab : tabs_[p]) {
      std::vector<glm::dvec2> polygon;
      for (const glm::dvec2 point : tab->points) polygon.push_back(pixel(layout_.on_canvas_mm(piece, point)));
      canvas.open(grown(std::move(polygon), settings_.bleed_mm * pixels_per_mm_));
    }
  canvas.grow(settings_.bleed_mm * pixels_per_mm_, settings_.on_tabs == OnTabs::Faded);
  Image image = std::move(canvas).image(is_grey_);
  if (window.is_mirrored) mirror(image);
  return std::make_shared<const Image>(std::move(image));
}

void PictureArtist::draw(Sheet& sheet, const PageView& view) const {
  if (!has_pictures_) return;
  const Box2 page = view.window();
  for (int piece = 0; piece < net_.n_pieces; ++piece) {
    if (layout_.pieces[static_cast<std::size_t>(piece)].canvas != view.page.canvas) continue;
    const Box2 part = reach(piece, page);
    if (part.is_empty()) continue;
    const glm::dvec2 pixels = glm::floor((part.max - part.min) * pixels_per_mm_);
    if (pixels.x < 1 || pixels.y < 1) continue;
    const Window window{piece, part.min, static_cast<int>(pixels.x), static_cast<int>(pixels.y),
                        view.is_mirrored};
    const glm::dvec2 size = pixels / pixels_per_mm_;
    const glm::dvec2 at = view.at(part.min) - glm::dvec2(view.is_mirrored ? size.x : 0, 0);
    sheet.pictures.push_back({Layer::Print, at, size, paint(window),
                              [self = shared_from_this(), window] { return self->paint(window); }});
  }
}

}  // namespace netwright
