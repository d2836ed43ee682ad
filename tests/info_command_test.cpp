// netwright-cli info: the report in words and as JSON, for sound, broken and hopeless models.
#include <algorithm>

#include "tests/cli_support.h"

namespace netwright {
namespace {

const Json* finding(const Json& json, const std::string& topic) {
  for (const Json& line : *json.find("findings")->array()) {
    if (*line.find("topic")->text() == topic) return &line;
  }
  return nullptr;
}

PolygonSoup with_doubled_face() {
  PolygonSoup soup = shapes::cube();
  soup.add_face(std::vector<int>(soup.face(3).begin(), soup.face(3).end()));
  return soup;
}

TEST_F(CommandLine, InfoTellsFactsOfASoundModel) {
  const std::string model = write("cube.obj", shapes::cuboid({60, 20, 30}));
  const Ended ended = run({"info", model});
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(
      ended.out,
      "cube.obj\n  6 faces, 8 corners\n  closed, genus 0\n  60 × 20 × 30, probably in mm\nFit to unfold.\n");
  const Json json = run_json({"info", model, "--json"}, 0);
  EXPECT_EQ(json.find("fit")->boolean(), true);
  EXPECT_EQ(json.find("unit")->text()->substr(0), "mm");
  EXPECT_EQ(json.find("size")->array()->at(2).number(), 30.0);
  EXPECT_EQ(finding(json, "counts")->find("count")->integer(), 6);
  EXPECT_TRUE(json.find("repair")->array()->empty());
}

TEST_F(CommandLine, InfoNamesCulpritsAndTellsWhatRepairWouldDo) {
  const std::string model = write("twice.obj", with_doubled_face());
  const Ended ended = run({"info", model});
  EXPECT_EQ(ended.status, 2);
  const std::string problem = "1 face has the same corners as another one (face 7).";
  EXPECT_NE(ended.out.find("  Problem: " + problem + "\n"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("With --repair it is fit to unfold:\n  Dropped 1 doubled face (7 → 6 faces).\n"),
            std::string::npos)
      << ended.out;
  const Json json = run_json({"info", model, "--json"}, 2);
  const Json* doubled = finding(json, "doubled_faces");
  ASSERT_NE(doubled, nullptr);
  EXPECT_EQ(*doubled->find("kind")->text(), "problem");
  EXPECT_EQ(*doubled->find("text")->text(), problem);
  ASSERT_EQ(doubled->find("faces")->array()->size(), 1U);
  EXPECT_EQ(doubled->find("faces")->array()->at(0).integer(), 7);
  EXPECT_EQ(json.find("repairable")->boolean(), true);
  EXPECT_EQ(json.find("repair")->array()->size(), 1U);
}

/// A crumb, a ball inside a box, that box.
PolygonSoup three_parts() {
  const PolygonSoup ball = shapes::combined(shapes::cube(0.1), shapes::icosphere(2), {9.5, 2, 0.3});
  return shapes::combined(ball, shapes::cube(4), {9, 0, 0});
}

TEST_F(CommandLine, InfoListsPartsAndUnfoldLeavesThemOut) {
  const std::string model = write("parts.obj", three_parts());
  const Ended ended = run({"info", model});
  EXPECT_NE(ended.out.find("Part 1: 6 faces, 4 × 4 × 4\n"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("Part 2: 80 faces, 2 × 2 × 2, inside another one\n"), std::string::npos)
      << ended.out;
  EXPECT_NE(ended.out.find("Part 3: 6 faces, 0.1 × 0.1 × 0.1, small\n"), std::string::npos) << ended.out;
  const Json json = run_json({"info", model, "--json"}, 0);
  ASSERT_EQ(json.find("parts")->array()->size(), 3U);
  EXPECT_EQ(json.find("parts")->array()->at(1).find("inner")->boolean(), true);
  const std::string net = at("net.fold");
  EXPECT_EQ(run_json({"unfold", model, "--json", "--leave-out", "inner"}, 0).find("pieces")->integer(), 2);
  EXPECT_EQ(run_json({"unfold", model, "--json", "--leave-out", "2,small"}, 0).find("faces")->integer(), 6);
  EXPECT_EQ(run_json({"unfold", model, "--json", "--leave-out", "1", "-o", net}, 0).find("faces")->integer(),
            86);
  EXPECT_EQ(run({"verify", net}).status, 0);
  expect_refusal(run({"unfold", model, "--leave-out", "4"}), "no part 4");
  expect_refusal(run({"unfold", model, "--leave-out", "1,2,3"}), "keep at least one");
  expect_refusal(run({"unfold", model, "--leave-out", "outer"}), "inner, small");
}

TEST_F(CommandLine, PartsKeepTheirNumbersWhateverIsWelded) {
  // Two halves of a box that a hair's breadth parts, and a small cube: welded, the box is one part.
  PolygonSoup box = shapes::cuboid({4, 4, 4});
  PolygonSoup halves;
  for (int f = 0; f < box.n_faces(); ++f) {
    std::vector<int> corners;
    for (const int c : box.face(f)) {
      glm::dvec3 p = box.points[static_cast<std::size_t>(c)];
      if (f >= 3) p += glm::dvec3(1e-4);
      corners.push_back(static_cast<int>(halves.points.size()));
      halves.points.push_back(p);
    }
    halves.add_face(corners);
  }
  const std::string model = write("halves.obj", shapes::combined(halves, shapes::cube(1), {12, 0, 0}));
  const auto parts = [&](const Json& json) { return json.find("parts")->array()->size(); };
  const std::size_t n_parts = parts(run_json({"info", model, "--json"}, 0));
  ASSERT_GE(n_parts, 3U);
  const std::string last = std::to_string(n_parts);
  EXPECT_EQ(run_json({"unfold", model, "--json", "--weld", "1"}, 0).find("pieces")->integer(), 2);
  EXPECT_EQ(
      run_json({"unfold", model, "--json", "--weld", "1", "--leave-out", last}, 0).find("faces")->integer(),
      6);
  EXPECT_EQ(
      run_json({"unfold", model, "--json", "--weld", "1", "--leave-out", "1"}, 0).find("faces")->integer(), 6)
      << "what is welded to a part that is left out goes with it";
}

TEST_F(CommandLine, SingleRepairsAreDoneAsAskedFor) {
  PolygonSoup ball = shapes::icosphere(2);
  ball.corners.resize(ball.corners.size() - 3);
  ball.face_begin.pop_back();
  const std::string model = write("ball.obj", ball);
  EXPECT_EQ(run_json({"unfold", model, "--json", "--repair"}, 0).find("closed")->boolean(), false);
  EXPECT_EQ(run_json({"unfold", model, "--json", "--close-holes", "3"}, 0).find("closed")->boolean(), true);
  PolygonSoup torn = shapes::cube();
  torn.points.push_back(torn.points[0] + glm::dvec3(0.001));
  torn.corners[0] = 8;
  const std::string box = write("torn.obj", torn);
  EXPECT_EQ(run_json({"unfold", box, "--json", "--weld", "0.1", "--split"}, 0).find("closed")->boolean(),
            false);
  EXPECT_EQ(run_json({"unfold", box, "--json", "--weld", "2", "--split"}, 0).find("closed")->boolean(), true)
      << "the file is in metres, probably";
  expect_refusal(run({"unfold", box, "--weld", "-1"}), "--weld");
}

TEST_F(CommandLine, SaysHowToSizeAModelThatIsHuge) {
  const std::string model = write("huge.obj", shapes::cube(3200));
  const Ended ended = run({"unfold", model, "-o", at("net.svg")});
  EXPECT_EQ(ended.status, 0);
  EXPECT_NE(ended.err.find("3.2 m tall"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("--height 200"), std::string::npos) << ended.err;
  EXPECT_EQ(run({"unfold", model, "-o", at("net.svg"), "--fit-page"}).err, "");
  EXPECT_EQ(run({"unfold", model, "-o", at("net.svg"), "--height", "200"}).err, "");
  EXPECT_EQ(run({"unfold", model}).err, "") << "nothing is printed";
}

TEST_F(CommandLine, InfoSaysWhatCannotBeRepaired) {
  // A Möbius strip of five triangles.
  const std::string strip =
      "v 0 0 0\nv 4 0 0\nv 5 3 1\nv 2 5 2\nv -1 3 1\nf 1 2 3\nf 2 3 4\nf 3 4 5\nf 4 5 1\nf 5 1 2\n";
  const Ended ended = run({"info", write("strip.obj", strip)});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.out.find("only one side"), std::string::npos) << ended.out;
  EXPECT_EQ(ended.out.find("With --repair"), std::string::npos) << ended.out;
  const Json json = run_json({"info", at("strip.obj"), "--json"}, 2);
  EXPECT_EQ(json.find("repairable")->boolean(), false);
  EXPECT_NE(finding(json, "one_sided"), nullptr);
}

}  // namespace
}  // namespace netwright
