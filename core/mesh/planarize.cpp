// The flow and its finish, with Eigen's sparse Cholesky factorization. Lengths are in mean edges, so that the
// step of the flow means the same for every model. The article weighs moves by lumped areas; here all corners
// weigh the same, since those of small faces would give way and move farther, and strain costs something too.
//
// The flow alone gets there on every model tried, but its last digits take dozens of steps: its energy also
// holds on to places within the planes. So once it slows down, only heights over the planes are penalised,
// with a weight that grows tenfold: in the limit that is Newton's method for "all heights are zero" with the
// smallest move, and its error squares with every step.
#include "core/mesh/planarize.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "core/mesh/deviation.h"
#include "core/mesh/mesh_report.h"
#include "core/mesh/planar_model.h"
#include "core/mesh/polygon_laplacian.h"

namespace netwright {
namespace {

using planarize_parts::PlanarModel;
using planarize_parts::Points;
using Sparse = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

constexpr double kFirstStep = 0.5;      // of the flow, in mean edges squared
constexpr double kStepGrowth = 1.2;     // while the energy falls
constexpr double kStiffness = 0.1;      // of faces against strain; a corner's own move counts 1
constexpr double kShortest = 1e-3;      // sides shorter than this, in mean edges, are not stiffer
constexpr int kFlowSteps = 40;          // more than the flow needs to come near
constexpr double kNear = 1e-3;          // unevenness from which on the finish takes fewer steps than the flow
constexpr int kFinishSteps = 25;        // the finish needs four to seven, where it gets there at all
constexpr double kFirstWeight = 10;     // of heights against moves, in the finish
constexpr double kLargestWeight = 1e8;  // beyond it rounding eats what is gained
constexpr double kStiffer = 8;          // of a face that folded over, for the next round
constexpr int kRounds = 12;             // of seeking a smaller move
constexpr int kPatience = 4;            // rounds without a smaller move before giving up on one
constexpr double kNoticed = 0.02;       // share of the size: a larger move is explained
constexpr double kNobodySees = 0.005;   // share of the size: a smaller move is not worth seeking

/// How much moves cost: per corner point its own move, per face its strain.
struct Weights {
  explicit Weights(const PlanarModel& model)
      : mass(model.start.size(), 1.0), stiffness(model.faces.size(), kStiffness) {}
  std::vector<double> mass;
  std::vector<double> stiffness;
};

/// What a move costs: its length at each corner, and how much it strains the faces. Corners that are close
/// together move together, or short sides would turn round before long ones are flat.
Sparse cost_of_moves(const PlanarModel& model, const Weights& weights) {
  const auto n = static_cast<Eigen::Index>(weights.mass.size());
  Triplets entries;
  for (Eigen::Index v = 0; v < n; ++v) entries.emplace_back(v, v, weights.mass[static_cast<std::size_t>(v)]);
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    const auto& face = model.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const glm::dvec3 arm = model.start[face[i]] - model.start[face[j]];
        const double stiffness = weights.stiffness[f] / std::max(glm::dot(arm, arm), kShortest * kShortest);
        entries.emplace_back(face[i], face[i], stiffness);
        entries.emplace_back(face[j], face[j], stiffness);
        entries.emplace_back(face[i], face[j], -stiffness);
        entries.emplace_back(face[j], face[i], -stiffness);
      }
    }
  }
  Sparse cost(n, n);
  cost.setFromTriplets(entries.begin(), entries.end());
  return cost;
}

/// One implicit step with the projections frozen: (M + t L) x' = M x, for the three coordinates at once.
bool flow_step(const PlanarModel& model, const Sparse& cost, double step, Points& points) {
  const auto n = static_cast<Eigen::Index>(points.size());
  Triplets entries;
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    const auto& face = model.faces[f];
    if (face.size() == 3) continue;
    const CornerMatrix matrix = off_plane_energy(model.frame(f, points));
    for (std::size_t i = 0; i < face.size(); ++i) {
      for (std::size_t j = 0; j < face.size(); ++j)
        entries.emplace_back(face[i], face[j], step * matrix(i, j));
    }
  }
  Sparse equations(n, n);
  equations.setFromTriplets(entries.begin(), entries.end());
  equations += cost;
  Eigen::MatrixXd places(n, 3);
  for (Eigen::Index v = 0; v < n; ++v) {
    const glm::dvec3& point = points[static_cast<std::size_t>(v)];
    places.row(v) << point.x, point.y, point.z;
  }
  const Eigen::SimplicialLDLT<Sparse> solver(equations);
  if (solver.info() != Eigen::Success) return false;
  const Eigen::MatrixXd moved = solver.solve(cost * places);
  if (!moved.allFinite()) return false;
  for (Eigen::Index v = 0; v < n; ++v) {
    points[static_cast<std::size_t>(v)] = {moved(v, 0), moved(v, 1), moved(v, 2)};
  }
  return true;
}

