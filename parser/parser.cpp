#include "parser/parser.h"

#include "parser/directive/interpreter.h"
#include "parser/directive/reader.h"
#include "parser/statement/statements.h"

#include <exception>

namespace firstlight::parser {

namespace {

// Adds messages that end the parse; those that came before are in `diagnostics` already.
void add(render::Diagnostics& diagnostics, const render::LoadOptions& options, render::Diagnostics messages) {
  for (render::Diagnostic& message : messages) {
    if (options.report) options.report(message);
    diagnostics.push_back(std::move(message));
  }
}

render::SceneSummary summarize(const render::Scene& scene, const Interpreter& interpreter) {
  render::SceneSummary summary;
  summary.objects = scene.solids.size();
  summary.lights = scene.lights.size();
  summary.textures = scene.textures.size();
  summary.keywords = interpreter.keyword_counts();
  for (const render::FeatureUse& use : scene.unrendered.list()) {
    summary.unrendered.push_back(interpreter.describe_unrendered(use));
  }
  return summary;
}

}  // namespace

render::LoadResult PovFrontEnd::load(const std::string& path, const render::LoadOptions& options) const {
  render::LoadResult result;
  render::Diagnostic failure;
  failure.file = path;
  try {
    render::SceneBuilder builder;
    builder.set_bounding(options.bounding);
    builder.settings().quality = options.quality;
    SceneContext context(builder);
    Interpreter interpreter(options, result.diagnostics, context);
    Reader reader(interpreter);
    interpreter.open_scene(path);
    parse_scene(reader, context);
    if (interpreter.recovery().has_failed()) return result;
    interpreter.finish();
    std::unique_ptr<const render::Scene> scene = builder.build();
    result.summary = summarize(*scene, interpreter);
    if (!options.parse_only && !scene->unrendered.empty()) {
      add(result.diagnostics, options, result.summary.unrendered);
    } else {
      result.scene = std::move(scene);
    }
    return result;
  } catch (const SyntaxError& error) {
    add(result.diagnostics, options, error.diagnostics);
  } catch (const std::bad_alloc&) {
    failure.message = "there is not enough memory for this scene";
    add(result.diagnostics, options, {failure});
  } catch (const std::exception& error) {
    failure.message = std::string("the scene cannot be read: ") + error.what();
    add(result.diagnostics, options, {failure});
  }
  return result;
}

}  // namespace firstlight::parser
