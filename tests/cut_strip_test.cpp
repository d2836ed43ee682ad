// Strips of paper and the sheets that cover them: as few as it takes, joined where the fewest marks are cut.
#include "core/sheet/cut_strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "core/base/random.h"

namespace netwright {
namespace {

constexpr double kOverlap = 10;
constexpr double kWindow = 60;

double cost_of(std::size_t n_sheets, int n_cut_marks) {
  return kMarksPerSheet * static_cast<double>(n_sheets) + n_cut_marks;
}

/// The least cost of all ways to lay seams at multiples of half a millimetre, by trying them.
class EveryWay {
 public:
  explicit EveryWay(const StripToCut& strip) : strip_(strip) {}

  double best() {
    go_on(0, strip_.paper.front().low, false, 0, 0);
    return best_;
  }

 private:
  void go_on(std::size_t stretch, double low, bool is_joined, std::size_t n_sheets, int n_cut) {
    const double half = kOverlap / 2;
    const double reach = low + kWindow - (is_joined ? half : 0);
    ++n_sheets;
    if (cost_of(n_sheets, n_cut) >= best_) return;
    for (std::size_t i = stretch; i < strip_.paper.size(); ++i) {
      const Span& paper = strip_.paper[i];
      if (paper.high <= reach && paper.high - low >= (is_joined ? kOverlap : 0)) {
        if (i + 1 == strip_.paper.size())
          best_ = std::min(best_, cost_of(n_sheets, n_cut));
        else
          go_on(i + 1, strip_.paper[i + 1].low, false, n_sheets, n_cut);
      }
      for (double seam = strip_.paper.front().low; seam + half <= reach; seam += 0.5) {
        if (seam - low < kOverlap || seam < paper.low + half || seam > paper.high - half) continue;
        int n_here = n_cut;
        for (const Span& mark : strip_.marks) n_here += mark.low < seam && seam < mark.high ? 1 : 0;
        go_on(i, seam, true, n_sheets, n_here);
      }
    }
  }

  const StripToCut& strip_;
  double best_ = std::numeric_limits<double>::infinity();
};

StripToCut random_strip(Random& random) {
  StripToCut strip;
  double at = random.unit() * 20;
  const int n_stretches = 1 + static_cast<int>(random.below(3));
  for (int i = 0; i < n_stretches; ++i) {
    const double length = 5 + random.unit() * 60;
    strip.paper.push_back({at, at + length});
    at += length + kOverlap + 1 + random.unit() * 30;
  }
  for (const Span& paper : strip.paper)
    // So few that passing near them all is not worth one that is cut.
    for (int i = 0; i < 2; ++i) {
      const double low = paper.low + random.unit() * (paper.high - paper.low);
      strip.marks.push_back({low, std::min(low + random.unit() * 25, paper.high)});
    }
  return strip;
}

TEST(CutStrip, TakesAsFewSheetsAndCutsAsFewMarksAsAnyWay) {
  Random random(5);
  int n_with_seams = 0;
  for (int round = 0; round < 100; ++round) {
    SCOPED_TRACE(round);
    const StripToCut strip = random_strip(random);
    const CutStrip cut = cut_strip(strip, kWindow, kOverlap);
    EXPECT_EQ(cost_of(cut.shares.size(), cut.n_cut_marks), EveryWay(strip).best());
    for (std::size_t i = 1; i < cut.shares.size(); ++i)
      n_with_seams += cut.shares[i].low == cut.shares[i - 1].high ? 1 : 0;
  }
  EXPECT_GT(n_with_seams, 20);
}

TEST(CutStrip, CoversAllPaperWithSheetsThatReachOverTheirSeams) {
  Random random(6);
  for (int round = 0; round < 200; ++round) {
    const StripToCut strip = random_strip(random);
    const std::vector<Span> shares = cut_strip(strip, kWindow, kOverlap).shares;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const bool joins_low = i > 0 && shares[i - 1].high == shares[i].low;
      const bool joins_high = i + 1 < shares.size() && shares[i + 1].low == shares[i].high;
      const double shown =
          shares[i].high - shares[i].low + (joins_low ? kOverlap / 2 : 0) + (joins_high ? kOverlap / 2 : 0);
      EXPECT_LE(shown, kWindow + 1e-6);
      if (i > 0) {
        EXPECT_GE(shares[i].low, shares[i - 1].high);
      }
    }
    for (const Span& paper : strip.paper) {
      double reached = paper.low;
      for (const Span& share : shares)
        if (share.low <= reached && share.high > reached) reached = share.high;
      EXPECT_GE(reached, paper.high - 1e-9);
    }
  }
}

TEST(CutStrip, KeepsWholeWhatFitsAWindow) {
  const StripToCut strip{{{3, 3 + kWindow}}, {{10, 40}}};
  const CutStrip cut = cut_strip(strip, kWindow, kOverlap);
  ASSERT_EQ(cut.shares.size(), 1U);
  EXPECT_EQ(cut.shares[0].low, 3);
  EXPECT_EQ(cut.shares[0].high, 3 + kWindow);
  EXPECT_EQ(cut.n_cut_marks, 0);
}

TEST(CutStrip, NeedsNoSheetsWithoutPaper) { EXPECT_TRUE(cut_strip({}, kWindow, kOverlap).shares.empty()); }

TEST(CutStrip, CoversLongStripsOfPaperInTheSmallestWindows) {
  const StripToCut strip{{{0, 2000}}, {}};
  EXPECT_EQ(cut_strip(strip, 30, kOverlap).shares.size(), 100U);
}

TEST(MergeSpans, JoinsWhatTouchesOrNearlyDoes) {
  const std::vector<Span> merged = merge_spans({{40, 50}, {0, 10}, {5, 20}, {24, 30}}, 5);
  ASSERT_EQ(merged.size(), 2U);
  EXPECT_EQ(merged[0].low, 0);
  EXPECT_EQ(merged[0].high, 30);
  EXPECT_EQ(merged[1].low, 40);
}

}  // namespace
}  // namespace netwright
