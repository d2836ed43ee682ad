// FOLD out and back without a digit lost, and one clear sentence for everything that is not a net.
#include "core/sheet/fold_file.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/sheet/write.h"
#include "core/unfold/verify.h"
#include "tests/sheet_support.h"

namespace netwright {
namespace {

using testing::net_of;

FlatNet flat_of(const PolygonSoup& soup, double scale = 12.3456789) {
  FlatNet flat = to_flat_net(spread_pieces(net_of(soup)), scale);
  flat.title = "A \"quoted\" title\n折り紙";
  return flat;
}

void expect_equal(const FlatNet& a, const FlatNet& b) {
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.folded, b.folded);
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_EQ(a.face_source, b.face_source);
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t i = 0; i < a.edges.size(); ++i) {
    EXPECT_EQ(a.edges[i].from, b.edges[i].from);
    EXPECT_EQ(a.edges[i].to, b.edges[i].to);
    EXPECT_EQ(a.edges[i].assignment, b.edges[i].assignment);
    EXPECT_NEAR(a.edges[i].fold_angle_rad, b.edges[i].fold_angle_rad, 1e-15);
  }
}

std::string refusal(const std::string& text) {
  try {
    parse_fold(text, "bad.fold");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Read);
    std::string sentence = error.what();
    EXPECT_EQ(sentence.rfind("bad.fold ", 0), 0U) << sentence;
    EXPECT_EQ(sentence.back(), '.') << sentence;
    return sentence;
  }
  ADD_FAILURE() << "nothing was refused in " << text.substr(0, 200);
  return "";
}

/// A good file with one piece of its text replaced.
std::string spoilt(const std::string& from, const std::string& to) {
  std::string text = fold_text(flat_of(shapes::tetrahedron()));
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(FoldFile, RoundTripsEveryShapeExactly) {
  for (const testing::ZooShape& shape : testing::zoo()) {
    SCOPED_TRACE(shape.soup.name);
    const FlatNet flat = flat_of(shape.soup);
    expect_equal(flat, parse_fold(fold_text(flat), "test"));
  }
}

TEST(FoldFile, RoundTripsThroughAFile) {
  const testing::TemporaryFolder folder;
  const FlatNet flat = flat_of(shapes::icosphere(2));
  write_fold(folder / "net.fold", flat);
  expect_equal(flat, read_fold(folder / "net.fold"));
  EXPECT_EQ(folder.files().size(), 1U);
}

TEST(FoldFile, SaysWhatTheStandardAndVerifyNeed) {
  const Json file = parse_json(fold_text(flat_of(shapes::cube(), 2)), "test");
  EXPECT_EQ(file.find("file_spec")->number(), 1.2);
  EXPECT_EQ(*file.find("file_creator")->text(), "Netwright");
  EXPECT_EQ(*file.find("frame_unit")->text(), "mm");
  EXPECT_EQ(file.find("netwright:face_source")->array()->size(), 6U);
  const Json& folded = file.find("file_frames")->array()->front();
  EXPECT_EQ(*folded.find("frame_classes")->array()->front().text(), "foldedForm");
  EXPECT_EQ(folded.find("frame_parent")->integer(), 0);
  EXPECT_EQ(folded.find("frame_inherit")->boolean(), true);
  EXPECT_EQ(folded.find("vertices_coords")->array()->size(), file.find("vertices_coords")->array()->size());
}

TEST(FoldFile, WritesAnglesInDegreesWithValleysPositive) {
  const Json file = parse_json(fold_text(flat_of(shapes::cube(), 2)), "test");
  const Json::Array& letters = *file.find("edges_assignment")->array();
  const Json::Array& angles = *file.find("edges_foldAngle")->array();
  int mountains = 0;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    const bool is_mountain = *letters[i].text() == "M";
    mountains += is_mountain ? 1 : 0;
    EXPECT_NEAR(*angles[i].number(), is_mountain ? -90 : 0, 1e-9);
  }
  EXPECT_EQ(mountains, 5);
}

TEST(FoldFile, WritesTheDrawingOfASolvedNetSoThatVerifyAccepts) {
  const testing::TemporaryFolder folder;
  const Net net = net_of(shapes::cube());
  write_drawing(folder / "net.fold", net, arrange(net, {}, {}), {"Cube", true, {}});
  const FlatNet flat = read_fold(folder / "net.fold");
  EXPECT_EQ(flat.title, "Cube");
  const VerifyReport report = verify(flat, 1);
  EXPECT_TRUE(report.is_net) << (report.faults.empty() ? "" : report.faults.front());
}

TEST(FoldFile, PrintsTheFlatFrameAtTheScaleOfThePages) {
  const testing::TemporaryFolder folder;
  const Net net = net_of(shapes::cube());
  write_drawing(folder / "net.fold", net, arrange(net, {}, {PrintSize::Kind::Height, 40}), {});
  const FlatNet flat = read_fold(folder / "net.fold");
  EXPECT_NEAR(mean_edge(flat), 40, 1e-9);
}

