// The PDF goes through a pipe, so nothing is left on the disk. A printer's name comes from a list but may be
// typed as well: it is an argument of its own and can do no harm.
#include "core/project/print_job.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "core/base/error.h"
#include "core/base/subprocess.h"
#include "core/project/derived.h"
#include "core/sheet/instructions.h"

namespace netwright {

namespace {

constexpr double kMostSeconds = 60;

[[noreturn]] void refuse(const std::string& text, std::size_t count) {
  throw Error(ErrorKind::Usage, "“" + text + "” names no sheets: write numbers from 1 to " +
                                    std::to_string(count) + ", as in 1-3, 5.");
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// 0 where it is no number.
std::size_t number_of(std::string_view text) {
  text = trimmed(text);
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? number : 0;
}

}  // namespace

std::vector<std::size_t> chosen_sheets(const std::string& text, std::size_t count) {
  std::vector<std::size_t> chosen;
  std::string_view rest = trimmed(text);
  if (rest.empty())
    for (std::size_t i = 0; i < count; ++i) chosen.push_back(i);
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string_view part = rest.substr(0, comma);
    const std::size_t dash = part.find('-');
    const std::size_t first = number_of(part.substr(0, dash));
    const std::size_t last = dash == std::string_view::npos ? first : number_of(part.substr(dash + 1));
    if (first == 0 || last < first || last > count) refuse(text, count);
    for (std::size_t i = first; i <= last; ++i) chosen.push_back(i - 1);
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  std::ranges::sort(chosen);
  const auto twice = std::ranges::unique(chosen);
  chosen.erase(twice.begin(), twice.end());
  return chosen;
}

std::vector<Sheet> printed_sheets(const PrintJob& job, const Project& project, const Derived& derived) {
  SheetSettings settings = project.sheet;
  settings.is_grey = settings.is_grey || job.is_grey;
  const Net& net = derived.shown->net;
  const SheetInfo info = sheet_info(project, derived.is_sound);
  std::vector<Sheet> sheets = draw_sheets(net, *derived.pages, info, settings);
  std::vector<Sheet> printed;
  for (const std::size_t i : chosen_sheets(job.sheets, sheets.size()))
    printed.push_back(std::move(sheets[i]));
  const InstructionPage where = project.exports.instructions;
  if (where != InstructionPage::None)
    add_instructions(printed, instruction_sheet(net, *derived.pages, info, settings), where);
  return printed;
}

std::span<const std::filesystem::path> printing_folders() {
  static const std::array<std::filesystem::path, 3> kFolders{"/usr/bin", "/usr/local/bin", "/bin"};
  return kFolders;
}

std::filesystem::path printing_program(const std::string& name,
                                       std::span<const std::filesystem::path> folders) {
  for (const std::filesystem::path& folder : folders) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(folder / name, ignored)) return folder / name;
  }
  return {};
}

std::vector<std::string> find_printers(const std::filesystem::path& lpstat) {
  std::vector<std::string> printers;
  if (lpstat.empty()) return printers;
  constexpr ChildLimits kLimits{.seconds = 5, .output_bytes = std::size_t{1} << 16};
  const ChildResult result = run_child(lpstat, {"-e"}, "", kLimits);
  if (result.end != ChildResult::End::Exited || result.exit_code != 0) return printers;
  for (std::size_t from = 0; from < result.output.size();) {
    const std::size_t end = std::min(result.output.find('\n', from), result.output.size());
    const std::string_view name = trimmed(std::string_view(result.output).substr(from, end - from));
    if (!name.empty()) printers.emplace_back(name);
    from = end + 1;
  }
  return printers;
}

void send_to_printer(const std::filesystem::path& lp, const PrintJob& job, std::string_view pdf,
                     const std::string& title, const Progress& progress) {
  if (lp.empty())
    throw Error(ErrorKind::Write, "This system has no lp to print with; export a PDF and print that.");
  std::vector<std::string> arguments;
  if (!job.printer.empty()) arguments.insert(arguments.end(), {"-d", job.printer});
  arguments.insert(arguments.end(), {"-t", title, "-o", "print-scaling=none"});
  ChildLimits limits;
  limits.seconds = kMostSeconds;
  limits.output_bytes = std::size_t{1} << 16;
  limits.progress = &progress;
  const ChildResult result = run_child(lp, arguments, pdf, limits);
  if (result.end == ChildResult::End::Exited && result.exit_code == 0) return;
  throw Error(ErrorKind::Write, std::string("The printing system did not take the sheets") +
                                    (job.printer.empty() ? "" : " for " + job.printer) +
                                    "; see whether the printer is on, or export a PDF.");
}

}  // namespace netwright
