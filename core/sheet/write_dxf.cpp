// DXF as release 12 had it, which every cutter's program reads: one unit is one millimetre, y up, one layer
// per kind of line. What is only printed (title, ruler, pictures) stays out.
#include <algorithm>
#include <array>
#include <numbers>
#include <string>

#include "core/sheet/number_text.h"
#include "core/sheet/vector_parts.h"
#include "core/sheet/write.h"

namespace netwright {

namespace {

struct DxfLayer {
  Layer layer;
  const char* name;
  int colour;  ///< of AutoCAD's index
};
constexpr std::array<DxfLayer, 6> kLayers = {{{Layer::Regmarks, "REG", 7},
                                              {Layer::Mountain, "FOLD_M", 5},
                                              {Layer::Valley, "FOLD_V", 3},
                                              {Layer::TabFold, "FOLD_TAB", 6},
                                              {Layer::Labels, "LABEL", 8},
                                              {Layer::Cut, "CUT", 1}}};

/// Pairs of a group code and its value, a line each: all that a DXF file consists of.
class DxfWriter {
 public:
  explicit DxfWriter(double height_mm) : height_mm_(height_mm) {}

  void add(int code, const std::string& value) { text_ += std::to_string(code) + "\n" + value + "\n"; }
  void add(int code, int value) { add(code, std::to_string(value)); }
  void add(int code, double value) {
    std::string number = decimal_number(value, 6);
    if (number.find('.') == std::string::npos) number += ".0";
    add(code, number);
  }
  void add_point(glm::dvec2 on_page) {
    add(10, on_page.x);
    add(20, height_mm_ - on_page.y);
    add(30, 0.0);
  }
  void begin_section(const std::string& name) {
    add(0, "SECTION");
    add(2, name);
  }
  void end_section() { add(0, "ENDSEC"); }

  void add_line(const DxfLayer& layer, const Line& points, bool is_closed) {
    if (points.size() == 2 && !is_closed) {
      add(0, "LINE");
      add(8, layer.name);
      add_point(points[0]);
      add(11, points[1].x);
      add(21, height_mm_ - points[1].y);
      add(31, 0.0);
      return;
    }
    add(0, "POLYLINE");
    add(8, layer.name);
    add(66, 1);
    add(10, 0.0);
    add(20, 0.0);
    add(30, 0.0);
    add(70, is_closed ? 1 : 0);
    for (const glm::dvec2 p : points) {
      add(0, "VERTEX");
      add(8, layer.name);
      add_point(p);
    }
    add(0, "SEQEND");
    add(8, layer.name);
  }

  void add_text(const DxfLayer& layer, const Text& text) {
    constexpr double kCapHeight = 0.727;  // of Inter's em; DXF measures letters by their capitals
    add(0, "TEXT");
    add(8, layer.name);
    add_point(text.at);
    add(40, text.size_mm * kCapHeight);
    add(1, plain(text.words));
    if (text.angle_rad != 0) add(50, -text.angle_rad * 180 / std::numbers::pi);
  }

  std::string take() { return std::move(text_); }

 private:
  /// Release 12 knows no UTF-8: other signs by their number.
  static std::string plain(const std::string& words) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string out;
    for (const char32_t code : code_points(clean_utf8(words))) {
      if (code >= 0x20 && code < 0x7f) {
        out += static_cast<char>(code);
      } else {
        out += "\\U+";
        for (const unsigned shift : {12U, 8U, 4U, 0U}) out += kDigits[(code >> shift) & 15U];
      }
    }
    return out;
  }

  double height_mm_;
  std::string text_;
};

void write_header(DxfWriter& dxf, const SheetRow& row) {
  dxf.begin_section("HEADER");
  dxf.add(9, "$ACADVER");
  dxf.add(1, "AC1009");
  dxf.add(9, "$INSUNITS");
  dxf.add(70, 4);  // millimetres
  dxf.add(9, "$MEASUREMENT");
  dxf.add(70, 1);  // metric
  dxf.add(9, "$EXTMIN");
  dxf.add_point({0, row.height_mm});
  dxf.add(9, "$EXTMAX");
  dxf.add_point({row.width_mm, 0});
  dxf.end_section();
}

void write_tables(DxfWriter& dxf) {
  dxf.begin_section("TABLES");
  dxf.add(0, "TABLE");
  dxf.add(2, "LTYPE");
  dxf.add(70, 1);
  dxf.add(0, "LTYPE");
  dxf.add(2, "CONTINUOUS");
  dxf.add(70, 64);
  dxf.add(3, "Solid line");
  dxf.add(72, 65);
  dxf.add(73, 0);
  dxf.add(40, 0.0);
  dxf.add(0, "ENDTAB");
  dxf.add(0, "TABLE");
  dxf.add(2, "LAYER");
  dxf.add(70, static_cast<int>(kLayers.size()));
  for (const DxfLayer& layer : kLayers) {
    dxf.add(0, "LAYER");
    dxf.add(2, layer.name);
    dxf.add(70, 0);
    dxf.add(62, layer.colour);
    dxf.add(6, "CONTINUOUS");
  }
  dxf.add(0, "ENDTAB");
  dxf.end_section();
}

void write_layer(DxfWriter& dxf, const DxfLayer& layer, const Sheet& sheet, const ExportSettings& settings,
                 const std::array<Font, 2>& fonts) {
  for (const Fill& fill : sheet.fills)
    if (fill.layer == layer.layer) dxf.add_line(layer, fill.points, true);
  for (const Stroke& stroke : sheet.strokes) {
    if (stroke.layer != layer.layer || stroke.points.size() < 2) continue;
    if (!settings.real_dashes || stroke.dash_mm.empty()) {
      dxf.add_line(layer, stroke.points, stroke.is_closed);
    } else {
      for (const Line& part : inked_lines(stroke)) dxf.add_line(layer, part, false);
    }
  }
  for (const Text& text : sheet.texts) {
    if (text.layer != layer.layer) continue;
    if (settings.live_text) {
      dxf.add_text(layer, text);
    } else {
      for (const Line& polygon : text_polygons(text, fonts[text.weight == FontWeight::Regular ? 0 : 1]))
        dxf.add_line(layer, polygon, true);
    }
  }
}

}  // namespace

std::string dxf_bytes(std::span<const Sheet> sheets, const ExportSettings& settings) {
  const SheetRow row = side_by_side(sheets);
  const std::array<Font, 2> fonts = {Font(FontWeight::Regular), Font(FontWeight::SemiBold)};
  DxfWriter dxf(row.height_mm);
  write_header(dxf, row);
  write_tables(dxf);
  dxf.begin_section("ENTITIES");
  for (const Sheet& sheet : row.sheets)
    for (const DxfLayer& layer : kLayers) write_layer(dxf, layer, sheet, settings, fonts);
  dxf.end_section();
  dxf.add(0, "EOF");
  return dxf.take();
}

}  // namespace netwright
