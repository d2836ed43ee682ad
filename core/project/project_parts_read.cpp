// Putting a project together again. Nothing that the parts say is believed before it was looked at: kinds,
// limits, indices, and whether tree and pins are those of this mesh.
#include "core/project/project_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/mesh/difficulty.h"
#include "core/project/json_fields.h"
#include "core/project/mesh_json.h"
#include "core/project/project_words.h"
#include "core/project/settings_json.h"
#include "core/project/shape_bytes.h"

namespace netwright {

namespace {

using namespace project_words;

constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
constexpr int kMostInt = std::numeric_limits<int>::max();
constexpr double kMostNumber = std::numeric_limits<double>::max();
constexpr double kMostMillimetres = 1e6;
constexpr double kLeastScale = 1e-9;

/// Reads one project. Its members are filled in the order in which they depend on each other.
class Reader {
 public:
  Reader(const ProjectParts& parts, const std::string& file)
      : parts_(parts), file_(file), json_(parse_json(parts.json, file, kMaxValues)) {}

  StoredProject read() {
    JsonFields fields(&json_, file_, "the project");
    check_format(fields);
    StoredProject stored;
    Project& project = stored.project;
    project.path = fields.text("file", "");
    stored.belongs_to = fields.text("belongs_to", "");
    static_cast<void>(fields.integer("n_faces", 0, kMostInt, 0));
    read_pictures();
    project.source = read_source(fields.object("source"));
    project.recipe = read_recipe(fields.object("recipe"));
    read_models(project, fields.object("mesh"), fields.object("made"));
    project.seed = seed(fields);
    project.pins = read_pins(project, fields.object("pins"), "the pins");
    project.edits = read_pins(project, fields.object("edits"), "the edits");
    project.tree = read_tree(project.dual->mesh(), fields);
    stored.runs = read_runs(project.dual->mesh(), fields);
    if (fields.has("run")) project.run = read_run(fields.object("run"));
    if (project.run && !project.tree) fields.refuse("run", "led to no tree");
    static_cast<void>(fields.object("run"));
    project.paper = read_paper(fields.object("paper"));
    project.size = read_size(fields.object("size"), project.dual->mesh());
    project.placed = read_placed(project, fields.object("placed"));
    project.tabs = read_tabs(fields.object("tabs"), file_, project.dual->mesh());
    project.glued = read_edges(fields, "glued", project.dual->mesh());
    if (!project.glued.empty() && !project.tree) fields.refuse("glued", "is of no net");
    project.exports = read_exports(fields.object("exports"), file_);
    project.sheet = read_sheet(fields.object("sheet"), file_, project.dual->mesh(), pictures_);
    fields.finish();
    return stored;
  }

  ProjectOutline outline() {
    JsonFields fields(&json_, file_, "the project");
    check_format(fields);
    ProjectOutline outline;
    outline.name = JsonFields(fields.object("source"), file_, "the source").text("name", "");
    outline.belongs_to = fields.text("belongs_to", "");
    outline.n_faces = static_cast<int>(fields.integer("n_faces", 0, kMostInt, 0));
    outline.is_proved = JsonFields(fields.object("run"), file_, "the run").flag("proved", false);
    return outline;
  }

 private:
  static constexpr std::size_t kMaxValues = 5'000'000;
  static constexpr std::int64_t kMaxPixels = 256'000'000;

  void check_format(JsonFields& fields) const {
    const std::int64_t format = fields.integer("format", 1, kMost, 0);
    if (format == 0) fields.refuse("format", "is missing");
    if (format > kProjectFormat)
      throw Error(ErrorKind::Read, file_ + " was saved by a newer Netwright (format " +
                                       std::to_string(format) + ", this one reads up to " +
                                       std::to_string(kProjectFormat) + "); update Netwright to open it.");
  }

