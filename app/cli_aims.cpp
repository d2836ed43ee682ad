// Words and weights of aims, and the figures of a net before and after.
#include "app/cli_aims.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string_view>

#include "core/base/counted.h"
#include "core/base/polygon2.h"
#include "core/project/net_measures.h"

namespace netwright {

namespace {

constexpr double kMostWeight = 100;

struct Word {
  std::string_view name;
  double PolishSettings::*weight;
};
constexpr std::array<Word, 6> kWords{
    Word{"cuts", &PolishSettings::short_cuts},     Word{"compact", &PolishSettings::compact},
    Word{"necks", &PolishSettings::few_necks},     Word{"paper", &PolishSettings::fits_paper},
    Word{"root", &PolishSettings::root_in_middle}, Word{"hidden", &PolishSettings::hidden_cuts}};

struct Aim {
  double PolishSettings::*weight = nullptr;
  double value = 1;
};

std::optional<Aim> aim_in(std::string_view text) {
  const std::size_t equals = text.find('=');
  Aim aim;
  for (const Word& word : kWords)
    if (text.substr(0, equals) == word.name) aim.weight = word.weight;
  if (equals != std::string_view::npos) {
    const std::string_view number = text.substr(equals + 1);
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), aim.value);
    if (error != std::errc() || end != number.data() + number.size()) return std::nullopt;
  }
  const bool is_good = aim.weight != nullptr && aim.value >= 0 && aim.value <= kMostWeight;
  return is_good ? std::optional(aim) : std::nullopt;
}

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.0f %%", 100 * share);
  return text;
}

}  // namespace

std::string why_not_aim(const std::string& word) {
  if (aim_in(word)) return {};
  return "it must be cuts, compact, necks, paper, root or hidden, each with a weight from 0 to 100 if "
         "wanted, "
         "as in necks=2";
}

void apply_aims(const std::vector<std::string>& words, PolishSettings& settings) {
  for (const std::string& word : words)
    if (const auto aim = aim_in(word)) settings.*aim->weight = aim->value;
}

PolishFigures polish_figures(const Net& net) {
  const NetMeasures measures = measure(net);
  PolishFigures figures;
  figures.cut_length = measures.cut_length;
  figures.box_fill = measures.fill;
  double paper = 0;
  for (const FaceId f : net.mesh().faces()) paper += net.mesh().area(f);
  double hulls = 0;
  for (const std::vector<glm::dvec2>& hull : measures.hulls) hulls += std::abs(signed_area(hull));
  figures.hull_fill = hulls > 0 ? paper / hulls : 0;
  for (const EdgeId e : net.mesh().edges())
    if (net.mesh().is_border(e)) figures.outline += net.mesh().length(e);
  figures.outline += 2 * measures.cut_length;
  return figures;
}

std::string polish_line(const SolveResult& result, const PolishSettings& settings) {
  if (!result.polished) return {};
  const PolishReport& report = *result.polished;
  const PolishFigures before = polish_figures(layout(result.net.dual, report.first));
  const PolishFigures after = polish_figures(result.net);
  const double shorter = before.cut_length > 0 ? 1 - after.cut_length / before.cut_length : 0;
  const std::string change = std::abs(shorter) < 0.005
                                 ? "as long"
                                 : percent(std::abs(shorter)) + (shorter < 0 ? " longer" : " shorter");
  std::string line = "Polished: cuts " + change + " · hull " + percent(after.hull_fill) + " filled (" +
                     percent(before.hull_fill) + ") · " + counted(report.necks_after, "neck", "necks") +
                     " under 3 mm (" + grouped(report.necks_before) + ")";
  std::string unmet;
  for (const std::string& wish : unmet_wishes(report, settings)) unmet += (unmet.empty() ? "" : ", ") + wish;
  if (!unmet.empty()) line += "\nNot met: " + unmet + ".";
  return line;
}

Json polish_json(const SolveResult& result) {
  const PolishReport& report = *result.polished;
  Json json;
  const auto add = [&json](const char* name, const PolishFigures& figures, int necks, double size) {
    Json one;
    one.set("cut_length", figures.cut_length);
    one.set("outline", figures.outline);
    one.set("hull_fill", figures.hull_fill);
    one.set("box_fill", figures.box_fill);
    one.set("necks", necks);
    if (size > 0) one.set("size_for_page", size);
    json.set(name, std::move(one));
  };
  add("before", polish_figures(layout(result.net.dual, report.first)), report.necks_before,
      report.size_before);
  add("after", polish_figures(result.net), report.necks_after, report.size_after);
  return json;
}

}  // namespace netwright
