// netwright-cli bench as people and scripts meet it: the real program measures tiny models, and its rows, its
// table and its exit status are looked at.
#include <chrono>
#include <cmath>
#include <map>
#include <set>
#include <thread>

#include "tests/cli_support.h"

namespace netwright {
namespace {

namespace fs = std::filesystem;

using Strings = std::vector<std::string>;

const Strings kColumns{"folder",      "model",        "faces",          "seed",  "solved",
                       "verified",    "overlaps",     "iterations",     "moves", "restarts",
                       "cpu_seconds", "wall_seconds", "verify_seconds", "note"};

Strings split(const std::string& text, char separator) {
  Strings parts;
  std::istringstream stream(text + separator);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

using Row = std::map<std::string, std::string>;

class BenchCommandLine : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    models_ = folder_ / "models";
    fs::create_directories(models_);
    write("models/cube.obj", shapes::cube());
    write("models/ball.obj", shapes::icosahedron());
  }

  [[nodiscard]] Ended bench(const Strings& more) const {
    Strings words{"bench", "--tsv", tsv()};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
  [[nodiscard]] std::string tsv() const { return at("rows.tsv"); }

  /// The file's rows by column; every line must be whole.
  [[nodiscard]] std::vector<Row> rows() const {
    const std::string text = content(tsv());
    EXPECT_TRUE(text.empty() || text.back() == '\n') << text;
    std::vector<Row> found;
    for (const std::string& line : split(text, '\n')) {
      if (line.empty() || line.starts_with('#')) continue;
      const Strings fields = split(line, '\t');
      EXPECT_EQ(fields.size(), kColumns.size()) << line;
      if (fields == kColumns || fields.size() != kColumns.size()) continue;
      for (std::size_t i = 0; i < fields.size(); ++i) {
        if (i == 0) found.emplace_back();
        found.back()[kColumns[i]] = fields[i];
      }
    }
    return found;
  }
  /// The lines of the summary below one heading, by folder and column.
  [[nodiscard]] std::map<std::string, Row> summary(const std::string& times) const {
    std::map<std::string, Row> found;
    Strings columns;
    bool is_meant = false;
    for (const std::string& line : split(content(tsv()), '\n')) {
      if (!line.starts_with("# ")) continue;
      const Strings fields = split(line.substr(2), '\t');
      if (fields.size() == 1) {
        is_meant = fields[0].starts_with(times);
      } else if (fields[0] == "folder") {
        columns = fields;
      } else if (is_meant && fields.size() == columns.size()) {
        for (std::size_t i = 0; i < fields.size(); ++i) found[fields[0]][columns[i]] = fields[i];
      }
    }
    return found;
  }

  void wait_for_rows(std::size_t n) const {
    for (int i = 0; i < 1000; ++i) {
      const std::string text = content(tsv());
      if (std::count(text.begin(), text.end(), '\n') >= static_cast<std::ptrdiff_t>(n + 3))
        return;  // three lines above the first
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    FAIL() << "no rows came: " << content(tsv());
  }

  fs::path models_;
};

TEST_F(BenchCommandLine, LeavesOneRowForEachModelAndSeed) {
  const Ended ended = bench({models_.string(), "--seeds", "2"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
  Strings runs;
  for (const Row& row : rows()) {
    runs.push_back(row.at("model") + " " + row.at("seed"));
    EXPECT_EQ(row.at("folder"), models_.string());
    EXPECT_EQ(row.at("faces"), row.at("model") == "cube.obj" ? "6" : "20");
    EXPECT_EQ(row.at("solved"), "1");
    EXPECT_EQ(row.at("verified"), "1");
    EXPECT_EQ(row.at("overlaps"), "0");
    EXPECT_EQ(row.at("note"), "");
    EXPECT_GT(std::stod(row.at("cpu_seconds")), 0);
    EXPECT_GT(std::stod(row.at("wall_seconds")), 0);
    EXPECT_GT(std::stod(row.at("verify_seconds")), 0);
  }
  EXPECT_EQ(runs, (Strings{"ball.obj 0", "ball.obj 1", "cube.obj 0", "cube.obj 1"}));
  EXPECT_NE(ended.out.find("median"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("100 %"), std::string::npos) << ended.out;
}

TEST_F(BenchCommandLine, NeedsNoFileForItsTable) {
  const Ended ended = run({"bench", models_.string()});
  EXPECT_EQ(ended.status, 0);
  EXPECT_NE(ended.out.find("\nmodels"), std::string::npos) << ended.out;
  EXPECT_EQ(files(), (Strings{"models"}));
}

TEST_F(BenchCommandLine, TellsWhatPolishBrings) {
  write("ball.obj", shapes::icosphere(3));
  write("torus.obj", shapes::torus(9, 7));
  const Ended ended = run({"bench", folder_.string(), "--polish", "0.05"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  const std::size_t table = ended.out.find("Polish (medians");
  ASSERT_NE(table, std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("\n2      -", table), std::string::npos) << "two nets with shorter cuts\n"
                                                                    << ended.out;
  EXPECT_EQ(run({"bench", folder_.string()}).out.find("Polish (medians"), std::string::npos);
  EXPECT_EQ(run({"bench", folder_.string(), "--polish", "1", "--tsv", at("runs.tsv")}).status, 1)
      << "a table of runs has no room for it";
}

TEST_F(BenchCommandLine, AddsOnlyWhatIsMissing) {
  ASSERT_EQ(bench({models_.string()}).status, 0);
  const std::vector<Row> before = rows();
  ASSERT_EQ(before.size(), 2U);
  const Ended more = bench({models_.string() + "/", "--seeds", "2"});
  EXPECT_EQ(more.status, 0);
  EXPECT_NE(more.err.find("2 of 4 runs"), std::string::npos) << more.err;
  const std::vector<Row> after = rows();
  ASSERT_EQ(after.size(), 4U);
  EXPECT_EQ(after[0], before[0]);
  EXPECT_EQ(after[1], before[1]);
  EXPECT_EQ(after[2].at("seed"), "1");
  EXPECT_EQ(after[3].at("seed"), "1");
  EXPECT_EQ(summary("cpu_seconds").at(models_.string()).at("n"), "4");

  const std::string whole = content(tsv());
  EXPECT_EQ(bench({models_.string(), "--seeds", "2"}).status, 0);
  EXPECT_EQ(content(tsv()), whole);
}

TEST_F(BenchCommandLine, DropsARowThatWasCutOff) {
  ASSERT_EQ(bench({models_.string(), "--seeds", "2"}).status, 0);
  const std::vector<Row> before = rows();
  const std::string text = content(tsv());
  const std::size_t last = text.rfind(before[3].at("folder"), text.find("# cpu_seconds"));
  for (const std::size_t length : {last + 3, last + 40, text.find('\n', last)}) {
    write("rows.tsv", text.substr(0, length));
    EXPECT_EQ(bench({models_.string(), "--seeds", "2"}).status, 0);
    const std::vector<Row> after = rows();
    ASSERT_EQ(after.size(), 4U);
    EXPECT_TRUE(std::equal(after.begin(), after.begin() + 3, before.begin()));
    EXPECT_EQ(after[3].at("model"), before[3].at("model"));
    EXPECT_EQ(after[3].at("seed"), before[3].at("seed"));
  }
  write("rows.tsv", text.substr(0, 20));
  EXPECT_EQ(bench({models_.string()}).status, 0);
  EXPECT_EQ(rows().size(), 2U);
}

TEST_F(BenchCommandLine, LeavesFilesAloneThatItCannotGoOnWith) {
  ASSERT_EQ(bench({models_.string()}).status, 0);
  const std::string text = content(tsv());
  expect_refusal(bench({models_.string(), "--streams", "2"}), "these options");
  expect_refusal(bench({models_.string(), "--search", "paper"}), "these options");
  expect_refusal(bench({models_.string(), "--time-limit", "5"}), "these options");
  EXPECT_EQ(content(tsv()), text);

  const std::string cube = at("models/cube.obj");
  const std::string model = content(cube);
  expect_refusal(run({"bench", models_.string(), "--tsv", cube}), "cube.obj");
  EXPECT_EQ(content(cube), model);

  const std::string broken = text.substr(0, text.find("\n# ") + 1) + "what is this\n";
  write("rows.tsv", broken);
  expect_refusal(bench({models_.string()}), "what is this");
  EXPECT_EQ(content(tsv()), broken);
  expect_refusal(run({"bench", models_.string(), "--tsv", at("nowhere/rows.tsv")}), "nowhere");
  expect_refusal(run({"bench", models_.string(), "--tsv", models_.string()}), "no ordinary file");
}

TEST_F(BenchCommandLine, NotesWhyAModelWasRefusedAndGoesOn) {
  write("models/broken.obj", std::string("v 0 0 0\nv 1 0 0\nf 1 2 9\n"));
  write("models/bent.obj", std::string("v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nf 1 2 3 4\n"));
  const Ended ended = bench({models_.string()});
  EXPECT_EQ(ended.status, 0);
  const std::vector<Row> all = rows();
  ASSERT_EQ(all.size(), 4U);
  for (const Row& row : all) {
    const bool is_sound = row.at("model") == "ball.obj" || row.at("model") == "cube.obj";
    EXPECT_EQ(row.at("solved"), is_sound ? "1" : "0");
    EXPECT_EQ(row.at("verified"), is_sound ? "1" : "0");
    EXPECT_EQ(row.at("note").empty(), is_sound) << row.at("note");
    if (!is_sound) {
      EXPECT_NE(row.at("note").find(row.at("model")), std::string::npos) << row.at("note");
    }
  }
  const Row figures = summary("cpu_seconds").at(models_.string());
  EXPECT_EQ(figures.at("n"), "4");
  EXPECT_EQ(figures.at("refused"), "2");
  EXPECT_EQ(figures.at("success_percent"), "50.00");
  EXPECT_GT(std::stod(figures.at("min")), 0);
}

TEST_F(BenchCommandLine, CountsWhatTookTooLong) {
  const Ended ended = bench({endless_model(), at("models/cube.obj"), "--time-limit", "0.2"});
  EXPECT_EQ(ended.status, 0);
  const std::vector<Row> all = rows();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].at("solved"), "0");
  EXPECT_EQ(all[0].at("verified"), "0");
  EXPECT_EQ(all[0].at("note"), "the time was up");
  EXPECT_GT(std::stoi(all[0].at("overlaps")), 0);
  EXPECT_GT(std::stod(all[0].at("cpu_seconds")), 0);
  const std::map<std::string, Row> figures = summary("cpu_seconds");
  EXPECT_EQ(figures.at(folder_.string()).at("success_percent"), "0.00");
  EXPECT_EQ(figures.at(folder_.string()).at("max"), all[0].at("cpu_seconds"));
  EXPECT_EQ(figures.at(models_.string()).at("success_percent"), "100.00");
}

TEST_F(BenchCommandLine, NotesThatAModelWasProvedToHaveNoNet) {
  write("models/hats.obj", testing::with_hats(shapes::tetrahedron()));
  EXPECT_EQ(bench({at("models/hats.obj")}).status, 0);
  const std::vector<Row> all = rows();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].at("solved"), "0");
  EXPECT_NE(all[0].at("note").find("has no net"), std::string::npos) << all[0].at("note");
}

TEST_F(BenchCommandLine, LeavesWholeRowsOnCtrlC) {
  const Strings words{"bench",         "--tsv",   tsv(), "--time-limit", "0", at("models/cube.obj"),
                      endless_model(), "--seeds", "2"};
  Child child(folder_, words);
  wait_for_rows(2);
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  child.interrupt();
  const Ended ended = child.wait();
  EXPECT_EQ(ended.status, 130);
  EXPECT_EQ(ended.out, "");
  const std::vector<Row> stopped = rows();
  ASSERT_EQ(stopped.size(), 2U);
  EXPECT_EQ(content(tsv()).find("# cpu_seconds"), std::string::npos);

  EXPECT_EQ(bench({"--time-limit", "0", models_.string(), "--seeds", "2"}).status, 0);
  const std::vector<Row> resumed = rows();
  ASSERT_EQ(resumed.size(), 4U);
  EXPECT_TRUE(std::equal(stopped.begin(), stopped.end(), resumed.begin()));
}

TEST_F(BenchCommandLine, FiguresAreThoseOfTheRows) {
  for (int i = 2; i < 9; ++i) write("models/torus" + std::to_string(i) + ".obj", shapes::torus(i + 3, 5));
  const Ended ended = bench({models_.string(), "--seeds", "3", "--streams", "2"});
  EXPECT_EQ(ended.status, 0) << ended.err;
  for (const char* column : {"cpu_seconds", "wall_seconds"}) {
    std::vector<double> times;
    for (const Row& row : rows()) times.push_back(std::stod(row.at(column)));
    ASSERT_EQ(times.size(), 27U);
    std::sort(times.begin(), times.end());
    double sum = 0;
    double squares = 0;
    for (const double time : times) sum += time;
    const double mean = sum / 27;
    for (const double time : times) squares += (time - mean) * (time - mean);
    double kept_sum = 0;
    int kept = 0;
    for (const double time : times) {
      if (time > mean + 3 * std::sqrt(squares / 27)) continue;
      kept_sum += time;
      ++kept;
    }
    const Row figures = summary(column).at(models_.string());
    const auto expect = [&](const char* name, double value) {
      EXPECT_NEAR(std::stod(figures.at(name)), value, 1.5e-9) << column << " " << name;
    };
    expect("min", times.front());
    expect("mean", mean);
    expect("filtered_mean", kept_sum / kept);
    expect("median", times[13]);
    expect("p95", times[25]);
    expect("p99", times[26]);
    expect("max", times.back());
    EXPECT_EQ(figures.at("n"), "27");
  }
}

TEST_F(BenchCommandLine, PrintsTheFiguresWithUnits) {
  const Ended ended = bench({models_.string(), "--seeds", "2"});
  const Row figures = summary("cpu_seconds").at(models_.string());
  const Strings lines = split(ended.out, '\n');
  ASSERT_GE(lines.size(), 3U);
  std::istringstream line(lines[2]);
  std::string name;
  std::string percent_sign;
  std::string unit;
  int n = 0;
  int refused = -1;
  double success = 0;
  line >> name >> n >> success >> percent_sign >> refused;
  EXPECT_EQ(name, "models");
  EXPECT_EQ(n, 4);
  EXPECT_EQ(success, 100);
  EXPECT_EQ(refused, 0);
  for (const char* figure : {"min", "mean", "filtered_mean", "median", "p95", "p99", "max"}) {
    double value = 0;
    line >> value >> unit;
    EXPECT_EQ(unit, "ms");
    EXPECT_NEAR(value, 1000 * std::stod(figures.at(figure)), 0.006 * (1 + value)) << figure;
  }
}

TEST_F(BenchCommandLine, WritesAReport) {
  write("models/ball.obj", shapes::regular_prism(4));
  const Ended ended = bench({models_.string(), "--report", at("deep/report")});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("Report: " + at("deep/report/index.html")), std::string::npos) << ended.out;
  const std::string page = content(at("deep/report/index.html"));
  EXPECT_NE(page.find("</html>"), std::string::npos);
  EXPECT_NE(page.find("2, 2 runs"), std::string::npos) << page;
  EXPECT_TRUE(content(at("deep/report/time.svg")).starts_with("<svg "));
  EXPECT_TRUE(content(at("deep/report/success.svg")).starts_with("<svg "));
  EXPECT_TRUE(content(at("deep/report/iterations.svg")).starts_with("<svg "));
  expect_refusal(bench({models_.string(), "--report", at("models/cube.obj")}), "it is no folder");
}

TEST_F(BenchCommandLine, MakesTheReportAnewOfItsTableAlone) {
  EXPECT_EQ(bench({models_.string(), "--seeds", "2", "--report", at("first")}).status, 0);
  const std::string table = content(tsv());
  fs::remove_all(models_);
  const Ended ended = bench({"--report", at("second")});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_EQ(content(at("second/index.html")), content(at("first/index.html")));
  EXPECT_NE(ended.out.find("100 %"), std::string::npos) << ended.out;
  EXPECT_EQ(content(tsv()), table);

  expect_refusal(bench({}), "--report");
  write("rows.tsv", std::string("what is this\n"));
  expect_refusal(bench({"--report", at("third")}), "no table of a bench");
  write("rows.tsv", table.substr(0, table.find("\n# cpu") + 1) + "what is this\n");
  expect_refusal(bench({"--report", at("third")}), "what is this");
  EXPECT_FALSE(fs::exists(at("third")));
}

TEST_F(BenchCommandLine, NotesMachineAndBuildOnceForEach) {
  ASSERT_EQ(bench({models_.string()}).status, 0);
  ASSERT_EQ(bench({models_.string(), "--seeds", "2"}).status, 0);
  const std::string text = content(tsv());
  const std::size_t place = text.find("# measured with ");
  ASSERT_NE(place, std::string::npos) << text;
  EXPECT_EQ(text.find("# measured with ", place + 1), std::string::npos) << text;
  const std::string line = text.substr(place, text.find('\n', place) - place);
  EXPECT_NE(line.find(" thread"), std::string::npos) << line;
  EXPECT_NE(line.find("netwright-cli"), std::string::npos) << line;

  std::string elsewhere = text;
  elsewhere.replace(place, line.size(), "# measured with another machine");
  write("rows.tsv", elsewhere);
  ASSERT_EQ(bench({models_.string(), "--seeds", "3", "--report", at("report")}).status, 0);
  EXPECT_EQ(rows().size(), 6U);
  const std::string page = content(at("report/index.html"));
  EXPECT_NE(page.find("another machine"), std::string::npos);
  EXPECT_NE(page.find("netwright-cli 0"), std::string::npos);
}

TEST_F(BenchCommandLine, MakesAGroupOfEachFolder) {
  fs::create_directories(folder_ / "tiers/b");
  fs::create_directories(folder_ / "tiers/a");
  fs::create_directories(folder_ / "tiers/empty");
  write("tiers/a/one.obj", shapes::cube());
  write("tiers/a/readme.txt", std::string("not a model"));
  write("tiers/a/.hidden.obj", shapes::cube());
  write("tiers/b/two.obj", shapes::cube());
  EXPECT_EQ(bench({at("tiers"), at("tiers/b/two.obj")}).status, 0);
  Strings found;
  for (const Row& row : rows()) found.push_back(row.at("folder") + " " + row.at("model"));
  EXPECT_EQ(found, (Strings{at("tiers/a") + " one.obj", at("tiers/b") + " two.obj"}));
  expect_refusal(bench({at("tiers/empty")}), "no model");
  expect_refusal(bench({at("nothing")}), "no file or folder");
  expect_refusal(run({"bench"}), "PATH");
  expect_refusal(bench({at("tiers"), "--seeds", "0"}), "--seeds");
}

TEST_F(BenchCommandLine, FindsTheSameOnAnyNumberOfThreads) {
  write("models/sphere.obj", shapes::icosphere(4));
  const auto counts = [&](const char* threads) {
    std::set<Strings> found;
    EXPECT_EQ(bench({models_.string(), "--seeds", "3", "--streams", "2", "--threads", threads}).status, 0);
    for (const Row& row : rows())
      found.insert({row.at("model"), row.at("seed"), row.at("iterations"), row.at("moves")});
    fs::remove(tsv());
    return found;
  };
  EXPECT_EQ(counts("1"), counts("2"));
}

TEST_F(BenchCommandLine, ExplainsItself) {
  const Ended help = run({"bench", "--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* word : {"--seeds", "--time-limit", "--tsv", "--streams", "--threads", "--search",
                           "nearest rank", "--report"}) {
    EXPECT_NE(help.out.find(word), std::string::npos) << word;
  }
}

}  // namespace
}  // namespace netwright
