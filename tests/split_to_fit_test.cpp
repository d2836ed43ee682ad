// Nets cut into the fewest pieces that fit a page.
#include "core/sheet/split_to_fit.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/best_angle.h"
#include "core/base/error.h"
#include "core/sheet/pages.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

using testing::net_of;

bool any_fold(EdgeId) { return true; }

PrintSize height(double mm) { return {PrintSize::Kind::Height, mm}; }

/// Does every piece fit a page by itself, without tabs?
bool all_fit(const Net& net, double scale, glm::dvec2 room) {
  std::vector<std::vector<glm::dvec2>> corners(static_cast<std::size_t>(net.n_pieces));
  for (const HalfedgeId h : net.mesh().halfedges())
    corners[static_cast<std::size_t>(net.piece[net.mesh().face(h)])].push_back(net.corner(h) * scale);
  return std::all_of(corners.begin(), corners.end(), [&](const std::vector<glm::dvec2>& points) {
    const auto hull = convex_hull(points);
    const auto cost = [&](glm::dvec2 size) { return std::max(size.x / room.x, size.y / room.y); };
    return cost(turned_box(hull, best_angle(hull, cost)).size()) <= 1 + 1e-9;
  });
}

/// Are all faces small enough for A4 with tabs at this height?
bool has_small_faces(const Mesh& mesh, double mm) {
  double largest = 0;
  for (const FaceId f : mesh.faces()) largest = std::max(largest, mesh.size(f));
  return largest * mm / mesh.height() < 140;
}

Net with_cuts(const Net& net, const std::vector<FaceId>& cuts) {
  UnfoldTree tree = net.tree;
  for (const FaceId f : cuts) tree.set_parent(f, HalfedgeId());
  return layout(net.dual, tree);
}

bool any_split_fits(const Net& net, const std::vector<FaceId>& folds, std::size_t from, int n_cuts,
                    std::vector<FaceId>& cuts, double scale, glm::dvec2 room) {
  if (n_cuts == 0) return all_fit(with_cuts(net, cuts), scale, room);
  for (std::size_t i = from; i < folds.size(); ++i) {
    cuts.push_back(folds[i]);
    const bool is_good = any_split_fits(net, folds, i + 1, n_cuts - 1, cuts, scale, room);
    cuts.pop_back();
    if (is_good) return true;
  }
  return false;
}

/// The fewest cuts of all that there are, by trying them all; -1 when more than `most`.
int fewest_cuts(const Net& net, double scale, const PaperSetup& paper, int most) {
  std::vector<FaceId> folds;
  for (const FaceId f : net.mesh().faces())
    if (!net.tree.is_root(f)) folds.push_back(f);
  for (int n = 0; n <= most; ++n)
    for (const PageFrame& frame : possible_frames(paper)) {
      std::vector<FaceId> cuts;
      if (any_split_fits(net, folds, 0, n, cuts, scale, frame.net.size())) return n;
    }
  return -1;
}

TEST(SplitToFit, CutsNothingThatFits) {
  const Net net = net_of(shapes::icosphere(1));
  EXPECT_TRUE(split_to_fit(net, {}, {}, no_tabs(), any_fold).cut.empty());
  EXPECT_TRUE(split_to_fit(net, {}, height(40), TabSettings(), any_fold).cut.empty());
}

TEST(SplitToFit, NeverMakesMorePiecesThanAllSplitsTried) {
  int n_compared = 0;
  for (const PolygonSoup& soup : {shapes::cube(), shapes::octahedron(), shapes::dodecahedron(),
                                  shapes::icosahedron(), shapes::cuboid({1, 4, 1}), shapes::letter_l()})
    for (const double mm : {90.0, 130.0, 180.0, 260.0}) {
      SCOPED_TRACE(soup.name + " at " + std::to_string(mm));
      const Net net = net_of(soup);
      const double scale = mm / net.mesh().height();
      const PaperSetup paper{"A5"};
      const int fewest = fewest_cuts(net, scale, paper, 4);
      if (fewest < 0) continue;
      const HandEdit edit = split_to_fit(net, paper, height(mm), no_tabs(), any_fold);
      EXPECT_EQ(static_cast<int>(edit.cut.size()), fewest);
      n_compared += fewest > 0 ? 1 : 0;
    }
  EXPECT_GE(n_compared, 8);
}

TEST(SplitToFit, EveryPieceFitsWithItsTabsAndIsPrintedWithoutTiles) {
  const std::vector<PolygonSoup> models{shapes::icosphere(2), shapes::torus(24, 9), shapes::gear(10),
                                        shapes::sand_clock(), shapes::open_cylinder(16, 3)};
  for (const double mm : {60.0, 105.0, 150.0, 195.0, 240.0, 300.0, 500.0})
    for (std::size_t i = 0; i < 2 * models.size(); ++i) {
      const TabSettings tabs = i % 2 == 0 ? no_tabs() : TabSettings();
      const Net net = net_of(models[i / 2]);
      if (!has_small_faces(net.mesh(), mm)) continue;
      const HandEdit edit = split_to_fit(net, {}, height(mm), tabs, any_fold);
      const Net split = layout(net.dual, edit.tree);
      EXPECT_EQ(split.n_pieces, static_cast<int>(edit.cut.size()) + 1);
      const PageLayout pages = arrange(split, {}, height(mm), tabs);
      for (const PageLayout::Canvas& canvas : pages.canvases)
        EXPECT_FALSE(canvas.is_tiled()) << net.mesh().name() << " " << mm;
    }
}

TEST(SplitToFit, LeavesFoldsThatMayNotBeCut) {
  const Net net = net_of(shapes::icosphere(2));
  // Half of all folds, picked by their numbers.
  const auto may_cut = [](EdgeId e) { return e.value % 2 == 0; };
  const HandEdit edit = split_to_fit(net, {}, height(300), no_tabs(), may_cut);
  EXPECT_GT(edit.cut.size(), 1U);
  for (const EdgeId e : edit.cut) EXPECT_TRUE(may_cut(e));
  const Net split = layout(net.dual, edit.tree);
  const double scale = 300 / net.mesh().height();
  const auto frames = possible_frames({});
  EXPECT_TRUE(std::any_of(frames.begin(), frames.end(),
                          [&](const PageFrame& frame) { return all_fit(split, scale, frame.net.size()); }));
}

TEST(SplitToFit, SaysWhenAFaceIsLargerThanThePaper) {
  try {
    split_to_fit(net_of(shapes::cube()), {"A6"}, height(200), no_tabs(), any_fold);
    FAIL() << "faces of 200 mm do not fit A6";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Usage);
    EXPECT_NE(std::string(error.what()).find("larger than a page of A6"), std::string::npos);
  }
}

}  // namespace
}  // namespace netwright
