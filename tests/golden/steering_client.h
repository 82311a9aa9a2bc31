#pragma once

#include <chrono>
#include <filesystem>
#include <string>

namespace firstlight::golden {

/// A program that steers a picture over its socket.
class SteeringClient {
 public:
  /// Waits until somebody listens at `socket`; connected() says whether that was in time.
  SteeringClient(const std::filesystem::path& socket, std::chrono::seconds limit);
  SteeringClient(const SteeringClient&) = delete;
  SteeringClient& operator=(const SteeringClient&) = delete;
  ~SteeringClient();

  bool connected() const { return descriptor_ >= 0; }
  /// The answer to a line; empty when the rendering has ended.
  std::string ask(const std::string& line);

 private:
  int descriptor_ = -1;
};

}  // namespace firstlight::golden
