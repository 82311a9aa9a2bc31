// Every name that a standard include file declares can be used where its kind belongs: textures on objects, colours in
// pigments, objects as objects.

#include "tests/parser/scene_text.h"

#include <algorithm>
#include <map>
#include <regex>
#include <sstream>
#include <vector>

namespace firstlight::parser {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

std::vector<fs::path> standard_includes() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator("/usr/share/povray-3.7/include")) {
    if (entry.path().extension() == ".inc") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string without_comments(const std::string& text) {
  std::string kept;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.compare(i, 2, "//") == 0) {
      i = std::min(text.find('\n', i), text.size() - 1);
    } else if (text.compare(i, 2, "/*") == 0) {
      i = std::min(text.find("*/", i), text.size() - 2) + 1;
      continue;
    }
    kept += text[i];
  }
  return kept;
}

struct Name {
  std::string name, kind;  ///< the word that its value begins with; for a function its parameters too
};

/// The names that the file declares, each once; those inside macros are among them.
std::vector<Name> names_of(const fs::path& file) {
  static const std::regex declaration(R"(#declare\s+(\w+)\s*=\s*(function\s*\([^)]*\)|function\s*\{\s*\w+|\w+|.))");
  std::map<std::string, std::string> kinds;
  std::vector<Name> names;
  const std::string text = without_comments(text_of(file));
  for (std::sregex_iterator it(text.begin(), text.end(), declaration), end; it != end; ++it) {
    const std::string name = (*it)[1];
    std::string kind = (*it)[2];
    if (const auto known = kinds.find(kind); known != kinds.end()) kind = known->second;
    if (kinds.emplace(name, kind).second) names.push_back({name, kind});
  }
  return names;
}

/// A call of the function `name` with as many numbers as it takes.
std::string call_of(const Name& name) {
  const std::string& kind = name.kind;
  std::size_t count = 3;
  if (const std::size_t open = kind.find('('); open != std::string::npos) {
    count = static_cast<std::size_t>(std::count(kind.begin(), kind.end(), ',')) + 1;
  }
  std::string call = name.name + "(0.5";
  while (--count > 0) call += ", 0.5";
  return call + ")";
}

std::string use_of(const Name& name) {
  static const std::map<std::string, std::string> forms = {
      {"texture", "sphere { 0, 1 texture { @ } }"},
      {"pigment", "sphere { 0, 1 pigment { @ } }"},
      {"normal", "sphere { 0, 1 normal { @ } }"},
      {"finish", "sphere { 0, 1 finish { @ } }"},
      {"material", "sphere { 0, 1 material { @ } }"},
      {"interior", "sphere { 0, 1 interior { @ } }"},
      {"media", "sphere { 0, 1 interior { media { @ } } }"},
      {"density", "sphere { 0, 1 interior { media { density { @ } } } }"},
      {"color_map", "sphere { 0, 1 pigment { gradient x color_map { @ } } }"},
      {"colour_map", "sphere { 0, 1 pigment { gradient x color_map { @ } } }"},
      {"pigment_map", "sphere { 0, 1 pigment { gradient x pigment_map { @ } } }"},
      {"texture_map", "sphere { 0, 1 texture { gradient x texture_map { @ } } }"},
      {"color", "sphere { 0, 1 pigment { color @ } } sphere { 0, 1 pigment { @ } }"},
      {"rgb", "sphere { 0, 1 pigment { color @ } }"},
      {"rgbf", "sphere { 0, 1 pigment { color @ } }"},
      {"rgbt", "sphere { 0, 1 pigment { color @ } }"},
      {"transform", "sphere { 0, 1 transform { @ } }"},
      {"sky_sphere", "sky_sphere { @ }"},
      {"camera", "camera { @ }"},
      {"light_source", "light_source { @ }"},
      {"spline", "#declare Use = @(0.5);"},
      {"seed", "#declare Use = rand(@);"},
      {"array", "#declare Use = @; #debug str(dimension_size(@, 1), 0, 0)"},
      {"\"", "#debug @"},
      {"concat", "#debug @"},
      {"str", "#debug @"},
  };
  static const std::vector<std::string> shapes = {
      "box",        "cone",    "cylinder", "difference",   "disc",   "height_field",   "intersection",
      "isosurface", "merge",   "mesh",     "object",       "plane",  "poly",           "prism",
      "quadric",    "quartic", "cubic",    "sor",          "sphere", "superellipsoid", "text",
      "torus",      "union",   "blob",     "bicubic_patch"};
  std::string form = "#declare Use = @;";  // of a number or a vector, as of any other value
  if (const auto known = forms.find(name.kind); known != forms.end()) form = known->second;
  if (std::find(shapes.begin(), shapes.end(), name.kind) != shapes.end()) form = "object { @ }";
  if (name.kind.starts_with("function")) form = "#declare Use = " + call_of(name) + ";";
  return std::regex_replace(form, std::regex("@"), name.name);
}

std::size_t count_of(const std::string& text, char c) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), c));
}

TEST(IncludeName, EachIsUsedByItsKind) {
  std::size_t used = 0;
  for (const fs::path& file : standard_includes()) {
    std::string scene =
        "#version 3.7; global_settings { assumed_gamma 1 } camera { look_at z }\n"
        "#include \"colors.inc\"\n#include \"shapes.inc\"\n";  // which some of them ask for
    scene += "#include \"" + file.filename().string() + "\"\n#version 3.7;\n#undef Use\n";
    for (const Name& name : names_of(file)) {
      if (name.kind.starts_with("function") && name.kind.find("internal") != std::string::npos) continue;
      scene += "#ifdef (" + name.name + ") " + use_of(name) + " #undef Use #debug \"\\u0001\" #end\n";
    }
    const SceneFile scene_file(scene);
    render::LoadOptions options;
    options.parse_only = true;
    const auto result = PovFrontEnd().load(scene_file.path(), options);
    EXPECT_EQ(errors(result), "") << file;
    used += count_of(messages(result, render::Diagnostic::Severity::debug), '\1');
  }
  EXPECT_GE(used, 1350u);
}

// How many numbers a built-in function takes only its call tells: all are called in the table of expressions.
TEST(IncludeName, BuiltInFunctionsAreComparedWithPovRay) {
  const std::string table = text_of(fs::path(FIRSTLIGHT_SOURCE_DIR) / "tests" / "parser" / "agreement.txt");
  std::size_t found = 0;
  for (const Name& name : names_of("/usr/share/povray-3.7/include/functions.inc")) {
    if (name.kind.find("internal") == std::string::npos) continue;
    EXPECT_NE(table.find("= " + name.name + "("), std::string::npos) << name.name;
    ++found;
  }
  EXPECT_GE(found, 70u);
}

}  // namespace
}  // namespace firstlight::parser
