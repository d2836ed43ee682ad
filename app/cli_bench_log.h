// The rows of a bench, in memory and, when asked for, in a file that grows row by row and can be taken up
// again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace netwright {

/// One run: a model, a seed, and what came of it. The columns of the file have the names of these members,
/// is_solved and is_verified as `solved` and `verified`, 0 or 1.
struct BenchRow {
  std::string folder;  ///< the group's name
  std::string model;   ///< file name
  std::int64_t faces = 0;
  std::int64_t seed = 0;
  bool is_solved = false;    ///< the search ended without overlaps
  bool is_verified = false;  ///< and the proof agreed
  std::int64_t overlaps = 0;
  std::int64_t iterations = 0;
  std::int64_t moves = 0;
  std::int64_t restarts = 0;
  double cpu_seconds = 0;     ///< as in unfold --json
  double wall_seconds = 0;    ///< search and proof; reading left out
  double verify_seconds = 0;  ///< CPU time of the proof
  std::string note;           ///< why there is no proved net; empty when there is one

  /// False when the model could not be read or is not fit to unfold, so that there are no times.
  [[nodiscard]] bool was_searched() const { return wall_seconds > 0; }
};

class BenchLog {
 public:
  /// Rows in memory only.
  BenchLog() = default;
  /// Opens or makes the file. What it holds is kept when it was measured with the same `options` (one line);
  /// a last row that was cut off and the summary are dropped. Throws Error(Write) when the file cannot be
  /// written, was made with other options, is no bench at all, or is being written by another bench.
  BenchLog(const std::filesystem::path& path, const std::string& options);
  ~BenchLog();
  BenchLog(const BenchLog&) = delete;
  BenchLog& operator=(const BenchLog&) = delete;

  [[nodiscard]] bool has(const std::string& folder, const std::string& model, std::int64_t seed) const;
  [[nodiscard]] const std::vector<BenchRow>& rows() const { return rows_; }

  /// Appends one row with one write. Throws Error(Write).
  void add(const BenchRow& row);
  /// Appends the lines of the summary as comments. Throws Error(Write).
  void finish(const std::vector<std::string>& summary);

 private:
  void open();
  void take_up(const std::string& text, const std::string& head);
  void write(const std::string& text) const;

  std::filesystem::path path_;
  int file_ = -1;
  std::vector<BenchRow> rows_;
};

}  // namespace netwright
