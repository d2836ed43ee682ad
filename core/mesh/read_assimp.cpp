// STL, PLY, 3MF, Collada and 3DS through Assimp without any post-processing. Runs only in the helper program
// (read_helper.cpp), never in the editor's own process.
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <memory>
#include <new>

#include "core/base/error.h"
#include "core/mesh/readers.h"

namespace netwright::readers {
namespace {

void add_mesh(PolygonSoup& soup, const aiMesh& mesh, const aiMatrix4x4& motion) {
  const std::size_t first = soup.points.size();
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const aiVector3D p = motion * mesh.mVertices[i];
    soup.points.emplace_back(p.x, p.y, p.z);
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
    soup.add_face(corners);
  }
}

void add_node(PolygonSoup& soup, const aiScene& scene, const aiNode& node, const aiMatrix4x4& outer) {
  const aiMatrix4x4 motion = outer * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) add_mesh(soup, *scene.mMeshes[node.mMeshes[i]], motion);
  for (unsigned i = 0; i < node.mNumChildren; ++i) add_node(soup, scene, *node.mChildren[i], motion);
}

}  // namespace

PolygonSoup read_with_assimp(std::string_view bytes, const std::string& extension) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(bytes.data(), bytes.size(), 0, extension.c_str());
  if (scene == nullptr || scene->mRootNode == nullptr) {
    const std::string said = importer.GetErrorString();
    if (said.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
    throw Error(ErrorKind::Read, said);
  }
  PolygonSoup soup;
  add_node(soup, *scene, *scene->mRootNode, aiMatrix4x4());
  return soup;
}

}  // namespace netwright::readers
