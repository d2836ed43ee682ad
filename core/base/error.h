// The one error type that crosses layers. Its text is a whole sentence for the user: what happened, where,
// and what to do about it. Ordinary outcomes (cancelled, overlaps remain) are not errors.
#pragma once

#include <stdexcept>
#include <string>

namespace netwright {

enum class ErrorKind {
  Usage,  ///< the request makes no sense (unknown option, face number out of range)
  Read,   ///< a file cannot be read or is not what it claims to be
  Unfit,  ///< the model was read but cannot be unfolded as it is (not manifold, not flat …)
  Write,  ///< a file cannot be written
};

class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& sentence) : std::runtime_error(sentence), kind_(kind) {}
  [[nodiscard]] ErrorKind kind() const { return kind_; }

 private:
  ErrorKind kind_;
};

}  // namespace netwright
