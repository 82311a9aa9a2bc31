#pragma once

#include "app/study/plot.h"
#include "app/study/study.h"

#include <string>
#include <string_view>

namespace firstlight::app {

/// Style sheet and script of the page.
std::string_view report_style();
std::string_view report_script();

/// Times and queues, a row a scheme.
std::string time_table(const Study& study);
/// How fast the picture comes near to what it will be, a row a scheme.
std::string convergence_table(const Study& study);

/// A plot with its heading, the list of its lines, and what there is to say about it (HTML).
std::string figure(const Plot& plot, const std::string& caption);

}  // namespace firstlight::app
