// What cairo cannot say about a finished picture, added afterwards.
#pragma once

#include <string>

namespace netwright {

/// Stores the resolution in a PNG (chunk pHYs), so that it prints at true size.
std::string with_resolution(std::string png, double dpi);

}  // namespace netwright
