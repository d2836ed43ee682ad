// How much processor time a thread has used, for reporting only: nothing is ever decided by it.
#pragma once

namespace netwright {

/// CPU seconds of the calling thread so far (the high-resolution thread clock, user and system time).
double thread_cpu_seconds();

}  // namespace netwright
