// Feeds bytes to the reader of one model format and, where a soup comes out, to everything that a file passes
// on its way to a mesh. NETWRIGHT_FUZZ_NAME stands for the file's name and so chooses the reader.
#include <cstdint>
#include <string_view>

#include "core/base/error.h"
#include "core/mesh/read.h"
#include "tests/fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace netwright;
  PolygonSoup soup;
  try {
    soup = read_soup_bytes(NETWRIGHT_FUZZ_NAME, {reinterpret_cast<const char*>(data), size});
  } catch (const Error& error) {
    testing::demand(error.kind() == ErrorKind::Read && error.what()[0] != '\0');
    return 0;
  }
  testing::check_promises(soup);
  testing::check_way_to_mesh(soup);
  return 0;
}
