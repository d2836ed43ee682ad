// Writes a proof while it is being searched for: what turns out not to matter is struck out again.
#pragma once

#include "core/unfold/impossibility.h"

namespace netwright {

class ProofWriter {
 public:
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  void add(ImpossibilityProof::Step step, std::int32_t a = 0, std::int32_t b = 0) {
    nodes_.push_back({step, a, b});
    is_struck_.push_back(0);
  }
  void strike(std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) is_struck_[i] = 1;
  }
  [[nodiscard]] std::vector<ImpossibilityProof::Node> nodes() const {
    std::vector<ImpossibilityProof::Node> left;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (is_struck_[i] == 0) left.push_back(nodes_[i]);
    return left;
  }

 private:
  std::vector<ImpossibilityProof::Node> nodes_;
  std::vector<char> is_struck_;
};

}  // namespace netwright
