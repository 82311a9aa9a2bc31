// libFuzzer's entry: every input is the text of a scene. The parser must come to an end with a scene or with messages,
// whatever the text is.

#include "parser/parser.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>

namespace {

using namespace std::chrono_literals;

/// Asks the parser to stop when a scene takes long: an endless loop is a scene like any other, but here it costs time.
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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr const char* kScene = "scene.pov";
  std::FILE* const file = std::fopen(kScene, "wb");
  if (file == nullptr || std::fwrite(data, 1, size, file) != size || std::fclose(file) != 0) std::abort();

  const Alarm alarm(200ms);
  firstlight::render::LoadOptions options;
  options.parse_only = true;
  options.stop = &alarm.rings();
  const firstlight::render::LoadResult result = firstlight::parser::PovFrontEnd().load(kScene, options);
  bool has_error = false;
  for (const auto& diagnostic : result.diagnostics) {
    has_error |= diagnostic.severity == firstlight::render::Diagnostic::Severity::error;
  }
  if (has_error != (result.scene == nullptr)) std::abort();  // exactly one of the two
  return 0;
}
