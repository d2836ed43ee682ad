// A line chart as SVG: scales, grid, curves, marks and labels. It knows nothing of benches. Colours come from
// classes, so that one picture does for light and dark, on its own and inside a page.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace netwright {

/// Where numbers lie along one axis.
struct ChartScale {
  double low = 0;
  double high = 1;
  bool is_log = false;
  struct Tick {
    double value = 0;
    std::string words;
  };
  std::vector<Tick> ticks{};

  /// 0 at `low`, 1 at `high`.
  [[nodiscard]] double share(double value) const;
};

enum class ChartMark { Circle, Ring, Square, Triangle, Diamond };
enum class ChartStroke { Solid, Thin, Dashed };

class Chart {
 public:
  struct Words {
    std::string title;
    std::string x;
    std::string y;
  };
  Chart(const Words& words, const ChartScale& x, const ChartScale& y);

  /// The area between two curves of as many points.
  void band(const std::vector<glm::dvec2>& low, const std::vector<glm::dvec2>& high,
            const std::string& series);
  void curve(const std::vector<glm::dvec2>& points, const std::string& series,
             ChartStroke stroke = ChartStroke::Solid);
  void marks(const std::vector<glm::dvec2>& points, const std::string& series, ChartMark mark);
  /// Words beside a point, to its right; labels that would cover each other are moved apart. The words may
  /// hold SVG tags.
  void label(glm::dvec2 point, const std::string& words, const std::string& series);

  /// The whole picture. Call once.
  [[nodiscard]] std::string svg() &&;

 private:
  struct Label {
    glm::dvec2 at{0};  // on the picture
    std::string words;
    std::string series;
  };
  [[nodiscard]] glm::dvec2 place(glm::dvec2 point) const;
  [[nodiscard]] std::string path(const std::vector<glm::dvec2>& points) const;
  void add_grid(const Words& words);
  void spread_labels();

  ChartScale x_;
  ChartScale y_;
  std::string back_;   // grid and bands
  std::string front_;  // curves and marks
  std::vector<Label> labels_;
};

/// Ticks at 1, 10, 100 … from `low` to `high`, with these words.
std::vector<ChartScale::Tick> decade_ticks(double low, double high, std::string (*words)(double));
/// About five ticks at round numbers from 0 to `high`.
std::vector<ChartScale::Tick> round_ticks(double high);

}  // namespace netwright
