// SVG by hand: one unit is one millimetre, and every kind of line has its own Inkscape layer, with names that
// cutting programs know (they skip Print and Regmarks). Words are outlines unless text is asked for, so that
// no machine misses the typeface.
#include <array>
#include <numbers>
#include <string>

#include "assets/assets.h"
#include "core/sheet/font.h"
#include "core/sheet/number_text.h"
#include "core/sheet/vector_parts.h"
#include "core/sheet/write.h"

namespace netwright {

namespace {

struct LayerName {
  Layer layer;
  const char* id;
  const char* label;
};
constexpr std::array<LayerName, 7> kLayers = {{{Layer::Print, "print", "Print"},
                                               {Layer::Regmarks, "regmarks", "Regmarks"},
                                               {Layer::Mountain, "fold-mountain", "Fold Mountain"},
                                               {Layer::Valley, "fold-valley", "Fold Valley"},
                                               {Layer::TabFold, "fold-tab", "Fold Tab"},
                                               {Layer::Labels, "labels", "Labels"},
                                               {Layer::Cut, "cut", "Cut"}}};

std::string mm(double value) { return decimal_number(value, 4); }

std::string colour_code(const glm::dvec3& colour) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string code = "#";
  for (int i = 0; i < 3; ++i) {
    const auto level = static_cast<unsigned>(std::lround(glm::clamp(colour[i], 0.0, 1.0) * 255));
    code += kDigits[level / 16];
    code += kDigits[level % 16];
  }
  return code;
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  return out;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = i; k < i + 3; ++k)
      group = group * 256 + (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U);
    for (const unsigned shift : {18U, 12U, 6U, 0U}) text += kDigits[(group >> shift) & 63U];
  }
  if (const std::size_t rest = bytes.size() % 3; rest > 0)
    text.replace(text.size() - (3 - rest), 3 - rest, 3 - rest, '=');
  return text;
}

std::string path_data(const std::vector<glm::dvec2>& points, bool is_closed) {
  std::string data;
  for (const glm::dvec2 p : points) data += (data.empty() ? "M" : " L") + mm(p.x) + "," + mm(p.y);
  return is_closed ? data + " Z" : data;
}

/// Writes the elements of one file.
class SvgWriter {
 public:
  explicit SvgWriter(const ExportSettings& settings) : settings_(settings) {}

  [[nodiscard]] std::string layers(std::span<const Sheet> sheets) {
    std::string text;
    for (const LayerName& name : kLayers) {
      std::string content;
      for (const Sheet& sheet : sheets) content += elements(sheet, name.layer);
      text += std::string("  <g id=\"") + name.id + "\" inkscape:groupmode=\"layer\" inkscape:label=\"" +
              name.label + "\">\n" + content + "  </g>\n";
    }
    return text;
  }

  /// The typefaces of live text, as part of the file.
  [[nodiscard]] std::string typefaces() const {
    if (!has_live_text_) return "";
    std::string style = "  <style>\n";
    for (const auto& [weight, file] :
         {std::pair{"400", "Inter-Regular.otf"}, {"600", "Inter-SemiBold.otf"}}) {
      const std::span<const std::byte> bytes = asset(std::string("assets/fonts/") + file);
      style += std::string("    @font-face{font-family:Inter;font-weight:") + weight +
               ";src:url(data:font/otf;base64," +
               base64({reinterpret_cast<const char*>(bytes.data()), bytes.size()}) + ")}\n";
    }
    return style + "  </style>\n";
  }

 private:
  std::string elements(const Sheet& sheet, Layer layer) {
    std::string content;
    for (const Fill& fill : sheet.fills)
      if (fill.layer == layer)
        content += "    <path d=\"" + path_data(fill.points, true) +
                   "\" style=\"fill:" + colour_code(fill.colour) + "\"/>\n";
    for (const Picture& picture : sheet.pictures)
      if (picture.layer == layer) content += image(picture);
    for (const Stroke& stroke : sheet.strokes)
      if (stroke.layer == layer) content += line(stroke);
    for (const Text& text : sheet.texts)
      if (text.layer == layer) content += settings_.live_text ? live_words(text) : words(text);
    return content;
  }

  static std::string image(const Picture& picture) {
    const std::shared_ptr<const Image> pixels = picture.pixels();
    if (!pixels || pixels->is_empty()) return "";
    return "    <image x=\"" + mm(picture.at.x) + "\" y=\"" + mm(picture.at.y) + "\" width=\"" +
           mm(picture.size_mm.x) + "\" height=\"" + mm(picture.size_mm.y) +
           "\" preserveAspectRatio=\"none\" xlink:href=\"data:image/png;base64," +
           base64(encode_png(*pixels)) + "\"/>\n";
  }

