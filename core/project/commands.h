// Every edit as a function from Project to Project. None of them changes what it was given, so a list of
// Projects is the whole history.
#pragma once

#include "core/project/project.h"
#include "core/unfold/hand_edits.h"

namespace netwright {

/// A fresh project of this model. What belongs to the user's desk and not to the model, the paper, stays.
Project new_project(const Project& before, std::filesystem::path path, std::shared_ptr<const DualGraph> dual);

/// The same file made into another mesh by another recipe. The net of the old mesh goes; pins are carried
/// over to the nearest faces and edges, as far as these can be found (see carry_pins.h). Where only another
/// axis is up the faces are the same ones, and net and root stay.
Project remake(Project project, const Recipe& recipe, std::shared_ptr<const MadeModel> made);

/// Layout and tree start at `face`, and runs keep it; an invalid face removes the pin. An accepted tree is
/// rerooted: it stays the same net.
Project pin_root(Project project, FaceId face);

/// Other pins. The accepted tree stays, rerooted to a pinned root, whether it keeps the pins or not: it is
/// for the next run to keep them.
Project set_pins(Project project, const Constraints& pins);

/// Makes a proved tree the project's own.
Project accept_tree(Project project, UnfoldTree tree, const RunSummary& run);

/// A tree changed by hand. Whether it is a net has to be proved again.
Project edit_by_hand(Project project, const HandEdit& edit);

/// What is pinned and what was edited by hand, together: where both speak of an edge, the hand came later.
Constraints pins_with_edits(const Project& project);

Project set_seed(Project project, std::uint64_t seed);
Project set_paper(Project project, const PaperSetup& paper);
Project set_size(Project project, const PrintSize& size);
Project set_tabs(Project project, const TabSettings& tabs);
Project set_sheet(Project project, const SheetSettings& sheet);
Project set_glued(Project project, std::vector<EdgeId> glued);
Project set_exports(Project project, const ExportSettings& exports);

/// The pieces lie where the user wants them; an empty layout arranges them by themselves again. They stay so
/// while the tree is edited by hand, and are arranged anew for another tree, other paper, and another size at
/// which they would not fit as they lie.
Project place_pieces(Project project, const HandLayout& placed);

}  // namespace netwright
