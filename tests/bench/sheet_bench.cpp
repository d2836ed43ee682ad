// What drawing and writing sheets costs on a torus of 800 faces that fills an A4 page: labels alone, sheets
// and their PDF, with and without a texture of 2048 pixels, at 300 dpi and with glue tabs.
#include <benchmark/benchmark.h>

#include <cmath>

#include "core/sheet/labels.h"
#include "core/sheet/write.h"
#include "core/solve/solve.h"
#include "tests/support.h"

namespace netwright {
namespace {

std::shared_ptr<const Image> picture() {
  constexpr int kSize = 2048;
  Image image{kSize, kSize, {}};
  Random random(3);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const auto shade = [&](double step) {
        return static_cast<std::uint8_t>(128 + 90 * std::sin(x * step) * std::cos(y * step * 1.3) +
                                         random.below(8));
      };
      image.rgba.insert(image.rgba.end(), {shade(0.011), shade(0.017), shade(0.023), 255});
    }
  return std::make_shared<const Image>(std::move(image));
}

/// A torus of 800 faces, its texture laid over it from above.
PolygonSoup model(bool is_textured) {
  PolygonSoup soup = shapes::torus(25, 16);
  if (!is_textured) return soup;
  Box3 box;
  for (const glm::dvec3& p : soup.points) box.add(p);
  for (const int corner : soup.corners) {
    const glm::dvec3 share = (soup.points[static_cast<std::size_t>(corner)] - box.min) / box.size();
    soup.corner_uv.emplace_back(share.x, share.z);
  }
  soup.materials = {{"", {1, 1, 1}, picture()}};
  soup.face_material.assign(static_cast<std::size_t>(soup.n_faces()), 0);
  return soup;
}

struct Scene {
  explicit Scene(bool is_textured) {
    Progress progress;
    net = solve(testing::make_dual(model(is_textured)), {}, progress).net;
    layout = arrange(net, {}, {}, TabSettings{});
    if (layout.tabs.tabs.empty()) layout.tabs = place_tabs(net, layout.scale, {});
  }
  Net net;
  PageLayout layout;
};

void labels(benchmark::State& state) {
  const Scene scene(false);
  SheetSettings settings;
  settings.labels.skips_obvious = false;
  for (auto _ : state) benchmark::DoNotOptimize(place_labels(scene.net, scene.layout, settings));
}
BENCHMARK(labels)->Unit(benchmark::kMillisecond);

void tabs(benchmark::State& state) {
  const Scene scene(false);
  for (auto _ : state) benchmark::DoNotOptimize(place_tabs(scene.net, scene.layout.scale, {}));
}
BENCHMARK(tabs)->Unit(benchmark::kMillisecond);

void sheets(benchmark::State& state, bool is_textured) {
  const Scene scene(is_textured);
  for (auto _ : state) benchmark::DoNotOptimize(draw_sheets(scene.net, scene.layout, {}));
}
BENCHMARK_CAPTURE(sheets, plain, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sheets, textured, true)->Unit(benchmark::kMillisecond);

void sheets_and_pdf(benchmark::State& state, bool is_textured) {
  const Scene scene(is_textured);
  for (auto _ : state) benchmark::DoNotOptimize(pdf_bytes(draw_sheets(scene.net, scene.layout, {}), "bench"));
}
BENCHMARK_CAPTURE(sheets_and_pdf, plain, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sheets_and_pdf, textured, true)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace netwright

BENCHMARK_MAIN();
