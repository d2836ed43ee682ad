// For scripts that drive the real window with mouse and keys: a file that says where everything is on screen.
// It reports what was drawn and never steers.
#pragma once

#include <filesystem>
#include <string>

#include "core/project/session.h"
#include "ui/workspace.h"

namespace netwright {

/// One line for each thing, words set apart by tabs, places in pixels of the window, numbers of faces, edges
/// and steps from 1 on as people count:
///   title TEXT
///   step POSITION COUNT             of the history, both 0 where nothing was changed
///   laying-out yes|no               pages are on their way, and what is drawn may move
///   widget NAME X Y WIDTH HEIGHT on|off
///   hovered-face N, hovered-edge N  what the pointer means
///   model-face N X Y, net-face N X Y
///   model-edge N X Y KIND PIN FACE OTHER, net-edge N X Y KIND PIN FACE OTHER
/// KIND is fold, cut or border; PIN is none, fold or cut; the faces are those at its sides, the one that was
/// pointed at first (OTHER is 0 at a border). A face or an edge is told where the pointer would mean it, and
/// only if it is seen whole enough for that; a cut has two places in the net.
std::string told_of(const Session& session, const UiState& ui, const Workspace& workspace,
                    const std::string& title);

/// Writes that into a file whenever it has changed; the file always holds one whole frame.
class Teller {
 public:
  /// Throws Error(Write) when the file cannot be written.
  explicit Teller(std::filesystem::path file);
  void tell(const std::string& text);

 private:
  std::filesystem::path file_;
  std::string told_;
};

}  // namespace netwright
