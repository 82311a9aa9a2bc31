#pragma once

#include <string_view>

namespace firstlight::app {

/// As in the project() line of CMakeLists.txt.
constexpr std::string_view kVersion = "0.1.0";

}  // namespace firstlight::app
