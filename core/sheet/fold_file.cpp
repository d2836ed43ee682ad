// FOLD 1.2 out and in. Reading trusts nothing: every type, length and index is checked before it is used.
#include "core/sheet/fold_file.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/json.h"

namespace netwright {

namespace {

constexpr std::size_t kMostBytes = 256'000'000;
constexpr double kDegreesPerRadian = 180 / std::numbers::pi;

template <class Items, class ToJson>
Json json_list(const Items& items, const ToJson& to_json) {
  Json::Array list;
  list.reserve(items.size());
  for (const auto& item : items) list.push_back(to_json(item));
  return list;
}

Json number_list(const std::vector<int>& numbers) {
  return json_list(numbers, [](int number) { return Json(number); });
}

/// Access to one file's values that speaks of the file, the key and the entry when something is wrong.
class Reader {
 public:
  Reader(std::string name, const Json& root) : name_(std::move(name)), root_(root) {}

  [[noreturn]] void refuse(const std::string& what) const {
    throw Error(ErrorKind::Read, name_ + " is not a net that can be read: " + what + ".");
  }

  [[nodiscard]] const Json::Array& list(const Json& frame, const std::string& key) const {
    const Json* const value = frame.find(key);
    if (value == nullptr) refuse("the key \"" + key + "\" is missing");
    if (value->array() == nullptr) refuse("\"" + key + "\" is not a list");
    return *value->array();
  }

  /// The entry of a list that must itself be a list of at least so many items.
  [[nodiscard]] const Json::Array& row(const Json::Array& rows, std::size_t i, const std::string& key,
                                       std::size_t least, std::size_t most) const {
    const Json::Array* const row = rows[i].array();
    if (row == nullptr || row->size() < least || row->size() > most)
      refuse(entry(key, i) + " is not a list of " + std::to_string(least) +
             (most == least ? ""
              : most > 1000 ? " or more"
                            : " or " + std::to_string(most)) +
             " numbers");
    return *row;
  }

  [[nodiscard]] double number(const Json& value, const std::string& key, std::size_t i) const {
    const auto number = value.number();
    if (!number || !std::isfinite(*number)) refuse(entry(key, i) + " holds something that is not a number");
    return *number;
  }

  [[nodiscard]] int index(const Json& value, const std::string& key, std::size_t i, std::size_t count) const {
    const auto number = value.integer();
    if (!number) refuse(entry(key, i) + " holds something that is not a whole number");
    if (*number < 0 || *number >= static_cast<std::int64_t>(count))
      refuse(entry(key, i) + " names vertex " + std::to_string(*number) + ", but there are " +
             std::to_string(count) + " (counted from 0)");
    return static_cast<int>(*number);
  }

  void same_length(const std::string& key, std::size_t size, const std::string& other,
                   std::size_t other_size) const {
    if (size != other_size)
      refuse("\"" + key + "\" has " + std::to_string(size) + " entries where \"" + other + "\" has " +
             std::to_string(other_size));
  }

  static std::string entry(const std::string& key, std::size_t i) {
    return "entry " + std::to_string(i) + " of \"" + key + "\"";
  }

  /// The frame that says where the vertices are on the model.
  [[nodiscard]] const Json& folded_frame() const {
    for (const Json& frame : list(root_, "file_frames")) {
      const Json* const classes = frame.find("frame_classes");
      if (classes == nullptr || classes->array() == nullptr) continue;
      for (const Json& name : *classes->array())
        if (name.text() != nullptr && *name.text() == "foldedForm") return frame;
    }
    refuse("it has no frame of class \"foldedForm\", so there is no model to compare with");
  }

 private:
  std::string name_;
  const Json& root_;
};

void read_points(FlatNet& net, const Reader& reader, const Json& root) {
  const std::string key = "vertices_coords";
  const Json::Array& flat = reader.list(root, key);
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const Json::Array& row = reader.row(flat, i, key, 2, 3);
    if (row.size() == 3 && reader.number(row[2], key, i) != 0)
      reader.refuse(Reader::entry(key, i) + " does not lie in the plane");
    net.points.emplace_back(reader.number(row[0], key, i), reader.number(row[1], key, i));
  }
  const Json::Array& folded = reader.list(reader.folded_frame(), key);
  reader.same_length("vertices_coords of the folded form", folded.size(), key, flat.size());
  for (std::size_t i = 0; i < folded.size(); ++i) {
    const Json::Array& row = reader.row(folded, i, key, 3, 3);
    net.folded.emplace_back(reader.number(row[0], key, i), reader.number(row[1], key, i),
                            reader.number(row[2], key, i));
  }
}

void read_faces(FlatNet& net, const Reader& reader, const Json& root) {
  const std::string key = "faces_vertices";
  const Json::Array& faces = reader.list(root, key);
  if (faces.empty()) reader.refuse("it has no faces");
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Json::Array& row = reader.row(faces, i, key, 3, faces.max_size());
    std::vector<int>& face = net.faces.emplace_back();
    for (const Json& corner : row) face.push_back(reader.index(corner, key, i, net.points.size()));
  }
  const std::string source_key = "netwright:face_source";
  for (std::size_t i = 0; i < faces.size(); ++i) net.face_source.push_back(static_cast<int>(i));
  if (root.find(source_key) == nullptr) return;
  const Json::Array& sources = reader.list(root, source_key);
  reader.same_length(source_key, sources.size(), key, faces.size());
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto source = sources[i].integer();
    if (!source || *source < 0 || *source > INT32_MAX)
      reader.refuse(Reader::entry(source_key, i) + " is not the number of a face");
    net.face_source[i] = static_cast<int>(*source);
  }
}

