// The figures of the paper's Table 2, as printed: minima below half a millisecond stand there as 0.
#include "app/cli_bench_paper.h"

namespace netwright {

const std::array<PaperProgram, 3> kPaperPrograms{{
    {"Tabu search, the authors' program",
     "Authors' tabu",
     {{{{0, 0.021, 0.017, 1.449, 100}},
       {{0, 0.311, 0.174, 102.130, 99.86}},
       {{0, 1.890, 1.178, 629.937, 99.68}},
       {{0, 5.499, 3.729, 1017.305, 99.64}},
       {{0, 13.769, 8.699, 1570.504, 99.43}}}}},
    {"Optimized Topological Surgery (OTS)",
     "OTS",
     {{{{0.068, 0.107, 0.103, 8.742, 100}},
       {{0.190, 0.832, 0.660, 270.273, 99.82}},
       {{0.610, 10.923, 7.992, 1058.936, 99.36}},
       {{1.966, 68.344, 47.895, 3847.608, 96.04}},
       {{3.627, 211.713, 142.361, 6694.813, 88.44}}}}},
    {"Simulated Annealing (SA)",
     "SA",
     {{{{0.001, 3.674, 3.014, 127.956, 99.71}},
       {{0.114, 86.467, 75.106, 612.973, 90.08}},
       {{1.769, 565.600, 562.719, 2036.940, 25.23}},
       std::nullopt,
       std::nullopt}}},
}};

}  // namespace netwright
