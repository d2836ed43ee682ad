// A Project taken apart into the files of its archive, and put together again. Everything is checked on the
// way back: what comes out is as good as any project made by hand.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/image.h"
#include "core/project/kept_runs.h"
#include "core/project/project.h"

namespace netwright {

/// What a project file holds, entry by entry.
struct ProjectParts {
  std::string json;
  std::string source;                 ///< the model file's faces, as shape_bytes()
  std::string base;                   ///< the mesh before simplifying and merging; empty where nothing was
  std::string mesh;                   ///< the mesh that is unfolded
  std::vector<std::string> pictures;  ///< textures, PNG
};

/// A project and, for one that was saved by itself, the file that its user saves it to.
struct StoredProject {
  Project project;
  std::filesystem::path belongs_to;
  std::vector<KeptRun> runs;  ///< of the project's mesh; that they are proved is only what the file says
};

/// Pictures that were packed before; packing a large one takes a second. Used by one thread at a time.
struct PictureCache {
  std::vector<std::pair<std::shared_ptr<const Image>, std::string>> pictures;
};

/// The version of the format; files of this one and all older ones are read.
inline constexpr int kProjectFormat = 2;

/// The project must have a model. `cache` may be null.
ProjectParts to_parts(const Project& project, const std::filesystem::path& belongs_to, PictureCache* cache,
                      const std::vector<KeptRun>& runs = {});

/// Meshes are taken as they were stored, not made again from the recipe, so a later Netwright that would make
/// them otherwise still shows the same net. `file` is what messages call the file.
/// Throws Error(Read) with one sentence.
StoredProject from_parts(const ProjectParts& parts, const std::string& file);

/// What the JSON alone tells, for a list of files.
struct ProjectOutline {
  std::string name;  ///< the model's
  std::filesystem::path belongs_to;
  int n_faces = 0;
  bool is_proved = false;
};
/// Throws Error(Read).
ProjectOutline outline_of(const std::string& json, const std::string& file);

}  // namespace netwright
