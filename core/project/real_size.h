// How large a model is by its own file, and whether that can be meant.
#pragma once

#include <string>

#include "core/mesh/mesh.h"

namespace netwright {

struct RealSize {
  double height_mm = 0;   ///< along the up axis
  double longest_mm = 0;  ///< the longest side of the box around it
  /// Under 10 mm or over 2 m: a unit that got lost, or a thing that nobody folds at its own size.
  [[nodiscard]] bool is_odd() const;
  /// Odd, and a height says how large it shall be; that of a sheet that lies on the table says nothing.
  [[nodiscard]] bool is_worth_asking() const;
};

/// What to propose instead, in mm: a model that stands on a table and takes a few pages.
inline constexpr double kUsualHeight = 200;

/// By guess_unit() of the file's faces, for the mesh that was made of them.
RealSize real_size(const PolygonSoup& source, const Mesh& mesh);

/// Of lengths that may be anything: "0.002 mm", "8.3 mm", "45 mm", "3.2 m", "14 km".
std::string real_length_text(double millimetres);

}  // namespace netwright
