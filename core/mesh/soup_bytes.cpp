// A model as bytes, for the pipe from the helper program: 'S', the counts, the arrays as they lie in memory
// (both ends are the same build), then materials and pictures. The receiving end believes nothing.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "core/base/error.h"
#include "core/mesh/readers.h"

namespace netwright::readers {
namespace {

/// Of points, face_begin, corners, corner_uv, face_material, materials, pictures.
using Counts = std::array<std::uint64_t, 7>;

template <class T>
void append(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T>
void append(std::string& bytes, const std::vector<T>& items) {
  bytes.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(T));
}

void append(std::string& bytes, const std::string& text) {
  append(bytes, std::uint64_t{text.size()});
  bytes += text;
}

/// Takes values off the front; once something is missing it stays failed.
class Taker {
 public:
  explicit Taker(std::string_view bytes) : rest_(bytes) {}

  template <class T>
  std::vector<T> items(std::uint64_t count) {
    if (count > rest_.size() / sizeof(T)) return fail<std::vector<T>>();
    std::vector<T> items(count);
    if (count > 0) std::memcpy(static_cast<void*>(items.data()), rest_.data(), count * sizeof(T));
    rest_.remove_prefix(count * sizeof(T));
    return items;
  }
  template <class T>
  T value() {
    const std::vector<T> one = items<T>(1);
    return one.empty() ? T{} : one.front();
  }
  std::string text() {
    const auto size = value<std::uint64_t>();
    if (size > rest_.size()) return fail<std::string>();
    std::string text(rest_.substr(0, size));
    rest_.remove_prefix(size);
    return text;
  }
  [[nodiscard]] bool is_over() const { return !has_failed_ && rest_.empty(); }
  [[nodiscard]] bool can_hold(std::uint64_t count) const { return count <= rest_.size(); }

 private:
  template <class T>
  T fail() {
    has_failed_ = true;
    rest_ = {};
    return {};
  }
  std::string_view rest_;
  bool has_failed_ = false;
};

bool is_sound(const ParsedModel& model) {
  const PolygonSoup& soup = model.soup;
  if (soup.face_begin.empty() || soup.face_begin.front() != 0) return false;
  for (std::size_t f = 1; f < soup.face_begin.size(); ++f) {
    if (soup.face_begin[f] < soup.face_begin[f - 1]) return false;
  }
  const auto within = [](const std::vector<int>& indices, std::size_t size) {
    return std::ranges::all_of(indices, [&](int i) { return i >= -1 && i < static_cast<int>(size); });
  };
  return soup.face_begin.back() == static_cast<int>(soup.corners.size()) &&
         (soup.corner_uv.empty() || soup.corner_uv.size() == soup.corners.size()) &&
         (soup.face_material.empty() || soup.face_material.size() + 1 == soup.face_begin.size()) &&
         within(soup.face_material, soup.materials.size()) && within(model.picture_of, model.pictures.size());
}

}  // namespace

std::string pack(const ParsedModel& model) {
  const PolygonSoup& soup = model.soup;
  std::string bytes = "S";
  append(bytes, Counts{soup.points.size(), soup.face_begin.size(), soup.corners.size(), soup.corner_uv.size(),
                       soup.face_material.size(), soup.materials.size(), model.pictures.size()});
  append(bytes, soup.points);
  append(bytes, soup.face_begin);
  append(bytes, soup.corners);
  append(bytes, soup.corner_uv);
  append(bytes, soup.face_material);
  for (std::size_t m = 0; m < soup.materials.size(); ++m) {
    append(bytes, soup.materials[m].name);
    append(bytes, soup.materials[m].colour);
    append(bytes, m < model.picture_of.size() ? model.picture_of[m] : -1);
  }
  for (const ParsedModel::Picture& picture : model.pictures) {
    append(bytes, picture.name);
    append(bytes, picture.bytes);
  }
  return bytes;
}

ParsedModel unpack(const std::string& name, std::string_view packed) {
  ParsedModel model;
  PolygonSoup& soup = model.soup;
  if (packed.starts_with('S')) {
    Taker taker(packed.substr(1));
    const auto counts = taker.value<Counts>();
    soup.points = taker.items<glm::dvec3>(counts[0]);
    soup.face_begin = taker.items<int>(counts[1]);
    soup.corners = taker.items<int>(counts[2]);
    soup.corner_uv = taker.items<glm::dvec2>(counts[3]);
    soup.face_material = taker.items<int>(counts[4]);
    for (std::uint64_t m = 0; m < counts[5] && taker.can_hold(counts[5] - m); ++m) {
      soup.materials.push_back({.name = taker.text(), .texture = nullptr});
      soup.materials.back().colour = taker.value<glm::dvec3>();
      model.picture_of.push_back(taker.value<int>());
    }
    for (std::uint64_t p = 0; p < counts[6] && taker.can_hold(counts[6] - p); ++p) {
      std::string label = taker.text();
      model.pictures.push_back({std::move(label), taker.text()});
    }
    const bool is_whole = soup.materials.size() == counts[5] && model.pictures.size() == counts[6];
    if (taker.is_over() && is_whole && is_sound(model)) return model;
  }
  throw Error(ErrorKind::Read,
              name + ": the helper that reads this format gave no sensible answer; export it as OBJ.");
}

}  // namespace netwright::readers
