// glTF and GLB through tinygltf: the scene is flattened into one soup with its nodes' motions applied;
// triangles, strips and fans become faces. tinygltf passes ranges on unchecked, so every access is checked
// here.
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <limits>

#include "core/mesh/pictures.h"
#include "core/mesh/readers.h"

namespace netwright::readers {
namespace {

constexpr std::size_t kMaxCorners = 60'000'000;  // repeated instances of one mesh can multiply without end
constexpr int kMaxDepth = 100;                   // nodes inside nodes; a cycle is caught by it too

template <class T>
double load(const unsigned char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return static_cast<double>(value);
}

template <class T>
double load_fraction(const unsigned char* at) {
  return std::max(load<T>(at) / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
}

/// A checked window on the numbers of an accessor.
struct Numbers {
  const unsigned char* data = nullptr;
  std::size_t count = 0;
  std::size_t stride = 0;
  std::size_t width = 0;  ///< bytes of one component
  int type = 0;
  bool is_fraction = false;

  [[nodiscard]] double operator()(std::size_t i, std::size_t component = 0) const {
    const unsigned char* at = data + i * stride + component * width;
    switch (type) {
      case TINYGLTF_COMPONENT_TYPE_BYTE:
        return is_fraction ? load_fraction<std::int8_t>(at) : load<std::int8_t>(at);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return is_fraction ? load_fraction<std::uint8_t>(at) : load<std::uint8_t>(at);
      case TINYGLTF_COMPONENT_TYPE_SHORT:
        return is_fraction ? load_fraction<std::int16_t>(at) : load<std::int16_t>(at);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return is_fraction ? load_fraction<std::uint16_t>(at) : load<std::uint16_t>(at);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return load<std::uint32_t>(at);
      case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return load<float>(at);
      default:
        return std::numeric_limits<double>::quiet_NaN();
    }
  }
};

template <class T>
const T* item(const std::vector<T>& items, int index) {
  return index >= 0 && static_cast<std::size_t>(index) < items.size()
             ? &items[static_cast<std::size_t>(index)]
             : nullptr;
}

/// The bytes that a buffer view covers; empty when it leaves its buffer.
std::span<const unsigned char> view_bytes(const tinygltf::Model& model, int index) {
  const tinygltf::BufferView* view = item(model.bufferViews, index);
  const tinygltf::Buffer* buffer = view != nullptr ? item(model.buffers, view->buffer) : nullptr;
  if (buffer == nullptr || view->byteOffset > buffer->data.size() ||
      view->byteLength > buffer->data.size() - view->byteOffset) {
    return {};
  }
  return std::span(buffer->data).subspan(view->byteOffset, view->byteLength);
}

glm::dmat4 local_motion(const tinygltf::Node& node) {
  glm::dmat4 m(1);
  if (node.matrix.size() == 16) {
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
    return m;
  }
  if (node.rotation.size() == 4) {
    const glm::dquat q(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
    m = glm::dmat4(glm::mat3_cast(q));
  }
  for (int axis = 0; node.scale.size() == 3 && axis < 3; ++axis) {
    m[axis] *= node.scale[static_cast<std::size_t>(axis)];
  }
  for (int axis = 0; node.translation.size() == 3 && axis < 3; ++axis) {
    m[3][axis] = node.translation[static_cast<std::size_t>(axis)];
  }
  return m;
}

class SceneReader {
 public:
  SceneReader(const std::string& name, const tinygltf::Model& model) : name_(name), model_(model) {
    soup_.is_indexed = false;
  }

  PolygonSoup read() {
    for (const std::string& extension : model_.extensionsRequired) {
      if (extension == "KHR_draco_mesh_compression" || extension == "EXT_meshopt_compression") {
        refuse(name_, "its shape is stored with " + extension + "; export it without compression.");
      }
    }
    add_materials();
    for (const int root : roots()) add_node(root, glm::dmat4(1), 0);
    if (n_left_out_ > 0) {
      soup_.notices.push_back(std::to_string(n_left_out_) + " parts made of points or lines were left out.");
    }
    if (!has_uv_) soup_.corner_uv.clear();
    if (soup_.materials.empty()) soup_.face_material.clear();
    return std::move(soup_);
  }

 private:
  [[nodiscard]] std::vector<int> roots() const {
    const tinygltf::Scene* scene = item(model_.scenes, std::max(model_.defaultScene, 0));
    if (scene != nullptr) return scene->nodes;
    std::vector<char> is_child(model_.nodes.size(), 0);
    for (const tinygltf::Node& node : model_.nodes) {
      for (const int child : node.children) {
        if (item(model_.nodes, child) != nullptr) is_child[static_cast<std::size_t>(child)] = 1;
      }
    }
    std::vector<int> roots;
    for (std::size_t i = 0; i < is_child.size(); ++i) {
      if (is_child[i] == 0) roots.push_back(static_cast<int>(i));
    }
    return roots;
  }

  void add_node(int index, const glm::dmat4& outer, int depth) {
    const tinygltf::Node* node = item(model_.nodes, index);
    if (node == nullptr)
      refuse(name_,
             "its scene names node " + std::to_string(index) + ", which is not there; export it again.");
    if (depth > kMaxDepth) refuse(name_, "its nodes lie more than 100 deep in one another; export it again.");
    const glm::dmat4 motion = outer * local_motion(*node);
    if (const tinygltf::Mesh* mesh = item(model_.meshes, node->mesh)) {
      for (const tinygltf::Primitive& primitive : mesh->primitives) add_primitive(primitive, motion);
    }
    for (const int child : node->children) add_node(child, motion, depth + 1);
  }

  void add_primitive(const tinygltf::Primitive& primitive, const glm::dmat4& motion) {
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    if (mode < TINYGLTF_MODE_TRIANGLES) {
      ++n_left_out_;
      return;
    }
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end())
      refuse(name_, "a part of it has no positions; export it again.");
    const Numbers points = numbers(position->second, TINYGLTF_TYPE_VEC3);
    first_point_ = soup_.points.size();
    for (std::size_t i = 0; i < points.count; ++i) {
      soup_.points.emplace_back(motion * glm::dvec4(points(i, 0), points(i, 1), points(i, 2), 1));
    }
    uv_ = Numbers{};
    if (const auto uv = primitive.attributes.find("TEXCOORD_" + std::to_string(uv_set(primitive)));
        uv != primitive.attributes.end()) {
      uv_ = numbers(uv->second, TINYGLTF_TYPE_VEC2);
    }
    material_ = item(model_.materials, primitive.material) != nullptr ? primitive.material : -1;
    is_mirrored_ = glm::determinant(glm::dmat3(motion)) < 0;
    add_triangles(mode, corner_list(primitive, points.count));
  }

  [[nodiscard]] int uv_set(const tinygltf::Primitive& primitive) const {
    const tinygltf::Material* material = item(model_.materials, primitive.material);
    return material == nullptr ? 0 : material->pbrMetallicRoughness.baseColorTexture.texCoord;
  }

  [[nodiscard]] std::vector<std::size_t> corner_list(const tinygltf::Primitive& primitive,
                                                     std::size_t n_points) const {
    std::vector<std::size_t> corners;
    if (primitive.indices < 0) {
      for (std::size_t i = 0; i < n_points; ++i) corners.push_back(i);
      return corners;
    }
    const Numbers indices = numbers(primitive.indices, TINYGLTF_TYPE_SCALAR);
    corners.reserve(indices.count);
    for (std::size_t i = 0; i < indices.count; ++i) {
      const double index = indices(i);
      if (!(index >= 0 && index < static_cast<double>(n_points))) {
        refuse(name_,
               "corner " + std::to_string(i + 1) +
                   " of a part names a point that is not there; the file is damaged, export it again.");
      }
      corners.push_back(static_cast<std::size_t>(index));
    }
    return corners;
  }

  void add_triangles(int mode, const std::vector<std::size_t>& c) {
    if (soup_.corners.size() + 3 * c.size() > kMaxCorners) {
      refuse(name_, "it has more than twenty million triangles; simplify it in a modelling program first.");
    }
    if (mode == TINYGLTF_MODE_TRIANGLES && c.size() % 3 != 0) {
      refuse(name_, "its last triangle is incomplete; the file is damaged, export it again.");
    }
    const std::size_t step = mode == TINYGLTF_MODE_TRIANGLES ? 3 : 1;
    for (std::size_t i = 0; i + 2 < c.size(); i += step) {
      const bool is_odd = mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1;
      const std::size_t first = mode == TINYGLTF_MODE_TRIANGLE_FAN ? c[0] : c[i];
      if (is_odd != is_mirrored_) {
        add_triangle({first, c[i + 2], c[i + 1]});
      } else {
        add_triangle({first, c[i + 1], c[i + 2]});
      }
    }
  }

  void add_triangle(const std::array<std::size_t, 3>& corners) {
    std::array<int, 3> face{};
    for (std::size_t k = 0; k < 3; ++k) {
      face[k] = static_cast<int>(first_point_ + corners[k]);
      const bool is_there = corners[k] < uv_.count;
      has_uv_ |= is_there;
      soup_.corner_uv.push_back(is_there ? glm::dvec2(uv_(corners[k], 0), 1 - uv_(corners[k], 1))
                                         : glm::dvec2(0));
    }
    soup_.add_face(face);
    soup_.face_material.push_back(material_);
  }

  [[nodiscard]] Numbers numbers(int index, int type) const {
    const tinygltf::Accessor* accessor = item(model_.accessors, index);
    if (accessor == nullptr || accessor->type != type)
      refuse(name_, "a part of it names data that is not there; export it again.");
    if (accessor->sparse.isSparse)
      refuse(name_, "its points are stored sparsely; export it without morph targets.");
    const std::span<const unsigned char> bytes = view_bytes(model_, accessor->bufferView);
    const int width = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor->componentType));
    const int n = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(type));
    const int stride =
        bytes.empty()
            ? -1
            : accessor->ByteStride(model_.bufferViews[static_cast<std::size_t>(accessor->bufferView)]);
    const auto element = static_cast<std::size_t>(std::max(width * n, 1));
    const bool fits =
        stride > 0 && width > 0 && accessor->byteOffset <= bytes.size() &&
        (accessor->count == 0 || (bytes.size() - accessor->byteOffset >= element &&
                                  accessor->count - 1 <= (bytes.size() - accessor->byteOffset - element) /
                                                             static_cast<std::size_t>(stride)));
    if (!fits)
      refuse(name_,
             "it promises more points than it holds; the file was cut short or damaged, export it again.");
    return {.data = bytes.data() + accessor->byteOffset,
            .count = accessor->count,
            .stride = static_cast<std::size_t>(stride),
            .width = static_cast<std::size_t>(width),
            .type = accessor->componentType,
            .is_fraction = accessor->normalized};
  }

