// Each face and each tab is a plot of its own. All numbers of a face are tried in one size along their sides,
// then in the next smaller one, until all of them have found a place that is free.
#include "core/sheet/labels.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/polygon2.h"
#include "core/sheet/draw.h"
#include "core/sheet/font.h"
#include "core/sheet/label_plot.h"
#include "core/sheet/outline.h"

namespace netwright {

namespace {

constexpr double kShrink = 0.85;
constexpr std::array<double, 7> kAlong = {0, -0.1, 0.1, -0.22, 0.22, -0.34, 0.34};
constexpr std::array<double, 5> kFromSide = {0.75, 0.45, 1.3, 2.0, 3.0};

/// Sizes from the wanted one down to the smallest that can be read.
std::vector<double> sizes_from(double most) {
  std::vector<double> sizes;
  for (double size = most; size > kLeastLabelSize * 1.05; size *= kShrink) sizes.push_back(size);
  sizes.push_back(std::min(most, kLeastLabelSize));
  return sizes;
}

/// Places the labels of one net, one kind after the other.
class Labeller {
 public:
  Labeller(const Net& net, const PageLayout& layout, const SheetSettings& settings)
      : net_(net), layout_(layout), settings_(settings), tabs_(tabs_by_side(net.mesh(), layout.tabs)) {
    plots_.resize(net.mesh().n_faces());
    for (const FaceId f : net.mesh().faces())
      for (const HalfedgeId h : net.mesh().halfedges(f)) plots_[f].polygon.push_back(point(h));
  }

  PlacedLabels run() {
    if (settings_.labels.edge_numbers) number_edges();
    if (settings_.labels.piece_names && net_.n_pieces > 1) name_pieces();
    if (settings_.labels.fold_angles) write_angles();
    if (settings_.labels.face_numbers) number_faces();
    return std::move(placed_);
  }

 private:
  /// A number that wants to be beside this side, in its face.
  struct Wish {
    HalfedgeId side;
    LabelWords words;
    Label::Kind kind = Label::Kind::EdgeNumber;
  };

  [[nodiscard]] glm::dvec2 point(HalfedgeId h) const {
    return layout_.on_canvas(net_.piece[net_.mesh().face(h)], net_.corner(h));
  }

  Label label_for(const Wish& wish) const {
    Label label;
    label.kind = wish.kind;
    label.words = wish.words.words;
    label.side = wish.side;
    label.face = net_.mesh().face(wish.side);
    label.canvas = canvas_of(label.face);
    return label;
  }

  [[nodiscard]] int canvas_of(FaceId f) const {
    return layout_.pieces[static_cast<std::size_t>(net_.piece[f])].canvas;
  }

  /// Beside its side, on the plot's side of it: near the middle and close to the line first.
  std::optional<Label> beside(const Wish& wish, const LabelPlot& plot, double size_mm,
                              bool is_outward) const {
    const glm::dvec2 from = point(wish.side);
    const glm::dvec2 to = point(net_.mesh().next(wish.side));
    const double length = glm::length(to - from);
    Label label = label_for(wish);
    label.size_mm = size_mm;
    label.box_mm = wish.words.box(size_mm);
    if (!(label.box_mm.x < length)) return std::nullopt;
    const glm::dvec2 along = (to - from) / length;
    // On the canvas y runs down, so a face lies to the right of its sides.
    const glm::dvec2 into = glm::dvec2(along.y, -along.x) * (is_outward ? -1.0 : 1.0);
    label.angle_rad = upright(std::atan2(along.y, along.x));
    label.is_on_tab = is_outward;
    for (const double distance : kFromSide)
      for (const double share : kAlong) {
        label.centre = (from + to) * 0.5 + along * (share * length) + into * (distance + label.box_mm.y / 2);
        if (plot.has_room_for(label)) return label;
      }
    return std::nullopt;
  }

  std::optional<Label> on_tab(const Wish& wish) const {
    const GlueTab* const tab = tabs_[wish.side];
    if (tab == nullptr) return std::nullopt;
    LabelPlot plot;
    const int piece = net_.piece[net_.mesh().face(wish.side)];
    for (const glm::dvec2 p : tab->points) plot.polygon.push_back(layout_.on_canvas_mm(piece, p));
    for (const double size : sizes_from(settings_.labels.size_mm))
      if (auto label = beside(wish, plot, size, true)) return label;
    return std::nullopt;
  }

