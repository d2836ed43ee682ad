// Lists folders with std::filesystem; every call takes an error code, since folders come and go while one
// looks.
#include "ui/file_browser.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "assets/icons.h"
#include "ui/widgets.h"

namespace netwright {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string extension_of(const fs::path& path) {
  const std::string dotted = lower(path.extension().string());
  return dotted.empty() ? dotted : dotted.substr(1);
}

std::string bytes_text(std::uintmax_t bytes) {
  static constexpr std::array<const char*, 4> kUnits{"B", "kB", "MB", "GB"};
  auto value = static_cast<double>(bytes);
  std::size_t unit = 0;
  while (value >= 1000 && unit + 1 < kUnits.size()) {
    value /= 1000;
    ++unit;
  }
  return std::to_string(std::lround(value)) + " " + kUnits[unit];
}

}  // namespace

fs::path home_folder() {
  const char* home = std::getenv("HOME");
  std::error_code error;
  if (home != nullptr && fs::is_directory(home, error)) return home;
  return fs::current_path(error);
}

void FileBrowser::begin(const Request& request) {
  request_ = request;
  name_ = request.mode == Mode::Save ? request.name : "";
  wants_overwrite_ = false;
  std::error_code error;
  enter(fs::is_directory(request.folder, error) ? request.folder : home_folder());
}

void FileBrowser::set_extension(const std::string& extension) {
  request_.extensions = {extension};
  if (!name_.empty()) name_ = fs::path(name_).replace_extension(extension).string();
  wants_overwrite_ = false;
  read_folder();
}

void FileBrowser::enter(const fs::path& folder) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(folder, error);
  folder_ = error ? folder : canonical;
  if (request_.mode == Mode::Open) name_.clear();
  wants_overwrite_ = false;
  scroll_to_top_ = true;
  read_folder();
}

void FileBrowser::read_folder() {
  entries_.clear();
  trouble_.clear();
  std::error_code error;
  for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error)) {
    std::error_code ignored;
    Entry entry{it->path().filename().string(), it->is_directory(ignored), 0};
    if (entry.name.starts_with('.')) continue;
    if (!entry.is_folder) entry.bytes = it->file_size(ignored);
    if (is_listed(entry)) entries_.push_back(std::move(entry));
  }
  if (error) trouble_ = "This folder cannot be read: " + error.message() + ".";
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return a.is_folder != b.is_folder ? a.is_folder : lower(a.name) < lower(b.name);
  });
}

bool FileBrowser::is_listed(const Entry& entry) const {
  if (entry.is_folder) return true;
  const auto& wanted = request_.extensions;
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), extension_of(entry.name)) != wanted.end();
}

bool FileBrowser::can_accept() const { return !name_.empty() && name_ != "." && name_ != ".."; }

std::optional<fs::path> FileBrowser::accept() {
  if (!can_accept()) return std::nullopt;
  fs::path path = fs::path(name_).is_absolute() ? fs::path(name_) : folder_ / name_;
  std::error_code error;
  // What is saved may be a folder of its own, told by its extension.
  const bool is_target = request_.mode == Mode::Save && extension_of(path) == request_.extensions.front();
  if (fs::is_directory(path, error) && !is_target) {
    enter(path);
    return std::nullopt;
  }
  if (request_.mode == Mode::Open) return path;
  if (extension_of(path) != request_.extensions.front()) path += "." + request_.extensions.front();
  if (fs::exists(path, error) && !wants_overwrite_) {
    wants_overwrite_ = true;
    return std::nullopt;
  }
  return path;
}

std::optional<fs::path> FileBrowser::choose(const Entry& entry, bool is_double) {
  if (entry.is_folder) {
    if (is_double) enter(folder_ / entry.name);
    return std::nullopt;
  }
  name_ = entry.name;
  wants_overwrite_ = false;
  return is_double ? accept() : std::nullopt;
}

