// Progress of reading a scene: the caller is told now and then, and may stop it.
#include "parser/directive/interpreter.h"

#include <algorithm>

namespace firstlight::parser {

void Interpreter::look_around() {
  using namespace std::chrono_literals;
  const Frame& text = frame();
  const Token token = (*text.file)[std::min(text.position, text.end)];
  if (options().stop != nullptr && options().stop->load(std::memory_order_relaxed)) {
    // To unwind from here may take longer than the caller waits, and the files must not be left half written.
    data_files_.discard_all();
    fail_finally(token.location, "reading the scene was stopped here");
  }
  if (!options().progress) return;
  const Clock::time_point now = Clock::now();
  if (now - began_ < 1s || now - last_told_ < 200ms) return;
  last_told_ = now;
  options().progress({text.file->source().name, token.location.line, taken(), context_.size});
}

}  // namespace firstlight::parser
