// What lies behind everything: a slight gradient for the model, an even desk for the net.
#pragma once

#include "render/gl_objects.h"
#include "render/palette.h"
#include "render/shader.h"

namespace netwright {

class Background {
 public:
  Background();
  /// Clears colour and depth and draws the gradient of the model's view.
  void draw_gradient(const Palette& palette) const;
  /// Clears to the desk of the net's view.
  static void clear_desk(const Palette& palette);

 private:
  Shader shader_;
  VertexArray array_;
};

}  // namespace netwright
