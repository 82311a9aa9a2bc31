#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace firstlight::app {

/// "500k", "16M", "1.5G", "1048576": a number of bytes, k, M, G and T being powers of 1024; a "B" or "iB" may follow.
/// Empty when `text` is something else or more than a machine can have.
std::optional<std::size_t> parse_memory_size(std::string_view text);

/// "16 M", "1.5 G", "900 bytes".
std::string short_memory_size(std::size_t bytes);

/// A quarter of the machine's memory, the rest being for the scene, the film and others; 0 when the system does not
/// tell.
std::size_t default_queue_memory();

}  // namespace firstlight::app
