// What stands around the net: title block with scale, proof and page number, the map of the tiles, and the
// legend.
#include <algorithm>
#include <filesystem>
#include <string>

#include "core/sheet/draw.h"
#include "core/sheet/number_text.h"
#include "core/sheet/print_style.h"

namespace netwright {

namespace {

using namespace print_style;

constexpr double kLeft = 0;
constexpr double kRight = 1;

constexpr double kTitleSize = 4.8;
constexpr double kPageSize = 3.3;
constexpr double kSmallSize = 2.5;
constexpr double kTitleBaseline = 4.3;
constexpr double kSmallBaseline = 8.6;
constexpr double kTitleGap = 2.5;
constexpr double kLegendSize = 2.4;
constexpr double kLegendGap = 2;
constexpr double kMapHeight = 9.4;
constexpr double kMapWidth = 22;
constexpr double kMapLargest = 0.04;  ///< of the sheets themselves

Stroke hairline(glm::dvec2 from, glm::dvec2 to) {
  return {Layer::Print, {from, to}, false, kHairlineWidth, kHairline, {}, 0};
}

std::string counted(std::size_t count, const std::string& one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

/// Shortens words until they fit, with an ellipsis for what is left out.
std::string fitted(const Font& font, const std::string& words, double size_mm, double room_mm) {
  if (font.width(words, size_mm) <= room_mm) return words;
  const double dots = font.width("…", size_mm);
  std::size_t kept = 0;
  double width = 0;
  while (kept < words.size()) {
    // A character goes as a whole: its first byte and those that continue it.
    std::size_t end = kept + 1;
    while (end < words.size() && (static_cast<unsigned char>(words[end]) & 0xc0U) == 0x80U) ++end;
    width += font.width(words.substr(kept, end - kept), size_mm);
    if (width + dots > room_mm) break;
    kept = end;
  }
  return words.substr(0, kept) + "…";
}

}  // namespace

TitleWords title_words(const Net& net, const PageLayout& layout, const SheetInfo& info, const SheetWords& own,
                       std::size_t n_unnumbered) {
  const Mesh& mesh = net.mesh();
  TitleWords words;
  const std::string& given = info.title.empty() ? own.title : info.title;
  // A model is named by its file; what kind of file it was matters to nobody who cuts it out.
  words.title = clean_utf8(given.empty() ? std::filesystem::path(mesh.name()).stem().string() : given);
  if (words.title.empty()) words.title = "Model";
  if (!own.author.empty()) words.author = "by " + clean_utf8(own.author);
  words.scale = "Scale 1 unit = " + short_number(layout.scale) + " mm";
  if (layout.model_height_mm > 1e-6)
    words.scale += ", model " + short_number(layout.model_height_mm) + " mm high";
  words.figures = words.scale + "  ·  " + counted(mesh.n_faces(), "face");
  if (info.seed) words.figures += "  ·  seed " + std::to_string(*info.seed);
  if (!layout.tabs.missing.empty())
    words.figures += "  ·  " + counted(layout.tabs.missing.size(), "cut") + " without tab";
  if (n_unnumbered > 0) words.figures += "  ·  " + counted(n_unnumbered, "short cut") + " unnumbered";
  const std::string pieces =
      net.n_pieces == 1 ? "one piece" : counted(static_cast<std::size_t>(net.n_pieces), "piece");
  words.is_proved = info.is_proved;
  words.proof = pieces + (info.is_proved ? ", proved: no overlaps" : ", not proved free of overlaps");
  return words;
}

double MarginArtist::word_width(const Text& text) const {
  return (text.weight == FontWeight::Regular ? regular_ : semi_bold_).width(text.words, text.size_mm);
}

void MarginArtist::add_text(Sheet& sheet, Text text, double align) const {
  text.at.x -= align * word_width(text);
  sheet.texts.push_back(std::move(text));
}

void MarginArtist::draw(Sheet& sheet, const PageView& view, const MarginNotes& notes) const {
  draw_header(sheet, view, notes);
  draw_footer(sheet, notes);
}

/// Title and author, shortened to what is left of their line.
void MarginArtist::draw_title(Sheet& sheet, double right, double baseline) const {
  const double left = layout_.frame.header.min.x;
  const double author_width =
      words_.author.empty() ? 0 : kTitleGap + regular_.width(words_.author, kPageSize);
  // The title comes first: its author has what it leaves.
  const double title_room = std::max(right - left - 5 - author_width, 0.6 * (right - left - 5));
  const std::string title = fitted(semi_bold_, words_.title, kTitleSize, title_room);
  const Text text{Layer::Print, {left, baseline}, title, kTitleSize, FontWeight::SemiBold, kInk};
  add_text(sheet, text, kLeft);
  if (words_.author.empty()) return;
  const double at = left + word_width(text) + kTitleGap;
  add_text(sheet,
           {Layer::Print,
            {at, baseline},
            fitted(regular_, words_.author, kPageSize, right - 5 - at),
            kPageSize,
            FontWeight::Regular,
            kQuietInk},
           kLeft);
}

void MarginArtist::draw_header(Sheet& sheet, const PageView& view, const MarginNotes& notes) const {
  const PageLayout::Page& page = view.page;
  const Box2 box = layout_.frame.header;
  const double title_y = box.min.y + kTitleBaseline;
  const double small_y = box.min.y + kSmallBaseline;
  double right = box.max.x;
  if (!page.tag.empty()) right = draw_map(sheet, view, right) - 4;

  Text number{Layer::Print, {right, title_y}, "", kPageSize, FontWeight::Regular, kInk};
  number.words = "page " + std::to_string(sheet.number) + " of " + std::to_string(sheet.count);
  const double number_left = right - word_width(number);
  add_text(sheet, number, kRight);
  double title_right = number_left;
  if (!page.tag.empty()) {
    const Text tag{Layer::Print, {number_left - 3, title_y}, page.tag,
                   kTitleSize,   FontWeight::SemiBold,       kInk};
    title_right -= 3 + word_width(tag);
    add_text(sheet, tag, kRight);
  }
  draw_title(sheet, title_right, title_y);

  const bool is_narrow = box.max.y - box.min.y > kHeaderHeight;
  const double proof_width = regular_.width(words_.proof, kSmallSize) + (words_.is_proved ? 4.2 : 0);
  if (is_narrow)
    draw_proof(sheet, box.min.x + proof_width, small_y + kNoteHeight);
  else
    draw_proof(sheet, right, small_y);
  const double room = right - box.min.x - (is_narrow ? 0 : proof_width + 4);
  // What the legend has no room for comes first; then the user's words, which nothing else repeats.
  std::string first = has_one_row() || notes.is_usual ? "" : notes.side;
  if (!notes.words.empty()) first += (first.empty() ? "" : "  ·  ") + clean_utf8(notes.words);
  const std::string before = first.empty() ? "" : first + "  ·  ";
  const bool has_room_for_all = regular_.width(before + words_.figures, kSmallSize) <= room;
  const std::string figures =
      fitted(regular_, before + (has_room_for_all ? words_.figures : words_.scale), kSmallSize, room);
  add_text(sheet, {Layer::Print, {box.min.x, small_y}, figures, kSmallSize, FontWeight::Regular, kQuietInk},
           kLeft);
  sheet.strokes.push_back(hairline({box.min.x, box.max.y}, box.max));
}

/// The proof in words, right-aligned, with a tick in a green disc when there is one.
void MarginArtist::draw_proof(Sheet& sheet, double right, double baseline) const {
  const Text text{Layer::Print, {right, baseline},   words_.proof,
                  kSmallSize,   FontWeight::Regular, words_.is_proved ? kGood : kQuietInk};
  add_text(sheet, text, kRight);
  if (!words_.is_proved) return;
  const glm::dvec2 centre(right - word_width(text) - 2.6, baseline - 0.9);
  Fill disc{Layer::Print, {}, kGood};
  for (int k = 0; k < 48; ++k)
    disc.points.push_back(centre + 1.5 * Rigid2::rotation(k * 0.1308996938995747).rotate({1, 0}));
  sheet.fills.push_back(std::move(disc));
  sheet.strokes.push_back(
      {Layer::Print,
       {centre + glm::dvec2(-0.7, 0.05), centre + glm::dvec2(-0.2, 0.55), centre + glm::dvec2(0.75, -0.5)},
       false,
       0.32,
       {1, 1, 1},
       {},
       0});
}

/// The sheets of this canvas, small and in their places, this one dark. Returns the map's left side.
double MarginArtist::draw_map(Sheet& sheet, const PageView& view, double right) const {
  Box2 all;
  for (const PageLayout::Page& page : layout_.pages)
    if (page.canvas == view.page.canvas) all.add(page.share);
  const double scale = std::min({kMapHeight / all.size().y, kMapWidth / all.size().x, kMapLargest});
  const glm::dvec2 corner(right - all.size().x * scale, layout_.frame.header.min.y);
  for (const PageLayout::Page& page : layout_.pages) {
    if (page.canvas != view.page.canvas) continue;
    glm::dvec2 low = (page.share.min - all.min) * scale;
    glm::dvec2 high = (page.share.max - all.min) * scale;
    if (view.is_mirrored) {
      low.x = all.size().x * scale - low.x;
      high.x = all.size().x * scale - high.x;
      std::swap(low.x, high.x);
    }
    const bool is_here = page.row == view.page.row && page.column == view.page.column;
    const double seam = std::min({0.3, 0.15 * (high.x - low.x), 0.15 * (high.y - low.y)});
    low += corner;
    high += corner - seam;
    sheet.fills.push_back(
        {Layer::Print, {low, {high.x, low.y}, high, {low.x, high.y}}, is_here ? kMapHere : kMapPaper});
  }
  return corner.x;
}

bool MarginArtist::has_one_row() const {
  return layout_.frame.footer.size().y < kFooterHeight + 1 && layout_.frame.side.is_empty();
}

void MarginArtist::draw_footer(Sheet& sheet, const MarginNotes& notes) const {
  const PageFrame& frame = layout_.frame;
  const Box2 box = frame.footer;
  const double width = box.max.x - box.min.x;
  sheet.strokes.push_back(hairline(box.min, {box.max.x, box.min.y}));
  const bool is_one_row = has_one_row();
  draw_legend(sheet, !is_one_row, notes);

  const std::string note = "Print at 100 %, not “fit to page”: then this ruler is true.";
  const Text text{Layer::Print, {0, 0}, note, 2.3, FontWeight::Regular, kQuietInk};
  if (!frame.side.is_empty()) {
    Text low = text;
    low.at = {box.min.x, box.max.y - 0.7};
    low.words = fitted(regular_, note, low.size_mm, width);
    add_text(sheet, low, kLeft);
    if (notes.is_back) return;
    const double height = frame.side.max.y - frame.side.min.y;
    const double length = height >= kRulerLength + 2 ? kRulerLength : kRulerLength / 2;
    draw_ruler(sheet, {frame.side.min.x, frame.side.min.y + (height + length) / 2}, true, length, regular_);
    return;
  }
  const double top = box.max.y - kFooterHeight;
  const double zero = is_one_row ? box.max.x - kRulerLength - 3 : box.min.x + 1;
  Text above = text;
  above.at = {zero, top + 3.9};
  add_text(sheet, above, kLeft);
  draw_ruler(sheet, {zero, top + 5.3}, false, kRulerLength, regular_);
}

/// Real samples of the kinds of line: over their names where the ruler stands beside them, else before them.
/// Returns where the row ends.
double MarginArtist::draw_samples(Sheet& sheet, bool is_stacked) const {
  struct Entry {
    Layer layer;
    const char* name;
  };
  std::vector<Entry> entries = {
      {Layer::Cut, "cut"}, {Layer::Mountain, "mountain fold"}, {Layer::Valley, "valley fold"}};
  if (!layout_.tabs.tabs.empty()) entries.push_back({Layer::TabFold, "tab fold"});
  const auto n = static_cast<double>(entries.size());
  const glm::dvec2 corner = layout_.frame.footer.min;
  const double width = layout_.frame.footer.size().x;
  double words = 0;
  for (const Entry& entry : entries) words += regular_.width(entry.name, kLegendSize);
  // Beside the ruler the words stand under samples of one length, elsewhere after shorter ones.
  const double column = std::min(kLegendColumn, (is_stacked ? width : width - kRulerLength - 5) / n);
  const double sample = is_stacked ? std::min(8.1, (width - words) / n - 3.5) : std::min(18.3, column - 4);
  glm::dvec2 from = corner + glm::dvec2(0, is_stacked ? 4.0 : 6.9);
  for (const Entry& entry : entries) {
    Stroke stroke = net_stroke(styles_, entry.layer, from, from + glm::dvec2(sample, 0));
    stroke.layer = Layer::Print;
    sheet.strokes.push_back(std::move(stroke));
    const glm::dvec2 at = from + (is_stacked ? glm::dvec2(sample + 1.5, 0.85) : glm::dvec2(0, 3.6));
    const Text name{Layer::Print, at, entry.name, kLegendSize, FontWeight::Regular, kInk};
    add_text(sheet, name, kLeft);
    from.x += is_stacked ? sample + 1.5 + word_width(name) + kLegendGap : column;
  }
  return from.x;
}

/// Samples, and which side of the paper this is, where both have room.
void MarginArtist::draw_legend(Sheet& sheet, bool is_stacked, const MarginNotes& notes) const {
  const glm::dvec2 corner = layout_.frame.footer.min;
  const double right = layout_.frame.footer.max.x;
  const double end = notes.has_legend ? draw_samples(sheet, is_stacked) : corner.x;
  Text note{Layer::Print, corner + glm::dvec2(0, 3.9), notes.side, 2.3, FontWeight::Regular, kQuietInk};
  if (!is_stacked) {
    note.words = fitted(regular_, note.words, note.size_mm, right - kRulerLength - 6 - corner.x);
    return add_text(sheet, note, kLeft);
  }
  if (word_width(note) > right - end - 2) return;
  note.at = {right, corner.y + 4.85};
  add_text(sheet, note, kRight);
}

void draw_ruler(Sheet& sheet, glm::dvec2 zero, bool is_upright, double length_mm, const Font& font) {
  constexpr double kLabelSize = 2.2;
  const glm::dvec2 along = is_upright ? glm::dvec2(0, -1) : glm::dvec2(1, 0);
  const glm::dvec2 across = is_upright ? glm::dvec2(1, 0) : glm::dvec2(0, 1);
  const auto line = [&](glm::dvec2 from, glm::dvec2 to) {
    sheet.strokes.push_back({Layer::Print, {from, to}, false, kRulerWidth, kInk, {}, 0});
  };
  line(zero, zero + along * length_mm);
  for (int mm = 0; mm <= static_cast<int>(length_mm); ++mm) {
    const double tick = mm % 10 == 0 ? 2.7 : mm % 5 == 0 ? 1.9 : 1.1;
    const glm::dvec2 at = zero + along * static_cast<double>(mm);
    line(at, at + across * tick);
    if (mm % 10 != 0) continue;
    const std::string words = std::to_string(mm);
    const double width = font.width(words, kLabelSize);
    const glm::dvec2 label = is_upright ? glm::dvec2(tick + 0.8, kLabelSize * 0.36)
                                        : glm::dvec2(-width / 2, tick + 0.9 + kLabelSize * 0.73);
    sheet.texts.push_back({Layer::Print, at + label, words, kLabelSize, FontWeight::Regular, kQuietInk});
  }
}

}  // namespace netwright
