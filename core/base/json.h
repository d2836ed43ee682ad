// JSON values of our own: plain, ordered as written, without a library's header. Only json.cpp knows the
// library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace netwright {

class Json {
 public:
  using Array = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;  ///< in the order of the text

  Json() = default;  ///< null
  Json(bool value) : value_(value) {}
  Json(int value) : value_(std::int64_t{value}) {}
  Json(std::int64_t value) : value_(value) {}
  Json(double value) : value_(value) {}  ///< not finite: written as null
  Json(std::string value) : value_(std::move(value)) {}
  Json(std::string_view value) : value_(std::string(value)) {}
  Json(const char* value) : value_(std::string(value)) {}
  Json(Array value) : value_(std::move(value)) {}
  Json(Object value) : value_(std::move(value)) {}

  [[nodiscard]] bool is_null() const { return std::holds_alternative<std::monostate>(value_); }
  // Each is null when the value is of another kind.
  [[nodiscard]] const Array* array() const { return std::get_if<Array>(&value_); }
  [[nodiscard]] const Object* object() const { return std::get_if<Object>(&value_); }
  [[nodiscard]] const std::string* text() const { return std::get_if<std::string>(&value_); }
  [[nodiscard]] std::optional<bool> boolean() const;
  [[nodiscard]] std::optional<double> number() const;         ///< any number
  [[nodiscard]] std::optional<std::int64_t> integer() const;  ///< a number without fraction
  /// The member of that name; null when there is none or this is no object.
  [[nodiscard]] const Json* find(std::string_view key) const;

  /// Appends a member (this becomes an object if it was null) or an item (an array if it was null).
  Json& set(std::string key, Json value);
  Json& add(Json item);

  bool operator==(const Json&) const = default;

 private:
  std::variant<std::monostate, bool, std::int64_t, double, std::string, Array, Object> value_;
};

/// Throws Error(Read): "NAME is not valid JSON: … (line L, column C)." Also refuses nesting deeper than 64
/// and more than `max_values` values, so that a hostile file costs neither the stack nor the memory.
Json parse_json(std::string_view text, const std::string& name, std::size_t max_values = 20'000'000);

struct JsonLook {
  bool is_indented = false;    ///< members on lines of their own; arrays of plain values stay on one line
  int significant_digits = 0;  ///< of fractions; 0 = the fewest that read back the same
};
std::string to_text(const Json& value, const JsonLook& look = {});

}  // namespace netwright
