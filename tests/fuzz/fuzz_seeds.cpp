// Writes small files of every fuzzed format to folders beside each other: what the fuzzers start from.
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/mesh/readers.h"
#include "core/project/project_file.h"
#include "core/sheet/fold_file.h"
#include "core/unfold/net.h"
#include "core/unfold/steepest_edge.h"
#include "tests/model_files.h"
#include "tests/project_support.h"
#include "tests/support.h"

namespace {

using namespace netwright;

void write(const std::filesystem::path& folder, const std::string& name, const std::string& bytes) {
  std::filesystem::create_directories(folder);
  testing::write_file(folder / name, bytes);
}

std::string fold_of(const PolygonSoup& soup) {
  auto dual = testing::make_dual(soup);
  Random random(1);
  UnfoldTree tree = steepest_edge_tree(*dual, random);
  return fold_text(to_flat_net(layout(dual, std::move(tree)), 10));
}

std::string base64(const std::string& bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto at = [&](std::size_t k) {
      return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U;
    };
    const unsigned three = at(i) << 16U | at(i + 1) << 8U | at(i + 2);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? kDigits[three >> (18 - 6 * k) & 63U] : '=';
  }
  return text;
}

/// As the fuzzer of projects cuts it.
std::string in_one(const ProjectParts& parts) {
  std::string bytes;
  for (const std::string& part : {parts.json, parts.source, parts.base, parts.mesh}) {
    testing::append(bytes, static_cast<std::uint32_t>(part.size()));
    bytes += part;
  }
  return parts.pictures.empty() ? bytes : bytes + parts.pictures.front();
}

/// In the formats that the helper program reads, and its answer about one of them.
void write_helped(const std::filesystem::path& root, const std::string& name, const PolygonSoup& soup) {
  write(root / "stl", name + ".binary", testing::to_binary_stl(soup));
  write(root / "stl", name + ".text", testing::to_text_stl(soup));
  write(root / "ply", name + ".binary", testing::to_binary_ply(soup));
  write(root / "ply", name + ".text", testing::to_text_ply(soup));
  write(root / "3mf", name, testing::to_3mf(soup));
  write(root / "dae", name, testing::to_dae(soup));
  write(root / "3ds", name, testing::to_3ds(soup));
  readers::ParsedModel parsed;
  parsed.soup = soup;
  write(root / "answer", name, readers::pack(parsed));
}

void write_project(const std::filesystem::path& folder, const std::string& name, Project project) {
  project = testing::solved(std::move(project));
  project.path = "model.obj";
  write(folder, name + ".zip", project_bytes(project, "project.netwright"));
  write(folder, name + ".parts", in_one(to_parts(project, {}, nullptr)));
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path root = argc > 1 ? argv[1] : "seeds";
  std::vector<PolygonSoup> soups{shapes::tetrahedron(), shapes::cube(), shapes::letter_l(),
                                 shapes::cuboid_with_holes(1, 1), shapes::bumpy_patch(2, 2)};
  soups.push_back(shapes::globe(3, 4));
  int n = 0;
  for (const PolygonSoup& soup : soups) {
    const std::string name = std::to_string(++n);
    write(root / "off", name, testing::to_off(soup));
    write(root / "obj", name, shapes::to_obj(soup));
    write(root / "fold", name, fold_of(soup));
    write_helped(root, name, soup);
  }
  for (const PolygonSoup& soup : {shapes::tetrahedron(), shapes::icosphere(1), shapes::bumpy_patch(2, 2)}) {
    const std::string uri = "data:application/octet-stream;base64," + base64(testing::gltf_buffer(soup));
    write(root / "gltf", soup.name + ".text", testing::gltf_text(soup, R"({"mesh":0})", uri));
    write(root / "gltf", soup.name + ".binary", testing::to_glb(soup));
  }
  for (const PolygonSoup& soup : soups) write_project(root / "project", soup.name, testing::project_of(soup));
  PolygonSoup painted = soups.back();
  const Image pixels{.width = 2, .height = 1, .rgba = {255, 0, 0, 255, 0, 255, 0, 128}};
  painted.materials = {{"paint", {1, 1, 1}, std::make_shared<const Image>(pixels)}};
  painted.face_material.assign(static_cast<std::size_t>(painted.n_faces()), 0);
  write_project(root / "project", "painted", testing::project_of(painted, {.faces = 12, .merges = true}));
  Project printed = testing::project_of(shapes::cube());
  printed.tabs.edits = {{EdgeId(1), TabSide::Both, 4.0, 0.5, 1.0}, {EdgeId(2), TabSide::None, {}, {}, {}}};
  printed.sheet.words = {"Cube", "me", "a note", painted.materials.front().texture};
  printed.sheet.hidden_folds = {EdgeId(3)};
  printed.sheet.shown_folds = {EdgeId(4)};
  write_project(root / "project", "printed", std::move(printed));
  write(root / "obj", "textured", shapes::to_obj(soups.back(), "library.mtl"));
  return 0;
}
