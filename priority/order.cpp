#include "priority/order.h"

#include "priority/boosted.h"
#include "priority/object_names.h"
#include "priority/schemes.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace firstlight::priority {

Order::Order(std::string text, SchemeInput input, std::shared_ptr<const Scheme> base)
    : text_(std::move(text)), input_(std::move(input)), base_(std::move(base)), scheme_(base_) {}

std::optional<Order> Order::parse(std::string_view text, const SchemeInput& input, std::string& error) {
  try {
    return Order(std::string(text), input, parse_scheme(text, input));
  } catch (const SchemeError& problem) {
    error = format(problem, text);
    return std::nullopt;
  }
}

std::string Order::add(const Boost& boost) {
  if (std::string problem = problem_with(boost); !problem.empty()) return problem;
  const auto same = std::ranges::find(boosts_, boost.name, &Boost::name);
  if (same != boosts_.end()) {
    *same = boost;
  } else {
    boosts_.push_back(boost);
  }
  put_boosts_above();
  return {};
}

bool Order::drop(std::string_view boost_name) {
  if (std::erase_if(boosts_, [&](const Boost& boost) { return boost.name == boost_name; }) == 0) return false;
  put_boosts_above();
  return true;
}

void Order::drop_all() {
  boosts_.clear();
  put_boosts_above();
}

Order Order::with_boosts_of(const Order& other) const {
  Order result = *this;
  result.boosts_ = other.boosts_;
  result.put_boosts_above();
  return result;
}

std::string Order::problem_with(const Boost& boost) const {
  constexpr std::size_t kMost = 256;
  if (base_ == nullptr) return fmt::format("the order '{}' has no queue in which rays could be boosted", text_);
  if (boosts_.size() >= kMost) return fmt::format("there are {} boosts already", kMost);
  const render::SceneIndex& scene = input_.scene;
  switch (boost.kind) {
    case Boost::Kind::region: {
      const Rectangle& r = boost.region;
      if (r.left > r.right || r.top > r.bottom) {
        return fmt::format("the rectangle ({}, {}) to ({}, {}) is empty: the upper left pixel comes first", r.left,
                           r.top, r.right, r.bottom);
      }
      if (r.right < 0 || r.bottom < 0 || r.left >= input_.width || r.top >= input_.height) {
        return fmt::format("the rectangle ({}, {}) to ({}, {}) is outside of the picture of {} x {}", r.left, r.top,
                           r.right, r.bottom, input_.width, input_.height);
      }
      break;
    }
    case Boost::Kind::object: {
      const std::vector<std::string_view> names = object_words(scene.objects);
      if (!std::ranges::binary_search(names, boost.object)) {
        return fmt::format("the scene has no object '{}'{}", boost.object, nearest_hint(boost.object, names));
      }
      break;
    }
    case Boost::Kind::light:
      if (boost.light < 0 || static_cast<std::size_t>(boost.light) >= scene.lights.size()) {
        return fmt::format("there is no light {}: the scene has {}, counted from 0", boost.light, scene.lights.size());
      }
      break;
  }
  return {};
}

void Order::put_boosts_above() {
  scheme_ = boosts_.empty() || base_ == nullptr ? base_ : make_boosted(base_, boosts_, input_);
}

}  // namespace firstlight::priority
