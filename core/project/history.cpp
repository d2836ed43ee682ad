// The one operation of the history that does more than move the present. Steps are kept without a limit: one
// costs some hundred bytes, trees included only when a run was accepted.
#include "core/project/history.h"

namespace netwright {

void History::push(std::string label, Project next) {
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(present_) + 1, entries_.end());
  entries_.push_back({std::move(label), std::move(next)});
  ++present_;
}

bool History::holds(const std::shared_ptr<const DualGraph>& dual) const {
  return std::any_of(entries_.begin(), entries_.end(),
                     [&](const Entry& entry) { return entry.project.dual == dual; });
}

}  // namespace netwright
