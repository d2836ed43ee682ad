// One buffer of triangles for all pages, and per page some batches of lines. Dashes are cut up here, so that
// they lie where the printer will put them; far away, where they would only flicker, lines are drawn whole.
#include "render/sheet_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "core/base/polygon2.h"
#include "render/gl.h"

namespace netwright {
namespace {

constexpr double kReadable_px = 4;    // letters smaller than this are left out
constexpr double kDashes_px = 1.6;    // pixels per mm from which dashes can be told apart
constexpr double kThinnest_px = 0.8;  // thinner lines would fade
constexpr double kNoLength = 1e-9;    // mm

std::array<std::uint8_t, 4> bytes_of(const glm::dvec3& colour) {
  const auto byte = [](double x) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(x, 0.0, 1.0)));
  };
  return {byte(colour.x), byte(colour.y), byte(colour.z), 255};
}

struct Pen {
  glm::dvec3 colour;
  double width_mm;
};

bool operator==(const Pen& a, const Pen& b) {
  return a.width_mm == b.width_mm && a.colour.x == b.colour.x && a.colour.y == b.colour.y &&
         a.colour.z == b.colour.z;
}

glm::vec3 lifted(glm::vec2 p) { return {p, 0.0F}; }

/// The inked parts of a polyline, `emit(from, to)` for each.
template <class Emit>
void walk_dashes(const std::vector<glm::dvec2>& points, const std::vector<double>& dash, double phase,
                 const Emit& emit) {
  const double period = std::accumulate(dash.begin(), dash.end(), 0.0);
  std::size_t part = 0;
  double left = 0;
  if (period > 0) {
    double into = std::fmod(phase, period);
    if (into < 0) into += period;
    while (into >= dash[part % dash.size()]) into -= dash[part++ % dash.size()];
    left = dash[part % dash.size()] - into;
  }
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double length = glm::distance(points[i], points[i + 1]);
    if (!(length > 0)) continue;
    const glm::dvec2 along = (points[i + 1] - points[i]) / length;
    for (double done = 0; done < length;) {
      const double step = std::min(left, length - done);
      if (part % 2 == 0) emit(points[i] + done * along, points[i] + (done + step) * along);
      done += step;
      left -= step;
      while (left <= kNoLength) left = dash[++part % dash.size()];
    }
  }
}

bool is_pattern(const std::vector<double>& dash) {
  constexpr double kShortest = 0.05;  // mm
  return dash.size() >= 2 && dash.size() % 2 == 0 &&
         std::accumulate(dash.begin(), dash.end(), 0.0) > kShortest;
}

}  // namespace

/// What a page is being put into.
struct SheetRenderer::Filling {
  std::vector<Vertex> vertices;
  glm::dvec2 corner_mm{0};
  double scale = 1;

  [[nodiscard]] glm::vec2 place(glm::dvec2 mm) const {
    const glm::dvec2 p = corner_mm + mm;
    return glm::vec2(glm::dvec2(p.x, -p.y) / scale);
  }
  void triangle(const std::array<glm::dvec2, 3>& mm, const std::array<std::uint8_t, 4>& colour) {
    for (const glm::dvec2 p : mm) vertices.push_back({place(p), {0, 0}, colour});
  }
  void quad(const std::array<glm::dvec2, 4>& mm, glm::vec2 uv_low, glm::vec2 uv_high,
            const std::array<std::uint8_t, 4>& colour) {
    const std::array<glm::vec2, 4> uv{uv_low, {uv_high.x, uv_low.y}, uv_high, {uv_low.x, uv_high.y}};
    for (const std::size_t k : {0U, 1U, 2U, 0U, 2U, 3U}) vertices.push_back({place(mm[k]), uv[k], colour});
  }
  void polygon(std::vector<glm::dvec2> mm, const std::array<std::uint8_t, 4>& colour) {
    if (mm.size() < 3) return;
    if (signed_area(mm) < 0) std::ranges::reverse(mm);
    if (!is_simple(mm)) return;
    for (const std::array<int, 3>& t : triangulate(mm))
      triangle({mm[static_cast<std::size_t>(t[0])], mm[static_cast<std::size_t>(t[1])],
                mm[static_cast<std::size_t>(t[2])]},
               colour);
  }
  [[nodiscard]] int count() const { return static_cast<int>(vertices.size()); }
};

SheetRenderer::SheetRenderer(const LineRenderer& lines) : lines_(lines), shader_("sheet") {
  constexpr std::size_t kStride = sizeof(Vertex);
  array_.attribute(0, buffer_, 2, AttributeType::Float, kStride, offsetof(Vertex, position));
  array_.attribute(1, buffer_, 2, AttributeType::Float, kStride, offsetof(Vertex, uv));
  array_.attribute(2, buffer_, 4, AttributeType::NormalizedByte, kStride, offsetof(Vertex, colour));
}