  /// All of a face's wishes in one size, as many as can be had in the smallest.
  std::vector<Label> in_face(FaceId f, std::vector<Wish> wishes) {
    const Mesh& mesh = net_.mesh();
    std::ranges::sort(wishes, {},
                      [&](const Wish& w) { return std::pair(mesh.length(mesh.edge(w.side)), w.side); });
    const std::size_t n_before = plots_[f].taken.size();
    std::vector<Label> found;
    for (const double size : sizes_from(settings_.labels.size_mm)) {
      plots_[f].taken.resize(n_before);
      found.clear();
      for (const Wish& wish : wishes)
        if (auto label = beside(wish, plots_[f], size, false)) {
          plots_[f].taken.push_back(*label);
          found.push_back(*std::move(label));
        }
      if (found.size() == wishes.size()) break;
    }
    return found;
  }

  void number_edges() {
    const Mesh& mesh = net_.mesh();
    const IdVector<EdgeId, int> numbers =
        cut_numbers(net_, settings_.labels.skips_obvious, strip_cuts(layout_, settings_));
    std::vector<std::vector<Wish>> wishes(mesh.n_faces());
    std::vector<Label> found;
    for (const EdgeId e : mesh.edges()) {
      if (numbers[e] == 0) continue;
      const LabelWords words(measure_, number_words(numbers[e]));
      for (const HalfedgeId side : {mesh.halfedge(e), mesh.twin(mesh.halfedge(e))}) {
        if (auto label = on_tab({side, words}))
          found.push_back(*std::move(label));
        else
          wishes[mesh.face(side).index()].push_back({side, words});
      }
    }
    for (const FaceId f : mesh.faces())
      if (!wishes[f.index()].empty())
        for (Label& label : in_face(f, std::move(wishes[f.index()]))) found.push_back(std::move(label));
    keep_pairs(std::move(found), numbers);
  }

  /// A number that stands on one side only would be looked for in vain.
  void keep_pairs(std::vector<Label> found, const IdVector<EdgeId, int>& numbers) {
    const Mesh& mesh = net_.mesh();
    IdVector<EdgeId, int> sides(mesh.n_edges(), 0);
    for (const Label& label : found) ++sides[mesh.edge(label.side)];
    for (const EdgeId e : mesh.edges())
      if (numbers[e] != 0 && sides[e] < 2) placed_.left_out.push_back(e);
    for (Label& label : found) {
      if (sides[mesh.edge(label.side)] == 2) {
        placed_.labels.push_back(std::move(label));
      } else if (!label.is_on_tab) {
        std::erase_if(plots_[label.face].taken, [&](const Label& l) { return l.side == label.side; });
      }
    }
    std::ranges::sort(placed_.labels, {}, &Label::side);
  }

  /// Anywhere in a face, as near to its middle as can be.
  std::optional<Label> inside(FaceId f, Label::Kind kind, const LabelWords& words, double most_mm,
                              double least_mm) {
    Label label;
    label.kind = kind;
    label.words = words.words;
    label.face = f;
    label.canvas = canvas_of(f);
    for (double size = most_mm; size >= least_mm * 0.999; size *= kShrink) {
      label.size_mm = size;
      label.box_mm = words.box(size);
      for (const glm::dvec2 centre : plots_[f].places()) {
        label.centre = centre;
        if (plots_[f].has_room_for(label)) return label;
      }
    }
    return std::nullopt;
  }

  void add(Label label) {
    plots_[label.face].taken.push_back(label);
    placed_.labels.push_back(std::move(label));
  }

  void name_pieces() {
    constexpr std::size_t kMostFaces = 40;
    const Mesh& mesh = net_.mesh();
    std::vector<std::vector<FaceId>> faces(static_cast<std::size_t>(net_.n_pieces));
    for (const FaceId f : mesh.faces()) faces[static_cast<std::size_t>(net_.piece[f])].push_back(f);
    for (std::size_t piece = 0; piece < faces.size(); ++piece) {
      std::ranges::sort(faces[piece], {}, [&](FaceId f) { return std::pair(-mesh.area(f), f); });
      if (faces[piece].size() > kMostFaces) faces[piece].resize(kMostFaces);
      const LabelWords words(names_, piece_name(static_cast<int>(piece)));
      std::optional<Label> best;
      for (const FaceId f : faces[piece]) {
        const double least = best ? best->size_mm / kShrink : kLeastLabelSize;
        if (auto label = inside(f, Label::Kind::PieceName, words, kPieceNameSize, least))
          best = std::move(label);
      }
      if (best) add(*std::move(best));
    }
  }

