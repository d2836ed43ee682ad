// What cairo cannot say about a finished file, added afterwards.
#pragma once

#include <string>

namespace netwright {

/// Tells PDF viewers not to shrink the page when printing (/PrintScaling /None), by an incremental update at
/// the end of the file. A file of unknown make is returned unchanged.
std::string with_true_size_printing(std::string pdf);

/// Stores the resolution in a PNG (chunk pHYs), so that it prints at true size.
std::string with_resolution(std::string png, double dpi);

}  // namespace netwright
