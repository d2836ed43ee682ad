// Pinning edges and faces by keys, in the real interface.
#include <gtest/gtest.h>

#include "render/edge_picker.h"
#include "tests/gui_support.h"
#include "ui/actions.h"
#include "ui/pinning.h"
#include "ui/selection.h"

namespace netwright::testing {
namespace {

constexpr int kDeleteKey = 261;

struct Ball : Gui {
  Ball() {
    open_sample("Icosphere");
    EXPECT_TRUE(unfold());
  }
  [[nodiscard]] const Mesh& mesh() { return session().project().dual->mesh(); }
  [[nodiscard]] const Constraints& pins() { return session().project().pins; }
  EdgeId first_of(EdgeKind kind) {
    const auto& kinds = session().shown()->kinds;
    for (const EdgeId e : kinds.ids())
      if (kinds[e] == kind) return e;
    ADD_FAILURE() << "the net has no such edge";
    return {};
  }
  void choose(EdgeId e) {
    select_side(ui(), mesh(), mesh().halfedge(e), false);
    frames();
  }
};

TEST(Pinning, GPinsAFoldCPinsACutAndDelFreesThem) {
  Ball gui;
  const EdgeId e = gui.first_of(EdgeKind::Cut);
  gui.choose(e);
  gui.key('G');
  EXPECT_EQ(pin_of(gui.pins(), e), EdgePin::MustFold);
  EXPECT_EQ(gui.session().undo_label(), "Undo pin 1 fold");
  gui.key('C');
  EXPECT_EQ(pin_of(gui.pins(), e), EdgePin::MustCut);
  gui.key(kDeleteKey);
  EXPECT_TRUE(gui.pins().are_free());
  gui.key('G');
  gui.key('G');
  EXPECT_TRUE(gui.pins().are_free()) << "the same key again takes the pin away";
}

TEST(Pinning, TheEdgeUnderThePointerComesBeforeTheSelection) {
  Ball gui;
  const EdgeId selected = gui.first_of(EdgeKind::Cut);
  const EdgeId hovered = gui.first_of(EdgeKind::Mountain);
  gui.choose(selected);
  gui.ui().hovered_side = gui.mesh().halfedge(hovered);
  EXPECT_EQ(chosen_edges({gui.session(), gui.ui()}), std::vector<EdgeId>{hovered});
  gui.ui().hovered_side = gui.mesh().halfedge(selected);
  EXPECT_EQ(chosen_edges({gui.session(), gui.ui()}), std::vector<EdgeId>{selected});
}

TEST(Pinning, PinsAreDrawnInBothViewsAndToldInThePanel) {
  Ball gui;
  const auto count = [&](const std::vector<LineSegment>& lines, OverlayStyle style) {
    return std::count_if(lines.begin(), lines.end(),
                         [&](const LineSegment& l) { return l.style == static_cast<std::uint32_t>(style); });
  };
  gui.choose(gui.first_of(EdgeKind::Cut));
  gui.key('G');
  gui.choose(EdgeId(gui.first_of(EdgeKind::Mountain)));
  gui.key('C');
  clear_selection(gui.ui());
  gui.frames(2);
  const OverlayLines& lines = gui.app.workspace().overlay().lines();
  EXPECT_GE(count(lines.space, OverlayStyle::PinnedFold), 1);
  EXPECT_EQ(count(lines.plane, OverlayStyle::PinnedFold), 2) << "a cut has two sides on paper";
  EXPECT_GE(count(lines.space, OverlayStyle::PinnedCut), 1);
  gui.rect("pins/summary");
  EXPECT_EQ(pins_text(gui.pins()), "1 fold · 1 cut");
  gui.click("pins/clear");
  EXPECT_TRUE(gui.pins().are_free());
}

TEST(Pinning, SelectedFacesStayTogether) {
  Ball gui;
  const FaceId f(3);
  const FaceId g = gui.mesh().neighbour(gui.mesh().first(f));
  gui.key('K');
  EXPECT_TRUE(gui.pins().together.empty()) << "nothing is selected";
  select_face(gui.ui(), f, false);
  select_face(gui.ui(), g, true);
  gui.frames();
  gui.key('K');
  ASSERT_EQ(gui.pins().together.size(), 1u);
  gui.frames(2);
  std::size_t n_outline = 0;
  for (const LineSegment& l : gui.app.workspace().overlay().lines().space)
    n_outline += l.style == static_cast<std::uint32_t>(OverlayStyle::Patch) ? 1 : 0;
  EXPECT_GE(n_outline, 4u) << "two triangles that share a side have four others";
  EXPECT_EQ(gui.pins().together[0], (std::vector<FaceId>{std::min(f, g), std::max(f, g)}));
  gui.key('K');
  EXPECT_TRUE(gui.pins().together.empty());
}

TEST(Pinning, CulpritsOfAContradictionLightUp) {
  Ball gui;
  Constraints pins;
  const VertexId v = gui.mesh().from(gui.mesh().first(FaceId(0)));
  for (const HalfedgeId h : gui.mesh().halfedges())
    if (gui.mesh().from(h) == v) set_pin(pins, gui.mesh().edge(h), EdgePin::MustFold);
  gui.session().set_pins(pins, "pin folds");
  gui.frames(2);
  std::size_t n_lit = 0;
  for (const LineSegment& l : gui.app.workspace().overlay().lines().space)
    n_lit += l.style == static_cast<std::uint32_t>(OverlayStyle::Culprit) ? 1 : 0;
  EXPECT_EQ(n_lit, pins.must_fold.size());
  gui.click("pins/show");
  EXPECT_FALSE(gui.ui().lit.faces.empty());
  gui.key(' ');
  gui.frames(3);
  EXPECT_EQ(gui.session().state(), RunState::Idle);
  EXPECT_FALSE(gui.ui().error.empty());
}

}  // namespace
}  // namespace netwright::testing
