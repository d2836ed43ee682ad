// Several pieces where no net of one piece was found and more were allowed on the command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli_options.h"
#include "app/cli_watch.h"
#include "core/base/json.h"
#include "core/solve/fewest_pieces.h"

namespace netwright {

/// What can be had in pieces; nothing where a single one was found, more were not allowed, or Ctrl-C came.
std::optional<PiecesResult> look_for_pieces(const UnfoldCommand& command, const SolveResult& result,
                                            const SolveOptions& options, const Interrupts& interrupts);

/// Takes the net of fewest pieces for the result, where the command allows so many; false where not.
bool take_pieces(const UnfoldCommand& command, const PiecesResult& pieces, SolveResult& result);

/// "2 pieces: 1450 mm of cuts on a model 100 mm high", a line for each choice, and how few there can be.
std::vector<std::string> pieces_lines(const UnfoldCommand& command, const PiecesResult& pieces);
Json pieces_json(const PiecesResult& pieces);

}  // namespace netwright
