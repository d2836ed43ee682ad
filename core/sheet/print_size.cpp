// From the size that was asked for to millimetres per model unit.
#include "core/sheet/print_size.h"

#include <cmath>

#include "core/base/error.h"
#include "core/sheet/number_text.h"

namespace netwright {

namespace {

[[noreturn]] void refuse(const std::string& sentence) { throw Error(ErrorKind::Usage, sentence); }

double scale_for_height(const Mesh& mesh, double height_mm) {
  if (!(height_mm > 0) || !std::isfinite(height_mm))
    refuse("A model cannot be " + short_number(height_mm) + " mm high; give a height above 0 mm.");
  if (!(mesh.height() > 1e-9 * mesh.box().diagonal()))
    refuse("The model is flat along its up axis, so it cannot be given a height; fit it to the page.");
  return height_mm / mesh.height();
}

double scale_for_edge(const Mesh& mesh, EdgeId edge, double edge_mm) {
  if (!edge.is_valid() || edge.index() >= mesh.n_edges())
    refuse("The edge that says how large the model is printed is not there; choose another one.");
  if (!(edge_mm > 0) || !std::isfinite(edge_mm))
    refuse("An edge cannot be " + short_number(edge_mm) + " mm long; give a length above 0 mm.");
  if (!(mesh.length(edge) > 1e-9 * mesh.box().diagonal()))
    refuse("The edge that says how large the model is printed has no length; choose another one.");
  return edge_mm / mesh.length(edge);
}

}  // namespace

std::optional<double> scale_of(const Mesh& mesh, const PrintSize& size) {
  switch (size.kind) {
    case PrintSize::Kind::Height:
      return scale_for_height(mesh, size.height_mm);
    case PrintSize::Kind::EdgeLength:
      return scale_for_edge(mesh, size.edge, size.edge_mm);
    case PrintSize::Kind::Scale:
      if (!(size.scale > 0) || !std::isfinite(size.scale))
        refuse("A model cannot be printed at a scale of " + short_number(size.scale) +
               "; give a scale above 0.");
      return size.scale;
    case PrintSize::Kind::FitSheets:
      if (size.sheets < 1 || size.sheets > kMostFittedSheets)
        refuse("A model cannot be fitted to " + std::to_string(size.sheets) + " sheets; choose from 1 to " +
               std::to_string(kMostFittedSheets) + ".");
      return std::nullopt;
    case PrintSize::Kind::FitPage:
      break;
  }
  return std::nullopt;
}

PrintSize without_edge(const Mesh& mesh, const PrintSize& size) {
  PrintSize other = size;
  const bool is_there = size.edge.is_valid() && size.edge.index() < mesh.n_edges();
  other.edge = EdgeId();
  if (size.kind != PrintSize::Kind::EdgeLength) return other;
  other.kind = PrintSize::Kind::FitPage;
  if (!is_there || !(mesh.length(size.edge) > 0)) return other;
  other.kind = PrintSize::Kind::Scale;
  other.scale = size.edge_mm / mesh.length(size.edge);
  return other;
}

std::string size_words(const PrintSize& size) {
  switch (size.kind) {
    case PrintSize::Kind::Height:
      return "a height of " + short_number(size.height_mm) + " mm";
    case PrintSize::Kind::EdgeLength:
      return "an edge of " + short_number(size.edge_mm) + " mm";
    case PrintSize::Kind::Scale:
      return "a scale of " + short_number(size.scale);
    case PrintSize::Kind::FitSheets:
      return std::to_string(size.sheets) + " sheets";
    case PrintSize::Kind::FitPage:
      break;
  }
  return "one page";
}

}  // namespace netwright
