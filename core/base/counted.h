// Numbers in sentences, the same everywhere: with what they count, and easy to read however large they are.
#pragma once

#include <cstdint>
#include <string>

namespace netwright {

/// Thousands apart by thin spaces: 12 000.
std::string grouped(std::int64_t number);
/// "1 move", "2 moves", "12 000 moves".
std::string counted(std::int64_t number, const std::string& one, const std::string& many);

}  // namespace netwright
