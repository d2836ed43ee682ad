// The archive around a project's parts, by libzip. The order of the entries is fixed and their times are all
// the same, so that the same project is the same file.
#include "core/project/project_file.h"

#include <zip.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/predicates.h"
#include "core/project/shape_bytes.h"
#include "core/project/thumbnail.h"
#include "core/unfold/flat_net.h"
#include "core/unfold/overlap.h"
#include "core/unfold/verify.h"

namespace netwright {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kZipMark = "PK\x03\x04";
constexpr std::size_t kFirstName = 30;  ///< where a zip file's first entry begins: its name, then its content
constexpr std::string_view kFirstEntry = "mimetypeapplication/x-netwright";
constexpr std::size_t kHeadBytes = 64;

constexpr const char* kMimeTypeEntry = "mimetype";
constexpr const char* kJsonEntry = "project.json";
constexpr const char* kThumbnailEntry = "thumbnail.png";
constexpr const char* kSourceEntry = "shapes/source";
constexpr const char* kBaseEntry = "shapes/base";
constexpr const char* kMeshEntry = "shapes/mesh";
constexpr int kThumbnailSide = 256;

// Far above any model made for paper. Deflate cannot shrink anything further than to a 1032nd.
constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30;
constexpr std::uint64_t kMaxTotalBytes = std::uint64_t{2} << 30;
constexpr std::uint64_t kMaxEntryBytes = std::uint64_t{1} << 30;
constexpr std::uint64_t kMaxJsonBytes = std::uint64_t{64} << 20;
constexpr std::uint64_t kMaxRatio = 1040;
constexpr std::int64_t kMaxEntries = 1000;

struct CloseArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
using Archive = std::unique_ptr<zip_t, CloseArchive>;
struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, FreeSource>;

[[noreturn]] void cannot_pack(const std::string& why) {
  throw Error(ErrorKind::Write, "The project cannot be packed: " + why + ".");
}

/// An archive being written in memory. What is added must stay until bytes() was called.
class ArchiveWriter {
 public:
  ArchiveWriter() {
    zip_error_t error;
    zip_error_init(&error);
    result_.reset(zip_source_buffer_create(nullptr, 0, 0, &error));
    if (!result_) cannot_pack(zip_error_strerror(&error));
    zip_source_keep(result_.get());  // the archive gives its own share back when it is closed
    archive_.reset(zip_open_from_source(result_.get(), ZIP_TRUNCATE, &error));
    if (!archive_) {
      const std::string why = zip_error_strerror(&error);
      zip_source_free(result_.get());
      cannot_pack(why);
    }
  }

  void add(const char* name, std::string_view content, bool is_compressed) {
    zip_source_t* const source = zip_source_buffer(archive_.get(), content.data(), content.size(), 0);
    const zip_int64_t index = source == nullptr ? -1 : zip_file_add(archive_.get(), name, source, 0);
    if (index < 0) {
      zip_source_free(source);
      cannot_pack(zip_strerror(archive_.get()));
    }
    const auto entry = static_cast<zip_uint64_t>(index);
    constexpr int kQuick = 3;
    constexpr zip_uint16_t kFirstOf1980 = (1 << 5) | 1;
    zip_set_file_compression(archive_.get(), entry, is_compressed ? ZIP_CM_DEFLATE : ZIP_CM_STORE, kQuick);
    zip_file_set_dostime(archive_.get(), entry, 0, kFirstOf1980, 0);
  }

  std::string bytes() {
    if (zip_close(archive_.get()) != 0) cannot_pack(zip_strerror(archive_.get()));
    static_cast<void>(archive_.release());
    zip_stat_t stat;
    zip_stat_init(&stat);
    std::string bytes;
    if (zip_source_stat(result_.get(), &stat) == 0) bytes.resize(stat.size);
    const bool is_read =
        !bytes.empty() && zip_source_open(result_.get()) == 0 &&
        zip_source_read(result_.get(), bytes.data(), bytes.size()) == static_cast<zip_int64_t>(bytes.size());
    if (!is_read) cannot_pack("there is too little memory");
    zip_source_close(result_.get());
    return bytes;
  }

