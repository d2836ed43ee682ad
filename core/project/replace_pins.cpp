// Every pin has one of three fates. Those that would contradict each other on the new faces are let go of,
// the ones that moved first.
#include "core/project/replace_pins.h"

#include <algorithm>
#include <array>

#include "core/base/counted.h"
#include "core/project/commands.h"

namespace netwright {

namespace {

using Kind = MeshReport::Line::Kind;
using Place = std::array<glm::dvec3, 2>;

/// What a line of the report is about, in the order of the report.
enum class Fate {
  RootMoved,
  FoldsMoved,
  CutsMoved,
  PatchesMoved,
  RootGone,
  FoldsGone,
  CutsGone,
  PatchesGone,
  FoldsAtBorder,
  FoldsLetGo,
  CutsLetGo,
  PatchesLetGo,
  EditsGone,
};

struct FateWords {
  Fate fate;
  Kind kind;
  const char* one;
  const char* many;
};

constexpr std::array<FateWords, 13> kFates{
    FateWords{Fate::RootMoved, Kind::Notice, "The root moved to the nearest face.", ""},
    FateWords{Fate::FoldsMoved, Kind::Notice, "pinned fold moved to the nearest edge.",
              "pinned folds moved to the nearest edges."},
    FateWords{Fate::CutsMoved, Kind::Notice, "pinned cut moved to the nearest edge.",
              "pinned cuts moved to the nearest edges."},
    FateWords{Fate::PatchesMoved, Kind::Notice, "patch that stays together has other faces now.",
              "patches that stay together have other faces now."},
    FateWords{Fate::RootGone, Kind::Problem, "The root is gone: no face lies near where it was.", ""},
    FateWords{Fate::FoldsGone, Kind::Problem, "pinned fold is gone: no edge lies near where it was.",
              "pinned folds are gone: no edges lie near where they were."},
    FateWords{Fate::CutsGone, Kind::Problem, "pinned cut is gone: no edge lies near where it was.",
              "pinned cuts are gone: no edges lie near where they were."},
    FateWords{Fate::PatchesGone, Kind::Problem, "patch is gone: no two of its faces are left.",
              "patches are gone: no two faces of them are left."},
    FateWords{Fate::FoldsAtBorder, Kind::Problem, "pinned fold is gone: its edge has only one face now.",
              "pinned folds are gone: their edges have only one face now."},
    FateWords{Fate::FoldsLetGo, Kind::Problem,
              "pinned fold was let go of: it contradicts other pins on the new faces.",
              "pinned folds were let go of: they contradict other pins on the new faces."},
    FateWords{Fate::CutsLetGo, Kind::Problem,
              "pinned cut was let go of: it contradicts other pins on the new faces.",
              "pinned cuts were let go of: they contradict other pins on the new faces."},
    FateWords{Fate::PatchesLetGo, Kind::Problem,
              "patch was let go of: it contradicts other pins on the new faces.",
              "patches were let go of: they contradict other pins on the new faces."},
    FateWords{Fate::EditsGone, Kind::Problem, "edge joined or cut by hand is free again.",
              "edges joined or cut by hand are free again."},
};

class Carrier {
 public:
  Carrier(const Project& old, const MeshMatch& match, const ModelFrame& frame, Project& next,
          ReplaceReport& report)
      : old_(old),
        from_(old.dual->mesh()),
        to_(next.dual->mesh()),
        match_(match),
        frame_(frame),
        next_(next),
        report_(report) {}

  void carry() {
    const Constraints& pins = old_.pins;
    next_.pins = {};
    next_.edits = {};
    carry_root();
    carry_edges(pins.must_fold, EdgePin::MustFold, Fate::FoldsMoved, Fate::FoldsGone);
    carry_edges(pins.must_cut, EdgePin::MustCut, Fate::CutsMoved, Fate::CutsGone);
    for (const std::vector<FaceId>& patch : pins.together) carry_patch(patch);
    if (!find_contradiction(*old_.dual, pins)) release_contradictions();
    carry_edits();
    tell();
  }

 private:
  struct Told {
    int count = 0;
    std::vector<Place> places;
  };
  Told& told(Fate fate) { return told_[static_cast<std::size_t>(fate)]; }