  void write_angles() {
    const Mesh& mesh = net_.mesh();
    const IdVector<EdgeId, EdgeKind> kinds = drawn_kinds(net_, settings_);
    for (const FaceId f : mesh.faces()) {
      if (net_.tree.is_root(f)) continue;
      const HalfedgeId h = net_.tree.to_parent(f);
      const EdgeKind kind = kinds[mesh.edge(h)];
      if (kind != EdgeKind::Mountain && kind != EdgeKind::Valley) continue;
      const double degrees = std::abs(net_.dual->bend(mesh.edge(h))) * 57.295779513082321;
      const LabelWords words(measure_, std::to_string(std::lround(degrees)) + "°");
      write_angle(h, words) || write_angle(mesh.twin(h), words);
    }
  }

  bool write_angle(HalfedgeId side, const LabelWords& words) {
    const LabelPlot& plot = plots_[net_.mesh().face(side)];
    for (const double size : sizes_from(settings_.labels.size_mm * kSmallShare))
      if (auto label = beside({side, words, Label::Kind::FoldAngle}, plot, size, false)) {
        add(*std::move(label));
        return true;
      }
    return false;
  }

  void number_faces() {
    for (const FaceId f : net_.mesh().faces()) {
      const LabelWords words(measure_, "#" + std::to_string(f.index() + 1));
      if (auto label = inside(f, Label::Kind::FaceNumber, words, settings_.labels.size_mm * kSmallShare,
                              kLeastLabelSize))
        add(*std::move(label));
    }
  }

  static constexpr double kPieceNameSize = 7;
  static constexpr double kSmallShare = 0.85;

  const Net& net_;
  const PageLayout& layout_;
  const SheetSettings& settings_;
  IdVector<HalfedgeId, const GlueTab*> tabs_;
  IdVector<FaceId, LabelPlot> plots_;
  WordMeasure measure_{FontWeight::Regular};
  WordMeasure names_{FontWeight::SemiBold};
  PlacedLabels placed_;
};

bool is_obvious(const Net& net, HalfedgeId side, HalfedgeId next) {
  const Mesh& mesh = net.mesh();
  if (mesh.twin(side) != next) return false;
  const glm::dvec2 point = net.corner(next);
  const glm::dvec2 back = net.corner(side) - point;
  const glm::dvec2 on = net.corner(mesh.next(next)) - point;
  const double gap = std::atan2(cross(back, on), glm::dot(back, on));
  return gap > -1e-9 && gap < kObviousGap;
}

}  // namespace

std::array<glm::dvec2, 4> Label::corners() const {
  const glm::dvec2 x = glm::dvec2(std::cos(angle_rad), std::sin(angle_rad)) * (box_mm.x / 2);
  const glm::dvec2 y = glm::dvec2(-std::sin(angle_rad), std::cos(angle_rad)) * (box_mm.y / 2);
  return {centre - x - y, centre + x - y, centre + x + y, centre - x + y};
}

std::string number_words(int number) {
  std::string words = std::to_string(number);
  std::string turned;
  for (const char digit : words) {
    if (digit != '0' && digit != '6' && digit != '8' && digit != '9') return words;
    turned.insert(turned.begin(), digit == '6' ? '9' : digit == '9' ? '6' : digit);
  }
  return turned == words || turned.front() == '0' ? words : words + ".";
}

std::string piece_name(int piece) {
  std::string name;
  for (int rest = piece; rest >= 0; rest = rest / 26 - 1)
    name.insert(name.begin(), static_cast<char>('A' + rest % 26));
  return name;
}

IdVector<EdgeId, int> cut_numbers(const Net& net, bool skips_obvious, const std::vector<EdgeId>& tabless) {
  const Mesh& mesh = net.mesh();
  IdVector<EdgeId, int> numbers(mesh.n_edges(), 0);
  IdVector<EdgeId, char> is_skipped(mesh.n_edges(), 0);
  const std::vector<OutlineLoop> loops = outline_loops(net);
  for (const OutlineLoop& loop : loops)
    for (std::size_t i = 0; skips_obvious && i < loop.sides.size(); ++i)
      if (is_obvious(net, loop.sides[i], loop.sides[(i + 1) % loop.sides.size()]))
        is_skipped[mesh.edge(loop.sides[i])] = 1;
  for (const EdgeId e : tabless) is_skipped[e] = 0;
  int count = 0;
  for (const OutlineLoop& loop : loops)
    for (const HalfedgeId h : loop.sides) {
      const EdgeId e = mesh.edge(h);
      if (!mesh.is_border(e) && is_skipped[e] == 0 && numbers[e] == 0) numbers[e] = ++count;
    }
  return numbers;
}

PlacedLabels place_labels(const Net& net, const PageLayout& layout, const SheetSettings& settings) {
  return Labeller(net, layout, settings).run();
}

}  // namespace netwright
