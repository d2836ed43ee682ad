// Triangles are filled row by row with the texture's place as a linear function. Growing hands each pixel's
// nearest painted one on to its neighbours for as long as that makes any of them nearer (vector propagation:
// exact but for rare pixels, which are off by a fraction of a pixel).
#include "core/sheet/picture_canvas.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace netwright {

namespace {

constexpr std::int16_t kFar = std::numeric_limits<std::int16_t>::max();
constexpr std::array<std::int16_t, 2> kNowhere = {kFar, kFar};
constexpr double kPaperShare = 0.62;  ///< of what is faded

int squared(std::array<std::int16_t, 2> offset) {
  return offset[0] == kFar ? std::numeric_limits<int>::max() : offset[0] * offset[0] + offset[1] * offset[1];
}

}  // namespace

PictureCanvas::PictureCanvas(int width, int height) {
  const auto n = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  image_ = {width, height, std::vector<std::uint8_t>(4 * n, 0)};
  is_open_.assign(n, 0);
}

std::pair<int, int> PictureCanvas::span(const glm::dvec2* polygon, std::size_t n, int row) const {
  constexpr double kSlack = 1e-6;
  const double y = row + 0.5;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 a = polygon[i];
    const glm::dvec2 b = polygon[(i + 1) % n];
    if (std::max(a.y, b.y) < y || std::min(a.y, b.y) > y) continue;
    const double t = a.y == b.y ? 0 : (y - a.y) / (b.y - a.y);
    const double x = a.x + t * (b.x - a.x);
    low = std::min({low, x, a.y == b.y ? b.x : x});
    high = std::max({high, x, a.y == b.y ? b.x : x});
  }
  if (!(low <= high)) return {0, 0};
  const double width = image_.width;
  const double first = std::clamp(std::ceil(low - 0.5 - kSlack), 0.0, width);
  const double end = std::clamp(std::floor(high - 0.5 + kSlack) + 1, 0.0, width);
  return {static_cast<int>(first), static_cast<int>(end)};
}

void PictureCanvas::paint_triangle(const std::array<glm::dvec2, 3>& at, const std::array<glm::dvec2, 3>& uv,
                                   const FacePaint::Coat& coat) {
  const auto [low, high] = std::minmax({at[0].y, at[1].y, at[2].y});
  const int first = static_cast<int>(std::clamp(std::floor(low - 1), 0.0, double(image_.height)));
  const int end = static_cast<int>(std::clamp(std::ceil(high + 1), 0.0, double(image_.height)));
  // uv as a function of the place: uv[0] plus the shares of two sides.
  const glm::dvec2 p = at[1] - at[0];
  const glm::dvec2 q = at[2] - at[0];
  const double area = p.x * q.y - p.y * q.x;
  const glm::dvec2 per_x = area == 0 ? glm::dvec2(0) : ((uv[1] - uv[0]) * q.y - (uv[2] - uv[0]) * p.y) / area;
  const glm::dvec2 per_y = area == 0 ? glm::dvec2(0) : ((uv[2] - uv[0]) * p.x - (uv[1] - uv[0]) * q.x) / area;
  for (int y = first; y < end; ++y) {
    const auto [from, to] = span(at.data(), 3, y);
    for (int x = from; x < to; ++x) {
      Pixel pixel = coat.colour;
      if (coat.texture != nullptr)
        pixel = texture_at(*coat.texture, uv[0] + per_x * (x + 0.5 - at[0].x) + per_y * (y + 0.5 - at[0].y));
      std::ranges::copy(pixel, image_.rgba.begin() + static_cast<std::ptrdiff_t>(4 * index(x, y)));
    }
  }
}

void PictureCanvas::open(const std::vector<glm::dvec2>& polygon) {
  double low = polygon.front().y;
  double high = low;
  for (const glm::dvec2 p : polygon) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  const int first = static_cast<int>(std::clamp(std::floor(low), 0.0, double(image_.height)));
  const int end = static_cast<int>(std::clamp(std::ceil(high), 0.0, double(image_.height)));
  for (int y = first; y < end; ++y) {
    const auto [from, to] = span(polygon.data(), polygon.size(), y);
    for (int x = from; x < to; ++x) is_open_[index(x, y)] = 1;
  }
}

