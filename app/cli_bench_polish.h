// What polish brought to the nets of a bench: each figure before and after, by folder.
#pragma once

#include <string>
#include <vector>

#include "app/cli_aims.h"
#include "core/solve/solve.h"

namespace netwright {

inline constexpr double kBenchHeight = 200;  ///< mm; how high models are for which necks are counted

/// The aim of a model in a bench: the usual weights, at kBenchHeight.
PolishAim bench_polish(const Mesh& mesh, double effort);

class PolishTable {
 public:
  /// A run whose net was polished; others count for nothing.
  void add(const std::string& folder, const SolveResult& result);

  /// One row per folder in the order of first appearance: nets, and "before → after" of each figure: lengths
  /// as medians of the change, shares as medians, necks as sums. Empty without nets.
  [[nodiscard]] std::string text() const;

 private:
  struct Folder {
    std::string name;
    std::vector<PolishFigures> before;
    std::vector<PolishFigures> after;
    int necks_before = 0;
    int necks_after = 0;
    double cpu_seconds = 0;
  };
  std::vector<Folder> folders_;
};

}  // namespace netwright
