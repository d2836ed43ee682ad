// The chain tree -> net -> overlaps -> pages -> sheets. Each link compares what it depends on with the
// Derived before and takes that one's result over when nothing changed.
#include "core/project/derived.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/predicates.h"
#include "core/sheet/instructions.h"
#include "core/sheet/labels.h"
#include "core/unfold/flat_net.h"
#include "core/unfold/verify.h"

namespace netwright {

namespace {

std::shared_ptr<const ShownNet> derive_net(const Project& project, const Derived* before,
                                           std::uint64_t version) {
  if (!project.tree) return nullptr;
  const bool is_by_hand = !project.edits.are_free();
  bool is_proved = project.run && project.run->is_proved;
  if (before && before->shown && before->source.dual == project.dual && before->source.tree == project.tree &&
      (is_by_hand || before->shown->is_proved == is_proved))
    return before->shown;
  Net net = layout(project.dual, *project.tree);
  std::vector<Overlap> overlaps = find_overlaps(net, kShownDepth);
  // A run proves its own net; what was changed by hand is proved here.
  if (is_by_hand && !is_proved && overlaps.empty()) {
    const int n_components = static_cast<int>(project.dual->mesh().n_components());
    is_proved = net.n_pieces == n_components && verify(to_flat_net(net, 1), n_components).is_net;
  }
  ShownNet shown = make_shown_net(std::move(net), std::move(overlaps), is_proved);
  shown.version = version;
  return std::make_shared<const ShownNet>(std::move(shown));
}

/// Pieces that somebody cut on purpose are printed, too, when none of them overlaps itself.
bool is_sound(const Project& project, const ShownNet& shown) {
  if (shown.is_proved) return true;
  const bool is_cut_up = !project.edits.must_cut.empty() && shown.overlaps.empty() &&
                         shown.net.n_pieces > static_cast<int>(project.dual->mesh().n_components());
  return is_cut_up && verify(to_flat_net(shown.net, 1), shown.net.n_pieces).is_net;
}

PageLayout pages_of(const Project& project, const Net& net) {
  if (!project.placed.is_automatic())
    if (std::optional<PageLayout> layout = lay_out(net, project.paper, project.placed, project.tabs))
      return *layout;
  return arrange(net, project.paper, project.size, project.tabs);
}

/// Sheets to look at: as many pixels as a screen shows, fewer where there are many sheets. What is printed
/// is drawn anew.
SheetSettings for_the_screen(SheetSettings settings, const PageLayout& layout) {
  constexpr double kScreenDpi = 110;
  constexpr double kMostPixels = 40e6;
  constexpr double kMmPerInch = 25.4;
  const double paper =
      static_cast<double>(layout.pages.size()) * layout.frame.width_mm * layout.frame.height_mm;
  const double dpi = std::min(kScreenDpi, kMmPerInch * std::sqrt(kMostPixels / std::max(paper, 1.0)));
  settings.pictures.dpi = std::min(settings.pictures.dpi, static_cast<int>(dpi));
  return settings;
}

void derive_pages(Derived& derived) {
  const Project& project = derived.source;
  const Net& net = derived.shown->net;
  derived.pages = std::make_shared<const PageLayout>(pages_of(project, net));
  derived.judged = std::make_shared<const Buildability>(judge(net, *derived.pages));
  if (!project.placed.is_automatic()) derived.misplaced = find_misplaced(net, *derived.pages);
}

void derive_sheets(Derived& derived, const Derived* before) {
  const Project& project = derived.source;
  const bool has_same_pages = before && before->source.run == project.run && before->shown == derived.shown &&
                              before->source.paper == project.paper && before->source.size == project.size &&
                              before->source.placed == project.placed && before->source.tabs == project.tabs;
  if (has_same_pages) {
    derived.pages = before->pages;
    derived.judged = before->judged;
    derived.misplaced = before->misplaced;
    derived.fault = before->fault;
    if (before->source.sheet == project.sheet) {
      derived.sheets = before->sheets;
      derived.unnumbered = before->unnumbered;
      derived.instructions = before->instructions;
    }
  }
  const bool wants_instructions = project.exports.instructions != InstructionPage::None;
  if (!wants_instructions) derived.instructions = nullptr;
  if (derived.sheets && (derived.instructions || !wants_instructions)) return;
  try {
    if (!derived.pages) derive_pages(derived);
    derived.fault.clear();
    if (!derived.is_sound || !derived.misplaced.is_nothing()) return;
    const SheetInfo info = sheet_info(project, derived.is_sound);
    const SheetSettings settings = for_the_screen(project.sheet, *derived.pages);
    const Net& net = derived.shown->net;
    if (!derived.sheets) {
      derived.sheets =
          std::make_shared<const std::vector<Sheet>>(draw_sheets(net, *derived.pages, info, settings));
      derived.unnumbered =
          std::make_shared<const std::vector<EdgeId>>(place_labels(net, *derived.pages, settings).left_out);
    }
    if (wants_instructions)
      derived.instructions =
          std::make_shared<const Sheet>(instruction_sheet(net, *derived.pages, info, settings));
  } catch (const Error& error) {
    derived.pages = nullptr;
    derived.fault = error.what();
  }
}

}  // namespace

std::shared_ptr<const Derived> derive(const Project& project, const std::shared_ptr<const Derived>& before,
                                      std::uint64_t version, Progress& progress, const NetHook& on_net) {
  auto derived = std::make_shared<Derived>();
  derived->source = project;
  if (progress.is_cancelled()) return derived;
  derived->shown = derive_net(project, before.get(), version);
  if (progress.is_cancelled()) return derived;
  if (on_net && derived->shown) on_net(derived->shown);
  const bool is_same = before && before->shown == derived->shown;
  if (derived->shown) derived->is_sound = is_same ? before->is_sound : is_sound(project, *derived->shown);
  const bool has_pages = derived->shown && (derived->shown->is_proved || !project.edits.are_free());
  if (has_pages) derive_sheets(*derived, before.get());
  return derived;
}

SheetInfo sheet_info(const Project& project, bool is_sound) {
  SheetInfo info;
  info.title = project.sheet.words.title;
  info.is_proved = is_sound || (project.run && project.run->is_proved);
  if (project.run) info.seed = project.run->seed;
  return info;
}

}  // namespace netwright
