#pragma once

#include "priority/scheme.h"
#include "priority/scheme_input.h"
#include "priority/scheme_text.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace firstlight::priority {

using SchemePtr = std::shared_ptr<const Scheme>;

/// A way to order the rays, as the user chooses it by name.
struct SchemeRow {
  std::string_view name;
  std::string_view meaning;    ///< one line for the help text
  std::string_view arguments;  ///< as they are written behind the name; empty: it takes none
  std::string_view example;    ///< text of an order that works with every scene
  /// Null: the traditional order, pixel by pixel and depth first, without a queue. `arguments`: behind their opening
  /// parenthesis; null: none were given. Throws SchemeError and MissingArguments.
  SchemePtr (*make)(const SchemeInput& input, SchemeText* arguments);
};

constexpr std::string_view kDefaultScheme = "contribution";

/// All of them. A new scheme is a file with a maker and a row here.
std::span<const SchemeRow> schemes();
/// Null when there is none of that name.
const SchemeRow* find_scheme(std::string_view name);
/// "contribution, level, ..." for messages.
std::string scheme_names();

/// The scheme or mixture that `text` stands for, null for `recursive`. Throws SchemeError. [scheme_parser.cpp]
SchemePtr parse_scheme(std::string_view text, const SchemeInput& input);

SchemePtr make_contribution(const SchemeInput& input, SchemeText* arguments);
SchemePtr make_complexity(const SchemeInput& input, SchemeText* arguments);
SchemePtr make_distance(const SchemeInput& input, SchemeText* arguments);
SchemePtr make_expression(const SchemeInput& input, SchemeText* arguments);
SchemePtr make_level(const SchemeInput& input, SchemeText* arguments);
SchemePtr make_light(const SchemeInput& input, SchemeText* arguments);
SchemePtr make_light_colour(const SchemeInput& input, SchemeText* arguments);
SchemePtr make_light_distance(const SchemeInput& input, SchemeText* arguments);
SchemePtr make_object(const SchemeInput& input, SchemeText* arguments);
SchemePtr make_ray_type(const SchemeInput& input, SchemeText* arguments);
SchemePtr make_region(const SchemeInput& input, SchemeText* arguments);
SchemePtr make_sample(const SchemeInput& input, SchemeText* arguments);
SchemePtr make_surface(const SchemeInput& input, SchemeText* arguments);

}  // namespace firstlight::priority
