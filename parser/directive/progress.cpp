// What happens now and then while a scene is read: the caller is told, and may stop it.
#include "parser/directive/interpreter.h"

#include <algorithm>

namespace firstlight::parser {

void Interpreter::look_around() {
  using namespace std::chrono_literals;
  const Frame& frame = frames_.back();
  const Token& token = frame.file->tokens[std::min(frame.position, frame.end)];
  if (options_.stop != nullptr && options_.stop->load(std::memory_order_relaxed)) {
    // To unwind from here may take longer than the caller waits, and the files must not be left half written.
    discard_data_files();
    fail_finally(token.location, "reading the scene was stopped here");
  }
  if (!options_.progress) return;
  const Clock::time_point now = Clock::now();
  if (now - began_ < 1s || now - last_told_ < 200ms) return;
  last_told_ = now;
  options_.progress({frame.file->source->name, token.location.line, taken(), context_.size});
}

}  // namespace firstlight::parser
