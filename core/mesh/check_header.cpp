// Compares what the headers of STL and PLY files promise with the size of the file. Assimp believes the
// headers and would allocate whatever they say.
#include <cstdint>
#include <cstring>
#include <map>
#include <vector>

#include "core/mesh/readers.h"
#include "core/mesh/words.h"

namespace netwright::readers {
namespace {

[[noreturn]] void refuse_promise(const std::string& name, std::uint64_t count, const std::string& what) {
  refuse(name, "its header promises " + std::to_string(count) + " " + what +
                   ", but the file is too short for them; it was cut short or damaged, export it again.");
}

void check_stl(const std::string& name, std::string_view bytes) {
  std::string_view rest = bytes;
  const bool is_text = next_word(rest) == "solid" && bytes.find("facet") != std::string_view::npos;
  std::uint32_t count = 0;
  constexpr std::size_t kHeader = 84;
  constexpr std::size_t kTriangle = 50;
  if (bytes.size() >= kHeader) std::memcpy(&count, bytes.data() + 80, sizeof count);
  const bool fits = bytes.size() >= kHeader && (bytes.size() - kHeader) / kTriangle >= count;
  if (is_text && !(fits && (bytes.size() - kHeader) == kTriangle * count)) {
    if (bytes.rfind("endsolid") == std::string_view::npos) {
      refuse(name, "it ends before its last triangle is closed; the file was cut short, export it again.");
    }
    return;
  }
  if (bytes.size() < kHeader) refuse(name, "it is too short to be an STL file; export it again.");
  if (!fits) refuse_promise(name, count, "triangles");
}

/// Fewest bytes that one value of a PLY type takes; 0 for a type that PLY does not know.
std::uint64_t ply_width(std::string_view type) {
  static const std::map<std::string_view, std::uint64_t> kWidths{
      {"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},  {"short", 2}, {"ushort", 2},
      {"int16", 2}, {"uint16", 2},  {"int", 4},    {"uint", 4},   {"int32", 4}, {"uint32", 4},
      {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  const auto found = kWidths.find(type);
  return found == kWidths.end() ? 0 : found->second;
}

void check_ply(const std::string& name, std::string_view bytes) {
  struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::uint64_t least_bytes = 0;
  };
  std::vector<Element> elements;
  bool is_text = false;
  bool is_ended = false;
  std::string_view rest = bytes;
  while (!rest.empty() && !is_ended) {
    std::string_view line = next_line(rest);
    const std::string_view keyword = next_word(line);
    if (keyword == "format") is_text = next_word(line) == "ascii";
    if (keyword == "end_header") is_ended = true;
    if (keyword == "element") {
      Element element{.name = std::string(next_word(line))};
      const std::optional<std::uint64_t> count = parse_count(next_word(line));
      if (!count) {
        refuse(name,
               "its header does not say how many of \"" + element.name + "\" it holds; export it again.");
      }
      element.count = *count;
      elements.push_back(std::move(element));
    }
    if (keyword == "property" && !elements.empty()) {
      std::string_view type = next_word(line);
      if (type == "list") type = next_word(line);
      elements.back().least_bytes += is_text ? 2 : ply_width(type);
    }
  }
  if (!is_ended) refuse(name, "its header has no end; the file was cut short, export it again.");
  std::uint64_t left = rest.size() + 1;  // the last line may lack its end
  for (const Element& element : elements) {
    const std::uint64_t least = std::max<std::uint64_t>(element.least_bytes, 1);
    if (element.count > left / least) refuse_promise(name, element.count, "\"" + element.name + "\" entries");
    left -= element.count * least;
  }
}

}  // namespace

void check_header(const std::string& name, std::string_view bytes, const std::string& extension) {
  if (extension == "stl") check_stl(name, bytes);
  if (extension == "ply") check_ply(name, bytes);
}

}  // namespace netwright::readers