void FileBrowser::draw_path(UiState& ui) {
  ButtonSpec up{"browser/up", "", icon::kFolderUp, "The folder above"};
  up.kind = ButtonKind::Outlined;
  up.height = ImGui::GetFrameHeight();
  up.is_enabled = folder_ != folder_.root_path();
  if (button(ui, up)) enter(folder_.parent_path());
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-FLT_MIN);
  std::string typed = folder_.string();
  if (ImGui::InputText("##folder", &typed, ImGuiInputTextFlags_EnterReturnsTrue)) {
    std::error_code error;
    if (fs::is_directory(typed, error)) {
      enter(typed);
    } else if (fs::exists(typed, error)) {
      name_ = fs::path(typed).filename().string();
      enter(fs::path(typed).parent_path());
      name_ = fs::path(typed).filename().string();
    } else {
      trouble_ = "There is no folder “" + typed + "”.";
    }
  }
  note_widget(ui, "browser/folder");
}

void FileBrowser::draw_places(UiState& ui) {
  std::error_code error;
  const auto place = [&](const char* sign, const std::string& label, const fs::path& folder) {
    ImGui::PushID(folder.c_str());
    if (ImGui::Selectable((std::string(sign) + "  " + label).c_str(), folder == folder_)) enter(folder);
    tooltip(ui, folder.string());
    ImGui::PopID();
  };
  place(icon::kHome, "Home", home_folder());
  place(icon::kFolder, "Current folder", fs::current_path(error));
  place(icon::kFolder, "Computer", folder_.root_path());
  std::vector<fs::path> seen;
  for (const fs::path& file : ui.settings.recent) {
    const fs::path folder = file.parent_path();
    if (folder.empty() || std::find(seen.begin(), seen.end(), folder) != seen.end()) continue;
    if (seen.empty()) text_small(ui, "Recent");
    seen.push_back(folder);
    place(icon::kRecent, folder.filename().string(), folder);
  }
}

std::optional<fs::path> FileBrowser::draw_entries(UiState& ui) {
  std::optional<fs::path> chosen;
  if (!trouble_.empty()) ImGui::TextWrapped("%s", trouble_.c_str());
  if (entries_.empty() && trouble_.empty()) text_muted(ui, "No files of this kind in this folder.");
  if (scroll_to_top_) ImGui::SetScrollY(0);
  scroll_to_top_ = false;
  const std::vector<Entry> listed =
      entries_;  // entering a folder replaces the list in the middle of the loop
  for (const Entry& entry : listed) {
    const bool is_selected = !entry.is_folder && entry.name == name_;
    ImGui::PushID(entry.name.c_str());
    const bool is_clicked = ImGui::Selectable("##entry", is_selected, ImGuiSelectableFlags_AllowDoubleClick);
    note_widget(ui, "browser/" + entry.name);
    const bool is_double = is_clicked && ImGui::IsMouseDoubleClicked(0);
    ImGui::SameLine(ui.look.px(4));
    ImGui::TextUnformatted(entry.is_folder ? icon::kFolder : icon::kFile);
    ImGui::SameLine(ui.look.px(32));
    const std::string size = entry.is_folder ? "" : bytes_text(entry.bytes);
    const float right = ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(size.c_str()).x;
    ImGui::TextUnformatted(shortened(entry.name, right - ui.look.px(48)).c_str());
    ImGui::SameLine(right);
    text_muted(ui, size);
    ImGui::PopID();
    if (is_clicked) chosen = choose(entry, is_double);
    if (chosen || folder_.empty()) break;
  }
  return chosen;
}

std::optional<fs::path> FileBrowser::draw(UiState& ui, float height) {
  draw_path(ui);
  const float list_height =
      height - ImGui::GetFrameHeightWithSpacing() * (request_.mode == Mode::Save ? 2 : 1);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.look.px(8), ui.look.px(6)));
  ImGui::BeginChild("places", ImVec2(ui.look.px(160), list_height), true);
  draw_places(ui);
  ImGui::EndChild();
  ImGui::SameLine(0, ui.look.px(8));
  ImGui::BeginChild("entries", ImVec2(0, list_height), true);
  std::optional<fs::path> chosen = draw_entries(ui);
  ImGui::EndChild();
  ImGui::PopStyleVar();
  if (request_.mode == Mode::Open) return chosen;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Name");
  ImGui::SameLine(ui.look.px(80));
  ImGui::SetNextItemWidth(-FLT_MIN);
  const std::string before = name_;
  const bool is_entered = ImGui::InputText("##name", &name_, ImGuiInputTextFlags_EnterReturnsTrue);
  note_widget(ui, "browser/name");
  if (name_ != before) wants_overwrite_ = false;
  if (is_entered && !chosen) chosen = accept();
  return chosen;
}

}  // namespace netwright
