// How the sheets are drawn: lines, numbers, pictures, sides, words. What most people leave alone is behind
// "More".
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/base/atomic_file.h"
#include "ui/actions.h"
#include "ui/panels.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Changes the settings as a step of that name.
template <class Change>
void set(UiContext& c, const char* label, const Change& change) {
  SheetSettings sheet = c.session.project().sheet;
  change(sheet);
  c.session.set_sheet(sheet, label);
}

bool same_looks(const LineStyles& a, const LineStyles& b) {
  return a.cut == b.cut && a.mountain == b.mountain && a.valley == b.valley && a.tab_fold == b.tab_fold;
}

void lines_row(UiContext& c) {
  const LineStyles& lines = c.session.project().sheet.lines;
  std::string shown = "Own lines";
  for (std::size_t i = 0; i < kLinePresetNames.size(); ++i)
    if (same_looks(lines, line_styles(static_cast<LinePreset>(i)))) shown = kLinePresetNames[i];
  ImGui::SetNextItemWidth(row(c.ui, "Lines") - c.ui.look.px(16));
  // What stands in brackets explains the name to those who choose.
  if (!begin_combo(c.ui, "print/lines", shown.substr(0, shown.find(" (")))) return;
  for (std::size_t i = 0; i < kLinePresetNames.size(); ++i) {
    const std::string name(kLinePresetNames[i]);
    if (ImGui::Selectable(name.c_str(), name == shown) && name != shown) {
      set(c, "line styles", [&](SheetSettings& sheet) {
        const LineStyles made = line_styles(static_cast<LinePreset>(i));
        sheet.lines.cut = made.cut;
        sheet.lines.mountain = made.mountain;
        sheet.lines.valley = made.valley;
        sheet.lines.tab_fold = made.tab_fold;
      });
    }
    note_widget(c.ui, "print/lines/" + name);
  }
  ImGui::EndCombo();
}

void flag(UiContext& c, const char* name, const char* label, const char* step, const char* tip,
          bool& (*place)(SheetSettings&)) {
  SheetSettings sheet = c.session.project().sheet;
  bool is_on = place(sheet);
  if (!checkbox(c.ui, name, label, is_on, tip)) return;
  place(sheet) = is_on;
  c.session.set_sheet(sheet, step);
}

void side_row(UiContext& c) {
  int side = static_cast<int>(c.session.project().sheet.printed_side);
  const float width = row(c.ui, "Printed side") - c.ui.look.px(16);
  if (segments(c.ui, "print/side", width, {"Out", "In", "Both"}, side))
    set(c, "printed side",
        [&](SheetSettings& sheet) { sheet.printed_side = static_cast<PrintedSide>(side); });
  tooltip(c.ui, "Which side of the paper becomes the outside; Both prints marks on the back");
}

std::string dash_text(const std::vector<double>& dash_mm) {
  std::string text;
  for (const double part : dash_mm) {
    std::array<char, 24> number{};
    std::snprintf(number.data(), number.size(), "%g", part);
    text.append(text.empty() ? "" : " ").append(number.data());
  }
  return text;
}

/// Nothing where the text is no pattern.
std::optional<std::vector<double>> dash_of(const std::string& text) {
  std::vector<double> parts;
  for (const char* at = text.c_str(); *at != '\0';) {
    char* end = nullptr;
    const double part = std::strtod(at, &end);
    if (end == at) {
      if (*at != ' ' && *at != ',' && *at != '/') return std::nullopt;
      ++at;
      continue;
    }
    if (!(part >= 0.1 && part <= 100)) return std::nullopt;
    parts.push_back(part);
    at = end;
  }
  if (parts.size() % 2 != 0 || parts.size() > 8) return std::nullopt;
  return parts;
}

