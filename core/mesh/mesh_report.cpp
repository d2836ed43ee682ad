// Turns counts into a report's figures and lines. Soup and mesh share every sentence.
#include "core/mesh/mesh_report.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <span>

#include "core/base/counted.h"
#include "core/base/predicates.h"
#include "core/mesh/formats.h"
#include "core/mesh/mesh.h"
#include "core/mesh/repair_findings.h"
#include "core/mesh/repair_topology.h"
#include "core/mesh/self_intersection.h"

namespace netwright {
namespace {

using Kind = MeshReport::Line::Kind;
using Topic = MeshReport::Topic;
using Line = MeshReport::Line;

constexpr std::array<std::string_view, 18> kTopicNames{"counts",
                                                       "shape",
                                                       "parts",
                                                       "borders",
                                                       "size",
                                                       "doubled_points",
                                                       "isolated_points",
                                                       "broken_faces",
                                                       "zero_area_faces",
                                                       "doubled_faces",
                                                       "non_manifold_edges",
                                                       "non_manifold_points",
                                                       "turned_faces",
                                                       "one_sided",
                                                       "uneven_faces",
                                                       "self_intersections",
                                                       "missing_textures",
                                                       "other"};

/// "faces 3, 8, 12 and 4 more", counted from 1 as in the file.
std::string number_list(const std::string& one, const std::string& many, std::span<const int> numbers) {
  constexpr std::size_t kShown = 5;
  std::string list = numbers.size() == 1 ? one + " " : many + " ";
  for (std::size_t i = 0; i < std::min(numbers.size(), kShown); ++i)
    list += (i > 0 ? ", " : "") + std::to_string(numbers[i] + 1);
  if (numbers.size() > kShown)
    list += " and " + grouped(static_cast<std::int64_t>(numbers.size() - kShown)) + " more";
  return list;
}

std::string face_list(std::span<const int> faces) { return number_list("face", "faces", faces); }

/// Three digits that matter: "0.0123", "83.1", "2 390".
std::string length_text(double length) {
  if (length >= 100 && length < 1e7) return grouped(std::llround(length));
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", length);
  return text.data();
}

void add_facts(MeshReport& report, bool has_shape) {
  report.lines.push_back(
      {Kind::Fact,
       counted(report.n_faces, "face", "faces") + ", " + counted(report.n_vertices, "corner", "corners"),
       Topic::Counts, report.n_faces});
  if (has_shape) {
    report.lines.push_back({Kind::Fact,
                            report.is_closed
                                ? "closed, genus " + std::to_string(report.genus)
                                : "open, " + counted(report.n_border_loops, "border", "borders") +
                                      ", genus " + std::to_string(report.genus),
                            Topic::Shape, report.genus});
  }
  if (report.n_components > 1) {
    report.lines.push_back({Kind::Fact,
                            grouped(report.n_components) + " separate parts; each becomes a piece of its own",
                            Topic::Parts, report.n_components});
  }
}

void add_uneven_faces(std::vector<int> faces, MeshReport& report) {
  report.n_uneven_faces = static_cast<int>(faces.size());
  if (faces.empty()) return;
  std::string text = counted(report.n_uneven_faces, "face is", "faces are") + " not flat, by up to " +
                     percent(report.worst_unevenness) + " of the face's size (" + face_list(faces) +
                     "); triangulate before unfolding.";
  report.lines.push_back(
      {Kind::Problem, std::move(text), Topic::UnevenFaces, report.n_uneven_faces, std::move(faces)});
}

/// `pairs` by the numbers of the file's faces.
void add_self_intersections(const SelfIntersections& found, MeshReport& report) {
  report.n_self_intersections = static_cast<int>(found.pairs.size());
  if (found.pairs.empty()) return;
  const auto& [a, b] = found.pairs.front();
  Line line{Kind::Notice,
            "The model cuts through itself in " + std::string(found.is_complete ? "" : "at least ") +
                counted(report.n_self_intersections, "place", "places") + ", first where faces " +
                std::to_string(a + 1) + " and " + std::to_string(b + 1) +
                " cross: it unfolds, but the paper cannot be glued through itself.",
            Topic::SelfIntersections, report.n_self_intersections};
  for (const auto& [first, second] : found.pairs) {
    line.faces.push_back(first);
    line.faces.push_back(second);
  }
  std::ranges::sort(line.faces);
  line.faces.erase(std::ranges::unique(line.faces).begin(), line.faces.end());
  report.lines.push_back(std::move(line));
}

/// Without culprits; the line is there only when there is a border.
Line* add_borders(MeshReport& report) {
  if (report.n_border_edges == 0) return nullptr;
  report.lines.push_back({Kind::Fact,
                          counted(report.n_border_loops, "border", "borders") + " of " +
                              counted(report.n_border_edges, "edge", "edges") + ", " +
                              length_text(report.border_length) + " long",
                          Topic::Borders, report.n_border_loops});
  return &report.lines.back();
}

/// Numbers of points lead to places.
void add_places(const PolygonSoup& soup, std::vector<Line>& lines) {
  const auto at = [&](int point) { return soup.points[static_cast<std::size_t>(point)]; };
  for (Line& line : lines) {
    for (const int point : line.points) line.point_places.push_back(at(point));
    for (const auto& [a, b] : line.edges) line.edge_places.push_back({at(a), at(b)});
  }
}

void add_size(const PolygonSoup& soup, MeshReport& report) {
  const UnitGuess unit = guess_unit(soup);
  report.lines.push_back(
      {Kind::Fact, size_text(report.size) + ", probably in " + std::string(unit.name), Topic::Size});
}

void add_points(const repair::Findings& found, MeshReport& report) {
  if (found.n_merged > 0) {
    report.lines.push_back({Kind::Notice,
                            repair::doubled_points_sentence(found.n_merged),
                            Topic::DoubledPoints,
                            found.n_merged,
                            {},
                            found.doubled_points});
  }
  const auto n_isolated = static_cast<int>(found.isolated_points.size());
  if (n_isolated > 0) {
    report.lines.push_back({Kind::Notice,
                            counted(n_isolated, "point belongs", "points belong") + " to no face (" +
                                number_list("point", "points", found.isolated_points) + ").",
                            Topic::IsolatedPoints,
                            n_isolated,
                            {},
                            found.isolated_points});
  }
}

void add_faces(Topic topic, const std::vector<int>& faces, const std::string& one, const std::string& many,
               MeshReport& report) {
  if (faces.empty()) return;
  const auto n = static_cast<int>(faces.size());
  report.lines.push_back(
      {Kind::Problem, counted(n, one, many) + " (" + face_list(faces) + ").", topic, n, faces});
}

void add_faults(const PolygonSoup& soup, const repair::Findings& found, MeshReport& report) {
  add_faces(Topic::BrokenFaces, found.broken_faces, "face names a corner twice or has fewer than three",
            "faces name a corner twice or have fewer than three", report);
  add_faces(Topic::ZeroAreaFaces, found.zero_area_faces, "face has no area", "faces have no area", report);
  add_faces(Topic::DoubledFaces, found.doubled_faces, "face has the same corners as another one",
            "faces have the same corners as other ones", report);
  if (const auto n = static_cast<int>(found.crowded_edges.size()); n > 0) {
    const auto& first = found.crowded_edges.front();
    report.lines.push_back({Kind::Problem,
                            counted(n, "edge has", "edges have") +
                                " more than two faces, first the one between points " +
                                std::to_string(first[0] + 1) + " and " + std::to_string(first[1] + 1) + ".",
                            Topic::NonManifoldEdges,
                            n,
                            {},
                            {},
                            found.crowded_edges});
  }
  if (const auto n = static_cast<int>(found.pinched_points.size()); n > 0) {
    report.lines.push_back({Kind::Problem,
                            "Parts of the model touch in " + counted(n, "single point", "single points") +
                                " (" + number_list("point", "points", found.pinched_points) + ").",
                            Topic::NonManifoldPoints,
                            n,
                            {},
                            found.pinched_points});
  }
  if (found.is_one_sided) {
    report.lines.push_back({Kind::Problem,
                            "The surface has only one side, like a Möbius strip: it cannot be repaired, only "
                            "cut open in a modelling program.",
                            Topic::OneSided, 1});
  }
  if (const auto n = static_cast<int>(found.turned_faces.size()); n > 0) {
    report.lines.push_back(
        {Kind::Notice, repair::turned_faces_sentence(n), Topic::TurnedFaces, n, found.turned_faces});
  }
  if (repair::used_box(soup).diagonal() < repair::kLeastDiagonal) {
    report.is_manifold = false;
    report.lines.push_back(
        {Kind::Problem, "All points lie in one place; export the model at a larger scale."});
  }
}

}  // namespace

std::string percent(double share) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), share < 0.001 ? "%.2g %%" : "%.1f %%", 100 * share);
  return text.data();
}

