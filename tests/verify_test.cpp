// The independent proof: it accepts good nets of every size and rejects each planted error. The nets are laid
// out here by hand, so that nothing of the program under test is needed to make them.
#include "core/unfold/verify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "core/base/geometry.h"
#include "core/base/predicates.h"
#include "core/base/random.h"

namespace netwright {
namespace {

using Faces = std::vector<std::vector<int>>;

struct Solid {
  std::vector<glm::dvec3> points;
  Faces faces;
};

std::size_t at(int i) { return static_cast<std::size_t>(i); }

glm::dvec3 newell(const Solid& solid, int face) {
  const std::vector<int>& f = solid.faces[at(face)];
  glm::dvec3 n(0);
  for (std::size_t i = 1; i + 1 < f.size(); ++i) {
    n += glm::cross(solid.points[at(f[i])] - solid.points[at(f[0])],
                    solid.points[at(f[i + 1])] - solid.points[at(f[0])]);
  }
  return glm::normalize(n);
}

/// Corners of a face in a plane of its own.
std::vector<glm::dvec2> flatten(const Solid& solid, int face) {
  const std::vector<int>& f = solid.faces[at(face)];
  const glm::dvec3 origin = solid.points[at(f[0])];
  const glm::dvec3 u = glm::normalize(solid.points[at(f[1])] - origin);
  const glm::dvec3 v = glm::cross(newell(solid, face), u);
  std::vector<glm::dvec2> flat;
  for (const int c : f)
    flat.emplace_back(glm::dot(solid.points[at(c)] - origin, u), glm::dot(solid.points[at(c)] - origin, v));
  return flat;
}

/// Corner i of `face` such that side i runs b -> a where `other` has a side a -> b; -1 when they share none.
std::pair<int, int> shared_side(const Solid& solid, int face, int other) {
  const std::vector<int>& f = solid.faces[at(face)];
  const std::vector<int>& g = solid.faces[at(other)];
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t j = 0; j < g.size(); ++j) {
      if (f[i] == g[(j + 1) % g.size()] && f[(i + 1) % f.size()] == g[j]) {
        return {static_cast<int>(i), static_cast<int>(j)};
      }
    }
  }
  return {-1, -1};
}

double bend_of(const Solid& solid, int face, int side, int other) {
  const std::vector<int>& f = solid.faces[at(face)];
  const glm::dvec3 along =
      glm::normalize(solid.points[at(f[at(side + 1) % f.size()])] - solid.points[at(f[at(side)])]);
  const glm::dvec3 a = newell(solid, face);
  const glm::dvec3 b = newell(solid, other);
  return std::atan2(glm::dot(glm::cross(a, b), along), glm::dot(a, b));
}

/// Lays `solid` out along a forest; parents come before their children in `order`. parent -1 starts a piece.
FlatNet unfold_by_hand(const Solid& solid, const std::vector<std::pair<int, int>>& order_and_parent) {
  FlatNet net;
  net.faces.resize(solid.faces.size());
  std::map<std::pair<int, int>, FlatNet::Edge> edges;
  int n_pieces = 0;
  for (const auto& [face, parent] : order_and_parent) {
    const std::vector<int>& f = solid.faces[at(face)];
    const std::vector<glm::dvec2> flat = flatten(solid, face);
    std::vector<int>& corners = net.faces[at(face)];
    corners.assign(f.size(), -1);
    Rigid2 motion;
    motion.x = parent < 0 ? 100.0 * n_pieces++ : 0;
    if (parent >= 0) {
      const auto [i, j] = shared_side(solid, face, parent);
      const std::size_t next = at(i + 1) % f.size();
      const std::vector<int>& g = net.faces[at(parent)];
      corners[at(i)] = g[at(j + 1) % g.size()];
      corners[next] = g[at(j)];
      const glm::dvec2 from = flat[next] - flat[at(i)];
      const glm::dvec2 start = net.points[at(corners[at(i)])];
      const glm::dvec2 to = net.points[at(corners[next])] - start;
      const double scale = 1 / (glm::length(from) * glm::length(to));
      motion.cos = glm::dot(from, to) * scale;
      motion.sin = cross(from, to) * scale;
      const glm::dvec2 offset = start - motion.rotate(flat[at(i)]);
      motion.x = offset.x;
      motion.y = offset.y;
      const double bend = bend_of(solid, face, i, parent);
      const int low = std::min(corners[at(i)], corners[next]);
      const int high = std::max(corners[at(i)], corners[next]);
      edges[{low, high}] = {low, high, bend > 0 ? Assignment::Mountain : Assignment::Valley, -bend};
      if (std::abs(bend) < 1e-6) edges[{low, high}].assignment = Assignment::Flat;
    }
    for (std::size_t i = 0; i < f.size(); ++i) {
      if (corners[i] >= 0) continue;
      corners[i] = static_cast<int>(net.points.size());
      net.points.push_back(motion(flat[i]));
      net.folded.push_back(solid.points[at(f[i])]);
    }
  }
  for (const std::vector<int>& f : net.faces) {
    net.face_source.push_back(static_cast<int>(net.face_source.size()));
    for (std::size_t i = 0; i < f.size(); ++i) {
      const int low = std::min(f[i], f[(i + 1) % f.size()]);
      const int high = std::max(f[i], f[(i + 1) % f.size()]);
      edges.try_emplace({low, high}, FlatNet::Edge{low, high, Assignment::Boundary, 0});
    }
  }
  for (const auto& entry : edges) net.edges.push_back(entry.second);
  return net;
}

