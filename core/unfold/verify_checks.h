// The parts of the independent proof, one per question. Only verify*.cpp includes this. All of them look at
// the same prepared copy of the net, in which coordinates are scaled by a power of two (which changes no
// digit).
#pragma once

#include <string>
#include <vector>

#include "core/unfold/verify.h"

namespace netwright::proof {

/// Side `corner` of face `face`: from that corner to the next one. Its ends are numbers of net points or of
/// places on the model, the smaller one first.
struct Side {
  int low = 0;
  int high = 0;
  int face = 0;
  int corner = 0;
  bool runs_up = false;  ///< the face walks it from low to high
};

/// Two faces that the net keeps together at a common edge.
struct Join {
  Side first;
  Side second;
};

struct Subject {
  explicit Subject(const FlatNet& judged) : net(judged) {}

  const FlatNet& net;
  std::vector<glm::dvec2> points;  ///< of magnitude 1 at most
  std::vector<glm::dvec3> folded;  ///< of magnitude 1 at most
  std::vector<int> place;          ///< one number for all net points at the same place on the model
  std::vector<int> turn;           ///< per face: +1 counter-clockwise in the plane, -1 clockwise
  double mean_edge = 0;            ///< of the prepared points; never more than the true one
  std::vector<Side> net_sides;  ///< by net points, sorted: sides that share an edge in the net are neighbours
  std::vector<Side> model_sides;  ///< by places, sorted: sides that share an edge on the model are neighbours
  std::vector<Join> joins;
  std::vector<int> piece;  ///< per face, 0 … n_pieces-1
  int n_pieces = 0;
  int n_components = 0;  ///< of the model
};

/// "Face 7 lies mirrored." / "Face 7 and 3 more faces lie mirrored." Faces count from 1, by their number in
/// the model's file where it is known.
std::string about_faces(const FlatNet& net, const std::vector<int>& faces, const std::string& one,
                        const std::string& several);

/// Index of one face, for messages.
std::string face_name(const FlatNet& net, int face);

using Faults = std::vector<std::string>;

/// The first finding of a kind in full, the others as a number.
class Findings {
 public:
  void add(const std::string& sentence) {
    if (count_++ == 0) first_ = sentence;
  }
  void tell(Faults& faults) const {
    if (count_ == 0) return;
    const std::string others = count_ == 1 ? "." : " (and " + std::to_string(count_ - 1) + " more like it).";
    faults.push_back(first_ + others);
  }

 private:
  std::string first_;
  int count_ = 0;
};

/// Can the net be judged at all: indices, counts, finite numbers, faces with area. Nothing else runs if not.
bool check_structure(const FlatNet& net, Faults& faults);
/// Fills everything in Subject up to mean_edge; faces without area are faults and end the proof.
bool measure(Subject& subject, Faults& faults);
/// Fills the rest: what is joined to what, in the net and on the model.
void connect(Subject& subject);

/// Returns the worst deviation, as a share of the face's size.
double check_congruence(const Subject& subject, Faults& faults);
void check_orientation(const Subject& subject, Faults& faults);
void check_forest(const Subject& subject, int expected_pieces, Faults& faults);
void check_pairing(const Subject& subject, Faults& faults);
void check_edges(const Subject& subject, Faults& faults);

struct Overlaps {
  int pairs = 0;
  double deepest = 0;  ///< in mean edges
};
Overlaps check_overlaps(const Subject& subject, Faults& faults);

/// Calls visit(first, last) for every run of sides with the same two ends.
template <class Visit>
void for_each_edge(const std::vector<Side>& sides, const Visit& visit) {
  for (std::size_t begin = 0; begin < sides.size();) {
    std::size_t end = begin + 1;
    while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high)
      ++end;
    visit(&sides[begin], &sides[begin] + (end - begin));
    begin = end;
  }
}

}  // namespace netwright::proof
