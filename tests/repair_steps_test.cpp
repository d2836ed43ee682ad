// Sound shapes are damaged in every way; the report must count the damage, and the matching step must undo it
// with area, volume, borders and genus as before.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "core/base/random.h"
#include "core/mesh/repair.h"
#include "core/mesh/repair_topology.h"
#include "core/mesh/shapes.h"
#include "tests/support.h"

namespace netwright {
namespace {

using testing::zoo;
using testing::ZooShape;
using Corners = std::vector<repair::Corner>;
using Topic = MeshReport::Topic;

RepairResult repaired(const PolygonSoup& soup, const Repairs& repairs = {}) {
  Progress progress;
  return repair_all(soup, repairs, progress);
}

/// The soup with other faces (and its points).
PolygonSoup with_faces(const PolygonSoup& soup, const std::vector<Corners>& faces) {
  repair::SoupWriter writer(soup);
  for (const Corners& face : faces) writer.add_face(face, 0, -1);
  PolygonSoup changed = writer.soup();
  changed.is_joined = soup.is_joined;
  return changed;
}

std::vector<Corners> faces_of(const PolygonSoup& soup) {
  std::vector<Corners> faces;
  for (int f = 0; f < soup.n_faces(); ++f) faces.push_back(repair::face_corners(soup, f));
  return faces;
}

glm::dvec3& point(PolygonSoup& soup, int p) { return soup.points[static_cast<std::size_t>(p)]; }

int add_point(PolygonSoup& soup, glm::dvec3 p) {
  soup.points.push_back(p);
  return static_cast<int>(soup.points.size()) - 1;
}

/// A shape damaged in one way.
struct Damaged {
  PolygonSoup soup;
  int count = 0;      ///< culprits the report must find; 0: this shape cannot be damaged so
  PolygonSoup sound;  ///< what the step must lead back to
};

struct Trial {
  Topic topic;
  std::function<Damaged(const ZooShape&, Random&)> damage;
  std::function<Repaired(const PolygonSoup&)> step;
  Repairs options{};
};

struct Measures {
  double area = 0;
  double volume = 0;
  double border = 0;
  int genus = 0;
  std::size_t n_components = 0;
};

Measures measures(const Mesh& mesh) {
  Measures all;
  for (const FaceId f : mesh.faces()) {
    all.area += mesh.area(f);
    all.volume += mesh.area(f) * glm::dot(mesh.normal(f), mesh.centre(f)) / 3;
  }
  for (const EdgeId e : mesh.edges()) all.border += mesh.is_border(e) ? mesh.length(e) : 0;
  all.genus = mesh.genus();
  all.n_components = mesh.n_components();
  return all;
}

void expect_same(const PreparedModel& is, const PolygonSoup& sound) {
  ASSERT_TRUE(is.is_fit()) << is.refusal;
  const PreparedModel was = prepare(sound);
  ASSERT_TRUE(was.is_fit()) << was.refusal;
  const Measures a = measures(*is.mesh);
  const Measures b = measures(*was.mesh);
  EXPECT_NEAR(a.area, b.area, 1e-9 * b.area);
  EXPECT_NEAR(a.border, b.border, 1e-9 * (1 + b.border));
  EXPECT_EQ(a.genus, b.genus);
  EXPECT_EQ(a.n_components, b.n_components);
  if (is.mesh->is_closed()) {
    EXPECT_NEAR(a.volume, b.volume, 1e-9 * std::abs(b.volume) + 1e-12);
  }
}

void expect_carried_along(const Repaired& step, const PolygonSoup& from) {
  const auto n = static_cast<std::size_t>(step.soup.n_faces());
  EXPECT_EQ(step.soup.corner_uv.size(), from.corner_uv.empty() ? 0U : step.soup.corners.size());
  ASSERT_EQ(step.face_source.size(), n);
  ASSERT_EQ(step.is_turned.size(), n);
  for (const int source : step.face_source) EXPECT_LT(source, from.n_faces());
}

/// How many of the zoo's shapes could be damaged so.
int try_on_the_zoo(const Trial& trial) {
  Random random(11);
  int n_damaged = 0;
  for (const ZooShape& shape : zoo()) {
    const Damaged damaged = trial.damage(shape, random);
    if (damaged.count == 0) continue;
    SCOPED_TRACE(shape.soup.name);
    ++n_damaged;
    EXPECT_EQ(report_on(damaged.soup).count(trial.topic), damaged.count);
    const Repaired step = trial.step(damaged.soup);
    EXPECT_EQ(step.count, damaged.count) << step.sentence;
    EXPECT_TRUE(step.sentence.ends_with(".")) << step.sentence;
    EXPECT_EQ(report_on(step.soup).count(trial.topic), 0);
    expect_carried_along(step, damaged.soup);
    expect_same(prepare(step.soup), damaged.sound);
    const RepairResult all = repaired(damaged.soup, trial.options);
    expect_same(all.prepared, damaged.sound);
    EXPECT_EQ(all.done, std::vector<std::string>{step.sentence});
    EXPECT_TRUE(repaired(all.soup, trial.options).done.empty()) << "twice is more than once";
  }
  return n_damaged;
}

TEST(Repair, ChangesNothingInSoundShapes) {
  for (const ZooShape& shape : zoo()) {
    const RepairResult result = repaired(shape.soup);
    EXPECT_TRUE(result.is_fit()) << shape.soup.name;
    EXPECT_TRUE(result.done.empty()) << shape.soup.name << ": " << result.done.front();
    EXPECT_EQ(result.soup.corners, shape.soup.corners) << shape.soup.name;
    EXPECT_EQ(result.soup.points, shape.soup.points) << shape.soup.name;
    EXPECT_NE(result.verdict.find("nothing to repair"), std::string::npos) << result.verdict;
  }
}

TEST(Repair, TurnsFlippedFaces) {
  const auto flip = [](const ZooShape& shape, Random& random) {
    std::set<int> flipped;  // few, so that open shapes know which way is right
    const int n = std::max(1, shape.soup.n_faces() / 12);
    while (static_cast<int>(flipped.size()) < n) flipped.insert(random.below(shape.soup.n_faces()));
    std::vector<Corners> faces = faces_of(shape.soup);
    for (const int f : flipped) std::ranges::reverse(faces[static_cast<std::size_t>(f)]);
    return Damaged{with_faces(shape.soup, faces), n, shape.soup};
  };
  EXPECT_EQ(try_on_the_zoo({Topic::TurnedFaces, flip, orient_faces}), static_cast<int>(zoo().size()));
}

TEST(Repair, DropsDoubledFaces) {
  const auto copy = [](const ZooShape& shape, Random& random) {
    const int n = 1 + shape.soup.n_faces() / 5;
    std::vector<Corners> faces = faces_of(shape.soup);
    for (int i = 0; i < n; ++i) {
      Corners again = faces[static_cast<std::size_t>(i)];
      if (random.below(2) == 1) std::ranges::reverse(again);
      std::ranges::rotate(again, again.begin() + 1);
      faces.push_back(again);
    }
    return Damaged{with_faces(shape.soup, faces), n, shape.soup};
  };
  EXPECT_EQ(try_on_the_zoo({Topic::DoubledFaces, copy, drop_doubled_faces}), static_cast<int>(zoo().size()));
}

/// The shape with points of its own for every face.
PolygonSoup torn(const PolygonSoup& soup) {
  PolygonSoup apart = soup;
  apart.points.clear();
  for (int& corner : apart.corners) corner = add_point(apart, soup.points[static_cast<std::size_t>(corner)]);
  return apart;
}

TEST(Repair, WeldsTornShapes) {
  const auto tear = [](const ZooShape& shape, Random&) {
    PolygonSoup soup = torn(shape.soup);
    const auto n = static_cast<int>(soup.points.size() - shape.soup.points.size());
    return Damaged{soup, n, shape.soup};
  };
  const auto step = [](const PolygonSoup& soup) { return weld_points(soup, 0); };
  EXPECT_EQ(try_on_the_zoo({Topic::DoubledPoints, tear, step}), static_cast<int>(zoo().size()));
}

TEST(Repair, SplitsPointsWherePartsTouch) {
  const auto touch = [](const ZooShape& shape, Random&) {
    Damaged damaged{shape.soup, 1, shape.soup};
    int top = 0;
    for (int p = 1; p < static_cast<int>(shape.soup.points.size()); ++p)
      top = point(damaged.soup, p).y > point(damaged.soup, top).y ? p : top;
    const glm::dvec3 tip = point(damaged.soup, top);
    for (PolygonSoup* soup : {&damaged.soup, &damaged.sound}) {
      const int apex = soup == &damaged.soup ? top : add_point(*soup, tip);
      const int a = add_point(*soup, tip + glm::dvec3(1, 2, 0));
      const int b = add_point(*soup, tip + glm::dvec3(-1, 2, 1));
      const int c = add_point(*soup, tip + glm::dvec3(-1, 2, -1));
      std::vector<Corners> faces = faces_of(*soup);
      for (const auto& t : {std::array{apex, a, b}, {apex, b, c}, {apex, c, a}, {a, c, b}})
        faces.push_back({{t[0]}, {t[1]}, {t[2]}});
      *soup = with_faces(*soup, faces);
    }
    return damaged;
  };
  EXPECT_EQ(try_on_the_zoo({Topic::NonManifoldPoints, touch, split_non_manifold}),
            static_cast<int>(zoo().size()));
}

TEST(Repair, SplitsEdgesWithAThirdFace) {
  const auto add_fin = [](const ZooShape& shape, Random&) {
    Damaged damaged{shape.soup, 0, shape.soup};
    const auto mesh = testing::make_mesh(shape.soup);
    for (const HalfedgeId h : mesh->halfedges()) {
      if (!mesh->twin(h).is_valid()) continue;
      const glm::dvec3 out = mesh->normal(mesh->face(h)) + mesh->normal(mesh->face(mesh->twin(h)));
      const glm::dvec3 far = mesh->position(h) + out * mesh->mean_edge();
      const auto corner = repair::face_corners(shape.soup, mesh->face(h).value);
      const int i = h.value - mesh->first(mesh->face(h)).value;
      const auto n = static_cast<int>(corner.size());
      int a = corner[static_cast<std::size_t>(i)].point;
      int b = corner[static_cast<std::size_t>((i + 1) % n)].point;
      for (PolygonSoup* soup : {&damaged.soup, &damaged.sound}) {
        if (soup == &damaged.sound) {
          a = add_point(*soup, mesh->position(h) + 3.0 * out * mesh->mean_edge());
          b = add_point(*soup, mesh->position(mesh->next(h)) + 3.0 * out * mesh->mean_edge());
        }
        const int c = add_point(*soup, soup == &damaged.soup ? far : far + 3.0 * out * mesh->mean_edge());
        std::vector<Corners> faces = faces_of(*soup);
        faces.push_back({{a}, {b}, {c}});
        *soup = with_faces(*soup, faces);
      }
      damaged.count = 1;
      break;
    }
    return damaged;
  };
  const auto step = [](const PolygonSoup& soup) {
    Repaired result = split_non_manifold(soup);
    EXPECT_EQ(result.count, 2) << "the fin gets two points of its own";
    result.count = 1;
    return result;
  };
  EXPECT_EQ(try_on_the_zoo({Topic::NonManifoldEdges, add_fin, step}), static_cast<int>(zoo().size()));
}

TEST(Repair, ClearsFacesWithoutAreaAndLeavesNoGap) {
  const auto add_sliver = [](const ZooShape& shape, Random& random) {
    // Face f gets a corner in the middle of a side, its neighbour does not: a face without area lies between.
    PolygonSoup soup = shape.soup;
    std::vector<Corners> faces = faces_of(soup);
    Corners& face = faces[static_cast<std::size_t>(random.below(soup.n_faces()))];
    const repair::Corner from = face[0];
    const repair::Corner to = face[1];
    const repair::Corner middle{add_point(soup, (point(soup, from.point) + point(soup, to.point)) * 0.5),
                                (from.uv + to.uv) * 0.5};
    face.insert(face.begin() + 1, middle);
    faces.push_back({from, to, middle});
    return Damaged{with_faces(soup, faces), 1, shape.soup};
  };
  EXPECT_EQ(try_on_the_zoo({Topic::ZeroAreaFaces, add_sliver, drop_degenerate_faces}),
            static_cast<int>(zoo().size()));
}

TEST(Repair, TakesCornersOutThatAreNamedTwice) {
  const auto stutter = [](const ZooShape& shape, Random& random) {
    std::vector<Corners> faces = faces_of(shape.soup);
    const int n = 1 + shape.soup.n_faces() / 4;
    for (int f = 0; f < n; ++f) {
      Corners& face = faces[static_cast<std::size_t>(f)];
      const auto i = static_cast<std::ptrdiff_t>(random.below(static_cast<int>(face.size())));
      const repair::Corner again = face[static_cast<std::size_t>(i)];
      const repair::Corner next = face[static_cast<std::size_t>(i + 1) % face.size()];
      face.insert(face.begin() + i, again);
      if (random.below(2) == 1) face.insert(face.begin() + i + 1, next);  // there and back again
    }
    return Damaged{with_faces(shape.soup, faces), n, shape.soup};
  };
  EXPECT_EQ(try_on_the_zoo({Topic::BrokenFaces, stutter, drop_degenerate_faces}),
            static_cast<int>(zoo().size()));
}

TEST(Repair, ClosesPunchedHolesWithTheSameFace) {
  const auto punch = [](const ZooShape& shape, Random& random) {
    if (!shape.is_closed) return Damaged{};
    std::vector<Corners> faces = faces_of(shape.soup);
    faces.erase(faces.begin() + random.below(shape.soup.n_faces()));
    return Damaged{with_faces(shape.soup, faces), 1, shape.soup};
  };
  const auto step = [](const PolygonSoup& soup) { return close_holes(soup, 1000); };
  const int n = try_on_the_zoo({Topic::Borders, punch, step, {.max_hole_edges = 1000}});
  EXPECT_GT(n, 30);
}

TEST(Repair, LeavesHolesOpenThatAreTooLarge) {
  PolygonSoup tube = shapes::open_cylinder(12, 2);
  EXPECT_EQ(close_holes(tube, 11).count, 0);
  const Repaired closed = close_holes(tube, 12);
  EXPECT_EQ(closed.count, 2);
  EXPECT_EQ(closed.sentence, "Closed 2 holes with 2 new faces (2 → 0 borders).");
  EXPECT_EQ(std::ranges::count(closed.face_source, -1), 2);
  EXPECT_TRUE(prepare(closed.soup).mesh->is_closed());
}

TEST(Repair, DoesNotTakeTheOutlineOfAFlatPartForAHole) {
  EXPECT_EQ(close_holes(shapes::grid_patch(3, 2), 1000).count, 0);
  EXPECT_EQ(close_holes(shapes::grid_patch(1, 1), 1000).count, 0);
}

TEST(Repair, ClosesBentHolesSmoothly) {
  const PolygonSoup ball = shapes::icosphere(6);
  std::vector<Corners> faces = faces_of(ball);
  int gone = ball.face(0)[0];
  for (int f = 0; f < ball.n_faces(); ++f) {  // a point of six faces, away from the icosahedron's corners
    for (const int p : ball.face(f)) {
      if (std::ranges::count(ball.corners, p) == 6) gone = p;
    }
  }
  std::erase_if(faces, [&](const Corners& face) {
    return std::ranges::any_of(face, [&](const repair::Corner& c) { return c.point == gone; });
  });
  const RepairResult result = repaired(with_faces(ball, faces), {.max_hole_edges = 6});
  ASSERT_TRUE(result.is_fit()) << result.verdict;
  EXPECT_TRUE(result.prepared.mesh->is_closed());
  EXPECT_EQ(result.prepared.mesh->genus(), 0);
  for (const HalfedgeId h : result.prepared.mesh->halfedges()) {
    const Mesh& mesh = *result.prepared.mesh;
    EXPECT_GT(glm::dot(mesh.normal(mesh.face(h)), mesh.normal(mesh.neighbour(h))), 0.8);
  }
}

TEST(Repair, WeldsCracksWithinTheTolerance) {
  PolygonSoup soup = torn(shapes::grid_cube(3));
  Random random(3);
  for (glm::dvec3& p : soup.points) p += 1e-3 * glm::dvec3(random.unit(), random.unit(), random.unit());
  EXPECT_GT(report_on(soup).n_components, 1);
  EXPECT_EQ(weld_points(soup, 1e-5).count, 0);
  const Repaired welded = weld_points(soup, 0.01);
  EXPECT_EQ(welded.count, 216 - 56);
  const MeshReport report = report_on(welded.soup);
  EXPECT_TRUE(report.is_closed);
  EXPECT_EQ(report.n_components, 1);
  EXPECT_EQ(welded.soup.points.size(), 56U);
}

TEST(Repair, KeepsBoxesApartThatShareAnEdge) {
  PolygonSoup soup = shapes::combined(shapes::cube(), shapes::cube(), {1, 1, 0});
  soup = torn(soup);
  soup.is_indexed = false;
  EXPECT_EQ(report_on(soup).count(Topic::NonManifoldEdges), 1);
  const RepairResult result = repaired(soup);
  ASSERT_TRUE(result.is_fit()) << result.verdict;
  EXPECT_TRUE(result.prepared.mesh->is_closed());
  EXPECT_EQ(result.prepared.mesh->n_components(), 2U);
}

TEST(Repair, TakesAWallOutOfABoxAndClosesTheBox) {
  PolygonSoup box = shapes::grid_cube(2);
  std::vector<Corners> faces = faces_of(box);
  std::vector<int> ring;  // the points of the middle plane, in order around the axis
  for (int p = 0; p < static_cast<int>(box.points.size()); ++p) {
    const Box3 all = repair::used_box(box);
    if (std::abs(point(box, p).x - all.centre().x) < 1e-9) ring.push_back(p);
  }
  const glm::dvec3 middle = repair::used_box(box).centre();
  std::ranges::sort(
      ring, {}, [&](int p) { return std::atan2(point(box, p).y - middle.y, point(box, p).z - middle.z); });
  Corners wall;
  for (const int p : ring) wall.push_back({p});
  faces.push_back(wall);
  const PolygonSoup soup = with_faces(box, faces);
  EXPECT_EQ(report_on(soup).count(Topic::NonManifoldEdges), 8);
  const RepairResult result = repaired(soup, {});
  ASSERT_TRUE(result.is_fit()) << result.verdict;
  EXPECT_EQ(result.prepared.mesh->n_components(), 2U);
  EXPECT_EQ(result.prepared.report.n_border_edges, 8);
}

TEST(Repair, DropsSmallAndInnerPartsOnlyWhenAsked) {
  const PolygonSoup inner = shapes::combined(shapes::cube(4), shapes::icosphere(2), {0.5, 2, 0.3});
  const PolygonSoup soup = shapes::combined(inner, shapes::cube(0.1), {9, 0, 0});
  const auto n_parts = [](const PolygonSoup& s) { return report_on(s).n_components; };
  ASSERT_EQ(n_parts(soup), 3);
  EXPECT_TRUE(repaired(soup).done.empty());
  const Repaired without_small = drop_small_parts(soup, 0.05);
  EXPECT_EQ(without_small.count, 1);
  EXPECT_EQ(without_small.soup.n_faces(), 6 + 80);
  const Repaired without_inner = drop_inner_parts(soup);
  EXPECT_EQ(without_inner.count, 1) << without_inner.sentence;
  EXPECT_EQ(without_inner.soup.n_faces(), 12);
  EXPECT_EQ(n_parts(drop_inner_parts(without_small.soup).soup), 1);
  EXPECT_EQ(drop_small_parts(soup, 10).soup.n_faces(), 6) << "the largest part stays";
}

TEST(Repair, DropsPointsThatNoFaceUses) {
  PolygonSoup soup = shapes::cube();
  soup.points.insert(soup.points.begin() + 3, 2, glm::dvec3(50));
  for (int& corner : soup.corners) corner += corner >= 3 ? 2 : 0;
  EXPECT_EQ(report_on(soup).count(Topic::IsolatedPoints), 2);
  EXPECT_EQ(report_on(soup).find(Topic::IsolatedPoints)->points, (std::vector<int>{3, 4}));
  const RepairResult result = repaired(soup);
  EXPECT_EQ(result.done, (std::vector<std::string>{"Dropped 2 points that no face uses (10 → 8 points)."}));
  EXPECT_EQ(result.soup.points, shapes::cube().points);
  EXPECT_EQ(result.soup.corners, shapes::cube().corners);
}

TEST(Repair, SplitsFacesThatAreNotFlatUnlessTheyWillBePlanarized) {
  PolygonSoup soup = shapes::cube();
  point(soup, 0) += glm::dvec3(0.1, 0.1, 0.1);
  Progress progress;
  EXPECT_FALSE(repair_all(soup, {}, progress, false).is_fit());
  const RepairResult result = repaired(soup);
  ASSERT_TRUE(result.is_fit()) << result.verdict;
  EXPECT_EQ(result.soup.n_faces(), 9);
  ASSERT_EQ(result.done.size(), 1U);
  EXPECT_EQ(result.done[0], "Split 3 faces that are not flat into triangles (6 → 9 faces).");
  for (const FaceId f : result.prepared.mesh->faces()) {
    EXPECT_EQ(result.prepared.mesh->face_source(f), result.face_source[f.index()]);
    EXPECT_LT(result.face_source[f.index()], 6);
  }
}

TEST(Repair, SaysThatOneSidedSurfacesCannotBeRepaired) {
  PolygonSoup moebius;
  moebius.name = "ring.obj";
  constexpr int n = 12;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.141592653589793 * i / n;
    const glm::dvec3 out(std::cos(angle), 0, std::sin(angle));
    const glm::dvec3 across = out * std::cos(angle / 2) + glm::dvec3(0, std::sin(angle / 2), 0);
    moebius.points.push_back(2.0 * out + 0.3 * across);
    moebius.points.push_back(2.0 * out - 0.3 * across);
  }
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i;
    const int b = i + 1 < n ? a + 2 : 1;
    const int c = i + 1 < n ? a + 3 : 0;
    moebius.add_face(std::array{a, b, a + 1});
    moebius.add_face(std::array{a + 1, b, c});
  }
  EXPECT_EQ(report_on(moebius).count(Topic::OneSided), 1);
  const RepairResult result = repaired(moebius);
  EXPECT_FALSE(result.is_fit());
  EXPECT_TRUE(result.verdict.starts_with("ring.obj cannot be repaired: the surface has only one side"))
      << result.verdict;
  EXPECT_THROW((void)orient_faces(moebius), std::exception);
}

