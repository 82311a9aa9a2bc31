#include "priority/mixture.h"

#include "priority/stacked.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace firstlight::priority {
namespace {

/// Tasks at a time, so that a further member's keys need no memory of their own.
constexpr std::size_t kChunk = 256;

/// Calls use(first index, chunk of tasks, room for as many keys).
template <class Use>
void by_chunks(std::span<const render::RayTask> tasks, const Use& use) {
  std::array<Key, kChunk> room;
  for (std::size_t begin = 0; begin < tasks.size(); begin += kChunk) {
    const std::size_t count = std::min(kChunk, tasks.size() - begin);
    use(begin, tasks.subspan(begin, count), std::span(room).first(count));
  }
}

class Lexicographic final : public Scheme {
 public:
  Lexicographic(SchemePtr first, SchemePtr second)
      : first_(std::move(first)), second_(std::move(second)), stacked_(first_->key_count(), second_->key_count()) {}

  void keys(std::span<const render::RayTask> tasks, std::span<Key> keys) const override {
    first_->keys(tasks, keys);
    by_chunks(tasks, [&](std::size_t begin, std::span<const render::RayTask> chunk, std::span<Key> second) {
      second_->keys(chunk, second);
      for (std::size_t i = 0; i < second.size(); ++i) keys[begin + i] = stacked_.of(keys[begin + i], second[i]);
    });
  }
  Key key_count() const override { return stacked_.count(); }
  bool tells_pixels_apart() const override { return first_->tells_pixels_apart() || second_->tells_pixels_apart(); }
  void learn(std::span<const render::RayTask> tasks, std::span<const render::Contribution> light,
             std::span<const render::RayTask> spawned) const override {
    first_->learn(tasks, light, spawned);
    second_->learn(tasks, light, spawned);
  }

 private:
  SchemePtr first_;
  SchemePtr second_;
  StackedKeys stacked_;
};

class Weighted final : public Scheme {
 public:
  explicit Weighted(std::vector<WeightedMember> members) : members_(std::move(members)) {
    double span = 0.0;
    for (const WeightedMember& member : members_) {
      if (member.weight < 0.0) least_ += member.weight;
      span += std::abs(member.weight);
    }
    if (span > 0.0) {
      // The smaller a member's weight, the more keys it takes to tell all its values apart.
      double wanted = 1.0;
      for (const WeightedMember& member : members_) {
        if (member.weight == 0.0) continue;
        wanted = std::max(wanted, (member.scheme->key_count() - 1) * span / std::abs(member.weight));
      }
      count_ = static_cast<Key>(std::min<double>(std::ceil(wanted) + 1.0, kMostKeys));
      scale_ = (count_ - 1) / span;
    }
  }

  void keys(std::span<const render::RayTask> tasks, std::span<Key> keys) const override {
    by_chunks(tasks, [&](std::size_t begin, std::span<const render::RayTask> chunk, std::span<Key> own) {
      std::array<double, kChunk> sums;
      std::fill_n(sums.begin(), own.size(), -least_);
      for (const WeightedMember& member : members_) {
        const Key last = member.scheme->key_count() - 1;
        if (last == 0) continue;
        member.scheme->keys(chunk, own);
        const double step = member.weight / last;
        for (std::size_t i = 0; i < own.size(); ++i) sums[i] += step * own[i];
      }
      for (std::size_t i = 0; i < own.size(); ++i) {
        keys[begin + i] = std::min(static_cast<Key>(std::max(sums[i] * scale_ + 0.5, 0.0)), count_ - 1);
      }
    });
  }
  Key key_count() const override { return count_; }
  bool tells_pixels_apart() const override {
    return std::ranges::any_of(members_, [](const WeightedMember& m) { return m.scheme->tells_pixels_apart(); });
  }
  void learn(std::span<const render::RayTask> tasks, std::span<const render::Contribution> light,
             std::span<const render::RayTask> spawned) const override {
    for (const WeightedMember& member : members_) member.scheme->learn(tasks, light, spawned);
  }

 private:
  static constexpr Key kMostKeys = 1024;  // more would leave blocks half empty

  std::vector<WeightedMember> members_;
  double least_ = 0.0;
  double scale_ = 0.0;
  Key count_ = 1;
};

}  // namespace

SchemePtr make_lexicographic(std::vector<SchemePtr> members) {
  SchemePtr all = members.front();
  for (std::size_t i = 1; i < members.size(); ++i) all = std::make_shared<Lexicographic>(all, std::move(members[i]));
  return all;
}

SchemePtr make_weighted(std::vector<WeightedMember> members) { return std::make_shared<Weighted>(std::move(members)); }

}  // namespace firstlight::priority
