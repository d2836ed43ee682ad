// The project file, *.netwright: a zip archive with everything in it. The first entry is called mimetype and
// is not compressed, so that its content stands at a fixed place and says what the file is.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/image.h"
#include "core/project/project_parts.h"

namespace netwright {

inline constexpr std::string_view kProjectExtension = "netwright";
inline constexpr std::string_view kProjectMimeType = "application/x-netwright";

/// Does a file that starts with these bytes (64 suffice) claim to be a project?
bool is_project(std::string_view first_bytes);
/// Is the file called a project (*.netwright, in any case), or does its content say that it is one?
bool is_project_file(const std::filesystem::path& path);
bool has_project_name(const std::filesystem::path& path);

/// The project must have a model. The same project gives the same bytes.
std::string project_bytes(const Project& project, const std::filesystem::path& belongs_to = {},
                          PictureCache* cache = nullptr, const std::vector<KeptRun>& runs = {});

/// Counts and sizes are bounded before memory is taken, and a net that the file calls proved is proved again.
/// `name` is what messages call the file. Throws Error(Read) with one sentence.
StoredProject parse_project(std::string_view bytes, const std::string& name);

/// Writes beside the file, flushes, reads that back as a project, and only then lets it take the old file's
/// place. Throws Error(Write) with one sentence; the old file is then as it was.
void save_project(const Project& project, const std::filesystem::path& path,
                  const std::filesystem::path& belongs_to = {}, PictureCache* cache = nullptr,
                  const std::vector<KeptRun>& runs = {});

StoredProject load_project(const std::filesystem::path& path);

/// What a list of files shows of one. Throws Error(Read).
struct ProjectGlance {
  ProjectOutline outline;
  Image thumbnail;  ///< empty where the file has none
};
ProjectGlance glance_at_project(const std::filesystem::path& path);

}  // namespace netwright
