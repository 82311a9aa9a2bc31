#pragma once

#include <string_view>

namespace firstlight::app::compare {

// The files of this folder that go into every report, put into the program when it is built (embed.cmake).
std::string_view report_css();
std::string_view index_js();
std::string_view scene_js();

}  // namespace firstlight::app::compare