  static Place place(const Mesh& mesh, HalfedgeId h, const ModelFrame& frame) {
    return {frame(mesh.position(mesh.from(h))), frame(mesh.position(mesh.to(h)))};
  }
  void note_edge(Fate fate, const Mesh& mesh, EdgeId e, const ModelFrame& frame) {
    Told& one = told(fate);
    ++one.count;
    one.places.push_back(place(mesh, mesh.halfedge(e), frame));
  }
  void note_faces(Fate fate, const Mesh& mesh, const std::vector<FaceId>& faces, const ModelFrame& frame) {
    Told& one = told(fate);
    ++one.count;
    for (const FaceId f : faces)
      for (const HalfedgeId h : mesh.halfedges(f)) one.places.push_back(place(mesh, h, frame));
  }

  void carry_root() {
    const FaceId root = old_.pins.root;
    if (!root.is_valid()) return;
    ++report_.n_pins;
    next_.pins.root = match_.faces[root];
    if (!next_.pins.root.is_valid()) {
      ++report_.n_lost;
      note_faces(Fate::RootGone, from_, {root}, frame_);
    } else if (match_.is_face_same[root] != 0) {
      ++report_.n_kept;
    } else {
      ++report_.n_moved;
      note_faces(Fate::RootMoved, to_, {next_.pins.root}, {});
    }
  }

  void carry_edges(const std::vector<EdgeId>& edges, EdgePin pin, Fate moved, Fate gone) {
    for (const EdgeId e : edges) {
      ++report_.n_pins;
      const EdgeId heir = match_.edges[e];
      const bool is_at_border = heir.is_valid() && to_.is_border(heir) && pin == EdgePin::MustFold;
      if (!heir.is_valid() || is_at_border) {
        ++report_.n_lost;
        note_edge(is_at_border ? Fate::FoldsAtBorder : gone, from_, e, frame_);
        continue;
      }
      set_pin(next_.pins, heir, pin);
      if (match_.is_edge_same[e] != 0) {
        ++report_.n_kept;
        continue;
      }
      ++report_.n_moved;
      moved_.push_back(heir);
      note_edge(moved, to_, heir, {});
    }
  }

  /// New faces without a partner belong to the patch whose face was there: one face may have become several.
  std::vector<FaceId> heirs_of(const std::vector<FaceId>& patch) const {
    std::vector<FaceId> faces;
    for (const FaceId f : patch)
      if (match_.faces[f].is_valid()) faces.push_back(match_.faces[f]);
    std::vector<FaceId> changed;
    for (const FaceId f : patch)
      if (match_.is_face_same[f] == 0) changed.push_back(f);
    if (changed.empty()) return faces;
    IdVector<FaceId, char> has_partner(to_.n_faces(), 0);
    for (const FaceId f : from_.faces())
      if (match_.faces[f].is_valid()) has_partner[match_.faces[f]] = 1;
    for (const FaceId f : to_.faces()) {
      const bool lies_in_one = has_partner[f] == 0 && std::ranges::any_of(changed, [&](FaceId own) {
                                 const double off = glm::length(to_.centre(f) - frame_(from_.centre(own)));
                                 return off < 0.4 * frame_.scale * from_.size(own) &&
                                        patch_of(next_.pins, f) < 0 &&
                                        glm::dot(to_.normal(f), frame_.direction(from_.normal(own))) > 0.97;
                               });
      if (lies_in_one) faces.push_back(f);
    }
    return faces;
  }

  /// The largest part of these faces that hangs together.
  std::vector<FaceId> largest_part(const std::vector<FaceId>& faces) const {
    IdVector<FaceId, int> part(to_.n_faces(), -1);
    for (const FaceId f : faces) part[f] = 0;
    std::vector<FaceId> largest;
    int n_parts = 0;
    for (const FaceId seed : faces) {
      if (part[seed] != 0) continue;
      std::vector<FaceId> reached{seed};
      part[seed] = ++n_parts;
      for (std::size_t i = 0; i < reached.size(); ++i)
        for (const HalfedgeId h : to_.halfedges(reached[i])) {
          const FaceId beyond = to_.neighbour(h);
          if (!beyond.is_valid() || part[beyond] != 0) continue;
          part[beyond] = n_parts;
          reached.push_back(beyond);
        }
      if (reached.size() > largest.size()) largest = std::move(reached);
    }
    return largest;
  }

