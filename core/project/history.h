// Undo and redo as a list of labelled Projects. Cheap, because Projects share their big parts.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "core/project/project.h"

namespace netwright {

class History {
 public:
  explicit History(Project first = {}) : entries_{{"", std::move(first)}} {}

  [[nodiscard]] const Project& present() const { return entries_[present_].project; }

  /// One undo step: `label` names the edit that led to `next` ("pin root"). What could be redone is gone.
  void push(std::string label, Project next);

  /// Changes the present without an undo step; what could be redone stays.
  void amend(Project project) { entries_[present_].project = std::move(project); }

  [[nodiscard]] bool can_undo() const { return present_ > 0; }
  [[nodiscard]] bool can_redo() const { return present_ + 1 < entries_.size(); }
  /// The edit's name; empty when there is none.
  [[nodiscard]] std::string undo_label() const { return entries_[present_].label; }
  [[nodiscard]] std::string redo_label() const { return can_redo() ? entries_[present_ + 1].label : ""; }
  /// All states there are, the first without a label, and which of them is the present one.
  [[nodiscard]] std::size_t size() const { return entries_.size(); }
  [[nodiscard]] std::size_t position() const { return present_; }
  [[nodiscard]] const std::string& label(std::size_t position) const { return entries_[position].label; }
  /// The state itself.
  [[nodiscard]] const Project& at(std::size_t position) const { return entries_[position].project; }
  /// Does any state have this mesh?
  [[nodiscard]] bool holds(const std::shared_ptr<const DualGraph>& dual) const;
  void go_to(std::size_t position) { present_ = std::min(position, entries_.size() - 1); }
  /// Both do nothing when there is nothing to do.
  void undo() { present_ -= can_undo() ? 1 : 0; }
  void redo() { present_ += can_redo() ? 1 : 0; }

 private:
  struct Entry {
    std::string label;
    Project project;
  };
  std::vector<Entry> entries_;  ///< never empty; the first has no label
  std::size_t present_ = 0;
};

}  // namespace netwright
