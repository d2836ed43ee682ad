// Groups digits by three and puts a number beside its noun. Thin spaces need no room and never look like a
// decimal point.
#include "core/base/counted.h"

namespace netwright {

std::string grouped(std::int64_t number) {
  std::string digits = std::to_string(number < 0 ? -number : number);
  for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), "\u2009");
  return number < 0 ? "−" + digits : digits;
}

std::string counted(std::int64_t number, const std::string& one, const std::string& many) {
  return grouped(number) + " " + (number == 1 ? one : many);
}

}  // namespace netwright
