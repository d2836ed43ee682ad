// Taking a project apart. Faces and corners are numbered as the stored mesh has them, so neither a change of
// the repairs nor of the edges' order can shift a tree.
#include "core/project/project_parts.h"

#include <algorithm>

#include "core/base/json.h"
#include "core/project/mesh_json.h"
#include "core/project/project_words.h"
#include "core/project/settings_json.h"
#include "core/project/shape_bytes.h"

namespace netwright {

namespace {

using namespace project_words;

template <class Words, class Enum>
Json word(const Words& words, Enum value) {
  return {words[static_cast<std::size_t>(value)]};
}

Json seed_json(std::uint64_t seed) { return {static_cast<std::int64_t>(seed)}; }

Json texts_json(const std::vector<std::string>& texts) {
  Json json{Json::Array{}};
  for (const std::string& text : texts) json.add(text);
  return json;
}

Json lists_json(const std::vector<std::vector<int>>& lists) {
  Json json{Json::Array{}};
  for (const std::vector<int>& list : lists) {
    Json items{Json::Array{}};
    for (const int item : list) items.add(item);
    json.add(std::move(items));
  }
  return json;
}

/// Collects the textures, each picture once.
class Pictures {
 public:
  explicit Pictures(PictureCache* cache) : cache_(cache) {}

  /// The picture's number from 1.
  int number_of(const std::shared_ptr<const Image>& image) {
    const auto found = std::find(images_.begin(), images_.end(), image);
    if (found != images_.end()) return static_cast<int>(found - images_.begin()) + 1;
    images_.push_back(image);
    packed.push_back(pack(image));
    return static_cast<int>(images_.size());
  }
  std::vector<std::string> packed;

  /// What is not in this project any more need not be kept.
  void tidy() {
    if (cache_ == nullptr) return;
    cache_->pictures.clear();
    for (std::size_t i = 0; i < images_.size(); ++i) cache_->pictures.emplace_back(images_[i], packed[i]);
  }

 private:
  [[nodiscard]] std::string pack(const std::shared_ptr<const Image>& image) const {
    if (cache_ != nullptr) {
      for (const auto& [known, bytes] : cache_->pictures)
        if (known == image) return bytes;
    }
    return encode_png(*image);
  }

