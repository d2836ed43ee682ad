// The pictures on the sheets: colours where they belong, no seams, bleed past the outline and over the tabs,
// and an image of the wanted resolution in the files.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/polygon2.h"
#include "core/sheet/face_paint.h"
#include "core/sheet/outline.h"
#include "core/sheet/picture_canvas.h"
#include "core/sheet/write.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

using testing::net_of;

constexpr Pixel kRed{255, 0, 0, 255};
constexpr Pixel kNothing{0, 0, 0, 0};

PolygonSoup painted(PolygonSoup soup, const std::vector<glm::dvec3>& colours) {
  for (const glm::dvec3& colour : colours) soup.materials.push_back({"", colour, nullptr});
  for (int f = 0; f < soup.n_faces(); ++f) soup.face_material.push_back(f % static_cast<int>(colours.size()));
  return soup;
}

PolygonSoup red_cube() { return painted(shapes::cube(), {{1, 0, 0}}); }

/// Left half black, right half white, upper half half as bright.
std::shared_ptr<const Image> quarters(int size) {
  Image image{size, size, {}};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const auto value = static_cast<std::uint8_t>((x < size / 2 ? 0 : 200) + (y < size / 2 ? 0 : 50));
      image.rgba.insert(image.rgba.end(), {value, value, value, 255});
    }
  return std::make_shared<const Image>(std::move(image));
}

/// A square whose corners are those of the texture.
PolygonSoup textured_square(int size) {
  PolygonSoup soup;
  soup.name = "square";
  soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  soup.add_face(std::vector<int>{0, 1, 2, 3});
  soup.corner_uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  soup.face_material = {0};
  soup.materials = {{"", {1, 1, 1}, quarters(size)}};
  return soup;
}

Pixel at(const Picture& picture, glm::dvec2 page_mm) {
  const Image& image = *picture.image;
  const glm::dvec2 p = (page_mm - picture.at) / picture.size_mm * glm::dvec2(image.width, image.height);
  if (p.x < 0 || p.y < 0 || p.x >= image.width || p.y >= image.height) return kNothing;
  const auto i = 4 * (static_cast<std::size_t>(p.y) * static_cast<std::size_t>(image.width) +
                      static_cast<std::size_t>(p.x));
  return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2], image.rgba[i + 3]};
}

struct Printed {
  Net net;
  PageLayout layout;
  Sheet sheet;
  [[nodiscard]] glm::dvec2 on_page(glm::dvec2 net_point) const {
    return layout.on_page(layout.pages.front(), layout.on_canvas(0, net_point));
  }
};

Printed print(const PolygonSoup& soup, const SheetSettings& settings = {}, double tab_mm = 0) {
  Net net = net_of(soup);
  PageLayout layout = arrange(net, {}, {PrintSize::Kind::FitPage});
  if (tab_mm > 0) layout.tabs = testing::tabs_everywhere(net, layout.scale, tab_mm);
  testing::widen(layout, 8);
  Sheet sheet = draw_sheets(net, layout, {}, settings).front();
  return {std::move(net), std::move(layout), std::move(sheet)};
}

TEST(Pictures, PlainModelsPrintWhite) {
  for (const PolygonSoup& soup : {shapes::cube(), painted(shapes::cube(), {Material{}.colour}),
                                  painted(shapes::cube(), {glm::dvec3(0.3)})})
    EXPECT_TRUE(print(soup).sheet.pictures.empty());
  EXPECT_EQ(print(red_cube()).sheet.pictures.size(), 1U);
  SheetSettings settings;
  settings.pictures.is_on = false;
  EXPECT_TRUE(print(red_cube(), settings).sheet.pictures.empty());
}

TEST(Pictures, EveryFaceHasTheColourOfItsMaterial) {
  const std::vector<glm::dvec3> colours = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}, {0, 0, 0}};
  const Printed p = print(painted(shapes::cube(), colours));
  for (const FaceId f : p.net.mesh().faces()) {
    const glm::dvec3 c = 255.0 * colours[f.index()];
    const Pixel expected{static_cast<std::uint8_t>(c.r), static_cast<std::uint8_t>(c.g),
                         static_cast<std::uint8_t>(c.b), 255};
    EXPECT_EQ(at(p.sheet.pictures.front(), p.on_page(p.net.box(f).centre())), expected);
  }
}

