// Puts the harmless steps together in prepare(). Point and face numbers in messages are those of the file,
// counted from 1.
#include "core/mesh/repair.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/base/error.h"
#include "core/base/predicates.h"
#include "core/mesh/repair_topology.h"

namespace netwright {
namespace {

using Topic = MeshReport::Topic;

[[noreturn]] void refuse(const PolygonSoup& soup, const std::string& what) {
  throw Error(ErrorKind::Unfit, (soup.name.empty() ? "The model" : soup.name) + ": " + what);
}

/// Two faces with the same corners are a modelling accident that the edge test would describe badly.
void refuse_doubled_faces(const PolygonSoup& soup) {
  std::map<std::vector<int>, int> first_with;
  for (int f = 0; f < soup.n_faces(); ++f) {
    std::vector<int> corners(soup.face(f).begin(), soup.face(f).end());
    std::ranges::sort(corners);
    const auto [place, is_new] = first_with.try_emplace(std::move(corners), f);
    if (!is_new) {
      refuse(soup,
             "faces " + std::to_string(place->second + 1) + " and " + std::to_string(f + 1) +
                 " have the same corners; delete one of them, or merge doubles in a modelling program.");
    }
  }
}

void refuse_lost_size(const PolygonSoup& soup) {
  const double diagonal = repair::used_box(soup).diagonal();
  if (diagonal < repair::kLeastDiagonal)
    refuse(soup, "all its points lie in one place; export it again at a larger scale.");
}

void add_notice(MeshReport& report, MeshReport::Topic topic, int count, std::string text) {
  report.lines.push_back({MeshReport::Line::Kind::Notice, std::move(text), topic, count});
}

/// What is wrong with uneven faces, as the one refusing sentence.
std::string uneven_sentence(const Mesh& mesh, const MeshReport& report) {
  FaceId worst(0);
  for (const FaceId f : mesh.faces()) {
    if (mesh.unevenness(f) > mesh.unevenness(worst)) worst = f;
  }
  return mesh.name() + ": " + counted(report.n_uneven_faces, "face is", "faces are") + " not flat, face " +
         std::to_string(mesh.face_source(worst) + 1) + " most of all (" + percent(report.worst_unevenness) +
         " of its size), and paper cannot follow; triangulate it in a modelling program.";
}

/// One try at a mesh: what it took, or why there is none.
struct Attempt {
  PolygonSoup soup;
  std::shared_ptr<const Mesh> mesh;
  std::string refusal;
  int n_merged = 0;
  std::ptrdiff_t n_turned = 0;
};

Attempt build(const PolygonSoup& soup, const std::vector<int>& face_source, std::vector<bool> is_turned) {
  Attempt attempt{.soup = soup, .mesh = nullptr, .refusal = {}};
  try {
    refuse_lost_size(attempt.soup);
    attempt.n_merged = weld(attempt.soup);
    refuse_doubled_faces(attempt.soup);
    const std::vector<bool> turned = orient(attempt.soup);
    attempt.n_turned = std::ranges::count(turned, true);
    is_turned.resize(turned.size(), false);
    for (std::size_t f = 0; f < turned.size(); ++f) is_turned[f] = is_turned[f] != turned[f];
    attempt.mesh = std::make_shared<const Mesh>(attempt.soup, is_turned, face_source);
  } catch (const Error& error) {
    attempt.refusal = error.what();
    attempt.n_turned = 0;
  }
  return attempt;
}

}  // namespace

PreparedModel repair::prepare_from(const PolygonSoup& soup, const std::vector<int>& face_source,
                                   const std::vector<bool>& is_turned) {
  const Attempt attempt = build(soup, face_source, is_turned);
  PreparedModel model{.mesh = attempt.mesh, .report = {}, .refusal = attempt.refusal};
  model.report = model.mesh ? report_on(*model.mesh) : report_on(attempt.soup, model.refusal);
  if (model.report.n_uneven_faces > 0) model.refusal = uneven_sentence(*model.mesh, model.report);
  if (soup.is_indexed && attempt.n_merged > 0) {
    add_notice(model.report, Topic::DoubledPoints, attempt.n_merged,
               repair::doubled_points_sentence(attempt.n_merged));
  }
  if (attempt.n_turned > 0) {
    add_notice(model.report, Topic::TurnedFaces, static_cast<int>(attempt.n_turned),
               repair::turned_faces_sentence(attempt.n_turned));
  }
  add_reader_notices(soup, model.report);
  return model;
}

PreparedModel prepare(const PolygonSoup& soup) { return repair::prepare_from(soup, {}, {}); }

}  // namespace netwright