void PictureCanvas::spread(std::vector<std::uint32_t>& front, int most) {
  const int width = image_.width;
  std::vector<std::uint32_t> next;
  while (!front.empty()) {
    next.clear();
    for (const std::uint32_t i : front) {
      const int x = static_cast<int>(i) % width;
      const int y = static_cast<int>(i) / width;
      const std::array<std::int16_t, 2> from = nearest_[i];
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          if (x + dx < 0 || x + dx >= width || y + dy < 0 || y + dy >= image_.height) continue;
          const std::size_t j = index(x + dx, y + dy);
          const std::array<std::int16_t, 2> offset = {static_cast<std::int16_t>(from[0] - dx),
                                                      static_cast<std::int16_t>(from[1] - dy)};
          const int distance = squared(offset);
          if (distance >= squared(nearest_[j]) || (distance > most && is_open_[j] == 0)) continue;
          nearest_[j] = offset;
          next.push_back(static_cast<std::uint32_t>(j));
        }
    }
    std::swap(front, next);
  }
}

void PictureCanvas::grow(double distance, bool fades) {
  const std::size_t n = is_open_.size();
  nearest_.assign(n, kNowhere);
  std::vector<std::uint32_t> front;
  for (std::size_t i = 0; i < n; ++i)
    if (image_.rgba[4 * i + 3] != 0) nearest_[i] = {0, 0};
  // Only what has a bare neighbour can grow.
  const int width = image_.width;
  for (int y = 0; y < image_.height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::size_t i = index(x, y);
      if (nearest_[i] == kNowhere) continue;
      const auto is_bare = [&](int dx, int dy) {
        return x + dx >= 0 && x + dx < width && y + dy >= 0 && y + dy < image_.height &&
               nearest_[index(x + dx, y + dy)] == kNowhere;
      };
      if (is_bare(-1, 0) || is_bare(1, 0) || is_bare(0, -1) || is_bare(0, 1))
        front.push_back(static_cast<std::uint32_t>(i));
    }
  const int most = static_cast<int>(distance * distance);
  spread(front, most);
  for (std::size_t i = 0; i < n; ++i) {
    const int reached = squared(nearest_[i]);
    if (reached == 0 || nearest_[i] == kNowhere) continue;
    const auto source = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + nearest_[i][0] +
                                                 nearest_[i][1] * static_cast<std::ptrdiff_t>(width));
    for (std::size_t c = 0; c < 3; ++c) {
      const double colour = image_.rgba[4 * source + c];
      const double share = fades && reached > most ? kPaperShare : 0;
      image_.rgba[4 * i + c] = static_cast<std::uint8_t>(std::lround(colour + (255 - colour) * share));
    }
    image_.rgba[4 * i + 3] = 255;
  }
}

Image PictureCanvas::image(bool is_grey) && {
  return is_grey ? greyed(std::move(image_)) : std::move(image_);
}

Image greyed(Image image) {
  for (std::size_t i = 0; i + 3 < image.rgba.size(); i += 4) {
    std::uint8_t* const p = &image.rgba[i];
    const auto grey = static_cast<std::uint8_t>((2126U * p[0] + 7152U * p[1] + 722U * p[2] + 5000U) / 10000U);
    std::fill(p, p + 3, grey);
  }
  return image;
}

void mirror(Image& image) {
  const auto width = static_cast<std::size_t>(image.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y)
    for (std::size_t left = 0, right = width - 1; left < right; ++left, --right)
      std::swap_ranges(&image.rgba[4 * (y * width + left)], &image.rgba[4 * (y * width + left)] + 4,
                       &image.rgba[4 * (y * width + right)]);
}

}  // namespace netwright
