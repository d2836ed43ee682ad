// What a finished PDF asks of viewers and printers, which cairo cannot say.
#pragma once

#include <string>

namespace netwright {

/// How sheets are printed on both sides, in the words of PDF.
enum class Duplex { None, FlipLongEdge, FlipShortEdge };

/// Tells viewers not to shrink the pages when printing (/PrintScaling /None), and where `duplex` says so to
/// print on both sides. The same file in gives the same bytes. Throws Error(Write) when the file is damaged.
std::string with_print_preferences(const std::string& pdf, Duplex duplex);

}  // namespace netwright