Solid box(double x = 1, double y = 1, double z = 1) {
  return {{{0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}, {0, 0, z}, {x, 0, z}, {x, y, z}, {0, y, z}},
          {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
}

/// The Latin cross.
FlatNet cross_net(const Solid& solid = box()) {
  return unfold_by_hand(solid, {{2, -1}, {0, 2}, {1, 2}, {3, 2}, {5, 2}, {4, 3}});
}

/// A flat patch of 2 x 2 squares, cut from the middle of the right side to the centre.
FlatNet patch_net() {
  Solid patch;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) patch.points.emplace_back(x, y, 0);
  }
  patch.faces = {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8, 7}};
  return unfold_by_hand(patch, {{0, -1}, {1, 0}, {2, 0}, {3, 2}});
}

/// Eight triangles around a saddle point whose angles sum up to 480 degrees, unfolded as one fan.
FlatNet saddle_net(const std::vector<double>& radii) {
  Solid saddle;
  saddle.points.emplace_back(0, 0, 0);
  const double cos_squared = 1.5 / (1 + std::sqrt(0.5));
  for (int k = 0; k < 8; ++k) {
    const double angle = k * std::acos(-1.0) / 4;
    const double up = (k % 2 == 0 ? 1 : -1) * std::sqrt(1 - cos_squared);
    const double out = std::sqrt(cos_squared);
    saddle.points.push_back(radii[at(k)] * glm::dvec3(out * std::cos(angle), out * std::sin(angle), up));
    saddle.faces.push_back({0, k + 1, (k + 1) % 8 + 1});
  }
  return unfold_by_hand(saddle, {{0, -1}, {1, 0}, {2, 1}, {3, 2}, {4, 3}, {5, 4}, {6, 5}, {7, 6}});
}

