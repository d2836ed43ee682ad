// From a model that was read to the files that were asked for: what unfold and replace have in common.
#pragma once

#include "app/cli_model.h"
#include "app/cli_watch.h"

namespace netwright {

/// Refuses outputs that cannot be written, before any time is spent. Throws Error.
void check_outputs(const UnfoldCommand& command);

/// Searches (unless the model brings its net along), proves, writes all files or none, and tells; the exit
/// status of unfold. `start` is when the program began, see now_seconds().
int search_and_write(const UnfoldCommand& command, const CliModel& model, const Interrupts& interrupts,
                     double start);

}  // namespace netwright