  void read_pictures() {
    std::int64_t n_pixels = 0;
    for (const std::string& bytes : parts_.pictures) {
      const ImageSize size = image_size(bytes);
      n_pixels += std::int64_t{size.width} * size.height;
      if (n_pixels > kMaxPixels) refuse_damaged(file_, "its pictures are larger than any memory");
      auto image = std::make_shared<const Image>(decode_image(bytes));
      if (image->is_empty()) refuse_damaged(file_, "one of its pictures cannot be read");
      pictures_.push_back(std::move(image));
    }
  }

  std::vector<Material> read_materials(JsonFields& fields) const {
    std::vector<Material> materials;
    const Json::Array* const items = fields.array("materials");
    if (items == nullptr) return materials;
    for (const Json& item : *items) {
      JsonFields one(&item, file_, "a material");
      Material& material = materials.emplace_back();
      material.name = one.text("name", "");
      const std::vector<double> colour = one.numbers("colour", -kMostNumber, kMostNumber);
      if (colour.size() == 3) {
        material.colour = {colour[0], colour[1], colour[2]};
      } else if (one.has("colour")) {
        one.refuse("colour", "is not three numbers");
      }
      const std::int64_t n = one.integer("picture", 1, static_cast<std::int64_t>(pictures_.size()), 0);
      if (n > 0) material.texture = pictures_[static_cast<std::size_t>(n) - 1];
      one.finish();
    }
    return materials;
  }

  /// What a soup and the soup of a mesh have in common: words around the arrays.
  void read_words(JsonFields& fields, PolygonSoup& soup) const {
    soup.name = fields.text("name", "");
    soup.up_axis = static_cast<UpAxis>(fields.choice("up", kUp, 0));
    soup.materials = read_materials(fields);
    const auto has_material = [&](int m) { return m >= -1 && m < static_cast<int>(soup.materials.size()); };
    if (!std::all_of(soup.face_material.begin(), soup.face_material.end(), has_material))
      refuse_damaged(file_, "a face names a material that is not there");
  }

  std::shared_ptr<const PolygonSoup> read_source(const Json* json) const {
    StoredShape shape = parse_shape(parts_.source, file_);
    if (shape.is_mesh()) refuse_damaged(file_, "a mesh stands where the model's own faces should");
    JsonFields fields(json, file_, "the source");
    read_words(fields, shape.soup);
    shape.soup.is_indexed = fields.flag("shares_points", true);
    shape.soup.is_joined = fields.flag("keeps_points_apart", false);
    shape.soup.notices = fields.texts("notices");
    fields.finish();
    return std::make_shared<const PolygonSoup>(std::move(shape.soup));
  }

  /// Without details it is what "repair all" does.
  Repairs read_repairs(const Json* json) const {
    JsonFields fields(json, file_, "the repairs");
    Repairs repairs;
    repairs.welds = fields.flag("weld", repairs.welds);
    repairs.weld_tolerance = fields.number("weld_tolerance", 0, kMostNumber, repairs.weld_tolerance);
    repairs.drops_degenerate_faces = fields.flag("degenerate_faces", repairs.drops_degenerate_faces);
    repairs.drops_doubled_faces = fields.flag("doubled_faces", repairs.drops_doubled_faces);
    repairs.splits_non_manifold = fields.flag("non_manifold", repairs.splits_non_manifold);
    repairs.max_hole_edges = static_cast<int>(fields.integer("hole_edges", 0, kMostInt, 0));
    repairs.drops_isolated_points = fields.flag("isolated_points", repairs.drops_isolated_points);
    fields.finish();
    return repairs;
  }

  std::vector<MovedCorner> read_moved(const std::vector<double>& numbers) const {
    if (numbers.size() % 6 != 0) refuse_damaged(file_, "a moved corner has no place");
    std::vector<MovedCorner> moved;
    for (std::size_t i = 0; i < numbers.size(); i += 6)
      moved.push_back(
          {{numbers[i], numbers[i + 1], numbers[i + 2]}, {numbers[i + 3], numbers[i + 4], numbers[i + 5]}});
    return moved;
  }

