#pragma once

#include "priority/scheme.h"
#include "priority/scheme_input.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace firstlight::priority {

/// Pixels from (left, top) to (right, bottom), both included, the upper left pixel being (0, 0).
struct Rectangle {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

/// A wish that some rays come before all others, or after them.
struct Boost {
  enum class Kind { region, object, light };

  std::string name = {};  ///< by which it is dropped again
  Kind kind = Kind::region;
  Rectangle region = {};    ///< of Kind::region
  std::string object = {};  ///< of Kind::object: its SDL identifier, or the word for a kind of shape
  int light = 0;            ///< of Kind::light: index into Scene::lights
  int by = 1;               ///< boosts of a ray add up; a larger sum leaves first; may be negative
};

/// The whole order of the rays: a scheme or mixture as the user writes it, and the boosts above it. A cheap value.
class Order {
 public:
  /// On failure the result is empty and `error` says what is wrong, with the place in `text`.
  static std::optional<Order> parse(std::string_view text, const SchemeInput& input, std::string& error);

  /// Adds a boost, or replaces the one of the same name. Empty, or what is wrong: no such object, no such light, an
  /// empty rectangle, an order without a queue.
  std::string add(const Boost& boost);
  bool drop(std::string_view boost_name);
  void drop_all();
  /// This order with the boosts of `other` instead of its own. Pre: the same scene.
  Order with_boosts_of(const Order& other) const;

  const std::string& text() const { return text_; }
  const std::vector<Boost>& boosts() const { return boosts_; }
  const SchemeInput& input() const { return input_; }
  /// Null: `recursive`, the traditional order without a queue.
  std::shared_ptr<const Scheme> scheme() const { return scheme_; }

 private:
  Order(std::string text, SchemeInput input, std::shared_ptr<const Scheme> base);
  std::string problem_with(const Boost& boost) const;
  void put_boosts_above();

  std::string text_;
  SchemeInput input_;
  std::shared_ptr<const Scheme> base_;  ///< without the boosts
  std::vector<Boost> boosts_;
  std::shared_ptr<const Scheme> scheme_;
};

}  // namespace firstlight::priority
