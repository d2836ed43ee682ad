// The processor's name stands in a file of the system; what the compiler was told comes from CMake.
#include "app/cli_bench_place.h"

#include <fstream>

#include "core/base/worker.h"

namespace netwright {
namespace {

/// Clang's version begins with its name, that of GCC does not.
#ifdef __clang__
constexpr const char* kCompiler = "";
#else
constexpr const char* kCompiler = "GCC ";
#endif

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unnamed processor";
}

}  // namespace

std::string bench_place() {
  const int n_threads = ThreadPool::hardware_threads();
  return processor_name() + ", " + std::to_string(n_threads) + (n_threads == 1 ? " thread; " : " threads; ") +
         "netwright-cli " NETWRIGHT_VERSION ", " + kCompiler + __VERSION__ + ", " NETWRIGHT_BUILD_OPTIONS;
}

}  // namespace netwright
