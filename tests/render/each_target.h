#pragma once

#include <hwy/highway.h>
#include <hwy/targets.h>

#include <string>

namespace firstlight::render {

/// Calls visit(name) once for each instruction set that the program was compiled for and the machine has, with that one
/// chosen for what is dispatched at run time.
template <class Visit>
void for_each_target(const Visit& visit) {
  for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
    const std::int64_t target = left & -left;
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    visit(std::string(hwy::TargetName(target)));
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace firstlight::render
