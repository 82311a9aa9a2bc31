#pragma once

#include <span>
#include <string>
#include <string_view>

namespace firstlight::app {

/// `program` with its arguments as they can be typed into a shell again.
std::string command_text(std::string_view program, std::span<const std::string> arguments);

}  // namespace firstlight::app