/// Adds one face to the system of the finish: its heights' residue, which acts along its normal.
void add_heights(const PolygonFrame& frame, const std::vector<std::size_t>& face, double weight,
                 Triplets& entries, Eigen::VectorXd& force) {
  const CornerMatrix residue = height_residue(frame);
  for (std::size_t i = 0; i < face.size(); ++i) {
    double height = 0;
    for (std::size_t j = 0; j < face.size(); ++j) {
      height += residue(i, j) * frame.height[j];
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
          entries.emplace_back(3 * face[i] + static_cast<std::size_t>(a),
                               3 * face[j] + static_cast<std::size_t>(b),
                               weight * residue(i, j) * frame.normal[a] * frame.normal[b]);
        }
      }
    }
    for (int a = 0; a < 3; ++a) {
      force[static_cast<Eigen::Index>(3 * face[i]) + a] -= weight * height * frame.normal[a];
    }
  }
}

/// One Levenberg-Marquardt step: the cost of moves against the heights after it, to first order.
bool finish_step(const PlanarModel& model, const Sparse& cost, double weight, Points& points) {
  const auto n = static_cast<Eigen::Index>(3 * points.size());
  Triplets entries;
  for (Eigen::Index column = 0; column < cost.outerSize(); ++column) {
    for (Sparse::InnerIterator entry(cost, column); entry; ++entry) {
      for (int a = 0; a < 3; ++a) entries.emplace_back(3 * entry.row() + a, 3 * column + a, entry.value());
    }
  }
  Eigen::VectorXd force = Eigen::VectorXd::Zero(n);
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    if (model.faces[f].size() == 3) continue;
    add_heights(model.frame(f, points), model.faces[f], weight, entries, force);
  }
  Sparse equations(n, n);
  equations.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Sparse> solver(equations);
  if (solver.info() != Eigen::Success) return false;
  const Eigen::VectorXd move = solver.solve(force);
  if (!move.allFinite()) return false;
  for (std::size_t v = 0; v < points.size(); ++v) {
    for (int a = 0; a < 3; ++a) points[v][a] += move[static_cast<Eigen::Index>(3 * v) + a];
  }
  return true;
}

/// Tries shapes and remembers the best one that is allowed: the flattest until one reaches the target, from
/// then on the one that moved least.
class Planarizer {
 public:
  Planarizer(const Mesh& mesh, const PlanarizeOptions& options, Progress& progress)
      : model_(mesh), options_(options), progress_(progress), best_(model_.start) {
    const PlanarModel::Measure before = model_.measure(model_.start);
    best_unevenness_ = unevenness_before_ = before.unevenness;
    off_plane_before_ = before.off_plane;
  }

  PlanarizeResult run();

 private:
  double consider(const Points& points);
  [[nodiscard]] bool may_go_on() const {
    return iterations_ < options_.max_iterations && !progress_.is_cancelled();
  }
  [[nodiscard]] bool is_flat(double unevenness) const { return unevenness <= options_.target; }
  void flow(Points& points);
  bool finish(const Weights& weights, Points& points);
  void seek_smaller_moves();
  [[nodiscard]] std::string sentence(const PlanarizeResult& result) const;
  [[nodiscard]] std::string reason(const PlanarizeResult& result) const;

  PlanarModel model_;
  PlanarizeOptions options_;
  Progress& progress_;
  Points best_;
  double unevenness_before_ = 0;
  double off_plane_before_ = 0;  // in mean edges, of the corner that was farthest off
  double best_unevenness_ = 0;
  double best_move_ = 0;
  double refused_move_ = 0;  // share of the size that a flat shape moved too far; 0 when there was none
  bool met_folded_ = false;  // a flat shape had a face turned over or crossing itself
  int iterations_ = 0;
  std::vector<double> energies_;
};

/// Returns the unevenness.
double Planarizer::consider(const Points& points) {
  const PlanarModel::Measure now = model_.measure(points);
  const double move = planarize_parts::largest_move(model_.start, points);
  const bool is_allowed = now.folded.empty() && move <= options_.max_move * model_.size;
  const bool is_better = is_flat(best_unevenness_) ? is_flat(now.unevenness) && move < best_move_
                                                   : now.unevenness < best_unevenness_;
  if (is_allowed && is_better) {
    best_ = points;
    best_unevenness_ = now.unevenness;
    best_move_ = move;
  } else if (!is_allowed && is_flat(now.unevenness)) {
    if (!now.folded.empty()) met_folded_ = true;
    if (move > options_.max_move * model_.size) refused_move_ = move / model_.size;
  }
  return now.unevenness;
}

/// The planarization flow, until the finish takes fewer steps.
void Planarizer::flow(Points& points) {
  const Sparse cost = cost_of_moves(model_, Weights(model_));
  double step = kFirstStep;
  energies_.push_back(model_.energy(points));
  for (int i = 0; i < kFlowSteps && may_go_on(); ++i) {
    Points next = points;
    ++iterations_;
    if (!flow_step(model_, cost, step, next)) return;
    const double after = model_.energy(next);
    if (after > energies_.back()) {
      step /= 4;
      continue;
    }
    points = std::move(next);
    energies_.push_back(after);
    step *= kStepGrowth;
    progress_.set_fraction(0.5 * (i + 1) / kFlowSteps);
    if (consider(points) < std::max(kNear, options_.target)) return;
  }
}

