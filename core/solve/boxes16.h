// Sixteen boxes at a time against one: the inner loop of the search's broad phase. Comparisons only, so every
// path gives the same answer; SSE2 is part of every x86-64, other machines take the plain loop.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

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

  /// Bit j is set when box 16 * block + j meets `box` (closed boxes).
  [[nodiscard]] unsigned hits(int block, const BoxF& box) const {
    const auto first = static_cast<std::size_t>(block) * 16;
    unsigned mask = 0;
#if defined(__SSE2__)
    const __m128 lo_x = _mm_set1_ps(box.min_x);
    const __m128 lo_y = _mm_set1_ps(box.min_y);
    const __m128 hi_x = _mm_set1_ps(box.max_x);
    const __m128 hi_y = _mm_set1_ps(box.max_y);
    for (unsigned q = 0; q < 16; q += 4) {
      const __m128 x = _mm_and_ps(_mm_cmple_ps(_mm_loadu_ps(&min_x[first + q]), hi_x),
                                  _mm_cmpge_ps(_mm_loadu_ps(&max_x[first + q]), lo_x));
      const __m128 y = _mm_and_ps(_mm_cmple_ps(_mm_loadu_ps(&min_y[first + q]), hi_y),
                                  _mm_cmpge_ps(_mm_loadu_ps(&max_y[first + q]), lo_y));
      mask |= static_cast<unsigned>(_mm_movemask_ps(_mm_and_ps(x, y))) << q;
    }
#else
    for (unsigned j = 0; j < 16; ++j) {
      const std::size_t k = first + j;
      const bool hit =
          min_x[k] <= box.max_x && max_x[k] >= box.min_x && min_y[k] <= box.max_y && max_y[k] >= box.min_y;
      mask |= (hit ? 1U : 0U) << j;
    }
#endif
    return mask;
  }
};

}  // namespace netwright
