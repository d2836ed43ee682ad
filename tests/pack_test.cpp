// Pieces packed by their true outlines.
#include "core/sheet/pack_outlines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/base/polygon2.h"
#include "core/base/random.h"
#include "core/sheet/pages.h"
#include "core/sheet/piece_shapes.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

constexpr glm::dvec2 kPage(190, 250);

Outlines turned(Outlines outlines, const Rigid2& turn) {
  for (auto& outline : outlines)
    for (glm::dvec2& p : outline) p = turn(p);
  return outlines;
}

/// An L with legs of this length, 12 mm wide.
PieceToPack corner_piece(double leg) {
  return {{{{0, 0}, {leg, 0}, {leg, 12}, {12, 12}, {12, leg}, {0, leg}}}, 0};
}

void expect_packed_well(const std::vector<PieceToPack>& pieces, const std::vector<PackedOutline>& packed) {
  ASSERT_EQ(packed.size(), pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Outlines one = turned(pieces[i].outlines, packed[i].turn);
    for (const auto& outline : one)
      for (const glm::dvec2 p : outline) {
        EXPECT_GE(std::min(p.x, p.y), -1e-6);
        EXPECT_LE(p.x, kPage.x + 1e-6);
        EXPECT_LE(p.y, kPage.y + 1e-6);
      }
    for (std::size_t j = 0; j < i; ++j) {
      if (packed[i].page != packed[j].page) continue;
      const Outlines other = turned(pieces[j].outlines, packed[j].turn);
      EXPECT_GE(distance_between(one, other), 3 - 1e-6) << i << " and " << j;
      EXPECT_FALSE(contains(one.front(), other.front().front()));
      EXPECT_FALSE(contains(other.front(), one.front().front()));
    }
  }
}

TEST(PackOutlines, LaysCornersIntoEachOther) {
  // Boxes of 100 mm: two to a page. Nested, all of them fit one.
  const std::vector<PieceToPack> pieces(5, corner_piece(100));
  const auto packed = pack_outlines(pieces, kPage, 3, 1);
  ASSERT_TRUE(packed);
  expect_packed_well(pieces, *packed);
}

TEST(PackOutlines, KeepsTheGapWhateverTheShapes) {
  Random random(11);
  std::vector<PieceToPack> pieces;
  for (int i = 0; i < 40; ++i) {
    std::vector<glm::dvec2> outline;
    const int n = 3 + i % 7;
    for (int k = 0; k < n; ++k)
      outline.push_back(Rigid2::rotation(2 * 3.14159265 * k / n).rotate({8 + 25 * random.unit(), 0}));
    pieces.push_back({{outline}, 0});
  }
  const auto packed = pack_outlines(pieces, kPage, 3, 40);
  ASSERT_TRUE(packed);
  expect_packed_well(pieces, *packed);
  const auto again = pack_outlines(pieces, kPage, 3, 40);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    EXPECT_EQ((*again)[i].page, (*packed)[i].page);
    EXPECT_EQ((*again)[i].turn, (*packed)[i].turn);
  }
}

TEST(PackOutlines, SaysWhenThereAreTooFewPages) {
  const std::vector<PieceToPack> pieces(12, corner_piece(180));
  EXPECT_FALSE(pack_outlines(pieces, kPage, 3, 1));
  EXPECT_FALSE(pack_outlines({corner_piece(400)}, kPage, 3, 5));
}

TEST(PackOutlines, MeasuresTheDistanceOfOutlines) {
  const Outlines square = {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}};
  EXPECT_NEAR(distance_between(square, turned(square, {1, 0, 14, 3})), 4, 1e-12);
  EXPECT_NEAR(distance_between(square, turned(square, {1, 0, 13, 14})), 5, 1e-12);
  EXPECT_EQ(distance_between(square, turned(square, {1, 0, 5, 5})), 0);
}

TEST(Arrange, PacksBulkyNetsOnFewerPagesThanTheirBoxesTake) {
  PolygonSoup soup = shapes::star(5);
  for (int i = 1; i < 12; ++i) soup = shapes::combined(soup, shapes::star(5 + i % 3), {8.0 * i, 0, 0});
  const Net net = testing::net_of(soup);
  ASSERT_EQ(net.n_pieces, 12);
  const PageLayout layout = arrange(net, {}, {PrintSize::Kind::Scale}, TabSettings());
  EXPECT_EQ(layout.pages.size(), 1U) << "small pieces share a page";
  // From some size on outlines do better than boxes, and at none do pieces come too near to each other.
  for (const double scale : {8.0, 14.0, 20.0}) {
    PrintSize size{PrintSize::Kind::Scale};
    size.scale = scale;
    const PageLayout pages = arrange(net, {}, size, TabSettings());
    const PieceShapes shapes = piece_shapes(net, scale, pages.tabs);
    for (int i = 0; i < net.n_pieces; ++i)
      for (int j = 0; j < i; ++j) {
        const auto& one = pages.pieces[static_cast<std::size_t>(i)];
        const auto& other = pages.pieces[static_cast<std::size_t>(j)];
        if (one.canvas != other.canvas) continue;
        EXPECT_GE(distance_between(turned(shapes.pieces[static_cast<std::size_t>(i)].outlines, one.turn),
                                   turned(shapes.pieces[static_cast<std::size_t>(j)].outlines, other.turn)),
                  3 - 1e-6);
      }
  }
}

}  // namespace
}  // namespace netwright