  Recipe read_recipe(const Json* json) const {
    JsonFields fields(json, file_, "the recipe");
    Recipe recipe;
    const int up = fields.choice("up", kUp, -1);
    if (up >= 0) recipe.up = static_cast<UpAxis>(up);
    if (fields.flag("repairs", false)) recipe.repairs = read_repairs(fields.object("repair_steps"));
    recipe.uneven = static_cast<UnevenFaces>(fields.choice("uneven", kUneven, 0));
    recipe.left_out = fields.integers("left_out", 0, kMostInt);
    recipe.faces = static_cast<int>(fields.integer("faces", 0, kMostInt, recipe.faces));
    recipe.moved = read_moved(fields.numbers("moved", -kMostNumber, kMostNumber));
    recipe.merges = fields.flag("merges", recipe.merges);
    recipe.apart = fields.integer_lists("apart", 0, kMostInt);
    fields.finish();
    return recipe;
  }

  std::shared_ptr<const Mesh> read_mesh(const std::string& bytes, const Json* json,
                                        int n_source_faces) const {
    StoredShape shape = parse_shape(bytes, file_);
    if (!shape.is_mesh()) refuse_damaged(file_, "its mesh does not say where its faces came from");
    for (const int source : shape.face_source)
      if (source < -1 || source >= n_source_faces)
        refuse_damaged(file_, "a face came from one that is not there");
    JsonFields fields(json, file_, "the mesh");
    read_words(fields, shape.soup);
    fields.finish();
    try {
      return std::make_shared<const Mesh>(shape.soup, shape.is_flipped, shape.face_source);
    } catch (const Error& error) {
      refuse_damaged(file_, std::string("its mesh is none (") + error.what() + ")");
    }
  }

  void read_models(Project& project, const Json* mesh_json, const Json* made_json) const {
    JsonFields fields(made_json, file_, "how the mesh was made");
    auto made = std::make_shared<MadeModel>();
    const int n_source_faces = project.source->n_faces();
    const auto mesh = read_mesh(parts_.mesh, mesh_json, n_source_faces);
    made->groups = IdVector<FaceId, std::vector<int>>(fields.integer_lists("groups", 0, n_source_faces - 1));
    if (!made->groups.empty() && made->groups.size() != mesh->n_faces())
      fields.refuse("groups", "are not of this mesh");
    made->origins = origins_of(*mesh, made->groups);
    try {
      const auto hidden = project.recipe.merges ? hidden_folds(*mesh, project.recipe) : std::vector<EdgeId>();
      made->dual = std::make_shared<const DualGraph>(mesh, hidden);
    } catch (const Error& error) {
      refuse_damaged(file_, std::string("its mesh cannot be unfolded (") + error.what() + ")");
    }
    made->report = report_on(*mesh);
    made->difficulty = predicted_difficulty(*mesh);
    add_reader_notices(*project.source, made->report);
    made->done = fields.texts("done");
    if (project.recipe.faces > 0 && !fields.has("deviation")) made->deviation.reset();
    const double deviation = fields.number("deviation", 0, kMostNumber, 0);
    if (made->deviation) made->deviation = deviation;
    made->n_faces_least = static_cast<int>(fields.integer("fewest_faces", 0, kMostInt, 0));
    auto stages = std::make_shared<ModelStages>();
    stages->source = project.source;
    stages->recipe = project.recipe;
    stages->done = fields.texts("base_done");
    stages->file_lines = lines_about_file(*project.source);
    const Json* const base_json = fields.object("base");
    stages->mesh = parts_.base.empty() ? mesh : read_mesh(parts_.base, base_json, n_source_faces);
    fields.finish();
    // Without its parts the whole is not stored: another recipe makes it anew.
    if (stages->recipe.left_out.empty()) {
      stages->whole = stages->mesh;
      stages->repaired = stages->done;
    }
    made->stages = std::move(stages);
    project.dual = made->dual;
    project.made = std::move(made);
  }

