// All renderers of the editor, made once the window's context is current and destroyed before it goes.
#pragma once

#include "render/background.h"
#include "render/line_renderer.h"
#include "render/mesh_renderer.h"
#include "render/net_renderer.h"
#include "render/overlay_renderer.h"
#include "render/sheet_renderer.h"
#include "render/tree_renderer.h"
#include "render/viewport.h"

namespace netwright {

struct Renderers {
  Background background;
  LineRenderer lines;
  MeshRenderer mesh{lines};
  NetRenderer net{lines};
  SheetRenderer sheets{lines};
  TreeRenderer tree{lines};
  OverlayRenderer overlay{lines};
  Viewport model_picture;
  Viewport net_picture;
};

}  // namespace netwright