TEST(Repair, TellsWhereFacesCameFromAndWhichWereTurned) {
  PolygonSoup soup = shapes::cube();
  std::vector<Corners> faces = faces_of(soup);
  std::ranges::reverse(faces[4]);
  faces.insert(faces.begin() + 2, faces[0]);  // faces 3, 4, 5 move on by one
  const RepairResult result = repaired(with_faces(soup, faces));
  ASSERT_TRUE(result.is_fit());
  EXPECT_EQ(result.face_source, (std::vector<int>{0, 1, 3, 4, 5, 6}));
  EXPECT_EQ(result.is_turned, (std::vector<bool>{false, false, false, false, true, false}));
  const Mesh& mesh = *result.prepared.mesh;
  for (const FaceId f : mesh.faces()) {
    EXPECT_EQ(mesh.face_source(f), result.face_source[f.index()]);
    EXPECT_EQ(mesh.is_flipped(f), result.is_turned[f.index()]);
  }
}

TEST(Repair, UndoesEverythingAtOnceInFilesWithoutSharedPoints) {
  Random random(5);
  for (const ZooShape& shape : zoo()) {
    if (!shape.is_closed) continue;
    std::vector<Corners> faces = faces_of(shape.soup);
    faces.push_back(faces[1]);
    faces.push_back({faces[2][0], faces[2][1], faces[2][0]});
    for (Corners& face : faces) {
      if (random.below(3) == 0) std::ranges::reverse(face);
    }
    faces.erase(faces.begin());
    PolygonSoup soup = torn(with_faces(shape.soup, faces));
    soup.is_indexed = false;
    const RepairResult result = repaired(soup, {.max_hole_edges = 1000});
    SCOPED_TRACE(shape.soup.name);
    expect_same(result.prepared, shape.soup);
    EXPECT_EQ(result.soup.points.size(), shape.soup.points.size());
    EXPECT_EQ(result.done.size(), 4U);
  }
}

