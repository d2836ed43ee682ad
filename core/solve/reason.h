// Which decisions a contradiction rests on, as a set of their numbers. A decision that is not in it need not
// be taken back: the other choice would end in the same contradiction.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace netwright {

class Reason {
 public:
  Reason() = default;
  explicit Reason(std::size_t n_decisions) : words_((n_decisions + 63) / 64, 0) {}

  void add(std::size_t i) { words_[i / 64] |= bit(i); }
  void drop(std::size_t i) { words_[i / 64] &= ~bit(i); }
  [[nodiscard]] bool has(std::size_t i) const { return (words_[i / 64] & bit(i)) != 0; }
  void add(const Reason& other) {
    for (std::size_t w = 0; w < words_.size(); ++w) words_[w] |= other.words_[w];
  }

 private:
  static std::uint64_t bit(std::size_t i) { return std::uint64_t{1} << (i % 64); }
  std::vector<std::uint64_t> words_;
};

}  // namespace netwright
