// The small pictures of finished runs as textures, made when a picture is drawn first. Owned by the
// workspace, since textures need the window's context, also when they go.
#pragma once

#include <imgui.h>

#include <map>
#include <memory>

#include "core/project/run_list.h"
#include "render/gl_objects.h"

namespace netwright {

class RunPictures {
 public:
  /// The picture's texture, white on clear; its first row is at v = 1.
  ImTextureID of(const RunList::Entry& run);
  /// Forgets the pictures of runs that are gone.
  void tidy();

 private:
  struct Kept {
    std::weak_ptr<const FinishedRun> run;
    Texture texture;
  };
  std::map<const FinishedRun*, Kept> kept_;
};

}  // namespace netwright
