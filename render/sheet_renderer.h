// Draws finished sheets as they will be printed: fills, pictures, lines in their colours and dashes, letters.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/sheet/sheet.h"
#include "render/camera.h"
#include "render/glyph_atlas.h"
#include "render/line_renderer.h"

namespace netwright {

/// A sheet and where it lies on the desk.
struct PlacedSheet {
  const Sheet* sheet = nullptr;
  glm::dvec2 corner_mm{0};        ///< of its top left, in the desk's millimetres, y down
  std::optional<Box2> clip = {};  ///< in the desk's units: only this of it is shown
  bool has_own_paper = false;     ///< nobody else draws the paper under it
};

class SheetRenderer {
 public:
  explicit SheetRenderer(const LineRenderer& lines);
  /// Takes sheets over; does nothing when `version` (not 0) is what it holds already. `scale`: mm per unit of
  /// the desk.
  void set_sheets(std::span<const PlacedSheet> sheets, double scale, std::uint64_t version);
  void clear();
  [[nodiscard]] bool is_empty() const { return pages_.empty(); }
  void draw(const PanZoomCamera& camera, const Palette& palette, float pixels_per_design_pixel);
  /// How many letters were drawn in the last picture: those too small to be read are left out.
  [[nodiscard]] int n_letters() const { return n_letters_; }

 private:
  struct Vertex {
    glm::vec2 position;
    glm::vec2 uv;
    std::array<std::uint8_t, 4> colour;
  };
  /// Part of a buffer of lines that one set of styles covers.
  struct Pens {
    std::vector<LineStyle> styles;  ///< widths in mm
    std::unique_ptr<LineBatch> dashed = std::make_unique<LineBatch>();
    std::unique_ptr<LineBatch> plain = std::make_unique<LineBatch>();
  };
  struct PictureQuad {
    int first = 0;
    const Texture* texture = nullptr;
  };
  struct Letters {
    double size_mm = 0;
    int end = 0;  ///< of the page's letters, counted in vertices from their first
  };
  struct Page {
    Box2 box;
    std::optional<Box2> clip;
    bool has_own_paper = false;
    int first_fill = 0;
    int n_fill = 0;
    std::vector<PictureQuad> pictures;
    std::vector<Pens> pens;
    int first_letter = 0;
    std::vector<Letters> letters;  ///< largest first
  };
  struct Filling;

  void add_page(const PlacedSheet& placed, Filling& filling);
  void add_strokes(const Sheet& sheet, const Filling& filling, Page& page);
  void add_letters(const Sheet& sheet, Filling& filling, Page& page);
  const Texture& texture_of(const std::shared_ptr<const Image>& image);
  void draw_page(const Page& page, const PanZoomCamera& camera, const Palette& palette, float scale);
  void draw_letters(const Page& page, double px_per_mm);

  const LineRenderer& lines_;
  Shader shader_;
  GlyphAtlas glyphs_;
  Buffer buffer_;
  VertexArray array_;
  double scale_ = 1;
  std::vector<Page> pages_;
  /// Pictures on the card, those of the sheets before included until the next ones are there.
  std::map<std::shared_ptr<const Image>, Texture> textures_;
  int n_letters_ = 0;
};

}  // namespace netwright