/// Newton's method with the smallest move, led in by growing weights. Half the target, so that the way back
/// to model units may round. Returns whether it got there.
bool Planarizer::finish(const Weights& weights, Points& points) {
  const Sparse cost = cost_of_moves(model_, weights);
  double weight = kFirstWeight;
  for (int i = 0; i < kFinishSteps && may_go_on(); ++i) {
    ++iterations_;
    if (!finish_step(model_, cost, weight, points)) return false;
    weight = std::min(kLargestWeight, 10 * weight);
    if (consider(points) <= options_.target / 2) return true;
  }
  return false;
}

/// The finish again, from the model as it was, with more weight on the corners that moved most: round by
/// round the largest move goes down towards what the most uneven face asks for. Faces that folded over get
/// stiffer.
void Planarizer::seek_smaller_moves() {
  Weights weights(model_);
  int last_gain = 0;
  for (int round = 0; round < kRounds && may_go_on(); ++round) {
    progress_.set_fraction(0.5 + 0.5 * round / kRounds);
    const double move_before = best_move_;
    Points points = model_.start;
    if (!finish(weights, points)) return;
    if (!is_flat(best_unevenness_) || best_move_ != move_before) last_gain = round;
    if (round - last_gain >= kPatience && best_move_ <= kNoticed * model_.size) return;
    const std::vector<std::size_t> folded = model_.measure(points).folded;
    for (const std::size_t f : folded) weights.stiffness[f] *= kStiffer;
    const double largest = planarize_parts::largest_move(model_.start, points);
    if (folded.empty() && largest < kNobodySees * model_.size) return;
    double sum = 0;
    for (std::size_t v = 0; v < weights.mass.size(); ++v) {
      const double share = glm::distance(model_.start[v], points[v]) / largest;
      weights.mass[v] *= 1 + 2 * share * share * share;
      sum += weights.mass[v];
    }
    for (double& mass : weights.mass) mass *= static_cast<double>(weights.mass.size()) / sum;
  }
}

std::string Planarizer::reason(const PlanarizeResult& result) const {
  if (result.was_cancelled) return "Flattening was stopped early";
  if (refused_move_ > 0) {
    return "The faces cannot be made flat without moving a corner by " + percent(refused_move_) +
           " of the model's size, which is more than the " + percent(options_.max_move) + " allowed";
  }
  if (met_folded_) return "The faces cannot be made flat without one of them turning over or crossing itself";
  return "The faces did not become flat within " + std::to_string(iterations_) + " steps";
}

std::string Planarizer::sentence(const PlanarizeResult& result) const {
  if (result.has_converged && result.iterations == 0) return "All faces are flat already; nothing was moved.";
  if (result.has_converged) {
    const std::string done = "All faces are flat now; no corner moved by more than " +
                             percent(result.moved_share) + " of the model's size";
    if (result.moved_share <= kNoticed) return done + ".";
    return done + " (corners of its most uneven face were " + percent(off_plane_before_ / model_.size) +
           " off the face's plane).";
  }
  return reason(result) + "; the worst face is still off its plane by " + percent(result.unevenness_after) +
         " of its size. Split the uneven faces into triangles instead.";
}

PlanarizeResult Planarizer::run() {
  progress_.set_phase("flattening the faces of " + model_.mesh.name());
  if (!is_flat(best_unevenness_)) {
    Points points = model_.start;
    flow(points);
    finish(Weights(model_), points);
    if (!is_flat(best_unevenness_) || best_move_ > kNobodySees * model_.size) seek_smaller_moves();
  }
  PlanarizeResult result;
  result.soup = model_.soup(best_);
  result.iterations = iterations_;
  result.flow_energies = std::move(energies_);
  result.unevenness_before = unevenness_before_;
  result.unevenness_after = planarize_parts::worst_unevenness(result.soup);
  result.has_converged = is_flat(result.unevenness_after);
  result.was_cancelled = !result.has_converged && progress_.is_cancelled();
  result.moved_share = best_move_ / model_.size;
  result.largest_move = best_move_ * model_.unit;
  if (best_move_ > 0) {
    // No point of a triangle moves farther than its corners do, however far off the sampling is.
    result.hausdorff =
        std::min(result.largest_move, hausdorff_distance(SurfaceTree(model_.mesh), SurfaceTree(result.soup)));
  }
  result.hausdorff_share = result.hausdorff / (model_.size * model_.unit);
  result.sentence = sentence(result);
  progress_.set_fraction(1);
  return result;
}

}  // namespace

PlanarizeResult planarize(const Mesh& mesh, const PlanarizeOptions& options, Progress& progress) {
  return Planarizer(mesh, options, progress).run();
}

}  // namespace netwright
