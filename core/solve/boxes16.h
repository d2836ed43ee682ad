// Many boxes against one, sixteen at a time: the inner loop of the search's broad phase. Comparisons only, so
// every path gives the same answer; which one runs is chosen when the program starts on the machine it finds
// itself on.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace netwright {

/// A box in float that is sure to contain the double box it was made from.
struct BoxF {
  float min_x = std::numeric_limits<float>::infinity();
  float min_y = std::numeric_limits<float>::infinity();
  float max_x = -std::numeric_limits<float>::infinity();
  float max_y = -std::numeric_limits<float>::infinity();

  /// Rounds outward: half a unit in the last place of float is 6e-8 of the value, twice that is added.
  static BoxF around(double min_x, double min_y, double max_x, double max_y) {
    constexpr float kOutward = 1.2e-7F;
    const auto low = [](double v) {
      return static_cast<float>(v) - kOutward * std::abs(static_cast<float>(v));
    };
    const auto high = [](double v) {
      return static_cast<float>(v) + kOutward * std::abs(static_cast<float>(v));
    };
    return {low(min_x), low(min_y), high(max_x), high(max_y)};
  }
  /// Grows to contain the other box.
  void add(const BoxF& b) {
    min_x = b.min_x < min_x ? b.min_x : min_x;
    min_y = b.min_y < min_y ? b.min_y : min_y;
    max_x = b.max_x > max_x ? b.max_x : max_x;
    max_y = b.max_y > max_y ? b.max_y : max_y;
  }
};

/// Boxes by coordinate, in blocks of 16; what fills up the last block is empty and meets nothing.
struct BoxLanes {
  std::vector<float> min_x, min_y, max_x, max_y;

  void resize(int n) {
    const auto padded = static_cast<std::size_t>((n + 15) / 16 * 16);
    constexpr float kInf = std::numeric_limits<float>::infinity();
    min_x.assign(padded, kInf);
    min_y.assign(padded, kInf);
    max_x.assign(padded, -kInf);
    max_y.assign(padded, -kInf);
  }
  void set(int i, const BoxF& b) {
    const auto k = static_cast<std::size_t>(i);
    min_x[k] = b.min_x;
    min_y[k] = b.min_y;
    max_x[k] = b.max_x;
    max_y[k] = b.max_y;
  }
  [[nodiscard]] BoxF get(int i) const {
    const auto k = static_cast<std::size_t>(i);
    return {min_x[k], min_y[k], max_x[k], max_y[k]};
  }
};

/// One way of comparing boxes. Closed boxes; those that fill up the last block meet nothing.
struct BoxKernel {
  const char* name;
  /// Bit j is set when box 16 * block + j meets `box`.
  unsigned (*hits)(const BoxLanes& lanes, int block, const BoxF& box);
  /// Numbers of all boxes that meet `box`, ascending; `found` must have room for all. Returns how many.
  int (*find)(const BoxLanes& lanes, const BoxF& box, int* found);
};

/// The widest kernel this machine can run: AVX2, SSE2 (every x86-64) or plain loops.
const BoxKernel& best_box_kernel();
/// All kernels this machine can run, the plain one first: for tests.
const std::vector<BoxKernel>& box_kernels();

}  // namespace netwright
