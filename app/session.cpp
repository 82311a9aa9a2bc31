#include "app/session.h"

#include "app/antialias.h"
#include "app/exit_code.h"
#include "app/load_scene.h"
#include "app/picture_file.h"
#include "parser/function_text.h"
#include "render/scene/scene_index.h"
#include "render/trace/medium_table.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace firstlight::app {
namespace {

/// The time that `work` takes.
template <class Work>
double seconds_of(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

Session::Session(const Options& options, ProgressLine& line, const std::atomic<bool>& stop)
    : options_(options), line_(line), stop_(stop), interrupt_(stop), front_end_(options.front_end) {}

bool Session::load() {
  line_.stage("reading the scene");
  parse_seconds_ = seconds_of([&] { loaded_ = load_scene(options_, *front_end_, line_, stop_); });
  if (loaded_.scene == nullptr) return false;
  antialias_ = antialias_of(options_, scene().settings);
  return true;
}

void Session::build(render::Foresight foresight) {
  line_.stage("building the hierarchy");
  build_seconds_ = seconds_of([&] { accel_.emplace(scene(), foresight); });
}

int Session::exit_code() const { return stop_ ? kExitInterrupted : kExitFailure; }

priority::SchemeInput Session::scheme_input(const render::Film* film) const {
  return {render::index_of(scene()), view().width, view().height, parser::compile_text, film};
}

priority::TraceOptions Session::trace_options() const {
  priority::TraceOptions out;
  const int processors = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  out.threads = options_.threads > 0 ? options_.threads : processors;
  out.queue_memory = options_.queue_memory;
  out.antialias = antialias_ ? &*antialias_ : nullptr;
  out.stop = &stop_;
  out.stop_at_error = options_.stop_at_error;
  out.stop_after = options_.stop_after;
  return out;
}

priority::TraceResult Session::trace(render::Film& film, const priority::TraceOptions& options) const {
  render::MediumTable media;
  return priority::trace({scene(), *accel_, media}, film, options);
}

std::string Session::write(const std::string& path, const render::Film& film) const {
  return write_film(path, film, scene().settings,
                    {.numbers = {.bits = options_.bits,
                                 .gamma = options_.file_gamma,
                                 .grey = options_.grey,
                                 .alpha = options_.alpha,
                                 .dithering = options_.dithering},
                     .quality = options_.compression,
                     .runs = options_.file_type == 'C'});
}

}  // namespace firstlight::app
