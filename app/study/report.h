#pragma once

#include "app/study/study.h"

#include <string>

namespace firstlight::app {

/// The study as one HTML page: tables, the paper's figures as plots, and what the picture looked like on the way. It
/// needs no other file and no network, and has a light and a dark look.
std::string report_html(const Study& study);

}  // namespace firstlight::app
