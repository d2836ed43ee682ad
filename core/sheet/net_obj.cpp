// Writes the model with the net as texture coordinates, its materials and the pictures they wear.
#include "core/sheet/net_obj.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/sheet/number_text.h"
#include "core/sheet/write.h"

namespace netwright {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFirstLine = "# A model with its net as texture coordinates, by Netwright";
constexpr double kMostPixels = 8192;

/// The shortest text that is read back as the same number.
std::string exact(double value) {
  std::array<char, 32> buffer{};
  const auto done = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), done.ptr};
}

std::string material_name(std::size_t canvas) { return "sheet_" + std::to_string(canvas + 1); }

int canvas_of(const Net& net, const PageLayout& layout, FaceId f) {
  return layout.pieces[static_cast<std::size_t>(net.piece[f])].canvas;
}

glm::dvec2 uv_of(const Net& net, const PageLayout& layout, HalfedgeId h) {
  const int piece = net.piece[net.mesh().face(h)];
  const auto& canvas =
      layout.canvases[static_cast<std::size_t>(layout.pieces[static_cast<std::size_t>(piece)].canvas)];
  const glm::dvec2 at = layout.on_canvas(piece, net.corner(h));
  return {at.x / canvas.width_mm, 1 - at.y / canvas.height_mm};
}

/// The layout of one canvas alone, on a page that is all net.
PageLayout bare_layout(const PageLayout& layout, std::size_t index) {
  PageLayout bare = layout;
  bare.tabs.missing.clear();  // no loose strips beside the net
  PageLayout::Canvas& canvas = bare.canvases[index];
  canvas.columns = 1;
  canvas.rows = 1;
  const Box2 all{{0, 0}, {canvas.width_mm, canvas.height_mm}};
  bare.frame.width_mm = canvas.width_mm;
  bare.frame.height_mm = canvas.height_mm;
  bare.frame.printable = all;
  bare.frame.net = all;
  bare.pages = {{static_cast<int>(index), 0, 0, {0, 0}, ""}};
  return bare;
}

bool is_ours(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  return !file || (std::getline(file, line) && line == kFirstLine);
}

}  // namespace

std::string net_obj_text(const Net& net, const PageLayout& layout, const std::string& mtl_name) {
  const Mesh& mesh = net.mesh();
  std::string text = std::string(kFirstLine) + "\nmtllib " + mtl_name + "\n";
  for (const VertexId v : mesh.vertices()) {
    const glm::dvec3& p = mesh.position(v);
    text += "v " + exact(p.x) + " " + exact(p.y) + " " + exact(p.z) + "\n";
  }
  for (const HalfedgeId h : mesh.halfedges()) {
    const glm::dvec2 uv = uv_of(net, layout, h);
    text += "vt " + decimal_number(uv.x, 9) + " " + decimal_number(uv.y, 9) + "\n";
  }
  for (std::size_t canvas = 0; canvas < layout.canvases.size(); ++canvas) {
    text += "usemtl " + material_name(canvas) + "\n";
    for (const FaceId f : mesh.faces()) {
      if (canvas_of(net, layout, f) != static_cast<int>(canvas)) continue;
      text += "f";
      for (const HalfedgeId h : mesh.halfedges(f))
        text += " " + std::to_string(mesh.from(h).index() + 1) + "/" + std::to_string(h.index() + 1);
      text += "\n";
    }
  }
  return text;
}

std::vector<Sheet> canvas_sheets(const Net& net, const PageLayout& layout, const SheetSettings& settings) {
  SheetSettings plain = settings;
  plain.printed_side = PrintedSide::Outside;
  plain.labels.edge_numbers = false;
  plain.words = {};
  std::vector<Sheet> sheets;
  for (std::size_t i = 0; i < layout.canvases.size(); ++i) {
    Sheet sheet = draw_sheets(net, bare_layout(layout, i), {}, plain).front();
    sheet.texts.clear();
    std::erase_if(sheet.strokes, [](const Stroke& stroke) {
      return stroke.layer == Layer::Print || stroke.layer == Layer::Regmarks || stroke.layer == Layer::Labels;
    });
    sheet.number = static_cast<int>(i) + 1;
    sheet.count = static_cast<int>(layout.canvases.size());
    sheets.push_back(std::move(sheet));
  }
  return sheets;
}

std::vector<fs::path> write_net_obj(const fs::path& path, const Net& net, const PageLayout& layout,
                                    const SheetSettings& settings, const ExportSettings& exports) {
  if (!is_ours(path)) {
    throw Error(ErrorKind::Write, path.string() +
                                      " is a model already, and would be lost; choose another name for the "
                                      "model with its net as texture coordinates.");
  }
  fs::path mtl = path;
  mtl.replace_extension(".mtl");
  fs::path png = path;
  png.replace_extension(".png");
  std::vector<fs::path> files = {path, mtl};
  std::string materials = "# Materials of " + path.filename().string() + ", by Netwright\n";
  const std::vector<Sheet> sheets = canvas_sheets(net, layout, settings);
  for (std::size_t i = 0; i < sheets.size(); ++i) {
    const fs::path picture = page_path(png, i, sheets.size());
    const double most_dpi = kMostPixels * 25.4 / std::max(sheets[i].width_mm, sheets[i].height_mm);
    const double dpi = std::min<double>(std::clamp(exports.png_dpi, kLeastDpi, kMostDpi), most_dpi);
    write_file(picture, png_bytes(sheets[i], dpi));
    files.push_back(picture);
    materials += "newmtl " + material_name(i) + "\nKd 1 1 1\nmap_Kd " + picture.filename().string() + "\n";
  }
  write_file(mtl, materials);
  write_file(path, net_obj_text(net, layout, mtl.filename().string()));
  return files;
}

}  // namespace netwright
