// Pins that move from one mesh of a model to another.
#include "core/project/carry_pins.h"

#include <gtest/gtest.h>

#include "core/base/progress.h"
#include "core/mesh/simplify.h"
#include "tests/pins.h"
#include "tests/support.h"

namespace netwright {
namespace {

TEST(CarryPins, TheSameMeshKeepsThemAll) {
  Random random(2);
  for (const auto& shape : testing::zoo()) {
    const auto dual = testing::make_dual(shape.soup);
    const Constraints pins = testing::random_pins(*dual, 3, random);
    const CarriedPins carried = carry_pins(pins, dual->mesh(), *testing::make_mesh(shape.soup));
    EXPECT_EQ(carried.n_lost, 0) << shape.soup.name;
    EXPECT_EQ(carried.pins, pins) << shape.soup.name;
    EXPECT_EQ(carried.sentence(), "");
  }
}

TEST(CarryPins, SimplifyingKeepsWhatLiesNear) {
  const auto mesh = testing::make_mesh(shapes::icosphere(8));
  Constraints pins;
  pins.root = FaceId(17);
  for (const int e : {5, 200, 300}) set_pin(pins, EdgeId(e), EdgePin::MustFold);
  for (const int e : {44, 400}) set_pin(pins, EdgeId(e), EdgePin::MustCut);
  Progress progress;
  const Simplifier simplifier(mesh, {}, progress);
  const auto simple = testing::make_mesh(simplifier.soup_at(240));
  const CarriedPins carried = carry_pins(pins, *mesh, *simple);
  EXPECT_EQ(
      carried.pins.must_fold.size() + carried.pins.must_cut.size() + static_cast<std::size_t>(carried.n_lost),
      5u);
  EXPECT_GE(carried.pins.must_fold.size() + carried.pins.must_cut.size(), 3u);
  ASSERT_TRUE(carried.pins.root.is_valid());
  EXPECT_LT(glm::length(simple->centre(carried.pins.root) - mesh->centre(pins.root)),
            simple->size(carried.pins.root));
}

TEST(CarryPins, WhatFindsNoPlaceIsCounted) {
  const auto mesh = testing::make_mesh(shapes::cube());
  Constraints pins;
  pins.root = FaceId(0);
  set_pin(pins, EdgeId(0), EdgePin::MustCut);
  PolygonSoup moved = shapes::cube();
  for (auto& point : moved.points) point += glm::dvec3(50, 0, 0);
  const CarriedPins carried = carry_pins(pins, *mesh, *testing::make_mesh(moved));
  EXPECT_EQ(carried.n_lost, 2);
  EXPECT_TRUE(carried.pins.are_free());
  EXPECT_NE(carried.sentence().find("2 pins"), std::string::npos);
}

}  // namespace
}  // namespace netwright
