// netwright-cli: the whole of Netwright without a window, for scripts and servers.
#include <exception>
#include <new>
#include <variant>

#include "app/cli_commands.h"
#include "app/cli_report.h"
#include "core/base/error.h"

namespace netwright {
namespace {

struct Runner {
  int operator()(const PrintCommand& command) const {
    print(command.text.substr(0, command.text.find_last_not_of('\n') + 1));
    return 0;
  }
  int operator()(const UnfoldCommand& command) const { return run_unfold(command); }
  int operator()(const ReplaceCommand& command) const { return run_replace(command); }
  int operator()(const VerifyCommand& command) const { return run_verify(command); }
  int operator()(const InfoCommand& command) const { return run_info(command); }
  int operator()(const BenchCommand& command) const { return run_bench(command); }
};

constexpr int kFailed = 1;

int run(int argc, const char* const* argv) {
  try {
    return std::visit(Runner{}, parse_command(argc, argv));
  } catch (const Error& error) {
    complain(error.what());
  } catch (const std::bad_alloc&) {
    complain("There is not enough memory for this model; simplify it first.");
  } catch (const std::exception& error) {
    complain(std::string("Something unexpected went wrong inside: ") + error.what() + ".");
  }
  return kFailed;
}

}  // namespace
}  // namespace netwright

int main(int argc, char** argv) { return netwright::run(argc, argv); }
