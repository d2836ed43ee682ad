// The order in which seams are glued.
#include "core/unfold/gluing_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/unfold/steepest_edge.h"
#include "tests/support.h"

namespace netwright {
namespace {

Net some_net(const PolygonSoup& soup) {
  const auto dual = testing::make_dual(soup);
  Random random(3);
  return layout(dual, steepest_edge_tree(*dual, random));
}

TEST(GluingOrder, NamesEveryCutOnce) {
  for (const testing::ZooShape& shape : testing::zoo()) {
    const Net net = some_net(shape.soup);
    std::vector<EdgeId> cuts;
    for (const EdgeId e : net.mesh().edges())
      if (!net.mesh().is_border(e) && !net.tree.is_fold(net.mesh(), e)) cuts.push_back(e);
    std::vector<EdgeId> order = gluing_order(net);
    std::ranges::sort(order);
    EXPECT_EQ(order, cuts) << shape.soup.name;
  }
}

TEST(GluingOrder, EverySeamOfABallClosesAPoint) {
  for (const PolygonSoup& soup : {shapes::cube(), shapes::icosphere(2), shapes::globe(5, 8)}) {
    const Net net = some_net(soup);
    const Mesh& mesh = net.mesh();
    IdVector<VertexId, int> n_open(mesh.n_vertices(), 0);
    const std::vector<EdgeId> order = gluing_order(net);
    const auto ends = [&](EdgeId e) {
      return std::array{mesh.from(mesh.halfedge(e)), mesh.to(mesh.halfedge(e))};
    };
    for (const EdgeId e : order)
      for (const VertexId v : ends(e)) ++n_open[v];
    for (const EdgeId e : order) {
      const auto [a, b] = ends(e);
      EXPECT_TRUE(n_open[a] == 1 || n_open[b] == 1) << soup.name << ": all but two faces are joined there";
      --n_open[a];
      --n_open[b];
    }
  }
}

TEST(GluingOrder, TheLastSeamHasTheMostRoom) {
  // One cap of the pyramid's needle is tiny; the last seam is at the wide end.
  const Net net = some_net(shapes::pyramid(5, 4));
  const Mesh& mesh = net.mesh();
  const auto room = [&](EdgeId e) {
    double sum = 0;
    for (const HalfedgeId h : mesh.halfedges())
      for (const VertexId v : {mesh.from(mesh.halfedge(e)), mesh.to(mesh.halfedge(e))})
        if (mesh.from(h) == v) sum += mesh.area(mesh.face(h));
    return sum;
  };
  const std::vector<EdgeId> order = gluing_order(net);
  ASSERT_FALSE(order.empty());
  for (const EdgeId e : order) EXPECT_LE(room(e), room(order.back()) + 1e-9);
}

}  // namespace
}  // namespace netwright
