// Every colour of the two views, for the light and the dark theme. What a colour means is the same in both.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec4.hpp>

namespace netwright {

enum class Theme { Light, Dark };

/// sRGB with straight alpha, each 0…1.
using Colour = glm::vec4;

/// 0xRRGGBB, as colours are written everywhere.
constexpr Colour rgb(std::uint32_t hex, float alpha = 1) {
  return {static_cast<float>((hex >> 16) & 255) / 255.0F, static_cast<float>((hex >> 8) & 255) / 255.0F,
          static_cast<float>(hex & 255) / 255.0F, alpha};
}

struct Palette {
  Theme theme = Theme::Light;
  // The model's view.
  Colour background_top;
  Colour background_bottom;
  Colour model;       ///< paper, fully lit
  Colour model_back;  ///< the inner side of an open model
  Colour model_edge;
  // The net's view.
  Colour desk;
  Colour sheet;  ///< a page on the desk
  Colour sheet_border;
  Colour sheet_margin;
  Colour paper;  ///< a face of the net
  Colour cut;
  Colour cut_halo;  ///< a thin rim around the net, where dark cuts would drown in a dark desk (else alpha 0)
  Colour mountain;
  Colour valley;
  Colour flat;
  Colour border;  ///< where the model is open: cut, but nothing is glued to it
  // Meaning, in both views.
  Colour tree;
  Colour root;
  Colour root_rim;
  Colour overlap;  ///< fill of an overlapping face
  Colour overlap_hatch;
  Colour hover;       ///< mixed into the face by its alpha; faces with a strong fill take white instead
  Colour hover_edge;  ///< an edge under the pointer, and the way to its partner
  Colour selection;   ///< outline
  Colour chosen;      ///< the face a move starts from
  Colour climbed;     ///< the path climbed by a move
  /// Seldom, often and most often in collision: ever darker, so that lightness alone tells them apart.
  std::array<Colour, 3> heat;
  Colour candidate;  ///< cuts the climb could have turned into folds
  Colour pinned_fold;
  Colour pinned_cut;
  Colour patch;    ///< outline of faces that stay together
  Colour measure;  ///< what the measuring tool draws
  Colour measure_rim;
};

const Palette& palette(Theme theme);

}  // namespace netwright
