// How large the model is printed, in the words its user has for it.
#pragma once

#include <optional>
#include <string>

#include "core/mesh/mesh.h"

namespace netwright {

struct PrintSize {
  enum class Kind {
    FitPage,     ///< as large as fits on one page
    Height,      ///< true to the height of the finished model
    EdgeLength,  ///< true to the length of one edge
    Scale,       ///< so many mm per model unit
    FitSheets,   ///< as large as fits on so many sheets
  };
  Kind kind = Kind::FitPage;
  double height_mm = 150;  ///< for Kind::Height
  EdgeId edge = {};        ///< for Kind::EdgeLength: which one,
  double edge_mm = 50;     ///< and how long
  double scale = 1;        ///< for Kind::Scale: mm per model unit
  int sheets = 2;          ///< for Kind::FitSheets: at least 1
  bool operator==(const PrintSize&) const = default;
};

inline constexpr int kMostFittedSheets = 100;

/// Mm per model unit where the size says so by itself; nothing where it depends on the paper. Throws
/// Error(Usage): no length, a model without height, an edge that is not there.
std::optional<double> scale_of(const Mesh& mesh, const PrintSize& size);

/// The same size for a mesh in this one's place, whose edges are other ones: what was said by an edge's
/// length is said by the scale.
PrintSize without_edge(const Mesh& mesh, const PrintSize& size);

/// "a height of 120 mm", "a scale of 3" …: what the size asks for, for a sentence.
std::string size_words(const PrintSize& size);

}  // namespace netwright