TEST(Pictures, HaveNoSeamBetweenFaces) {
  const Printed p = print(painted(shapes::icosphere(2), {{1, 0, 0}}));
  const Image& image = *p.sheet.pictures.front().image;
  std::size_t n_red = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    const Pixel pixel{image.rgba[i], image.rgba[i + 1], image.rgba[i + 2], image.rgba[i + 3]};
    EXPECT_TRUE(pixel == kRed || pixel == kNothing);
    if (pixel == kRed) ++n_red;
  }
  // Across every fold of the net everything is covered.
  for (const FaceId f : p.net.mesh().faces()) {
    if (p.net.tree.is_root(f)) continue;
    const HalfedgeId h = p.net.tree.to_parent(f);
    const glm::dvec2 a = p.on_page(p.net.corner(h));
    const glm::dvec2 b = p.on_page(p.net.corner(p.net.mesh().next(h)));
    for (double t = 0; t <= 1; t += 0.01) EXPECT_EQ(at(p.sheet.pictures.front(), a + t * (b - a)), kRed);
  }
  EXPECT_GT(n_red, 10000U);
}

TEST(Pictures, GoOnPastTheOutlineAsFarAsAsked) {
  for (const double bleed : {0.5, 1.0, 2.0}) {
    SheetSettings settings;
    settings.pictures.bleed_mm = bleed;
    const Printed p = print(red_cube(), settings);
    for (const OutlineLoop& loop : outline_loops(p.net))
      for (const HalfedgeId h : loop.sides) {
        const glm::dvec2 a = p.on_page(p.net.corner(h));
        const glm::dvec2 b = p.on_page(p.net.corner(p.net.mesh().next(h)));
        const glm::dvec2 along = glm::normalize(b - a);
        const glm::dvec2 out(-along.y, along.x);
        const glm::dvec2 middle = (a + b) * 0.5;
        EXPECT_EQ(at(p.sheet.pictures.front(), middle + out * (bleed - 0.15)), kRed);
        EXPECT_EQ(at(p.sheet.pictures.front(), middle + out * (bleed + 0.15)), kNothing);
      }
  }
}

TEST(Pictures, AreCarriedOverTheTabsInFullFadedOrNotAtAll) {
  using OnTabs = PictureSettings::OnTabs;
  for (const OnTabs mode : {OnTabs::Full, OnTabs::Faded, OnTabs::White}) {
    SheetSettings settings;
    settings.pictures.on_tabs = mode;
    const Printed p = print(red_cube(), settings, 5);
    for (const GlueTab& tab : p.layout.tabs.tabs) {
      const auto place = [&](glm::dvec2 mm) {
        return p.layout.on_page(p.layout.pages.front(), p.layout.on_canvas_mm(0, mm));
      };
      const glm::dvec2 fold = (tab.points[0] + tab.points[1]) * 0.5;
      const glm::dvec2 rim = (tab.points[2] + tab.points[3]) * 0.5;
      const Picture& picture = p.sheet.pictures.front();
      EXPECT_EQ(at(picture, place(fold + 0.1 * (rim - fold))), kRed) << "bleed covers the fold";
      const Pixel middle = at(picture, place(fold + 0.7 * (rim - fold)));
      if (mode == OnTabs::White) {
        EXPECT_EQ(middle, kNothing);
      } else if (mode == OnTabs::Full) {
        EXPECT_EQ(middle, kRed);
      } else {
        EXPECT_EQ(middle[0], 255);
        EXPECT_GT(middle[1], 100);
        EXPECT_LT(middle[1], 220);
        EXPECT_EQ(middle[3], 255);
      }
    }
  }
}

TEST(Pictures, TakeNoMoreOfAPageThanTheFacesOnIt) {
  const Net net = net_of(red_cube());
  const PageLayout layout = arrange(net, {}, {PrintSize::Kind::Height, 150});
  ASSERT_GT(layout.pages.size(), 2U);
  SheetSettings settings;
  settings.pictures.dpi = 72;
  const std::vector<Sheet> sheets = draw_sheets(net, layout, {}, settings);
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    Box2 faces;
    const Box2 window = layout.pages[i].shown;
    for (const FaceId f : net.mesh().faces()) {
      Box2 box;
      for (const HalfedgeId h : net.mesh().halfedges(f)) box.add(layout.on_canvas(0, net.corner(h)));
      box = {glm::max(box.min - 1.0, window.min), glm::min(box.max + 1.0, window.max)};
      if (box.min.x < box.max.x && box.min.y < box.max.y) faces.add(box);
    }
    ASSERT_EQ(sheets[i].pictures.size(), faces.is_empty() ? 0U : 1U);
    if (!faces.is_empty()) {
      EXPECT_LT(glm::length(sheets[i].pictures[0].size_mm - faces.size()), 1);
    }
  }
}

