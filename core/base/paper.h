// Paper sizes in millimetres.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace netwright {

struct PaperFormat {
  std::string_view name;
  double width_mm;  ///< portrait: width <= height
  double height_mm;
};

/// A4 first, then the other A and B sizes, Letter, Legal, Tabloid.
std::span<const PaperFormat> paper_formats();

/// Looks a format up by name, ignoring case.
std::optional<PaperFormat> find_paper(std::string_view name);

enum class Orientation { Auto, Portrait, Landscape };

/// What is loaded in the printer.
struct PaperSetup {
  std::string format = "A4";
  Orientation orientation = Orientation::Auto;
  double margin_mm = 10;
  bool operator==(const PaperSetup&) const = default;
};

}  // namespace netwright
