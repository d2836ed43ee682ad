// PDF and PNG through cairo, and the bundled typeface through FreeType. One routine draws a sheet in
// millimetres; the surface decides how many points or pixels that is.
#include <cairo-ft.h>
#include <cairo-pdf.h>
#include <cairo.h>
#include <ft2build.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "assets/assets.h"
#include "core/base/error.h"
#include "core/sheet/font.h"
#include "core/sheet/patch_bytes.h"
#include "core/sheet/print_preferences.h"
#include "core/sheet/write.h"

namespace netwright {

namespace {

constexpr double kMmPerInch = 25.4;
constexpr double kPointsPerMm = 72 / kMmPerInch;

/// A face and the library it lives in; the bytes are part of the program.
class Typeface {
 public:
  explicit Typeface(FontWeight weight) {
    const std::span<const std::byte> bytes = asset(
        weight == FontWeight::Regular ? "assets/fonts/Inter-Regular.otf" : "assets/fonts/Inter-SemiBold.otf");
    if (FT_Init_FreeType(&library_) != 0) throw std::runtime_error("FreeType does not start");
    if (FT_New_Memory_Face(library_, reinterpret_cast<const FT_Byte*>(bytes.data()),
                           static_cast<FT_Long>(bytes.size()), 0, &face_) != 0) {
      FT_Done_FreeType(library_);
      throw std::runtime_error("the bundled font is damaged");
    }
  }
  ~Typeface() {
    FT_Done_Face(face_);
    FT_Done_FreeType(library_);
  }
  Typeface(const Typeface&) = delete;
  Typeface& operator=(const Typeface&) = delete;
  [[nodiscard]] FT_Face face() const { return face_; }

 private:
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
};

template <auto destroy>
struct Destroyer {
  template <class T>
  void operator()(T* object) const {
    destroy(object);
  }
};
using Surface = std::unique_ptr<cairo_surface_t, Destroyer<cairo_surface_destroy>>;
using Context = std::unique_ptr<cairo_t, Destroyer<cairo_destroy>>;
using FontFace = std::unique_ptr<cairo_font_face_t, Destroyer<cairo_font_face_destroy>>;

/// cairo keeps font faces in caches of its own, so the typeface lives until cairo lets go of it.
FontFace cairo_face(FontWeight weight) {
  static const cairo_user_data_key_t key{};
  auto typeface = std::make_unique<Typeface>(weight);
  FontFace face(cairo_ft_font_face_create_for_ft_face(typeface->face(), FT_LOAD_NO_HINTING));
  const auto release = [](void* data) { delete static_cast<Typeface*>(data); };
  if (cairo_font_face_set_user_data(face.get(), &key, typeface.get(), release) != CAIRO_STATUS_SUCCESS)
    throw std::bad_alloc();
  static_cast<void>(typeface.release());
  return face;
}

/// cairo wants colours multiplied by their opacity, in words of the machine's own byte order.
Surface cairo_image(const Image& image) {
  Surface surface(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height));
  unsigned char* const rows = cairo_image_surface_get_data(surface.get());
  if (rows == nullptr) throw std::bad_alloc();
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  const std::uint8_t* from = image.rgba.data();
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y)
    for (std::size_t x = 0; x < static_cast<std::size_t>(image.width); ++x, from += 4) {
      const std::uint32_t alpha = from[3];
      const auto part = [&](std::size_t c) { return (from[c] * alpha + 127U) / 255U; };
      const std::uint32_t word = alpha << 24U | part(0) << 16U | part(1) << 8U | part(2);
      std::memcpy(rows + y * stride + 4 * x, &word, 4);
    }
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

/// Draws sheets onto a context whose unit is the millimetre.
class Painter {
 public:
  explicit Painter(cairo_t* cr) : cr_(cr) {}

