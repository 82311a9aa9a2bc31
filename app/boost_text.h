#pragma once

#include "priority/order.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace firstlight::app {

/// The words of `text`, between blanks.
std::vector<std::string_view> words_of(std::string_view text);

/// A boost as a user writes it: "region X0 Y0 X1 Y1", "object NAME" or "light N", then perhaps "by N" and "as NAME".
/// Without a name of its own it gets one that none of `present` has. On failure the result is empty and `error` says
/// what is wrong; whether the scene has such an object is for priority::Order to say.
std::optional<priority::Boost> parse_boost(std::string_view text, std::span<const priority::Boost> present,
                                           std::string& error);

/// "face: region 10 10 50 50 by 2".
std::string boost_text(const priority::Boost& boost);

/// How they are written, for a help text.
std::string boost_help();

}  // namespace firstlight::app
