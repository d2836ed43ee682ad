// From wishes to tabs: lists the options of every cut, values them, and has the best ones chosen together.
#include "core/unfold/glue_tabs.h"

#include <algorithm>
#include <array>

#include "core/unfold/tab_choice.h"
#include "core/unfold/tab_shapes.h"

namespace netwright {

namespace {

// Having a tab at all counts for more than anything about it; then that it lands on its face, its width, and
// how much of the edge it holds.
constexpr double kValueOfTab = 20;
constexpr double kValueOfLanding = 4;
constexpr double kValueOfWidth = 4;
constexpr double kValueOfRim = 1;
constexpr double kValueOfTurn = 3;  ///< of keeping to the alternation

class Tabs {
 public:
  Tabs(const Net& net, double scale, const TabSettings& settings)
      : net_(net), mesh_(net.mesh()), scale_(scale), settings_(settings) {
    std::vector<std::vector<SideGrid::Side>> sides(static_cast<std::size_t>(net.n_pieces));
    for (const HalfedgeId h : mesh_.halfedges())
      if (!is_covered(h)) sides[piece(h)].push_back(side(h));
    for (std::vector<SideGrid::Side>& of_piece : sides)
      grids_.emplace_back(std::move(of_piece), 2 * settings.width_mm);
    if (settings.pattern == TabSettings::Pattern::Alternating) find_turns();
  }