  PictureCache* cache_;
  std::vector<std::shared_ptr<const Image>> images_;
};

Json materials_json(const std::vector<Material>& materials, Pictures& pictures) {
  Json json{Json::Array{}};
  for (const Material& material : materials) {
    Json one;
    one.set("name", material.name);
    one.set("colour", Json::Array{material.colour.x, material.colour.y, material.colour.z});
    if (material.texture && !material.texture->is_empty())
      one.set("picture", pictures.number_of(material.texture));
    json.add(std::move(one));
  }
  return json;
}

Json source_json(const PolygonSoup& source, Pictures& pictures) {
  Json json;
  json.set("name", source.name);
  json.set("up", word(kUp, source.up_axis));
  json.set("shares_points", source.is_indexed);
  json.set("keeps_points_apart", source.is_joined);
  json.set("notices", texts_json(source.notices));
  json.set("materials", materials_json(source.materials, pictures));
  return json;
}

Json mesh_json(const Mesh& mesh, Pictures& pictures) {
  Json json;
  json.set("name", mesh.name());
  json.set("up", word(kUp, mesh.up_axis()));
  json.set("materials", materials_json(mesh.materials(), pictures));
  return json;
}

Json repairs_json(const Repairs& repairs) {
  Json json;
  json.set("weld", repairs.welds);
  if (repairs.weld_tolerance >= 0) json.set("weld_tolerance", repairs.weld_tolerance);
  json.set("degenerate_faces", repairs.drops_degenerate_faces);
  json.set("doubled_faces", repairs.drops_doubled_faces);
  json.set("non_manifold", repairs.splits_non_manifold);
  json.set("hole_edges", repairs.max_hole_edges);
  json.set("isolated_points", repairs.drops_isolated_points);
  return json;
}

/// Six numbers a corner: from where, to where.
Json moved_json(const std::vector<MovedCorner>& moved) {
  Json json{Json::Array{}};
  for (const MovedCorner& corner : moved)
    for (const glm::dvec3& p : {corner.from, corner.to})
      for (const double x : {p.x, p.y, p.z}) json.add(x);
  return json;
}

Json recipe_json(const Recipe& recipe) {
  Json json;
  if (recipe.up) json.set("up", word(kUp, *recipe.up));
  json.set("repairs", recipe.repairs != kNoRepairs);
  if (recipe.repairs != kNoRepairs && recipe.repairs != Repairs{})
    json.set("repair_steps", repairs_json(recipe.repairs));
  json.set("uneven", word(kUneven, recipe.uneven));
  Json left_out{Json::Array{}};
  for (const int face : recipe.left_out) left_out.add(face);
  if (!recipe.left_out.empty()) json.set("left_out", left_out);
  json.set("faces", recipe.faces);
  if (!recipe.moved.empty()) json.set("moved", moved_json(recipe.moved));
  json.set("merges", recipe.merges);
  if (!recipe.apart.empty()) json.set("apart", lists_json(recipe.apart));
  return json;
}

/// Per face the corner where the side to its parent begins, -1 for a root.
Json tree_json(const UnfoldTree& tree, const Mesh& mesh) {
  Json json{Json::Array{}};
  for (const FaceId f : mesh.faces())
    json.add(tree.is_root(f) ? -1 : tree.to_parent(f).value - mesh.first(f).value);
  return json;
}

Json pins_json(const Constraints& pins, const Mesh& mesh) {
  Json json;
  json.set("root", pins.root.value);
  json.set("must_fold", edges_json(pins.must_fold, mesh));
  json.set("must_cut", edges_json(pins.must_cut, mesh));
  Json patches{Json::Array{}};
  for (const std::vector<FaceId>& patch : pins.together) {
    Json faces{Json::Array{}};
    for (const FaceId f : patch) faces.add(f.value);
    patches.add(std::move(faces));
  }
  json.set("together", std::move(patches));
  return json;
}

Json run_json(const RunSummary& run) {
  Json json;
  json.set("seed", seed_json(run.seed));
  json.set("moves", run.moves);
  json.set("restarts", run.restarts);
  json.set("seconds", run.seconds);
  json.set("overlaps", run.overlaps);
  json.set("proved", run.is_proved);
  return json;
}

/// Per piece a face, its canvas, and the turn of the face on it.
Json runs_json(const std::vector<KeptRun>& runs, const Mesh& mesh) {
  Json json{Json::Array{}};
  for (const KeptRun& run : runs) {
    Json one;
    one.set("run", run_json(run.summary));
    one.set("tree", tree_json(*run.tree, mesh));
    json.add(std::move(one));
  }
  return json;
}

/// What the size is not made of is left out, as long as it is what it is without a word.
Json size_json(const PrintSize& size, const Mesh& mesh) {
  const PrintSize usual;
  Json json;
  json.set("kind", word(kSizes, size.kind));
  json.set("height_mm", size.height_mm);
  if (size.edge.is_valid()) json.set("edge", edges_json({size.edge}, mesh));
  if (size.edge_mm != usual.edge_mm) json.set("edge_mm", size.edge_mm);
  if (size.scale != usual.scale) json.set("scale", size.scale);
  if (size.sheets != usual.sheets) json.set("sheets", size.sheets);
  return json;
}

Json placed_json(const HandLayout& placed) {
  Json canvases{Json::Array{}};
  for (const HandLayout::Canvas& canvas : placed.canvases) canvases.add(canvas.columns).add(canvas.rows);
  Json faces{Json::Array{}};
  Json on{Json::Array{}};
  Json turns{Json::Array{}};
  for (const HandLayout::Place& place : placed.places) {
    faces.add(place.face.value);
    on.add(place.canvas);
    turns.add(place.turn.cos).add(place.turn.sin).add(place.turn.x).add(place.turn.y);
  }
  Json json;
  json.set("landscape", placed.is_landscape);
  json.set("scale", placed.scale);
  json.set("canvases", std::move(canvases));
  json.set("faces", std::move(faces));
  json.set("on", std::move(on));
  json.set("turns", std::move(turns));
  return json;
}

Json project_json(const Project& project, const std::filesystem::path& belongs_to, Pictures& pictures,
                  const std::vector<KeptRun>& runs) {
  const MadeModel& made = *project.made;
  const Mesh& mesh = project.dual->mesh();
  Json json;
  json.set("format", kProjectFormat);
  json.set("file", project.path.string());
  if (!belongs_to.empty()) json.set("belongs_to", belongs_to.string());
  json.set("n_faces", static_cast<int>(mesh.n_faces()));
  json.set("source", source_json(*project.source, pictures));
  json.set("recipe", recipe_json(project.recipe));
  json.set("mesh", mesh_json(mesh, pictures));
  Json made_json;
  if (made.stages && made.stages->mesh) made_json.set("base", mesh_json(*made.stages->mesh, pictures));
  if (made.stages) made_json.set("base_done", texts_json(made.stages->done));
  made_json.set("done", texts_json(made.done));
  if (made.deviation) made_json.set("deviation", *made.deviation);
  if (!made.groups.empty()) made_json.set("groups", lists_json(made.groups.raw()));
  made_json.set("fewest_faces", made.n_faces_least);
  json.set("made", std::move(made_json));
  json.set("pins", pins_json(project.pins, mesh));
  if (!project.edits.are_free()) json.set("edits", pins_json(project.edits, mesh));
  json.set("seed", seed_json(project.seed));
  if (project.tree) json.set("tree", tree_json(*project.tree, mesh));
  if (project.run) json.set("run", run_json(*project.run));
  if (!runs.empty()) json.set("runs", runs_json(runs, mesh));
  Json paper;
  paper.set("format", project.paper.format);
  paper.set("orientation", word(kOrientation, project.paper.orientation));
  paper.set("margin_mm", project.paper.margin_mm);
  json.set("paper", std::move(paper));
  json.set("size", size_json(project.size, mesh));
  if (!project.placed.is_automatic()) json.set("placed", placed_json(project.placed));
  json.set("exports", exports_json(project.exports));
  if (!project.glued.empty()) json.set("glued", edges_json(project.glued, mesh));
  json.set("tabs", tabs_json(project.tabs, mesh));
  json.set("sheet",
           sheet_json(project.sheet, mesh, [&](const auto& image) { return pictures.number_of(image); }));
  return json;
}

}  // namespace

ProjectParts to_parts(const Project& project, const std::filesystem::path& belongs_to, PictureCache* cache,
                      const std::vector<KeptRun>& runs) {
  Pictures pictures(cache);
  ProjectParts parts;
  parts.json = to_text(project_json(project, belongs_to, pictures, runs), {.is_indented = true});
  StoredShape source;
  source.soup = *project.source;
  parts.source = shape_bytes(source);
  const auto& base = project.made->stages ? project.made->stages->mesh : nullptr;
  if (base && base != project.dual->shared_mesh()) parts.base = shape_bytes(shape_of(*base));
  parts.mesh = shape_bytes(shape_of(project.dual->mesh()));
  pictures.tidy();
  parts.pictures = std::move(pictures.packed);
  return parts;
}

}  // namespace netwright