std::string size_text(const glm::dvec3& size) {
  return length_text(size.x) + " × " + length_text(size.y) + " × " + length_text(size.z);
}

const MeshReport::Line* MeshReport::find(Topic topic) const {
  const auto found = std::ranges::find(lines, topic, &Line::topic);
  return found == lines.end() ? nullptr : &*found;
}

int MeshReport::count(Topic topic) const {
  int count = 0;
  for (const Line& line : lines) count += line.topic == topic ? line.count : 0;
  return count;
}

std::string_view topic_name(MeshReport::Topic topic) {
  return kTopicNames.at(static_cast<std::size_t>(topic));
}

UnitGuess guess_unit(const PolygonSoup& soup) {
  constexpr UnitGuess kMillimetres{"mm", 1};
  constexpr UnitGuess kCentimetres{"cm", 10};
  constexpr UnitGuess kMetres{"m", 1000};
  const ModelFormat* format = model_format(std::filesystem::path(soup.name));
  if (format != nullptr && format->unit == "mm") return kMillimetres;
  if (format != nullptr && format->unit == "m") return kMetres;
  const glm::dvec3 size = repair::used_box(soup).size();
  const double longest = std::max({size.x, size.y, size.z});
  if (longest >= 20) return kMillimetres;
  return longest >= 2 ? kCentimetres : kMetres;
}

