// The same comparisons three times: plain, four lanes (SSE2) and eight (AVX2). The wide ones are compiled for
// their own instruction set alone, so the program still starts on machines without it.
#include "core/solve/boxes16.h"

#include <bit>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace netwright {

namespace {

unsigned hits_plain(const BoxLanes& lanes, int block, const BoxF& box) {
  const auto first = static_cast<std::size_t>(block) * 16;
  unsigned mask = 0;
  for (unsigned j = 0; j < 16; ++j) {
    const std::size_t k = first + j;
    const bool hit = lanes.min_x[k] <= box.max_x && lanes.max_x[k] >= box.min_x &&
                     lanes.min_y[k] <= box.max_y && lanes.max_y[k] >= box.min_y;
    mask |= (hit ? 1U : 0U) << j;
  }
  return mask;
}

int append_bits(unsigned mask, int first, int* found, int n) {
  for (; mask != 0; mask &= mask - 1) found[n++] = first + std::countr_zero(mask);
  return n;
}

int find_plain(const BoxLanes& lanes, const BoxF& box, int* found) {
  const int n_blocks = static_cast<int>(lanes.min_x.size() / 16);
  int n = 0;
  for (int b = 0; b < n_blocks; ++b) n = append_bits(hits_plain(lanes, b, box), 16 * b, found, n);
  return n;
}

#if defined(__x86_64__)

unsigned hits_sse2(const BoxLanes& lanes, int block, const BoxF& box) {
  const auto first = static_cast<std::size_t>(block) * 16;
  const __m128 lo_x = _mm_set1_ps(box.min_x);
  const __m128 lo_y = _mm_set1_ps(box.min_y);
  const __m128 hi_x = _mm_set1_ps(box.max_x);
  const __m128 hi_y = _mm_set1_ps(box.max_y);
  unsigned mask = 0;
  for (unsigned q = 0; q < 16; q += 4) {
    const std::size_t k = first + q;
    const __m128 x = _mm_and_ps(_mm_cmple_ps(_mm_loadu_ps(&lanes.min_x[k]), hi_x),
                                _mm_cmpge_ps(_mm_loadu_ps(&lanes.max_x[k]), lo_x));
    const __m128 y = _mm_and_ps(_mm_cmple_ps(_mm_loadu_ps(&lanes.min_y[k]), hi_y),
                                _mm_cmpge_ps(_mm_loadu_ps(&lanes.max_y[k]), lo_y));
    mask |= static_cast<unsigned>(_mm_movemask_ps(_mm_and_ps(x, y))) << q;
  }
  return mask;
}

int find_sse2(const BoxLanes& lanes, const BoxF& box, int* found) {
  const int n_blocks = static_cast<int>(lanes.min_x.size() / 16);
  int n = 0;
  for (int b = 0; b < n_blocks; ++b) n = append_bits(hits_sse2(lanes, b, box), 16 * b, found, n);
  return n;
}

__attribute__((target("avx2"))) unsigned hits_avx2(const BoxLanes& lanes, int block, const BoxF& box) {
  const auto first = static_cast<std::size_t>(block) * 16;
  const __m256 lo_x = _mm256_set1_ps(box.min_x);
  const __m256 lo_y = _mm256_set1_ps(box.min_y);
  const __m256 hi_x = _mm256_set1_ps(box.max_x);
  const __m256 hi_y = _mm256_set1_ps(box.max_y);
  unsigned mask = 0;
  for (unsigned q = 0; q < 16; q += 8) {
    const std::size_t k = first + q;
    const __m256 x = _mm256_and_ps(_mm256_cmp_ps(_mm256_loadu_ps(&lanes.min_x[k]), hi_x, _CMP_LE_OQ),
                                   _mm256_cmp_ps(_mm256_loadu_ps(&lanes.max_x[k]), lo_x, _CMP_GE_OQ));
    const __m256 y = _mm256_and_ps(_mm256_cmp_ps(_mm256_loadu_ps(&lanes.min_y[k]), hi_y, _CMP_LE_OQ),
                                   _mm256_cmp_ps(_mm256_loadu_ps(&lanes.max_y[k]), lo_y, _CMP_GE_OQ));
    mask |= static_cast<unsigned>(_mm256_movemask_ps(_mm256_and_ps(x, y))) << q;
  }
  return mask;
}

__attribute__((target("avx2"))) int find_avx2(const BoxLanes& lanes, const BoxF& box, int* found) {
  const int n_blocks = static_cast<int>(lanes.min_x.size() / 16);
  int n = 0;
  for (int b = 0; b < n_blocks; ++b) n = append_bits(hits_avx2(lanes, b, box), 16 * b, found, n);
  return n;
}

#endif

}  // namespace

const std::vector<BoxKernel>& box_kernels() {
  static const std::vector<BoxKernel> kernels = [] {
    std::vector<BoxKernel> list{{"plain", hits_plain, find_plain}};
#if defined(__x86_64__)
    list.push_back({"SSE2", hits_sse2, find_sse2});
    if (__builtin_cpu_supports("avx2") != 0) list.push_back({"AVX2", hits_avx2, find_avx2});
#endif
    return list;
  }();
  return kernels;
}

const BoxKernel& best_box_kernel() { return box_kernels().back(); }

}  // namespace netwright
