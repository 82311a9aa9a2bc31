#include "priority/steering.h"

#include <utility>

namespace firstlight::priority {

std::string Steering::set_scheme(std::string_view text) {
  // Parsed without the lock: the workers ask for the order meanwhile.
  std::string error;
  const std::optional<Order> parsed = Order::parse(text, input_, error);
  if (!parsed) return error;
  const std::lock_guard lock(mutex_);
  if ((parsed->scheme() == nullptr) != (order_.scheme() == nullptr)) {
    return "there is no way from or to 'recursive' while it renders: that order has no queue";
  }
  order_ = parsed->with_boosts_of(order_);
  version_.fetch_add(1, std::memory_order_release);
  return {};
}

std::string Steering::boost(const Boost& boost) {
  const std::lock_guard lock(mutex_);
  std::string problem = order_.add(boost);
  if (problem.empty()) version_.fetch_add(1, std::memory_order_release);
  return problem;
}

bool Steering::drop(std::string_view boost_name) {
  const std::lock_guard lock(mutex_);
  if (!order_.drop(boost_name)) return false;
  version_.fetch_add(1, std::memory_order_release);
  return true;
}

void Steering::drop_all() {
  const std::lock_guard lock(mutex_);
  if (order_.boosts().empty()) return;
  order_.drop_all();
  version_.fetch_add(1, std::memory_order_release);
}

void Steering::pause() {
  const std::lock_guard lock(mutex_);
  paused_.store(true, std::memory_order_relaxed);
}

void Steering::resume() {
  {
    const std::lock_guard lock(mutex_);
    paused_.store(false, std::memory_order_relaxed);
  }
  resumed_.notify_all();
}

void Steering::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopped_.store(true, std::memory_order_relaxed);
  }
  resumed_.notify_all();
}

void Steering::save() { save_.store(true); }

Order Steering::order() const {
  const std::lock_guard lock(mutex_);
  return order_;
}

std::shared_ptr<const Scheme> Steering::scheme() const {
  const std::lock_guard lock(mutex_);
  return order_.scheme();
}

void Steering::wait_while_paused() {
  std::unique_lock lock(mutex_);
  resumed_.wait(lock, [this] { return !paused() || stopped(); });
}

}  // namespace firstlight::priority