  GlueTabs place() {
    for (const EdgeId e : mesh_.edges()) add_cut(e);
    const std::vector<int> chosen = choose_tabs(options_);
    for (std::size_t cut = 0; cut < chosen.size(); ++cut) {
      if (chosen[cut] < 0) {
        if (is_wanted_[cut] != 0) miss(edges_[cut], options_[cut].empty());
        continue;
      }
      const TabOption& option = options_[cut][static_cast<std::size_t>(chosen[cut])];
      const auto polygon = option.shape.polygon();
      result_.tabs.push_back(
          {option.side, {polygon.begin(), polygon.end()}, option.shape.width_mm, option.shape.lands_inside});
    }
    std::ranges::sort(result_.tabs, {}, &GlueTab::side);
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool is_covered(HalfedgeId h) const {
    return mesh_.twin(h).is_valid() && net_.tree.is_fold(mesh_, mesh_.edge(h));
  }
  [[nodiscard]] std::size_t piece(HalfedgeId h) const {
    return static_cast<std::size_t>(net_.piece[mesh_.face(h)]);
  }
  [[nodiscard]] SideGrid::Side side(HalfedgeId h) const {
    return {h, net_.corner(h) * scale_, net_.corner(mesh_.next(h)) * scale_};
  }

  [[nodiscard]] const TabEdit* edit(EdgeId e) const {
    const auto found = std::ranges::lower_bound(settings_.edits, e, {}, &TabEdit::edge);
    return found != settings_.edits.end() && found->edge == e ? &*found : nullptr;
  }

  [[nodiscard]] TabWish wish(HalfedgeId h) const {
    TabWish wish{settings_.width_mm, settings_.angle_rad, settings_.angle_rad};
    if (const TabEdit* const own = edit(mesh_.edge(h))) {
      wish.width_mm = own->width_mm.value_or(wish.width_mm);
      wish.from_angle_rad = own->first_angle_rad.value_or(wish.from_angle_rad);
      wish.to_angle_rad = own->second_angle_rad.value_or(wish.to_angle_rad);
      if (h != mesh_.halfedge(mesh_.edge(h))) std::swap(wish.from_angle_rad, wish.to_angle_rad);
    }
    return wish;
  }

  /// The face the tab is glued to, laid down beyond the side, from the side's end on.
  [[nodiscard]] std::vector<glm::dvec2> partner(HalfedgeId h) const {
    std::vector<glm::dvec2> corners;
    const HalfedgeId twin = mesh_.twin(h);
    if (!twin.is_valid()) return corners;
    const Rigid2 placement = net_.placement[mesh_.face(h)] * net_.dual->unroll(h);
    HalfedgeId corner = twin;
    do {
      corners.push_back(placement(net_.dual->flat(corner)) * scale_);
      corner = mesh_.next(corner);
    } while (corner != twin);
    corners[0] = side(h).to;
    corners[1] = side(h).from;
    return corners;
  }

  void add_options(HalfedgeId h, std::vector<TabOption>& options) const {
    const TabWish wished = wish(h);
    for (const TabShape& shape : tab_shapes(grids_[piece(h)], side(h), wished, partner(h))) {
      double value =
          kValueOfTab + kValueOfWidth * shape.width_mm / wished.width_mm + kValueOfRim * shape.rim_share;
      if (shape.lands_inside) value += kValueOfLanding;
      if (!has_turn_.empty() && has_turn_[h] != 0) value += kValueOfTurn;
      options.push_back({h, shape, value});
    }
  }

  void add_cut(EdgeId e) {
    const HalfedgeId first = mesh_.halfedge(e);
    const TabEdit* const own = edit(e);
    TabSide asked = own != nullptr ? own->side : TabSide::Auto;
    if (is_covered(first) || asked == TabSide::None) return;
    const HalfedgeId second = mesh_.twin(first);
    if (!second.is_valid()) {
      if (settings_.on_borders || asked != TabSide::Auto) add(e, {first});
      return;
    }
    if (asked == TabSide::Auto && settings_.pattern == TabSettings::Pattern::BothSides) asked = TabSide::Both;
    switch (asked) {
      case TabSide::First:
        add(e, {first});
        break;
      case TabSide::Second:
        add(e, {second});
        break;
      case TabSide::Both:
        add(e, {first});
        add(e, {second});
        break;
      default:
        add(e, {first, second});
    }
  }

  void add(EdgeId e, std::initializer_list<HalfedgeId> sides) {
    std::vector<TabOption> options;
    for (const HalfedgeId h : sides) add_options(h, options);
    options_.push_back(std::move(options));
    edges_.push_back(e);
    is_wanted_.push_back(mesh_.is_border(e) ? 0 : 1);
  }

  void miss(EdgeId e, bool is_hopeless) {
    if (!result_.missing.empty() && result_.missing.back() == e) return;  // the other side of a cut with two
    result_.missing.push_back(e);
    if (is_hopeless) ++result_.n_hopeless;
  }

  /// Every other side along the outlines: the two sides of a cut lie an odd number of sides apart, but for
  /// models with handles.
  void find_turns() {
    has_turn_.assign(mesh_.n_halfedges(), 0);
    std::vector<char> is_done(mesh_.n_halfedges(), 0);
    for (const HalfedgeId start : mesh_.halfedges()) {
      if (is_covered(start) || is_done[start.index()] != 0) continue;
      char turn = 1;
      HalfedgeId h = start;
      do {
        is_done[h.index()] = 1;
        has_turn_[h] = turn;
        turn = static_cast<char>(1 - turn);
        h = next_uncovered(h);
      } while (h != start);
    }
  }
  [[nodiscard]] HalfedgeId next_uncovered(HalfedgeId h) const {
    h = mesh_.next(h);
    while (is_covered(h)) h = mesh_.next(mesh_.twin(h));
    return h;
  }

  const Net& net_;
  const Mesh& mesh_;
  double scale_;
  const TabSettings& settings_;
  std::vector<SideGrid> grids_;
  IdVector<HalfedgeId, char> has_turn_;  ///< empty unless tabs alternate
  std::vector<std::vector<TabOption>> options_;
  std::vector<EdgeId> edges_;
  std::vector<char> is_wanted_;
  GlueTabs result_;
};

}  // namespace

GlueTabs place_tabs(const Net& net, double scale, const TabSettings& settings) {
  if (!settings.is_on) return {};
  return Tabs(net, scale, settings).place();
}

}  // namespace netwright
