#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace firstlight::render {

/// Features that the scene language has and a picture may not be able to show: one row each in features.def.
enum class Feature : std::uint16_t {
#define FEATURE(name, spelling, rendered) name,
#include "render/feature/features.def"
#undef FEATURE
};

/// The feature as the scene language writes it: "blob", "camera fisheye".
std::string_view spelling(Feature feature);
/// Whether pictures show it.
bool is_rendered(Feature feature);

/// A place in the scene text where a feature is asked for. `file` is the front end's number of the file; line and
/// column count from 1.
struct FeatureUse {
  Feature feature{};
  std::uint32_t file = 0;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

/// The features that a description asks for and that cannot be rendered, the first place of each. Empty for most; a
/// copy is cheap. A description carries its own, so what is declared and never used is never refused.
class FeatureUses {
 public:
  /// Does nothing for a feature that is rendered.
  void add(const FeatureUse& use);
  void add(const FeatureUses& others);
  /// Forgets the uses of a feature.
  void remove(Feature feature);
  bool empty() const { return !uses_; }
  const std::vector<FeatureUse>& list() const;

 private:
  std::shared_ptr<const std::vector<FeatureUse>> uses_;
};

}  // namespace firstlight::render
