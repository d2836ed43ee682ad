// Dynamic programming from low to high: a sheet begins at a seam or where paper begins after a gap, and ends
// at a seam or where paper ends.
#include "core/sheet/cut_strip.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace netwright {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kStep_mm = 0.5;
constexpr double kNear_mm = 2;
/// A mark that a seam passes within kNear_mm counts so much of one that it cuts.
constexpr double kNearCost = 0.05;

/// Where a sheet begins: at the seam of a step, or where a stretch of paper does.
struct Begin {
  bool is_seam = false;
  std::size_t at = 0;  ///< step or stretch
};

/// The least cost of having covered everything up to some place, and where its last sheet begins.
struct Way {
  double cost = kNever;
  Begin last;

  void improve(double other, Begin begin) {
    if (other < cost) *this = {other, begin};
  }
};

class StripCutter {
 public:
  StripCutter(const StripToCut& strip, double window, double overlap)
      : paper_(strip.paper),
        window_(window),
        overlap_(overlap),
        least_share_(std::min(overlap, (window - overlap) / 2)),
        origin_(paper_.front().low),
        n_steps_(static_cast<std::size_t>(std::ceil((paper_.back().high - origin_) / kStep_mm)) + 1),
        costs_(seam_costs(strip.marks)),
        to_seam_(n_steps_),
        to_end_(paper_.size() + 1) {}

  /// The shares from low to high.
  std::vector<Span> cut() {
    to_end_[0].cost = 0;
    for (std::size_t i = 0; i < paper_.size(); ++i) {
      reach_seams(i);
      reach_end(i);
    }
    std::vector<Span> shares;
    double high = paper_.back().high;
    for (Begin begin = to_end_.back().last;;) {
      const double low = begin.is_seam ? at(begin.at) : paper_[begin.at].low;
      shares.push_back({low, high});
      if (!begin.is_seam && begin.at == 0) break;
      high = begin.is_seam ? low : paper_[begin.at - 1].high;
      begin = begin.is_seam ? to_seam_[begin.at].last : to_end_[begin.at].last;
    }
    std::reverse(shares.begin(), shares.end());
    return shares;
  }

 private:
  [[nodiscard]] double at(std::size_t step) const { return origin_ + static_cast<double>(step) * kStep_mm; }

  /// The first step at or after a place, and the last one at or before it; both may lie beyond the strip.
  [[nodiscard]] std::ptrdiff_t step_after(double place) const {
    return static_cast<std::ptrdiff_t>(std::ceil((place - origin_) / kStep_mm));
  }
  [[nodiscard]] std::ptrdiff_t step_before(double place) const {
    return static_cast<std::ptrdiff_t>(std::floor((place - origin_) / kStep_mm));
  }

  /// What a seam at every step cuts.
  [[nodiscard]] std::vector<double> seam_costs(const std::vector<Span>& marks) const {
    std::vector<double> change(n_steps_ + 1, 0);
    const auto add = [&](double low, double high, double cost) {
      const std::ptrdiff_t first = std::max<std::ptrdiff_t>(step_before(low) + 1, 0);
      const std::ptrdiff_t end = std::min(step_after(high), static_cast<std::ptrdiff_t>(n_steps_));
      if (first >= end) return;
      change[static_cast<std::size_t>(first)] += cost;
      change[static_cast<std::size_t>(end)] -= cost;
    };
    for (const Span& mark : marks) {
      add(mark.low, mark.high, 1);
      add(mark.low - kNear_mm, mark.high + kNear_mm, kNearCost);
    }
    double sum = 0;
    for (double& value : change) value = sum += value;
    return change;
  }

  /// Seams inside a stretch of paper. A queue holds the seams before that may still be the best to begin at.
  void reach_seams(std::size_t stretch) {
    const auto least = static_cast<std::size_t>(std::ceil(least_share_ / kStep_mm));
    const auto most = static_cast<std::size_t>(std::floor((window_ - overlap_) / kStep_mm));
    const std::ptrdiff_t first =
        std::max<std::ptrdiff_t>(step_after(paper_[stretch].low + least_share_ / 2), 0);
    const std::ptrdiff_t last = std::min(step_before(paper_[stretch].high - least_share_ / 2),
                                         static_cast<std::ptrdiff_t>(n_steps_) - 1);
    for (std::ptrdiff_t i = first; i <= last; ++i) {
      const auto step = static_cast<std::size_t>(i);
      for (; n_queued_ + least <= step; ++n_queued_) {
        while (queue_.size() > head_ && to_seam_[queue_.back()].cost >= to_seam_[n_queued_].cost)
          queue_.pop_back();
        queue_.push_back(n_queued_);
      }
      while (head_ < queue_.size() && queue_[head_] + most < step) ++head_;
      Way& way = to_seam_[step];
      if (head_ < queue_.size()) way.improve(to_seam_[queue_[head_]].cost, {true, queue_[head_]});
      begin_at_paper(way, stretch, at(step), {least_share_, window_ - overlap_ / 2});
      way.cost += kMarksPerSheet + costs_[step];
    }
  }

  void reach_end(std::size_t stretch) {
    Way& way = to_end_[stretch + 1];
    const double end = paper_[stretch].high;
    const std::ptrdiff_t last =
        std::min(step_before(end - least_share_), static_cast<std::ptrdiff_t>(n_steps_) - 1);
    for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(step_after(end - (window_ - overlap_ / 2)), 0);
         i <= last; ++i)
      way.improve(to_seam_[static_cast<std::size_t>(i)].cost, {true, static_cast<std::size_t>(i)});
    begin_at_paper(way, stretch, end, {0, window_});
    way.cost += kMarksPerSheet;
  }

  /// Sheets that begin where this stretch does, or one before it, and are so long when they reach to `end`.
  void begin_at_paper(Way& way, std::size_t stretch, double end, Span length) const {
    for (std::size_t j = stretch + 1; j-- > 0;) {
      const double here = end - paper_[j].low;
      // A sheet that is as wide as the window is not too wide for the rounding of its corners.
      if (here > length.high * (1 + 1e-9)) break;
      if (here >= length.low) way.improve(to_end_[j].cost, {false, j});
    }
  }

  const std::vector<Span>& paper_;
  double window_;
  double overlap_;
  double least_share_;  ///< between two seams; less would be all overlap
  double origin_;
  std::size_t n_steps_;
  std::vector<double> costs_;
  std::vector<Way> to_seam_;  ///< of each step
  std::vector<Way> to_end_;   ///< of the stretches before
  std::vector<std::size_t> queue_;
  std::size_t head_ = 0;
  std::size_t n_queued_ = 0;
};

}  // namespace

std::vector<Span> merge_spans(std::vector<Span> spans, double gap) {
  std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.low < b.low; });
  std::vector<Span> merged;
  for (const Span& span : spans)
    if (!merged.empty() && span.low <= merged.back().high + gap)
      merged.back().high = std::max(merged.back().high, span.high);
    else
      merged.push_back(span);
  return merged;
}

CutStrip cut_strip(const StripToCut& strip, double window, double overlap) {
  CutStrip result;
  if (strip.paper.empty()) return result;
  result.shares = StripCutter(strip, window, overlap).cut();
  for (std::size_t i = 1; i < result.shares.size(); ++i) {
    const double seam = result.shares[i].low;
    if (result.shares[i - 1].high != seam) continue;
    for (const Span& mark : strip.marks) result.n_cut_marks += mark.low < seam && seam < mark.high ? 1 : 0;
  }
  return result;
}

}  // namespace netwright