/// A ball with a doubled face, a turned one and a hole, each facet with points of its own.
PolygonSoup careless_ball() {
  const PolygonSoup ball = shapes::icosphere(2);
  std::vector<Corners> faces = faces_of(ball);
  faces.push_back(faces[5]);
  std::ranges::reverse(faces[9]);
  faces.erase(faces.begin() + 40);
  PolygonSoup soup = torn(with_faces(ball, faces));
  soup.is_indexed = false;
  return soup;
}

TEST(RepairSurvey, CountsWhatEachStepHasToDoWhetherItIsWantedOrNot) {
  Progress progress;
  const RepairSurvey none = survey_repairs(careless_ball(), kNoRepairs, progress);
  ASSERT_NE(none.find(RepairStep::DoubledFaces), nullptr);
  EXPECT_EQ(none.find(RepairStep::DoubledFaces)->found, 1);
  EXPECT_EQ(none.find(RepairStep::DoubledFaces)->left, 1);
  EXPECT_EQ(none.find(RepairStep::UnevenFaces), nullptr) << "triangles are flat";
  EXPECT_EQ(none.find(RepairStep::IsolatedPoints), nullptr);
  Repairs some = kNoRepairs;
  some.drops_doubled_faces = true;
  some.max_hole_edges = 3;
  const RepairSurvey done = survey_repairs(careless_ball(), some, progress);
  EXPECT_EQ(done.find(RepairStep::DoubledFaces)->left, 0);
  ASSERT_NE(done.find(RepairStep::Turn), nullptr);
  EXPECT_EQ(done.find(RepairStep::Turn)->found, 1);
  EXPECT_EQ(done.find(RepairStep::Turn)->left, 0);
  ASSERT_NE(done.find(RepairStep::Holes), nullptr);
  EXPECT_EQ(done.find(RepairStep::Holes)->found, 1);
  EXPECT_EQ(done.find(RepairStep::Holes)->left, 0);
  EXPECT_EQ(done.hole_sizes, std::vector<int>{3});
  EXPECT_TRUE(none.can_weld) << "the hole's edges could be joined to others";
}