void SheetRenderer::clear() {
  pages_.clear();
  buffer_.stamp(0);
}

void SheetRenderer::set_sheets(std::span<const PlacedSheet> sheets, double scale, std::uint64_t version) {
  if (buffer_.holds(version)) return;
  scale_ = scale;
  pages_.clear();
  Filling filling;
  filling.scale = scale;
  for (const PlacedSheet& placed : sheets) add_page(placed, filling);
  std::erase_if(textures_, [](const auto& entry) { return entry.first.use_count() == 1; });
  buffer_.upload(std::as_bytes(std::span(filling.vertices)));
  buffer_.stamp(version);
  glyphs_.upload();
}

void SheetRenderer::add_page(const PlacedSheet& placed, Filling& filling) {
  const Sheet& sheet = *placed.sheet;
  filling.corner_mm = placed.corner_mm;
  Page& page = pages_.emplace_back();
  page.box.add(glm::dvec2(filling.place({0, 0})));
  page.box.add(glm::dvec2(filling.place({sheet.width_mm, sheet.height_mm})));
  page.clip = placed.clip;
  page.has_own_paper = placed.has_own_paper;
  page.first_fill = filling.count();
  if (placed.has_own_paper)
    filling.polygon({{0, 0}, {sheet.width_mm, 0}, {sheet.width_mm, sheet.height_mm}, {0, sheet.height_mm}},
                    {255, 255, 255, 255});
  for (const Fill& fill : sheet.fills) filling.polygon(fill.points, bytes_of(fill.colour));
  page.n_fill = filling.count() - page.first_fill;
  for (const Picture& picture : sheet.pictures) {
    if (!picture.image || picture.image->is_empty()) continue;
    page.pictures.push_back({filling.count(), &texture_of(picture.image)});
    const glm::dvec2 a = picture.at;
    const glm::dvec2 b = a + picture.size_mm;
    // The picture's first row is v = 1.
    filling.quad({a, glm::dvec2(b.x, a.y), b, glm::dvec2(a.x, b.y)}, {0, 1}, {1, 0}, {255, 255, 255, 255});
  }
  add_strokes(sheet, filling, page);
  add_letters(sheet, filling, page);
}

const Texture& SheetRenderer::texture_of(const std::shared_ptr<const Image>& image) {
  const auto [at, is_new] = textures_.try_emplace(image);
  if (is_new) at->second.upload(*image);
  return at->second;
}

void SheetRenderer::add_strokes(const Sheet& sheet, const Filling& filling, Page& page) {
  std::vector<Pen> known;
  std::vector<std::vector<LineSegment>> dashed;
  std::vector<std::vector<LineSegment>> plain;
  for (const Stroke& stroke : sheet.strokes) {
    const Pen pen{stroke.colour, stroke.width_mm};
    const auto found = std::ranges::find(known, pen);
    const auto number = static_cast<std::size_t>(found - known.begin());
    const bool is_new = found == known.end();
    if (is_new) known.push_back(pen);
    const std::size_t batch = number / kMaxLineStyles;
    const auto style = static_cast<std::uint32_t>(number % kMaxLineStyles);
    if (batch >= plain.size()) {
      plain.emplace_back();
      dashed.emplace_back();
      page.pens.emplace_back();
    }
    if (is_new) {
      LineStyle made;
      made.colour = Colour(glm::vec3(pen.colour), 1);
      made.width_px = static_cast<float>(pen.width_mm);
      page.pens[batch].styles.push_back(made);
    }
    std::vector<glm::dvec2> points = stroke.points;
    if (stroke.is_closed && !points.empty()) points.push_back(points.front());
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      plain[batch].push_back({lifted(filling.place(points[i])), lifted(filling.place(points[i + 1])), style});
    if (!is_pattern(stroke.dash_mm)) {
      dashed[batch].insert(
          dashed[batch].end(),
          plain[batch].end() - static_cast<std::ptrdiff_t>(points.empty() ? 0 : points.size() - 1),
          plain[batch].end());
      continue;
    }
    walk_dashes(points, stroke.dash_mm, stroke.dash_phase_mm, [&](glm::dvec2 a, glm::dvec2 b) {
      dashed[batch].push_back({lifted(filling.place(a)), lifted(filling.place(b)), style});
    });
  }
  for (std::size_t i = 0; i < page.pens.size(); ++i) {
    page.pens[i].plain->upload(plain[i], 1);
    page.pens[i].dashed->upload(dashed[i], 1);
  }
}

