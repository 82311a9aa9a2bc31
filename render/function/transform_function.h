#pragma once

#include "render/function/function.h"
#include "render/math/transform.h"

namespace firstlight::render {

/// `function { transform { } }`: where a point goes.
FunctionPtr make_transform_function(const Transform& transform);

}  // namespace firstlight::render
