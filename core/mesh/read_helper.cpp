// The helper program netwright-read: takes a model file's bytes on standard input and its format as the only
// argument, writes the packed soup to standard output, or 'E' and what is wrong with the file.
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "core/mesh/readers.h"

namespace {

std::string read_all(std::FILE* file) {
  std::string bytes;
  std::vector<char> block(1 << 16);
  for (std::size_t n = 0; (n = std::fread(block.data(), 1, block.size(), file)) > 0;)
    bytes.append(block.data(), n);
  return bytes;
}

std::string answer(const std::string& bytes, const std::string& extension) {
  try {
    return netwright::readers::pack(netwright::readers::parse_with_assimp(bytes, extension));
  } catch (const std::bad_alloc&) {
    return "Eit asks for more memory than a model should";
  } catch (const std::exception& error) {
    return std::string("E") + error.what();
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("netwright-read is started by netwright itself: netwright-read FORMAT < MODEL\n", stderr);
    return 1;
  }
  const std::string reply = answer(read_all(stdin), argv[1]);
  return std::fwrite(reply.data(), 1, reply.size(), stdout) == reply.size() && std::fflush(stdout) == 0 ? 0
                                                                                                        : 1;
}
