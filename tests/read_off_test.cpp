// The OFF reader: polygons of any size, its dialects, and the lies it must not believe.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/mesh/read.h"
#include "core/mesh/shapes.h"
#include "tests/model_files.h"

namespace netwright {
namespace {

using testing::to_off;

std::string refusal(const std::string& text) {
  try {
    read_soup_bytes("model.off", text);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Read);
    return error.what();
  }
  return "accepted";
}

TEST(ReadOff, KeepsPolygonsAsTheyAre) {
  const PolygonSoup gear = shapes::gear(80);  // its caps have 320 corners each
  const PolygonSoup soup = read_soup_bytes("gear.off", to_off(gear));
  EXPECT_EQ(soup.face_begin, gear.face_begin);
  EXPECT_EQ(soup.corners, gear.corners);
  EXPECT_EQ(soup.up_axis, UpAxis::Z);
}

TEST(ReadOff, LeavesOutColoursNormalsAndComments) {
  const PolygonSoup soup = read_soup_bytes("a.off",
                                           "COFF # coloured\n3 1 0\n\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255 # "
                                           "red\n0 1 0 0 0 255 255\n3 0 1 2 0.5 0.5 0.5\n");
  EXPECT_EQ(soup.points, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2}));
}

TEST(ReadOff, TakesCountsOnTheFirstLineAndWindowsLineEnds) {
  EXPECT_EQ(read_soup_bytes("a.off", "OFF 3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n").n_faces(), 1);
}

TEST(ReadOff, RefusesFacesThatNameMissingPoints) {
  PolygonSoup soup = shapes::icosphere(1);
  for (const int point : {99, 12, -1}) {
    soup.corners[4] = point;
    EXPECT_NE(refusal(to_off(soup)).find("face 2 names point " + std::to_string(point)), std::string::npos);
  }
}

TEST(ReadOff, RefusesNumbersThatAreNone) {
  EXPECT_NE(refusal("OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n").find("point 2"), std::string::npos);
  EXPECT_NE(refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\nthree 0 1 2\n").find("face 1"), std::string::npos);
  EXPECT_NE(refusal("OFF\nmany few 0\n").find("how many points"), std::string::npos);
}

TEST(ReadOff, RefusesAFileCutShortAnywhere) {
  const std::string text = to_off(shapes::icosphere(1));
  for (std::size_t n = 1; n < text.size() - 8; n += 11)
    EXPECT_NE(refusal(text.substr(0, n)), "accepted") << n;
}

TEST(ReadOff, RefusesTheDialectsItDoesNotSpeak) {
  EXPECT_NE(refusal("4OFF\n1 1 0\n0 0 0 0\n").find("dimensions"), std::string::npos);
  EXPECT_NE(refusal("OFF BINARY\n12345678901234567890").find("binary OFF"), std::string::npos);
}

}  // namespace
}  // namespace netwright
