#pragma once

#include "parser/directive/interpreter.h"
#include "parser/directive/reader.h"
#include "parser/statement/statements.h"
#include "render/feature/feature.h"
#include "tests/parser/scene_text.h"

#include <optional>
#include <string>
#include <string_view>

namespace firstlight::parser {

/// The result of a text that ends with an object.
struct ParsedObject {
  std::optional<render::Object> object;
  std::string errors;    ///< one a line
  std::string warnings;  ///< the same
};

/// The description of the object that `text` is, in version 3.7.
inline ParsedObject parsed_object(std::string_view text) {
  const SceneFile file("#version 3.7; " + std::string(text) + "\n");
  ParsedObject result;
  render::LoadResult messages;
  render::SceneBuilder builder;
  SceneContext context(builder);
  const render::LoadOptions options;
  Interpreter interpreter(options, messages.diagnostics, context);
  Reader reader(interpreter);
  try {
    interpreter.open_scene(file.path());
    result.object = parse_object(reader, context);
    EXPECT_TRUE(reader.peek().is_end()) << text;
  } catch (const SyntaxError& error) {
    messages.diagnostics.insert(messages.diagnostics.end(), error.diagnostics.begin(), error.diagnostics.end());
  }
  result.errors = errors(messages);
  result.warnings = warnings(messages);
  return result;
}

/// The same of a text without errors and warnings.
inline render::Object object_of(std::string_view text) {
  ParsedObject parsed = parsed_object(text);
  EXPECT_EQ(parsed.errors, "") << text;
  EXPECT_EQ(parsed.warnings, "") << text;
  return parsed.object.value_or(render::Object());
}

/// The scene of `text`, with a camera behind it unless the text has one, which may ask for what cannot be rendered.
inline render::LoadResult described(std::string_view text) {
  const bool has_camera = text.find("camera {") != std::string_view::npos;
  const SceneFile file("#version 3.7; global_settings { assumed_gamma 1 } " + std::string(text) +
                       (has_camera ? "" : "\ncamera { location <0, 0, -5> look_at 0 }"));
  render::LoadOptions options;
  options.parse_only = true;
  return PovFrontEnd().load(file.path(), options);
}

/// The same of a text without errors and warnings.
inline std::unique_ptr<const render::Scene> described_scene(std::string_view text) {
  render::LoadResult result = described(text);
  EXPECT_EQ(errors(result), "") << text;
  EXPECT_EQ(warnings(result), "") << text;
  if (!result.scene) return std::make_unique<const render::Scene>();
  return std::move(result.scene);
}

/// The words that `uses` names, one after the other.
inline std::string spelled(const render::FeatureUses& uses) {
  std::string all;
  for (const render::FeatureUse& use : uses.list()) {
    all += (all.empty() ? "" : " ") + std::string(render::spelling(use.feature));
  }
  return all;
}

}  // namespace firstlight::parser
