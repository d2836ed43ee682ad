// The pictures that a model's materials name: each is looked for and decoded once, and what is missing is
// told in one sentence, however many there are. Only the readers include it.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/image.h"
#include "core/mesh/read.h"

namespace netwright::readers {

class Pictures {
 public:
  explicit Pictures(CompanionLookup companions = {}) : companions_(std::move(companions)) {}

  /// The picture in a file beside the model; null when it is not there or cannot be read.
  std::shared_ptr<const Image> from_file(const std::string& written);
  /// A picture that lies in the model itself, under a name of its own; null when it cannot be read.
  std::shared_ptr<const Image> from_bytes(const std::string& label, std::string_view bytes);
  /// Says that a picture is missing without looking for it.
  void miss(const std::string& file);
  /// What could not be had, as sentences for PolygonSoup::notices.
  [[nodiscard]] std::vector<std::string> notices() const;

 private:
  CompanionLookup companions_;
  std::map<std::string, std::shared_ptr<const Image>> known_;
  std::vector<std::string> missing_;
  std::vector<std::string> unreadable_;
};

}  // namespace netwright::readers
