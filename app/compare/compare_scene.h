#pragma once

#include "app/compare/record.h"
#include "app/compare/settings.h"

#include <string>

namespace firstlight::app::compare {

/// Renders a scene with POV-Ray and with Firstlight in turn, and compares what they made. Errors are in the record. When
/// CompareSettings::stop became true meanwhile, the programs have been ended and the record says nothing.
/// Threads  May be called by several at a time.
SceneRecord compare_scene(const SceneJob& job, const CompareSettings& settings);

/// Empty, or that POV-Ray is not there and how to install it.
std::string check_povray(const CompareSettings& settings);

}  // namespace firstlight::app::compare
