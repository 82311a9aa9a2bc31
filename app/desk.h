#pragma once

#include "priority/observer.h"
#include "priority/steering.h"

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace firstlight::app {

/// Where those who steer a picture meet the thread that renders it: how far the picture is, and pictures to be saved
/// now.
///
/// Threads  An observer, serve() and close() from the thread that renders; the rest from any.
class Desk final : public priority::Observer {
 public:
  /// Writes a picture to a file, empty standing for the usual one; returns empty, or why it failed.
  using Write = std::function<std::string(const std::string& file)>;
  Desk(priority::Steering& steering, Write write) : steering_(steering), write_(std::move(write)) {}
  ~Desk() override { close(); }

  void progress(const priority::Progress& progress) override;
  void save(const priority::Progress& progress) override;
  priority::Progress latest() const;

  /// Has the picture written as it is, to `file`; empty: where the finished one will be. Returns when that is done:
  /// empty, or why it failed.
  std::string save_to(const std::string& file);

  /// Writes the pictures that were asked for.
  void serve();
  /// There will be no more serve(): all who wait are told so.
  void close();

 private:
  struct Wish {
    std::string file;
    std::string problem;
    bool done = false;
  };

  priority::Steering& steering_;
  const Write write_;
  mutable std::mutex mutex_;
  std::condition_variable served_;
  priority::Progress latest_;
  std::vector<std::shared_ptr<Wish>> wishes_;
  bool closed_ = false;
};

}  // namespace firstlight::app