TEST(Pictures, ShowTheTextureTheRightWayRound) {
  for (const int size : {2, 64, 512}) {
    const Printed p = print(textured_square(size));
    const auto value = [&](glm::dvec2 place) {
      const glm::dvec2 corner = p.net.corner(HalfedgeId(0));
      const glm::dvec2 x = p.net.corner(HalfedgeId(1)) - corner;
      const glm::dvec2 y = p.net.corner(HalfedgeId(3)) - corner;
      return at(p.sheet.pictures.front(), p.on_page(corner + x * place.x + y * place.y))[0];
    };
    EXPECT_NEAR(value({0.25, 0.25}), 50, 2);
    EXPECT_NEAR(value({0.75, 0.25}), 250, 2);
    EXPECT_NEAR(value({0.25, 0.75}), 0, 2);
    EXPECT_NEAR(value({0.75, 0.75}), 200, 2);
  }
}

TEST(Pictures, HaveTheResolutionThatIsAskedFor) {
  for (const int dpi : {72, 150, 300}) {
    SheetSettings settings;
    settings.pictures.dpi = dpi;
    const Printed p = print(red_cube(), settings);
    const Picture& picture = p.sheet.pictures.front();
    EXPECT_NEAR(picture.image->width / picture.size_mm.x, dpi / 25.4, 1e-9);
    EXPECT_NEAR(picture.image->height / picture.size_mm.y, dpi / 25.4, 1e-9);
    const testing::TemporaryFolder folder;
    write_file(folder / "out.pdf", pdf_bytes(std::vector{p.sheet}, "red"));
    const std::string list = testing::output_of({"pdfimages", "-list", (folder / "out.pdf").string()});
    const std::string size = std::to_string(picture.image->width) + "  ";
    EXPECT_NE(list.find(size), std::string::npos) << list;
    EXPECT_NE(list.find(" " + std::to_string(dpi) + " "), std::string::npos) << list;
  }
}

TEST(Pictures, AreMadeWhenAskedForWhereTheyWouldFillTheMemory) {
  const Net net = net_of(red_cube());
  SheetSettings settings;
  settings.pictures.dpi = 300;
  const PageLayout layout = arrange(net, {}, {PrintSize::Kind::Height, 300});
  ASSERT_GT(layout.pages.size(), 6U);
  double kept = 0;
  int n_later = 0;
  for (const Sheet& sheet : draw_sheets(net, layout, {}, settings))
    for (const Picture& picture : sheet.pictures) {
      if (picture.image) {
        kept += static_cast<double>(picture.image->width) * picture.image->height;
        EXPECT_TRUE(sheet.number > 1 || picture.later()->rgba == picture.image->rgba);
      } else if (++n_later == 1) {
        ASSERT_TRUE(picture.pixels());
        EXPECT_NEAR(picture.pixels()->width / picture.size_mm.x, 300 / 25.4, 1e-9);
      }
    }
  EXPECT_LE(kept, 60e6);
  EXPECT_GT(n_later, 0);
}

TEST(Pictures, LieInThePngWhereTheirFacesAre) {
  const Printed p = print(red_cube());
  const Image page = decode_image(png_bytes(p.sheet, 100));
  const glm::dvec2 place = p.on_page(p.net.box(FaceId(2)).centre()) * (100 / 25.4);
  const auto i = 4 * (static_cast<std::size_t>(place.y) * static_cast<std::size_t>(page.width) +
                      static_cast<std::size_t>(place.x));
  EXPECT_GT(page.rgba[i], 240);
  EXPECT_LT(page.rgba[i + 1], 20);
}

