// The environment and the calendar.
#include "ui/recovery.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace netwright {

namespace {

constexpr std::array<const char*, 12> kMonths{"January",   "February", "March",    "April",
                                              "May",       "June",     "July",     "August",
                                              "September", "October",  "November", "December"};

std::tm local(std::chrono::system_clock::time_point moment) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(moment);
  std::tm parts{};
  localtime_r(&seconds, &parts);
  return parts;
}

bool is_same_day(const std::tm& a, const std::tm& b) {
  return a.tm_year == b.tm_year && a.tm_yday == b.tm_yday;
}

}  // namespace

std::filesystem::path state_folder() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && *state != 0) return std::filesystem::path(state) / "netwright";
  const char* home = std::getenv("HOME");
  if (home != nullptr && *home != 0) return std::filesystem::path(home) / ".local/state/netwright";
  return {};
}

std::string moment_text(std::chrono::system_clock::time_point then,
                        std::chrono::system_clock::time_point now) {
  const std::tm when = local(then);
  const std::tm today = local(now);
  std::string day = std::to_string(when.tm_mday) + " " + kMonths[static_cast<std::size_t>(when.tm_mon)];
  if (when.tm_year != today.tm_year) day += " " + std::to_string(when.tm_year + 1900);
  if (is_same_day(when, today)) day = "today";
  if (is_same_day(when, local(now - std::chrono::hours(24)))) day = "yesterday";
  std::array<char, 24> clock{};
  std::snprintf(clock.data(), clock.size(), " at %d:%02d", when.tm_hour, when.tm_min);
  return day + clock.data();
}

}  // namespace netwright
