// Where every named widget was drawn in the last frame, so that a test can click by name. Off (null in
// UiState) outside tests.
#pragma once

#include <imgui.h>

#include <map>
#include <optional>
#include <string>

namespace netwright {

struct WidgetRect {
  ImVec2 min;
  ImVec2 max;
  bool is_enabled = true;
  [[nodiscard]] ImVec2 centre() const { return {(min.x + max.x) / 2, (min.y + max.y) / 2}; }
};

class WidgetLog {
 public:
  void begin_frame() { rects_.clear(); }
  void note(const std::string& name, const WidgetRect& rect) { rects_[name] = rect; }
  [[nodiscard]] std::optional<WidgetRect> find(const std::string& name) const {
    const auto it = rects_.find(name);
    return it == rects_.end() ? std::nullopt : std::optional(it->second);
  }
  [[nodiscard]] const std::map<std::string, WidgetRect>& all() const { return rects_; }

 private:
  std::map<std::string, WidgetRect> rects_;
};

}  // namespace netwright
