// Glue tabs: on every net of the zoo they cover nothing, every cut that has room gets one, and what the user
// asks of single edges is done as far as there is room.
#include "core/unfold/glue_tabs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/solve/solve.h"
#include "core/unfold/tab_choice.h"
#include "tests/support.h"
#include "tests/tab_check.h"

namespace netwright {
namespace {

using testing::find_faults;
using testing::has_room;
using testing::laid_faces;
using testing::make_dual;
using testing::zoo;

constexpr double kAreaOfRounding = 1e-6;  // mm²
constexpr double kDegree = 0.017453292519943295;

Net solved(const PolygonSoup& soup) {
  Progress progress;
  return solve(make_dual(soup), {.seed = 1, .streams = 1, .threads = 1}, progress).net;
}

/// So that the mean edge measures this much.
double scale_for_edge(const Net& net, double mean_edge_mm) { return mean_edge_mm / net.mesh().mean_edge(); }

bool is_cut(const Net& net, EdgeId e) { return !net.mesh().is_border(e) && !net.tree.is_fold(net.mesh(), e); }

const GlueTab* tab_on(const GlueTabs& tabs, HalfedgeId h) {
  for (const GlueTab& tab : tabs.tabs)
    if (tab.side == h) return &tab;
  return nullptr;
}

EdgeId some_cut(const Net& net) {
  for (const EdgeId e : net.mesh().edges())
    if (is_cut(net, e)) return e;
  return {};
}

TabSettings with_edit(const TabEdit& edit) {
  TabSettings settings;
  settings.edits.push_back(edit);
  return settings;
}

TEST(GlueTabs, CoverNoFaceAndNoOtherTab) {
  for (const auto& shape : zoo()) {
    const Net net = solved(shape.soup);
    for (const double edge_mm : {7.0, 15.0, 40.0})
      for (const auto pattern : {TabSettings::Pattern::BestSide, TabSettings::Pattern::Alternating,
                                 TabSettings::Pattern::BothSides}) {
        TabSettings settings;
        settings.pattern = pattern;
        settings.on_borders = true;
        const double scale = scale_for_edge(net, edge_mm);
        const auto faults = find_faults(net, scale, place_tabs(net, scale, settings));
        EXPECT_LT(faults.over_faces_mm2, kAreaOfRounding) << shape.soup.name << " " << edge_mm;
        EXPECT_LT(faults.over_tabs_mm2, kAreaOfRounding) << shape.soup.name << " " << edge_mm;
      }
  }
}

TEST(GlueTabs, EveryCutHasOneOrIsMissing) {
  for (const auto& shape : zoo()) {
    const Net net = solved(shape.soup);
    const GlueTabs tabs = place_tabs(net, scale_for_edge(net, 12), {});
    std::multiset<EdgeId> told(tabs.missing.begin(), tabs.missing.end());
    for (const GlueTab& tab : tabs.tabs) told.insert(net.mesh().edge(tab.side));
    for (const EdgeId e : net.mesh().edges())
      EXPECT_EQ(told.count(e), is_cut(net, e) ? 1U : 0U) << shape.soup.name << " edge " << e.value;
    EXPECT_LE(tabs.n_hopeless, tabs.missing.size());
  }
}

TEST(GlueTabs, AreTrapezoidsOnTheirSideAsWideAsTold) {
  for (const auto& shape : zoo()) {
    const Net net = solved(shape.soup);
    const double scale = scale_for_edge(net, 20);
    for (const GlueTab& tab : place_tabs(net, scale, {}).tabs) {
      const glm::dvec2 end = net.corner(net.mesh().next(tab.side)) * scale;
      const glm::dvec2 begin = net.corner(tab.side) * scale;
      EXPECT_NEAR(glm::length(tab.points[0] - end), 0, 1e-9);
      EXPECT_NEAR(glm::length(tab.points[1] - begin), 0, 1e-9);
      EXPECT_TRUE(is_convex(tab.points));
      EXPECT_GT(signed_area(tab.points), 0);
      EXPECT_GE(tab.width_mm, kLeastTabWidth * (1 - 1e-9));
      EXPECT_LE(tab.width_mm, std::min(5.0, glm::length(end - begin) / 2) * (1 + 1e-9));
      for (std::size_t i = 2; i < tab.points.size(); ++i)
        EXPECT_NEAR(cross(begin - end, tab.points[i] - end) / glm::length(begin - end), tab.width_mm, 1e-9);
    }
  }
}

TEST(GlueTabs, AreFoundForAlmostAllCutsThatHaveRoomAlone) {
  int n_room = 0;
  int n_tabbed = 0;
  for (const auto& shape : zoo()) {
    const Net net = solved(shape.soup);
    const double scale = scale_for_edge(net, 15);
    const GlueTabs tabs = place_tabs(net, scale, {});
    const auto faces = laid_faces(net, scale);
    for (const EdgeId e : net.mesh().edges()) {
      if (!is_cut(net, e)) continue;
      const HalfedgeId h = net.mesh().halfedge(e);
      if (!has_room(net, scale, faces, h, 2) && !has_room(net, scale, faces, net.mesh().twin(h), 2)) continue;
      ++n_room;
      n_tabbed += std::ranges::count(tabs.missing, e) == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(n_room, 500);
  EXPECT_GE(n_tabbed, 0.99 * n_room);
}

TEST(GlueTabs, LieInsideTheFaceTheyAreGluedTo) {
  for (const auto& shape : zoo()) {
    const Net net = solved(shape.soup);
    const double scale = scale_for_edge(net, 20);
    for (const GlueTab& tab : place_tabs(net, scale, {}).tabs) {
      if (!tab.lands_inside) continue;
      const Rigid2 beyond = net.placement[net.mesh().face(tab.side)] * net.dual->unroll(tab.side);
      std::vector<glm::dvec2> partner;
      for (const HalfedgeId h : net.mesh().halfedges(net.mesh().neighbour(tab.side)))
        partner.push_back(beyond(net.dual->flat(h)) * scale);
      double inside = 0;
      for (const auto& t : triangulate(partner)) {
        const auto corner = [&](std::size_t i) { return partner[static_cast<std::size_t>(t[i])]; };
        inside += testing::common_area(tab.points, {corner(0), corner(1), corner(2)});
      }
      const double area = signed_area(tab.points);
      EXPECT_NEAR(inside, area, 1e-3 * area) << shape.soup.name;
    }
  }
}

TEST(GlueTabs, ACubeGetsSevenWholeOnes) {
  const Net net = solved(shapes::cube());
  const GlueTabs tabs = place_tabs(net, scale_for_edge(net, 40), {});
  ASSERT_EQ(tabs.tabs.size(), 7U);
  EXPECT_TRUE(tabs.missing.empty());
  for (const GlueTab& tab : tabs.tabs) {
    EXPECT_DOUBLE_EQ(tab.width_mm, 5);
    EXPECT_TRUE(tab.lands_inside);
  }
}

TEST(GlueTabs, GoWhereTheUserWantsThem) {
  const Net net = solved(shapes::icosahedron());
  const double scale = scale_for_edge(net, 40);
  const EdgeId e = some_cut(net);
  const HalfedgeId h = net.mesh().halfedge(e);
  const HalfedgeId twin = net.mesh().twin(h);
  const auto sides = [&](TabSide side) {
    const GlueTabs tabs = place_tabs(net, scale, with_edit({e, side, {}, {}, {}}));
    return std::pair(tab_on(tabs, h) != nullptr, tab_on(tabs, twin) != nullptr);
  };
  EXPECT_EQ(sides(TabSide::First), std::pair(true, false));
  EXPECT_EQ(sides(TabSide::Second), std::pair(false, true));
  EXPECT_EQ(sides(TabSide::Both), std::pair(true, true));
  EXPECT_EQ(sides(TabSide::None), std::pair(false, false));
  EXPECT_TRUE(place_tabs(net, scale, with_edit({e, TabSide::None, {}, {}, {}})).missing.empty())
      << "what is not wanted is not missed";
}

TEST(GlueTabs, HaveTheWidthAndAnglesTheUserWants) {
  const Net net = solved(shapes::cube());
  const double scale = scale_for_edge(net, 60);
  const EdgeId e = some_cut(net);
  for (const TabSide side : {TabSide::First, TabSide::Second}) {
    const GlueTabs tabs = place_tabs(net, scale, with_edit({e, side, 9.0, 30 * kDegree, 20 * kDegree}));
    const HalfedgeId first = net.mesh().halfedge(e);
    const HalfedgeId h = side == TabSide::First ? first : net.mesh().twin(first);
    const GlueTab* const tab = tab_on(tabs, h);
    ASSERT_NE(tab, nullptr);
    EXPECT_NEAR(tab->width_mm, 9, 1e-9);
    ASSERT_EQ(tab->points.size(), 4U);
    const auto angle = [&](std::size_t corner, std::size_t rim, std::size_t other) {
      const glm::dvec2 a = glm::normalize(tab->points[rim] - tab->points[corner]);
      return std::acos(glm::dot(a, glm::normalize(tab->points[other] - tab->points[corner]))) / kDegree;
    };
    const double at_begin = angle(1, 2, 0);
    const double at_end = angle(0, 3, 1);
    EXPECT_NEAR(side == TabSide::First ? at_begin : at_end, 30, 1e-6);
    EXPECT_NEAR(side == TabSide::First ? at_end : at_begin, 20, 1e-6);
  }
}

TEST(GlueTabs, TakeTurnsAlongTheOutlineWhenTheyAlternate) {
  const Net net = solved(shapes::cube());
  TabSettings settings;
  settings.pattern = TabSettings::Pattern::Alternating;
  const GlueTabs tabs = place_tabs(net, scale_for_edge(net, 40), settings);
  const Mesh& mesh = net.mesh();
  HalfedgeId h = tabs.tabs.front().side;
  const HalfedgeId start = h;
  bool has_tab = true;
  do {
    EXPECT_EQ(tab_on(tabs, h) != nullptr, has_tab);
    has_tab = !has_tab;
    h = mesh.next(h);
    while (net.tree.is_fold(mesh, mesh.edge(h))) h = mesh.next(mesh.twin(h));
  } while (h != start);
}

TEST(GlueTabs, StandOnBordersOnlyWhenAsked) {
  const Net net = solved(shapes::grid_patch(4, 3));
  const double scale = scale_for_edge(net, 30);
  const auto n_on_borders = [&](const TabSettings& settings) {
    return std::ranges::count_if(place_tabs(net, scale, settings).tabs,
                                 [&](const GlueTab& tab) { return !net.mesh().twin(tab.side).is_valid(); });
  };
  EXPECT_EQ(n_on_borders({}), 0);
  TabSettings asked;
  asked.on_borders = true;
  EXPECT_EQ(n_on_borders(asked), static_cast<int>(net.mesh().n_border_edges()));
  EXPECT_TRUE(place_tabs(net, scale, no_tabs()).tabs.empty());
}

TEST(GlueTabs, AreLeftOutAndToldWhereEdgesAreTooShort) {
  const Net net = solved(shapes::icosphere(2));
  const GlueTabs tabs = place_tabs(net, 3.9 / net.mesh().mean_edge() / 2, {});
  EXPECT_TRUE(tabs.tabs.empty());
  EXPECT_EQ(tabs.missing.size(), tabs.n_hopeless);
  EXPECT_EQ(tabs.missing.size(), net.mesh().n_edges() - (net.mesh().n_faces() - 1));
}

/// The best sum of values by trying everything.
double best_by_trying(const std::vector<std::vector<TabOption>>& cuts, std::vector<const TabShape*>& taken,
                      std::size_t cut) {
  if (cut == cuts.size()) return 0;
  double best = best_by_trying(cuts, taken, cut + 1);
  for (const TabOption& option : cuts[cut]) {
    if (std::ranges::any_of(taken, [&](const TabShape* other) { return tabs_collide(option.shape, *other); }))
      continue;
    taken.push_back(&option.shape);
    best = std::max(best, option.value + best_by_trying(cuts, taken, cut + 1));
    taken.pop_back();
  }
  return best;
}

TEST(GlueTabs, ChoosesAsWellAsTryingEverything) {
  Random random(7);
  double chosen_sum = 0;
  double best_sum = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<std::vector<TabOption>> cuts(6);
    for (std::size_t cut = 0; cut < cuts.size(); ++cut)
      for (int k = 0; k < 3; ++k) {
        const double x = random.unit() * 20;
        const double y = random.unit() * 12;
        TabShape shape;
        shape.points = {glm::dvec2(x + 6, y), {x, y}, {x + 1, y - 4}, {x + 5, y - 4}};
        cuts[cut].push_back({HalfedgeId(static_cast<std::int32_t>(2 * cut)), shape, 1 + random.unit()});
      }
    const std::vector<int> chosen = choose_tabs(cuts);
    for (std::size_t a = 0; a < cuts.size(); ++a) {
      if (chosen[a] < 0) continue;
      const TabOption& option = cuts[a][static_cast<std::size_t>(chosen[a])];
      chosen_sum += option.value;
      for (std::size_t b = a + 1; b < cuts.size(); ++b) {
        if (chosen[b] < 0) continue;
        EXPECT_FALSE(tabs_collide(option.shape, cuts[b][static_cast<std::size_t>(chosen[b])].shape));
      }
    }
    std::vector<const TabShape*> taken;
    best_sum += best_by_trying(cuts, taken, 0);
  }
  EXPECT_GT(best_sum, 150);
  EXPECT_GE(chosen_sum, 0.99 * best_sum);
}

}  // namespace
}  // namespace netwright
