// All that follows from a Project: net, overlaps, kinds of edges, pages and sheets, worked out in one place
// and one order, and again only where something it depends on has changed.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/project/project.h"
#include "core/project/shown_net.h"
#include "core/sheet/buildability.h"
#include "core/sheet/pages.h"
#include "core/sheet/sheet.h"

namespace netwright {

struct Derived {
  Project source;                         ///< what it was made from
  std::shared_ptr<const ShownNet> shown;  ///< null without a tree
  /// The net is proved, or it was cut by hand into pieces each of which is proved.
  bool is_sound = false;
  /// Null unless the net is proved or edited by hand.
  std::shared_ptr<const PageLayout> pages;
  Misplaced misplaced;  ///< on these pages, where pieces were put by hand
  /// Null unless the net is sound and nothing is misplaced.
  std::shared_ptr<const std::vector<Sheet>> sheets;
  /// Cuts whose numbers find no room on the sheets; null without those.
  std::shared_ptr<const std::vector<EdgeId>> unnumbered;
  std::shared_ptr<const Sheet> instructions;   ///< null unless there are sheets and the exports want it
  std::shared_ptr<const Buildability> judged;  ///< null without pages
  std::string fault;  ///< why there are no sheets (margins that leave no room …), one sentence; else empty
};

/// Called with the net as soon as it is made, before its pages are.
using NetHook = std::function<void(std::shared_ptr<const ShownNet>)>;

/// `before` may be null; parts of it whose sources are unchanged are shared; a net that is made anew gets
/// `version`. Stops early with what there is
/// when `progress` is cancelled. Takes milliseconds for hundreds of faces: a chore for the worker.
std::shared_ptr<const Derived> derive(const Project& project, const std::shared_ptr<const Derived>& before,
                                      std::uint64_t version, Progress& progress, const NetHook& on_net = {});

/// What the title block of a project's sheets says; `is_sound` as in Derived.
SheetInfo sheet_info(const Project& project, bool is_sound);

}  // namespace netwright
