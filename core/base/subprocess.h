// Where child processes are made, and nowhere else: a program with an argument vector (never a shell), bytes
// in, bytes out, and limits on its time and memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"

namespace netwright {

struct ChildLimits {
  double seconds = 0;            ///< wall clock and CPU time; 0 = none
  std::size_t memory_bytes = 0;  ///< address space; 0 = none (also under sanitizers, which map terabytes)
  std::size_t output_bytes = 0;  ///< what it may write at most; 0 = none
  const Progress* progress = nullptr;  ///< when it is cancelled, the child is ended; may be null
};

struct ChildResult {
  enum class End {
    Exited,   ///< by itself; see exit_code
    Crashed,  ///< killed by a signal that we did not send
    TimedOut,
    Flooded,    ///< wrote more than it may
    Cancelled,  ///< by the limits' progress
  };
  End end = End::Exited;
  int exit_code = 0;
  std::string output;  ///< its standard output; standard error is discarded
};

/// Runs the program to its end, feeding `input` to its standard input. Safe to call from any thread.
/// Throws Error(Read) when it cannot be started at all.
ChildResult run_child(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                      std::string_view input, const ChildLimits& limits);

/// The folder that the running program lies in.
std::filesystem::path program_folder();

}  // namespace netwright