/// A face with a notch, and a square that fills the notch; joined at its bottom. All in one plane.
FlatNet notch_net() {
  const Solid solid{{{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {2, 2, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}},
                    {{0, 1, 2, 3, 4, 5, 6, 7}, {5, 4, 3, 6}}};
  return unfold_by_hand(solid, {{0, -1}, {1, 0}});
}

bool has_fault(const VerifyReport& report, const std::string& words) {
  return std::any_of(report.faults.begin(), report.faults.end(),
                     [&](const std::string& fault) { return fault.find(words) != std::string::npos; });
}

std::string all_faults(const VerifyReport& report) {
  std::string text;
  for (const std::string& fault : report.faults) text += fault + "\n";
  return text;
}

void expect_net(const FlatNet& net, int expected_pieces = 1) {
  const VerifyReport report = verify(net, expected_pieces);
  EXPECT_TRUE(report.is_net) << all_faults(report);
  EXPECT_EQ(report.overlaps, 0);
  EXPECT_EQ(report.deepest_overlap, 0);
}

void expect_fault(const FlatNet& net, const std::string& words, int expected_pieces = 1) {
  const VerifyReport report = verify(net, expected_pieces);
  EXPECT_FALSE(report.is_net);
  EXPECT_TRUE(has_fault(report, words)) << "wanted: " << words << "\ngot: " << all_faults(report);
}

/// A sphere of flat latitude bands: triangles at the poles, trapezoids between them.
Solid globe(int n_bands, int n_meridians) {
  Solid solid;
  const double pi = std::acos(-1.0);
  for (int i = 1; i < n_bands; ++i) {
    for (int k = 0; k < n_meridians; ++k) {
      const double down = pi * i / n_bands;
      const double round = 2 * pi * k / n_meridians;
      solid.points.emplace_back(std::sin(down) * std::cos(round), std::sin(down) * std::sin(round),
                                std::cos(down));
    }
  }
  const int north = static_cast<int>(solid.points.size());
  solid.points.emplace_back(0, 0, 1);
  solid.points.emplace_back(0, 0, -1);
  const int last = (n_bands - 2) * n_meridians;
  for (int k = 0; k < n_meridians; ++k) {
    const int next = (k + 1) % n_meridians;
    solid.faces.push_back({north, k, next});
    solid.faces.push_back({north + 1, last + next, last + k});
    for (int i = 0; i + 2 < n_bands; ++i) {
      const int row = i * n_meridians;
      solid.faces.push_back({row + k, row + n_meridians + k, row + n_meridians + next, row + next});
    }
  }
  return solid;
}

/// A spanning tree grown from face 0 by taking random sides.
std::vector<std::pair<int, int>> random_tree(const Solid& solid, Random& random) {
  std::map<std::pair<int, int>, int> face_of_side;
  for (std::size_t f = 0; f < solid.faces.size(); ++f) {
    const std::vector<int>& corners = solid.faces[f];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      face_of_side[{corners[i], corners[(i + 1) % corners.size()]}] = static_cast<int>(f);
    }
  }
  std::vector<char> is_in(solid.faces.size(), 0);
  std::vector<std::pair<int, int>> tree;
  std::vector<std::pair<int, int>> front{{0, -1}};
  while (!front.empty()) {
    std::swap(front[at(random.below(static_cast<int>(front.size())))], front.back());
    const auto [face, parent] = front.back();
    front.pop_back();
    if (is_in[at(face)] != 0) continue;
    is_in[at(face)] = 1;
    tree.emplace_back(face, parent);
    const std::vector<int>& corners = solid.faces[at(face)];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      front.emplace_back(face_of_side.at({corners[(i + 1) % corners.size()], corners[i]}), face);
    }
  }
  return tree;
}

/// Area over diameter of the intersection of two convex polygons, by clipping: another definition of depth,
/// never larger than the true one.
double clipped_depth(const FlatNet& net, const std::vector<int>& face, const std::vector<int>& other) {
  std::vector<glm::dvec2> left;
  for (const int c : face) left.push_back(net.points[at(c)]);
  for (std::size_t i = 0; i < other.size(); ++i) {
    const glm::dvec2 a = net.points[at(other[i])];
    const glm::dvec2 e = net.points[at(other[(i + 1) % other.size()])] - a;
    std::vector<glm::dvec2> kept;
    for (std::size_t k = 0; k < left.size(); ++k) {
      const glm::dvec2 p = left[k];
      const glm::dvec2 q = left[(k + 1) % left.size()];
      const double p_in = cross(e, p - a);
      const double q_in = cross(e, q - a);
      if (p_in >= 0) kept.push_back(p);
      if ((p_in >= 0) != (q_in >= 0)) kept.push_back(p + (q - p) * (p_in / (p_in - q_in)));
    }
    left = std::move(kept);
  }
  double area = 0;
  double diameter = 0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    area += 0.5 * cross(left[i] - left[0], left[(i + 1) % left.size()] - left[0]);
    for (const glm::dvec2 p : left) diameter = std::max(diameter, glm::distance(p, left[i]));
  }
  return diameter > 0 ? area / diameter : 0;
}

FlatNet scaled(FlatNet net, double flat, double space) {
  for (glm::dvec2& p : net.points) p *= flat;
  for (glm::dvec3& p : net.folded) p *= space;
  return net;
}