  [[nodiscard]] std::string line(const Stroke& stroke) const {
    std::string style = "fill:none;stroke:" + colour_code(stroke.colour) +
                        ";stroke-width:" + mm(stroke.width_mm) + ";stroke-linejoin:round";
    std::string data;
    if (stroke.dash_mm.empty()) {
      data = path_data(stroke.points, stroke.is_closed);
    } else if (settings_.real_dashes) {
      for (const Line& part : inked_lines(stroke)) data += (data.empty() ? "" : " ") + path_data(part, false);
    } else {
      data = path_data(stroke.points, stroke.is_closed);
      style += ";stroke-dasharray:";
      for (const double part : stroke.dash_mm) style += (style.back() == ':' ? "" : ",") + mm(part);
      if (stroke.dash_phase_mm != 0) style += ";stroke-dashoffset:" + mm(stroke.dash_phase_mm);
    }
    return "    <path d=\"" + data + "\" style=\"" + style + "\"/>\n";
  }

  [[nodiscard]] std::string words(const Text& text) const {
    std::string data;
    for (const Font::Step& step : text_outline(text, font(text.weight))) {
      data += step.kind;
      const std::size_t n_points = step.kind == 'C' ? 3 : step.kind == 'Z' ? 0 : 1;
      for (std::size_t i = 0; i < n_points; ++i)
        data += (i == 0 ? "" : " ") + mm(step.points[i].x) + "," + mm(step.points[i].y);
    }
    return "    <path aria-label=\"" + escaped(clean_utf8(text.words)) + "\" d=\"" + data +
           "\" style=\"fill:" + colour_code(text.colour) + "\"/>\n";
  }

  std::string live_words(const Text& text) {
    has_live_text_ = true;
    std::string element = "    <text x=\"" + mm(text.at.x) + "\" y=\"" + mm(text.at.y) + "\"";
    if (text.angle_rad != 0) {
      element += " transform=\"rotate(" + mm(text.angle_rad * 180 / std::numbers::pi) + " " + mm(text.at.x) +
                 " " + mm(text.at.y) + ")\"";
    }
    return element + " style=\"font-family:Inter,sans-serif;font-weight:" +
           (text.weight == FontWeight::Regular ? "400" : "600") + ";font-size:" + mm(text.size_mm) +
           "px;fill:" + colour_code(text.colour) + "\">" + escaped(clean_utf8(text.words)) + "</text>\n";
  }

  [[nodiscard]] const Font& font(FontWeight weight) const {
    return weight == FontWeight::Regular ? regular_ : semi_bold_;
  }

  const ExportSettings& settings_;
  Font regular_{FontWeight::Regular};
  Font semi_bold_{FontWeight::SemiBold};
  bool has_live_text_ = false;
};

/// Inkscape's pages, one per sheet.
std::string named_view(const SheetRow& row) {
  std::string view = "  <sodipodi:namedview id=\"view\" inkscape:document-units=\"mm\"";
  if (row.sheets.size() < 2) return view + "/>\n";
  view += ">\n";
  for (std::size_t i = 0; i < row.sheets.size(); ++i)
    view += "    <inkscape:page id=\"page-" + std::to_string(i + 1) + "\" x=\"" + mm(row.left_mm[i]) +
            "\" y=\"0\" width=\"" + mm(row.sheets[i].width_mm) + "\" height=\"" +
            mm(row.sheets[i].height_mm) + "\"/>\n";
  return view + "  </sodipodi:namedview>\n";
}

}  // namespace

std::string svg_bytes(std::span<const Sheet> sheets, const std::string& title,
                      const ExportSettings& settings) {
  const SheetRow row = side_by_side(sheets);
  const std::string width = mm(row.width_mm);
  const std::string height = mm(row.height_mm);
  SvgWriter writer(settings);
  const std::string layers = writer.layers(row.sheets);
  return "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n"
         "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\"\n"
         "     xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n"
         "     xmlns:sodipodi=\"http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd\"\n"
         "     version=\"1.1\" width=\"" +
         width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + " " + height + "\">\n" +
         "  <title>" + escaped(clean_utf8(title)) + "</title>\n" + named_view(row) + writer.typefaces() +
         layers + "</svg>\n";
}

}  // namespace netwright
