// On what a bench was measured: figures mean little without it.
#pragma once

#include <string>

namespace netwright {

/// Machine and build in one line, as "Intel Core i5-6500, 4 threads; netwright-cli 1.0, GCC 12.2.0, Release
/// -O3".
std::string bench_place();

}  // namespace netwright
