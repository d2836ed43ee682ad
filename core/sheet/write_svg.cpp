// SVG by hand: one unit is one millimetre, and every kind of line has its own Inkscape layer, with names that
// cutting programs know (they skip Print and Regmarks). Words are outlines, so that no machine misses the
// typeface.
#include <array>
#include <string>

#include "core/sheet/font.h"
#include "core/sheet/number_text.h"
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

std::string path_data(const std::vector<glm::dvec2>& points, bool is_closed) {
  std::string data;
  for (const glm::dvec2 p : points) data += (data.empty() ? "M" : " L") + mm(p.x) + "," + mm(p.y);
  return is_closed ? data + " Z" : data;
}

std::string fill_element(const Fill& fill) {
  return "    <path d=\"" + path_data(fill.points, true) + "\" style=\"fill:" + colour_code(fill.colour) +
         "\"/>\n";
}

std::string stroke_element(const Stroke& stroke) {
  std::string style = "fill:none;stroke:" + colour_code(stroke.colour) +
                      ";stroke-width:" + mm(stroke.width_mm) + ";stroke-linejoin:round";
  if (!stroke.dash_mm.empty()) {
    style += ";stroke-dasharray:";
    for (const double part : stroke.dash_mm) style += (style.back() == ':' ? "" : ",") + mm(part);
    if (stroke.dash_phase_mm != 0) style += ";stroke-dashoffset:" + mm(stroke.dash_phase_mm);
  }
  return "    <path d=\"" + path_data(stroke.points, stroke.is_closed) + "\" style=\"" + style + "\"/>\n";
}

std::string text_element(const Text& text, const Font& font) {
  std::string data;
  const std::string words = clean_utf8(text.words);
  for (const Font::Step& step : font.outline(words, text.size_mm, text.at)) {
    data += step.kind;
    const std::size_t n_points = step.kind == 'C' ? 3 : step.kind == 'Z' ? 0 : 1;
    for (std::size_t i = 0; i < n_points; ++i)
      data += (i == 0 ? "" : " ") + mm(step.points[i].x) + "," + mm(step.points[i].y);
  }
  return "    <path aria-label=\"" + escaped(words) + "\" d=\"" + data +
         "\" style=\"fill:" + colour_code(text.colour) + "\"/>\n";
}

}  // namespace

std::string svg_bytes(const Sheet& sheet, const std::string& title) {
  const Font regular(FontWeight::Regular);
  const Font semi_bold(FontWeight::SemiBold);
  const std::string width = mm(sheet.width_mm);
  const std::string height = mm(sheet.height_mm);
  std::string svg =
      "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\"\n"
      "     version=\"1.1\" width=\"" +
      width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 " + width + " " + height + "\">\n";
  svg += "  <title>" + escaped(clean_utf8(title)) + "</title>\n";
  for (const LayerName& name : kLayers) {
    std::string content;
    for (const Fill& fill : sheet.fills)
      if (fill.layer == name.layer) content += fill_element(fill);
    for (const Stroke& stroke : sheet.strokes)
      if (stroke.layer == name.layer) content += stroke_element(stroke);
    for (const Text& text : sheet.texts)
      if (text.layer == name.layer)
        content += text_element(text, text.weight == FontWeight::Regular ? regular : semi_bold);
    svg += std::string("  <g id=\"") + name.id + "\" inkscape:groupmode=\"layer\" inkscape:label=\"" +
           name.label + "\">\n" + content + "  </g>\n";
  }
  return svg + "</svg>\n";
}

}  // namespace netwright
