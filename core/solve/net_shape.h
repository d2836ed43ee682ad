// What a person with scissors feels of a net, kept in step with the search's state: how far the paper lies
// from the middle, how large the net is, where it is about to tear.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "core/solve/search_state.h"

namespace netwright {

/// A net between parallel lines in kDirections directions: a polygon just outside its convex hull.
class Supports {
 public:
  static constexpr int kDirections = 16;

  explicit Supports(const SearchState& state);

  /// Of the polygon; at most a percent above the hull's unless the net is a needle.
  [[nodiscard]] double area() const;
  /// Turned to the best of these directions: the factor by which lengths are too large for a room. 1 or less
  /// fits.
  [[nodiscard]] double size_in(glm::dvec2 room) const;
  [[nodiscard]] glm::dvec2 middle() const;  ///< of the box along the axes

 private:
  static constexpr int kSides = 2 * kDirections;
  std::array<double, kSides> reach_{};
};

class NetShape {
 public:
  /// `neck_width` in the model's own unit, the mean edge. The model and the state must outlive this.
  NetShape(const DualGraph& dual, const SearchModel& model, const SearchState& state, double neck_width);

  /// To be called after each change of the state.
  void refresh();

  /// Polar moment of the paper about its middle, divided by that of a disc of the same area: 1 for a disc,
  /// 3 to 6 for a spidery net.
  [[nodiscard]] double spread() const { return moment_ / disc_; }
  [[nodiscard]] double spread_after(const Exchange& exchange) const;

  [[nodiscard]] double total_area() const { return total_area_; }
  [[nodiscard]] glm::dvec2 middle() const;             ///< of the paper
  [[nodiscard]] glm::dvec2 middle_of(int face) const;  ///< of a placed face

  /// Necks: folds shorter than the width, and faces between folds that are narrower there.
  [[nodiscard]] int necks() const;
  [[nodiscard]] int neck_change(int removed, int inserted) const;

 private:
  struct Sums {
    double area = 0;
    glm::dvec2 first{0};  // of area × place
    double second = 0;    // of area × distance² from the origin
  };
  /// What is not as it is in the state: two folds are exchanged.
  struct Swapped {
    int removed = -1;
    int inserted = -1;
  };
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  void add_face(int f);
  [[nodiscard]] bool is_fold(int h, Swapped swapped) const;
  [[nodiscard]] bool is_neck(int f, Swapped swapped) const;
  [[nodiscard]] bool is_narrow(int f, int corner, int side) const;

  const SearchModel* model_;
  const SearchState* state_;
  double neck_width_;
  std::vector<Sums> faces_;          // per face, in its own frame; `second` about its own middle
  std::vector<Sums> before_;         // of all faces before a position of the preorder, placed
  std::vector<glm::dvec2> corners_;  // per halfedge: its corner in its face's frame
  std::vector<char> may_be_narrow_;  // per face: some corner is near enough to some side
  double total_area_ = 0;
  double disc_ = 0;
  double moment_ = 0;
};

}  // namespace netwright
