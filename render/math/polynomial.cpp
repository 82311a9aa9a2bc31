#include "render/math/polynomial.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/math/polynomial.cpp"
#include <hwy/foreach_target.h>

#include "render/math/polynomial-inl.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace firstlight::render {
namespace HWY_NAMESPACE {

/// Up to kRaysAtOnce of the polynomials in any order, by their numbers.
struct Chosen {
  std::array<std::uint8_t, kRaysAtOnce + Lanes::kCount> number;
  std::size_t count = 0;

  void add(std::size_t which) { number[count++] = static_cast<std::uint8_t>(which); }
  /// Lanes beyond the last repeat it.
  void fill() { std::fill_n(number.begin() + static_cast<std::ptrdiff_t>(count), Lanes::kCount, number[count - 1]); }
};

/// The coefficients of `count` of them that stand in the list from `first` on, in ascending order.
template <class Order>
HWY_INLINE void gather(const PolynomialColumns& p, Order order, const std::uint8_t* first, std::size_t count,
                       Lanes* c) {
  if (count == Lanes::kCount && first[count - 1] == first[0] + count - 1) {
    for (std::size_t i = 0; i <= order; ++i) c[i] = Lanes::load(&p.c[i][first[0]]);
    return;
  }
  for (std::size_t i = 0; i <= order; ++i) {
    double numbers[Lanes::kCount];
    for (std::size_t lane = 0; lane < Lanes::kCount; ++lane) numbers[lane] = p.c[i][first[lane]];
    c[i] = Lanes::load(numbers);
  }
}

/// Curve parts that hold one root each.
struct Brackets {
  Chosen of;
  Column<double> begin, end, at_begin, from;

  void add(std::size_t which, const CurvePart& part, double start) {
    begin[of.count] = part.begin;
    end[of.count] = part.end;
    at_begin[of.count] = part.at_begin;
    from[of.count] = start;
    of.add(which);
  }
};

/// The curve parts of as many polynomials as there are lanes.
struct PartColumns {
  double begin[Lanes::kCount], end[Lanes::kCount], at_begin[Lanes::kCount], at_end[Lanes::kCount];

