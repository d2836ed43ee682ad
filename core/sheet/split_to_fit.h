// A net that is larger than the paper, cut into the fewest pieces that each fit on a page.
#pragma once

#include "core/base/paper.h"
#include "core/sheet/print_size.h"
#include "core/unfold/glue_tabs.h"
#include "core/unfold/hand_edits.h"
#include "core/unfold/net.h"

namespace netwright {

/// Which folds to cut so that every piece fits a page of this paper by itself, tabs and all, at the net's
/// size: as few as it takes, and among those short ones. Folds that `may_cut` says no to stay. Nothing is cut
/// where everything fits, as it does when the size depends on the paper. Without tabs and with few choices
/// (as in nets of some dozen faces) no split has fewer pieces. Throws Error(Usage) as arrange() does, and
/// when a face or what may not be cut is larger than the paper.
HandEdit split_to_fit(const Net& net, const PaperSetup& paper, const PrintSize& size, const TabSettings& tabs,
                      const MayCut& may_cut);

}  // namespace netwright
