// Numbers as text, the same on every machine (the locale has no say).
#pragma once

#include <string>

namespace netwright {

/// At most three significant digits, without trailing zeros and without exponent where it can be helped:
/// "1.43", "0.0125", "143", "1430".
std::string short_number(double value);

/// At most `decimals` digits after the point, without trailing zeros: "12.5", "0", "-3.0625".
std::string decimal_number(double value, int decimals);

}  // namespace netwright