  void draw(const Sheet& sheet) {
    for (const Fill& fill : sheet.fills) {
      trace(fill.points, true);
      set_colour(fill.colour);
      cairo_fill(cr_);
    }
    for (const Picture& picture : sheet.pictures)
      if (const auto image = picture.pixels(); image && !image->is_empty()) show(picture, *image);
    cairo_set_line_cap(cr_, CAIRO_LINE_CAP_BUTT);
    cairo_set_line_join(cr_, CAIRO_LINE_JOIN_ROUND);
    for (const Stroke& stroke : sheet.strokes) {
      trace(stroke.points, stroke.is_closed);
      set_colour(stroke.colour);
      cairo_set_line_width(cr_, stroke.width_mm);
      cairo_set_dash(cr_, stroke.dash_mm.data(), static_cast<int>(stroke.dash_mm.size()),
                     stroke.dash_phase_mm);
      cairo_stroke(cr_);
    }
    for (const Text& text : sheet.texts) {
      cairo_set_font_face(cr_, text.weight == FontWeight::Regular ? regular_.get() : semi_bold_.get());
      cairo_set_font_size(cr_, text.size_mm);
      set_colour(text.colour);
      cairo_save(cr_);
      cairo_translate(cr_, text.at.x, text.at.y);
      cairo_rotate(cr_, text.angle_rad);
      cairo_move_to(cr_, 0, 0);
      cairo_show_text(cr_, clean_utf8(text.words).c_str());
      cairo_restore(cr_);
    }
  }

 private:
  /// One image object with as many pixels as the picture has; what scales it is the page's matrix.
  void show(const Picture& picture, const Image& image) {
    const Surface surface = cairo_image(image);
    cairo_save(cr_);
    cairo_translate(cr_, picture.at.x, picture.at.y);
    cairo_scale(cr_, picture.size_mm.x / image.width, picture.size_mm.y / image.height);
    cairo_set_source_surface(cr_, surface.get(), 0, 0);
    cairo_paint(cr_);
    cairo_restore(cr_);
  }

  void trace(const std::vector<glm::dvec2>& points, bool is_closed) {
    cairo_new_path(cr_);
    for (const glm::dvec2 p : points) cairo_line_to(cr_, p.x, p.y);
    if (is_closed) cairo_close_path(cr_);
  }
  void set_colour(const glm::dvec3& c) { cairo_set_source_rgb(cr_, c.x, c.y, c.z); }

  cairo_t* cr_;
  FontFace regular_ = cairo_face(FontWeight::Regular);
  FontFace semi_bold_ = cairo_face(FontWeight::SemiBold);
};

cairo_status_t append_bytes(void* target, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(target)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error(ErrorKind::Write,
                std::string("The page cannot be drawn: ") + cairo_status_to_string(status) + ".");
}

void set_no_hinting(cairo_t* cr) {
  cairo_font_options_t* const options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(cr, options);
  cairo_font_options_destroy(options);
}

int add_outline(std::vector<Font::Step>& steps, FT_Outline& outline, double scale, glm::dvec2 at) {
  struct Target {
    std::vector<Font::Step>& steps;
    double scale;
    glm::dvec2 at;
    glm::dvec2 last{0, 0};
    [[nodiscard]] glm::dvec2 map(const FT_Vector* p) const {
      return at + scale * glm::dvec2(static_cast<double>(p->x), -static_cast<double>(p->y));
    }
    void end_at(char kind, glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
      steps.push_back({kind, {a, b, c}});
      last = kind == 'C' ? c : a;
    }
  } target{steps, scale, at};
  FT_Outline_Funcs calls{};
  calls.move_to = [](const FT_Vector* p, void* data) {
    Target& t = *static_cast<Target*>(data);
    if (!t.steps.empty() && t.steps.back().kind != 'Z') t.steps.push_back({'Z', {}});
    t.end_at('M', t.map(p), {}, {});
    return 0;
  };
  calls.line_to = [](const FT_Vector* p, void* data) {
    Target& t = *static_cast<Target*>(data);
    t.end_at('L', t.map(p), {}, {});
    return 0;
  };
  calls.conic_to = [](const FT_Vector* control, const FT_Vector* p, void* data) {
    Target& t = *static_cast<Target*>(data);
    const glm::dvec2 c = t.map(control);
    const glm::dvec2 end = t.map(p);
    t.end_at('C', (t.last + 2.0 * c) / 3.0, (end + 2.0 * c) / 3.0, end);
    return 0;
  };
  calls.cubic_to = [](const FT_Vector* a, const FT_Vector* b, const FT_Vector* p, void* data) {
    Target& t = *static_cast<Target*>(data);
    t.end_at('C', t.map(a), t.map(b), t.map(p));
    return 0;
  };
  const int status = FT_Outline_Decompose(&outline, &calls, &target);
  if (!steps.empty() && steps.back().kind != 'Z') steps.push_back({'Z', {}});
  return status;
}

/// Back pages are turned like the page of a book: over the long edge of upright paper, the short one of
/// lying.
Duplex duplex_of(std::span<const Sheet> sheets) {
  const auto back = std::ranges::find(sheets, true, &Sheet::is_back);
  if (back == sheets.end()) return Duplex::None;
  return back->width_mm > back->height_mm ? Duplex::FlipShortEdge : Duplex::FlipLongEdge;
}

}  // namespace

