// Pieces put on the page by hand: laid out, kept through edits, saved, printed where they are seen, and never
// printed badly.
#include "core/sheet/placing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "core/project/commands.h"
#include "core/project/derived.h"
#include "core/project/project_file.h"
#include "core/project/replace_model.h"
#include "core/sheet/outline.h"
#include "core/sheet/placing_edits.h"
#include "tests/project_same.h"
#include "tests/project_support.h"
#include "tests/session_support.h"

namespace netwright {
namespace {

using namespace testing;

constexpr double kTurn_rad = 0.3;

PolygonSoup two_solids() { return shapes::combined(shapes::cube(), shapes::tetrahedron(), {5, 0, 0}); }

/// Solved, and printed without glue tabs.
Project bare(const PolygonSoup& soup) { return set_tabs(solved(project_of(soup)), no_tabs()); }

Project solved_pair() { return bare(two_solids()); }

std::shared_ptr<const Derived> derived_of(const Project& project) {
  Progress progress;
  return derive(project, nullptr, 1, progress);
}

HandLayout as_it_lies(const Derived& derived) { return as_placed(derived.shown->net, *derived.pages); }

Box2 box_of(const Net& net, const PageLayout& layout, int piece) {
  Box2 box;
  for (const HalfedgeId h : net.mesh().halfedges())
    if (net.piece[net.mesh().face(h)] == piece) box.add(layout.on_canvas(piece, net.corner(h)));
  return box;
}

Rigid2 shift(double x, double y) { return {1, 0, x, y}; }

/// The place of the piece that holds the face.
HandLayout::Place& place_of(HandLayout& placed, const Net& net, FaceId face) {
  for (HandLayout::Place& place : placed.places)
    if (net.piece[place.face] == net.piece[face]) return place;
  throw std::logic_error("a piece without a place");
}

void expect_near(const Box2& a, const Box2& b) {
  EXPECT_NEAR(glm::distance(a.min, b.min), 0, 1e-9);
  EXPECT_NEAR(glm::distance(a.max, b.max), 0, 1e-9);
}

TEST(Derived, LaysPagesOutAgainOnlyWhereTheyChange) {
  const Project project = solved_pair();
  const auto first = derived_of(project);
  ASSERT_NE(first->sheets, nullptr);
  Progress progress;
  SheetSettings titled = project.sheet;
  titled.words.title = "Moon";
  const auto second = derive(set_sheet(project, titled), first, 2, progress);
  EXPECT_EQ(second->pages, first->pages);
  EXPECT_EQ(second->judged, first->judged);
  ASSERT_NE(second->sheets, nullptr);
  EXPECT_NE(second->sheets, first->sheets);
  const auto third = derive(set_tabs(project, TabSettings()), first, 3, progress);
  EXPECT_NE(third->pages, first->pages);
  EXPECT_FALSE(third->pages->tabs.tabs.empty());
}

TEST(Placing, TabsThatCoverAnotherPieceOrTheEdgeAreTold) {
  const Project project = solved(project_of(two_solids()));
  const auto derived = derived_of(project);
  const Net& net = derived->shown->net;
  const PageLayout& pages = *derived->pages;
  ASSERT_FALSE(pages.tabs.tabs.empty());
  EXPECT_TRUE(derived->misplaced.is_nothing()) << misplaced_sentence(derived->misplaced);
  HandLayout placed = as_it_lies(*derived);
  const auto misplaced_with = [&](const TabSettings& tabs) {
    return find_misplaced(net, *lay_out(net, {}, placed, tabs));
  };
  EXPECT_TRUE(misplaced_with(project.tabs).is_nothing());
  // Where tabs reach out furthest, they go over the edge while faces only come up to it.
  const int piece = net.piece[placed.places[0].face];
  const Box2 faces = box_of(net, pages, piece);
  const Box2 with_tabs = box_on_canvas(net, pages, piece);
  const glm::dvec2 room = pages.frame.net.size();
  const std::array<std::pair<double, glm::dvec2>, 4> edges = {
      {{faces.min.x - with_tabs.min.x, {-faces.min.x, 0}},
       {faces.min.y - with_tabs.min.y, {0, -faces.min.y}},
       {with_tabs.max.x - faces.max.x, {room.x - faces.max.x, 0}},
       {with_tabs.max.y - faces.max.y, {0, room.y - faces.max.y}}}};
  const auto [reach, to_edge] = *std::max_element(
      edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  ASSERT_GT(reach, 0.5);
  const HandLayout before = placed;
  placed.places[0].turn = shift(to_edge.x, -to_edge.y) * placed.places[0].turn;
  EXPECT_TRUE(misplaced_with(no_tabs()).over_edge.empty());
  EXPECT_EQ(misplaced_with(project.tabs).over_edge, std::vector<int>{piece});
  // Coming from any side, tabs cover the other piece no later than faces do, and somewhere earlier.
  const glm::dvec2 way = box_on_canvas(net, pages, 1 - piece).centre() - with_tabs.centre();
  int n_earlier = 0;
  for (int k = 0; k < 8; ++k) {
    const glm::dvec2 step = Rigid2::rotation(k * 0.785).rotate({1, 0});
    const auto steps_until_covered = [&](const TabSettings& tabs) {
      placed = before;
      const glm::dvec2 start = way - 300.0 * step;
      placed.places[0].turn = shift(start.x, -start.y) * placed.places[0].turn;
      int steps = 0;
      for (; misplaced_with(tabs).overlapping.empty() && steps < 400; ++steps)
        placed.places[0].turn = shift(step.x, -step.y) * placed.places[0].turn;
      return steps;
    };
    const int with = steps_until_covered(project.tabs);
    const int without = steps_until_covered(no_tabs());
    EXPECT_LE(with, without);
    n_earlier += with < without ? 1 : 0;
  }
  EXPECT_GT(n_earlier, 0);
}

TEST(Placing, WhatIsPlacedAsItLiesLiesAsBefore) {
  const auto derived = derived_of(solved_pair());
  const Net& net = derived->shown->net;
  const auto layout = lay_out(net, {}, as_it_lies(*derived));
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->pages.size(), derived->pages->pages.size());
  EXPECT_EQ(layout->scale, derived->pages->scale);
  for (int piece = 0; piece < net.n_pieces; ++piece)
    expect_near(box_of(net, *layout, piece), box_of(net, *derived->pages, piece));
  EXPECT_TRUE(find_misplaced(net, *layout).is_nothing());
}

TEST(Placing, TilesStayThoseThatTheNetMeets) {
  Project project = bare(shapes::icosphere(3));
  project.size = {PrintSize::Kind::Height, 300};
  const auto derived = derived_of(project);
  ASSERT_GT(derived->pages->pages.size(), 1U);
  const auto layout = lay_out(derived->shown->net, {}, as_it_lies(*derived));
  ASSERT_TRUE(layout);
  ASSERT_EQ(layout->pages.size(), derived->pages->pages.size());
  for (std::size_t i = 0; i < layout->pages.size(); ++i)
    EXPECT_EQ(layout->pages[i].tag, derived->pages->pages[i].tag);
}

TEST(Placing, PiecesThatCoverEachOtherOrTheEdgeAreTold) {
  const auto derived = derived_of(solved_pair());
  const Net& net = derived->shown->net;
  HandLayout placed = as_it_lies(*derived);
  ASSERT_EQ(placed.places.size(), 2U);
  const Box2 first = box_of(net, *derived->pages, net.piece[placed.places[0].face]);
  const Box2 second = box_of(net, *derived->pages, net.piece[placed.places[1].face]);
  const glm::dvec2 onto = first.centre() - second.centre();
  HandLayout on_top = placed;
  on_top.places[1].turn = shift(onto.x, -onto.y) * on_top.places[1].turn;
  const Misplaced covering = find_misplaced(net, *lay_out(net, {}, on_top));
  ASSERT_EQ(covering.overlapping.size(), 1U);
  EXPECT_EQ(covering.overlapping.front(), std::pair(0, 1));
  EXPECT_GE(covering.faces.size(), 2U);
  EXPECT_NE(misplaced_sentence(covering).find("Two pieces overlap"), std::string::npos);

  HandLayout outside = placed;
  const double far = derived->pages->frame.net.size().x;
  outside.places[0].turn = shift(-far, 0) * outside.places[0].turn;
  const Misplaced over = find_misplaced(net, *lay_out(net, {}, outside));
  EXPECT_TRUE(over.overlapping.empty());
  EXPECT_EQ(over.over_edge, std::vector{net.piece[placed.places[0].face]});
  EXPECT_NE(misplaced_sentence(over).find("over the edge"), std::string::npos);
}

TEST(Placing, PiecesOnDifferentSheetsDoNotMeet) {
  const auto derived = derived_of(solved_pair());
  const Net& net = derived->shown->net;
  HandLayout placed = as_it_lies(*derived);
  placed.canvases.push_back({});
  placed.places[1].canvas = static_cast<int>(placed.canvases.size()) - 1;
  const auto layout = lay_out(net, {}, placed);
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->pages.size(), 2U);
  EXPECT_TRUE(find_misplaced(net, *layout).is_nothing());
}

TEST(Placing, PlacesOfOtherPiecesAreNoLayout) {
  const auto derived = derived_of(solved_pair());
  const Net& net = derived->shown->net;
  HandLayout placed = as_it_lies(*derived);
  EXPECT_FALSE(lay_out(net, {"A4", Orientation(placed.is_landscape ? 1 : 2), 10}, placed)) << "other pages";
  HandLayout twice = placed;
  twice.places[1] = twice.places[0];
  EXPECT_FALSE(lay_out(net, {}, twice));
  placed.places.pop_back();
  EXPECT_FALSE(lay_out(net, {}, placed));
}

TEST(Placing, ACutLeavesBothPartsWhereTheyLie) {
  Project project = bare(shapes::icosphere(2));
  const auto before = derived_of(project);
  project.placed = as_it_lies(*before);
  project.placed.places[0].turn = Rigid2::rotation(kTurn_rad) * project.placed.places[0].turn;
  const Mesh& mesh = project.dual->mesh();
  const PageLayout turned = *derived_of(project)->pages;
  for (const EdgeId e : mesh.edges()) {
    if (!project.tree->is_fold(mesh, e)) continue;
    const Project cut = edit_by_hand(project, *cut_at(mesh, *project.tree, e));
    const auto after = derived_of(cut);
    ASSERT_EQ(after->shown->net.n_pieces, 2);
    ASSERT_EQ(cut.placed.places.size(), 2U);
    ASSERT_TRUE(after->pages);
    EXPECT_FALSE(after->sheets) << "two pieces are not printed";
    const Net& net = after->shown->net;
    for (const HalfedgeId h : mesh.halfedges()) {
      const glm::dvec2 was = turned.on_canvas(0, before->shown->net.corner(h));
      const glm::dvec2 is = after->pages->on_canvas(net.piece[mesh.face(h)], net.corner(h));
      ASSERT_NEAR(glm::distance(was, is), 0, 1e-6);
    }
    EXPECT_TRUE(after->misplaced.overlapping.empty()) << "parts that touch do not overlap";
  }
}

TEST(Placing, AJoinMovesOnlyWhatSwingsOver) {
  Project project = bare(shapes::icosphere(2));
  const Mesh& mesh = project.dual->mesh();
  project.placed = as_it_lies(*derived_of(project));
  const auto may_cut = [](EdgeId) { return true; };
  for (const HalfedgeId h : mesh.halfedges()) {
    const auto edit = join_at(mesh, *project.tree, h, may_cut, FaceId());
    if (!edit) continue;
    const auto before = derived_of(project);
    const auto after = derived_of(edit_by_hand(project, *edit));
    ASSERT_EQ(after->pages->canvases.size(), 1U);
    for (const HalfedgeId side : mesh.halfedges()) {
      const FaceId f = mesh.face(side);
      if (std::find(edit->moved.begin(), edit->moved.end(), f) != edit->moved.end()) continue;
      const Net& net = after->shown->net;
      ASSERT_NEAR(glm::distance(after->pages->on_canvas(net.piece[f], net.corner(side)),
                                before->pages->on_canvas(0, before->shown->net.corner(side))),
                  0, 1e-6);
    }
  }
}

TEST(Placing, AnotherNetOrPaperIsArrangedAnew) {
  Project project = solved_pair();
  project.placed = as_it_lies(*derived_of(project));
  EXPECT_TRUE(set_paper(project, {"A3", Orientation::Auto, 10}).placed.is_automatic());
  EXPECT_TRUE(set_size(project, {PrintSize::Kind::Height, 500}).placed.is_automatic()) << "does not fit";
  EXPECT_TRUE(set_size(project, PrintSize()).placed.is_automatic()) << "fitting is arranging";
  EXPECT_TRUE(accept_tree(project, *project.tree, {}).placed.is_automatic());
  Progress progress;
  const Replacement newer = replace_model(project, "newer.obj", project.source, std::nullopt, progress);
  EXPECT_TRUE(newer.project.placed.is_automatic());
  EXPECT_EQ(set_seed(project, 9).placed, project.placed);
  EXPECT_EQ(pin_root(project, FaceId(3)).placed, project.placed);
  const auto rerooted = derived_of(pin_root(project, FaceId(3)));
  ASSERT_TRUE(rerooted->sheets);
  EXPECT_TRUE(rerooted->misplaced.is_nothing());
}

TEST(Placing, SmallerPiecesKeepTheirPlacesAndAngles) {
  Project project = solved_pair();
  const auto automatic = derived_of(project);
  project.placed = as_it_lies(*automatic);
  const Net& net = automatic->shown->net;
  const double height = automatic->pages->model_height_mm / 2;
  const Project smaller = set_size(project, {PrintSize::Kind::Height, height});
  ASSERT_FALSE(smaller.placed.is_automatic());
  const auto derived = derived_of(smaller);
  ASSERT_TRUE(derived->sheets);
  EXPECT_NEAR(derived->pages->model_height_mm, height, 1e-9);
  for (const int piece : {0, 1}) {
    const Box2 was = box_of(net, *automatic->pages, piece);
    const Box2 is = box_of(derived->shown->net, *derived->pages, piece);
    EXPECT_NEAR(glm::distance(is.centre(), was.centre()), 0, 1e-9);
    EXPECT_NEAR(glm::distance(is.size(), was.size() / 2.0), 0, 1e-9);
  }
}

TEST(Placing, SavedAndOpenedAgainThePiecesLieTheSame) {
  Project project = solved_pair();
  project.placed = as_it_lies(*derived_of(project));
  project.placed.places[0].turn = Rigid2::rotation(kTurn_rad) * project.placed.places[0].turn;
  const Project read = parse_project(project_bytes(project), "pair.netwright").project;
  expect_same(project, read);
  EXPECT_EQ(read.placed.places.size(), 2U);
  project.placed = {};
  EXPECT_TRUE(parse_project(project_bytes(project), "pair.netwright").project.placed.is_automatic());
}

TEST(Placing, AFileCannotPrintPiecesAtAnotherSize) {
  Project project = solved_pair();
  project.placed = as_it_lies(*derived_of(project));
  project.placed.places[0].turn.cos *= 1.5;
  project.placed.places[0].turn.sin *= 1.5;
  EXPECT_THROW(parse_project(project_bytes(project), "pair.netwright"), Error);
  project.placed = as_it_lies(*derived_of(project));
  project.placed.places[1].canvas = 7;
  EXPECT_THROW(parse_project(project_bytes(project), "pair.netwright"), Error);
}

TEST(MovePieces, ANewSheetComesAndAnEmptyOneGoes) {
  const auto derived = derived_of(solved_pair());
  const Net& net = derived->shown->net;
  const PageLayout& layout = *derived->pages;
  ASSERT_EQ(layout.canvases.size(), 1U);
  const HandLayout apart = move_pieces(net, layout, {{1, 1, shift(2, 3)}});
  const PageLayout two = *lay_out(net, {}, apart);
  EXPECT_EQ(two.pages.size(), 2U);
  EXPECT_NEAR(box_of(net, two, 1).min.x, box_of(net, layout, 1).min.x + 2, 1e-9);
  EXPECT_NEAR(box_of(net, two, 1).min.y, box_of(net, layout, 1).min.y - 3, 1e-9);
  const HandLayout together = move_pieces(net, two, {{0, 1, Rigid2()}});
  EXPECT_EQ(together.canvases.size(), 1U);
  EXPECT_EQ(lay_out(net, {}, together)->pages.size(), 1U);
}

TEST(AlignPieces, BringsBoxesInLine) {
  const auto derived = derived_of(solved_pair());
  const Net& net = derived->shown->net;
  const PageLayout& layout = *derived->pages;
  const auto boxes = [&](Align where) {
    const PageLayout aligned = *lay_out(net, {}, align_pieces(net, layout, {0, 1}, where));
    return std::pair(box_of(net, aligned, 0), box_of(net, aligned, 1));
  };
  const Box2 a = box_of(net, layout, 0);
  const Box2 b = box_of(net, layout, 1);
  const auto left = boxes(Align::Left);
  EXPECT_NEAR(left.first.min.x, std::min(a.min.x, b.min.x), 1e-9);
  EXPECT_NEAR(left.second.min.x, left.first.min.x, 1e-9);
  EXPECT_NEAR(left.second.min.y, b.min.y, 1e-9) << "up and down nothing moves";
  const auto right = boxes(Align::Right);
  EXPECT_NEAR(right.first.max.x, right.second.max.x, 1e-9);
  const auto top = boxes(Align::Top);
  EXPECT_NEAR(top.first.min.y, std::min(a.min.y, b.min.y), 1e-9);
  EXPECT_NEAR(top.first.min.y, top.second.min.y, 1e-9);
  const auto bottom = boxes(Align::Bottom);
  EXPECT_NEAR(bottom.first.max.y, std::max(a.max.y, b.max.y), 1e-9);
  EXPECT_NEAR(bottom.first.max.y, bottom.second.max.y, 1e-9);
  const auto across = boxes(Align::CentreAcross);
  EXPECT_NEAR(across.first.centre().x, across.second.centre().x, 1e-9);
  const auto upright = boxes(Align::CentreUpright);
  EXPECT_NEAR(upright.first.centre().y, upright.second.centre().y, 1e-9);
}

TEST(AlignPieces, OnePieceAloneGoesToTheEdgeOfItsSheet) {
  const auto derived = derived_of(solved_pair());
  const Net& net = derived->shown->net;
  const PageLayout aligned = *lay_out(net, {}, align_pieces(net, *derived->pages, {1}, Align::Bottom));
  EXPECT_NEAR(box_of(net, aligned, 1).max.y, aligned.frame.net.size().y, 1e-9);
  EXPECT_FALSE(std::binary_search(find_misplaced(net, aligned).over_edge.begin(),
                                  find_misplaced(net, aligned).over_edge.end(), 1));
}

TEST(SnappedTurn, PrefersTheNearerOfStepsAndEdges) {
  constexpr double kDegree = 3.14159265358979323846 / 180;
  EXPECT_NEAR(snapped_turn(47 * kDegree, {}), 45 * kDegree, 1e-12);
  EXPECT_NEAR(snapped_turn(-8 * kDegree, {}), -15 * kDegree, 1e-12);
  EXPECT_NEAR(snapped_turn(49 * kDegree, {51 * kDegree}), 51 * kDegree, 1e-12);
  EXPECT_NEAR(snapped_turn(-40 * kDegree, {51 * kDegree}), -39 * kDegree, 1e-12) << "a quarter turn less";
}

TEST(LevelTurns, LayAnEdgeLevelOrUpright) {
  const auto derived = derived_of(bare(shapes::tetrahedron()));
  const Net& net = derived->shown->net;
  const auto turns = level_turns(net, *derived->pages, {0});
  ASSERT_FALSE(turns.empty());
  for (const double turn : turns) {
    const Rigid2 turned = Rigid2::rotation(turn) * derived->pages->pieces[0].turn;
    double least = 1;
    for (const OutlineLoop& loop : outline_loops(net))
      for (const HalfedgeId h : loop.sides) {
        const glm::dvec2 along =
            glm::normalize(turned.rotate(net.corner(net.mesh().next(h)) - net.corner(h)));
        least = std::min({least, std::abs(along.x), std::abs(along.y)});
      }
    EXPECT_LT(least, 1e-9);
  }
}

class SessionPlacing : public SessionTest {
 protected:
  void SetUp() override { open_and_unfold(shapes::to_obj(two_solids())); }
  [[nodiscard]] const Net& net() const { return session_.shown()->net; }
  [[nodiscard]] HandLayout placed() const { return as_placed(net(), *session_.pages()); }
  [[nodiscard]] Box2 box(int piece) const { return box_of(net(), *session_.pages(), piece); }
  [[nodiscard]] bool until_laid_out(const std::shared_ptr<const PageLayout>& before) {
    return frames_until([&] { return session_.pages() && session_.pages() != before; });
  }
  /// Puts the first piece so far to the left; the second stays.
  void move_first(double left_mm) {
    HandLayout layout = placed();
    HandLayout::Place& place = place_of(layout, net(), net().tree.roots().front());
    place.turn = shift(-left_mm, 0) * place.turn;
    const auto before = session_.pages();
    session_.place_pieces(layout, "move piece");
    ASSERT_TRUE(until_laid_out(before));
  }
};

TEST_F(SessionPlacing, AMoveIsOneStepThatCanBeUndone) {
  const Box2 was = box(0);
  const Box2 other = box(1);
  HandLayout layout = placed();
  place_of(layout, net(), net().tree.roots().front()).turn =
      shift(0, 1.5) * place_of(layout, net(), net().tree.roots().front()).turn;
  const auto before = session_.pages();
  session_.place_pieces(layout, "move piece");
  ASSERT_TRUE(until_laid_out(before));
  EXPECT_EQ(session_.undo_label(), "Undo move piece");
  EXPECT_NEAR(box(0).min.y, was.min.y - 1.5, 1e-9);
  expect_near(box(1), other);
  const auto moved = session_.pages();
  session_.undo();
  ASSERT_TRUE(until_laid_out(moved));
  expect_near(box(0), was);
  EXPECT_FALSE(session_.has_placed_pieces());
}

TEST_F(SessionPlacing, ReArrangingGoesBackToTheLayoutMadeByItself) {
  const Box2 was = box(0);
  move_first(3);
  EXPECT_TRUE(session_.has_placed_pieces());
  const auto before = session_.pages();
  session_.rearrange_pieces();
  ASSERT_TRUE(until_laid_out(before));
  EXPECT_EQ(session_.undo_label(), "Undo re-arrange all");
  expect_near(box(0), was);
}

TEST_F(SessionPlacing, TheSheetsShowThePiecesWhereTheyWerePut) {
  // Smaller than the page allows, so that there is somewhere to go.
  const auto full = session_.pages();
  session_.set_size({PrintSize::Kind::Height, 40});
  ASSERT_TRUE(until_laid_out(full));
  const auto first_cut = [&] {
    for (const Stroke& stroke : session_.sheets()->front().strokes)
      if (stroke.layer == Layer::Cut && stroke.is_closed) return stroke.points;
    return std::vector<glm::dvec2>();
  };
  const std::vector<glm::dvec2> before = first_cut();
  ASSERT_FALSE(before.empty());
  HandLayout layout = placed();
  for (HandLayout::Place& place : layout.places) place.turn = shift(0, -0.5) * place.turn;
  const auto pages = session_.pages();
  session_.place_pieces(layout, "move 2 pieces");
  ASSERT_TRUE(until_laid_out(pages));
  ASSERT_TRUE(session_.sheets()) << misplaced_sentence(*session_.misplaced());
  const std::vector<glm::dvec2> after = first_cut();
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_NEAR(after[i].x, before[i].x, 1e-9);
    EXPECT_NEAR(after[i].y, before[i].y + 0.5, 1e-9);
  }
}

TEST_F(SessionPlacing, WhatHangsOverTheEdgeIsNotPrinted) {
  move_first(400);
  ASSERT_NE(session_.misplaced(), nullptr);
  EXPECT_EQ(session_.sheets(), nullptr);
  const auto file = in_folder("pair.pdf");
  session_.export_to(file);
  ASSERT_TRUE(
      frames_until([this] { return has_message(Message::Kind::Error, "over the edge of the page"); }));
  EXPECT_FALSE(std::filesystem::exists(file));
  session_.undo();
  ASSERT_TRUE(frames_until([this] { return session_.sheets() != nullptr; }));
  EXPECT_EQ(session_.misplaced(), nullptr);
}

}  // namespace
}  // namespace netwright
