#include "render/shape/root_search.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shape/root_search.cpp"
#include <hwy/foreach_target.h>

#include "render/lanes/lanes-inl.h"
#include "render/math/interrupt.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#ifndef FIRSTLIGHT_RENDER_SHAPE_ROOT_SEARCH
#define FIRSTLIGHT_RENDER_SHAPE_ROOT_SEARCH
namespace firstlight::render {
namespace {

/// Stretches that a ray halves at once.
constexpr std::uint32_t kMostOfRay = 32;
constexpr std::size_t kMostStretches = kMostOfRay * kRaysAtOnce;
/// A search that needs more finds nothing. A field that is 0 all along a ray is asked at every step of the accuracy.
constexpr int kMostRounds = 50'000;
constexpr int kMostEvaluations = 1'000'000;

/// With room behind, so that equal places of the rows do not compete for one place in the cache.
template <class T>
using Row = std::array<T, kMostStretches + 40>;

/// Stretches of all rays; those of a ray follow each other, the nearest first, and have been halved as often.
struct Stretches {
  Row<double> begin, at_begin, end, at_end;
  Row<std::int64_t> ray;
  std::size_t size;

  void add(double from, double at_from, double to, double at_to, std::size_t of) {
    begin[size] = from;
    at_begin[size] = at_from;
    end[size] = to;
    at_end[size] = at_to;
    ray[size++] = static_cast<std::int64_t>(of);
  }
};

/// A round's middles of stretches, and which halves are to be looked at: bits of eight stretches each.
struct Middles {
  Row<double> depth;
  std::array<Row<double>, 3> point;
  Row<double> value;
  std::array<std::uint8_t, kMostStretches / 8> nearer, further;
};

/// Halves of a ray's stretches in the present round.
struct Halves {
  Column<double> length;  ///< halved from one to the next, not the difference of the ends
  Column<double> climb;   ///< how much the field may change along them, at most
};

}  // namespace
}  // namespace firstlight::render
#endif

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

HWY_INLINE Lanes gather(const Column<double>& column, const std::int64_t* rays) {
  return hn::GatherIndex(LaneTag(), column.at.data(), hn::LoadU(LaneBits(), rays));
}

void find_middles(const Stretches& all, const RayColumns& rays, const Column<double>& half_length, Middles& middles) {
  for (std::size_t i = 0; i < all.size; i += Lanes::kCount) {
    const std::int64_t* ray = all.ray.data() + i;
    const Lanes depth = Lanes::load(all.begin.data() + i) + gather(half_length, ray);
    depth.store(middles.depth.data() + i);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Lanes place = gather(rays.origin.of[axis], ray) + gather(rays.direction.of[axis], ray) * depth;
      place.store(middles.point[axis].data() + i);
    }
  }
}

