// The command line where one piece is impossible: the proof, its file, and nets of several pieces.
#include "core/project/proof_file.h"
#include "tests/cli_support.h"

namespace netwright {
namespace {

class PiecesCommandLine : public CommandLine {
 protected:
  std::string hats() { return write("hats.obj", testing::with_hats(shapes::octahedron())); }
};

TEST_F(PiecesCommandLine, TellsThatOnePieceIsImpossibleAndWritesTheProof) {
  const std::string proof = at("hats.proof");
  const Ended ended = run({"unfold", hats(), "-o", at("hats.pdf"), "--proof", proof});
  EXPECT_EQ(ended.status, 3);
  EXPECT_NE(ended.err.find("hats.obj has no net in one piece: that is proved."), std::string::npos)
      << ended.err;
  EXPECT_FALSE(std::filesystem::exists(at("hats.pdf")));
  const Ended checked = run({"verify", proof});
  EXPECT_EQ(checked.status, 0);
  EXPECT_NE(checked.out.find("Proved: hats.obj, 72 faces, has no net in one piece"), std::string::npos)
      << checked.out;
}

TEST_F(PiecesCommandLine, RefusesAProofThatWasTamperedWith) {
  const std::string path = at("hats.proof");
  ASSERT_EQ(run({"unfold", hats(), "--proof", path}).status, 3);
  const ProofFile whole = read_proof(path);
  ASSERT_TRUE(verify_impossible(whole.mesh, whole.proof).is_proved);
  ImpossibilityProof less = whole.proof;
  less.regions[0].joins.pop_back();
  write_proof(path, whole.mesh, less);
  EXPECT_EQ(read_proof(path).proof, less);
  const Ended refused = run({"verify", path});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.out.find("Not a proof: "), std::string::npos) << refused.out;
  std::ofstream(path) << R"({"netwright_proof": 9})";
  const Ended unreadable = run({"verify", path});
  EXPECT_EQ(unreadable.status, 1);
  EXPECT_NE(unreadable.err.find("netwright_proof"), std::string::npos) << unreadable.err;
}

TEST_F(PiecesCommandLine, AProofOfHingesSurvivesItsFile) {
  std::vector<glm::dvec2> outline;
  for (int i = 0; i < 14; ++i) {
    const double r = i % 2 == 0 ? 1 : 0.4;
    outline.emplace_back(r * std::cos(i * M_PI / 7), r * std::sin(i * M_PI / 7));
  }
  const std::string proof = at("star.proof");
  EXPECT_EQ(run({"unfold", write("star.obj", shapes::prism(outline, 0.5)), "--proof", proof}).status, 3);
  EXPECT_EQ(run({"verify", proof}).status, 0);
}

TEST_F(PiecesCommandLine, TakesTheFewestPieces) {
  const std::string net = at("hats.fold");
  const Ended ended = run({"unfold", hats(), "-o", net, "--fewest-pieces", "--height", "150"});
  ASSERT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("4 pieces, proved"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("of cuts on a model 150 mm high; fewer are impossible\n5 pieces: "),
            std::string::npos)
      << ended.out;
  EXPECT_EQ(run({"verify", net}).status, 2) << "one piece is what a net has, unless more are allowed";
  EXPECT_EQ(run({"verify", net, "--pieces", "3"}).status, 2);
  EXPECT_EQ(run({"verify", net, "--pieces", "4"}).status, 0);
}

TEST_F(PiecesCommandLine, AllowsNoMorePiecesThanWereNamed) {
  const Ended three = run({"unfold", hats(), "-o", at("hats.fold"), "--pieces", "3"});
  EXPECT_EQ(three.status, 3);
  EXPECT_FALSE(std::filesystem::exists(at("hats.fold")));
  EXPECT_NE(three.err.find("there are nets of 4 pieces, more than --pieces allows"), std::string::npos)
      << three.err;
  const Ended four = run({"unfold", hats(), "-o", at("hats.netwright"), "--pieces", "4", "--json"});
  ASSERT_EQ(four.status, 0) << four.err;
  const Json json = parse_json(four.out, "out");
  EXPECT_EQ(json.find("pieces")->integer(), 4);
  EXPECT_EQ(json.find("choices")->find("at_least")->integer(), 4);
  EXPECT_EQ(run({"verify", at("hats.netwright"), "--pieces", "4"}).status, 0);
}

TEST_F(PiecesCommandLine, AModelWithANetStaysOnePiece) {
  const Ended ended = run({"unfold", write("cube.obj", shapes::cube()), "--fewest-pieces"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_NE(ended.out.find("One piece, proved"), std::string::npos) << ended.out;
}

}  // namespace
}  // namespace netwright
