// Stands in for netwright-read in tests: the model file says what it does wrong.
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace {

std::string read_all() {
  std::string bytes;
  char block[4096];
  for (std::size_t n = 0; (n = std::fread(block, 1, sizeof block, stdin)) > 0;) bytes.append(block, n);
  return bytes;
}

[[noreturn]] void spin() {
  for (std::atomic<unsigned> n = 0;; ++n) {
  }
}

[[noreturn]] void swallow_memory() {
  std::vector<char*> blocks;
  for (;;) {
    constexpr std::size_t kBlock = std::size_t{16} << 20;
    blocks.push_back(static_cast<char*>(std::malloc(kBlock)));
    std::memset(blocks.back(), 1, kBlock);  // without memory: null, and so a crash
  }
}

void crash() {
  signal(SIGSEGV, SIG_DFL);  // a sanitizer would catch it and end the program with a report of its own
  raise(SIGSEGV);
}

[[noreturn]] void write_without_end() {
  const std::string block(1 << 16, 'S');
  for (;;) std::fwrite(block.data(), 1, block.size(), stdout);
}

}  // namespace

int main() {
  const std::string wish = read_all();
  if (wish == "crash") crash();
  if (wish == "abort") std::abort();
  if (wish == "sleep") pause();
  if (wish == "spin") spin();
  if (wish == "swallow") swallow_memory();
  if (wish == "flood") write_without_end();
  if (wish == "lie") std::fwrite("S\xff\xff\xff\xff\xff\xff\xff\xff", 1, 9, stdout);
  if (wish == "gossip") std::puts("Hello, I am a model of a teapot.");
  if (wish == "fail") return 3;
  return 0;
}