TEST(Verify, AcceptsTheLatinCrossOfACube) {
  const VerifyReport report = verify(cross_net());
  EXPECT_TRUE(report.is_net) << all_faults(report);
  EXPECT_EQ(report.pieces, 1);
  EXPECT_EQ(report.overlaps, 0);
  EXPECT_LT(report.worst_distortion, 1e-12);
  EXPECT_TRUE(report.faults.empty());
}

TEST(Verify, AcceptsACubeWrittenDownDigitByDigit) {
  FlatNet net;
  net.points = {{1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 0}, {2, 0}, {3, 1},
                {3, 2}, {2, 3}, {1, 3}, {0, 2}, {0, 1}, {4, 1}, {4, 2}};
  net.folded = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0},
                {1, 1, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 0}, {0, 1, 0}};
  net.faces = {{0, 1, 2, 3}, {4, 5, 1, 0}, {1, 6, 7, 2}, {3, 2, 8, 9}, {11, 0, 3, 10}, {6, 12, 13, 7}};
  const double quarter = std::acos(-1.0) / 2;
  for (const auto& [a, b] : std::vector<std::pair<int, int>>{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {6, 7}}) {
    net.edges.push_back({a, b, Assignment::Mountain, -quarter});
  }
  for (const auto& [a, b] : std::vector<std::pair<int, int>>{{4, 5},
                                                             {5, 1},
                                                             {0, 4},
                                                             {1, 6},
                                                             {7, 2},
                                                             {2, 8},
                                                             {8, 9},
                                                             {9, 3},
                                                             {11, 0},
                                                             {3, 10},
                                                             {10, 11},
                                                             {6, 12},
                                                             {12, 13},
                                                             {13, 7}}) {
    net.edges.push_back({a, b, Assignment::Boundary, 0});
  }
  expect_net(net);
}

TEST(Verify, AcceptsNetsOfAnySizeAnywhere) {
  for (const double flat : {1e-300, 1e-30, 1e-3, 1e3, 1e30, 1e300}) {
    for (const double space : {1e-300, 1e-30, 1.0, 1e30, 1e300}) expect_net(scaled(cross_net(), flat, space));
  }
  FlatNet far = cross_net();
  for (glm::dvec2& p : far.points) p += glm::dvec2(1048576, -524288);
  expect_net(far);
}

TEST(Verify, FindsOverlapsAtAnySize) {
  for (const double size : {1e-300, 1e-30, 1e30, 1e300}) {
    const VerifyReport report = verify(scaled(saddle_net(std::vector<double>(8, 1.0)), size, 1 / size));
    EXPECT_FALSE(report.is_net);
    EXPECT_EQ(report.overlaps, 2);
    EXPECT_NEAR(report.deepest_overlap, std::sqrt(0.75), 1e-9);
  }
}

TEST(Verify, AcceptsANetInWhichTheWholeModelRunsInwards) {
  Solid inward = box(1, 2, 3);
  for (std::vector<int>& face : inward.faces) std::reverse(face.begin(), face.end());
  FlatNet net = cross_net(inward);
  // Seen from outside: mirrored as a whole, so that convex edges are mountains on the printed side again.
  for (glm::dvec2& p : net.points) p.x = -p.x;
  for (FlatNet::Edge& edge : net.edges) {
    if (edge.assignment == Assignment::Boundary) continue;
    EXPECT_EQ(edge.assignment, Assignment::Valley);
    edge.assignment = Assignment::Mountain;
    edge.fold_angle_rad = -edge.fold_angle_rad;
  }
  expect_net(net);
}

TEST(Verify, RejectsAFaceListedTheOtherWayRound) {
  FlatNet net = cross_net(box(1, 2, 3));
  std::reverse(net.faces[4].begin(), net.faces[4].end());
  expect_fault(net, "Face 5 lists its corners the other way round");
}

TEST(Verify, RejectsEmptyNetsAndBrokenLists) {
  expect_fault(FlatNet(), "no faces");
  FlatNet net = cross_net();
  net.faces[2][1] = 99;
  expect_fault(net, "Face 3 names a point that the net does not have");
  net = cross_net();
  net.faces[2][1] = -1;
  expect_fault(net, "Face 3 names a point");
  net = cross_net();
  net.faces[0].resize(2);
  expect_fault(net, "Face 1 has fewer than three corners");
  net = cross_net();
  net.faces[5][0] = net.faces[5][2];
  expect_fault(net, "Face 6 uses the same point");
  net = cross_net();
  net.folded.pop_back();
  expect_fault(net, "place on the model");
  net = cross_net();
  net.edges[0].to = 1000;
  expect_fault(net, "does not run between two");
}

