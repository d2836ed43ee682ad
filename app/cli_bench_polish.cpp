// Collects figures of nets and their medians.
#include "app/cli_bench_polish.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace netwright {

namespace {

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

double median_of(const std::vector<PolishFigures>& nets, double PolishFigures::*figure) {
  std::vector<double> values;
  for (const PolishFigures& net : nets) values.push_back(net.*figure);
  return median(std::move(values));
}

/// In percent, of nets that have such a length at all.
double median_change(const std::vector<PolishFigures>& before, const std::vector<PolishFigures>& after,
                     double PolishFigures::*length) {
  std::vector<double> values;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (before[i].*length > 0) values.push_back(100 * (after[i].*length / (before[i].*length) - 1));
  return values.empty() ? 0 : median(std::move(values));
}

}  // namespace

PolishAim bench_polish(const Mesh& mesh, double effort) {
  const double scale = mesh.height() > 0 ? kBenchHeight / mesh.height() : 1;
  return {{.effort = effort}, [scale](const Net&) { return scale; }, {}, {}};
}

void PolishTable::add(const std::string& folder, const SolveResult& result) {
  if (!result.polished || !result.is_proved) return;
  auto at = std::ranges::find(folders_, folder, &Folder::name);
  if (at == folders_.end()) {
    Folder fresh;
    fresh.name = folder;
    at = folders_.insert(folders_.end(), std::move(fresh));
  }
  at->before.push_back(polish_figures(layout(result.net.dual, result.polished->first)));
  at->after.push_back(polish_figures(result.net));
  at->necks_before += result.polished->necks_before;
  at->necks_after += result.polished->necks_after;
  at->cpu_seconds += result.finish_seconds;
}

std::string PolishTable::text() const {
  if (folders_.empty()) return {};
  std::string text =
      "Polish (medians; necks under 3 mm on models 200 mm high, all together)\n"
      "nets   cuts     outline  hull filled     rectangle filled  necks           CPU time  "
      "folder\n";
  for (const Folder& folder : folders_) {
    const auto percent = [&](const std::vector<PolishFigures>& nets, double PolishFigures::*figure) {
      return 100 * median_of(nets, figure);
    };
    std::array<char, 320> line{};
    std::snprintf(
        line.data(), line.size(),
        "%-6zu %+5.1f %%  %+5.1f %%  %3.0f %% → %3.0f %%   %3.0f %% → %3.0f %%     %5d → %-5d   %.2f s  ",
        folder.before.size(), median_change(folder.before, folder.after, &PolishFigures::cut_length),
        median_change(folder.before, folder.after, &PolishFigures::outline),
        percent(folder.before, &PolishFigures::hull_fill), percent(folder.after, &PolishFigures::hull_fill),
        percent(folder.before, &PolishFigures::box_fill), percent(folder.after, &PolishFigures::box_fill),
        folder.necks_before, folder.necks_after,
        folder.cpu_seconds / static_cast<double>(folder.before.size()));
    text += line.data() + folder.name + "\n";
  }
  text.pop_back();
  return text;
}

}  // namespace netwright