void SheetRenderer::add_letters(const Sheet& sheet, Filling& filling, Page& page) {
  std::vector<const Text*> texts;
  for (const Text& text : sheet.texts) texts.push_back(&text);
  std::ranges::stable_sort(texts, std::greater<>(), [](const Text* text) { return text->size_mm; });
  page.first_letter = filling.count();
  for (const Text* text : texts) {
    const glm::dvec2 along(std::cos(text->angle_rad), std::sin(text->angle_rad));
    const glm::dvec2 down(-along.y, along.x);
    double pen_em = 0;
    const auto place = [&](double x_em, double y_em) {
      return text->at + text->size_mm * ((pen_em + x_em) * along + y_em * down);
    };
    for (const std::string_view letter : letters_of(text->words)) {
      const GlyphAtlas::Glyph& glyph = glyphs_.glyph(text->weight, letter);
      if (glyph.has_ink())
        filling.quad({place(glyph.low.x, glyph.low.y), place(glyph.high.x, glyph.low.y),
                      place(glyph.high.x, glyph.high.y), place(glyph.low.x, glyph.high.y)},
                     glyph.uv_low, glyph.uv_high, bytes_of(text->colour));
      pen_em += glyph.advance_em;
    }
    const int end = filling.count() - page.first_letter;
    if (page.letters.empty() || page.letters.back().size_mm != text->size_mm)
      page.letters.push_back({text->size_mm, end});
    else
      page.letters.back().end = end;
  }
}

void SheetRenderer::draw(const PanZoomCamera& camera, const Palette& palette, float pixels_per_design_pixel) {
  n_letters_ = 0;
  const Box2 seen = camera.visible();
  for (const Page& page : pages_) {
    const Box2& box = page.box;
    const bool is_seen = box.max.x >= seen.min.x && box.min.x <= seen.max.x && box.max.y >= seen.min.y &&
                         box.min.y <= seen.max.y;
    if (is_seen) draw_page(page, camera, palette, pixels_per_design_pixel);
  }
}

void SheetRenderer::draw_letters(const Page& page, double px_per_mm) {
  int end = 0;
  for (const Letters& letters : page.letters)
    if (letters.size_mm * px_per_mm >= kReadable_px) end = letters.end;
  if (end == 0) return;
  n_letters_ += end / 6;
  shader_.set("kind", 1);
  glBindTexture(GL_TEXTURE_2D, glyphs_.texture());
  glDrawArrays(GL_TRIANGLES, page.first_letter, end);
}

void SheetRenderer::draw_page(const Page& page, const PanZoomCamera& camera, const Palette& palette,
                              float scale) {
  const double px_per_mm = camera.pixels_per_unit() / scale_;
  if (page.clip) {
    const glm::dvec2 low = camera.to_pixel(page.clip->min);
    const glm::dvec2 high = camera.to_pixel(page.clip->max);
    glScissor(static_cast<int>(std::floor(low.x)), static_cast<int>(std::floor(camera.size_px().y - low.y)),
              static_cast<int>(std::ceil(high.x - low.x)), static_cast<int>(std::ceil(low.y - high.y)));
    glEnable(GL_SCISSOR_TEST);
  }
  const auto use = [&] {
    shader_.use();
    shader_.set("clip_from_world", glm::mat4(camera.view_projection()));
    shader_.set("paper", palette.paper);
    shader_.set("pixels", 0);
    glActiveTexture(GL_TEXTURE0);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(array_.name());
  };
  use();
  shader_.set("kind", 0);
  glDrawArrays(GL_TRIANGLES, page.first_fill, page.n_fill);
  shader_.set("kind", 2);
  for (const PictureQuad& picture : page.pictures) {
    glBindTexture(GL_TEXTURE_2D, picture.texture->name());
    glDrawArrays(GL_TRIANGLES, picture.first, 6);
  }
  for (const Pens& pens : page.pens) {
    std::vector<LineStyle> styles = pens.styles;
    for (LineStyle& style : styles) {
      style.width_px = static_cast<float>(std::max(style.width_px * px_per_mm, kThinnest_px)) / scale;
      style.colour *= palette.paper;
    }
    const LineBatch& batch =
        px_per_mm >= kDashes_px * static_cast<double>(scale) ? *pens.dashed : *pens.plain;
    lines_.draw(batch, styles, look_through(camera, scale));
  }
  use();
  draw_letters(page, px_per_mm);
  if (page.clip) glDisable(GL_SCISSOR_TEST);
}

}  // namespace netwright
