// A reader that crashes, hangs or swallows memory: each costs the user one sentence, and nothing else.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <functional>

#include <string>
#include <thread>

#include "core/base/error.h"
#include "core/mesh/readers.h"
#include "core/project/session.h"
#include "tests/model_files.h"
#include "tests/sheet_support.h"
#include "tests/support.h"

namespace netwright {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kCanLimitMemory = false;
#else
constexpr bool kCanLimitMemory = true;
#endif

constexpr std::size_t kMegabyte = std::size_t{1} << 20;

/// Time out of mind for what must not be cut short, a blink for what must.
readers::ChildReader misbehaving(double seconds = 60) {
  return {NETWRIGHT_MISBEHAVING_READER,
          {.seconds = seconds, .memory_bytes = 200 * kMegabyte, .output_bytes = 4 * kMegabyte}};
}

std::string sentence_of(const std::function<void()>& reads) {
  try {
    reads();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Read);
    std::string said = error.what();
    EXPECT_TRUE(said.ends_with(".")) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    return said;
  }
  ADD_FAILURE() << "nothing was refused";
  return "";
}

std::string sentence_when_it(const std::string& wish, double seconds = 60) {
  const auto no_companions = [](const std::string&) { return std::nullopt; };
  return sentence_of([&] {
    static_cast<void>(readers::read_in_child("pot.dae", wish, "dae", no_companions, misbehaving(seconds)));
  });
}

/// The largest child of this process so far, in bytes.
std::size_t largest_child() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

/// Nodes in nodes in nodes: Assimp follows them with its stack until there is none left.
std::string deep_collada() {
  constexpr int kDepth = 200'000;
  std::string text =
      R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">)"
      R"(<asset><up_axis>Y_UP</up_axis></asset><library_visual_scenes><visual_scene id="s" name="s">)";
  for (int i = 0; i < kDepth; ++i) text += "<node>";
  for (int i = 0; i < kDepth; ++i) text += "</node>";
  return text +
         R"(</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

/// A text STL that takes Assimp far longer than a blink.
std::string long_stl() {
  std::string text = "solid long\n";
  for (int i = 0; i < 100'000; ++i)
    text += "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
  return text + "endsolid long\n";
}

TEST(ReaderInChild, ACrashIsOneSentence) {
  for (const char* wish : {"crash", "abort"})
    EXPECT_NE(sentence_when_it(wish).find(
                  "pot.dae: the file is damaged in a way that stops the program reading it"),
              std::string::npos);
}

TEST(ReaderInChild, AHangEndsWithItsTime) {
  for (const char* wish : {"sleep", "spin"})
    EXPECT_NE(sentence_when_it(wish, 0.2).find("takes more time or memory than a model should"),
              std::string::npos);
}

TEST(ReaderInChild, MemoryWithoutEndEndsAtTheLimit) {
  if (!kCanLimitMemory) GTEST_SKIP() << "sanitizers need address space without limits";
  EXPECT_NE(sentence_when_it("swallow").find("stops the program reading it"), std::string::npos);
  EXPECT_LT(largest_child(), 300 * kMegabyte);
}

TEST(ReaderInChild, OutputWithoutEndEndsAtTheLimit) {
  EXPECT_NE(sentence_when_it("flood").find("takes more time or memory than a model should"),
            std::string::npos);
}

TEST(ReaderInChild, AnswersThatMakeNoSenseAreNotBelieved) {
  for (const char* wish : {"lie", "gossip", "fail", "say nothing"})
    EXPECT_NE(sentence_when_it(wish).find("gave no sensible answer"), std::string::npos) << wish;
}

TEST(ReaderInChild, SaysWhenTheReaderIsMissing) {
  const auto no_companions = [](const std::string&) { return std::nullopt; };
  EXPECT_NE(sentence_of([&] {
              static_cast<void>(
                  readers::read_in_child("pot.dae", "x", "dae", no_companions, {"/nowhere/reader", {}}));
            }).find("is missing; install Netwright again"),
            std::string::npos);
}

TEST(RealReader, CrashesOnDeepNestingAndThatIsOneSentence) {
  if (!kCanLimitMemory) GTEST_SKIP() << "the sanitizers tell of the crash themselves";
  EXPECT_NE(sentence_of([] {
              static_cast<void>(read_soup_bytes("deep.dae", deep_collada()));
            }).find("deep.dae: the file is damaged in a way that stops the program reading it"),
            std::string::npos);
}

TEST(RealReader, IsStoppedWhenItTakesTooLong) {
  readers::ChildReader reader = readers::usual_child_reader();
  reader.limits.seconds = 0.02;
  const auto no_companions = [](const std::string&) { return std::nullopt; };
  EXPECT_NE(sentence_of([&] {
              static_cast<void>(readers::read_in_child("long.stl", long_stl(), "stl", no_companions, reader));
            }).find("takes more time or memory"),
            std::string::npos);
}

TEST(RealReader, IsStoppedWhenAFileUnpacksToFarMoreThanItIs) {
  if (!kCanLimitMemory) GTEST_SKIP() << "sanitizers need address space without limits";
  // 300 MB of blanks in 300 kB of zip archive.
  const testing::TemporaryFolder folder;
  const std::string script =
      "import zipfile,sys\n"
      "z=zipfile.ZipFile(sys.argv[1],'w',zipfile.ZIP_DEFLATED)\n"
      "z.writestr('_rels/.rels','<?xml version=\"1.0\"?><Relationships "
      "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
      "Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
      "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>')\n"
      "z.writestr('3D/3dmodel.model',' '*(300<<20)+'<?xml version=\"1.0\"?><model/>')\n"
      "z.close()\n";
  testing::output_of({"python3", "-c", script, (folder / "bomb.3mf").string()});
  readers::ChildReader reader = readers::usual_child_reader();
  reader.limits.memory_bytes = 250 * kMegabyte;
  const std::string bytes = testing::read_file(folder / "bomb.3mf");
  EXPECT_LT(bytes.size(), kMegabyte);
  const auto no_companions = [](const std::string&) { return std::nullopt; };
  EXPECT_NE(sentence_of([&] {
              static_cast<void>(readers::read_in_child("bomb.3mf", bytes, "3mf", no_companions, reader));
            }).find("bomb.3mf: the file is damaged"),
            std::string::npos);
}

TEST(RealReader, ACrashLeavesTheOpenProjectAsItIs) {
  double now = 0;
  Session session([&] { return now; });
  const auto turn_until = [&](const std::function<bool()>& holds) {
    for (int i = 0; i < 50000 && !holds(); ++i) {
      session.poll();
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    return holds();
  };
  session.open_bytes("ball.obj", shapes::to_obj(shapes::icosphere(1)));
  ASSERT_TRUE(turn_until([&] { return session.state() == RunState::Idle; }));
  session.set_size({PrintSize::Kind::Height, 77});
  const Project before = session.project();
  session.take_messages();
  session.open_bytes("deep.dae", deep_collada());
  ASSERT_TRUE(turn_until([&] { return session.state() == RunState::Idle; }));
  const std::vector<Message> said = session.take_messages();
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said.front().kind, Message::Kind::Error);
  EXPECT_EQ(session.project(), before);
  EXPECT_TRUE(session.can_undo());
}

}  // namespace
}  // namespace netwright
