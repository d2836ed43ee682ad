// Editing by hand in the session: the shown tree is changed as the user says, checked by the same chore that
// derives everything else.
#include "core/base/predicates.h"
#include "core/project/commands.h"
#include "core/project/session_impl.h"

namespace netwright {

void Session::edit_by_hand(const HandEdit& edit, const std::string& label) {
  if (!has_model() || edit.tree.n_faces() != project().dual->mesh().n_faces()) return;
  impl_->end_replay();
  impl_->discard_run();
  const std::shared_ptr<const ShownNet> next = preview(edit);
  impl_->is_unfinished = false;
  impl_->last_figures.reset();
  impl_->settled = impl_->stamp(std::make_shared<ShownNet>(*next));
  impl_->edit(label, netwright::edit_by_hand(project(), edit));
}

std::shared_ptr<const ShownNet> Session::preview(const HandEdit& edit) const {
  Net net = layout(project().dual, edit.tree);
  std::vector<Overlap> overlaps = find_overlaps(net, kShownDepth);
  return std::make_shared<const ShownNet>(make_shown_net(std::move(net), std::move(overlaps), false));
}

bool Session::may_cut(EdgeId edge) const {
  return pin_of(project().pins, edge) != EdgePin::MustFold &&
         pin_of(project().edits, edge) != EdgePin::MustFold;
}

}  // namespace netwright
