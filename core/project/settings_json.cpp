// Tabs and sheets as JSON. Lines are written whole, not as the name of their preset, so a project prints the
// same when a later version changes a preset.
#include "core/project/settings_json.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/project/carry_settings.h"
#include "core/project/json_fields.h"
#include "core/project/mesh_json.h"
#include "core/project/project_words.h"

namespace netwright {

namespace {

using namespace project_words;

constexpr double kMostLine = 20;         // mm
constexpr double kMostDash = 1000;       // mm
constexpr std::size_t kMostDashes = 32;  // of one pattern
constexpr double kLeastDashSum = 1e-3;   // mm; a shorter pattern would be millions of strokes
constexpr double kMostBleed = 20;        // mm
constexpr double kMostLabel = 100;       // mm
constexpr double kLeastLabel = 0.1;      // mm
constexpr double kUpright = std::numbers::pi / 2;

template <class Words, class Enum>
Json word(const Words& words, Enum value) {
  return {words[static_cast<std::size_t>(value)]};
}

template <class Enum, class Words>
Enum chosen(JsonFields& fields, std::string_view key, const Words& words, Enum otherwise) {
  return static_cast<Enum>(fields.choice(key, words, static_cast<int>(otherwise)));
}

Json edit_json(const TabEdit& edit, const Mesh& mesh) {
  Json json;
  json.set("at", edges_json({edit.edge}, mesh));
  json.set("side", word(kTabSides, edit.side));
  if (edit.width_mm) json.set("width_mm", *edit.width_mm);
  if (edit.first_angle_rad) json.set("first_angle_rad", *edit.first_angle_rad);
  if (edit.second_angle_rad) json.set("second_angle_rad", *edit.second_angle_rad);
  return json;
}

std::optional<double> maybe(JsonFields& fields, std::string_view key, double low, double high) {
  const bool is_there = fields.has(key);
  const double value = fields.number(key, low, high, low);
  return is_there ? std::optional(value) : std::nullopt;
}

TabEdit read_edit(const Json& json, const std::string& file, const Mesh& mesh) {
  JsonFields fields(&json, file, "a tab");
  const std::vector<HalfedgeId> at = read_sides(fields, "at", mesh);
  if (at.size() != 1) fields.refuse("at", "is not one edge");
  TabEdit edit;
  edit.edge = mesh.edge(at.front());
  edit.side = chosen(fields, "side", kTabSides, TabSide::Auto);
  edit.width_mm = maybe(fields, "width_mm", 0, kMostTabWidth);
  edit.first_angle_rad = maybe(fields, "first_angle_rad", 0, kUpright);
  edit.second_angle_rad = maybe(fields, "second_angle_rad", 0, kUpright);
  fields.finish();
  return at.front() == mesh.halfedge(edit.edge) ? edit : seen_from_twin(edit);
}

Json line_json(const PrintedLine& line) {
  Json json;
  json.set("colour", Json::Array{line.colour.x, line.colour.y, line.colour.z});
  json.set("width_mm", line.width_mm);
  Json dashes{Json::Array{}};
  for (const double length : line.dash_mm) dashes.add(length);
  json.set("dash_mm", std::move(dashes));
  return json;
}

PrintedLine read_line(const Json* json, const std::string& file, const PrintedLine& usual) {
  if (json == nullptr) return usual;
  JsonFields fields(json, file, "a line");
  PrintedLine line = usual;
  const std::vector<double> colour = fields.numbers("colour", 0, 1);
  if (colour.size() == 3)
    line.colour = {colour[0], colour[1], colour[2]};
  else if (fields.has("colour"))
    fields.refuse("colour", "is not three numbers");
  line.width_mm = fields.number("width_mm", 0, kMostLine, usual.width_mm);
  const bool has_dashes = fields.has("dash_mm");
  std::vector<double> dashes = fields.numbers("dash_mm", 0, kMostDash);
  double sum = 0;
  for (const double length : dashes) sum += length;
  const bool is_pattern =
      dashes.size() % 2 == 0 && dashes.size() <= kMostDashes && (dashes.empty() || sum >= kLeastDashSum);
  if (!is_pattern) fields.refuse("dash_mm", "is no pattern of ink and gaps");
  if (has_dashes) line.dash_mm = std::move(dashes);
  fields.finish();
  return line;
}

Json lines_json(const LineStyles& lines) {
  Json json;
  json.set("cut", line_json(lines.cut));
  json.set("mountain", line_json(lines.mountain));
  json.set("valley", line_json(lines.valley));
  json.set("tab_fold", line_json(lines.tab_fold));
  json.set("flat_below_rad", lines.flat_below_rad);
  json.set("only_ends", lines.only_ends);
  json.set("end_mark_mm", lines.end_mark_mm);
  return json;
}

LineStyles read_lines(const Json* json, const std::string& file) {
  LineStyles lines = line_styles(LinePreset::Origami);
  JsonFields fields(json, file, "the lines");
  lines.cut = read_line(fields.object("cut"), file, lines.cut);
  lines.mountain = read_line(fields.object("mountain"), file, lines.mountain);
  lines.valley = read_line(fields.object("valley"), file, lines.valley);
  lines.tab_fold = read_line(fields.object("tab_fold"), file, lines.tab_fold);
  lines.flat_below_rad = fields.number("flat_below_rad", 0, std::numbers::pi, lines.flat_below_rad);
  lines.only_ends = fields.flag("only_ends", lines.only_ends);
  lines.end_mark_mm = fields.number("end_mark_mm", 0, kMostDash, lines.end_mark_mm);
  fields.finish();
  return lines;
}

Json labels_json(const LabelSettings& labels) {
  Json json;
  json.set("edge_numbers", labels.edge_numbers);
  json.set("skips_obvious", labels.skips_obvious);
  json.set("on_reverse", labels.on_reverse);
  json.set("piece_names", labels.piece_names);
  json.set("fold_angles", labels.fold_angles);
  json.set("face_numbers", labels.face_numbers);
  json.set("size_mm", labels.size_mm);
  return json;
}

LabelSettings read_labels(const Json* json, const std::string& file) {
  LabelSettings labels;
  JsonFields fields(json, file, "the labels");
  labels.edge_numbers = fields.flag("edge_numbers", labels.edge_numbers);
  labels.skips_obvious = fields.flag("skips_obvious", labels.skips_obvious);
  labels.on_reverse = fields.flag("on_reverse", labels.on_reverse);
  labels.piece_names = fields.flag("piece_names", labels.piece_names);
  labels.fold_angles = fields.flag("fold_angles", labels.fold_angles);
  labels.face_numbers = fields.flag("face_numbers", labels.face_numbers);
  labels.size_mm = fields.number("size_mm", kLeastLabel, kMostLabel, labels.size_mm);
  fields.finish();
  return labels;
}

Json pictures_json(const PictureSettings& pictures) {
  Json json;
  json.set("on", pictures.is_on);
  json.set("dpi", pictures.dpi);
  json.set("bleed_mm", pictures.bleed_mm);
  json.set("on_tabs", word(kOnTabs, pictures.on_tabs));
  return json;
}

PictureSettings read_pictures(const Json* json, const std::string& file) {
  PictureSettings pictures;
  JsonFields fields(json, file, "the pictures");
  pictures.is_on = fields.flag("on", pictures.is_on);
  pictures.dpi = static_cast<int>(fields.integer("dpi", 72, 600, pictures.dpi));
  pictures.bleed_mm = fields.number("bleed_mm", 0, kMostBleed, pictures.bleed_mm);
  pictures.on_tabs = chosen(fields, "on_tabs", kOnTabs, pictures.on_tabs);
  fields.finish();
  return pictures;
}

}  // namespace

Json tabs_json(const TabSettings& tabs, const Mesh& mesh) {
  Json json;
  json.set("on", tabs.is_on);
  json.set("pattern", word(kTabPatterns, tabs.pattern));
  json.set("width_mm", tabs.width_mm);
  json.set("angle_rad", tabs.angle_rad);
  if (tabs.in_search) json.set("in_search", true);
  json.set("on_borders", tabs.on_borders);
  Json edits{Json::Array{}};
  for (const TabEdit& edit : tabs.edits) edits.add(edit_json(edit, mesh));
  if (!tabs.edits.empty()) json.set("edits", std::move(edits));
  return json;
}

TabSettings read_tabs(const Json* json, const std::string& file, const Mesh& mesh) {
  TabSettings tabs;
  JsonFields fields(json, file, "the tabs");
  tabs.is_on = fields.flag("on", tabs.is_on);
  tabs.pattern = chosen(fields, "pattern", kTabPatterns, tabs.pattern);
  tabs.width_mm = fields.number("width_mm", 0, kMostTabWidth, tabs.width_mm);
  tabs.angle_rad = fields.number("angle_rad", 0, kUpright, tabs.angle_rad);
  tabs.in_search = fields.flag("in_search", tabs.in_search);
  tabs.on_borders = fields.flag("on_borders", tabs.on_borders);
  if (const Json::Array* const edits = fields.array("edits"))
    for (const Json& edit : *edits) tabs.edits.push_back(read_edit(edit, file, mesh));
  std::ranges::sort(tabs.edits, {}, &TabEdit::edge);
  if (std::ranges::adjacent_find(tabs.edits, {}, &TabEdit::edge) != tabs.edits.end())
    fields.refuse("edits", "name an edge twice");
  fields.finish();
  return tabs;
}

Json exports_json(const ExportSettings& exports) {
  Json json;
  json.set("one_file", exports.is_one_file);
  json.set("real_dashes", exports.real_dashes);
  json.set("live_text", exports.live_text);
  json.set("png_dpi", exports.png_dpi);
  json.set("instructions", word(kInstructions, exports.instructions));
  return json;
}

ExportSettings read_exports(const Json* json, const std::string& file) {
  ExportSettings exports;
  JsonFields fields(json, file, "the exports");
  exports.is_one_file = fields.flag("one_file", exports.is_one_file);
  exports.real_dashes = fields.flag("real_dashes", exports.real_dashes);
  exports.live_text = fields.flag("live_text", exports.live_text);
  exports.png_dpi = static_cast<int>(fields.integer("png_dpi", kLeastDpi, kMostDpi, exports.png_dpi));
  exports.instructions = chosen(fields, "instructions", kInstructions, exports.instructions);
  fields.finish();
  return exports;
}

Json sheet_json(const SheetSettings& sheet, const Mesh& mesh,
                const std::function<int(const std::shared_ptr<const Image>&)>& number_of) {
  Json json;
  json.set("lines", lines_json(sheet.lines));
  json.set("labels", labels_json(sheet.labels));
  json.set("pictures", pictures_json(sheet.pictures));
  json.set("printed_side", word(kPrintedSides, sheet.printed_side));
  json.set("loose_strips", sheet.loose_strips);
  json.set("grey", sheet.is_grey);
  json.set("title", sheet.words.title);
  json.set("author", sheet.words.author);
  json.set("note", sheet.words.note);
  if (sheet.words.picture && !sheet.words.picture->is_empty())
    json.set("picture", number_of(sheet.words.picture));
  if (!sheet.hidden_folds.empty()) json.set("hidden_folds", edges_json(sheet.hidden_folds, mesh));
  if (!sheet.shown_folds.empty()) json.set("shown_folds", edges_json(sheet.shown_folds, mesh));
  return json;
}

SheetSettings read_sheet(const Json* json, const std::string& file, const Mesh& mesh,
                         const std::vector<std::shared_ptr<const Image>>& pictures) {
  SheetSettings sheet;
  JsonFields fields(json, file, "the sheets");
  sheet.lines = read_lines(fields.object("lines"), file);
  sheet.labels = read_labels(fields.object("labels"), file);
  sheet.pictures = read_pictures(fields.object("pictures"), file);
  sheet.printed_side = chosen(fields, "printed_side", kPrintedSides, sheet.printed_side);
  sheet.loose_strips = fields.flag("loose_strips", sheet.loose_strips);
  sheet.is_grey = fields.flag("grey", sheet.is_grey);
  sheet.words.title = fields.text("title", "");
  sheet.words.author = fields.text("author", "");
  sheet.words.note = fields.text("note", "");
  const std::int64_t n = fields.integer("picture", 1, static_cast<std::int64_t>(pictures.size()), 0);
  if (n > 0) sheet.words.picture = pictures[static_cast<std::size_t>(n) - 1];
  sheet.hidden_folds = read_edges(fields, "hidden_folds", mesh);
  sheet.shown_folds = read_edges(fields, "shown_folds", mesh);
  fields.finish();
  return sheet;
}

}  // namespace netwright