TEST(RepairSurvey, AgreesWithWhatRepairDoes) {
  Random random(23);
  for (const ZooShape& shape : zoo()) {
    std::vector<Corners> faces = faces_of(shape.soup);
    faces.push_back(faces[static_cast<std::size_t>(random.below(shape.soup.n_faces()))]);
    const PolygonSoup soup = with_faces(shape.soup, faces);
    Progress progress;
    const RepairSurvey survey = survey_repairs(soup, {}, progress);
    std::vector<std::string> told;
    for (const RepairCount& count : survey.counts) {
      if (count.left < count.found) told.push_back(count.sentence);
    }
    EXPECT_EQ(told, repaired(soup).done) << shape.soup.name;
  }
}

TEST(RepairSurvey, FindsNothingInSoundClosedShapes) {
  for (const ZooShape& shape : zoo()) {
    if (!shape.is_closed) continue;
    Progress progress;
    const RepairSurvey survey = survey_repairs(shape.soup, kNoRepairs, progress);
    EXPECT_TRUE(survey.counts.empty()) << shape.soup.name;
    EXPECT_FALSE(survey.can_weld) << shape.soup.name;
  }
}

TEST(Repair, WeldsAsFarAsTheToleranceReaches) {
  PolygonSoup soup = torn(shapes::icosphere(2));
  Random random(3);
  for (glm::dvec3& p : soup.points) {
    for (int axis = 0; axis < 3; ++axis) p[axis] += 1e-4 * (random.below(1001) / 1000.0 - 0.5);
  }
  Repairs weld = kNoRepairs;
  weld.welds = true;
  EXPECT_GT(repaired(soup, weld).prepared.report.n_border_edges, 0);
  weld.weld_tolerance = 2e-4;
  const RepairResult welded = repaired(soup, weld);
  ASSERT_TRUE(welded.is_fit()) << welded.verdict;
  EXPECT_TRUE(welded.prepared.mesh->is_closed());
  EXPECT_EQ(welded.prepared.mesh->n_vertices(), 42U);
}

