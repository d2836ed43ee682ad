// Polish: a net stays a net on the way, keeps its pins, and is better by what it was asked for.
#include "core/solve/polish.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/solve/solve.h"
#include "core/unfold/net_size.h"
#include "tests/pins.h"
#include "tests/support.h"

namespace netwright {
namespace {

using testing::make_dual;
using testing::zoo;

constexpr double kMeanEdgeMm = 8;

SolveOptions polished(PolishSettings settings = {.effort = 0.04}) {
  SolveOptions options{.seed = 1, .streams = 1, .threads = 1};
  options.polish =
      PolishAim{settings, [](const Net& net) { return kMeanEdgeMm / net.mesh().mean_edge(); }, {}, {}};
  return options;
}

SolveResult solved(const std::shared_ptr<const DualGraph>& dual, const SolveOptions& options) {
  Progress progress;
  return solve(dual, options, progress);
}

double cut_length(const Mesh& mesh, const UnfoldTree& tree) {
  double length = 0;
  for (const EdgeId e : mesh.edges())
    if (!mesh.is_border(e) && !tree.is_fold(mesh, e)) length += mesh.length(e);
  return length;
}

/// A net in the search's own terms.
struct Laid {
  explicit Laid(const PolygonSoup& soup, double neck_width = 0)
      : dual(make_dual(soup)), models(search_models(*dual)), state(models.front(), 2e-11) {
    const SolveResult result = solved(dual, {.seed = 3, .streams = 1, .threads = 1});
    std::vector<char> folds;
    for (const HalfedgeId h : models.front().mesh_halfedge)
      folds.push_back(result.net.tree.is_fold(dual->mesh(), dual->mesh().edge(h)) ? 1 : 0);
    state.set_tree(folds);
    shape = std::make_unique<NetShape>(*dual, models.front(), state, neck_width);
  }
  std::shared_ptr<const DualGraph> dual;
  std::vector<SearchModel> models;
  SearchState state;
  std::unique_ptr<NetShape> shape;
};

/// Random exchanges, whatever they make overlap; `look` sees each before and after.
template <class Before, class After>
void exchange_at_random(Laid& laid, int n, Before&& before, After&& after) {
  const SearchModel& model = laid.models.front();
  Random random(5);
  std::vector<PathStep> path;
  for (int i = 0; i < n;) {
    const int wanted = random.below(model.n_halfedges);
    if (model.twin[static_cast<std::size_t>(wanted)] < 0 || laid.state.is_fold(wanted)) continue;
    laid.state.find_path(model.face_of[static_cast<std::size_t>(wanted)], model.beyond(wanted), path);
    const PathStep step = path[static_cast<std::size_t>(random.below(static_cast<int>(path.size())))];
    const int up = laid.state.up(step.child);
    const int removed = step.near_is_child ? up : model.twin[static_cast<std::size_t>(up)];
    const Exchange exchange = laid.state.exchange(step.child, removed, wanted);
    before(exchange);
    laid.state.apply(exchange);
    laid.shape->refresh();
    after(exchange);
    ++i;
  }
}

TEST(NetShape, ForetellsTheSpreadOfAnExchange) {
  Laid laid(shapes::icosphere(2));
  double foretold = 0;
  exchange_at_random(
      laid, 50, [&](const Exchange& exchange) { foretold = laid.shape->spread_after(exchange); },
      [&](const Exchange&) { ASSERT_NEAR(laid.shape->spread(), foretold, 1e-9 * foretold); });
}

TEST(NetShape, SpreadsADiscLeast) {
  EXPECT_NEAR(Laid(shapes::grid_patch(24, 24)).shape->spread(), 2 * 3.14159265 / 6, 1e-6) << "a square";
  EXPECT_GT(Laid(shapes::grid_patch(24, 2)).shape->spread(), 4) << "a strip";
}

TEST(NetShape, CountsNecksAsTheyComeAndGo) {
  for (const double width : {0.5, 0.9, 1.2}) {
    Laid laid(shapes::globe(), width);
    int foretold = 0;
    int seen = 0;
    exchange_at_random(
        laid, 60,
        [&](const Exchange& exchange) {
          foretold = laid.shape->necks() + laid.shape->neck_change(exchange.removed, exchange.inserted);
        },
        [&](const Exchange&) {
          ASSERT_EQ(laid.shape->necks(), foretold);
          seen += foretold;
        });
    EXPECT_GT(seen, 0);
  }
}

TEST(NetShape, CallsShortFoldsAndNarrowFacesNecks) {
  // Three squares in a row: the middle one is as wide as the folds beside it are long.
  const PolygonSoup row = shapes::grid_patch(3, 1);
  EXPECT_EQ(Laid(row, 0.99).shape->necks(), 0);
  EXPECT_EQ(Laid(row, 1.01).shape->necks(), 3) << "two folds, and the square between them";
}

TEST(Supports, LieJustOutsideTheHull) {
  const Laid square(shapes::grid_patch(4, 4));
  const Supports supports(square.state);
  EXPECT_NEAR(supports.area(), 16, 0.3);
  EXPECT_NEAR(supports.size_in({4, 4}), 1, 1e-9);
  EXPECT_NEAR(supports.size_in({8, 5}), 0.8, 1e-9);
  const Laid strip(shapes::grid_patch(6, 2));
  EXPECT_NEAR(Supports(strip.state).size_in({2, 6}), 1, 1e-9) << "upright";
  EXPECT_NEAR(Supports(strip.state).area(), 12, 0.6);
}

TEST(Supports, TouchEveryCornerWhateverTheFaces) {
  for (const auto& shape : zoo()) {
    const Laid laid(shape.soup);
    glm::dvec2 low(1e300);
    glm::dvec2 high(-1e300);
    for (int v = 0; v < static_cast<int>(laid.models.front().verts.size()); ++v) {
      low = glm::min(low, laid.state.placed(v));
      high = glm::max(high, laid.state.placed(v));
    }
    const glm::dvec2 middle = Supports(laid.state).middle();
    EXPECT_NEAR(middle.x, 0.5 * (low.x + high.x), 1e-9) << shape.soup.name;
    EXPECT_NEAR(middle.y, 0.5 * (low.y + high.y), 1e-9) << shape.soup.name;
  }
}

TEST(Polish, LeavesOneProvedNetWithShorterCuts) {
  double before = 0;
  double after = 0;
  for (const auto& shape : zoo()) {
    const auto dual = make_dual(shape.soup);
    const SolveResult result = solved(dual, polished());
    ASSERT_TRUE(result.is_proved) << shape.soup.name;
    ASSERT_TRUE(result.polished) << shape.soup.name;
    EXPECT_EQ(result.proof.pieces, shape.n_components) << shape.soup.name;
    EXPECT_TRUE(result.overlaps.empty());
    EXPECT_LE(result.polished->necks_after, result.polished->necks_before + 2) << shape.soup.name;
    before += cut_length(dual->mesh(), result.polished->first);
    after += cut_length(dual->mesh(), result.net.tree);
  }
  EXPECT_LT(after, 0.98 * before);
}

TEST(Polish, FillsTheHullOfARoundModel) {
  const auto dual = make_dual(shapes::icosphere(3));
  const SearchModel model = search_models(*dual).front();
  const auto spread = [&](const UnfoldTree& tree) {
    std::vector<char> folds;
    for (const HalfedgeId h : model.mesh_halfedge)
      folds.push_back(tree.is_fold(dual->mesh(), dual->mesh().edge(h)) ? 1 : 0);
    SearchState state(model, 2e-11);
    state.set_tree(folds);
    EXPECT_EQ(state.overlaps(), 0);
    return Supports(state).area() / model.total_area;
  };
  const SolveResult result = solved(dual, polished());
  EXPECT_LT(spread(result.net.tree), 0.85 * spread(result.polished->first));
}

TEST(Polish, GivesTheSameNetForTheSameSeed) {
  const auto dual = make_dual(shapes::icosphere(3));
  const SolveResult one = solved(dual, polished());
  EXPECT_EQ(one.net.tree, solved(dual, polished()).net.tree);
  EXPECT_NE(one.net.tree, one.polished->first);
  SolveOptions threaded = polished();
  threaded.threads = 2;
  EXPECT_EQ(one.net.tree, solved(dual, threaded).net.tree);
}

TEST(Polish, KeepsPins) {
  const auto dual = make_dual(shapes::grid_cube(4));
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Random random(seed);
    SolveOptions options = polished();
    options.pins = testing::random_pins(*dual, 3, random);
    const SolveResult result = solved(dual, options);
    ASSERT_TRUE(result.is_proved);
    EXPECT_TRUE(keeps_pins(dual->mesh(), result.net.tree, options.pins));
    EXPECT_NE(result.net.tree, result.polished->first);
  }
}

TEST(Polish, IsNotDoneUnlessAskedFor) {
  const auto dual = make_dual(shapes::icosphere(3));
  SolveOptions plain = polished();
  plain.polish.reset();
  const SolveResult result = solved(dual, plain);
  EXPECT_FALSE(result.polished);
  EXPECT_EQ(result.net.tree, solved(dual, polished()).polished->first);
  EXPECT_FALSE(solved(dual, polished({.effort = 0})).polished);
}

TEST(Polish, MakesANetFitThePage) {
  const auto dual = make_dual(shapes::icosphere(3));
  SolveOptions options = polished({.effort = 4, .fits_paper = 1});
  double area_mm2 = 0;
  for (const FaceId f : dual->mesh().faces()) area_mm2 += dual->mesh().area(f);
  area_mm2 *= std::pow(kMeanEdgeMm / dual->mesh().mean_edge(), 2);
  const double side_mm = std::sqrt(area_mm2 / 0.36);  // 36 % of a square page
  options.polish->rooms_mm = {{side_mm, side_mm}};
  const SolveResult result = solved(dual, options);
  ASSERT_TRUE(result.is_proved);
  EXPECT_GT(result.polished->size_before, 1.1);
  EXPECT_LE(result.polished->size_after, 1);
}

TEST(Polish, TellsWhenAPageCannotBeFit) {
  const auto dual = make_dual(shapes::cube());
  SolveOptions options = polished({.effort = 1, .fits_paper = 1});
  options.polish->rooms_mm = {{kMeanEdgeMm, kMeanEdgeMm}};
  const SolveResult result = solved(dual, options);
  EXPECT_TRUE(result.is_proved);
  EXPECT_GT(result.polished->size_after, 2);
}

TEST(Polish, TellsTheFiguresOfTheNetThatComesOut) {
  const auto dual = make_dual(shapes::grid_cube(4));
  SolveOptions options = polished({.effort = 0.04, .few_necks = 0, .fits_paper = 1});
  const double scale = 2.5 / dual->mesh().mean_edge();
  options.polish->scale = [scale](const Net&) { return scale; };
  options.polish->rooms_mm = {{24, 24}};
  options.tabs = TabAim{{}, [](const Net& net) { return kMeanEdgeMm / net.mesh().mean_edge(); }};
  const SolveResult result = solved(dual, options);
  ASSERT_TRUE(result.is_proved);
  const SearchModel model = search_models(*dual).front();
  std::vector<char> folds;
  for (const HalfedgeId h : model.mesh_halfedge)
    folds.push_back(result.net.tree.is_fold(dual->mesh(), dual->mesh().edge(h)) ? 1 : 0);
  SearchState state(model, 2e-11);
  state.set_tree(folds);
  const double mm = scale * dual->mesh().mean_edge();
  EXPECT_EQ(NetShape(*dual, model, state, kNeckWidth / mm).necks(), result.polished->necks_after);
  EXPECT_DOUBLE_EQ(Supports(state).size_in(glm::dvec2(24) / mm), result.polished->size_after);
}

TEST(Polish, BringsTheRootToTheMiddle) {
  const auto dual = make_dual(shapes::icosphere(3));
  const auto distance = [&](FaceId face, double weight) {
    SolveOptions options = polished({.effort = 0.08, .root_in_middle = weight});
    options.pins.root = face;
    const Net net = solved(dual, options).net;
    return glm::distance(net.box(face).centre(), net.box().centre()) / net.box().diagonal();
  };
  double asked = 0;
  double left_alone = 0;
  for (const FaceId face : {FaceId(7), FaceId(70), FaceId(150)}) {  // one may happen to lie in the middle
    const double off = distance(face, 3);
    EXPECT_LT(off, 0.15) << "this box is not quite the one that polish looks at";
    asked += off;
    left_alone += distance(face, 0);
  }
  EXPECT_LT(asked, left_alone / 2);
}

TEST(Polish, TellsWhichWishesAreNotMet) {
  const PolishSettings asked{.fits_paper = 1, .root_in_middle = 1};
  PolishReport report;
  report.size_after = 1;
  EXPECT_TRUE(unmet_wishes(report, asked).empty());
  report.size_after = 1.115;
  report.necks_after = 1;
  report.root_off = 0.3;
  const std::vector<std::string> all = {"12 % too large for the page", "1 neck under 3 mm",
                                        "the root is off the middle"};
  EXPECT_EQ(unmet_wishes(report, asked), all);
  EXPECT_TRUE(unmet_wishes(report, {.few_necks = 0}).empty()) << "what was not asked for is not missed";
}

TEST(Polish, MissesAPageThatNoNetFits) {
  SolveOptions options = polished({.effort = 0.05, .fits_paper = 1});
  options.polish->scale = [](const Net&) { return 100.0; };
  options.polish->rooms_mm = {{20, 20}};
  const SolveResult result = solved(make_dual(shapes::icosphere(2)), options);
  ASSERT_TRUE(result.is_proved);
  const std::vector<std::string> unmet = unmet_wishes(*result.polished, options.polish->settings);
  ASSERT_FALSE(unmet.empty());
  EXPECT_TRUE(unmet.front().ends_with(" % too large for the page")) << unmet.front();
}

TEST(Polish, HidesCutsWhereTheyAreNotSeen) {
  const auto dual = make_dual(shapes::icosphere(3));
  IdVector<EdgeId, double> sight(dual->mesh().n_edges(), 0);
  for (const EdgeId e : dual->mesh().edges()) sight[e] = e.value % 2 == 0 ? 1 : 0;
  const auto seen = [&](double weight) {
    SolveOptions options = polished({.effort = 0.08, .hidden_cuts = weight});
    options.polish->in_sight = sight;
    const SolveResult result = solved(dual, options);
    double length = 0;
    for (const EdgeId e : dual->mesh().edges())
      if (!result.net.tree.is_fold(dual->mesh(), e)) length += sight[e] * dual->mesh().length(e);
    return length;
  };
  EXPECT_LT(seen(2), 0.7 * seen(0));
}

TEST(Polish, ShowsProvedNetsThatNeverGetWorse) {
  const auto dual = make_dual(shapes::icosphere(3));
  Mailbox<Snapshot> box;
  std::vector<std::shared_ptr<const Snapshot>> seen;
  SolveHooks hooks{&box, {}, nullptr};
  hooks.pace = [&] {
    if (auto snapshot = box.take()) seen.push_back(std::move(snapshot));
    return Pace::Full;
  };
  Progress progress;
  const SolveResult result = solve(dual, polished(), progress, hooks);
  seen.push_back(box.take());
  int n_polished = 0;
  double fraction = 0;
  for (const auto& snapshot : seen) {
    if (!snapshot->polish) continue;
    ++n_polished;
    EXPECT_TRUE(snapshot->overlaps.empty());
    EXPECT_TRUE(verify(to_flat_net(snapshot->net, 1), 1).is_net);
    EXPECT_GE(snapshot->polish->fraction, fraction);
    fraction = snapshot->polish->fraction;
    EXPECT_TRUE(std::ranges::is_sorted(snapshot->polish->costs, std::ranges::greater()));
  }
  EXPECT_GT(n_polished, 10);
  EXPECT_TRUE(seen.back()->is_final);
  EXPECT_EQ(seen.back()->net.tree, result.net.tree);
  EXPECT_LT(seen.back()->polish->costs.back(), 0.9 * seen.back()->polish->costs.front());
}

TEST(Polish, TellsAWatcherOfEveryNetHowMuchIsCutAndHowMuchPaperItTakes) {
  const auto dual = make_dual(shapes::icosphere(3));
  Mailbox<Snapshot> box;
  Progress progress;
  const SolveResult result = solve(dual, polished(), progress, {&box, {}, nullptr});
  const auto last = box.take();
  ASSERT_TRUE(last && last->is_final && last->polish);
  const std::vector<PolishStation>& stations = last->polish->stations;
  ASSERT_GT(stations.size(), 3U);
  const Net first = layout(dual, result.polished->first);
  EXPECT_EQ(stations.front().fraction, 0);
  EXPECT_DOUBLE_EQ(stations.front().cut_length, cut_length(first));
  EXPECT_DOUBLE_EQ(stations.front().paper, paper_area(piece_hulls(first)));
  EXPECT_DOUBLE_EQ(stations.back().cut_length, cut_length(result.net));
  EXPECT_DOUBLE_EQ(stations.back().paper, paper_area(piece_hulls(result.net)));
  EXPECT_LT(stations.back().cut_length, stations.front().cut_length);
  EXPECT_LT(stations.back().paper, stations.front().paper);
  EXPECT_TRUE(std::ranges::is_sorted(stations, {}, &PolishStation::fraction));
  EXPECT_GT(stations.back().fraction, 0);
  EXPECT_LE(stations.back().fraction, 1);
  // The log's nets are some of these.
  EXPECT_EQ(result.log.back().polish_fraction, stations.back().fraction);
}

TEST(Polish, EndsWithTheBestSoFarWhenStopped) {
  const auto dual = make_dual(shapes::icosphere(3));
  Mailbox<Snapshot> box;
  int n_rounds = 0;
  SolveHooks hooks{&box, {}, nullptr};
  hooks.pace = [&] {
    const auto snapshot = box.take();
    return snapshot && snapshot->polish && ++n_rounds == 4 ? Pace::Stop : Pace::Full;
  };
  Progress progress;
  const SolveResult result = solve(dual, polished({.effort = 1000}), progress, hooks);
  EXPECT_EQ(n_rounds, 4);
  EXPECT_TRUE(result.is_proved);
  EXPECT_FALSE(result.was_cancelled);
  EXPECT_NE(result.net.tree, result.polished->first);
}

TEST(Polish, IsToldInTheLogAsNetsAfterTheSearch) {
  const SolveResult result = solved(make_dual(shapes::icosphere(3)), polished());
  ASSERT_GT(result.log.size(), 2U);
  EXPECT_FALSE(result.log.front().is_polish);
  EXPECT_TRUE(result.log.back().is_polish);
  EXPECT_EQ(result.log.back().start, result.net.tree);
  EXPECT_EQ(result.log.back().overlaps_at_start, 0);
}

}  // namespace
}  // namespace netwright
