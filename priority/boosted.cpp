#include "priority/boosted.h"

#include "priority/object_names.h"
#include "priority/pixels.h"
#include "priority/stacked.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <set>
#include <span>

namespace firstlight::priority {
namespace {

/// Sums of boosts, from the least to the largest that a ray can have, as numbers from 0.
class BoostRanks {
 public:
  explicit BoostRanks(const std::vector<Boost>& boosts) {
    std::set<std::int64_t> sums{0};
    for (const Boost& boost : boosts) {
      const std::set<std::int64_t> without = sums;
      for (const std::int64_t sum : without) sums.insert(sum + boost.by);
      if (sums.size() > kMost) break;
    }
    for (const Boost& boost : boosts) (boost.by < 0 ? least_ : largest_) += boost.by;
    if (sums.size() <= kMost) sums_.assign(sums.begin(), sums.end());
  }

  Key count() const { return sums_.empty() ? kMost : static_cast<Key>(sums_.size()); }
  Key of(std::int64_t sum) const {
    if (!sums_.empty()) return static_cast<Key>(std::ranges::lower_bound(sums_, sum) - sums_.begin());
    // Too many to give each its own: by size.
    const double share = static_cast<double>(sum - least_) / static_cast<double>(largest_ - least_);
    return std::min(static_cast<Key>(share * kMost), kMost - 1);
  }

 private:
  static constexpr Key kMost = 64;
  std::vector<std::int64_t> sums_;  // rising; empty: too many
  std::int64_t least_ = 0;
  std::int64_t largest_ = 0;
};

class Boosted final : public Scheme {
 public:
  Boosted(std::shared_ptr<const Scheme> base, const std::vector<Boost>& boosts, const SchemeInput& input)
      : base_(std::move(base)), pixels_(input), ranks_(boosts), keys_(ranks_.count(), base_->key_count()) {
    const std::span<const render::ObjectGroup> groups = input.scene.objects;
    by_object_.resize(groups.size());
    by_light_.resize(input.scene.lights.size());
    for (const Boost& boost : boosts) {
      switch (boost.kind) {
        case Boost::Kind::region:
          regions_.push_back({boost.region, boost.by});
          break;
        case Boost::Kind::object:
          for (std::size_t i = 0; i < groups.size(); ++i) {
            if (is_called(groups[i], boost.object)) by_object_[i] += boost.by;
          }
          break;
        case Boost::Kind::light:
          by_light_[static_cast<std::size_t>(boost.light)] += boost.by;
          has_lights_ = true;
          break;
      }
    }
  }

  void keys(std::span<const render::RayTask> tasks, std::span<Key> keys) const override {
    base_->keys(tasks, keys);
    for (std::size_t i = 0; i < tasks.size(); ++i) keys[i] = keys_.of(ranks_.of(sum_of(tasks[i])), keys[i]);
  }
  Key key_count() const override { return keys_.count(); }
  bool tells_pixels_apart() const override { return !regions_.empty() || base_->tells_pixels_apart(); }
  void learn(std::span<const render::RayTask> tasks, std::span<const render::Contribution> light,
             std::span<const render::RayTask> spawned) const override {
    base_->learn(tasks, light, spawned);
  }

 private:
  struct Region {
    Rectangle where;
    std::int64_t by;
  };

  std::int64_t sum_of(const render::RayTask& task) const {
    std::int64_t sum = task.object < by_object_.size() ? by_object_[task.object] : 0;
    if (!regions_.empty()) {
      const int x = pixels_.x(task);
      const int y = pixels_.y(task);
      for (const auto& [where, by] : regions_) {
        if (x >= where.left && x <= where.right && y >= where.top && y <= where.bottom) sum += by;
      }
    }
    if (has_lights_ && task.kind == render::RayKind::shadow) {
      // The feelers of a record leave together: with the one that is wanted most.
      std::int64_t most = std::numeric_limits<std::int64_t>::min();
      task.for_each_feeler([&](std::uint32_t light, const render::PackedRgb&) {
        if (light < by_light_.size()) most = std::max(most, by_light_[light]);
      });
      sum += most;
    }
    return sum;
  }

  std::shared_ptr<const Scheme> base_;
  Pixels pixels_;
  BoostRanks ranks_;
  StackedKeys keys_;
  std::vector<Region> regions_;
  std::vector<std::int64_t> by_object_;
  std::vector<std::int64_t> by_light_;
  bool has_lights_ = false;
};

}  // namespace

std::shared_ptr<const Scheme> make_boosted(std::shared_ptr<const Scheme> base, const std::vector<Boost>& boosts,
                                           const SchemeInput& input) {
  return std::make_shared<Boosted>(std::move(base), boosts, input);
}

}  // namespace firstlight::priority
