// Feeds bytes to what our helper program does with a format that Assimp parses, in this process: the check of
// the header, the parsing, packing the answer and unpacking it. What comes out of Assimp may crash, hang or
// swallow memory: that is what the helper is for; what counts here is whether our own code is to blame.
// NETWRIGHT_FUZZ_FORMAT is the format's extension.
#include <cstdint>
#include <exception>
#include <string_view>

#include "core/base/error.h"
#include "core/mesh/readers.h"
#include "tests/fuzz/promises.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace netwright;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  readers::ParsedModel parsed;
  try {
    readers::check_header("fuzz", bytes, NETWRIGHT_FUZZ_FORMAT);
    parsed = readers::parse_with_assimp(bytes, NETWRIGHT_FUZZ_FORMAT);
  } catch (const std::exception&) {  // the helper tells of any of them
    return 0;
  }
  const std::string packed = readers::pack(parsed);
  testing::demand(readers::pack(readers::unpack("fuzz", packed)) == packed);
  return 0;
}
