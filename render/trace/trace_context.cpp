#include "render/trace/trace_context.h"

#include "render/scene/scene.h"

namespace firstlight::render {

const Camera& TraceContext::camera() const { return other_camera != nullptr ? *other_camera : scene.camera; }

}  // namespace firstlight::render
