// The command line as people and scripts meet it: the real program is started as a child, and its exit
// status, its words and its files are looked at.
#include <chrono>
#include <thread>

#include "tests/cli_support.h"

namespace netwright {
namespace {

TEST_F(CommandLine, UnfoldsACubeIntoEveryFormat) {
  const std::string cube = write("cube.obj", shapes::cube());
  const Ended ended = run(
      {"unfold", cube, "-o", at("net.pdf"), "-o", at("net.svg"), "-o", at("net.fold"), "-o", at("net.png")});
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(ended.err, "");
  EXPECT_EQ(files(), (Strings{"cube.obj", "net.fold", "net.pdf", "net.png", "net.svg"}));
  EXPECT_TRUE(content(at("net.pdf")).starts_with("%PDF-"));
  EXPECT_TRUE(content(at("net.png")).starts_with("\x89PNG"));
  EXPECT_NE(content(at("net.svg")).find("<svg"), std::string::npos);
  EXPECT_NE(ended.out.find("cube.obj: 6 faces, closed, genus 0"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("One piece, proved: no overlaps"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("net.svg"), std::string::npos) << ended.out;
}

TEST_F(CommandLine, WritesAFolderForACuttingMachine) {
  const std::string cube = write("cube.obj", shapes::cube());
  const Ended ended = run({"unfold", cube, "--cutter", "laser", "-o", at("laser/"), "-o", at("net.pdf")});
  EXPECT_EQ(ended.status, 0) << ended.err;
  for (const char* const name : {"laser/cube-print.pdf", "laser/cube-cut.svg", "laser/cube-cut.dxf"})
    EXPECT_FALSE(content(at(name)).empty()) << name;
  EXPECT_EQ(run({"unfold", cube, "--cutter", "scissors", "-o", at("out")}).status, 1);
  EXPECT_EQ(run({"unfold", cube, "-o", at("out")}).status, 1) << "no extension and no cutter";
}

TEST_F(CommandLine, WritesMachineFilesAsAskedFor) {
  const std::string cube = write("cube.obj", shapes::cube());
  const Ended ended = run({"unfold", cube, "--height", "300", "--one-file", "--real-dashes", "-o",
                           at("net.svg"), "-o", at("net.dxf")});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(files(), (Strings{"cube.obj", "net.dxf", "net.svg"}));
  EXPECT_EQ(content(at("net.svg")).find("stroke-dasharray"), std::string::npos);
}

TEST_F(CommandLine, PrintsAsAskedFor) {
  const std::string cube = write("cube.obj", shapes::cube());
  const auto svg_with = [&](Strings options) {
    options.insert(options.begin(), {"unfold", cube, "--height", "30", "-o", at("net.svg")});
    EXPECT_EQ(run(options).status, 0);
    return content(at("net.svg"));
  };
  EXPECT_NE(svg_with({"--lines", "cutter"}).find("stroke:#ff0000"), std::string::npos);
  EXPECT_EQ(svg_with({"--lines", "cutter", "--grey"}).find("stroke:#ff0000"), std::string::npos);
  EXPECT_NE(svg_with({"--side", "inside"}).find("mirrored"), std::string::npos);
  EXPECT_NE(svg_with({}), svg_with({"--no-numbers"}));
  EXPECT_NE(svg_with({}), svg_with({"--margin", "20"}));
  const auto n_paths = [](const std::string& svg) {
    int n = 0;
    for (std::size_t i = svg.find("<path"); i != std::string::npos; i = svg.find("<path", i + 1)) ++n;
    return n;
  };
  const std::string whole = svg_with({});
  EXPECT_EQ(svg_with({"--fold-ends", "0"}), whole);
  const std::string ends = svg_with({"--fold-ends", "4"});
  EXPECT_GE(n_paths(ends), n_paths(whole) + 5) << "two marks at each of the five folds";
  EXPECT_NE(svg_with({"--fold-ends", "6"}), ends);
  for (const Strings& wrong : {Strings{"--tabs", "1"},
                               {"--lines", "blue"},
                               {"--side", "left"},
                               {"--fold-ends", "-1"},
                               {"--loose-strips", "some"}}) {
    Strings command{"unfold", cube};
    command.insert(command.end(), wrong.begin(), wrong.end());
    EXPECT_EQ(run(command).status, 1) << wrong[0];
  }
}

TEST_F(CommandLine, LeavesLooseStripsOutWhenAskedTo) {
  // Sides much shorter than the least tab: every cut is left without one.
  const std::string cube = write("cube.obj", shapes::cube());
  const auto svg_with = [&](const Strings& more) {
    Strings options{"unfold", cube, "--height", "3.5", "-o", at("net.svg")};
    options.insert(options.end(), more.begin(), more.end());
    EXPECT_EQ(run(options).status, 0);
    return content(at("net.svg"));
  };
  const std::string with = svg_with({});
  EXPECT_EQ(svg_with({"--loose-strips", "on"}), with);
  EXPECT_LT(svg_with({"--loose-strips", "off"}).size(), with.size());
}

TEST_F(CommandLine, ReportsHowWellTheNetCanBeBuilt) {
  const std::string cube = write("cube.obj", shapes::cube());
  const Ended large = run({"unfold", cube, "--height", "40", "--report"});
  EXPECT_EQ(large.status, 0);
  EXPECT_NE(large.out.find("\nSmallest edge 40"), std::string::npos) << large.out;
  EXPECT_NE(large.out.find("sheet"), std::string::npos);
  EXPECT_NE(run({"unfold", cube, "--height", "4", "--report"}).out.find("warning: Smallest edge 4"),
            std::string::npos);
  const Json json = run_json({"unfold", cube, "--height", "2", "--report", "--json"}, 0);
  const Json::Array* const lines = json.find("report")->array();
  ASSERT_NE(lines, nullptr);
  EXPECT_EQ(*lines->front().find("grade")->text(), "trouble");
}

TEST_F(CommandLine, LooksForANetWithRoomForTabsEverywhere) {
  const std::string model = write("cube.obj", shapes::grid_cube(4));
  const auto n_without = [&](const std::string& tabs) {
    const Json json = run_json({"unfold", model, "--json", "--seed", "5", "--streams", "1", "--height", "60",
                                "--tabs", tabs, "-o", at("net.pdf")},
                               0);
    return json.find("cuts_without_tab")->integer().value();
  };
  const std::int64_t plain = n_without("5");
  EXPECT_GT(plain, 10);
  EXPECT_LT(4 * n_without("5,everywhere"), plain);
}

TEST_F(CommandLine, ReportsWithoutWritingWhenNoOutputIsNamed) {
  const Ended ended = run({"unfold", write("cube.obj", shapes::cube())});
  EXPECT_EQ(ended.status, 0);
  EXPECT_EQ(files(), (Strings{"cube.obj"}));
}

TEST_F(CommandLine, PrintsOneJsonObjectWithAllItsKeys) {
  const std::string model = write("torus.obj", shapes::torus(8, 5));
  const Json json = run_json({"unfold", model, "--json", "--seed", "7"}, 0);
  ASSERT_NE(json.object(), nullptr);
  Strings keys;
  for (const auto& member : *json.object()) keys.push_back(member.first);
  EXPECT_EQ(keys,
            (Strings{"model", "faces", "vertices", "genus", "closed", "pieces", "overlaps", "verified",
                     "seed", "iterations", "restarts", "cpu_seconds", "verify_seconds", "wall_seconds"}));
  EXPECT_EQ(*json.find("model")->text(), model);
  EXPECT_EQ(json.find("faces")->integer(), 80);
  EXPECT_EQ(json.find("vertices")->integer(), 40);
  EXPECT_EQ(json.find("genus")->integer(), 1);
  EXPECT_EQ(json.find("closed")->boolean(), true);
  EXPECT_EQ(json.find("pieces")->integer(), 1);
  EXPECT_EQ(json.find("overlaps")->integer(), 0);
  EXPECT_EQ(json.find("verified")->boolean(), true);
  EXPECT_EQ(json.find("seed")->integer(), 7);
  EXPECT_GE(json.find("wall_seconds")->number().value_or(-1),
            json.find("verify_seconds")->number().value_or(0));
}

TEST_F(CommandLine, UnfoldsEachComponentIntoAPieceOfItsOwn) {
  const std::string two = write("two.obj", shapes::combined(shapes::cube(), shapes::octahedron(), {5, 0, 0}));
  const Json json = run_json({"unfold", two, "--json", "-o", at("two.fold")}, 0);
  EXPECT_EQ(json.find("pieces")->integer(), 2);
  EXPECT_EQ(run({"verify", at("two.fold")}).status, 0);
}

TEST_F(CommandLine, GivesTheSameNetForTheSameSeedOnAnyNumberOfThreads) {
  const std::string model = write("sphere.obj", shapes::icosphere(4));
  EXPECT_EQ(run({"unfold", model, "-o", at("a.fold"), "--seed", "5", "--threads", "1"}).status, 0);
  EXPECT_EQ(run({"unfold", model, "-o", at("b.fold"), "--seed", "5", "--threads", "2"}).status, 0);
  EXPECT_EQ(run({"unfold", model, "-o", at("c.fold"), "--seed", "6", "--threads", "2"}).status, 0);
  EXPECT_EQ(content(at("a.fold")), content(at("b.fold")));
  EXPECT_NE(content(at("a.fold")), content(at("c.fold")));
}

TEST_F(CommandLine, SearchesAsThePaperHasItWhenAskedTo) {
  const std::string model = write("torus.obj", shapes::torus(10, 6));
  EXPECT_EQ(run({"unfold", model, "-o", at("usual.fold")}).status, 0);
  EXPECT_EQ(run({"unfold", model, "-o", at("fast.fold"), "--search", "fast"}).status, 0);
  EXPECT_EQ(run({"unfold", model, "-o", at("paper.fold"), "--search", "paper"}).status, 0);
  EXPECT_EQ(content(at("usual.fold")), content(at("fast.fold")));
  EXPECT_NE(content(at("usual.fold")), content(at("paper.fold")));
  EXPECT_EQ(run({"verify", at("paper.fold")}).status, 0);
  expect_refusal(run({"unfold", model, "--search", "slow"}), "fast or paper");
}

TEST_F(CommandLine, StartsAtTheFaceThatIsAskedFor) {
  const std::string model = write("solid.obj", shapes::icosahedron());
  EXPECT_EQ(run({"unfold", model, "--root", "20"}).status, 0);
  expect_refusal(run({"unfold", model, "--root", "21"}), "faces 1 to 20");
  expect_refusal(run({"unfold", model, "--root", "0"}), "--root");
}

TEST_F(CommandLine, PrintsAtTheHeightThatIsAskedFor) {
  const std::string model = write("cube.obj", shapes::cube());
  const Ended ended = run({"unfold", model, "-o", at("big.pdf"), "--height", "150", "--paper", "a4"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("150 mm high"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("A4, the model"), std::string::npos) << ended.out;
  const Ended tall = run({"unfold", model, "-o", at("tall.pdf"), "--height", "1500"});
  EXPECT_NE(tall.out.find("1500 mm high"), std::string::npos) << tall.out;
  expect_refusal(run({"unfold", model, "--height", "150", "--fit-page"}), "--height");
  expect_refusal(run({"unfold", model, "--height", "-1"}), "--height");
  expect_refusal(run({"unfold", model, "--paper", "A99"}), "A99");
}

TEST_F(CommandLine, VerifiesWhatItWroteAndNothingElse) {
  const std::string model = write("solid.obj", shapes::dodecahedron());
  ASSERT_EQ(run({"unfold", model, "-o", at("net.fold")}).status, 0);
  const Ended good = run({"verify", at("net.fold")});
  EXPECT_EQ(good.status, 0) << good.out;
  EXPECT_NE(good.out.find("12 faces in one piece"), std::string::npos) << good.out;
  const Json json = run_json({"verify", at("net.fold"), "--json"}, 0);
  EXPECT_EQ(json.find("verified")->boolean(), true);
  EXPECT_EQ(json.find("pieces")->integer(), 1);

  std::string text = content(at("net.fold"));
  const std::size_t coordinates = text.find("vertices_coords");
  ASSERT_NE(coordinates, std::string::npos);
  const std::size_t digit = text.find_first_of("123456789", text.find('[', coordinates));
  text[digit] = text[digit] == '9' ? '8' : static_cast<char>(text[digit] + 1);
  const Ended bad = run({"verify", write("bad.fold", text)});
  EXPECT_EQ(bad.status, 2) << bad.out;
  EXPECT_NE(bad.out.find("Not a net"), std::string::npos);
  expect_refusal(run({"verify", write("half.fold", text.substr(0, text.size() / 2))}), "half.fold");
  expect_refusal(run({"verify", at("none.fold")}), "none.fold");
}

TEST_F(CommandLine, TellsWhatAModelHolds) {
  const Ended good = run({"info", write("torus.obj", shapes::torus(8, 5))});
  EXPECT_EQ(good.status, 0);
  EXPECT_NE(good.out.find("80 faces"), std::string::npos) << good.out;
  const std::string fan = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n";
  EXPECT_EQ(run({"info", write("fan.obj", fan)}).status, 2);
  EXPECT_EQ(run_json({"info", at("fan.obj"), "--json"}, 2).find("fit")->boolean(), false);
  expect_refusal(run({"info", write("empty.obj", "")}), "empty.obj");
}

TEST_F(CommandLine, RefusesWhatCannotWorkBeforeItSearches) {
  const std::string model = endless_model();
  expect_refusal(run({"unfold", model, "-o", at("net.doc")}), ".pdf");
  expect_refusal(run({"unfold", model, "-o", at("net")}), ".pdf");
  expect_refusal(run({"unfold", model, "-o", at("nowhere/net.pdf")}), "does not exist");
  expect_refusal(run({"unfold", model, "--streams", "0"}), "--streams");
  for (const char* seed : {"-1", "1.5", "99999999999999999999", "x"}) {
    expect_refusal(run({"unfold", model, "--seed", seed}), "--seed");
  }
  expect_refusal(run({"unfold", model, "--time-limit", "nan"}), "--time-limit");
  expect_refusal(run({"unfold", model, "--seed", "1", "--seed", "2"}), "more than once");
  expect_refusal(run({"unfold", model, "--fast"}), "--fast");
  expect_refusal(run({"unfold"}), "MODEL");
  expect_refusal(run({"fold", model}), "unfold, replace, verify, info or bench");
  expect_refusal(run({}), "unfold, replace, verify, info or bench");
  EXPECT_EQ(files(), (Strings{"endless.obj"}));
}

TEST_F(CommandLine, WritesNothingWhenTheModelCannotBeUsed) {
  expect_refusal(run({"unfold", at("none.obj"), "-o", at("net.pdf")}), "none.obj");
  expect_refusal(run({"unfold", write("junk.obj", "\xff\xd8\xff\xe0 not a model"), "-o", at("net.pdf")}),
                 "junk.obj");
  expect_refusal(run({"unfold", write("bent.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nf 1 2 3 4\n"), "-o",
                      at("net.pdf")}),
                 "flat");
  EXPECT_EQ(files(), (Strings{"bent.obj", "junk.obj"}));
}

TEST_F(CommandLine, WritesNothingWhenTheTimeIsUp) {
  const std::string model = endless_model();
  const Json json = run_json({"unfold", model, "-o", at("net.pdf"), "--time-limit", "0.3", "--json"}, 2);
  EXPECT_EQ(json.find("verified")->boolean(), false);
  EXPECT_GT(json.find("overlaps")->integer(), 0);
  const Ended ended = run({"unfold", model, "-o", at("net.pdf"), "--time-limit", "0.3"});
  EXPECT_EQ(ended.status, 2);
  EXPECT_NE(ended.err.find("--time-limit"), std::string::npos);
  EXPECT_EQ(files(), (Strings{"endless.obj"}));
}

TEST_F(CommandLine, PolishesTheNetAndTellsSo) {
  const std::string model = write("ball.obj", shapes::to_obj(shapes::icosphere(3)));
  const Ended usual = run({"unfold", model, "--polish", "0.1", "--height", "100"});
  EXPECT_NE(usual.out.find("Polished: cuts "), std::string::npos) << usual.out;
  EXPECT_EQ(run({"unfold", model}).out.find("Polished"), std::string::npos);
  const Json json = run_json({"unfold", model, "--polish", "0.1", "--aim", "necks=3,compact", "--json"}, 0);
  const Json* polish = json.find("polish");
  ASSERT_NE(polish, nullptr);
  EXPECT_GT(polish->find("after")->find("hull_fill")->number(),
            1.1 * *polish->find("before")->find("hull_fill")->number());
  EXPECT_EQ(polish->find("after")->find("size_for_page"), nullptr);
  const Json page =
      run_json({"unfold", model, "--polish", "0.1", "--aim", "paper", "--height", "60", "--json"}, 0);
  EXPECT_LE(page.find("polish")->find("after")->find("size_for_page")->number(), 1);
}

TEST_F(CommandLine, RefusesAimsThatItDoesNotKnow) {
  for (const char* aim : {"beauty", "necks=", "necks=-1", "necks=1000", "=2"}) {
    const Ended ended = run({"unfold", write("cube.obj", shapes::cube()), "--aim", aim});
    EXPECT_EQ(ended.status, 1) << aim;
    EXPECT_NE(ended.err.find("it must be cuts, compact"), std::string::npos) << ended.err;
  }
}

TEST_F(CommandLine, TellsWhyThereIsNoNet) {
  const std::string model = write("hats.obj", shapes::to_obj(testing::with_hats(shapes::tetrahedron())));
  const Json json = run_json({"unfold", model, "--must-fold", "1:2", "--time-limit", "1", "--json"}, 3);
  const Json* why = json.find("why");
  ASSERT_NE(why, nullptr);
  ASSERT_FALSE(why->find("hot_faces")->array()->empty());
  EXPECT_EQ(why->find("hot_faces")->array()->front().find("heat")->number(), 1.0);
  ASSERT_FALSE(why->find("excess_points")->array()->empty());
  EXPECT_GT(why->find("excess_points")->array()->front().find("degrees")->number(), 360.0);
  EXPECT_TRUE(why->find("releases")->array()->empty());
  const Ended ended = run({"unfold", model, "--must-fold", "1:2", "--time-limit", "1"});
  EXPECT_NE(ended.err.find("Most often in collision: faces "), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("with more than 360"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("Without its pins no net was found either."), std::string::npos) << ended.err;
}

TEST_F(CommandLine, SoftensAShapeThatHasNoNet) {
  const std::string model = write("hats.obj", shapes::to_obj(testing::with_hats(shapes::tetrahedron())));
  const Json json = run_json(
      {"unfold", model, "-o", at("net.fold"), "--soften", "1000", "--time-limit", "20", "--json"}, 0);
  EXPECT_EQ(json.find("verified")->boolean(), true);
  ASSERT_NE(json.find("softened"), nullptr);
  EXPECT_GT(json.find("softened")->find("deviation_mm")->number(), 0.0);
  EXPECT_EQ(run({"verify", at("net.fold")}).status, 0);
}

TEST_F(CommandLine, EndsWithStatus130OnCtrlC) {
  write("net.pdf", std::string("what was there before"));
  Child child(folder_, {"unfold", endless_model(), "-o", at("net.pdf"), "--time-limit", "0"});
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  child.interrupt();
  const Ended ended = child.wait();
  EXPECT_EQ(ended.status, 130);
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(content(at("net.pdf")), "what was there before");
}

TEST_F(CommandLine, RepairsFlattensSimplifiesAndMergesOnlyWhenAsked) {
  PolygonSoup doubled = shapes::icosphere(4);
  doubled.add_face(std::vector<int>(doubled.face(5).begin(), doubled.face(5).end()));
  const std::string ball = write("ball.obj", doubled);
  expect_refusal(run({"unfold", ball, "-o", at("net.fold")}), "--repair");
  EXPECT_EQ(run_json({"unfold", ball, "--repair", "--json"}, 0).find("faces")->integer(), 320);

  const Ended fewer = run({"unfold", ball, "--repair", "--simplify", "100", "-o", at("net.fold")});
  EXPECT_EQ(fewer.status, 0) << fewer.err;
  EXPECT_NE(fewer.err.find("Simplified from 320 to 100 faces."), std::string::npos) << fewer.err;
  EXPECT_EQ(run({"verify", at("net.fold")}).status, 0);

  PolygonSoup bent = shapes::cuboid({2, 1, 3});
  bent.points.back() += glm::dvec3(0.1, 0.2, 0.15);
  const std::string box = write("box.obj", bent);
  expect_refusal(run({"unfold", box}), "Or add --planarize");
  EXPECT_EQ(run_json({"unfold", box, "--planarize", "--json"}, 0).find("faces")->integer(), 6);
  EXPECT_EQ(run_json({"unfold", box, "--split", "--json"}, 0).find("faces")->integer(), 9);
  expect_refusal(run({"unfold", box, "--split", "--planarize"}), "--split");

  const std::string cube = write("cube.obj", shapes::grid_cube(3));
  EXPECT_EQ(run_json({"unfold", cube, "--merge", "--json"}, 0).find("faces")->integer(), 6);
  expect_refusal(run({"unfold", cube, "--simplify", "3"}), "--simplify");
  expect_refusal(run({"unfold", cube, "--up", "x"}), "y or z");
  EXPECT_EQ(run({"unfold", cube, "--up", "z", "--height", "30", "-o", at("cube.pdf")}).status, 0);
}

TEST_F(CommandLine, ExplainsItself) {
  const Ended help = run({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* word : {"unfold", "verify", "info", "bench", "Exit status"}) {
    EXPECT_NE(help.out.find(word), std::string::npos) << word;
  }
  const Ended unfold = run({"unfold", "--help"});
  EXPECT_EQ(unfold.status, 0);
  for (const char* word : {"--seed", "--time-limit", "--streams", "--threads", "--search", "--root", "--up",
                           "--repair", "--planarize", "--split", "--simplify", "--merge", "--paper",
                           "--height", "--fit-page", "--json", "--output"}) {
    EXPECT_NE(unfold.out.find(word), std::string::npos) << word;
  }
  const Ended version = run({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_TRUE(version.out.starts_with("netwright-cli ")) << version.out;
}

}  // namespace
}  // namespace netwright
