// The gradient is one triangle with a tone per corner: no full-screen shading beyond an interpolation.
#include "render/background.h"

#include "render/gl.h"

namespace netwright {

Background::Background() : shader_("background") {}

void Background::draw_gradient(const Palette& palette) const {
  glDisable(GL_SCISSOR_TEST);
  glDepthMask(GL_TRUE);
  glClearDepth(1);
  glClear(GL_DEPTH_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  shader_.use();
  shader_.set("top", palette.background_top);
  shader_.set("bottom", palette.background_bottom);
  glBindVertexArray(array_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Background::clear_desk(const Palette& palette) {
  glDisable(GL_SCISSOR_TEST);
  glClearColor(palette.desk.r, palette.desk.g, palette.desk.b, 1);
  glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace netwright
