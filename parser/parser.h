#pragma once

#include "render/scene/front_end.h"

namespace firstlight::parser {

/// The POV-Ray scene description language, version 3.7, as a front end of the renderer.
class PovFrontEnd final : public render::FrontEnd {
 public:
  std::string_view name() const override { return "pov"; }
  std::vector<std::string_view> extensions() const override { return {".pov"}; }
  render::LoadResult load(const std::string& path, const render::LoadOptions& options) const override;
};

}  // namespace firstlight::parser
