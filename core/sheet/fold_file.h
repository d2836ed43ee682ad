// FOLD 1.2, the origami community's JSON, for a net: one frame flat in mm at print scale with every digit,
// one frame folded on the model, so that the file can be verified without the model.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/unfold/flat_net.h"

namespace netwright {

std::string fold_text(const FlatNet& net);
/// Throws Error(Write).
void write_fold(const std::filesystem::path& path, const FlatNet& net);

/// Checks types, lengths, ranges and finiteness and throws Error(Read) with one sentence naming the file
/// (`name`), the key and the entry; what the numbers mean is for `verify` to judge. Files of other programs
/// are read too when they have both frames.
FlatNet parse_fold(std::string_view text, const std::string& name);
FlatNet read_fold(const std::filesystem::path& path);

}  // namespace netwright
