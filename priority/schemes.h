#pragma once

#include "priority/scheme.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace firstlight::priority {

/// What a scheme may know of the picture beside the tasks.
struct SchemeInput {
  int width = 0;  ///< pixels
  int height = 0;
  int max_trace_level = 0;
};

/// A way to order the rays, as the user chooses it by name.
struct SchemeRow {
  std::string_view name;
  std::string_view meaning;  ///< one line for the help text
  /// Null: the traditional order, pixel by pixel and depth first, without a queue.
  std::unique_ptr<const Scheme> (*make)(const SchemeInput& input);
};

constexpr std::string_view kDefaultScheme = "contribution";

/// All of them. A new scheme is a file with a maker and a row here.
std::span<const SchemeRow> schemes();
/// Null when there is none of that name.
const SchemeRow* find_scheme(std::string_view name);
/// "contribution, level, ..." for messages.
std::string scheme_names();

std::unique_ptr<const Scheme> make_contribution(const SchemeInput& input);
std::unique_ptr<const Scheme> make_level(const SchemeInput& input);
std::unique_ptr<const Scheme> make_ray_type(const SchemeInput& input);

}  // namespace firstlight::priority
