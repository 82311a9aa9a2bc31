// libFuzzer's entry: every input is the text of a scene, of which a small picture is made twice, in the traditional order
// and by priority. Both must come to an end, and to the same bits.

#include "priority/driver.h"
#include "priority/order.h"
#include "priority/scheme_input.h"
#include "render/accel/accel.h"
#include "render/film/film.h"
#include "render/math/interrupt.h"
#include "render/scene/scene_index.h"
#include "render/trace/medium_table.h"
#include "tests/fuzz/alarm.h"
#include "tests/fuzz/read_scene.h"

#include <cstring>
#include <string>
#include <vector>

namespace firstlight::fuzz {
namespace {

constexpr int kWidth = 16;
constexpr int kHeight = 12;

/// The colours of the picture; empty when `stop` came first.
std::vector<render::Rgb> picture_of(const render::Scene& scene, const render::Accel& accel,
                                    const priority::Scheme* scheme, const std::atomic<bool>& stop) {
  render::MediumTable media;
  render::Film film(kWidth, kHeight);
  priority::TraceOptions options;
  options.scheme = scheme;
  options.stop = &stop;
  if (!priority::trace({scene, accel, media}, film, options).complete()) return {};
  std::vector<render::Rgb> colors;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) colors.push_back(film.color(x, y));
  }
  return colors;
}

void render(const render::Scene& scene, const std::atomic<bool>& stop) {
  const render::Interrupt interrupt(stop);
  const render::Accel accel(scene);
  if (render::Interrupt::seen()) return;
  std::string error;
  const auto order =
      priority::Order::parse("contribution", {.scene = index_of(scene), .width = kWidth, .height = kHeight}, error);
  if (!order) std::abort();
  const auto scheme = order->scheme();
  const std::vector<render::Rgb> by_priority = picture_of(scene, accel, scheme.get(), stop);
  const std::vector<render::Rgb> traditional = picture_of(scene, accel, nullptr, stop);
  if (by_priority.empty() || traditional.empty()) return;
  if (std::memcmp(by_priority.data(), traditional.data(), by_priority.size() * sizeof(render::Rgb)) != 0) std::abort();
}

}  // namespace
}  // namespace firstlight::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const firstlight::fuzz::Alarm alarm(std::chrono::milliseconds(500));
  firstlight::render::LoadOptions options;
  options.width = firstlight::fuzz::kWidth;
  options.height = firstlight::fuzz::kHeight;
  options.stop = &alarm.rings();
  const auto loaded = firstlight::fuzz::read_scene(data, size, options);
  if (loaded.scene != nullptr) firstlight::fuzz::render(*loaded.scene, alarm.rings());
  return 0;
}