struct Font::Impl {
  explicit Impl(FontWeight weight) : typeface(weight) {}

  /// Loads the glyph unscaled, so that nothing is rounded, and returns its advance in em.
  double load(char32_t code) const {
    FT_Face const face = typeface.face();
    if (FT_Load_Glyph(face, FT_Get_Char_Index(face, code), FT_LOAD_NO_SCALE) != 0) return 0;
    return static_cast<double>(face->glyph->metrics.horiAdvance) / face->units_per_EM;
  }

  Typeface typeface;
};

Font::Font(FontWeight weight) : impl_(std::make_unique<Impl>(weight)) {}
Font::~Font() = default;
Font::Font(Font&&) noexcept = default;
Font& Font::operator=(Font&&) noexcept = default;

double Font::width(std::string_view words, double size_mm) const {
  double width_em = 0;
  for (const char32_t code : code_points(words)) width_em += impl_->load(code);
  return width_em * size_mm;
}

std::vector<Font::Step> Font::outline(std::string_view words, double size_mm, glm::dvec2 at) const {
  std::vector<Step> steps;
  FT_Face const face = impl_->typeface.face();
  for (const char32_t code : code_points(words)) {
    const double advance_em = impl_->load(code);
    if (face->glyph->format == FT_GLYPH_FORMAT_OUTLINE &&
        add_outline(steps, face->glyph->outline, size_mm / face->units_per_EM, at) != 0)
      throw std::runtime_error("the bundled font is damaged");
    at.x += advance_em * size_mm;
  }
  return steps;
}

std::string pdf_bytes(std::span<const Sheet> sheets, const std::string& title) {
  std::string bytes;
  const Surface surface(cairo_pdf_surface_create_for_stream(append_bytes, &bytes, 100, 100));
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_TITLE, clean_utf8(title).c_str());
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATOR, "Netwright");
  // No date: the same net gives the same bytes on any day.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  {
    const Context cr(cairo_create(surface.get()));
    set_no_hinting(cr.get());
    Painter painter(cr.get());
    for (const Sheet& sheet : sheets) {
      cairo_pdf_surface_set_size(surface.get(), sheet.width_mm * kPointsPerMm,
                                 sheet.height_mm * kPointsPerMm);
      cairo_identity_matrix(cr.get());
      cairo_scale(cr.get(), kPointsPerMm, kPointsPerMm);
      painter.draw(sheet);
      cairo_show_page(cr.get());
    }
    check(cairo_status(cr.get()));
  }
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
  return with_print_preferences(bytes, duplex_of(sheets));
}

std::string png_bytes(const Sheet& sheet, double dpi) {
  const double pixels_per_mm = dpi / kMmPerInch;
  const auto pixels = [&](double mm) { return static_cast<int>(std::lround(mm * pixels_per_mm)); };
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels(sheet.width_mm), pixels(sheet.height_mm)));
  {
    const Context cr(cairo_create(surface.get()));
    cairo_set_source_rgb(cr.get(), 1, 1, 1);
    cairo_paint(cr.get());
    cairo_scale(cr.get(), pixels_per_mm, pixels_per_mm);
    set_no_hinting(cr.get());
    Painter(cr.get()).draw(sheet);
    check(cairo_status(cr.get()));
  }
  std::string bytes;
  check(cairo_surface_write_to_png_stream(surface.get(), append_bytes, &bytes));
  return with_resolution(std::move(bytes), dpi);
}

}  // namespace netwright
