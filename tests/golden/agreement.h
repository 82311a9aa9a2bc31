#pragma once
#include "tests/golden/scene_list.h"

#include <string>
#include <vector>

namespace firstlight::golden {

/// Renders the scene with both programs, here and now, and fails the test when their pictures differ by more than the
/// scene allows; both pictures, their difference and the numbers are then left in the folder golden-failures. `more`
/// is added to the options of both.
void expect_agreement(const GoldenScene& scene, const std::vector<std::string>& more = {});

}  // namespace firstlight::golden
