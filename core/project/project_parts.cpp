// The JSON in a project file, and how the meshes beside it are tied to it. Faces and corners are numbered as
// the stored mesh has them, so neither a change of the repairs nor of the edges' order can shift a tree.
#include "core/project/project_parts.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "core/base/json.h"
#include "core/project/json_fields.h"
#include "core/project/shape_bytes.h"

namespace netwright {

namespace {

constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();
constexpr int kMostInt = std::numeric_limits<int>::max();
constexpr double kMostNumber = std::numeric_limits<double>::max();
constexpr double kMostMillimetres = 1e6;

constexpr std::array<std::string_view, 2> kUp{"y", "z"};
constexpr std::array<std::string_view, 3> kUneven{"refuse", "split", "flatten"};
constexpr std::array<std::string_view, 3> kOrientation{"auto", "portrait", "landscape"};
constexpr std::array<std::string_view, 2> kSizes{"fit_page", "height"};

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

Json recipe_json(const Recipe& recipe) {
  Json json;
  if (recipe.up) json.set("up", word(kUp, *recipe.up));
  json.set("repairs", recipe.repairs);
  json.set("uneven", word(kUneven, recipe.uneven));
  json.set("faces", recipe.faces);
  json.set("merges", recipe.merges);
  return json;
}

/// Per face the corner where the side to its parent begins, -1 for a root.
Json tree_json(const UnfoldTree& tree, const Mesh& mesh) {
  Json json{Json::Array{}};
  for (const FaceId f : mesh.faces())
    json.add(tree.is_root(f) ? -1 : tree.to_parent(f).value - mesh.first(f).value);
  return json;
}

/// Face and corner where the edge begins, face and corner …
Json edges_json(const std::vector<EdgeId>& edges, const Mesh& mesh) {
  Json json{Json::Array{}};
  for (const EdgeId e : edges) {
    const HalfedgeId h = mesh.halfedge(e);
    json.add(mesh.face(h).value);
    json.add(h.value - mesh.first(mesh.face(h)).value);
  }
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

Json project_json(const Project& project, const std::filesystem::path& belongs_to, Pictures& pictures) {
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
  made_json.set("deviation", made.deviation);
  made_json.set("fewest_faces", made.n_faces_least);
  json.set("made", std::move(made_json));
  json.set("pins", pins_json(project.pins, mesh));
  json.set("seed", seed_json(project.seed));
  if (project.tree) json.set("tree", tree_json(*project.tree, mesh));
  if (project.run) json.set("run", run_json(*project.run));
  Json paper;
  paper.set("format", project.paper.format);
  paper.set("orientation", word(kOrientation, project.paper.orientation));
  paper.set("margin_mm", project.paper.margin_mm);
  json.set("paper", std::move(paper));
  Json size;
  size.set("kind", word(kSizes, project.size.kind));
  size.set("height_mm", project.size.height_mm);
  json.set("size", std::move(size));
  return json;
}

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
    read_pins(project, fields.object("pins"));
    read_tree(project, fields);
    if (fields.has("run")) project.run = read_run(fields.object("run"));
    if (project.run && !project.tree) fields.refuse("run", "led to no tree");
    static_cast<void>(fields.object("run"));
    project.paper = read_paper(fields.object("paper"));
    project.size = read_size(fields.object("size"));
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

  Recipe read_recipe(const Json* json) const {
    JsonFields fields(json, file_, "the recipe");
    Recipe recipe;
    const int up = fields.choice("up", kUp, -1);
    if (up >= 0) recipe.up = static_cast<UpAxis>(up);
    recipe.repairs = fields.flag("repairs", recipe.repairs);
    recipe.uneven = static_cast<UnevenFaces>(fields.choice("uneven", kUneven, 0));
    recipe.faces = static_cast<int>(fields.integer("faces", 0, kMostInt, recipe.faces));
    recipe.merges = fields.flag("merges", recipe.merges);
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
    try {
      made->dual = std::make_shared<const DualGraph>(mesh);
    } catch (const Error& error) {
      refuse_damaged(file_, std::string("its mesh cannot be unfolded (") + error.what() + ")");
    }
    made->report = report_on(*mesh);
    add_reader_notices(*project.source, made->report);
    made->done = fields.texts("done");
    made->deviation = fields.number("deviation", 0, kMostNumber, 0);
    made->n_faces_least = static_cast<int>(fields.integer("fewest_faces", 0, kMostInt, 0));
    auto stages = std::make_shared<ModelStages>();
    stages->source = project.source;
    stages->recipe = project.recipe;
    stages->done = fields.texts("base_done");
    const Json* const base_json = fields.object("base");
    stages->mesh = parts_.base.empty() ? mesh : read_mesh(parts_.base, base_json, n_source_faces);
    fields.finish();
    made->stages = std::move(stages);
    project.dual = made->dual;
    project.made = std::move(made);
  }

  static std::uint64_t seed(JsonFields& fields) {
    return static_cast<std::uint64_t>(fields.integer("seed", -kMost - 1, kMost, 0));
  }

  static std::vector<EdgeId> read_edges(JsonFields& fields, std::string_view key, const Mesh& mesh) {
    const std::vector<int> numbers = fields.integers(key, 0, kMostInt);
    std::vector<EdgeId> edges;
    for (std::size_t i = 0; i < numbers.size(); i += 2) {
      const FaceId f(numbers[i]);
      const bool is_there =
          i + 1 < numbers.size() && f.index() < mesh.n_faces() && numbers[i + 1] < mesh.degree(f);
      if (!is_there) fields.refuse(key, "names an edge that is not there");
      edges.push_back(mesh.edge(HalfedgeId(mesh.first(f).value + numbers[i + 1])));
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
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

  void read_pins(Project& project, const Json* json) const {
    JsonFields fields(json, file_, "the pins");
    const Mesh& mesh = project.dual->mesh();
    const auto n_faces = static_cast<std::int64_t>(mesh.n_faces());
    Constraints& pins = project.pins;
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
  }

  static void read_tree(Project& project, JsonFields& fields) {
    const bool has_tree = fields.has("tree");
    const std::vector<int> corners = fields.integers("tree", -1, kMostInt);
    if (!has_tree) return;
    const Mesh& mesh = project.dual->mesh();
    if (corners.size() != mesh.n_faces()) fields.refuse("tree", "is not one of this mesh");
    UnfoldTree tree(mesh.n_faces());
    for (const FaceId f : mesh.faces()) {
      const int corner = corners[f.index()];
      if (corner >= mesh.degree(f)) fields.refuse("tree", "is not one of this mesh");
      if (corner >= 0) tree.set_parent(f, HalfedgeId(mesh.first(f).value + corner));
    }
    if (!tree.is_forest(mesh)) fields.refuse("tree", "does not hang together");
    project.tree = std::make_shared<const UnfoldTree>(std::move(tree));
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

  PrintSize read_size(const Json* json) const {
    JsonFields fields(json, file_, "the size");
    PrintSize size;
    size.kind = static_cast<PrintSize::Kind>(fields.choice("kind", kSizes, 0));
    size.height_mm = fields.number("height_mm", 0, kMostMillimetres, size.height_mm);
    fields.finish();
    return size;
  }

  const ProjectParts& parts_;
  const std::string& file_;
  Json json_;
  std::vector<std::shared_ptr<const Image>> pictures_;
};

}  // namespace

ProjectParts to_parts(const Project& project, const std::filesystem::path& belongs_to, PictureCache* cache) {
  Pictures pictures(cache);
  ProjectParts parts;
  parts.json = to_text(project_json(project, belongs_to, pictures), {.is_indented = true});
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

StoredProject from_parts(const ProjectParts& parts, const std::string& file) {
  return Reader(parts, file).read();
}

ProjectOutline outline_of(const std::string& json, const std::string& file) {
  ProjectParts parts;
  parts.json = json;
  return Reader(parts, file).outline();
}

}  // namespace netwright