/// Turns what the function gives into values of the fields.
void judge_halves(const Stretches& all, const RayFields& fields, const Halves& halves, const Column<double>& high,
                  double accuracy, Middles& middles) {
  std::fill_n(middles.nearer.begin(), (all.size + 7) / 8, std::uint8_t{0});
  std::fill_n(middles.further.begin(), (all.size + 7) / 8, std::uint8_t{0});
  for (std::size_t i = 0; i < all.size; i += Lanes::kCount) {
    const std::int64_t* ray = all.ray.data() + i;
    const Lanes value = gather(fields.sign(), ray) * (Lanes::load(middles.value.data() + i) - fields.threshold());
    value.store(middles.value.data() + i);
    const Lanes at_begin = Lanes::load(all.at_begin.data() + i), at_end = Lanes::load(all.at_end.data() + i);
    const Lanes climb = gather(halves.climb, ray), limit = gather(high, ray);
    const auto is_short = gather(halves.length, ray) < accuracy;
    const auto counts = [&](const Lanes& from, const Lanes& at_from, const Lanes& at_to) HWY_ATTR {
      const Lanes reach = select(is_short, at_to, at_from + at_to - climb);
      const auto mask = (reach < 0.0) & (from <= limit);
      return static_cast<std::uint8_t>(bits(mask) << (i % 8));
    };
    middles.nearer[i / 8] |= counts(Lanes::load(all.begin.data() + i), at_begin, value);
    middles.further[i / 8] |= counts(Lanes::load(middles.depth.data() + i), value, at_end);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(find_middles);
HWY_EXPORT(judge_halves);

/// One search.
class RootSearch::Rounds {
 public:
  Rounds(const RayFields& fields, double accuracy, const SearchedPart& part, Column<double>& root)
      : fields_(fields), accuracy_(accuracy), part_(part), root_(root), room_(room_of_thread()) {}

  std::uint64_t run(std::uint64_t who) {
    room_.now->size = 0;
    for (std::uint64_t bits = who; bits != 0; bits &= bits - 1) begin(static_cast<std::size_t>(__builtin_ctzll(bits)));
    for (int round = 0; open_ != 0 && round < kMostRounds && !Interrupt::asked(); ++round) halve();
    return found_;
  }

 private:
  /// A stretch that a ray looks at only if nothing is found before.
  struct PutOff {
    double begin, at_begin, end, at_end, length, climb;
  };
  struct Room {
    std::unique_ptr<Stretches> now = std::make_unique<Stretches>(), next = std::make_unique<Stretches>();
    std::unique_ptr<Middles> middles = std::make_unique<Middles>();
    std::array<std::vector<PutOff>, kRaysAtOnce> put_off;  ///< of each ray; the nearest is the last
  };

  static Room& room_of_thread() {
    thread_local Room room;
    return room;
  }

  void begin(std::size_t ray) {
    room_.put_off[ray].clear();
    const double length = part_.end[ray] - part_.begin[ray];
    const double climb = part_.gradient[ray] * part_.speed[ray] * length;
    const bool is_short = length < accuracy_;
    const bool counts = is_short ? part_.at_end[ray] < 0.0 : part_.at_begin[ray] + part_.at_end[ray] - climb < 0.0;
    if (!counts || !(part_.begin[ray] <= part_.high[ray])) return;
    if (is_short) return find(ray, part_.end[ray]);
    halves_.length[ray] = 0.5 * length;
    halves_.climb[ray] = 0.5 * climb;
    open_ |= std::uint64_t{1} << ray;
    room_.now->add(part_.begin[ray], part_.at_begin[ray], part_.end[ray], part_.at_end[ray], ray);
  }
  void find(std::size_t ray, double depth) {
    found_ |= std::uint64_t{1} << ray;
    root_[ray] = depth;
  }

  void halve() {
    const Stretches& now = *room_.now;
    Middles& middles = *room_.middles;
    pad(*room_.now);
    HWY_DYNAMIC_DISPATCH(find_middles)(now, fields_.rays(), halves_.length, middles);
    fields_.evaluate({middles.point[0].data(), middles.point[1].data(), middles.point[2].data()},
                     now.size == 1 ? 1 : padded(now.size), middles.value.data());
    HWY_DYNAMIC_DISPATCH(judge_halves)(now, fields_, halves_, part_.high, accuracy_, middles);
    choose_next();
    std::swap(room_.now, room_.next);
  }
  static std::size_t padded(std::size_t size) { return (size + 7) / 8 * 8; }
  /// Fills what stands behind the stretches up to a multiple of eight with the last.
  static void pad(Stretches& all) {
    const std::size_t last = all.size - 1;
    for (std::size_t i = all.size; i < padded(all.size); ++i) {
      all.begin[i] = all.begin[last];
      all.at_begin[i] = all.at_begin[last];
      all.end[i] = all.end[last];
      all.at_end[i] = all.at_end[last];
      all.ray[i] = all.ray[last];
    }
  }

  /// Takes the halves that are to be looked at into the next round: of each ray those up to the first that ends below
  /// 0, for there a root is to be expected. Others are put off.
  void choose_next() {
    const Stretches& now = *room_.now;
    const Middles& middles = *room_.middles;
    room_.next->size = 0;
    std::uint64_t going_on = 0;
    Chosen of;
    const auto finish = [&] {
      if (of.ray == kNoRay) return;
      if (of.has_some) going_on |= std::uint64_t{1} << of.ray;
      std::vector<PutOff>& put_off = room_.put_off[of.ray];
      std::reverse(put_off.begin() + static_cast<std::ptrdiff_t>(of.put_off), put_off.end());
    };
    for (std::size_t i = 0; i < now.size; i += 8) {
      const unsigned nearer = middles.nearer[i / 8], further = middles.further[i / 8];
      for (unsigned bits = nearer | further; bits != 0; bits &= bits - 1) {
        const auto bit = static_cast<unsigned>(__builtin_ctz(bits));
        const std::size_t at = i + bit;
        if (at >= now.size) break;
        const auto ray = static_cast<std::size_t>(now.ray[at]);
        if (ray != of.ray) {
          finish();
          of = {ray, halves_.length[ray] < accuracy_, false, false, room_.next->size, room_.put_off[ray].size()};
        }
        if ((nearer >> bit & 1u) != 0) {
          take(of, now.begin[at], now.at_begin[at], middles.depth[at], middles.value[at]);
        }
        if ((further >> bit & 1u) != 0) take(of, middles.depth[at], middles.value[at], now.end[at], now.at_end[at]);
      }
    }
    finish();
    const std::uint64_t left = open_ & ~going_on & ~found_;
    open_ = going_on;
    for (std::uint64_t bits = going_on; bits != 0; bits &= bits - 1) {
      const auto ray = static_cast<std::size_t>(__builtin_ctzll(bits));
      halves_.length[ray] *= 0.5;
      halves_.climb[ray] *= 0.5;
    }
    for (std::uint64_t bits = left; bits != 0; bits &= bits - 1)
      take_up(static_cast<std::size_t>(__builtin_ctzll(bits)));
  }
  static constexpr std::size_t kNoRay = kRaysAtOnce;
  /// A ray whose halves are being chosen.
  struct Chosen {
    std::size_t ray = kNoRay;
    bool is_short = false;  ///< they are answers
    bool has_some = false;
    bool is_full = false;
    std::size_t first = 0;    ///< among the next
    std::size_t put_off = 0;  ///< before
  };
  void take(Chosen& of, double begin, double at_begin, double end, double at_end) {
    if (of.is_short) {
      if ((found_ >> of.ray & 1u) == 0) find(of.ray, end);
    } else if (!of.is_full) {
      room_.next->add(begin, at_begin, end, at_end, of.ray);
      of.has_some = true;
      of.is_full = at_end < 0.0 || room_.next->size - of.first == kMostOfRay;
    } else {
      room_.put_off[of.ray].push_back({begin, at_begin, end, at_end, halves_.length[of.ray], halves_.climb[of.ray]});
    }
  }
  /// Goes on with the nearest stretches that were put off, which have been halved as often.
  void take_up(std::size_t ray) {
    Stretches& next = *room_.next;
    std::vector<PutOff>& put_off = room_.put_off[ray];
    if (put_off.empty()) return;
    open_ |= std::uint64_t{1} << ray;
    const double length = put_off.back().length;
    halves_.length[ray] = 0.5 * length;
    halves_.climb[ray] = 0.5 * put_off.back().climb;
    for (std::uint32_t count = 0; count < kMostOfRay && !put_off.empty() && put_off.back().length == length; ++count) {
      const PutOff s = put_off.back();
      put_off.pop_back();
      next.add(s.begin, s.at_begin, s.end, s.at_end, ray);
      if (s.at_end < 0.0) break;
    }
  }

  const RayFields& fields_;
  double accuracy_;
  const SearchedPart& part_;
  Column<double>& root_;
  Room& room_;
  Halves halves_;
  std::uint64_t open_ = 0;
  std::uint64_t found_ = 0;
};

std::uint64_t RootSearch::first(std::uint64_t who, const SearchedPart& part, Column<double>& root) const {
  return Rounds(fields_, accuracy_, part, root).run(who);
}

/// Looks at one stretch after the other up to one that must be halved: what the nearer half teaches of the gradient
/// counts in the further one.
LearningSearch::Next LearningSearch::look(std::size_t ray, SearchedPart& part, std::vector<Stretch>& waiting) const {
  for (; !waiting.empty(); waiting.pop_back()) {
    Stretch& s = waiting.back();
    double& gradient = part.gradient[ray];
    const double met = std::abs((s.at_end - s.at_begin) / (part.speed[ray] * s.length));
    if (gradient < met * evaluate_[1]) {
      gradient = met * evaluate_[1] * evaluate_[1];
      s.climb = gradient * part.speed[ray] * s.length;
    }
    if (s.length < accuracy_) {
      if (s.at_end < 0.0) return Next::found;
    } else if (s.at_begin + s.at_end - s.climb < 0.0) {
      return Next::halve;
    }
  }
  return Next::nothing;
}

std::uint64_t LearningSearch::first(std::uint64_t who, SearchedPart& part, Column<double>& root) {
  thread_local std::array<std::vector<Stretch>, kRaysAtOnce> waiting_of_rays;
  for (std::uint64_t bits = who; bits != 0; bits &= bits - 1) {
    const auto ray = static_cast<std::size_t>(__builtin_ctzll(bits));
    if (part.gradient[ray] > evaluate_[0]) part.gradient[ray] *= evaluate_[2];
    const double length = part.end[ray] - part.begin[ray];
    waiting_of_rays[ray] = {{part.begin[ray], part.at_begin[ray], part.end[ray], part.at_end[ray], length,
                             part.gradient[ray] * part.speed[ray] * length}};
  }
  std::uint64_t found = 0;
  std::uint64_t open = who;
  Column<double> middle;
  Column<double> at_middle;
  for (int round = 0; open != 0; ++round) {
    for (std::uint64_t bits = open; bits != 0; bits &= bits - 1) {
      const auto ray = static_cast<std::size_t>(__builtin_ctzll(bits));
      const std::uint64_t bit = std::uint64_t{1} << ray;
      const std::vector<Stretch>& waiting = waiting_of_rays[ray];
      const Next next = look(ray, part, waiting_of_rays[ray]);
      if (next == Next::halve) {
        middle[ray] = waiting.back().begin + 0.5 * waiting.back().length;
        ++evaluations_;
        continue;
      }
      open &= ~bit;
      if (next == Next::nothing) continue;
      found |= bit;
      root[ray] = waiting.back().end;
    }
    if (round >= kMostEvaluations || Interrupt::asked()) break;
    fields_.at(open, middle, at_middle);
    for (std::uint64_t bits = open; bits != 0; bits &= bits - 1) {
      const auto ray = static_cast<std::size_t>(__builtin_ctzll(bits));
      std::vector<Stretch>& waiting = waiting_of_rays[ray];
      const Stretch s = waiting.back();
      waiting.pop_back();
      waiting.push_back({middle[ray], at_middle[ray], s.end, s.at_end, 0.5 * s.length, 0.5 * s.climb});
      waiting.push_back({s.begin, s.at_begin, middle[ray], at_middle[ray], 0.5 * s.length, 0.5 * s.climb});
    }
  }
  return found;
}

}  // namespace firstlight::render
#endif
