// Reads the members of a JSON object one by one, each with its limits, and complains about those that nobody
// asked for: a file of a newer Netwright is refused rather than read without half of its meaning.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/json.h"

namespace netwright {

class JsonFields {
 public:
  /// `file` is what messages call the file, `place` the object in it. A null pointer is an object without
  /// members. The JSON must outlive this. Throws Error(Read) when it is no object.
  JsonFields(const Json* json, std::string file, std::string place);

  // Each returns its default where the member is missing (older files have fewer) and throws Error(Read)
  // where it is of another kind or beyond its limits.
  std::int64_t integer(std::string_view key, std::int64_t low, std::int64_t high, std::int64_t otherwise);
  double number(std::string_view key, double low, double high, double otherwise);
  bool flag(std::string_view key, bool otherwise);
  std::string text(std::string_view key, const std::string& otherwise);
  /// The index of the member's word among `words`.
  int choice(std::string_view key, std::span<const std::string_view> words, int otherwise);
  std::vector<std::string> texts(std::string_view key);
  std::vector<int> integers(std::string_view key, int low, int high);
  std::vector<std::vector<int>> integer_lists(std::string_view key, int low, int high);
  std::vector<double> numbers(std::string_view key, double low, double high);
  const Json::Array* array(std::string_view key);  ///< null where it is missing
  const Json* object(std::string_view key);        ///< null where it is missing
  [[nodiscard]] bool has(std::string_view key) const;

  /// To be called at the end. Throws Error(Read) naming a member that was not asked for.
  void finish() const;

  [[noreturn]] void refuse(std::string_view key, const std::string& what) const;

 private:
  const Json* find(std::string_view key);
  [[nodiscard]] std::vector<int> integers_of(std::string_view key, const Json::Array& items, int low,
                                             int high) const;

  const Json* json_;
  std::string file_;
  std::string place_;
  std::vector<std::string_view> known_;
};

}  // namespace netwright