  static std::uint64_t seed(JsonFields& fields) {
    return static_cast<std::uint64_t>(fields.integer("seed", -kMost - 1, kMost, 0));
  }

  void read_patches(JsonFields& fields, Constraints& pins, const Mesh& mesh) const {
    const Json::Array* const patches = fields.array("together");
    if (patches == nullptr) return;
    std::vector<char> is_taken(mesh.n_faces(), 0);
    for (const Json& patch : *patches) {
      const Json wrapped = Json().set("faces", patch);
      JsonFields one(&wrapped, file_, "a patch");
      std::vector<FaceId> faces;
      for (const int f : one.integers("faces", 0, static_cast<int>(mesh.n_faces()) - 1)) {
        if (std::exchange(is_taken[static_cast<std::size_t>(f)], 1) != 0)
          fields.refuse("together", "names a face twice");
        faces.emplace_back(f);
      }
      if (faces.size() < 2) fields.refuse("together", "has a patch of fewer than two faces");
      std::sort(faces.begin(), faces.end());
      pins.together.push_back(std::move(faces));
    }
  }

  Constraints read_pins(const Project& project, const Json* json, const char* what) const {
    JsonFields fields(json, file_, what);
    const Mesh& mesh = project.dual->mesh();
    const auto n_faces = static_cast<std::int64_t>(mesh.n_faces());
    Constraints pins;
    pins.root = FaceId(static_cast<std::int32_t>(fields.integer("root", -1, n_faces - 1, -1)));
    pins.must_fold = read_edges(fields, "must_fold", mesh);
    pins.must_cut = read_edges(fields, "must_cut", mesh);
    for (const EdgeId e : pins.must_fold) {
      if (mesh.is_border(e)) fields.refuse("must_fold", "names an edge of the border");
      if (std::binary_search(pins.must_cut.begin(), pins.must_cut.end(), e))
        fields.refuse("must_fold", "names an edge that must be cut");
    }
    read_patches(fields, pins, mesh);
    fields.finish();
    return pins;
  }

  static std::shared_ptr<const UnfoldTree> read_tree(const Mesh& mesh, JsonFields& fields) {
    const bool has_tree = fields.has("tree");
    const std::vector<int> corners = fields.integers("tree", -1, kMostInt);
    if (!has_tree) return nullptr;
    if (corners.size() != mesh.n_faces()) fields.refuse("tree", "is not one of this mesh");
    UnfoldTree tree(mesh.n_faces());
    for (const FaceId f : mesh.faces()) {
      const int corner = corners[f.index()];
      if (corner >= mesh.degree(f)) fields.refuse("tree", "is not one of this mesh");
      if (corner >= 0) tree.set_parent(f, HalfedgeId(mesh.first(f).value + corner));
    }
    if (!tree.is_forest(mesh)) fields.refuse("tree", "does not hang together");
    return std::make_shared<const UnfoldTree>(std::move(tree));
  }

  std::vector<KeptRun> read_runs(const Mesh& mesh, JsonFields& fields) const {
    std::vector<KeptRun> runs;
    const Json::Array* const items = fields.array("runs");
    if (items == nullptr) return runs;
    if (items->size() > kMostKeptRuns) fields.refuse("runs", "are more than any project keeps");
    for (const Json& item : *items) {
      JsonFields one(&item, file_, "a run");
      const RunSummary summary = read_run(one.object("run"));
      runs.push_back({read_tree(mesh, one), summary});
      if (!runs.back().tree) one.refuse("tree", "is missing");
      one.finish();
    }
    return runs;
  }