TEST(Verify, RejectsNumbersThatAreNotFinite) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    FlatNet net = cross_net();
    net.points[3].y = bad;
    expect_fault(net, "not finite");
    net = cross_net();
    net.folded[3].z = bad;
    expect_fault(net, "not finite");
  }
}

TEST(Verify, RejectsADoubledFace) {
  FlatNet net = cross_net();
  net.face_source[4] = 2;
  expect_fault(net, "Face 3 of the model is in the net more than once");
  net = cross_net();
  net.faces.push_back(net.faces[4]);
  net.face_source.push_back(6);
  const VerifyReport report = verify(net);
  EXPECT_FALSE(report.is_net);
  EXPECT_GE(report.overlaps, 1);
}

TEST(Verify, RejectsShiftedStretchedAndScaledFaces) {
  const std::string words = "not have the shape and size";
  FlatNet net = cross_net();
  net.points[at(net.faces[4][0])] += glm::dvec2(1e-4, 0);
  expect_fault(net, words);
  net = cross_net(box(1, 1, 1));
  for (glm::dvec2& p : net.points) p.x *= 1.00001;
  expect_fault(net, words);
  net = unfold_by_hand(box(), {{2, -1}, {0, 2}, {1, 2}, {3, 2}, {5, 2}, {4, -1}});
  expect_net(net, 2);
  for (const int corner : net.faces[4]) net.points[at(corner)] *= 1.01;
  expect_fault(net, "Face 5 does " + words, 2);
}

TEST(Verify, MeasuresTheDistortion) {
  FlatNet net = patch_net();
  net.points[at(net.faces[3][2])] += glm::dvec2(1e-4, 0);
  EXPECT_NEAR(verify(net).worst_distortion, 1e-4, 1e-5);
}

TEST(Verify, RejectsAMirroredFace) {
  FlatNet net = unfold_by_hand(box(1, 2, 3), {{2, -1}, {0, 2}, {1, 2}, {3, 2}, {5, 2}, {4, -1}});
  expect_net(net, 2);
  for (const int corner : net.faces[4]) net.points[at(corner)].x *= -1;
  expect_fault(net, "Face 5 is mirrored", 2);
}

TEST(Verify, RejectsFacesWithoutArea) {
  FlatNet net = cross_net();
  net.points[at(net.faces[4][0])] = net.points[at(net.faces[4][1])];
  net.points[at(net.faces[4][3])] = net.points[at(net.faces[4][2])];
  expect_fault(net, "no area");
}

TEST(Verify, RejectsAFaceThatIsNotFlatOnTheModel) {
  FlatNet net = cross_net();
  net.folded[at(net.faces[4][0])] += glm::dvec3(0.01, 0.01, 0.01);
  expect_fault(net, "not flat");
}

TEST(Verify, AcceptsANearlyFlatFaceLaidOutByProjection) {
  Solid solid{{{0, 0, 4e-4}, {1, 0, -4e-4}, {1, 1, 4e-4}, {0, 1, -4e-4}}, {{0, 1, 2, 3}}};
  expect_net(unfold_by_hand(solid, {{0, -1}}));
}

TEST(Verify, RejectsTheWrongNumberOfPieces) {
  const FlatNet two = unfold_by_hand(box(), {{2, -1}, {0, 2}, {1, 2}, {3, 2}, {5, 2}, {4, -1}});
  expect_fault(two, "The net has 2 pieces where 1 is expected");
  expect_fault(two, "The net has 2 pieces where 1 is expected", 0);
  expect_fault(cross_net(), "The net has 1 piece where 2 are expected", 2);
}

