// A soup's shape as bytes, for the pipe from the helper program: 'S', three counts, then the arrays as they
// lie in memory (both ends are the same build). The receiving end believes nothing.
#include <array>
#include <cstdint>
#include <cstring>

#include "core/base/error.h"
#include "core/mesh/readers.h"

namespace netwright::readers {
namespace {

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

bool is_sound(const PolygonSoup& soup) {
  if (soup.face_begin.empty() || soup.face_begin.front() != 0) return false;
  for (std::size_t f = 1; f < soup.face_begin.size(); ++f) {
    if (soup.face_begin[f] < soup.face_begin[f - 1]) return false;
  }
  return soup.face_begin.back() == static_cast<int>(soup.corners.size());
}

}  // namespace

std::string pack(const PolygonSoup& soup) {
  const std::array<std::uint64_t, 3> counts{soup.points.size(), soup.face_begin.size(), soup.corners.size()};
  std::string bytes = "S";
  bytes.append(reinterpret_cast<const char*>(counts.data()), sizeof counts);
  append(bytes, soup.points);
  append(bytes, soup.face_begin);
  append(bytes, soup.corners);
  return bytes;
}

PolygonSoup unpack(const std::string& name, std::string_view packed) {
  PolygonSoup soup;
  std::array<std::uint64_t, 3> counts{};
  if (packed.size() > sizeof counts && packed.front() == 'S') {
    std::memcpy(counts.data(), packed.data() + 1, sizeof counts);
    packed.remove_prefix(1 + sizeof counts);
    const std::uint64_t limit = packed.size();
    if (counts[0] <= limit && counts[1] <= limit && counts[2] <= limit &&
        counts[0] * sizeof(glm::dvec3) + (counts[1] + counts[2]) * sizeof(int) == limit) {
      soup.points = take<glm::dvec3>(packed, counts[0]);
      soup.face_begin = take<int>(packed, counts[1]);
      soup.corners = take<int>(packed, counts[2]);
      if (is_sound(soup)) return soup;
    }
  }
  throw Error(ErrorKind::Read,
              name + ": the helper that reads this format gave no sensible answer; export it as OBJ.");
}

}  // namespace netwright::readers
