// What packing by outlines saves: every model is unfolded, printed 200 mm high with tabs, cut into pieces
// that fit A6, and these are packed on A4 in their boxes and by their outlines. Usage: pack_bench MODEL…
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <vector>

#include "core/base/best_angle.h"
#include "core/base/error.h"
#include "core/mesh/read.h"
#include "core/project/make_model.h"
#include "core/sheet/pack.h"
#include "core/sheet/pack_outlines.h"
#include "core/sheet/page_frame.h"
#include "core/sheet/piece_shapes.h"
#include "core/sheet/split_to_fit.h"
#include "core/solve/solve.h"

namespace netwright {
namespace {

constexpr double kGap_mm = 3;

struct Totals {
  std::size_t n_pieces = 0;
  int n_in_boxes = 0;
  int n_by_outlines = 0;
  double area_pages = 0;
  double slowest_s = 0;
  double split_s = 0;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int pages_in_boxes(const PieceShapes& shapes, glm::dvec2 room, std::vector<PieceToPack>& to_pack) {
  std::vector<glm::dvec2> sizes;
  for (const PieceShape& piece : shapes.pieces) {
    const double angle = best_angle(piece.hull, [](glm::dvec2 size) { return size.x * size.y; });
    sizes.push_back(turned_box(piece.hull, angle).size());
    to_pack.push_back({piece.outlines, angle});
  }
  int n_pages = 0;
  for (const Packed& packed : pack(sizes, room, kGap_mm)) n_pages = std::max(n_pages, packed.page + 1);
  return n_pages;
}

void measure(const char* file, Totals& totals) {
  Progress progress;
  const MadeModel made =
      make_model(std::make_shared<const PolygonSoup>(read_soup(file)), {}, nullptr, progress);
  if (!made.dual) return;
  const SolveResult result = solve(made.dual, {.seed = 0, .streams = 1, .threads = 1}, progress, {});
  if (!result.is_proved) return;
  const PrintSize size{PrintSize::Kind::Height, 200};
  const auto any_fold = [](EdgeId) { return true; };
  auto start = std::chrono::steady_clock::now();
  const HandEdit edit = split_to_fit(result.net, {"A6"}, size, TabSettings(), any_fold);
  const double split_s = seconds_since(start);
  const Net net = layout(result.net.dual, edit.tree);
  const PieceShapes shapes = piece_shapes(net, *scale_of(net.mesh(), size), TabSettings());
  const glm::dvec2 room = page_frame({}).net.size();
  std::vector<PieceToPack> to_pack;
  const int n_in_boxes = pages_in_boxes(shapes, room, to_pack);
  start = std::chrono::steady_clock::now();
  const auto packed = pack_outlines(to_pack, room, kGap_mm, n_in_boxes);
  const double pack_s = seconds_since(start);
  int n_by_outlines = 0;
  if (packed)
    for (const PackedOutline& piece : *packed) n_by_outlines = std::max(n_by_outlines, piece.page + 1);
  const int n_pages = packed ? n_by_outlines : n_in_boxes;
  const double area_pages = shapes.area_mm2 / (room.x * room.y);
  std::printf(
      "%4zu pieces: %3d pages in boxes, %3d by outlines, %5.1f of paper; packed in %.3f s, split in %.3f s\n",
      to_pack.size(), n_in_boxes, n_pages, area_pages, pack_s, split_s);
  totals.n_pieces += to_pack.size();
  totals.n_in_boxes += n_in_boxes;
  totals.n_by_outlines += n_pages;
  totals.area_pages += area_pages;
  totals.slowest_s = std::max(totals.slowest_s, pack_s);
  totals.split_s = std::max(totals.split_s, split_s);
}

}  // namespace
}  // namespace netwright

int main(int argc, char** argv) {
  using namespace netwright;
  Totals totals;
  for (int i = 1; i < argc; ++i) {
    try {
      measure(argv[i], totals);
    } catch (const Error& error) {
      std::fprintf(stderr, "%s: %s\n", argv[i], error.what());
    }
  }
  std::printf(
      "all %zu pieces: %d pages in boxes, %d by outlines, %.1f pages of paper; slowest packing %.3f s, "
      "slowest split %.3f s\n",
      totals.n_pieces, totals.n_in_boxes, totals.n_by_outlines, totals.area_pages, totals.slowest_s,
      totals.split_s);
  return 0;
}