/// Colour, width and dashes of one kind of line.
void line_row(UiContext& c, const char* name, const char* label, PrintedLine LineStyles::*line) {
  UiState& ui = c.ui;
  const std::string id = std::string("print/") + name;
  const PrintedLine& now = c.session.project().sheet.lines.*line;
  const float width = row(ui, label) - ui.look.px(16);
  const float row_left = ImGui::GetCursorPosX();
  std::array<float, 3> colour{static_cast<float>(now.colour.x), static_cast<float>(now.colour.y),
                              static_cast<float>(now.colour.z)};
  if (ui.draft_colour_of == id) colour = ui.draft_colour;
  const bool is_touched = ImGui::ColorEdit3(("##" + id).c_str(), colour.data(),
                                            ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel);
  note_widget(ui, id + "-colour");
  if (is_touched) {
    ui.draft_colour_of = id;
    ui.draft_colour = colour;
  }
  // Picking a colour is one step, not one for every shade the pointer passes.
  if (ui.draft_colour_of == id && !ImGui::IsMouseDown(ImGuiMouseButton_Left) && !ImGui::IsItemActive()) {
    ui.draft_colour_of.clear();
    set(c, "line colour", [&](SheetSettings& sheet) {
      (sheet.lines.*line).colour = glm::dvec3(colour[0], colour[1], colour[2]);
    });
  }
  ImGui::SameLine();
  double width_mm = now.width_mm;
  ImGui::SetNextItemWidth(width - ImGui::GetItemRectSize().x - ui.look.px(8));
  if (number_field(ui, id + "-width", width_mm, "%.2f"))
    set(c, "line width",
        [&](SheetSettings& sheet) { (sheet.lines.*line).width_mm = std::clamp(width_mm, 0.02, 5.0); });
  tooltip(ui, "Width in mm");
  // Four numbers and what parts them take a line of their own.
  ImGui::SetCursorPosX(row_left);
  ImGui::SetNextItemWidth(width);
  std::string dashes = dash_text(now.dash_mm);
  if (text_field(ui, id + "-dash", dashes, "solid")) {
    if (const auto parts = dash_of(dashes))
      set(c, "line dashes", [&](SheetSettings& sheet) { (sheet.lines.*line).dash_mm = *parts; });
    else
      add_toast(ui, "Dashes are ink and gap in turn, in mm: 3 0.9 0.3 0.9.", false);
  }
  const std::string tip = "Ink and gap in turn, in mm; empty is a solid line";
  tooltip(ui, dashes.empty() ? tip : dashes + "\n" + tip);
}

void fold_rows(UiContext& c) {
  double degrees = c.session.project().sheet.lines.flat_below_rad / kDegree;
  ImGui::SetNextItemWidth(row(c.ui, "Hide below") - c.ui.look.px(16));
  const bool is_entered = number_field(c.ui, "print/flat-below", degrees, "%.1f°");
  tooltip(c.ui, "Folds bent less than this are not printed");
  if (is_entered)
    set(c, "hide flat folds", [&](SheetSettings& sheet) {
      sheet.lines.flat_below_rad = std::clamp(degrees, 0.0, 180.0) * kDegree;
    });
  flag(c, "print/ends", "Only the ends of folds", "marks at the ends",
       "A short mark at both ends of a fold, for clean faces",
       [](SheetSettings& s) -> bool& { return s.lines.only_ends; });
  const SheetSettings& sheet = c.session.project().sheet;
  const std::size_t n_edited = sheet.hidden_folds.size() + sheet.shown_folds.size();
  if (n_edited == 0) return;
  if (button(c.ui, {"print/reset-folds", "Reset " + std::to_string(n_edited) + " by hand", "",
                    "All folds are printed by their angle again", ButtonKind::Outlined}))
    set(c, "reset fold lines", [](SheetSettings& s) {
      s.hidden_folds.clear();
      s.shown_folds.clear();
    });
}

void label_rows(UiContext& c) {
  flag(c, "print/obvious", "Skip obvious numbers", "obvious numbers",
       "None where two neighbouring sides can only be glued to each other",
       [](SheetSettings& s) -> bool& { return s.labels.skips_obvious; });
  flag(c, "print/reverse", "Numbers on the back", "numbers on the back", "On a page of its own, mirrored",
       [](SheetSettings& s) -> bool& { return s.labels.on_reverse; });
  flag(c, "print/pieces", "Names of pieces", "names of pieces", "A, B, C … where there are several",
       [](SheetSettings& s) -> bool& { return s.labels.piece_names; });
  flag(c, "print/angles", "Angles of folds", "angles of folds", "In degrees",
       [](SheetSettings& s) -> bool& { return s.labels.fold_angles; });
  flag(c, "print/faces", "Numbers of faces", "numbers of faces", "As the status bar counts them",
       [](SheetSettings& s) -> bool& { return s.labels.face_numbers; });
  double points = c.session.project().sheet.labels.size_mm * 72 / 25.4;
  ImGui::SetNextItemWidth(row(c.ui, "Letters") - c.ui.look.px(16));
  if (number_field(c.ui, "print/letters", points, "%.1f pt"))
    set(c, "size of letters",
        [&](SheetSettings& sheet) { sheet.labels.size_mm = std::clamp(points, 2.0, 72.0) * 25.4 / 72; });
}

