// Writes the hard families, size by size, as OBJ files into one folder per family, for netwright-cli bench.
// Usage: hard_shapes FOLDER.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/mesh/shapes.h"
#include "core/mesh/shapes_hard.h"

namespace netwright {
namespace {

struct Family {
  std::string name;
  std::vector<int> sizes;
  std::function<PolygonSoup(int)> make;
};

std::vector<Family> families() {
  using namespace shapes;
  return {
      // The first six in the proportions that the authors' program was measured with.
      {"tubes",
       {1, 2, 3, 4, 5, 6, 12, 24},
       [](int n) { return box_with_tubes(n, n, n < 6 ? n + 1 : n + 2, std::max(0.3, 0.8 - 0.1 * n)); }},
      {"long_tubes", {1, 2, 4, 8, 16, 24}, [](int n) { return box_with_tubes(n, n, 30.0 * n); }},
      {"short_tubes", {1, 2, 4, 8, 16, 24}, [](int n) { return box_with_tubes(n, n, 1.0); }},
      {"slots", {2, 8, 32, 128, 512}, [](int n) { return comb(n, 4.0 * n, 0.25); }},
      {"combs", {2, 8, 32, 128, 512}, [](int n) { return comb(n, 50); }},
      {"brushes", {2, 4, 8, 16, 32}, [](int n) { return brush(n, n, 10, 0.25); }},
      {"screws", {1, 4, 16, 64, 200}, [](int n) { return screw(n); }},
      {"deep_screws", {1, 4, 16, 64, 200}, [](int n) { return screw(n, 12, 4, 0.2); }},
      {"scaffolds", {1, 2, 3, 4, 6, 8}, [](int n) { return scaffold(n); }},
      {"menger_sponges", {1, 2}, [](int n) { return menger_sponge(n); }},
      {"spikes_100", {1, 2, 4, 8, 12}, [](int n) { return spiked(icosphere(n), 1); }},
      {"spikes_125", {1, 2, 4, 8, 12}, [](int n) { return spiked(icosphere(n), 1.25); }},
      {"spikes_150", {1, 2, 4, 8}, [](int n) { return spiked(icosphere(n), 1.5); }},
      {"spikes_200", {1, 2, 4, 8}, [](int n) { return spiked(icosphere(n), 2); }},
      {"spikes_400", {1, 2, 4, 8}, [](int n) { return spiked(icosphere(n), 4); }},
      {"spiked_rings", {3, 4, 5, 6, 8}, [](int n) { return spiked(torus(n + 1, n), 1.75); }},
      {"spindles", {4, 16, 64, 256, 1024}, [](int n) { return star_spindle(n, 0.5, 8); }},
      {"sharp_spindles", {4, 16, 64, 256, 1024}, [](int n) { return star_spindle(n, 0.1, 8); }},
  };
}

void write(const std::filesystem::path& folder, const Family& family) {
  std::filesystem::create_directories(folder / family.name);
  for (const int size : family.sizes) {
    const PolygonSoup soup = family.make(size);
    std::string number = std::to_string(size);
    number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
    write_file(folder / family.name / (family.name + "_" + number + ".obj"), shapes::to_obj(soup));
    std::printf("%-20s %4d %6d faces\n", family.name.c_str(), size, soup.n_faces());
  }
}

}  // namespace
}  // namespace netwright

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: hard_shapes FOLDER\n");
    return 1;
  }
  for (const netwright::Family& family : netwright::families()) netwright::write(argv[1], family);
}
