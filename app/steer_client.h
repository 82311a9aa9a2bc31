#pragma once

#include <span>
#include <string>

namespace firstlight::app {

/// `firstlight steer SOCKET [command...]`: sends the command, or without one each line of the standard input, to the
/// program that renders, and prints its answers. Returns the exit code: 1 when there was an answer that says "error".
int steer_client(std::span<const std::string> arguments);

}  // namespace firstlight::app
