#include "render/feature/feature.h"

#include <algorithm>

namespace firstlight::render {
namespace {

struct Row {
  std::string_view spelling;
  bool rendered;
};

constexpr Row kRows[] = {
#define FEATURE(name, spelling, rendered) {spelling, rendered},
#include "render/feature/features.def"
#undef FEATURE
};

const Row& row_of(Feature feature) { return kRows[static_cast<std::size_t>(feature)]; }

}  // namespace

std::string_view spelling(Feature feature) { return row_of(feature).spelling; }
bool is_rendered(Feature feature) { return row_of(feature).rendered; }

void FeatureUses::add(const FeatureUse& use) {
  if (is_rendered(use.feature)) return;
  const auto same = [&](const FeatureUse& other) { return other.feature == use.feature; };
  if (uses_ && std::any_of(uses_->begin(), uses_->end(), same)) return;
  auto more = uses_ ? std::make_shared<std::vector<FeatureUse>>(*uses_) : std::make_shared<std::vector<FeatureUse>>();
  more->push_back(use);
  uses_ = std::move(more);
}

void FeatureUses::add(const FeatureUses& others) {
  if (uses_ == others.uses_) return;
  if (!uses_) {
    uses_ = others.uses_;
    return;
  }
  for (const FeatureUse& use : others.list()) add(use);
}

void FeatureUses::remove(Feature feature) {
  if (!uses_) return;
  std::vector<FeatureUse> rest = *uses_;
  std::erase_if(rest, [&](const FeatureUse& use) { return use.feature == feature; });
  uses_ = rest.empty() ? nullptr : std::make_shared<std::vector<FeatureUse>>(std::move(rest));
}

const std::vector<FeatureUse>& FeatureUses::list() const {
  static const std::vector<FeatureUse> none;
  return uses_ ? *uses_ : none;
}

}  // namespace firstlight::render