  void add_materials() {
    std::vector<std::shared_ptr<const Image>> pictures(model_.images.size());
    for (const tinygltf::Material& material : model_.materials) {
      Material mine{.name = material.name, .texture = nullptr};
      const tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
      if (pbr.baseColorFactor.size() >= 3) {
        mine.colour = {pbr.baseColorFactor[0], pbr.baseColorFactor[1], pbr.baseColorFactor[2]};
      }
      const tinygltf::Texture* texture = item(model_.textures, pbr.baseColorTexture.index);
      if (texture != nullptr && item(model_.images, texture->source) != nullptr) {
        std::shared_ptr<const Image>& picture = pictures[static_cast<std::size_t>(texture->source)];
        if (!picture) picture = load_picture(model_.images[static_cast<std::size_t>(texture->source)]);
        mine.texture = picture;
      }
      soup_.materials.push_back(std::move(mine));
    }
    for (std::string& notice : pictures_.notices()) soup_.notices.push_back(std::move(notice));
  }

  std::shared_ptr<const Image> load_picture(const tinygltf::Image& image) {
    const std::span<const unsigned char> bytes =
        image.bufferView >= 0 ? view_bytes(model_, image.bufferView) : std::span(image.image);
    if (bytes.empty() && image.bufferView < 0 && !image.uri.empty()) {
      pictures_.miss(image.uri);
      return nullptr;
    }
    return pictures_.from_bytes(image.uri.empty() ? image.name : image.uri,
                                {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }

  const std::string& name_;
  const tinygltf::Model& model_;
  Pictures pictures_;
  PolygonSoup soup_;
  int n_left_out_ = 0;
  bool has_uv_ = false;
  // The part being added.
  std::size_t first_point_ = 0;
  Numbers uv_;
  int material_ = -1;
  bool is_mirrored_ = false;
};

/// Lets tinygltf find companion files through our lookup only.
tinygltf::FsCallbacks file_callbacks(const CompanionLookup& companions) {
  tinygltf::FsCallbacks files{};
  files.FileExists = [](const std::string& file, void* data) {
    const auto& lookup = *static_cast<const CompanionLookup*>(data);
    return lookup && lookup(file).has_value();
  };
  files.ExpandFilePath = [](const std::string& file, void*) { return file; };
  files.ReadWholeFile = [](std::vector<unsigned char>* out, std::string*, const std::string& file,
                           void* data) {
    const auto& lookup = *static_cast<const CompanionLookup*>(data);
    const std::optional<std::string> bytes = lookup ? lookup(file) : std::nullopt;
    if (bytes) out->assign(bytes->begin(), bytes->end());
    return bytes.has_value();
  };
  files.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
  };
  files.user_data = const_cast<CompanionLookup*>(&companions);
  return files;
}

/// Keeps a picture's bytes for later; those inside a buffer are fetched afterwards, with their range checked.
bool keep_picture(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                  const unsigned char* bytes, int size, void*) {
  if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
  return true;
}

/// What tinygltf said, as the middle of a sentence.
std::string as_clause(const std::string& said) {
  std::string clause = said.substr(0, said.find('\n'));
  while (clause.ends_with('.') || clause.ends_with(' ')) clause.pop_back();
  return clause.empty() ? "no reason given" : clause;
}

}  // namespace

PolygonSoup read_gltf(const std::string& name, std::string_view bytes, const CompanionLookup& companions) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks(file_callbacks(companions));
  loader.SetImageLoader(keep_picture, nullptr);
  tinygltf::Model model;
  std::string error;
  std::string warning;
  const auto size = static_cast<unsigned int>(bytes.size());
  const bool is_read =
      bytes.starts_with("glTF")
          ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                        reinterpret_cast<const unsigned char*>(bytes.data()), size)
          : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, "");
  if (!is_read) {
    refuse(name, "this glTF file is incomplete or damaged (" + as_clause(error) +
                     "); put its companion files beside it or export it again.");
  }
  return SceneReader(name, model).read();
}

}  // namespace netwright::readers
