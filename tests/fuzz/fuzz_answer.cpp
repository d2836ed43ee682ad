// Feeds bytes to the reader of our helper program's answers, as if a damaged model had taken that over.
#include <cstdint>
#include <string_view>

#include "core/base/error.h"
#include "core/mesh/readers.h"
#include "tests/fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace netwright;
  try {
    const readers::ParsedModel model = readers::unpack("fuzz", {reinterpret_cast<const char*>(data), size});
    for (const int picture : model.picture_of)
      testing::demand(picture >= -1 && picture < static_cast<int>(model.pictures.size()));
  } catch (const Error& error) {
    testing::demand(error.kind() == ErrorKind::Read && error.what()[0] != '\0');
  }
  return 0;
}
