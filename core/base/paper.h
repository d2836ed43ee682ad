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

/// Looks a format up by name, ignoring case, or takes a paper of one's own by its size: "200x300", in mm;
/// its name is then kCustomPaper. Nothing for unknown names and sides beyond the limits.
std::optional<PaperFormat> find_paper(std::string_view name);

inline constexpr std::string_view kCustomPaper = "custom";
inline constexpr double kLeastPaperSide = 40;   ///< mm
inline constexpr double kMostPaperSide = 5000;  ///< mm

/// The word for a paper of one's own, as PaperSetup::format has it: the shorter side first, in tenths of a
/// millimetre at most ("200x300", "99.5x210").
std::string custom_paper(double width_mm, double height_mm);

enum class Orientation { Auto, Portrait, Landscape };

/// What is loaded in the printer.
struct PaperSetup {
  std::string format = "A4";
  Orientation orientation = Orientation::Auto;
  double margin_mm = 10;
  bool operator==(const PaperSetup&) const = default;
};

}  // namespace netwright
