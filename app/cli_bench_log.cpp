// The file's form: a comment with the options, a header, one line of tab-separated fields per run, a comment
// with machine and build before the first one measured there, and at the end the summary as comments.
// Everything after the last whole row is made anew when the bench goes on.
#include "app/cli_bench_log.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <optional>
#include <system_error>

#include "core/base/atomic_file.h"
#include "core/base/error.h"

namespace netwright {
namespace {

constexpr const char* kHeader =
    "folder\tmodel\tfaces\tseed\tsolved\tverified\toverlaps\titerations\tmoves\trestarts\tcpu_seconds\t"
    "wall_seconds\tverify_seconds\tnote\n";
constexpr std::size_t kColumns = 14;
constexpr const char* kPlace = "# measured with ";
constexpr std::size_t kMostBytes = std::size_t{1} << 30;

/// Tabs and line ends would tear a row apart; names and notes may hold them.
std::string one_field(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
  return text;
}

std::string seconds(double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.9f", value);
  return text.data();
}

std::string to_line(const BenchRow& row) {
  std::string line = row.folder + "\t" + row.model;
  for (const std::int64_t value :
       {row.faces, row.seed, std::int64_t{row.is_solved}, std::int64_t{row.is_verified}, row.overlaps,
        row.iterations, row.moves, row.restarts}) {
    line += "\t" + std::to_string(value);
  }
  for (const double value : {row.cpu_seconds, row.wall_seconds, row.verify_seconds})
    line += "\t" + seconds(value);
  return line + "\t" + row.note + "\n";
}

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> parts(1);
  for (const char c : line) {
    if (c == '\t') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

template <class Number>
bool read_number(const std::string& text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

bool read_flag(const std::string& text, bool& value) {
  value = text == "1";
  return text == "0" || text == "1";
}

/// A line without its end, as a row; nothing when it is none.
std::optional<BenchRow> to_row(const std::string& line) {
  const std::vector<std::string> parts = fields(line);
  if (parts.size() != kColumns) return {};
  BenchRow row;
  row.folder = parts[0];
  row.model = parts[1];
  row.note = parts[13];
  const bool is_row = read_number(parts[2], row.faces) && read_number(parts[3], row.seed) &&
                      read_flag(parts[4], row.is_solved) && read_flag(parts[5], row.is_verified) &&
                      read_number(parts[6], row.overlaps) && read_number(parts[7], row.iterations) &&
                      read_number(parts[8], row.moves) && read_number(parts[9], row.restarts) &&
                      read_number(parts[10], row.cpu_seconds) && read_number(parts[11], row.wall_seconds) &&
                      read_number(parts[12], row.verify_seconds);
  return is_row ? std::optional(row) : std::nullopt;
}

/// Where the lines that count end, and the first one that is neither a run nor a comment.
struct WholeLines {
  std::size_t end = 0;
  std::string stranger;
};

/// Enters the rows and places that begin at `begin`; the summary behind them does not count.
WholeLines whole_lines(const std::string& text, std::size_t begin, BenchRecord& record) {
  WholeLines lines{begin, {}};
  for (std::size_t end = text.find('\n', begin); end != std::string::npos; end = text.find('\n', lines.end)) {
    const std::string line = text.substr(lines.end, end - lines.end);
    if (line.starts_with(kPlace)) {
      record.places.push_back(line.substr(std::strlen(kPlace)));
    } else if (const std::optional<BenchRow> row = to_row(line)) {
      record.rows.push_back(*row);
    } else {
      if (!line.starts_with('#')) lines.stranger = line.substr(0, 60);
      break;
    }
    lines.end = end + 1;
  }
  return lines;
}

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason,
                         const std::string& cure) {
  throw Error(ErrorKind::Write, "Cannot write " + path.string() + ": " + reason + "; " + cure + ".");
}

}  // namespace

BenchRecord read_bench(const std::filesystem::path& path) {
  const std::string text = read_file(path, kMostBytes);
  const std::size_t head = text.find(kHeader);
  if (!text.starts_with("# ") || head == std::string::npos || head != text.find('\n') + 1) {
    throw Error(ErrorKind::Read, "Cannot read " + path.string() +
                                     ": it is no table of a bench; name one that --tsv has made.");
  }
  BenchRecord record;
  record.options = text.substr(2, head - 3);
  const WholeLines lines = whole_lines(text, head + std::strlen(kHeader), record);
  if (!lines.stranger.empty()) {
    throw Error(ErrorKind::Read, "Cannot read " + path.string() + ": line \"" + lines.stranger +
                                     "\" in it is no run; repair it or measure again.");
  }
  return record;
}

BenchLog::BenchLog(const std::string& options, const std::string& place) : place_(one_field(place)) {
  record_.options = one_field(options);
}

BenchLog::BenchLog(const std::filesystem::path& path, const std::string& options, const std::string& place)
    : path_(path), place_(one_field(place)) {
  record_.options = one_field(options);
  open();
  try {
    take_up(read_file(path_, kMostBytes), "# " + record_.options + "\n" + kHeader);
  } catch (...) {
    ::close(file_);
    throw;
  }
}

BenchLog::~BenchLog() {
  if (file_ >= 0) ::close(file_);
}

void BenchLog::open() {
  std::error_code ignored;
  if (std::filesystem::exists(path_, ignored) && !std::filesystem::is_regular_file(path_, ignored))
    refuse(path_, "it is no ordinary file", "choose another name");
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) refuse(path_, std::strerror(errno), "choose a name in a folder that may be written to");
  if (::flock(file_, LOCK_EX | LOCK_NB) == 0) return;
  ::close(file_);
  refuse(path_, "another bench is writing it", "wait for its end or choose another name");
}

void BenchLog::take_up(const std::string& text, const std::string& head) {
  std::size_t kept = 0;
  if (text.starts_with(head)) {
    const WholeLines lines = whole_lines(text, head.size(), record_);
    if (!lines.stranger.empty())
      refuse(path_, "line \"" + lines.stranger + "\" in it is no run", "repair it or choose another name");
    kept = lines.end;
  } else if (!head.starts_with(text)) {
    refuse(path_, "it is there already and was not measured with these options",
           "choose another name, or the options in its first line");
  }
  if (::ftruncate(file_, static_cast<off_t>(kept)) != 0)
    refuse(path_, std::strerror(errno), "choose another name");
  if (kept == 0) write(head);
}

bool BenchLog::has(const std::string& folder, const std::string& model, std::int64_t seed) const {
  return std::any_of(record_.rows.begin(), record_.rows.end(), [&](const BenchRow& row) {
    return row.seed == seed && row.model == one_field(model) && row.folder == one_field(folder);
  });
}

void BenchLog::add(const BenchRow& row) {
  BenchRow kept = row;
  for (std::string* text : {&kept.folder, &kept.model, &kept.note}) *text = one_field(*text);
  // Figures are made of what can be read in the file, so that they can be checked against it.
  const std::string line = to_line(kept);
  if (record_.places.empty() || record_.places.back() != place_) {
    write(kPlace + place_ + "\n");
    record_.places.push_back(place_);
  }
  write(line);
  record_.rows.push_back(*to_row(line.substr(0, line.size() - 1)));
}

void BenchLog::finish(const std::vector<std::string>& summary) {
  std::string text;
  for (const std::string& line : summary) text += "# " + line + "\n";
  write(text);
}

void BenchLog::write(const std::string& text) const {
  if (file_ < 0) return;
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t n = ::write(file_, text.data() + done, text.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) refuse(path_, std::strerror(errno), "make room and start again, the rows in it are kept");
    done += static_cast<std::size_t>(n);
  }
}

}  // namespace netwright
