// The session's pages: how the pieces lie on them, by themselves or as the user put them.
#include "core/project/commands.h"
#include "core/project/session_impl.h"

namespace netwright {

std::shared_ptr<const PageLayout> Session::pages() const {
  const bool has_result = !impl_->run && !impl_->is_unfinished && impl_->derived;
  return has_result && impl_->derived->shown == shown() ? impl_->derived->pages : nullptr;
}

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

void Session::set_exports(const ExportSettings& exports, const std::string& label) {
  if (exports != project().exports) impl_->edit(label, netwright::set_exports(project(), exports));
}

void Session::rearrange_pieces() { place_pieces({}, "re-arrange all"); }

}  // namespace netwright
