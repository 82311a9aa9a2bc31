#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace firstlight::fuzz {

/// Asks for an end when a scene takes long: an endless loop is a scene like any other, but here it costs time.
class Alarm {
 public:
  explicit Alarm(std::chrono::milliseconds after)
      : thread_([this, after](const std::stop_token& token) {
          std::unique_lock lock(mutex_);
          if (!changed_.wait_for(lock, token, after, [] { return false; }) && !token.stop_requested()) rings_ = true;
        }) {}
  const std::atomic<bool>& rings() const { return rings_; }

 private:
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::atomic<bool> rings_ = false;
  std::jthread thread_;
};

}  // namespace firstlight::fuzz