TEST(Verify, ExpectsOnePieceForEachComponentWhenAskedTo) {
  Solid two = box();
  const Solid other = box(2, 2, 2);
  for (const glm::dvec3 p : other.points) two.points.push_back(p + glm::dvec3(5, 0, 0));
  for (std::vector<int> face : other.faces) {
    for (int& corner : face) corner += 8;
    two.faces.push_back(face);
  }
  const FlatNet net = unfold_by_hand(
      two,
      {{2, -1}, {0, 2}, {1, 2}, {3, 2}, {5, 2}, {4, 3}, {8, -1}, {6, 8}, {7, 8}, {9, 8}, {11, 8}, {10, 9}});
  expect_net(net, 0);
  expect_net(net, 2);
  EXPECT_FALSE(verify(net, 1).is_net);
}

TEST(Verify, RejectsARingOfFolds) {
  FlatNet net = patch_net();
  // Sewing the one cut of the flat patch leaves every coordinate right and closes a ring.
  const auto merge = [&](int from, int to) {
    for (std::vector<int>& face : net.faces) std::replace(face.begin(), face.end(), from, to);
    for (FlatNet::Edge& edge : net.edges) {
      if (edge.from == from) edge.from = to;
      if (edge.to == from) edge.to = to;
    }
  };
  for (int i = 0; i < static_cast<int>(net.points.size()); ++i) {
    for (int j = 0; j < i; ++j) {
      if (net.folded[at(i)] == net.folded[at(j)]) merge(i, j);
    }
  }
  expect_fault(net, "close 1 ring of faces");
}

TEST(Verify, RejectsAJoinThatTheModelDoesNotHave) {
  // Face 4 hangs at face 5 by a side that belongs to faces 4 and 1 on the model.
  FlatNet net = unfold_by_hand(box(), {{2, -1}, {0, 2}, {1, 2}, {3, 2}, {5, 2}, {4, -1}});
  const std::vector<int> loose = net.faces[4];
  const std::vector<int> host = net.faces[5];
  const glm::dvec2 shift = net.points[at(host[0])] - net.points[at(loose[0])];
  for (const int corner : loose) net.points[at(corner)] += shift;
  net.faces[4][0] = host[0];
  net.faces[4][1] = host[3];
  EXPECT_FALSE(verify(net).is_net);
  net.folded[at(host[3])] = net.folded[at(loose[1])];
  EXPECT_FALSE(verify(net).is_net);
}

TEST(Verify, RejectsThreeFacesAtOneEdge) {
  FlatNet net = cross_net();
  net.points.emplace_back(-5, -5);
  net.folded.emplace_back(0, 0, 9);
  net.faces.push_back({net.faces[4][0], net.faces[4][1], static_cast<int>(net.points.size()) - 1});
  net.face_source.push_back(6);
  expect_fault(net, "cuts cannot be paired");
}

TEST(Verify, RejectsWrongMarksAndAngles) {
  FlatNet net = cross_net();
  const auto is_fold = [](const FlatNet::Edge& e) { return e.assignment != Assignment::Boundary; };
  FlatNet::Edge& fold = *std::find_if(net.edges.begin(), net.edges.end(), is_fold);
  fold.assignment = Assignment::Valley;
  expect_fault(net, "is marked wrongly: on the model it is a mountain");
  fold.assignment = Assignment::Flat;
  expect_fault(net, "marked wrongly");
  fold.assignment = Assignment::Boundary;
  expect_fault(net, "marked wrongly");
  fold.assignment = Assignment::Mountain;
  fold.fold_angle_rad = -fold.fold_angle_rad;
  expect_fault(net, "wrong angle");
  net = cross_net();
  std::find_if_not(net.edges.begin(), net.edges.end(), is_fold)->assignment = Assignment::Mountain;
  expect_fault(net, "is marked as a fold");
}

TEST(Verify, RejectsMissingDoubledAndStrayEdges) {
  FlatNet net = cross_net();
  net.edges.pop_back();
  expect_fault(net, "is missing from the net's list of edges");
  net = cross_net();
  net.edges.push_back(net.edges.front());
  expect_fault(net, "listed more than once");
  net = cross_net();
  net.edges.push_back({net.faces[0][0], net.faces[0][2], Assignment::Boundary, 0});
  expect_fault(net, "names 1 that no face has");
}

