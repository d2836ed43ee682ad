// The six bundled models, read from the program's own bytes.
#include "ui/samples.h"

#include <array>
#include <filesystem>

#include "assets/assets.h"

namespace netwright {
namespace {

constexpr std::string_view kFolder = "assets/samples/";
constexpr std::array<Sample, 6> kSamples{Sample{"Bunny", "assets/samples/bunny_370.obj"},
                                         Sample{"Teapot", "assets/samples/teapot_745.obj"},
                                         Sample{"Globe", "assets/samples/globe.obj"},
                                         Sample{"Sand clock", "assets/samples/sand_clock.obj"},
                                         Sample{"Icosphere", "assets/samples/icosphere_80.obj"},
                                         Sample{"Cube", "assets/samples/cube.obj"}};

}  // namespace

std::span<const Sample> samples() { return kSamples; }

std::string sample_name(const Sample& sample) {
  return std::filesystem::path(sample.file).filename().string();
}

CompanionLookup sample_companions() {
  return [](const std::string& name) -> std::optional<std::string> {
    const std::string wanted = std::string(kFolder) + name;
    for (const Asset& candidate : assets()) {
      if (candidate.name == wanted) return std::string(asset_text(wanted));
    }
    return std::nullopt;
  };
}

void open_sample(Session& session, const Sample& sample) {
  session.open_bytes(sample_name(sample), std::string(asset_text(sample.file)), sample_companions());
}

}  // namespace netwright
