// The independent proof: asks the questions of verify_checks.h one after the other and collects the answers.
// Here too: whether a net can be judged at all, and how faults are put into words.
#include "core/unfold/verify.h"

#include <algorithm>
#include <cmath>

#include "core/unfold/verify_checks.h"

namespace netwright {
namespace proof {

std::string face_name(const FlatNet& net, int face) {
  const auto f = static_cast<std::size_t>(face);
  return std::to_string((net.face_source.empty() ? face : net.face_source[f]) + 1);
}

std::string about_faces(const FlatNet& net, const std::vector<int>& faces, const std::string& one,
                        const std::string& several) {
  const std::string first = "Face " + face_name(net, faces.front());
  const std::size_t others = faces.size() - 1;
  if (others == 0) return first + " " + one;
  return first + " and " + std::to_string(others) + (others == 1 ? " other face " : " other faces ") +
         several;
}

namespace {

bool is_finite(const FlatNet& net) {
  const auto flat = [](glm::dvec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); };
  const auto space = [](glm::dvec3 p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  };
  return std::all_of(net.points.begin(), net.points.end(), flat) &&
         std::all_of(net.folded.begin(), net.folded.end(), space) &&
         std::all_of(net.edges.begin(), net.edges.end(),
                     [](const FlatNet::Edge& e) { return std::isfinite(e.fold_angle_rad); });
}

bool has_repeated_corner(std::vector<int> face) {
  std::sort(face.begin(), face.end());
  return std::adjacent_find(face.begin(), face.end()) != face.end();
}

void check_faces(const FlatNet& net, Faults& faults) {
  const int n_points = static_cast<int>(net.points.size());
  std::vector<int> small;
  std::vector<int> outside;
  std::vector<int> repeated;
  for (std::size_t f = 0; f < net.faces.size(); ++f) {
    const std::vector<int>& face = net.faces[f];
    const bool is_inside =
        std::all_of(face.begin(), face.end(), [&](int corner) { return corner >= 0 && corner < n_points; });
    if (!is_inside) outside.push_back(static_cast<int>(f));
    if (face.size() < 3) small.push_back(static_cast<int>(f));
    if (has_repeated_corner(face)) repeated.push_back(static_cast<int>(f));
  }
  if (!small.empty()) faults.push_back(about_faces(net, small, "has", "have") + " fewer than three corners.");
  if (!outside.empty()) {
    faults.push_back(about_faces(net, outside, "names a point", "name points") +
                     " that the net does not have.");
  }
  if (!repeated.empty()) {
    faults.push_back(about_faces(net, repeated, "uses", "use") + " the same point for two corners.");
  }
}

void check_sources(const FlatNet& net, Faults& faults) {
  if (net.face_source.empty()) return;
  std::vector<int> sources = net.face_source;
  std::sort(sources.begin(), sources.end());
  if (sources.size() != net.faces.size() || sources.front() < 0) {
    faults.emplace_back("The list of the model's faces does not fit the faces of the net.");
    return;
  }
  const auto twice = std::adjacent_find(sources.begin(), sources.end());
  if (twice != sources.end()) {
    faults.push_back("Face " + std::to_string(*twice + 1) + " of the model is in the net more than once.");
  }
}

}  // namespace

bool check_structure(const FlatNet& net, Faults& faults) {
  const std::size_t before = faults.size();
  if (net.faces.empty()) faults.emplace_back("The net has no faces.");
  if (net.points.size() != net.folded.size()) {
    faults.emplace_back("Not every point of the net has its place on the model.");
  }
  if (!is_finite(net)) faults.emplace_back("A number in the net is not finite.");
  check_sources(net, faults);
  if (faults.size() != before) return false;  // messages about faces need their sources
  check_faces(net, faults);
  const int n_points = static_cast<int>(net.points.size());
  const auto is_bad = [&](const FlatNet::Edge& e) {
    return e.from < 0 || e.to < 0 || e.from >= n_points || e.to >= n_points || e.from == e.to;
  };
  if (std::any_of(net.edges.begin(), net.edges.end(), is_bad)) {
    faults.emplace_back("An edge of the net does not run between two of its points.");
  }
  return faults.size() == before;
}

}  // namespace proof

VerifyReport verify(const FlatNet& net, int expected_pieces) {
  VerifyReport report;
  if (!proof::check_structure(net, report.faults)) return report;
  proof::Subject subject{net};
  if (!proof::measure(subject, report.faults)) return report;
  proof::connect(subject);
  report.pieces = subject.n_pieces;
  report.worst_distortion = proof::check_congruence(subject, report.faults);
  proof::check_orientation(subject, report.faults);
  proof::check_forest(subject, expected_pieces, report.faults);
  proof::check_pairing(subject, report.faults);
  proof::check_edges(subject, report.faults);
  const proof::Overlaps overlaps = proof::check_overlaps(subject, report.faults);
  report.overlaps = overlaps.pairs;
  report.deepest_overlap = overlaps.deepest;
  report.is_net = report.faults.empty();
  return report;
}

}  // namespace netwright
