// The OBJ with the net as texture coordinates: read back by our own reader and held against the net.
#include "core/sheet/net_obj.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/mesh/read.h"
#include "core/sheet/write.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

using testing::net_of;
using testing::TemporaryFolder;

/// Every side of every face has its length on paper.
void expect_true_lengths(const PolygonSoup& soup, const PageLayout& layout) {
  ASSERT_EQ(soup.corner_uv.size(), soup.corners.size());
  for (int f = 0; f < soup.n_faces(); ++f) {
    const auto first = static_cast<std::size_t>(soup.face_begin[static_cast<std::size_t>(f)]);
    const auto& canvas =
        layout.canvases[static_cast<std::size_t>(soup.face_material[static_cast<std::size_t>(f)])];
    const glm::dvec2 size(canvas.width_mm, canvas.height_mm);
    const std::size_t n = soup.face(f).size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = first + i;
      const std::size_t b = first + (i + 1) % n;
      const double on_paper = glm::length((soup.corner_uv[a] - soup.corner_uv[b]) * size);
      const glm::dvec3 in_space = soup.points[static_cast<std::size_t>(soup.corners[a])] -
                                  soup.points[static_cast<std::size_t>(soup.corners[b])];
      EXPECT_NEAR(on_paper, glm::length(in_space) * layout.scale, 1e-4);
    }
  }
}

TEST(NetObj, HasEveryFaceInItsPaperSize) {
  const TemporaryFolder folder;
  const Net net = net_of(shapes::star(7));
  const PageLayout layout = arrange(net, {}, {});
  const auto files = write_drawing(folder / "star.obj", net, layout, {}).files;
  ASSERT_EQ(files.size(), 3U);
  const PolygonSoup soup = read_soup(files[0]);
  EXPECT_EQ(soup.n_faces(), static_cast<int>(net.mesh().n_faces()));
  EXPECT_EQ(soup.points.size(), net.mesh().n_vertices());
  EXPECT_TRUE(soup.notices.empty());
  ASSERT_EQ(soup.materials.size(), 1U);
  EXPECT_NE(soup.materials[0].texture, nullptr);
  expect_true_lengths(soup, layout);
}

TEST(NetObj, HasAPictureForEachSheetAlsoOfATiledPiece) {
  const TemporaryFolder folder;
  const Net net = net_of(shapes::combined(shapes::cube(), shapes::cube(), {5, 0, 0}));
  for (const double height_mm : {50.0, 150.0}) {
    const PageLayout layout = arrange(net, {}, {PrintSize::Kind::Height, height_mm});
    ASSERT_EQ(layout.canvases.size(), 2U);
    EXPECT_EQ(layout.canvases[0].is_tiled(), height_mm > 100);
    const auto files = write_drawing(folder / "two.obj", net, layout, {}, {}, {.png_dpi = 72}).files;
    ASSERT_EQ(files.size(), 4U);
    EXPECT_EQ(files[3].filename(), "two_2.png");
    const PolygonSoup soup = read_soup(files[0]);
    ASSERT_EQ(soup.materials.size(), 2U);
    expect_true_lengths(soup, layout);
  }
}

TEST(NetObj, ShowsTheOutlineOfTheNetWhereItsCornersAre) {
  const TemporaryFolder folder;
  const Net net = net_of(shapes::cube());
  const PageLayout layout = arrange(net, {}, {});
  const auto files = write_drawing(folder / "cube.obj", net, layout, {}, {}, {.png_dpi = 150}).files;
  const PolygonSoup soup = read_soup(files[0]);
  const Image& picture = *soup.materials[0].texture;
  const auto grey = [&](glm::dvec2 uv) {
    int darkest = 255;
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy) {
        const int x = std::clamp(static_cast<int>(uv.x * picture.width) + dx, 0, picture.width - 1);
        const int y = std::clamp(static_cast<int>((1 - uv.y) * picture.height) + dy, 0, picture.height - 1);
        darkest = std::min<int>(darkest, picture.rgba[4 * static_cast<std::size_t>(y * picture.width + x)]);
      }
    return darkest;
  };
  for (int f = 0; f < 6; ++f) {
    glm::dvec2 centre(0);
    for (std::size_t i = 0; i < 4; ++i) {
      const glm::dvec2 uv = soup.corner_uv[4 * static_cast<std::size_t>(f) + i];
      EXPECT_LT(grey(uv), 200) << "lines meet at the corner";
      centre += uv / 4.0;
    }
    EXPECT_EQ(grey(centre), 255) << "nothing but paper";
  }
}

TEST(NetObj, NeverReplacesAModelThatItDidNotWrite) {
  const TemporaryFolder folder;
  const Net net = net_of(shapes::cube());
  const PageLayout layout = arrange(net, {}, {});
  write_file(folder / "model.obj", "v 0 0 0\n");
  try {
    write_drawing(folder / "model.obj", net, layout, {});
    ADD_FAILURE() << "nothing was refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Write);
  }
  EXPECT_EQ(read_file(folder / "model.obj", 100), "v 0 0 0\n");
  EXPECT_EQ(folder.files().size(), 1U);
  write_drawing(folder / "net.obj", net, layout, {}, {}, {.png_dpi = 72});
  EXPECT_EQ(write_drawing(folder / "net.obj", net, layout, {}, {}, {.png_dpi = 72}).files.size(), 3U);
}

}  // namespace
}  // namespace netwright
