// Lays the page of instructions out: title, figures in two columns, and six pictures with a line each.
#include "core/sheet/instructions.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/sheet/draw.h"
#include "core/sheet/number_text.h"
#include "core/sheet/print_style.h"

namespace netwright {

namespace {

using namespace print_style;

constexpr double kTitleSize = 4.8;
constexpr double kTextSize = 2.9;
constexpr double kLineHeight = 4.6;
constexpr double kWordColumn = 24;  // where the figures begin behind their names
constexpr double kDotRadius = 1.15;

struct Stage {
  double amount;
  const char* words;
};
constexpr std::array<Stage, 6> kStages = {{{0, "Cut out along the outline."},
                                           {0.12, "Score every line, then fold it once."},
                                           {0.35, "Mountains fold away from you, valleys towards you."},
                                           {0.6, "Glue from the middle outwards."},
                                           {0.85, "Sides with equal numbers belong together."},
                                           {1, "Close the last seam where you can reach it."}}};

std::string length_words(double mm) {
  return mm >= 995 ? decimal_number(mm / 1000, 1) + " m" : decimal_number(mm / 10, 0) + " cm";
}

/// To the half hour above one, to the quarter below.
std::string time_words(double hours) {
  if (hours < 0.875) return decimal_number(std::max(1.0, std::round(hours * 4)) * 15, 0) + " minutes";
  const double rounded = hours > 10 ? std::round(hours) : std::round(hours * 2) / 2;
  return decimal_number(rounded, 1) + (rounded == 1 ? " hour" : " hours");
}

std::string counted(int count, const std::string& one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

class Artist {
 public:
  Artist(const Net& net, const PageLayout& layout, const SheetInfo& info, const SheetSettings& settings)
      : net_(net),
        layout_(layout),
        figures_(build_figures(net, layout, settings)),
        title_(title_words(net, layout, info, settings.words).title) {
    sheet_.width_mm = layout.frame.width_mm;
    sheet_.height_mm = layout.frame.height_mm;
    sheet_.number = 0;
    sheet_.count = figures_.n_sheets;
  }

  Sheet draw() {
    const Box2 page = layout_.frame.printable;
    add(page.min + glm::dvec2(0, 4.3), "How to build " + title_, FontWeight::SemiBold, kTitleSize);
    const double below = draw_figures(page.min.y + 12);
    draw_stages({{page.min.x, below + 3}, page.max});
    return std::move(sheet_);
  }

 private:
  void add(glm::dvec2 at, const std::string& words, FontWeight weight = FontWeight::Regular,
           double size = kTextSize, glm::dvec3 colour = kInk) {
    sheet_.texts.push_back({Layer::Print, at, words, size, weight, colour});
  }

  /// A name in grey and what there is to say; returns the next line's height.
  double row(glm::dvec2 at, const std::string& name, const std::string& words) {
    add(at, name, FontWeight::Regular, kTextSize, kQuietInk);
    add(at + glm::dvec2(kWordColumn, 0), words);
    return at.y + kLineHeight;
  }

  double draw_figures(double top) {
    const Box2 page = layout_.frame.printable;
    const double left = page.min.x;
    const int n_folds = figures_.n_mountains + figures_.n_valleys;
    double y = top;
    draw_dots({left + kWordColumn, y - kTextSize * 0.36});
    y = row({left, y}, "Difficulty", "");
    y = row({left, y}, "Time",
            "about " + time_words(figures_.hours()) + ": " + time_words(figures_.cutting_h) + " cutting, " +
                time_words(figures_.folding_h) + " folding, " + time_words(figures_.gluing_h) + " gluing");
    y = row({left, y}, "Cut",
            length_words(figures_.outline_mm) + " around " + counted(net_.n_pieces, "piece") + " on " +
                counted(figures_.n_sheets, "sheet"));
    y = row({left, y}, "Fold",
            counted(n_folds, "line") + ", " + length_words(figures_.fold_mm) + ": " +
                counted(figures_.n_mountains, "mountain") + ", " + counted(figures_.n_valleys, "valley"));
    std::string seams = counted(figures_.n_cuts, "seam") + ", " + length_words(figures_.cut_mm);
    if (figures_.n_tabs > 0) seams += ", " + counted(figures_.n_tabs, "tab");
    if (figures_.n_cuts > 0) seams += "; the shortest " + decimal_number(figures_.shortest_cut_mm, 1) + " mm";
    y = row({left, y}, "Glue", seams);
    return row({left, y}, "Paper", std::string(paper_weight(figures_, layout_.model_height_mm)) + " g/m²");
  }

  /// Full dots for the difficulty, empty ones up to five.
  void draw_dots(glm::dvec2 at) {
    for (int i = 0; i < 5; ++i) {
      const glm::dvec2 centre = at + glm::dvec2(kDotRadius + i * 3.2, 0);
      std::vector<glm::dvec2> circle;
      for (int k = 0; k < 24; ++k)
        circle.push_back(centre + kDotRadius * glm::dvec2(std::cos(k * kStep), std::sin(k * kStep)));
      if (i < figures_.difficulty) sheet_.fills.push_back({Layer::Print, circle, kInk});
      sheet_.strokes.push_back({Layer::Print, circle, true, kRulerWidth, kInk, {}, 0});
    }
    add(at + glm::dvec2(5 * 3.2 + 1, kTextSize * 0.36), std::to_string(figures_.difficulty) + " of 5");
  }

  void draw_stages(const Box2& room) {
    constexpr double kGap = 6;
    constexpr double kCaption = 7;
    const Net spread = spread_pieces(net_);
    const int columns = room.size().x > room.size().y ? 3 : 2;
    const int rows = static_cast<int>(kStages.size()) / columns;
    const glm::dvec2 cell = (room.size() + kGap) / glm::dvec2(columns, rows) - kGap;
    for (std::size_t i = 0; i < kStages.size(); ++i) {
      const int n = static_cast<int>(i);
      const glm::dvec2 low = room.min + (cell + kGap) * glm::dvec2(n % columns, n / columns);
      const Box2 box{low + 2.0, low + cell - glm::dvec2(2, kCaption)};
      for (Fill& fill : folding_picture(spread, kStages[i].amount, box))
        sheet_.fills.push_back(std::move(fill));
      const glm::dvec2 caption = low + glm::dvec2(0, cell.y - 1.5);
      add(caption, std::to_string(n + 1), FontWeight::SemiBold);
      add(caption + glm::dvec2(5, 0), kStages[i].words);
    }
  }

  static constexpr double kStep = 0.26179938779914941;  // 15 degrees
  const Net& net_;
  const PageLayout& layout_;
  BuildFigures figures_;
  std::string title_;
  Sheet sheet_;
};

}  // namespace

Sheet instruction_sheet(const Net& net, const PageLayout& layout, const SheetInfo& info,
                        const SheetSettings& settings) {
  Sheet sheet = Artist(net, layout, info, settings).draw();
  if (settings.is_grey) make_grey(sheet);
  return sheet;
}

void add_instructions(std::vector<Sheet>& sheets, Sheet page, InstructionPage where) {
  if (where == InstructionPage::Last) {
    sheets.push_back(std::move(page));
    return;
  }
  Sheet empty;
  empty.width_mm = page.width_mm;
  empty.height_mm = page.height_mm;
  empty.is_back = true;
  if (std::ranges::any_of(sheets, &Sheet::is_back)) sheets.insert(sheets.begin(), std::move(empty));
  sheets.insert(sheets.begin(), std::move(page));
}

}  // namespace netwright
