// libFuzzer's entry: every input is the text of a scene. The parser must come to an end with a scene or with messages,
// whatever the text is.

#include "tests/fuzz/alarm.h"
#include "tests/fuzz/read_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const firstlight::fuzz::Alarm alarm(std::chrono::milliseconds(200));
  firstlight::render::LoadOptions options;
  options.parse_only = true;
  options.stop = &alarm.rings();
  firstlight::fuzz::read_scene(data, size, options);
  return 0;
}
