// Where unsaved work is kept, and how the moment is told at which it was.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace netwright {

/// $XDG_STATE_HOME/netwright, or below ~/.local/state; empty when neither is known.
std::filesystem::path state_folder();

/// "today at 14:05", "yesterday at 9:12", "3 March at 10:00", "3 March 2025 at 10:00": in local time.
std::string moment_text(std::chrono::system_clock::time_point then,
                        std::chrono::system_clock::time_point now);

}  // namespace netwright
