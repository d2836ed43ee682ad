// Words of the command line become settings of the project.
#include "app/cli_print.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <numbers>
#include <span>
#include <string_view>

#include "app/cli_pins.h"

namespace netwright {

namespace {

constexpr std::array<std::string_view, 6> kTabWords = {"none", "child",       "one",
                                                       "both", "alternating", "everywhere"};
constexpr std::array<std::string_view, 6> kLabelWords = {"none",  "all",    "angles",
                                                         "faces", "pieces", "reverse"};
constexpr std::array<std::string_view, 4> kLineWords = {"origami", "kit", "solid", "cutter"};
constexpr std::array<std::string_view, 2> kSwitchWords = {"off", "on"};
constexpr std::array<std::string_view, 3> kSideWords = {"outside", "inside", "both"};
constexpr std::array<std::string_view, 3> kOrientationWords = {"auto", "portrait", "landscape"};

std::optional<double> number_in(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// The word's place among the others; nothing when it is none of them.
std::optional<std::size_t> place_of(std::string_view word, std::span<const std::string_view> words) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) return std::nullopt;
  return static_cast<std::size_t>(found - words.begin());
}

std::string why_none_of(std::string_view word, std::span<const std::string_view> words) {
  if (place_of(word, words)) return {};
  std::string text = "it must be ";
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + std::string(words[i]);
  return text;
}

struct EdgeWish {
  std::pair<int, int> faces;
  double length_mm = 0;
};

std::optional<EdgeWish> edge_in(std::string_view word) {
  const std::size_t between = word.find(':');
  const std::size_t equals = word.find('=');
  if (between == std::string_view::npos || equals == std::string_view::npos || equals < between)
    return std::nullopt;
  const auto face = [](std::string_view text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? number : 0;
  };
  const EdgeWish wish{{face(word.substr(0, between)), face(word.substr(between + 1, equals - between - 1))},
                      number_in(word.substr(equals + 1)).value_or(0)};
  const bool is_good =
      wish.faces.first > 0 && wish.faces.second > 0 && wish.length_mm > 0 && wish.length_mm <= 1e6;
  return is_good ? std::optional(wish) : std::nullopt;
}

void apply_tabs(const PrintOptions& options, TabSettings& tabs) {
  for (const std::string& word : options.tabs) {
    const std::optional<double> width_mm = number_in(word);
    tabs.is_on = word != "none" && width_mm != 0;
    if (word == "child") tabs.width_mm = kChildTabWidth;
    if (word == "one") tabs.pattern = TabSettings::Pattern::BestSide;
    if (word == "both") tabs.pattern = TabSettings::Pattern::BothSides;
    if (word == "everywhere") tabs.in_search = true;
    if (word == "alternating") tabs.pattern = TabSettings::Pattern::Alternating;
    if (tabs.is_on && width_mm) tabs.width_mm = *width_mm;
  }
  if (options.tab_angle_deg) tabs.angle_rad = *options.tab_angle_deg * std::numbers::pi / 180;
}

void apply_labels(const PrintOptions& options, LabelSettings& labels) {
  if (options.has_no_numbers) labels.edge_numbers = false;
  for (const std::string& word : options.labels) {
    if (word == "all") labels.skips_obvious = false;
    if (word == "angles") labels.fold_angles = true;
    if (word == "faces") labels.face_numbers = true;
    if (word == "pieces") labels.piece_names = true;
    if (word == "reverse") labels.on_reverse = true;
  }
}

void apply_sheet(const PrintOptions& options, SheetSettings& sheet) {
  apply_labels(options, sheet.labels);
  if (const auto place = place_of(options.lines, kLineWords))
    sheet.lines = line_styles(static_cast<LinePreset>(*place));
  if (options.fold_ends_mm) {
    sheet.lines.only_ends = *options.fold_ends_mm > 0;
    if (sheet.lines.only_ends) sheet.lines.end_mark_mm = *options.fold_ends_mm;
  }
  if (const auto place = place_of(options.loose_strips, kSwitchWords)) sheet.loose_strips = *place == 1;
  if (const auto place = place_of(options.printed_side, kSideWords))
    sheet.printed_side = static_cast<PrintedSide>(*place);
  if (options.has_no_pictures) sheet.pictures.is_on = false;
  if (options.picture_dpi) sheet.pictures.dpi = *options.picture_dpi;
  if (options.is_grey) sheet.is_grey = true;
  if (options.title) sheet.words.title = *options.title;
  if (options.author) sheet.words.author = *options.author;
  if (options.note) sheet.words.note = *options.note;
}

}  // namespace

std::string why_not_tabs(const std::string& word) {
  const auto width_mm = number_in(word);
  const bool is_width =
      width_mm && (*width_mm == 0 || (*width_mm >= kLeastTabWidth && *width_mm <= kMostTabWidth));
  if (is_width || place_of(word, kTabWords)) return {};
  return "it must be 0 or a number of millimetres from 2 to 50, none, child, one, both, "
         "alternating or everywhere";
}

std::string why_not_label(const std::string& word) { return why_none_of(word, kLabelWords); }
std::string why_not_lines(const std::string& word) { return why_none_of(word, kLineWords); }
std::string why_not_strips(const std::string& word) { return why_none_of(word, kSwitchWords); }
std::string why_not_side(const std::string& word) { return why_none_of(word, kSideWords); }
std::string why_not_orientation(const std::string& word) { return why_none_of(word, kOrientationWords); }

std::string why_not_edge(const std::string& word) {
  return edge_in(word) ? std::string()
                       : "it must be two face numbers counted from 1 and a length in mm, as in 12:13=40";
}

void apply(const PrintOptions& options, Project& project) {
  apply_tabs(options, project.tabs);
  apply_sheet(options, project.sheet);
  if (options.margin_mm) project.paper.margin_mm = *options.margin_mm;
  if (const auto place = place_of(options.orientation, kOrientationWords))
    project.paper.orientation = static_cast<Orientation>(*place);
  if (const auto edge = edge_in(options.edge)) {
    project.size.kind = PrintSize::Kind::EdgeLength;
    project.size.edge = edge_between(project.dual->mesh(), edge->faces, "to measure");
    project.size.edge_mm = edge->length_mm;
  }
}

}  // namespace netwright
