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

/// What a bench has measured, and with what.
struct BenchRecord {
  std::string options;              ///< of the search, one line
  std::vector<std::string> places;  ///< machine and build, one line each; several when it was gone on with
  std::vector<BenchRow> rows;
};

/// The record in a bench's file; a last row that was cut off is left out. Throws Error(Read) when the file
/// cannot be read or is no bench.
BenchRecord read_bench(const std::filesystem::path& path);

class BenchLog {
 public:
  /// Rows in memory only. `options` and `place` are one line each, see BenchRecord.
  BenchLog(const std::string& options, const std::string& place);
  /// Opens or makes the file. What it holds is kept when it was measured with the same `options`, wherever
  /// that was; a last row that was cut off and the summary are dropped. Throws Error(Write) when the file
  /// cannot be written, was made with other options, is no bench at all, or is being written by another
  /// bench.
  BenchLog(const std::filesystem::path& path, const std::string& options, const std::string& place);
  ~BenchLog();
  BenchLog(const BenchLog&) = delete;
  BenchLog& operator=(const BenchLog&) = delete;

  [[nodiscard]] bool has(const std::string& folder, const std::string& model, std::int64_t seed) const;
  [[nodiscard]] const BenchRecord& record() const { return record_; }

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
  std::string place_;  // where the rows to come are measured
  BenchRecord record_;
};

}  // namespace netwright