 private:
  Source result_;
  Archive archive_;
};

/// An archive being read. Tells damage in the words of the file.
class ArchiveReader {
 public:
  ArchiveReader(std::string_view bytes, const std::string& file) : file_(file) {
    zip_error_t error;
    zip_error_init(&error);
    Source source(zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error));
    if (source) archive_.reset(zip_open_from_source(source.get(), ZIP_RDONLY, &error));
    if (!archive_) refuse_damaged(file_, "its end is missing or mangled");
    static_cast<void>(source.release());
    if (zip_get_num_entries(archive_.get(), 0) > kMaxEntries)
      refuse_damaged(file_, "it holds more entries than any project");
  }

  /// Nothing when there is no such entry.
  std::optional<std::string> find(const std::string& name, std::uint64_t most) {
    const zip_int64_t index = zip_name_locate(archive_.get(), name.c_str(), 0);
    if (index < 0) return std::nullopt;
    const std::uint64_t size = checked_size(static_cast<zip_uint64_t>(index), name, most);
    zip_file_t* const entry = zip_fopen_index(archive_.get(), static_cast<zip_uint64_t>(index), 0);
    if (entry == nullptr) refuse_damaged(file_, name + " in it cannot be opened");
    std::string bytes(size, '\0');
    const zip_int64_t got = zip_fread(entry, bytes.data(), bytes.size());
    // Only the end tells whether the check sum is right.
    char more = 0;
    const bool is_whole = got == static_cast<zip_int64_t>(size) && zip_fread(entry, &more, 1) == 0;
    zip_fclose(entry);
    if (!is_whole) refuse_damaged(file_, name + " in it is damaged");
    return bytes;
  }

  std::string get(const std::string& name, std::uint64_t most) {
    std::optional<std::string> bytes = find(name, most);
    if (!bytes) refuse_damaged(file_, name + " is missing in it");
    return std::move(*bytes);
  }

 private:
  std::uint64_t checked_size(zip_uint64_t index, const std::string& name, std::uint64_t most) {
    constexpr zip_uint64_t kNeeded = ZIP_STAT_SIZE | ZIP_STAT_COMP_SIZE | ZIP_STAT_COMP_METHOD;
    zip_stat_t stat;
    zip_stat_init(&stat);
    if (zip_stat_index(archive_.get(), index, 0, &stat) != 0 || (stat.valid & kNeeded) != kNeeded)
      refuse_damaged(file_, name + " in it cannot be opened");
    if (stat.comp_method != ZIP_CM_STORE && stat.comp_method != ZIP_CM_DEFLATE)
      refuse_damaged(file_, name + " in it is packed in a way that no Netwright uses");
    total_ += stat.size;
    if (stat.size > most || total_ > kMaxTotalBytes || stat.size / kMaxRatio > stat.comp_size)
      refuse_damaged(file_, name + " in it is larger than any project's");
    return stat.size;
  }

  const std::string& file_;
  Archive archive_;
  std::uint64_t total_ = 0;
};

std::string picture_entry(std::size_t number) { return "pictures/" + std::to_string(number) + ".png"; }

std::string read_head(const fs::path& path) {
  std::string head(kHeadBytes, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  return head;
}

void check_head(std::string_view bytes, const std::string& name) {
  if (is_project(bytes)) return;
  throw Error(ErrorKind::Read,
              name + (bytes.empty() ? " is empty: there is no project in it; open an earlier copy of it."
                                    : " is no Netwright project; open one that ends in .netwright."));
}

/// A file may say what it likes: what is shown as proved has been proved by us.
void prove_again(Project& project) {
  if (!project.tree || !project.run || !project.run->is_proved) return;
  const Net net = layout(project.dual, *project.tree);
  const VerifyReport proof = verify(to_flat_net(net, 1), net.n_pieces);
  if (proof.is_net) return;
  project.run->is_proved = false;
  project.run->overlaps = static_cast<int>(find_overlaps(net, kShownDepth).size());
}

}  // namespace

bool is_project(std::string_view first_bytes) {
  return first_bytes.starts_with(kZipMark) && first_bytes.size() >= kFirstName + kFirstEntry.size() &&
         first_bytes.substr(kFirstName, kFirstEntry.size()) == kFirstEntry;
}