  void set(std::size_t lane, const CurvePart& part) {
    begin[lane] = part.begin;
    end[lane] = part.end;
    at_begin[lane] = part.at_begin;
    at_end[lane] = part.at_end;
  }
};

/// Takes the nearest waiting part of each polynomial from `first` on, `count` of them. What is in question is put back in
/// halves, what holds one root into `brackets`.
template <class Order>
HWY_INLINE void look_at_parts(const PolynomialColumns& p, Order order, const std::uint8_t* first, std::size_t count,
                              RootColumns::Search& search, Brackets& brackets) {
  Lanes c[kCoefficients<Order>];
  gather(p, order, first, count, c);
  PartColumns parts;
  unsigned whole_bits = 0;
  for (std::size_t lane = 0; lane < Lanes::kCount; ++lane) {
    const std::size_t which = first[lane];
    if (lane < count) --search.waiting_count[which];
    parts.set(lane, search.waiting[which][search.waiting_count[which]]);
    whole_bits |= unsigned{search.halvings_left[which] == PolynomialRoots::kMostHalvings} << lane;
  }
  const auto begin = Lanes::load(parts.begin);
  const auto end = Lanes::load(parts.end);
  const Lanes width = end - begin;
  Lanes b[kCoefficients<Order>];
  find_bernstein(c, order, begin, width, b);
  auto at_begin = Lanes::load(parts.at_begin);
  auto at_end = Lanes::load(parts.at_end);
  if (whole_bits != 0) {
    const auto whole = Lanes::mask_of(whole_bits);
    at_begin = select(whole, b[0], at_begin);
    at_end = select(whole, value(c, order, end), at_end);
    at_begin.store(parts.at_begin);
    at_end.store(parts.at_end);
  }
  b[0] = at_begin;
  b[order] = at_end;
  const SignChanges<Lanes> changes = sign_changes(b, order);
  const unsigned of_count = (1u << count) - 1u;
  const unsigned once = bits(changes.once) & of_count;
  unsigned often = bits(changes.often) & of_count;
  if ((once | often) == 0) return;
  double start[Lanes::kCount];
  (begin + width * changes.crossing).store(start);
  if (std::is_same_v<Order, std::integral_constant<std::size_t, 4>> && (often & whole_bits) != 0) {
    often &= ~(bits(without(has_no_real_root(c), is_narrow(begin, end))) & whole_bits);
  }
  double middles[Lanes::kCount];
  double at_middle[Lanes::kCount];
  unsigned narrow = 0;
  if (often != 0) {
    const Lanes middle = 0.5 * (begin + end);
    middle.store(middles);
    value(c, order, middle).store(at_middle);
    narrow = bits(is_narrow(begin, end));
  }
  for (std::size_t lane = 0; lane < count; ++lane) {
    const std::size_t which = first[lane];
    const CurvePart part{parts.begin[lane], parts.end[lane], parts.at_begin[lane], parts.at_end[lane]};
    if ((once >> lane & 1u) != 0) {
      brackets.add(which, part, start[lane]);
    } else if ((often >> lane & 1u) != 0) {
      if (search.halvings_left[which] == 0 || (narrow >> lane & 1u) != 0) {
        if ((part.at_begin < 0.0) != (part.at_end < 0.0)) brackets.add(which, part, middles[lane]);
        continue;
      }
      --search.halvings_left[which];
      CurvePart* waiting = search.waiting[which].data() + search.waiting_count[which];
      waiting[0] = {middles[lane], part.end, at_middle[lane], part.at_end};
      waiting[1] = {part.begin, middles[lane], part.at_begin, at_middle[lane]};
      search.waiting_count[which] = static_cast<std::uint8_t>(search.waiting_count[which] + 2);
    }
  }
}

template <class Order>
HWY_INLINE void solve(const PolynomialColumns& p, Order order, Brackets& brackets, Column<double>& root) {
  if (brackets.of.count == 0) return;
  brackets.of.fill();
  for (std::size_t i = 0; i < brackets.of.count; i += Lanes::kCount) {
    const std::uint8_t* first = &brackets.of.number[i];
    const std::size_t count = std::min(Lanes::kCount, brackets.of.count - i);
    Lanes c[kCoefficients<Order>];
    gather(p, order, first, count, c);
    const auto below = load<Lanes>(brackets.at_begin, i) < Lanes(0.0);
    double found[Lanes::kCount];
    bracketed_root(c, order, load<Lanes>(brackets.begin, i), load<Lanes>(brackets.end, i), below,
                   load<Lanes>(brackets.from, i), Lanes::first(count))
        .store(found);
    for (std::size_t lane = 0; lane < count; ++lane) root[first[lane]] = found[lane];
  }
}

template <class Order>
HWY_INLINE std::uint64_t next_roots(const PolynomialColumns& p, Order order, RootColumns::Search& search,
                                    std::uint64_t open, Column<double>& root) {
  std::uint64_t found = 0;
  while (open != 0) {
    Chosen chosen;
    for (std::uint64_t left = open; left != 0; left &= left - 1) {
      const auto which = static_cast<std::size_t>(__builtin_ctzll(left));
      if (search.waiting_count[which] != 0) {
        chosen.add(which);
      } else {
        open &= ~(std::uint64_t{1} << which);
      }
    }
    if (chosen.count == 0) break;
    chosen.fill();
    Brackets brackets;
    for (std::size_t i = 0; i < chosen.count; i += Lanes::kCount) {
      look_at_parts(p, order, &chosen.number[i], std::min(Lanes::kCount, chosen.count - i), search, brackets);
    }
    solve(p, order, brackets, root);
    std::uint64_t solved = 0;
    for (std::size_t i = 0; i < brackets.of.count; ++i) solved |= std::uint64_t{1} << brackets.of.number[i];
    found |= solved;
    open &= ~solved;
  }
  return found;
}

void find_few_roots(const PolynomialColumns& p, std::uint64_t who, RootColumns::Search& search) {
  search.has_first = 0;
  search.has_second = 0;
  for (std::size_t i = 0; i < kRaysAtOnce; i += Lanes::kCount) {
    const std::uint64_t of_vector = who >> i & kAllLanes;
    if (of_vector == 0) continue;
    Lanes c[3] = {Lanes(0.0), Lanes(0.0), Lanes(0.0)};
    for (std::size_t k = 0; k <= p.order; ++k) c[k] = load<Lanes>(p.c[k], i);
    const FewRoots<Lanes> roots = few_roots(c, load<Lanes>(p.low, i), load<Lanes>(p.high, i));
    store(roots.first, search.first, i);
    store(roots.second, search.second, i);
    search.has_first |= (bits(roots.has_first) & of_vector) << i;
    search.has_second |= (bits(roots.has_second) & of_vector) << i;
  }
}

std::uint64_t find_next_roots(const PolynomialColumns& p, RootColumns::Search& search, std::uint64_t who,
                              Column<double>& root) {
  switch (p.order) {
    case 3:
      return next_roots(p, std::integral_constant<std::size_t, 3>(), search, who, root);
    case 4:
      return next_roots(p, std::integral_constant<std::size_t, 4>(), search, who, root);
    case 6:
      return next_roots(p, std::integral_constant<std::size_t, 6>(), search, who, root);
    default:
      return next_roots(p, p.order, search, who, root);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace firstlight::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace firstlight::render {

HWY_EXPORT(find_few_roots);
HWY_EXPORT(find_next_roots);

bool PolynomialRoots::next_of_few(double& root) {
  using namespace HWY_NAMESPACE;
  if (halvings_left_ == kMostHalvings) {
    One c[3] = {0.0, 0.0, 0.0};
    std::copy(c_.begin(), c_.end(), c);
    const FewRoots<One> roots = few_roots(c, One(waiting_[0].begin), One(waiting_[0].end));
    halvings_left_ = 0;
    waiting_count_ = 0;
    if (roots.has_second.holds) waiting_[waiting_count_++].begin = roots.second.v;
    if (roots.has_first.holds) waiting_[waiting_count_++].begin = roots.first.v;
  }
  if (waiting_count_ == 0) return false;
  root = waiting_[--waiting_count_].begin;
  return true;
}

template <class Order>
bool PolynomialRoots::next(Order order, double& root) {
  using namespace HWY_NAMESPACE;
  One c[kCoefficients<Order>];
  for (std::size_t i = 0; i <= order; ++i) c[i] = c_[i];
  while (waiting_count_ > 0) {
    CurvePart here = waiting_[--waiting_count_];
    const One begin = here.begin;
    const One end = here.end;
    const One width = end - begin;
    One b[kCoefficients<Order>];
    find_bernstein(c, order, begin, width, b);
    const bool is_whole = halvings_left_ == kMostHalvings;
    if (is_whole) {
      here.at_begin = b[0].v;
      here.at_end = value(c, order, end).v;
    }
    b[0] = here.at_begin;
    b[order] = here.at_end;
    const SignChanges<One> changes = sign_changes(b, order);
    const bool is_below_at_begin = here.at_begin < 0.0;
    const auto solve = [&](One from) {
      root = bracketed_root(c, order, begin, end, OneMask{is_below_at_begin}, from, OneMask{true}).v;
      return true;
    };
    if (changes.once.holds) return solve(begin + width * changes.crossing);
    if (!changes.often.holds) continue;
    const One middle = 0.5 * (begin + end);
    if (halvings_left_ == 0 || is_narrow(begin, end).holds) {
      if (is_below_at_begin == (here.at_end < 0.0)) continue;
      return solve(middle);
    }
    if constexpr (std::is_same_v<Order, std::integral_constant<std::size_t, 4>>) {
      if (is_whole && has_no_real_root(c).holds) return false;
    }
    --halvings_left_;
    const double at_middle = value(c, order, middle).v;
    waiting_[waiting_count_++] = {middle.v, here.end, at_middle, here.at_end};
    waiting_[waiting_count_++] = {here.begin, middle.v, here.at_begin, at_middle};
  }
  return false;
}

bool PolynomialRoots::next(double& root) {
  if (waiting_count_ == 0) return false;
  switch (c_.size() - 1) {
    case 1:
    case 2:
      return next_of_few(root);
    case 3:
      return next(std::integral_constant<std::size_t, 3>(), root);
    case 4:
      return next(std::integral_constant<std::size_t, 4>(), root);
    case 6:
      return next(std::integral_constant<std::size_t, 6>(), root);
    default:
      return next(c_.size() - 1, root);
  }
}

RootColumns::Search& RootColumns::of_thread() {
  thread_local const std::unique_ptr<Search> search(new Search);
  return *search;
}

RootColumns::RootColumns(const PolynomialColumns& polynomials, std::uint64_t who)
    : polynomials_(&polynomials), search_(&of_thread()) {
  if (polynomials.order <= 2) {
    HWY_DYNAMIC_DISPATCH(find_few_roots)(polynomials, who, *search_);
    return;
  }
  for (; who != 0; who &= who - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctzll(who));
    search_->waiting[i][0] = {polynomials.low[i], polynomials.high[i], 0.0, 0.0};
    search_->waiting_count[i] = 1;
    search_->halvings_left[i] = PolynomialRoots::kMostHalvings;
  }
}

std::uint64_t RootColumns::next(std::uint64_t who, Column<double>& root) {
  if (polynomials_->order <= 2) return next_of_few(who, root);
  return HWY_DYNAMIC_DISPATCH(find_next_roots)(*polynomials_, *search_, who, root);
}

std::uint64_t RootColumns::next_of_few(std::uint64_t who, Column<double>& root) {
  const std::uint64_t found = who & (search_->has_first | search_->has_second);
  for (std::uint64_t left = found; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctzll(left));
    const bool is_first = (search_->has_first >> i & 1U) != 0;
    root[i] = is_first ? search_->first[i] : search_->second[i];
    (is_first ? search_->has_first : search_->has_second) &= ~(std::uint64_t{1} << i);
  }
  return found;
}

double root_bound(std::span<const double> c) {
  One numbers[kMostOrder + 1];
  std::copy(c.begin(), c.end(), numbers);
  return HWY_NAMESPACE::root_bound(numbers, c.size() - 1).v;
}

}  // namespace firstlight::render
#endif
