#include "app/parse_command.h"

#include "app/front_ends.h"
#include "app/load_scene.h"
#include "app/output.h"
#include "app/progress.h"
#include "app/render_command.h"
#include "render/scene/escaped.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdlib>

namespace firstlight::app {

namespace {

std::string to_text(const std::string& scene, const render::SceneSummary& summary) {
  std::string text =
      fmt::format("{}: {} objects, {} lights, {} textures\n", scene, summary.objects, summary.lights, summary.textures);
  for (const render::Diagnostic& missing : summary.unrendered) {
    text += fmt::format("{}:{}:{}: {}\n", missing.file, missing.line, missing.column, missing.message);
  }
  return render::escaped_lines(text);  // paths may hold anything
}

}  // namespace

std::string to_json(const std::string& scene, const render::SceneSummary& summary) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["scene"] = scene;
  json["objects"] = summary.objects;
  json["lights"] = summary.lights;
  json["textures"] = summary.textures;
  json["keywords"] = Json::object();
  for (const auto& [word, count] : summary.keywords) json["keywords"][word] = count;
  json["unrendered"] = Json::array();
  for (const render::Diagnostic& missing : summary.unrendered) {
    json["unrendered"].push_back(
        {{"feature", missing.subject}, {"file", missing.file}, {"line", missing.line}, {"column", missing.column}});
  }
  // A path that is not UTF-8 must not cost the rest.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

int parse_command(const Options& options, const std::atomic<bool>& stop) {
  const ChosenFrontEnd front_end(options.front_end);
  if (!front_end.error().empty()) {
    say_error(front_end.error());
    return kExitFailure;
  }
  ProgressLine line(options.quiet);
  line.stage("reading the scene");
  const render::LoadResult loaded = load_scene(options, *front_end, line, &stop);
  line.clear();
  if (loaded.scene == nullptr) return stop ? kExitInterrupted : kExitFailure;
  const std::string text =
      options.json ? to_json(options.scene, loaded.summary) : to_text(options.scene, loaded.summary);
  const std::string problem = print_result(text);
  if (!problem.empty()) say_error(problem);
  // To take a scene of many objects apart needs a good part of the time that reading it does, and the process is at its
  // end.
  std::_Exit(problem.empty() ? EXIT_SUCCESS : kExitFailure);
}

}  // namespace firstlight::app
