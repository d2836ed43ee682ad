// The session's pages: how the pieces lie on them, by themselves or as the user put them.
#include "core/base/error.h"
#include "core/base/predicates.h"
#include "core/project/commands.h"
#include "core/project/session_impl.h"
#include "core/sheet/split_to_fit.h"

namespace netwright {

std::shared_ptr<const PageLayout> Session::pages() const {
  const bool has_result = !impl_->run && !impl_->is_unfinished && impl_->derived;
  return has_result && impl_->derived->shown == shown() ? impl_->derived->pages : nullptr;
}

bool Session::is_laying_out() const { return impl_->deriving != nullptr; }

const Misplaced* Session::misplaced() const {
  return pages() && !impl_->derived->misplaced.is_nothing() ? &impl_->derived->misplaced : nullptr;
}

void Session::place_pieces(const HandLayout& placed, const std::string& label) {
  if (pages() && placed != project().placed) impl_->edit(label, netwright::place_pieces(project(), placed));
}

void Session::set_tabs(const TabSettings& tabs, const std::string& label) {
  if (tabs != project().tabs) impl_->edit(label, netwright::set_tabs(project(), tabs));
}

void Session::set_sheet(const SheetSettings& sheet, const std::string& label) {
  if (sheet != project().sheet) impl_->edit(label, netwright::set_sheet(project(), sheet));
}

void Session::set_glued(std::vector<EdgeId> glued, const std::string& label) {
  Project next = netwright::set_glued(project(), std::move(glued));
  if (next.glued != project().glued) impl_->edit(label, std::move(next));
}

std::shared_ptr<const Buildability> Session::buildability() const {
  return pages() ? impl_->derived->judged : nullptr;
}

void Session::set_exports(const ExportSettings& exports, const std::string& label) {
  if (exports != project().exports) impl_->edit(label, netwright::set_exports(project(), exports));
}

void Session::split_to_fit() {
  if (impl_->run || impl_->is_unfinished || !project().tree || impl_->splitting) return;
  auto chore = std::make_shared<Impl::Chore<Impl::Split>>(impl_->bell);
  chore->progress =
      impl_->worker.submit(Worker::Lane::Chores, [chore, source = project()](Progress& progress) {
        progress.set_phase("Splitting the net");
        auto split = std::make_shared<Impl::Split>();
        split->of = source.tree;
        const Constraints pins = pins_with_edits(source);
        const auto may_cut = [&](EdgeId e) { return pin_of(pins, e) != EdgePin::MustFold; };
        try {
          split->edit = netwright::split_to_fit(layout(source.dual, *source.tree), source.paper, source.size,
                                                source.tabs, may_cut);
          Net net = layout(source.dual, split->edit.tree);
          std::vector<Overlap> overlaps = find_overlaps(net, kShownDepth);
          split->shown =
              std::make_shared<const ShownNet>(make_shown_net(std::move(net), std::move(overlaps), false));
        } catch (const Error& error) {
          split->fault = error.what();
        }
        chore->result.post(std::move(split));
      });
  impl_->splitting = std::move(chore);
}

void Session::rearrange_pieces() { place_pieces({}, "re-arrange all"); }

}  // namespace netwright
