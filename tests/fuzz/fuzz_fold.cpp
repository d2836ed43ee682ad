// Feeds bytes to the FOLD reader and what it lets pass to the proof. A file that was read is written and read
// again: the second copy must be the first.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/base/error.h"
#include "core/sheet/fold_file.h"
#include "core/unfold/verify.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace netwright;
  FlatNet net;
  try {
    net = parse_fold(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz.fold");
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::Read || error.what()[0] == '\0') std::abort();
    return 0;
  }
  const VerifyReport report = verify(net);
  if (report.is_net != report.faults.empty()) std::abort();
  const FlatNet again = parse_fold(fold_text(net), "again.fold");
  if (again.points != net.points || again.faces != net.faces || again.folded != net.folded) std::abort();
  return 0;
}
