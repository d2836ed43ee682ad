// The proof in JSON: plain lists of numbers, each step as its kind and two numbers.
#include "core/project/proof_file.h"

#include <array>
#include <limits>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/project/json_fields.h"

namespace netwright {
namespace {

using Node = ImpossibilityProof::Node;
using Step = ImpossibilityProof::Step;

constexpr int kFormat = 1;
constexpr std::size_t kMostBytes = 200'000'000;
constexpr int kMostNumber = std::numeric_limits<int>::max();

Json list(const std::vector<int>& numbers) {
  Json json{Json::Array{}};
  for (const int number : numbers) json.add(number);
  return json;
}

Json points_json(const Mesh& mesh) {
  Json json{Json::Array{}};
  for (const VertexId v : mesh.vertices())
    for (int k = 0; k < 3; ++k) json.add(mesh.position(v)[k]);
  return json;
}

Json faces_json(const Mesh& mesh) {
  Json json{Json::Array{}};
  for (const FaceId f : mesh.faces()) {
    std::vector<int> corners;
    for (const HalfedgeId h : mesh.halfedges(f)) corners.push_back(mesh.from(h).value);
    json.add(list(corners));
  }
  return json;
}

Json regions_json(const ImpossibilityProof& proof) {
  Json json{Json::Array{}};
  for (const ImpossibilityProof::Region& region : proof.regions) {
    std::vector<int> faces;
    for (const FaceId f : region.faces) faces.push_back(f.value);
    Json joins{Json::Array{}};
    for (const std::vector<int>& one : region.joins) joins.add(list(one));
    Json entry;
    entry.set("faces", list(faces));
    entry.set("joins", std::move(joins));
    json.add(std::move(entry));
  }
  return json;
}

/// An edge as a face and a corner; the other steps as they are.
Node in_file(const Mesh& mesh, const Node& node) {
  if (node.step != Step::Hinge) return node;
  const HalfedgeId h = mesh.halfedge(EdgeId(node.a));
  return {node.step, mesh.face(h).value, h.value - mesh.first(mesh.face(h)).value};
}

/// An edge that is not there gets a number that the checker refuses.
Node from_file(const Mesh& mesh, const Node& node) {
  if (node.step != Step::Hinge) return node;
  const bool is_there = node.a >= 0 && static_cast<std::size_t>(node.a) < mesh.n_faces() && node.b >= 0 &&
                        node.b < mesh.degree(FaceId(node.a));
  if (!is_there) return {node.step, -1, 0};
  return {node.step, mesh.edge(HalfedgeId(mesh.first(FaceId(node.a)).value + node.b)).value, 0};
}

PolygonSoup read_shape(JsonFields& fields) {
  PolygonSoup soup;
  soup.name = fields.text("model", "");
  const std::vector<double> points = fields.numbers("points", -1e300, 1e300);
  if (points.size() % 3 != 0) fields.refuse("points", "ends within a point");
  for (std::size_t i = 0; i < points.size(); i += 3)
    soup.points.emplace_back(points[i], points[i + 1], points[i + 2]);
  const int last = static_cast<int>(soup.points.size()) - 1;
  for (const std::vector<int>& face : fields.integer_lists("faces", 0, last)) soup.add_face(face);
  return soup;
}

ImpossibilityProof::Region read_region(const Json& json, const std::string& file) {
  JsonFields fields(&json, file, "regions");
  ImpossibilityProof::Region region;
  for (const int f : fields.integers("faces", 0, kMostNumber)) region.faces.emplace_back(f);
  region.joins = fields.integer_lists("joins", 0, kMostNumber);
  fields.finish();
  return region;
}

std::vector<Node> read_steps(JsonFields& fields, const Mesh& mesh) {
  const std::vector<int> numbers = fields.integers("steps", 0, kMostNumber);
  if (numbers.size() % 3 != 0) fields.refuse("steps", "ends within a step");
  std::vector<Node> nodes;
  for (std::size_t i = 0; i < numbers.size(); i += 3) {
    if (numbers[i] > static_cast<int>(Step::Topology))
      fields.refuse("steps", "has a step of an unknown kind");
    nodes.push_back(from_file(mesh, {static_cast<Step>(numbers[i]), numbers[i + 1], numbers[i + 2]}));
  }
  return nodes;
}

}  // namespace

bool has_proof_name(const std::filesystem::path& path) {
  return path.extension() == "." + std::string(kProofExtension);
}

void write_proof(const std::filesystem::path& path, const Mesh& mesh, const ImpossibilityProof& proof) {
  std::vector<int> steps;
  for (const Node& node : proof.nodes) {
    const Node told = in_file(mesh, node);
    for (const int number : std::array{static_cast<int>(told.step), told.a, told.b}) steps.push_back(number);
  }
  Json json;
  json.set("netwright_proof", kFormat);
  json.set("model", mesh.name());
  json.set("points", points_json(mesh));
  json.set("faces", faces_json(mesh));
  json.set("regions", regions_json(proof));
  json.set("steps", list(steps));
  write_file(path, to_text(json) + "\n");
}

ProofFile read_proof(const std::filesystem::path& path) {
  const std::string file = path.string();
  const Json json = parse_json(read_file(path, kMostBytes), file);
  JsonFields fields(&json, file, "the proof");
  if (fields.integer("netwright_proof", 1, kMostNumber, 0) != kFormat)
    fields.refuse("netwright_proof", "is not of a format that this Netwright knows");
  const PolygonSoup soup = read_shape(fields);
  if (soup.n_faces() == 0) fields.refuse("faces", "is empty");
  ProofFile read{Mesh(soup), {}};
  if (const Json::Array* regions = fields.array("regions"))
    for (const Json& region : *regions) read.proof.regions.push_back(read_region(region, file));
  read.proof.nodes = read_steps(fields, read.mesh);
  fields.finish();
  return read;
}

}  // namespace netwright
