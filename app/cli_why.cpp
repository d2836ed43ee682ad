// The hottest faces, the corners with too much paper around them, and the pins that stand in the way.
#include "app/cli_why.h"

#include <cmath>
#include <numbers>

#include "core/sheet/number_text.h"

namespace netwright {

namespace {

// More than this nobody reads in a terminal; the JSON has all.
constexpr std::size_t kNamed = 5;

int file_number(const Mesh& mesh, FaceId f) { return mesh.face_source(f) + 1; }

double degrees(double angle_rad) { return angle_rad * 180 / std::numbers::pi; }

std::string joined(const std::vector<std::string>& words, std::size_t n_all) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() && n_all == words.size() ? " and " : ", ";
    text += words[i];
  }
  return n_all > words.size() ? text + " and " + std::to_string(n_all - words.size()) + " more" : text;
}

std::string faces_line(const Trouble& trouble, const Mesh& mesh) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < std::min(kNamed, trouble.hot.size()); ++i)
    words.push_back(std::to_string(file_number(mesh, trouble.hot[i])));
  return std::string("Most often in collision: ") + (trouble.hot.size() == 1 ? "face " : "faces ") +
         joined(words, trouble.hot.size()) + ".";
}

std::string points_line(const Trouble& trouble, const Mesh& mesh) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < std::min(kNamed, trouble.points.size()); ++i) {
    const ExcessPoint& point = trouble.points[i];
    const glm::dvec3& p = mesh.position(point.vertex);
    words.push_back(decimal_number(degrees(point.angle_rad), 0) + "° at (" + short_number(p.x) + ", " +
                    short_number(p.y) + ", " + short_number(p.z) + ")");
  }
  return "Corners there with more than 360° of faces around them: " + joined(words, trouble.points.size()) +
         ".";
}

std::vector<std::string> release_lines(const Releases& releases, const Mesh& mesh) {
  if (releases.are_innocent) return {"Without its pins no net was found either."};
  if (releases.was_cancelled && releases.ways.empty()) return {"There was no time to try its pins out."};
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < std::min(kNamed, releases.ways.size()); ++i)
    lines.push_back("Releasing " +
                    pins_words(mesh, releases.ways[i], [&](FaceId f) { return file_number(mesh, f); }) +
                    " gives a net.");
  return lines;
}

Json pin_json(const Pin& pin, const Mesh& mesh) {
  Json faces{Json::Array{}};
  for (const FaceId f : faces_of(mesh, pin)) faces.add(file_number(mesh, f));
  Json json;
  json.set("kind", pin.kind == Pin::Kind::MustFold  ? "must-fold"
                   : pin.kind == Pin::Kind::MustCut ? "must-cut"
                                                    : "patch");
  json.set("faces", std::move(faces));
  return json;
}

Json releases_json(const Releases& releases, const Mesh& mesh) {
  Json ways{Json::Array{}};
  for (const std::vector<Pin>& way : releases.ways) {
    Json pins{Json::Array{}};
    for (const Pin& pin : way) pins.add(pin_json(pin, mesh));
    ways.add(std::move(pins));
  }
  return ways;
}

}  // namespace

WhyNot look_into(const SolveResult& result, const SolveOptions& options, Progress& progress) {
  WhyNot why{find_trouble(result), {}, !options.pins.are_free()};
  if (why.has_pins) why.releases = find_releases(result.net.dual, options, why.trouble, progress);
  return why;
}

std::vector<std::string> why_lines(const WhyNot& why, const Mesh& mesh) {
  std::vector<std::string> lines;
  if (!why.trouble.hot.empty()) lines.push_back(faces_line(why.trouble, mesh));
  if (!why.trouble.points.empty()) lines.push_back(points_line(why.trouble, mesh));
  if (why.has_pins)
    for (std::string& line : release_lines(why.releases, mesh)) lines.push_back(std::move(line));
  return lines;
}

Json why_json(const WhyNot& why, const Mesh& mesh) {
  Json faces{Json::Array{}};
  for (const FaceId f : why.trouble.hot) {
    Json face;
    face.set("face", file_number(mesh, f));
    face.set("heat", static_cast<double>(why.trouble.heat[f]));
    faces.add(std::move(face));
  }
  Json points{Json::Array{}};
  for (const ExcessPoint& point : why.trouble.points) {
    const glm::dvec3& p = mesh.position(point.vertex);
    Json one;
    one.set("at", Json(Json::Array{p.x, p.y, p.z}));
    one.set("degrees", degrees(point.angle_rad));
    one.set("share", point.share);
    points.add(std::move(one));
  }
  Json json;
  json.set("hot_faces", std::move(faces));
  json.set("excess_points", std::move(points));
  if (why.has_pins) json.set("releases", releases_json(why.releases, mesh));
  return json;
}

}  // namespace netwright
