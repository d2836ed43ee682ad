// What a finished PDF asks of viewers and printers, which cairo cannot say.
#pragma once

#include <string>

namespace netwright {

/// Tells viewers not to shrink the pages when printing (/PrintScaling /None), and with `is_double_sided` to
/// print on both sides, turned over the long edge. The same file in gives the same bytes. Throws Error(Write)
/// when the file is damaged.
std::string with_print_preferences(const std::string& pdf, bool is_double_sided);

}  // namespace netwright