  RunSummary read_run(const Json* json) const {
    JsonFields fields(json, file_, "the run");
    RunSummary run;
    run.seed = seed(fields);
    run.moves = fields.integer("moves", 0, kMost, 0);
    run.restarts = static_cast<int>(fields.integer("restarts", 0, kMostInt, 0));
    run.seconds = fields.number("seconds", 0, kMostNumber, 0);
    run.overlaps = static_cast<int>(fields.integer("overlaps", 0, kMostInt, 0));
    run.is_proved = fields.flag("proved", false);
    fields.finish();
    return run;
  }

  PaperSetup read_paper(const Json* json) const {
    JsonFields fields(json, file_, "the paper");
    PaperSetup paper;
    paper.format = fields.text("format", paper.format);
    if (!find_paper(paper.format)) fields.refuse("format", "is a paper that this Netwright does not know");
    paper.orientation = static_cast<Orientation>(fields.choice("orientation", kOrientation, 0));
    paper.margin_mm = fields.number("margin_mm", 0, kMostMillimetres, paper.margin_mm);
    fields.finish();
    return paper;
  }

  PrintSize read_size(const Json* json, const Mesh& mesh) const {
    JsonFields fields(json, file_, "the size");
    PrintSize size;
    size.kind = static_cast<PrintSize::Kind>(fields.choice("kind", kSizes, 0));
    size.height_mm = fields.number("height_mm", 0, kMostMillimetres, size.height_mm);
    const std::vector<EdgeId> edges = read_edges(fields, "edge", mesh);
    if (!edges.empty()) size.edge = edges.front();
    size.edge_mm = fields.number("edge_mm", 0, kMostMillimetres, size.edge_mm);
    size.scale = fields.number("scale", 0, kMostNumber, size.scale);
    size.sheets = static_cast<int>(fields.integer("sheets", 1, kMostFittedSheets, size.sheets));
    if (size.kind == PrintSize::Kind::EdgeLength && !size.edge.is_valid())
      fields.refuse("edge", "is missing");
    fields.finish();
    return size;
  }

  HandLayout read_placed(const Project& project, const Json* json) const {
    JsonFields fields(json, file_, "the placed pieces");
    const int last_face = static_cast<int>(project.dual->mesh().n_faces()) - 1;
    HandLayout placed;
    placed.is_landscape = fields.flag("landscape", false);
    placed.scale = fields.number("scale", kLeastScale, kMostMillimetres, placed.scale);
    const std::vector<int> canvases = fields.integers("canvases", 1, kMostTilesAlong);
    const std::vector<int> faces = fields.integers("faces", 0, last_face);
    const std::vector<int> on = fields.integers("on", 0, static_cast<int>(canvases.size() / 2) - 1);
    const std::vector<double> turns = fields.numbers("turns", -kMostMillimetres, kMostMillimetres);
    fields.finish();
    if (canvases.size() % 2 != 0 || on.size() != faces.size() || turns.size() != 4 * faces.size())
      fields.refuse("faces", "do not match their places");
    if (!faces.empty() && !project.tree) fields.refuse("faces", "are of no net");
    for (std::size_t i = 0; i < canvases.size(); i += 2)
      placed.canvases.push_back({canvases[i], canvases[i + 1]});
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Rigid2 turn{turns[4 * i], turns[4 * i + 1], turns[4 * i + 2], turns[4 * i + 3]};
      // Anything but a turn would print the piece at another size.
      constexpr double kRounding = 1e-9;
      if (std::abs(std::hypot(turn.cos, turn.sin) - 1) > kRounding) fields.refuse("turns", "are no turns");
      placed.places.push_back({FaceId(faces[i]), on[i], turn});
    }
    return placed;
  }

  const ProjectParts& parts_;
  const std::string& file_;
  Json json_;
  std::vector<std::shared_ptr<const Image>> pictures_;
};

}  // namespace

StoredProject from_parts(const ProjectParts& parts, const std::string& file) {
  return Reader(parts, file).read();
}

ProjectOutline outline_of(const std::string& json, const std::string& file) {
  ProjectParts parts;
  parts.json = json;
  return Reader(parts, file).outline();
}

}  // namespace netwright
