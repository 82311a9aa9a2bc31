#pragma once

#include "app/compare/record.h"

#include <span>
#include <string>
#include <string_view>

namespace firstlight::app::compare {

/// A Markdown page: totals, what is missing, and for each folder a line a scene that both programs rendered, and the
/// names of the others with the number of features that they lack. `command`: what makes the page anew.
std::string agreement_page(std::span<const SceneRecord> records, std::string_view command);

}  // namespace firstlight::app::compare