TEST(FoldFile, RefusesWhatIsNotJsonAndSaysWhere) {
  EXPECT_NE(refusal("").find("line 1"), std::string::npos);
  EXPECT_NE(refusal("{\n  \"a\": ,\n}").find("line 2, column 8"), std::string::npos);
  EXPECT_NE(refusal("[1, 2]").find("FOLD"), std::string::npos);
  EXPECT_NE(refusal("null").find("FOLD"), std::string::npos);
  EXPECT_NE(refusal("v 0 0 0\nf 1 2 3\n").find("not valid JSON"), std::string::npos);
  EXPECT_NE(refusal(std::string(5000, '[')).find("nested too deeply"), std::string::npos);
  EXPECT_NE(refusal("{\"a\": 1e999}").find("not valid JSON"), std::string::npos);
  EXPECT_NE(refusal("{\"a\": \"\xff\xfe\"}").find("not valid JSON"), std::string::npos);
}

TEST(FoldFile, RefusesMissingKeysByName) {
  for (const std::string key : {"vertices_coords", "faces_vertices", "edges_vertices", "edges_assignment",
                                "edges_foldAngle", "file_frames"})
    EXPECT_NE(refusal(spoilt("\"" + key + "\"", "\"other\"")).find("\"" + key + "\" is missing"),
              std::string::npos);
  EXPECT_NE(refusal(spoilt("foldedForm", "creasePattern")).find("foldedForm"), std::string::npos);
}

TEST(FoldFile, RefusesWrongTypesAndNumbersWithTheirPlace) {
  EXPECT_NE(refusal(spoilt("\"faces_vertices\": [", "\"faces_vertices\": 7, \"x\": [")).find("not a list"),
            std::string::npos);
  EXPECT_NE(refusal(spoilt("\"edges_assignment\": [\"", "\"edges_assignment\": [\"Q")).find("entry 0"),
            std::string::npos);
  EXPECT_NE(refusal(spoilt("\"edges_foldAngle\": [", "\"edges_foldAngle\": [0, ")).find("entries"),
            std::string::npos);
  EXPECT_NE(
      refusal(spoilt("\"netwright:face_source\": [0", "\"netwright:face_source\": [-1")).find("entry 0"),
      std::string::npos);
}

TEST(FoldFile, RefusesIndicesOutOfRange) {
  const std::string start = "\"faces_vertices\": [\n    [";
  for (const std::string bad : {"99, ", "-1, ", "1.5, ", "\"a\", ", "null, ", "99999999999999999999, "})
    EXPECT_NE(refusal(spoilt(start, start + bad)).find("entry 0 of \"faces_vertices\""), std::string::npos)
        << bad;
}

TEST(FoldFile, RefusesFacesThatAreNoPolygonsAndPointsOffThePlane) {
  const FlatNet good = flat_of(shapes::tetrahedron());
  FlatNet two = good;
  two.faces[2] = {0, 1};
  EXPECT_NE(refusal(fold_text(two)).find("entry 2 of \"faces_vertices\""), std::string::npos);
  FlatNet none = good;
  none.faces.clear();
  EXPECT_NE(refusal(fold_text(none)).find("no faces"), std::string::npos);
  FlatNet short_model = good;
  short_model.folded.pop_back();
  EXPECT_NE(refusal(fold_text(short_model)).find("folded form"), std::string::npos);
  FlatNet infinite = good;
  infinite.points[0].x = std::numeric_limits<double>::infinity();
  EXPECT_NE(refusal(fold_text(infinite)).find("not a number"), std::string::npos);
  const std::string coords = "\"vertices_coords\": [\n    [";
  EXPECT_NE(refusal(spoilt(coords, coords + "1, 2, 3],\n    [")).find("plane"), std::string::npos);
}

TEST(FoldFile, NeverCrashesOnADamagedFile) {
  const std::string good = fold_text(flat_of(shapes::cube()));
  Random random(11);
  int refused = 0;
  for (int round = 0; round < 400; ++round) {
    std::string bad = good;
    const int n_changes = 1 + random.below(4);
    for (int change = 0; change < n_changes; ++change) {
      const auto at = static_cast<std::size_t>(random.below(static_cast<int>(bad.size())));
      if (random.below(3) == 0)
        bad.erase(at, static_cast<std::size_t>(random.below(40)));
      else
        bad[at] = static_cast<char>(random.below(256));
    }
    try {
      parse_fold(bad, "damaged");
    } catch (const Error& error) {
      ++refused;
      EXPECT_EQ(error.kind(), ErrorKind::Read);
    }
  }
  EXPECT_GT(refused, 200);
}

TEST(FoldFile, NamesFilesThatAreNotThere) {
  try {
    read_fold("no/such/net.fold");
    ADD_FAILURE() << "nothing was refused";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("no/such/net.fold does not exist"), std::string::npos);
  }
}

}  // namespace
}  // namespace netwright
