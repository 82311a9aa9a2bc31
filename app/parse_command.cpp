#include "app/parse_command.h"

#include "app/exit_code.h"
#include "app/progress.h"
#include "app/session.h"
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
  ProgressLine line(options.quiet);
  Session session(options, line, stop);
  if (!session.error().empty()) return fail(session.error());
  const bool is_loaded = session.load();
  line.clear();
  if (!is_loaded) return session.exit_code();
  const int code =
      print(options.json ? to_json(options.scene, session.summary()) : to_text(options.scene, session.summary()));
  // To take a scene of many objects apart needs a good part of the time that reading it does, and the process is at its
  // end.
  std::_Exit(code);
}

}  // namespace firstlight::app
