// Wavefront OBJ with its material library, through tinyobjloader's callbacks, which keep polygons of any
// size. A first pass over the text cleans it and reads the coordinates itself: the library turns "nan" and
// other words into 0 without telling, and its own decimal conversion is off in the last digits.
#include <tiny_obj_loader.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "core/mesh/pictures.h"
#include "core/mesh/readers.h"
#include "core/mesh/words.h"

namespace netwright::readers {
namespace {

struct CleanText {
  std::string text;                ///< one statement per line, no trailing blanks
  std::vector<glm::dvec3> points;  ///< as written
  std::vector<int> face_line;      ///< line number of each face in the file
};

std::string at_line(int line) { return "line " + std::to_string(line); }

double coordinate(const std::string& name, std::string_view word, std::size_t point, int line) {
  const std::string place = "point " + std::to_string(point) + " (" + at_line(line) + ")";
  if (word.empty()) {
    refuse(name, place + " has fewer than three coordinates; the file is damaged, export it again.");
  }
  const std::optional<double> value = parse_number(word);
  if (!value) {
    refuse(name, place + " has the coordinate \"" + std::string(word.substr(0, 20)) +
                     "\", which is not a finite number; repair the point or export the model again.");
  }
  return *value;
}

void clean_line(const std::string& name, std::string_view line, int number, CleanText& clean) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return;
  line.remove_prefix(begin);
  const std::string_view body = line;
  const std::string_view keyword = next_word(line);
  if (keyword == "v") {
    glm::dvec3 p;
    for (int i = 0; i < 3; ++i) p[i] = coordinate(name, next_word(line), clean.points.size() + 1, number);
    clean.points.push_back(p);
  } else if (keyword == "f") {
    if (line.empty()) refuse(name, at_line(number) + " is a face without corners; delete the line.");
    clean.face_line.push_back(number);
  }
  clean.text.append(body).push_back('\n');
}

CleanText clean(const std::string& name, std::string_view text) {
  CleanText clean;
  clean.text.reserve(text.size() + 1);
  std::string joined;
  int number = 0;
  while (!text.empty()) {
    ++number;
    std::string_view line = next_line(text);
    const std::size_t last = line.find_last_not_of(" \t");
    line = line.substr(0, last == std::string_view::npos ? 0 : last + 1);
    if (line.ends_with('\\')) {
      joined.append(line.substr(0, line.size() - 1)).push_back(' ');
      continue;
    }
    if (joined.empty()) {
      clean_line(name, line, number, clean);
    } else {
      clean_line(name, joined.append(line), number, clean);
      joined.clear();
    }
  }
  if (!joined.empty()) clean_line(name, joined, number, clean);
  return clean;
}

/// Hands material libraries to tinyobjloader by their names, and keeps what it made of them.
class MaterialLibraries : public tinyobj::MaterialReader {
 public:
  MaterialLibraries(const CompanionLookup& companions, std::vector<std::string>& notices)
      : companions_(companions), notices_(notices) {}

  bool operator()(const std::string& library, std::vector<tinyobj::material_t>* materials,
                  std::map<std::string, int>* index, std::string* warning, std::string* error) override {
    const std::optional<std::string> text = companions_ ? companions_(library) : std::nullopt;
    if (!text) {
      notices_.push_back("The material library " + library +
                         " was not found; colours and pictures are left out.");
      return false;
    }
    std::istringstream stream(*text);
    tinyobj::LoadMtl(index, materials, &stream, warning, error);
    found_ = *materials;
    return true;
  }

  [[nodiscard]] const std::vector<tinyobj::material_t>& found() const { return found_; }

 private:
  const CompanionLookup& companions_;
  std::vector<std::string>& notices_;
  std::vector<tinyobj::material_t> found_;
};

/// Collects what the callbacks bring.
struct Collector {
  const std::string& name;
  const CleanText& clean;
  PolygonSoup soup;
  int n_points = 0;  ///< read so far: negative indices count back from here
  int material = -1;
  bool has_uv = false;
  bool has_bad_uv = false;
  std::vector<glm::dvec2> uv;