Assignment read_assignment(const Reader& reader, const Json& value, std::size_t i) {
  const std::string* const letter = value.text();
  for (const Assignment known :
       {Assignment::Mountain, Assignment::Valley, Assignment::Flat, Assignment::Boundary})
    if (letter != nullptr && letter->size() == 1 && letter->front() == static_cast<char>(known)) return known;
  reader.refuse(Reader::entry("edges_assignment", i) + " is none of M, V, F and B");
}

void read_edges(FlatNet& net, const Reader& reader, const Json& root) {
  const std::string key = "edges_vertices";
  const Json::Array& ends = reader.list(root, key);
  const Json::Array& letters = reader.list(root, "edges_assignment");
  const Json::Array& angles = reader.list(root, "edges_foldAngle");
  reader.same_length("edges_assignment", letters.size(), key, ends.size());
  reader.same_length("edges_foldAngle", angles.size(), key, ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Json::Array& row = reader.row(ends, i, key, 2, 2);
    FlatNet::Edge& edge = net.edges.emplace_back();
    edge.from = reader.index(row[0], key, i, net.points.size());
    edge.to = reader.index(row[1], key, i, net.points.size());
    edge.assignment = read_assignment(reader, letters[i], i);
    edge.fold_angle_rad = reader.number(angles[i], "edges_foldAngle", i) / kDegreesPerRadian;
  }
}

}  // namespace

std::string fold_text(const FlatNet& net) {
  Json folded;
  folded.set("frame_classes", Json::Array{"foldedForm"});
  folded.set("frame_parent", 0);
  folded.set("frame_inherit", true);
  folded.set("frame_unit", "unit");
  folded.set("vertices_coords", json_list(net.folded, [](glm::dvec3 p) {
               return Json(Json::Array{p.x, p.y, p.z});
             }));

  Json file;
  file.set("file_spec", 1.2);
  file.set("file_creator", "Netwright");
  file.set("file_title", net.title);
  file.set("file_classes", Json::Array{"singleModel"});
  file.set("frame_classes", Json::Array{"creasePattern"});
  file.set("frame_attributes", Json::Array{"2D"});
  file.set("frame_unit", "mm");
  file.set("vertices_coords", json_list(net.points, [](glm::dvec2 p) {
             return Json(Json::Array{p.x, p.y});
           }));
  file.set("edges_vertices", json_list(net.edges, [](const FlatNet::Edge& e) {
             return Json(Json::Array{e.from, e.to});
           }));
  file.set("edges_assignment", json_list(net.edges, [](const FlatNet::Edge& e) {
             return Json(std::string(1, static_cast<char>(e.assignment)));
           }));
  file.set("edges_foldAngle", json_list(net.edges, [](const FlatNet::Edge& e) {
             return Json(e.fold_angle_rad * kDegreesPerRadian);
           }));
  file.set("faces_vertices", json_list(net.faces, number_list));
  file.set("netwright:face_source", number_list(net.face_source));
  file.set("file_frames", Json::Array{std::move(folded)});
  return to_text(file, {.is_indented = true, .significant_digits = 17}) + "\n";
}

void write_fold(const std::filesystem::path& path, const FlatNet& net) { write_file(path, fold_text(net)); }

FlatNet parse_fold(std::string_view text, const std::string& name) {
  const Json root = parse_json(text, name);
  const Reader reader(name, root);
  if (root.object() == nullptr) reader.refuse("it is not a FOLD file, which starts with {");
  FlatNet net;
  if (const Json* const title = root.find("file_title"); title != nullptr && title->text() != nullptr)
    net.title = *title->text();
  read_points(net, reader, root);
  read_faces(net, reader, root);
  read_edges(net, reader, root);
  return net;
}

FlatNet read_fold(const std::filesystem::path& path) {
  return parse_fold(read_file(path, kMostBytes), path.string());
}

}  // namespace netwright
