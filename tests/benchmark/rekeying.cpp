// How long it takes to put waiting rays into another order: renders a scene until enough of them wait, and changes the
// scheme for another.
//
//   rekeying SCENE SIZE THREADS SCHEME SCHEME [ROUNDS]
//
// Prints for each change the records that waited (the feelers of a hit are one) and the milliseconds for a million.
#include "app/study/curve.h"
#include "parser/function_text.h"
#include "parser/parser.h"
#include "priority/driver.h"
#include "priority/order.h"
#include "priority/steering.h"
#include "render/accel/accel.h"
#include "render/scene/scene_index.h"
#include "render/trace/medium_table.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace firstlight;

constexpr std::uint64_t kEnoughRays = 2'000'000;
constexpr std::uint64_t kCheckpointRays = 400'000;

[[noreturn]] void fail(const std::string& why) {
  fmt::print(stderr, "rekeying: {}\n", why);
  std::exit(EXIT_FAILURE);
}

/// Changes the scheme once, when enough rays wait, and stops the picture at the checkpoint after that.
struct Changer final : priority::Observer {
  Changer(priority::Steering& steered, std::string scheme) : steering(steered), other(std::move(scheme)) {}

  void checkpoint(const priority::Progress& progress) override {
    if (changed) steering.stop();
    if (changed || progress.rays_waiting < kEnoughRays) return;
    if (const std::string wrong = steering.set_scheme(other); !wrong.empty()) fail(wrong);
    changed = true;
  }

  priority::Steering& steering;
  std::string other;
  bool changed = false;
};

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() < 5) fail("usage: rekeying SCENE SIZE THREADS SCHEME SCHEME [ROUNDS]");
  render::LoadOptions load;
  load.width = load.height = std::atoi(arguments[1].c_str());
  const int threads = std::atoi(arguments[2].c_str());
  const int rounds = arguments.size() > 5 ? std::atoi(arguments[5].c_str()) : 5;
  if (load.width < 1 || threads < 1 || rounds < 1) fail("SIZE, THREADS and ROUNDS are numbers from 1 on");
  const render::LoadResult loaded = parser::PovFrontEnd().load(arguments[0], load);
  if (loaded.scene == nullptr) fail("cannot read the scene " + arguments[0]);
  const render::Accel accel(*loaded.scene);
  render::Film film(load.width, load.height);
  priority::SchemeInput input;
  input.scene = render::index_of(*loaded.scene);
  input.width = load.width;
  input.height = load.height;
  input.compile = parser::compile_text;
  input.film = &film;

  const auto milliseconds_of_change = [&](const std::string& from, const std::string& to) {
    render::MediumTable media;
    std::string error;
    auto order = priority::Order::parse(from, input, error);
    if (!order) fail(error);
    priority::Steering steering(std::move(*order));
    Changer changer(steering, to);
    priority::TraceOptions options;
    options.steering = &steering;
    options.threads = threads;
    options.observer = &changer;
    options.checkpoint_rays = kCheckpointRays;
    const priority::TraceResult result = priority::trace({*loaded.scene, accel, media}, film, options);
    const auto& rekeying = result.statistics.rekeying;
    if (rekeying.count != 1) fail("too few rays wait; ask for a larger picture");
    const double a_million = 1e9 * rekeying.longest_s / static_cast<double>(rekeying.rays);
    fmt::print("{} to {}: {} records, {:.1f} ms, {:.1f} ms a million\n", from, to, rekeying.rays,
               1e3 * rekeying.longest_s, a_million);
    return a_million;
  };
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round) {
    times.push_back(milliseconds_of_change(arguments[3], arguments[4]));
  }
  fmt::print("median: {:.1f} ms a million\n", app::median(times));
  return EXIT_SUCCESS;
}
