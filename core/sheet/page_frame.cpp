// How a page is divided: margins, title block, legend and ruler, and the rest for the net.
#include "core/sheet/page_frame.h"

#include <string>

#include "core/base/error.h"
#include "core/sheet/number_text.h"
#include "core/sheet/print_style.h"

namespace netwright {

namespace {

using namespace print_style;

PaperFormat checked_format(const PaperSetup& paper) {
  const auto format = find_paper(paper.format);
  if (!format) {
    std::string known;
    for (const PaperFormat& f : paper_formats()) known += (known.empty() ? "" : ", ") + std::string(f.name);
    throw Error(ErrorKind::Usage, "There is no paper called \"" + paper.format + "\"; choose one of " +
                                      known + ", or give its sides in mm, as in 200x300.");
  }
  return *format;
}

PageFrame make_frame(const PaperSetup& paper, bool is_landscape) {
  const PaperFormat format = checked_format(paper);
  PageFrame frame;
  frame.width_mm = is_landscape ? format.height_mm : format.width_mm;
  frame.height_mm = is_landscape ? format.width_mm : format.height_mm;
  const double margin = paper.margin_mm;
  frame.printable = {{margin, margin}, {frame.width_mm - margin, frame.height_mm - margin}};
  const glm::dvec2 low = frame.printable.min;
  const glm::dvec2 high = frame.printable.max;
  const double width = high.x - low.x;

  // Legend and ruler share the footer where the page is wide enough; else they stack, and on a page narrower
  // than the ruler it stands upright along the left side.
  const bool is_one_row = width >= 3 * kLegendColumn + kRulerLength + 5;
  const bool has_upright_ruler = width < kRulerLength + 1;
  const double footer = is_one_row          ? kFooterHeight
                        : has_upright_ruler ? kLegendHeight + kNoteHeight
                                            : kFooterHeight + kLegendHeight;
  // On a narrow page the proof gets a line of its own below the figures.
  const double header = kHeaderHeight + (width < kWideHeader ? kNoteHeight : 0);
  frame.header = {low, {high.x, low.y + header}};
  frame.footer = {{low.x, high.y - footer}, high};
  frame.net = {{low.x, frame.header.max.y + kStripGap}, {high.x, frame.footer.min.y - kStripGap}};
  if (has_upright_ruler) {
    frame.side = {{low.x, frame.header.max.y}, {low.x + kSideWidth, frame.footer.min.y}};
    frame.net.min.x = frame.side.max.x + kStripGap;
  }
  frame.net.min += kNetInset;
  frame.net.max -= kNetInset;
  return frame;
}

bool has_room(const PageFrame& frame, double margin_mm) {
  const glm::dvec2 room = frame.net.size();
  return margin_mm >= 0 && room.x >= kLeastNetSide && room.y >= kLeastNetSide;
}

[[noreturn]] void refuse_margin(const PaperSetup& paper) {
  throw Error(ErrorKind::Usage, "A margin of " + short_number(paper.margin_mm) +
                                    " mm leaves no room for a net on " + paper.format +
                                    " paper; choose a margin from 0 to 15 mm.");
}

}  // namespace

PageFrame page_frame(const PaperSetup& paper) { return possible_frames(paper).front(); }

std::vector<PageFrame> possible_frames(const PaperSetup& paper) {
  std::vector<PageFrame> frames;
  for (const bool is_landscape : {false, true}) {
    if (paper.orientation == (is_landscape ? Orientation::Portrait : Orientation::Landscape)) continue;
    const PageFrame frame = make_frame(paper, is_landscape);
    if (has_room(frame, paper.margin_mm)) frames.push_back(frame);
  }
  if (frames.empty()) refuse_margin(paper);
  return frames;
}

}  // namespace netwright
