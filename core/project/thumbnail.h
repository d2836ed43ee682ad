// A small picture of a model, drawn without any graphics card, so that command line and worker can make one.
#pragma once

#include "core/base/image.h"
#include "core/mesh/dual_graph.h"

namespace netwright {

/// The model in its colours and textures, seen from a corner above, on a clear background; `side` pixels
/// square. Takes some milliseconds.
Image draw_thumbnail(const DualGraph& dual, int side);

}  // namespace netwright