  [[nodiscard]] std::string place() const {
    const auto f = static_cast<std::size_t>(soup.n_faces());
    return "face " + std::to_string(f + 1) + " (" + at_line(clean.face_line.at(f)) + ")";
  }

  [[nodiscard]] int point_index(int written) const {
    const int index = written > 0 ? written - 1 : n_points + written;
    if (written == 0) {
      refuse(name,
             place() +
                 " has a corner without a valid point number; points count from 1, export the model again.");
    }
    if (index < 0 || index >= static_cast<int>(clean.points.size())) {
      refuse(name, place() + " names point " + std::to_string(written) + ", but the file has only " +
                       std::to_string(clean.points.size()) +
                       "; the file was cut short or damaged, export it again.");
    }
    return index;
  }

  void add_face(std::span<const tinyobj::index_t> corners) {
    if (corners.size() < 3) {
      refuse(name, place() + " has only " + std::to_string(corners.size()) +
                       " corners; delete it in a modelling program.");
    }
    for (const tinyobj::index_t& corner : corners) {
      soup.corners.push_back(point_index(corner.vertex_index));
      const int written = corner.texcoord_index;
      const int index = written > 0 ? written - 1 : static_cast<int>(uv.size()) + written;
      const bool is_there = written != 0 && index >= 0 && index < static_cast<int>(uv.size());
      has_uv |= is_there;
      has_bad_uv |= written != 0 && !is_there;
      soup.corner_uv.push_back(is_there ? uv[static_cast<std::size_t>(index)] : glm::dvec2(0));
    }
    soup.face_begin.push_back(static_cast<int>(soup.corners.size()));
    soup.face_material.push_back(material);
  }
};

Collector& self(void* data) { return *static_cast<Collector*>(data); }

tinyobj::callback_t callbacks() {
  tinyobj::callback_t calls;
  calls.vertex_cb = [](void* data, double, double, double, double) { ++self(data).n_points; };
  calls.texcoord_cb = [](void* data, double u, double v, double) { self(data).uv.emplace_back(u, v); };
  calls.usemtl_cb = [](void* data, const char*, int material) { self(data).material = material; };
  calls.index_cb = [](void* data, tinyobj::index_t* corners, int n) {
    self(data).add_face(std::span(corners, static_cast<std::size_t>(n)));
  };
  return calls;
}

void add_materials(PolygonSoup& soup, const std::vector<tinyobj::material_t>& found,
                   const CompanionLookup& companions) {
  Pictures pictures(companions);
  for (const tinyobj::material_t& material : found) {
    Material mine{.name = material.name,
                  .colour = {material.diffuse[0], material.diffuse[1], material.diffuse[2]},
                  .texture = nullptr};
    const std::string& file = material.diffuse_texname;
    if (!file.empty()) mine.texture = pictures.from_file(file);
    soup.materials.push_back(std::move(mine));
  }
  for (std::string& notice : pictures.notices()) soup.notices.push_back(std::move(notice));
}

}  // namespace

PolygonSoup read_obj(const std::string& name, std::string_view bytes, const CompanionLookup& companions) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const CleanText text = clean(name, bytes);
  Collector collector{.name = name, .clean = text, .soup = {}, .uv = {}};
  MaterialLibraries libraries(companions, collector.soup.notices);
  std::istringstream stream(text.text);
  std::string warning;
  std::string error;
  if (!tinyobj::LoadObjWithCallback(stream, callbacks(), &collector, &libraries, &warning, &error)) {
    refuse(name, "this is not a readable OBJ file (" + error + "); export the model again.");
  }
  PolygonSoup soup = std::move(collector.soup);
  soup.points = text.points;
  if (collector.has_bad_uv) {
    soup.notices.emplace_back("Some corners name texture coordinates that the file does not have.");
  }
  if (!collector.has_uv) soup.corner_uv.clear();
  const bool has_material =
      std::ranges::any_of(soup.face_material, [](int material) { return material >= 0; });
  if (has_material) {
    add_materials(soup, libraries.found(), companions);
  } else {
    soup.face_material.clear();
  }
  return soup;
}

}  // namespace netwright::readers
