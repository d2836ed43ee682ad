// OFF, read by our own code: Assimp drops polygons of more than nine corners and bends indices that are out
// of range, both without a word. Faces may carry a colour behind their corners, points (in COFF files) one
// behind their place; normals are left out.
#include <optional>
#include <utility>
#include <vector>

#include "core/mesh/face_colours.h"
#include "core/mesh/readers.h"
#include "core/mesh/words.h"

namespace netwright::readers {
namespace {

/// Walks over the words of the file, lines without their comments.
class OffWords {
 public:
  explicit OffWords(std::string_view bytes) : rest_(bytes) {}

  /// The next word, on this line or a later one; empty at the end.
  std::string_view next() {
    std::string_view word = next_word(line_);
    while (word.empty() && !rest_.empty()) {
      line_ = next_line(rest_);
      line_ = line_.substr(0, line_.find('#'));
      word = next_word(line_);
    }
    return word;
  }
  /// Leaves the line and hands out what stood behind the last word.
  std::string_view end_line() { return std::exchange(line_, {}); }

 private:
  std::string_view rest_;
  std::string_view line_;
};

using Colour = std::optional<glm::dvec3>;  // sRGB, 0…1

struct Header {
  std::uint64_t points = 0;
  std::uint64_t faces = 0;
  bool has_normals = false;
  bool has_colours = false;  ///< of points
};

/// Red, green and blue as whole numbers up to 255 or with a point up to 1; none for anything else, such as
/// the number of a colour in a table of the reader's.
Colour read_colour(std::string_view line) {
  glm::dvec3 colour;
  bool is_fraction = false;
  for (int i = 0; i < 3; ++i) {
    const std::string_view word = next_word(line);
    const std::optional<double> value = parse_number(word);
    if (!value || *value < 0) return std::nullopt;
    is_fraction |= word.find('.') != std::string_view::npos;
    colour[i] = *value;
  }
  return is_fraction ? colour : colour / 255.0;
}

Header read_header(const std::string& name, OffWords& words, std::size_t n_bytes) {
  std::string_view word = words.next();
  const std::string_view kind = word.ends_with("OFF") ? word : std::string_view();
  if (word.starts_with('4') || word.starts_with('n')) {
    refuse(name, "it describes a shape in more than three dimensions; open a model in three.");
  }
  if (word.ends_with("OFF")) word = words.next();
  if (word == "BINARY") refuse(name, "binary OFF files cannot be read; export it as text.");
  const std::optional<std::uint64_t> points = parse_count(word);
  const std::optional<std::uint64_t> faces = parse_count(words.next());
  if (!points || !faces) {
    refuse(name, "its first lines do not say how many points and faces it holds; export it again.");
  }
  words.end_line();
  constexpr std::uint64_t kPoint = 6;  // "0 0 0\n" is the shortest point
  constexpr std::uint64_t kFace = 4;   // "1 0\n" is the shortest face
  if (*points > n_bytes / kPoint || *faces > (n_bytes - *points * kPoint) / kFace) {
    refuse(name,
           "its header promises " + std::to_string(*points) + " points and " + std::to_string(*faces) +
               " faces, but the file is too short for them; it was cut short or damaged, export it again.");
  }
  const auto has = [&](char mark) { return kind.find(mark) != std::string_view::npos; };
  return {*points, *faces, has('N'), has('C')};
}

[[noreturn]] void refuse_end(const std::string& name, const std::string& where) {
  refuse(name, "it ends in the middle of " + where + "; the file was cut short, export it again.");
}

glm::dvec3 read_point(const std::string& name, OffWords& words, std::uint64_t number, const Header& header,
                      Colour& colour) {
  const std::string place = "point " + std::to_string(number);
  glm::dvec3 p;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = words.next();
    if (word.empty()) refuse_end(name, place);
    const std::optional<double> value = parse_number(word);
    if (!value) {
      refuse(name, place + " has the coordinate \"" + std::string(word.substr(0, 20)) +
                       "\", which is not a finite number; repair the point or export the model again.");
    }
    p[axis] = *value;
  }
  std::string_view behind = words.end_line();
  for (int i = 0; header.has_normals && i < 3; ++i) next_word(behind);
  if (header.has_colours) colour = read_colour(behind);
  return p;
}

std::vector<int> read_face(const std::string& name, OffWords& words, std::uint64_t number,
                           std::uint64_t n_points, Colour& colour) {
  const std::string place = "face " + std::to_string(number);
  const std::string_view first = words.next();
  if (first.empty()) refuse_end(name, place);
  const std::optional<std::uint64_t> n_corners = parse_count(first);
  if (!n_corners)
    refuse(name, place + " does not say how many corners it has; the file is damaged, export it again.");
  std::vector<int> corners;
  for (std::uint64_t k = 0; k < *n_corners; ++k) {
    const std::string_view word = words.next();
    if (word.empty()) refuse_end(name, place);
    const std::optional<std::uint64_t> point = parse_count(word);
    if (!point || *point >= n_points) {
      refuse(name, place + " names point " + std::string(word.substr(0, 20)) + ", but there are only " +
                       std::to_string(n_points) + ", counted from 0; the file is damaged, export it again.");
    }
    corners.push_back(static_cast<int>(*point));
  }
  colour = read_colour(words.end_line());
  return corners;
}

/// Of a face's points; none when one of them has no colour.
Colour mean_colour(std::span<const int> corners, const std::vector<Colour>& point_colours) {
  glm::dvec3 mean(0);
  for (const int corner : corners) {
    const Colour& colour = point_colours[static_cast<std::size_t>(corner)];
    if (!colour) return std::nullopt;
    mean += *colour / static_cast<double>(corners.size());
  }
  return corners.empty() ? std::nullopt : Colour(mean);
}

}  // namespace

PolygonSoup read_off(const std::string& name, std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  OffWords words(bytes);
  const Header header = read_header(name, words, bytes.size());
  PolygonSoup soup;
  std::vector<Colour> point_colours;
  for (std::uint64_t i = 1; i <= header.points; ++i) {
    Colour& colour = point_colours.emplace_back();
    soup.points.push_back(read_point(name, words, i, header, colour));
  }
  std::vector<Colour> face_colours;
  for (std::uint64_t f = 1; f <= header.faces; ++f) {
    Colour& colour = face_colours.emplace_back();
    soup.add_face(read_face(name, words, f, header.points, colour));
    if (!colour) colour = mean_colour(soup.face(soup.n_faces() - 1), point_colours);
  }
  colour_faces(soup, face_colours);
  return soup;
}

}  // namespace netwright::readers
