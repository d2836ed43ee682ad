// Keeping the list short: what goes first is the oldest run that is not the best of its mesh.
#include "core/project/run_list.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace netwright {

int FinishedRun::score() const { return static_cast<int>(std::lround(measures.fill * 100)); }

bool is_better(const FinishedRun& a, const FinishedRun& b) {
  const auto key = [](const FinishedRun& run) {
    return std::tuple(!run.summary.is_proved, run.summary.overlaps, run.measures.n_pieces,
                      -run.measures.fill);
  };
  return key(a) < key(b);
}

RunList::Entry RunList::add(FinishedRun run) {
  const auto is_same = [&](const Entry& other) {
    return other->dual == run.dual && other->summary.seed == run.summary.seed && *other->tree == *run.tree;
  };
  const auto twin = std::find_if(runs_.begin(), runs_.end(), is_same);
  if (twin != runs_.end()) {
    run.number = (*twin)->number;
    runs_.erase(twin);
  } else {
    run.number = ++n_numbers_;
  }
  runs_.push_back(std::make_shared<const FinishedRun>(std::move(run)));
  Entry added = runs_.back();
  if (runs_.size() > kMostRuns) drop_one();
  shed_logs();
  return added;
}

void RunList::erase(int number) {
  std::erase_if(runs_, [number](const Entry& run) { return run->number == number; });
}

void RunList::clear() {
  runs_.clear();
  n_numbers_ = 0;
}

RunList::Entry RunList::find(int number) const {
  const auto it =
      std::find_if(runs_.begin(), runs_.end(), [&](const Entry& r) { return r->number == number; });
  return it == runs_.end() ? nullptr : *it;
}

std::vector<RunList::Entry> RunList::of(const std::shared_ptr<const DualGraph>& dual) const {
  std::vector<Entry> found;
  std::copy_if(runs_.begin(), runs_.end(), std::back_inserter(found),
               [&](const Entry& run) { return run->dual == dual; });
  return found;
}

RunList::Entry RunList::best_of(const std::shared_ptr<const DualGraph>& dual) const {
  Entry best;
  for (const Entry& run : runs_)
    if (run->dual == dual && (!best || is_better(*run, *best))) best = run;
  return best;
}

void RunList::drop_one() {
  const auto is_best = [this](const Entry& run) { return best_of(run->dual) == run; };
  const auto victim = std::find_if_not(runs_.begin(), runs_.end() - 1, is_best);
  runs_.erase(victim == runs_.end() - 1 ? runs_.begin() : victim);
}

void RunList::shed_logs() {
  std::size_t bytes = 0;
  for (auto run = runs_.rbegin(); run != runs_.rend(); ++run) {
    if (!(*run)->log) continue;
    bytes += (*run)->log->bytes();
    if (bytes <= most_log_bytes_ || run == runs_.rbegin()) continue;
    FinishedRun without = **run;
    without.log = nullptr;
    *run = std::make_shared<const FinishedRun>(std::move(without));
  }
}

}  // namespace netwright
