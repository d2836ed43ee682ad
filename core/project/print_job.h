// Printing through CUPS: the programs lp and lpstat do it, where there are any.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/sheet/sheet.h"

namespace netwright {

struct Derived;
struct Project;

struct PrintJob {
  std::string printer;  ///< empty: the system's usual one
  std::string sheets;   ///< "1-3, 5", counted from 1; empty: all
  bool is_grey = false;
};

/// The sheets named by a text like "1-3, 5", from 0, sorted, each once. Throws Error(Usage) where it names
/// none, or one beyond `count`.
std::vector<std::size_t> chosen_sheets(const std::string& text, std::size_t count);

/// What a job prints of a project whose net and pages were derived: the sheets that it names, drawn as fine
/// as printers are, and the page with instructions where the project's exports have one. Throws Error(Usage).
std::vector<Sheet> printed_sheets(const PrintJob& job, const Project& project, const Derived& derived);

/// Where a program of the printing system is; empty where it is in none of the folders.
std::filesystem::path printing_program(const std::string& name,
                                       std::span<const std::filesystem::path> folders);
std::span<const std::filesystem::path> printing_folders();

/// The printers that the system knows; none without lpstat.
std::vector<std::string> find_printers(const std::filesystem::path& lpstat);

/// Hands a PDF to lp, at true size. Throws Error(Write) with one sentence.
void send_to_printer(const std::filesystem::path& lp, const PrintJob& job, std::string_view pdf,
                     const std::string& title, const Progress& progress);

}  // namespace netwright
