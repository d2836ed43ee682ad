// STL, PLY, 3MF, Collada and 3DS through Assimp without any post-processing. Runs only in the helper program
// (read_helper.cpp), never in the editor's own process.
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <memory>
#include <new>
#include <optional>

#include "core/base/error.h"
#include "core/mesh/face_colours.h"
#include "core/mesh/readers.h"

namespace netwright::readers {
namespace {

class SceneReader {
 public:
  SceneReader(const aiScene& scene, const std::string& extension)
      : scene_(scene), has_looks_(extension != "stl" && extension != "3mf") {}

  ParsedModel read() {
    for (unsigned m = 0; has_looks_ && m < scene_.mNumMaterials; ++m) add_material(*scene_.mMaterials[m]);
    add_node(*scene_.mRootNode, aiMatrix4x4());
    PolygonSoup& soup = model_.soup;
    if (!has_uv_) soup.corner_uv.clear();
    colour_faces(soup, colours_);
    if (soup.materials.empty()) soup.face_material.clear();
    model_.picture_of.resize(soup.materials.size(), -1);
    return std::move(model_);
  }

 private:
  /// How a material's picture is repeated and shifted.
  struct Tiling {
    glm::dvec2 scale{1};
    glm::dvec2 shift{0};
  };

  void add_material(const aiMaterial& material) {
    const std::string name = material.GetName().C_Str();
    aiColor3D colour(0.8F, 0.8F, 0.8F);
    material.Get(AI_MATKEY_COLOR_DIFFUSE, colour);
    const int picture = add_picture(material);
    // What Assimp makes up for models without materials is no colour of theirs.
    const bool is_made_up = picture < 0 && name == AI_DEFAULT_MATERIAL_NAME;
    number_.push_back(is_made_up ? -1 : static_cast<int>(model_.soup.materials.size()));
    Tiling tiling;
    if (aiUVTransform turn; material.Get(AI_MATKEY_UVTRANSFORM_DIFFUSE(0), turn) == AI_SUCCESS) {
      tiling = {{turn.mScaling.x, turn.mScaling.y}, {turn.mTranslation.x, turn.mTranslation.y}};
    }
    tilings_.push_back(tiling);
    if (is_made_up) return;
    const glm::dvec3 srgb(colour.r, colour.g, colour.b);
    model_.soup.materials.push_back({.name = name, .colour = linear_colour(srgb), .texture = nullptr});
    model_.picture_of.push_back(picture);
  }

  int add_picture(const aiMaterial& material) {
    aiString file;
    for (const aiTextureType type : {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR}) {
      if (material.GetTexture(type, 0, &file) == AI_SUCCESS && file.length > 0) break;
      file.Clear();
    }
    if (file.length == 0) return -1;
    ParsedModel::Picture picture{.name = file.C_Str(), .bytes = {}};
    for (std::size_t p = 0; p < model_.pictures.size(); ++p)
      if (model_.pictures[p].name == picture.name) return static_cast<int>(p);
    const aiTexture* inside = scene_.GetEmbeddedTexture(file.C_Str());
    // With a height it would be bare pixels, which none of these formats hold.
    if (inside != nullptr && inside->mHeight == 0 && inside->pcData != nullptr)
      picture.bytes.assign(reinterpret_cast<const char*>(inside->pcData), inside->mWidth);
    model_.pictures.push_back(std::move(picture));
    return static_cast<int>(model_.pictures.size()) - 1;
  }

  void add_node(const aiNode& node, const aiMatrix4x4& outer) {
    const aiMatrix4x4 motion = outer * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) add_mesh(*scene_.mMeshes[node.mMeshes[i]], motion);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add_node(*node.mChildren[i], motion);
  }

  void add_mesh(const aiMesh& mesh, const aiMatrix4x4& motion) {
    const std::size_t first = model_.soup.points.size();
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D p = motion * mesh.mVertices[i];
      model_.soup.points.emplace_back(p.x, p.y, p.z);
    }
    std::vector<int> corners;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      corners.clear();
      for (unsigned k = 0; k < face.mNumIndices; ++k) {
        if (face.mIndices[k] >= mesh.mNumVertices) {
          throw Error(ErrorKind::Read, "face " + std::to_string(f + 1) + " names point " +
                                           std::to_string(face.mIndices[k]) + " of only " +
                                           std::to_string(mesh.mNumVertices));
        }
        corners.push_back(static_cast<int>(first + face.mIndices[k]));
      }
      model_.soup.add_face(corners);
      dress_face(mesh, face);
    }
  }

  void dress_face(const aiMesh& mesh, const aiFace& face) {
    const std::size_t m = mesh.mMaterialIndex;
    const int material = m < number_.size() ? number_[m] : -1;
    model_.soup.face_material.push_back(material);
    const bool has_picture = material >= 0 && model_.picture_of[static_cast<std::size_t>(material)] >= 0;
    const bool has_uv = has_looks_ && mesh.HasTextureCoords(0);
    has_uv_ |= has_uv;
    const Tiling tiling = has_picture ? tilings_[m] : Tiling();
    glm::dvec3 sum(0);
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      const unsigned i = face.mIndices[k];
      const aiVector3D uv = has_uv ? mesh.mTextureCoords[0][i] : aiVector3D();
      model_.soup.corner_uv.push_back(glm::dvec2(uv.x, uv.y) * tiling.scale + tiling.shift);
      if (!mesh.HasVertexColors(0)) continue;
      const aiColor4D& c = mesh.mColors[0][i];
      sum += glm::dvec3(c.r, c.g, c.b) / static_cast<double>(face.mNumIndices);
    }
    const bool has_colour = has_looks_ && mesh.HasVertexColors(0) && !has_picture && face.mNumIndices > 0;
    colours_.push_back(has_colour ? std::optional(sum) : std::nullopt);
  }

  const aiScene& scene_;
  bool has_looks_;  ///< not with STL, where none are meant, nor with 3MF, where Assimp mixes them up
  bool has_uv_ = false;
  ParsedModel model_;
  std::vector<int> number_;  ///< in the soup, of each of the scene's materials
  std::vector<Tiling> tilings_;
  std::vector<std::optional<glm::dvec3>> colours_;
};

}  // namespace

ParsedModel parse_with_assimp(std::string_view bytes, const std::string& extension) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, extension.c_str());
  if (scene == nullptr || scene->mRootNode == nullptr) {
    const std::string said = importer.GetErrorString();
    if (said.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
    throw Error(ErrorKind::Read, said);
  }
  return SceneReader(*scene, extension).read();
}

}  // namespace netwright::readers
