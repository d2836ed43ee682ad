// The bundled models: what they are called, and how a session opens them.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/mesh/read.h"
#include "core/project/session.h"

namespace netwright {

struct Sample {
  std::string_view title;  ///< "Stanford bunny"
  std::string_view file;   ///< among the assets
};

std::span<const Sample> samples();

/// The file's name without folder: "bunny_370.obj".
std::string sample_name(const Sample& sample);
/// Finds what a sample's file refers to among the embedded ones.
CompanionLookup sample_companions();

void open_sample(Session& session, const Sample& sample);

}  // namespace netwright
