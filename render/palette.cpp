// The colours themselves. Fills that carry a meaning keep the face's shading visible: their alpha says how
// much of the paper shows through.
#include "render/palette.h"

namespace netwright {
namespace {

Palette meanings() {
  Palette p;
  p.tree = rgb(0x4169E1);
  p.root = rgb(0xFFA500, 0.88F);
  p.root_rim = rgb(0x3A2600);
  p.overlap = rgb(0xE5484D, 0.62F);
  p.overlap_hatch = rgb(0xA60F1C, 0.9F);
  p.selection = rgb(0x18A058);
  p.chosen = rgb(0xC026D3, 0.62F);
  p.climbed = rgb(0xE879F9, 0.28F);
  p.heat = {rgb(0xFBD38A, 0.9F), rgb(0xDD5A7F, 0.9F), rgb(0x5A1B73, 0.9F)};
  p.candidate = rgb(0xD61FD6);
  p.pinned_fold = rgb(0x0F9D6B);
  p.pinned_cut = rgb(0xE07A00);
  p.patch = rgb(0x7C3AED);
  p.measure = rgb(0x0B7A75);
  p.measure_rim = rgb(0xFFFFFF);
  return p;
}

Palette light() {
  Palette p = meanings();
  p.theme = Theme::Light;
  p.background_top = rgb(0xF0F2F5);
  p.background_bottom = rgb(0xD3D8E0);
  p.model = rgb(0xF6F4F0);
  p.model_back = rgb(0xC3CBDD);
  p.model_edge = rgb(0x6C717B);
  p.desk = rgb(0xC5CAD1);
  p.sheet = rgb(0xF7F8FA);
  p.sheet_border = rgb(0x9AA1AC);
  p.sheet_margin = rgb(0xB4BAC4);
  p.paper = rgb(0xFFFFFF);
  p.cut = rgb(0x191C21);
  p.cut_halo = rgb(0xFFFFFF, 0);
  p.mountain = rgb(0xB5392B);
  p.valley = rgb(0x1F78B4);
  p.flat = rgb(0x191C21, 0.13F);
  p.border = rgb(0x737A86);
  p.hover = rgb(0x5B8DEF, 0.38F);
  p.hover_edge = rgb(0x008DB0);
  return p;
}

Palette dark() {
  Palette p = meanings();
  p.theme = Theme::Dark;
  p.background_top = rgb(0x363A42);
  p.background_bottom = rgb(0x1D1F23);
  p.model = rgb(0xDADCE0);
  p.model_back = rgb(0x8790A6);
  p.model_edge = rgb(0x3F434B);
  p.desk = rgb(0x2A2D32);
  p.sheet = rgb(0x4A4E56);
  p.sheet_border = rgb(0x7B828E);
  p.sheet_margin = rgb(0x6A707B);
  p.paper = rgb(0xE2E4E8);
  p.cut = rgb(0x101216);
  p.cut_halo = rgb(0xA9B0BC);
  p.mountain = rgb(0xA93226);
  p.valley = rgb(0x1B6CA8);
  p.flat = rgb(0x101216, 0.16F);
  p.border = rgb(0x6B727E);
  p.hover = rgb(0x4C82F0, 0.42F);
  p.hover_edge = rgb(0x22BEE6);
  return p;
}

}  // namespace

const Palette& palette(Theme theme) {
  static const Palette kLight = light();
  static const Palette kDark = dark();
  return theme == Theme::Light ? kLight : kDark;
}

}  // namespace netwright