MeshReport report_on(const PolygonSoup& soup) {
  const repair::Findings found = repair::find_faults(soup);
  MeshReport report;
  report.n_faces = soup.n_faces();
  report.n_vertices = found.n_vertices;
  report.n_components = found.n_parts;
  report.genus = found.genus;
  report.n_border_edges = static_cast<int>(found.border_edges.size());
  report.n_border_loops = found.n_border_loops;
  report.border_length = found.border_length;
  report.size = found.size;
  report.worst_unevenness = found.worst_unevenness;
  report.is_closed = found.border_edges.empty() && found.crowded_edges.empty();
  report.is_manifold = soup.n_faces() > 0 && found.broken_faces.empty() && found.zero_area_faces.empty() &&
                       found.doubled_faces.empty() && found.crowded_edges.empty() &&
                       found.pinched_points.empty() && !found.is_one_sided;
  add_facts(report, report.is_manifold);
  if (Line* borders = add_borders(report)) borders->edges = found.border_edges;
  add_size(soup, report);
  add_faults(soup, found, report);
  add_uneven_faces(found.uneven_faces, report);
  add_self_intersections(find_self_intersections(soup), report);
  add_points(found, report);
  add_reader_notices(soup, report);
  add_places(soup, report.lines);
  return report;
}

MeshReport report_on(const Mesh& mesh) {
  MeshReport report;
  report.n_faces = static_cast<int>(mesh.n_faces());
  report.n_vertices = static_cast<int>(mesh.n_vertices());
  report.n_components = static_cast<int>(mesh.n_components());
  report.genus = mesh.genus();
  report.n_border_edges = static_cast<int>(mesh.n_border_edges());
  report.n_border_loops = static_cast<int>(mesh.n_border_loops());
  report.is_closed = mesh.is_closed();
  report.is_manifold = true;
  report.size = mesh.box().size();
  for (const EdgeId e : mesh.edges()) report.border_length += mesh.is_border(e) ? mesh.length(e) : 0;
  add_facts(report, true);
  if (Line* borders = add_borders(report)) {
    for (const EdgeId e : mesh.edges()) {
      const HalfedgeId h = mesh.halfedge(e);
      if (mesh.is_border(e)) borders->edge_places.push_back({mesh.position(h), mesh.position(mesh.next(h))});
    }
  }
  std::vector<FaceId> uneven;
  for (const FaceId f : mesh.faces()) {
    report.worst_unevenness = std::max(report.worst_unevenness, mesh.unevenness(f));
    if (mesh.side_unevenness(f) > kFlatness) uneven.push_back(f);
  }
  std::ranges::sort(uneven, [&](FaceId a, FaceId b) { return mesh.unevenness(a) > mesh.unevenness(b); });
  std::vector<int> sources;
  for (const FaceId f : uneven) sources.push_back(mesh.face_source(f));
  add_uneven_faces(std::move(sources), report);
  SelfIntersections crossings = find_self_intersections(mesh);
  for (auto& [a, b] : crossings.pairs) {
    a = mesh.face_source(FaceId(a));
    b = mesh.face_source(FaceId(b));
  }
  add_self_intersections(crossings, report);
  return report;
}

std::vector<Line> lines_about_file(const PolygonSoup& soup) {
  const repair::Findings found = repair::find_faults(soup);
  MeshReport report;
  add_faults(soup, found, report);
  add_points(found, report);
  add_places(soup, report.lines);
  for (Line& line : report.lines) line.kind = Kind::Notice;
  return std::move(report.lines);
}

void add_reader_notices(const PolygonSoup& soup, MeshReport& report) {
  for (const std::string& notice : soup.notices) {
    const bool is_picture = notice.starts_with("The picture") || notice.starts_with("The material library");
    report.lines.push_back({Kind::Notice, notice, is_picture ? Topic::MissingTextures : Topic::Other, 1});
  }
}

MeshReport report_on(const PolygonSoup& soup, const std::string& problem) {
  MeshReport report;
  report.n_faces = soup.n_faces();
  report.n_vertices = repair::n_used_points(soup);
  add_facts(report, false);
  report.lines.push_back({Kind::Problem, problem});
  return report;
}

}  // namespace netwright