TEST(Verify, AcceptsTouchingAndRejectsTheThinnestOverlap) {
  const FlatNet exact = patch_net();
  expect_net(exact);
  const int corner = exact.faces[3][1];
  ASSERT_EQ(exact.points[at(corner)], glm::dvec2(2, 1));
  for (const double push : {1e-12, -1e-12, 5e-10, -1e-7}) {
    FlatNet net = exact;
    net.points[at(corner)].y -= push;
    expect_net(net);
  }
  for (const double push : {2e-9, 1e-8, 1e-7}) {
    FlatNet net = exact;
    net.points[at(corner)].y -= push;
    const VerifyReport report = verify(net);
    EXPECT_EQ(report.overlaps, 1) << push;
    EXPECT_NEAR(report.deepest_overlap, push, 0.01 * push);
    EXPECT_LT(report.worst_distortion, 1e-6);
    EXPECT_EQ(report.faults.size(), 1U);
    EXPECT_TRUE(has_fault(report, "1 pair of faces overlaps"));
  }
}

TEST(Verify, FindsAFaceThatLiesInsideAnother) {
  const VerifyReport report = verify(saddle_net({3, 3, 3, 1, 1, 1, 1, 1}));
  EXPECT_FALSE(report.is_net);
  EXPECT_GE(report.overlaps, 1);
  EXPECT_TRUE(has_fault(report, "2 pairs of faces overlap, faces 2 and 8 the deepest")) << all_faults(report);
}

TEST(Verify, LooksForOverlapsWithinPiecesOnly) {
  FlatNet net = unfold_by_hand(box(), {{2, -1}, {0, 2}, {1, 2}, {3, 2}, {5, 2}, {4, -1}});
  const glm::dvec2 shift = net.points[at(net.faces[2][0])] - net.points[at(net.faces[4][0])];
  for (const int corner : net.faces[4]) net.points[at(corner)] += shift;
  expect_net(net, 2);
}

TEST(Verify, LetsConcaveFacesInterlock) {
  const FlatNet net = notch_net();
  expect_net(net);
  FlatNet wider = net;
  for (const int corner : wider.faces[1]) {
    glm::dvec2& p = wider.points[at(corner)];
    if (p.y > 1.5) p.x += 0.1;
  }
  const VerifyReport report = verify(wider);
  EXPECT_EQ(report.overlaps, 1);
  EXPECT_FALSE(report.is_net);
}

TEST(Verify, CopesWithCornersOnStraightSides) {
  // A notched outline whose sides carry extra corners.
  const Solid solid{{{0, 0, 0},
                     {1.5, 0, 0},
                     {3, 0, 0},
                     {3, 2, 0},
                     {2, 2, 0},
                     {2, 1, 0},
                     {1.5, 1, 0},
                     {1, 1, 0},
                     {1, 2, 0},
                     {0, 2, 0},
                     {0, 1, 0}},
                    {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}}};
  expect_net(unfold_by_hand(solid, {{0, -1}}));
}

TEST(Verify, RejectsAFaceThatCrossesItself) {
  const Solid solid{{{0, 0, 0}, {4, 0, 0}, {0, 2, 0}, {3, 3, 0}}, {{0, 1, 2, 3}}};
  expect_fault(unfold_by_hand(solid, {{0, -1}}), "crosses itself");
}

TEST(Verify, AgreesWithClippingOnRandomNetsOfAGlobe) {
  Random random(1);
  int n_nets = 0;
  int n_overlapping = 0;
  for (int round = 0; round < 60; ++round) {
    const Solid solid = globe(3 + random.below(4), 3 + random.below(5));
    const FlatNet net = unfold_by_hand(solid, random_tree(solid, random));
    int expected = 0;
    for (std::size_t f = 0; f < net.faces.size(); ++f) {
      for (std::size_t g = 0; g < f; ++g)
        expected += clipped_depth(net, net.faces[f], net.faces[g]) > 1e-8 ? 1 : 0;
    }
    const VerifyReport report = verify(net);
    EXPECT_EQ(report.overlaps, expected);
    EXPECT_EQ(report.is_net, expected == 0) << all_faults(report);
    (expected == 0 ? n_nets : n_overlapping) += 1;
  }
  EXPECT_GT(n_nets, 5);
  EXPECT_GT(n_overlapping, 5);
}

}  // namespace
}  // namespace netwright
