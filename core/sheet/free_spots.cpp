// Looks for free boxes along the sides of the page first: out of the way of the net, and of one that is cut
// out.
#include "core/sheet/free_spots.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/sheet/outline.h"
#include "core/sheet/print_style.h"

namespace netwright {

namespace {

using namespace print_style;

constexpr double kDistance = 4;  // from the net, mm
constexpr double kNoteSize = 2.8;
constexpr double kNoteWidth = 60;
constexpr double kLineHeight = 1.4;  // of the size

bool meets(const Box2& a, const Box2& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

/// Words in lines of this width at most; a word that is wider has a line of its own.
std::vector<std::string> wrapped(const Font& font, const std::string& text, double size_mm, double width_mm) {
  std::vector<std::string> lines(1);
  std::string word;
  const auto end_word = [&] {
    if (word.empty()) return;
    std::string& line = lines.back();
    const std::string longer = line.empty() ? word : line + " " + word;
    if (line.empty() || font.width(longer, size_mm) <= width_mm)
      line = longer;
    else
      lines.push_back(word);
    word.clear();
  };
  for (const char c : text) {
    if (c != ' ' && c != '\n' && c != '\t') {
      word += c;
      continue;
    }
    end_word();
    if (c == '\n') lines.emplace_back();
  }
  end_word();
  return lines;
}

void draw_picture(Sheet& sheet, FreeSpots& spots, const std::shared_ptr<const Image>& image) {
  const double longest = std::max(image->width, image->height);
  for (const double side : {40.0, 30.0, 22.0, 15.0}) {
    const glm::dvec2 size = glm::dvec2(image->width, image->height) * (side / longest);
    const auto box = spots.take(size);
    if (!box) continue;
    sheet.pictures.push_back({Layer::Print, box->min, size, image});
    return;
  }
}

}  // namespace

FreeSpots::FreeSpots(const NetLines& lines, const PageView& view) : frame_(view.frame) {
  for (const NetLines::Outline& outline : lines.outlines) {
    if (outline.canvas != view.page.canvas) continue;
    for (std::size_t i = 0; i < outline.points.size(); ++i)
      outline_.emplace_back(view.at(outline.points[i]),
                            view.at(outline.points[(i + 1) % outline.points.size()]));
  }
}

bool FreeSpots::is_free(const Box2& box) const {
  const Box2 clear{box.min - kDistance, box.max + kDistance};
  if (std::ranges::any_of(taken_, [&](const Box2& other) { return meets(clear, other); })) return false;
  if (std::ranges::any_of(
          outline_, [&](const Segment& s) { return clip_segment(clear, s.first, s.second).has_value(); }))
    return false;
  return winding_number(outline_, box.centre()) == 0;
}

std::optional<Box2> FreeSpots::take(glm::dvec2 size) {
  const glm::dvec2 room = frame_.size() - size;
  if (room.x < 0 || room.y < 0) return std::nullopt;
  const auto taken_at = [&](glm::dvec2 share) -> std::optional<Box2> {
    const glm::dvec2 low = frame_.min + room * share;
    if (!is_free({low, low + size})) return std::nullopt;
    taken_.push_back({low, low + size});
    return taken_.back();
  };
  for (int k = 0; k <= 12; ++k) {
    const double share = k / 12.0;
    for (const glm::dvec2 at : {glm::dvec2(1, 1 - share), glm::dvec2(0, 1 - share), glm::dvec2(1 - share, 1),
                                glm::dvec2(1 - share, 0)})
      if (auto box = taken_at(at)) return box;
  }
  return std::nullopt;
}

void draw_test_square(Sheet& sheet, FreeSpots& spots) {
  const auto box = spots.take(glm::dvec2(kSquare));
  if (!box) return;
  const glm::dvec2 low = box->min;
  const glm::dvec2 high = low + kSquare;
  sheet.strokes.push_back(
      {Layer::Print, {low, {high.x, low.y}, high, {low.x, high.y}}, true, kHairlineWidth, kQuietInk, {}, 0});
  sheet.texts.push_back({Layer::Print,
                         {low.x + 2, high.y - 2},
                         "50 mm × 50 mm, to check the print",
                         2.3,
                         FontWeight::Regular,
                         kQuietInk});
}

bool draw_own_words(Sheet& sheet, FreeSpots& spots, const SheetWords& words, const Font& font) {
  if (words.picture && !words.picture->is_empty()) draw_picture(sheet, spots, words.picture);
  if (words.note.empty()) return true;
  const std::vector<std::string> lines = wrapped(font, words.note, kNoteSize, kNoteWidth);
  double width = 0;
  for (const std::string& line : lines) width = std::max(width, font.width(line, kNoteSize));
  const double step = kNoteSize * kLineHeight;
  const auto box = spots.take({width, step * static_cast<double>(lines.size())});
  if (!box) return false;
  glm::dvec2 at = box->min + glm::dvec2(0, kNoteSize);
  for (const std::string& line : lines) {
    sheet.texts.push_back({Layer::Print, at, clean_utf8(line), kNoteSize, FontWeight::Regular, kInk});
    at.y += step;
  }
  return true;
}

}  // namespace netwright