TEST(Repair, DoesNoStepThatIsNotWanted) {
  const PolygonSoup soup = careless_ball();
  Repairs holes = kNoRepairs;
  holes.max_hole_edges = 3;
  const RepairResult half = repaired(soup, holes);
  EXPECT_FALSE(half.is_fit());
  EXPECT_NE(half.verdict.find("same corners"), std::string::npos) << half.verdict;
  holes.drops_doubled_faces = true;
  const RepairResult whole = repaired(soup, holes);
  ASSERT_TRUE(whole.is_fit()) << whole.verdict;
  EXPECT_TRUE(whole.prepared.mesh->is_closed());
}

PolygonSoup random_soup(Random& random) {
  PolygonSoup soup;
  const int n_points = 4 + random.below(9);
  for (int p = 0; p < n_points; ++p)
    soup.points.emplace_back(random.below(3), random.below(3), random.below(3));
  const int n_faces = 1 + random.below(14);
  for (int f = 0; f < n_faces; ++f) {
    std::vector<int> corners;
    const int n = random.below(8) == 0 ? 2 + random.below(5) : 3;
    for (int i = 0; i < n; ++i) corners.push_back(random.below(n_points));
    soup.add_face(corners);
  }
  return soup;
}

TEST(Repair, MakesAManifoldOfAnySoupOrSaysWhyNot) {
  Random random(17);
  int n_fit = 0;
  for (int i = 0; i < 2000; ++i) {
    const PolygonSoup soup = random_soup(random);
    const RepairResult result = repaired(soup, {.max_hole_edges = random.below(2) * 8});
    SCOPED_TRACE(i);
    n_fit += result.is_fit() ? 1 : 0;
    EXPECT_FALSE(result.verdict.empty());
    const MeshReport report = report_on(result.soup);
    EXPECT_EQ(report.is_manifold, result.prepared.mesh != nullptr) << result.verdict;
    EXPECT_EQ(report.count(Topic::NonManifoldEdges), 0);
    EXPECT_EQ(report.count(Topic::NonManifoldPoints), 0);
    EXPECT_EQ(report.count(Topic::BrokenFaces), 0);
    EXPECT_EQ(report.count(Topic::ZeroAreaFaces), 0);
    EXPECT_EQ(report.count(Topic::DoubledFaces), 0);
    EXPECT_EQ(report.count(Topic::IsolatedPoints), 0);
    if (result.soup.n_faces() > 0 && report.count(Topic::OneSided) == 0) {
      EXPECT_TRUE(result.is_fit()) << result.verdict;
    }
    EXPECT_TRUE(repaired(result.soup).done.empty()) << repaired(result.soup).done.front();
  }
  EXPECT_GT(n_fit, 1000);
}

TEST(Repair, StopsBetweenStepsWhenCancelled) {
  Progress progress;
  progress.cancel();
  PolygonSoup soup = shapes::cube();
  soup.add_face(std::array{0, 1, 1});
  const RepairResult result = repair_all(soup, {}, progress);
  EXPECT_TRUE(result.done.empty());
  EXPECT_FALSE(result.is_fit());
}

}  // namespace
}  // namespace netwright
