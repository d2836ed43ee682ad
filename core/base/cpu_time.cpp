// The thread clock of POSIX; getrusage would tick in steps of 4 ms and read zero for most models.
#include "core/base/cpu_time.h"

#include <ctime>

namespace netwright {

double thread_cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace netwright
