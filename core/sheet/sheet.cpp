// Puts the sheets together: per page one side or two, and on each the pictures, the net's lines, labels, the
// marks of a tile, title block, legend and ruler; beside the net what finds room there.
#include "core/sheet/sheet.h"

#include <algorithm>

#include "core/sheet/draw.h"
#include "core/sheet/free_spots.h"
#include "core/sheet/loose_strips.h"
#include "core/sheet/picture_canvas.h"
#include "core/sheet/piece_pictures.h"

namespace netwright {

namespace {

constexpr double kMostPixels = 60e6;

/// What one side of the paper shows. Lines are cut and folds; the cut alone where there are no folds.
struct Side {
  bool is_back = false;
  bool is_mirrored = false;
  bool has_pictures = false;
  bool has_cuts = true;
  bool has_folds = true;
  bool has_labels = true;
  bool is_usual = false;  ///< the outside, and nothing on the back
  std::string sentence;
};

std::vector<Side> sides_of(const SheetSettings& settings, const PageLayout& layout, bool has_labels) {
  const std::string flip = layout.frame.is_landscape() ? "short edge." : "long edge.";
  const std::string turned = ", turned like the page of a book.";
  if (settings.printed_side == PrintedSide::Both)
    return {{false, false, true, true, false, false, false, "The outside. Two-sided, flipped on the " + flip},
            {true, true, false, true, true, true, false, "The inside" + turned}};
  const bool is_inside = settings.printed_side == PrintedSide::Inside;
  const bool is_split = has_labels && settings.labels.on_reverse;
  Side front{false, is_inside, !is_inside, true, true, !is_split, !is_inside && !is_split, ""};
  front.sentence = is_inside ? "The printed side is the inside, so it is drawn mirrored."
                             : "The printed side is the outside.";
  if (!is_split) return {front};
  front.sentence = std::string(is_inside ? "The inside, mirrored." : "The outside.") +
                   " Two-sided, flipped on the " + flip;
  return {front,
          {true, !is_inside, false, false, false, true, false,
           std::string(is_inside ? "The outside" : "The inside") + turned}};
}

/// Where a side shows the net. A back page is the front turned over its upright edge.
PageView view_of(const PageLayout& layout, const PageLayout::Page& page, const Side& side) {
  Box2 frame = layout.frame.net;
  if (side.is_back)
    frame = {{layout.frame.width_mm - frame.max.x, frame.min.y},
             {layout.frame.width_mm - frame.min.x, frame.max.y}};
  return {layout, page, side.is_mirrored, frame};
}

/// In print shops' weights, so that colours keep their brightness.
void grey(glm::dvec3& colour) { colour = glm::dvec3(glm::dot(colour, glm::dvec3(0.2126, 0.7152, 0.0722))); }

/// The parts that all pages share.
class SheetArtist {
 public:
  SheetArtist(const Net& net, const PageLayout& layout, const SheetInfo& info, const SheetSettings& settings)
      : layout_(layout),
        settings_(settings),
        lines_(net_lines(net, layout, settings)),
        pictures_(std::make_shared<const PictureArtist>(net, layout, settings)),
        labels_(place_labels(net, layout, settings)),
        strips_(loose_strips(net, layout, settings, labels_)),
        margin_(layout, title_words(net, layout, info, settings.words, labels_.left_out.size()),
                settings.lines) {}

  [[nodiscard]] std::vector<Side> sides() const {
    return sides_of(settings_, layout_, !labels_.labels.empty());
  }

  void draw(Sheet& sheet, const PageView& view, const Side& side) {
    const bool is_tile = layout_.canvases[static_cast<std::size_t>(view.page.canvas)].is_tiled();
    MarginNotes notes{side.sentence, side.is_usual, side.is_back, side.has_folds, ""};
    if (!is_tile && !side.is_back) {
      notes.words = draw_beside_net(sheet, view);
    } else if (sheet.number == 1) {
      notes.words = settings_.words.note;
    }
    if (is_tile) draw_tile_marks(sheet, view, margin_.font());
    if (side.has_pictures) pictures_->draw(sheet, view);
    if (side.has_folds) draw_folds(sheet, lines_, view, settings_.lines);
    if (side.has_cuts) draw_cuts(sheet, lines_, view, settings_.lines);
    if (side.has_labels) draw_labels(sheet, labels_, view);
    keep_pictures(sheet);
    margin_.draw(sheet, view, notes);
    if (settings_.is_grey) make_grey(sheet);
  }

 private:
  /// Lets go of images that can be made anew once there are many of them.
  void keep_pictures(Sheet& sheet) {
    for (Picture& picture : sheet.pictures) {
      if (!picture.later) continue;
      n_pixels_ += static_cast<double>(picture.image->width) * picture.image->height;
      if (n_pixels_ > kMostPixels) picture.image.reset();
    }
  }

  /// Returns the note when it has to go elsewhere.
  std::string draw_beside_net(Sheet& sheet, const PageView& view) {
    const bool is_first = sheet.number == 1;
    if (!is_first && strips_.empty()) return "";
    FreeSpots spots(lines_, view);
    const bool has_note = !is_first || draw_own_words(sheet, spots, settings_.words, margin_.font());
    draw_loose_strips(sheet, spots, settings_.lines, margin_.font(), strips_);
    if (is_first) draw_test_square(sheet, spots);
    return has_note ? "" : settings_.words.note;
  }

  const PageLayout& layout_;
  const SheetSettings& settings_;
  NetLines lines_;
  std::shared_ptr<const PictureArtist> pictures_;
  PlacedLabels labels_;
  std::vector<LooseStrip> strips_;  ///< that have not found room yet
  MarginArtist margin_;
  double n_pixels_ = 0;
};

}  // namespace

void make_grey(Sheet& sheet) {
  for (Fill& fill : sheet.fills) grey(fill.colour);
  for (Stroke& stroke : sheet.strokes) grey(stroke.colour);
  for (Text& text : sheet.texts) grey(text.colour);
  // Those of the net are painted grey; the user's own is not.
  for (Picture& picture : sheet.pictures)
    if (!picture.later) picture.image = std::make_shared<const Image>(greyed(*picture.image));
}

std::vector<Sheet> draw_sheets(const Net& net, const PageLayout& layout, const SheetInfo& info,
                               const SheetSettings& settings) {
  SheetArtist artist(net, layout, info, settings);
  const std::vector<Side> sides = artist.sides();
  std::vector<Sheet> sheets;
  for (const PageLayout::Page& page : layout.pages)
    for (const Side& side : sides) {
      Sheet sheet;
      sheet.width_mm = layout.frame.width_mm;
      sheet.height_mm = layout.frame.height_mm;
      sheet.number = static_cast<int>(sheets.size()) + 1;
      sheet.count = static_cast<int>(layout.pages.size() * sides.size());
      sheet.tag = page.tag;
      sheet.is_back = side.is_back;
      artist.draw(sheet, view_of(layout, page, side), side);
      sheets.push_back(std::move(sheet));
    }
  return sheets;
}

}  // namespace netwright
