// Finds and decodes pictures, and words what is missing.
#include "core/mesh/pictures.h"

#include <algorithm>

namespace netwright::readers {
namespace {

/// "a.png", "a.png and b.png", "a.png, b.png and 7 more".
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kNamed = 4;
  std::string text = names.front();
  const std::size_t n_named = names.size() > kNamed + 1 ? kNamed : names.size();
  for (std::size_t i = 1; i < n_named; ++i) {
    const bool is_last = i + 1 == names.size();
    text += (is_last ? " and " : ", ") + names[i];
  }
  if (n_named < names.size()) text += " and " + std::to_string(names.size() - n_named) + " more";
  return text;
}

void add_notice(const std::vector<std::string>& names, const std::string& what,
                std::vector<std::string>& notices) {
  if (names.empty()) return;
  const bool is_one = names.size() == 1;
  notices.push_back((is_one ? "The picture " : "The pictures ") + listed(names) + what +
                    (is_one ? "; its faces stay plain." : "; their faces stay plain."));
}

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

}  // namespace

std::shared_ptr<const Image> Pictures::from_file(const std::string& written) {
  const bool is_dotted = written.starts_with("./") || written.starts_with(".\\");
  const std::string file = is_dotted ? written.substr(2) : written;
  const auto [at, is_new] = known_.try_emplace(file, nullptr);
  if (!is_new) return at->second;
  const std::optional<std::string> bytes = companions_ ? companions_(file) : std::nullopt;
  if (!bytes) {
    miss(file);
    return nullptr;
  }
  at->second = from_bytes(file, *bytes);
  return at->second;
}

std::shared_ptr<const Image> Pictures::from_bytes(const std::string& label, std::string_view bytes) {
  auto image = std::make_shared<const Image>(decode_image(bytes));
  if (!image->is_empty()) return image;
  add_once(unreadable_, label.empty() ? "inside the model" : label);
  return nullptr;
}

void Pictures::miss(const std::string& file) { add_once(missing_, file); }

std::vector<std::string> Pictures::notices() const {
  std::vector<std::string> notices;
  const auto was = [](const std::vector<std::string>& names) { return names.size() == 1 ? " was" : " were"; };
  add_notice(missing_, was(missing_) + std::string(" not found"), notices);
  add_notice(unreadable_, " cannot be read", notices);
  return notices;
}

}  // namespace netwright::readers
