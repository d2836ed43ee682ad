// The five commands. Each returns the program's exit status and throws Error for what ends with status 1.
#pragma once

#include "app/cli_options.h"

namespace netwright {

/// 0 one proved net per component, written; 2 not within the limits; 130 cancelled. Writes nothing but with
/// 0.
int run_unfold(const UnfoldCommand& command);

/// As run_unfold().
int run_replace(const ReplaceCommand& command);

/// 0 a net, 2 not one.
int run_verify(const VerifyCommand& command);

/// 0 fit to unfold, 2 needs repair.
int run_info(const InfoCommand& command);

/// 0 when it ran through, whatever the runs came to; 130 cancelled.
int run_bench(const BenchCommand& command);

}  // namespace netwright
