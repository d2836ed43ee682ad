// Packs and unpacks the arrays. A hostile file can only make us allocate as much as it has bytes.
#include "core/project/shape_bytes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/base/error.h"

namespace netwright {

namespace {

static_assert(std::endian::native == std::endian::little, "the arrays in project files are little-endian");

constexpr std::string_view kMark = "NWSHAPE1";
/// As for the models that are read: squares and volumes of coordinates must stay within a double's range.
constexpr double kMaxCoordinate = 1e75;

enum Part { Points, Faces, Corners, Uv, Materials, Sources, Flips };
constexpr std::size_t kParts = 7;
using Counts = std::array<std::uint64_t, kParts>;
constexpr Counts kItemBytes{
    sizeof(glm::dvec3), sizeof(int), sizeof(int), sizeof(glm::dvec2), sizeof(int), sizeof(int), 1};

template <class T>
void append(std::string& bytes, const std::vector<T>& items) {
  bytes.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(T));
}

template <class T>
std::vector<T> take(std::string_view& bytes, std::uint64_t count) {
  std::vector<T> items(count);
  if (count > 0) std::memcpy(static_cast<void*>(items.data()), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
  return items;
}

/// The counts are those of the bytes that follow, to the last one.
bool fits(const Counts& counts, std::uint64_t n_bytes) {
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < kParts; ++i) {
    if (counts[i] > n_bytes) return false;
    total += counts[i] * kItemBytes[i];
  }
  const std::uint64_t n_faces = counts[Faces] == 0 ? 0 : counts[Faces] - 1;
  const auto none_or = [](std::uint64_t count, std::uint64_t all) { return count == 0 || count == all; };
  return total == n_bytes && n_faces > 0 && n_bytes < (std::uint64_t{1} << 31) &&
         none_or(counts[Uv], counts[Corners]) && none_or(counts[Materials], n_faces) &&
         none_or(counts[Sources], n_faces) && counts[Flips] == counts[Sources];
}

bool is_within(const std::vector<int>& values, int low, std::size_t end) {
  return std::all_of(values.begin(), values.end(), [&](int value) {
    return value >= low && (value < 0 || static_cast<std::size_t>(value) < end);
  });
}

bool is_sound(const glm::dvec3& p) {
  // A comparison with what is not a number is false.
  return std::abs(p.x) <= kMaxCoordinate && std::abs(p.y) <= kMaxCoordinate &&
         std::abs(p.z) <= kMaxCoordinate;
}

void check(const PolygonSoup& soup, const std::string& file) {
  const std::vector<int>& begin = soup.face_begin;
  if (begin.front() != 0 || begin.back() != static_cast<int>(soup.corners.size()) ||
      !std::is_sorted(begin.begin(), begin.end()))
    refuse_damaged(file, "the faces do not follow each other");
  if (!is_within(soup.corners, 0, soup.points.size()))
    refuse_damaged(file, "a face names a point that is not there");
  if (!std::all_of(soup.points.begin(), soup.points.end(), is_sound))
    refuse_damaged(file, "a point has a coordinate that is no usable number");
  const auto is_finite = [](const glm::dvec2& uv) { return std::isfinite(uv.x) && std::isfinite(uv.y); };
  if (!std::all_of(soup.corner_uv.begin(), soup.corner_uv.end(), is_finite))
    refuse_damaged(file, "a texture coordinate is no number");
}

}  // namespace

void refuse_damaged(const std::string& file, const std::string& what) {
  throw Error(ErrorKind::Read, file + " is damaged: " + what + "; open an earlier copy of it.");
}

StoredShape shape_of(const Mesh& mesh) {
  StoredShape shape;
  PolygonSoup& soup = shape.soup;
  for (const VertexId v : mesh.vertices()) soup.points.push_back(mesh.position(v));
  for (const FaceId f : mesh.faces()) {
    for (const HalfedgeId h : mesh.halfedges(f)) {
      soup.corners.push_back(mesh.from(h).value);
      if (mesh.has_uv()) soup.corner_uv.push_back(mesh.uv(h));
    }
    soup.face_begin.push_back(static_cast<int>(soup.corners.size()));
    soup.face_material.push_back(mesh.material(f));
    shape.face_source.push_back(mesh.face_source(f));
    shape.is_flipped.push_back(mesh.is_flipped(f));
  }
  const auto is_none = [](int material) { return material < 0; };
  if (std::all_of(soup.face_material.begin(), soup.face_material.end(), is_none)) soup.face_material.clear();
  return shape;
}

std::string shape_bytes(const StoredShape& shape) {
  const PolygonSoup& soup = shape.soup;
  const Counts counts{soup.points.size(),     soup.face_begin.size(),    soup.corners.size(),
                      soup.corner_uv.size(),  soup.face_material.size(), shape.face_source.size(),
                      shape.is_flipped.size()};
  std::string bytes(kMark);
  bytes.append(reinterpret_cast<const char*>(counts.data()), sizeof counts);
  append(bytes, soup.points);
  append(bytes, soup.face_begin);
  append(bytes, soup.corners);
  append(bytes, soup.corner_uv);
  append(bytes, soup.face_material);
  append(bytes, shape.face_source);
  for (const bool is_flipped : shape.is_flipped) bytes.push_back(is_flipped ? '\1' : '\0');
  return bytes;
}

StoredShape parse_shape(std::string_view bytes, const std::string& file) {
  Counts counts{};
  if (!bytes.starts_with(kMark) || bytes.size() < kMark.size() + sizeof counts)
    refuse_damaged(file, "its mesh is not what it should be");
  std::memcpy(counts.data(), bytes.data() + kMark.size(), sizeof counts);
  bytes.remove_prefix(kMark.size() + sizeof counts);
  if (!fits(counts, bytes.size())) refuse_damaged(file, "its mesh is cut short or longer than it says");
  StoredShape shape;
  PolygonSoup& soup = shape.soup;
  soup.points = take<glm::dvec3>(bytes, counts[Points]);
  soup.face_begin = take<int>(bytes, counts[Faces]);
  soup.corners = take<int>(bytes, counts[Corners]);
  soup.corner_uv = take<glm::dvec2>(bytes, counts[Uv]);
  soup.face_material = take<int>(bytes, counts[Materials]);
  shape.face_source = take<int>(bytes, counts[Sources]);
  for (const char flag : bytes) shape.is_flipped.push_back(flag != 0);
  check(soup, file);
  return shape;
}

}  // namespace netwright