TEST(Pictures, MakeWordsAndLinesOnDarkGroundLight) {
  const Printed dark = print(painted(shapes::cube(), {{0.01, 0.01, 0.02}}), {}, 0);
  int n_labels = 0;
  for (const Text& text : dark.sheet.texts) {
    if (text.layer != Layer::Labels) continue;
    ++n_labels;
    EXPECT_GT(text.colour.r, 0.9);
  }
  EXPECT_GT(n_labels, 0);
  for (const Stroke& stroke : dark.sheet.strokes)
    if (stroke.layer == Layer::Mountain) {
      EXPECT_GT(stroke.colour.b, 0.6);
      EXPECT_GT(stroke.colour.r, stroke.colour.b) << "still of its own colour";
    }
  const auto light_cut = [](const Printed& p) {
    double length = 0;
    for (const Stroke& stroke : p.sheet.strokes)
      if (stroke.layer == Layer::Print && stroke.width_mm == SheetSettings{}.lines.cut.width_mm &&
          stroke.colour.r > 0.8)
        length += testing::length_of(stroke);
    return length;
  };
  const double outline = 14 * dark.layout.scale * dark.net.mesh().mean_edge();
  EXPECT_NEAR(light_cut(dark), outline, 0.01 * outline) << "all of the outline can be seen";
  const Printed light = print(painted(shapes::cube(), {{1, 1, 0.2}}), {}, 0);
  EXPECT_EQ(light_cut(light), 0);
  for (const Text& text : light.sheet.texts) EXPECT_LT(text.colour.r, 0.5);
  for (const Stroke& stroke : light.sheet.strokes)
    if (stroke.layer == Layer::Mountain) {
      EXPECT_EQ(stroke.colour, SheetSettings{}.lines.mountain.colour);
    }
}

TEST(Pictures, TakeAnyTextureCoordinates) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const glm::dvec2 uv : {glm::dvec2(nan, 0), {0, infinite}, {-infinite, nan}, {1e300, -1e300}})
    EXPECT_EQ(texture_at(*quarters(4), uv), texture_at(*quarters(4), {0, 0}));
  for (const double far : {-3.0, 7.0})
    EXPECT_EQ(texture_at(*quarters(4), {0.25 + far, 0.75 - far}), texture_at(*quarters(4), {0.25, 0.75}));
}

TEST(Pictures, StayWithinTheMemoryOnTheLargestPaper) {
  const Net net = net_of(red_cube());
  SheetSettings settings;
  settings.pictures.dpi = 600;
  const PageLayout layout = arrange(net, {"A0", Orientation::Portrait, 10}, {PrintSize::Kind::Height, 10});
  const std::vector<Sheet> sheets = draw_sheets(net, layout, {}, settings);
  const Picture& picture = sheets[0].pictures[0];
  const double pixels_per_mm = picture.image->width / picture.size_mm.x;
  EXPECT_LT(pixels_per_mm, 600 / 25.4);
  EXPECT_NEAR(pixels_per_mm * pixels_per_mm * layout.frame.net.size().x * layout.frame.net.size().y, 120e6,
              1);
}

TEST(PictureCanvas, GrowsToTheNearestPaintedPixel) {
  PictureCanvas canvas(40, 20);
  const FacePaint::Coat red{nullptr, kRed};
  const FacePaint::Coat blue{nullptr, {0, 0, 255, 255}};
  canvas.paint_triangle({{{5, 5}, {10, 5}, {5, 15}}}, {}, red);
  canvas.paint_triangle({{{30, 5}, {35, 5}, {35, 15}}}, {}, blue);
  canvas.open({{0, 0}, {40, 0}, {40, 20}, {0, 20}});
  canvas.grow(2, false);
  const Image image = std::move(canvas).image(false);
  const auto red_at = [&](std::size_t x, std::size_t y) { return image.rgba[4 * (y * 40 + x)] == 255; };
  for (std::size_t y = 0; y < 20; ++y)
    for (std::size_t x = 0; x < 40; ++x) EXPECT_EQ(image.rgba[4 * (y * 40 + x) + 3], 255);
  EXPECT_TRUE(red_at(18, 5));
  EXPECT_FALSE(red_at(21, 5));
  EXPECT_TRUE(red_at(0, 19));
  EXPECT_FALSE(red_at(39, 19));
}

TEST(PictureCanvas, IsGreyOnRequestAndMirrors) {
  PictureCanvas canvas(4, 1);
  canvas.paint_triangle({{{0, -1}, {2, 0.5}, {0, 2}}}, {}, {nullptr, kRed});
  Image image = std::move(canvas).image(true);
  EXPECT_EQ(image.rgba[0], 54);
  EXPECT_EQ(image.rgba[1], 54);
  mirror(image);
  EXPECT_EQ(image.rgba[12], 54);
  EXPECT_EQ(image.rgba[3], 0);
}

}  // namespace
}  // namespace netwright
