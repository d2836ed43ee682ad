// The list of a net's overlaps, the deepest first, and the one that is lit in both views.
#pragma once

#include <cstdint>
#include <vector>

#include "core/project/shown_net.h"

namespace netwright {

struct OverlapList {
  struct Row {
    Overlap overlap;
    double depth = 0;  ///< in model units
  };
  /// More than this nobody reads; it keeps the list cheap on unfinished nets of any size.
  static constexpr std::size_t kMostRows = 500;

  /// Does nothing when it lists this net already.
  void list(const ShownNet& shown);

  std::vector<Row> rows;
  std::uint64_t version = ~std::uint64_t{0};  ///< of the net; none at first
};

}  // namespace netwright
