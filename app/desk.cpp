#include "app/desk.h"

#include <utility>

namespace firstlight::app {

void Desk::progress(const priority::Progress& progress) {
  const std::lock_guard lock(mutex_);
  latest_ = progress;
}

priority::Progress Desk::latest() const {
  const std::lock_guard lock(mutex_);
  return latest_;
}

void Desk::save(const priority::Progress& progress) {
  this->progress(progress);
  serve();
}

std::string Desk::save_to(const std::string& file) {
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

void Desk::serve() {
  std::vector<std::shared_ptr<Wish>> wishes;
  {
    const std::lock_guard lock(mutex_);
    wishes = std::exchange(wishes_, {});
  }
  for (const auto& wish : wishes) {
    std::string problem = write_(wish->file);
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
