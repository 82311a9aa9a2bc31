#include "app/desk.h"

#include <utility>

namespace firstlight::app {

void Desk::publish(const priority::Progress& progress) {
  const std::lock_guard lock(mutex_);
  latest_ = progress;
}

priority::Progress Desk::latest() const {
  const std::lock_guard lock(mutex_);
  return latest_;
}

std::string Desk::save(const std::string& file) {
  auto wish = std::make_shared<Wish>();
  wish->file = file;
  std::unique_lock lock(mutex_);
  if (!closed_) {
    wishes_.push_back(wish);
    steering_.save();
    served_.wait(lock, [&] { return wish->done || closed_; });
  }
  return wish->done ? wish->problem : "the rendering has ended";
}

void Desk::serve(const Write& write) {
  std::vector<std::shared_ptr<Wish>> wishes;
  {
    const std::lock_guard lock(mutex_);
    wishes = std::exchange(wishes_, {});
  }
  for (const auto& wish : wishes) {
    std::string problem = write(wish->file);
    const std::lock_guard lock(mutex_);
    wish->problem = std::move(problem);
    wish->done = true;
  }
  served_.notify_all();
}

void Desk::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  served_.notify_all();
}

}  // namespace firstlight::app