void picture_rows(UiContext& c) {
  const PictureSettings& pictures = c.session.project().sheet.pictures;
  auto dpi = static_cast<std::uint64_t>(pictures.dpi);
  ImGui::SetNextItemWidth(row(c.ui, "Pictures, dpi") - c.ui.look.px(16));
  if (number_field(c.ui, "print/dpi", dpi))
    set(c, "picture resolution", [&](SheetSettings& sheet) {
      sheet.pictures.dpi = static_cast<int>(std::clamp<std::uint64_t>(dpi, 72, 600));
    });
  double bleed_mm = pictures.bleed_mm;
  ImGui::SetNextItemWidth(row(c.ui, "Bleed") - c.ui.look.px(16));
  if (length_field(c.ui, "print/bleed", bleed_mm))
    set(c, "bleed", [&](SheetSettings& sheet) { sheet.pictures.bleed_mm = std::clamp(bleed_mm, 0.0, 10.0); });
  tooltip(c.ui, "How far colours reach past the outline, so that a crooked cut shows no white");
  int on_tabs = static_cast<int>(pictures.on_tabs);
  const float width = row(c.ui, "On tabs") - c.ui.look.px(16);
  if (segments(c.ui, "print/on-tabs", width, {"Full", "Faint", "White"}, on_tabs))
    set(c, "picture on tabs", [&](SheetSettings& sheet) {
      sheet.pictures.on_tabs = static_cast<PictureSettings::OnTabs>(on_tabs);
    });
}

void word_row(UiContext& c, const char* name, const char* label, const char* hint,
              std::string SheetWords::*word) {
  std::string text = c.session.project().sheet.words.*word;
  ImGui::SetNextItemWidth(row(c.ui, label) - c.ui.look.px(16));
  if (text_field(c.ui, std::string("print/") + name, text, hint))
    set(c, name, [&](SheetSettings& sheet) { sheet.words.*word = text; });
}

/// A picture of the user's own, by its file's name.
void own_picture_row(UiContext& c) {
  constexpr std::size_t kMostBytes = std::size_t{64} << 20;
  std::string path;
  const bool has_one = c.session.project().sheet.words.picture != nullptr;
  ImGui::SetNextItemWidth(row(c.ui, "Own picture") - c.ui.look.px(16));
  if (text_field(c.ui, "print/picture", path, has_one ? "there is one" : "path of a file")) {
    try {
      auto image = std::make_shared<const Image>(decode_image(read_file(path, kMostBytes)));
      if (image->is_empty())
        add_toast(c.ui, path + " is no picture that can be read (PNG, JPEG, BMP, GIF, TGA).", false);
      else
        set(c, "picture", [&](SheetSettings& sheet) { sheet.words.picture = image; });
    } catch (const std::exception& error) {
      add_toast(c.ui, error.what(), false);
    }
  }
  if (!has_one) return;
  if (button(c.ui, {"print/no-picture", "Take it away", "", "No picture of your own on the sheet",
                    ButtonKind::Outlined}))
    set(c, "take picture away", [](SheetSettings& sheet) { sheet.words.picture = nullptr; });
}

void more_rows(UiContext& c) {
  line_row(c, "cut", "Cut", &LineStyles::cut);
  line_row(c, "mountain", "Mountain", &LineStyles::mountain);
  line_row(c, "valley", "Valley", &LineStyles::valley);
  line_row(c, "tab-fold", "Tab fold", &LineStyles::tab_fold);
  fold_rows(c);
  label_rows(c);
  picture_rows(c);
  flag(c, "print/grey", "Shades of grey", "shades of grey", "For printers without colours",
       [](SheetSettings& s) -> bool& { return s.is_grey; });
  word_row(c, "title", "Title", "the model's name", &SheetWords::title);
  word_row(c, "author", "Author", "", &SheetWords::author);
  word_row(c, "note", "Note", "", &SheetWords::note);
  own_picture_row(c);
}

}  // namespace

void panel_print(UiContext& context) {
  if (!context.session.has_model()) {
    text_muted(context.ui, "Open a model to set how it is printed.");
    return;
  }
  lines_row(context);
  side_row(context);
  flag(context, "print/numbers", "Numbers at cuts", "numbers",
       "The same on both sides of a cut: on the tab and where it is glued",
       [](SheetSettings& s) -> bool& { return s.labels.edge_numbers; });
  flag(context, "print/pictures", "Colours and pictures", "pictures",
       "Prints the model's own textures and colours",
       [](SheetSettings& s) -> bool& { return s.pictures.is_on; });
  if (more_header(context.ui, "print/more", context.ui.is_more_print_open)) more_rows(context);
}

}  // namespace netwright