  void carry_patch(const std::vector<FaceId>& patch) {
    ++report_.n_pins;
    const std::vector<FaceId> faces = largest_part(heirs_of(patch));
    if (faces.size() < 2) {
      ++report_.n_lost;
      note_faces(Fate::PatchesGone, from_, patch, frame_);
      return;
    }
    keep_together(next_.pins, faces);
    const bool is_same = faces.size() == patch.size() &&
                         std::ranges::all_of(patch, [&](FaceId f) { return match_.is_face_same[f] != 0; });
    if (is_same) {
      ++report_.n_kept;
    } else {
      ++report_.n_moved;
      note_faces(Fate::PatchesMoved, to_, faces, {});
    }
  }

  /// Of the pins to blame those that moved, else the last one, else the patch that shows the trouble.
  void release_contradictions() {
    while (const auto contradiction = find_contradiction(*next_.dual, next_.pins)) {
      std::vector<EdgeId> blamed;
      for (const EdgeId e : contradiction->edges)
        if (pin_of(next_.pins, e) != EdgePin::None) blamed.push_back(e);
      const auto own = std::ranges::find_if(
          blamed, [&](EdgeId e) { return std::ranges::find(moved_, e) != moved_.end(); });
      if (!blamed.empty()) {
        release_edge(own != blamed.end() ? *own : blamed.back());
      } else if (!release_patch(contradiction->faces)) {
        return;
      }
    }
  }

  void count_release(bool had_moved) {
    ++report_.n_lost;
    --(had_moved ? report_.n_moved : report_.n_kept);
  }

  void release_edge(EdgeId e) {
    const bool was_fold = pin_of(next_.pins, e) == EdgePin::MustFold;
    note_edge(was_fold ? Fate::FoldsLetGo : Fate::CutsLetGo, to_, e, {});
    const bool had_moved = std::ranges::find(moved_, e) != moved_.end();
    if (had_moved) --told(was_fold ? Fate::FoldsMoved : Fate::CutsMoved).count;
    count_release(had_moved);
    set_pin(next_.pins, e, EdgePin::None);
  }

  bool release_patch(const std::vector<FaceId>& faces) {
    for (const FaceId f : faces) {
      const int patch = patch_of(next_.pins, f);
      if (patch < 0) continue;
      const std::vector<FaceId> let_go_of = next_.pins.together[static_cast<std::size_t>(patch)];
      note_faces(Fate::PatchesLetGo, to_, let_go_of, {});
      const bool had_moved = told(Fate::PatchesMoved).count > 0;
      if (had_moved) --told(Fate::PatchesMoved).count;
      count_release(had_moved);
      let_go(next_.pins, let_go_of);
      return true;
    }
    return false;
  }

  /// Edits are the last net's affair: what does not fit any more is simply free.
  void carry_edits() {
    const auto carry_one = [&](EdgeId e, EdgePin pin) {
      const EdgeId heir = match_.edges[e];
      if (heir.is_valid() && match_.is_edge_same[e] != 0 && !to_.is_border(heir)) {
        set_pin(next_.edits, heir, pin);
        if (!find_contradiction(*next_.dual, pins_with_edits(next_))) return;
        set_pin(next_.edits, heir, EdgePin::None);
      }
      note_edge(Fate::EditsGone, from_, e, frame_);
    };
    for (const EdgeId e : old_.edits.must_fold) carry_one(e, EdgePin::MustFold);
    for (const EdgeId e : old_.edits.must_cut) carry_one(e, EdgePin::MustCut);
  }

  void tell() {
    for (const FateWords& words : kFates) {
      const Told& one = told(words.fate);
      if (one.count <= 0) continue;
      MeshReport::Line line{words.kind,
                            *words.many == '\0' ? words.one : counted(one.count, words.one, words.many)};
      line.count = one.count;
      line.edge_places = one.places;
      report_.lines.push_back(std::move(line));
    }
  }

  const Project& old_;
  const Mesh& from_;
  const Mesh& to_;
  const MeshMatch& match_;
  const ModelFrame& frame_;
  Project& next_;
  ReplaceReport& report_;
  std::vector<EdgeId> moved_;  // new edges of pins that moved
  std::array<Told, kFates.size()> told_;
};

}  // namespace

void replace_pins(const Project& old, const MeshMatch& match, const ModelFrame& frame, Project& next,
                  ReplaceReport& report) {
  Carrier(old, match, frame, next, report).carry();
}

}  // namespace netwright
