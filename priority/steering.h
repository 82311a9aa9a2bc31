#pragma once

#include "priority/order.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace firstlight::priority {

/// A user's requests to a picture in progress. None of it changes the finished picture.
///
/// Threads  Asked from any thread: a terminal, a socket, a test. The workers look at version() once a block, and put
///          the waiting rays in their new order side by side with tracing.
class Steering {
 public:
  explicit Steering(Order order) : input_(order.input()), order_(std::move(order)) {}

  // ---- For the user's side
  /// Changes the scheme or mixture, keeping the boosts. Empty, or what is wrong with `text` (then nothing changes).
  std::string set_scheme(std::string_view text);
  /// Adds a boost, or replaces the one of the same name. Empty, or what is wrong.
  std::string boost(const Boost& boost);
  /// Returns false when there was none of that name.
  bool drop(std::string_view boost_name);
  void drop_all();
  void pause();
  void resume();
  /// Ends the tracing; what is on the film stays.
  void stop();
  /// Asks for a picture as it is now.
  void save();

  /// As it stands now.
  Order order() const;
  bool paused() const { return paused_.load(std::memory_order_relaxed); }
  bool stopped() const { return stopped_.load(std::memory_order_relaxed); }

  // ---- For the engine's side
  /// Grows with every change of the order.
  std::uint64_t version() const { return version_.load(std::memory_order_acquire); }
  std::shared_ptr<const Scheme> scheme() const;
  /// True once after each save().
  bool take_save_request() { return save_.exchange(false); }
  /// Returns when not paused, or stopped.
  void wait_while_paused();

 private:
  const SchemeInput input_;
  mutable std::mutex mutex_;
  std::condition_variable resumed_;
  Order order_;
  std::atomic<std::uint64_t> version_ = 1;
  std::atomic<bool> paused_ = false;
  std::atomic<bool> stopped_ = false;
  std::atomic<bool> save_ = false;
};

}  // namespace firstlight::priority