bool has_project_name(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension.size() == kProjectExtension.size() + 1 && extension.substr(1) == kProjectExtension;
}

bool is_project_file(const fs::path& path) {
  std::error_code ignored;
  return has_project_name(path) || (fs::is_regular_file(path, ignored) && is_project(read_head(path)));
}

std::string project_bytes(const Project& project, const fs::path& belongs_to, PictureCache* cache,
                          const std::vector<KeptRun>& runs) {
  const ProjectParts parts = to_parts(project, belongs_to, cache, runs);
  const std::string thumbnail = encode_png(draw_thumbnail(*project.dual, kThumbnailSide));
  ArchiveWriter archive;
  archive.add(kMimeTypeEntry, kProjectMimeType, false);
  archive.add(kJsonEntry, parts.json, true);
  archive.add(kThumbnailEntry, thumbnail, false);
  archive.add(kSourceEntry, parts.source, true);
  if (!parts.base.empty()) archive.add(kBaseEntry, parts.base, true);
  archive.add(kMeshEntry, parts.mesh, true);
  for (std::size_t i = 0; i < parts.pictures.size(); ++i)
    archive.add(picture_entry(i + 1).c_str(), parts.pictures[i], false);
  return archive.bytes();
}

StoredProject parse_project(std::string_view bytes, const std::string& name) {
  check_head(bytes, name);
  ArchiveReader archive(bytes, name);
  ProjectParts parts;
  parts.json = archive.get(kJsonEntry, kMaxJsonBytes);
  // A newer format may well have other entries: the JSON says so, and nobody should be told of damage then.
  static_cast<void>(outline_of(parts.json, name));
  parts.source = archive.get(kSourceEntry, kMaxEntryBytes);
  parts.base = archive.find(kBaseEntry, kMaxEntryBytes).value_or("");
  parts.mesh = archive.get(kMeshEntry, kMaxEntryBytes);
  while (auto picture = archive.find(picture_entry(parts.pictures.size() + 1), kMaxEntryBytes))
    parts.pictures.push_back(std::move(*picture));
  StoredProject stored = from_parts(parts, name);
  prove_again(stored.project);
  return stored;
}

void save_project(const Project& project, const fs::path& path, const fs::path& belongs_to,
                  PictureCache* cache, const std::vector<KeptRun>& runs) {
  const std::string bytes = project_bytes(project, belongs_to, cache, runs);
  if (bytes.size() > kMaxFileBytes)
    throw Error(ErrorKind::Write,
                path.filename().string() + " would be larger than 1 GB; give the model smaller textures.");
  const std::string name = path.filename().string();
  write_file(path, bytes, [&](std::string_view written) {
    try {
      if (written == bytes) static_cast<void>(parse_project(written, name));
    } catch (const Error& error) {
      throw Error(ErrorKind::Write, "What was saved could not be read again (" + std::string(error.what()) +
                                        "), so the old file was kept; save it under another name.");
    }
    if (written != bytes)
      throw Error(ErrorKind::Write, path.string() +
                                        " cannot be written: the disk gives back something else than it was "
                                        "given; save to another one.");
  });
}

StoredProject load_project(const fs::path& path) {
  return parse_project(read_file(path, kMaxFileBytes), path.filename().string());
}

ProjectGlance glance_at_project(const fs::path& path) {
  const std::string name = path.filename().string();
  const std::string bytes = read_file(path, kMaxFileBytes);
  check_head(bytes, name);
  ArchiveReader archive(bytes, name);
  ProjectGlance glance;
  glance.outline = outline_of(archive.get(kJsonEntry, kMaxJsonBytes), name);
  constexpr std::uint64_t kMaxThumbnailBytes = std::uint64_t{4} << 20;
  const std::string picture = archive.find(kThumbnailEntry, kMaxThumbnailBytes).value_or("");
  const ImageSize size = image_size(picture);
  if (std::max(size.width, size.height) <= 4 * kThumbnailSide) glance.thumbnail = decode_image(picture);
  return glance;
}

}  // namespace netwright
