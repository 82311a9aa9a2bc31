#include "tests/golden/scene_list.h"

#include "app/compare/list.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

namespace firstlight::golden {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kExamplesFolder = "/usr/share/doc/povray/examples";
constexpr std::string_view kExamples[] = {
    "advanced/sombrero.pov",      "advanced/infinitybox.pov",   "advanced/bwstripe.pov", "language/macros/macro1.pov",
    "language/macros/macro2.pov", "language/macros/macro3.pov", "incdemo/colors.pov",
};

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The number at the front of `text`, which is taken off it; nothing when there is none.
template <typename Number>
std::optional<Number> take_number(std::string_view& text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

GoldenScene golden_scene(const std::string& name, const fs::path& file) {
  GoldenScene scene;
  scene.name = test_name(name);
  scene.file = file;
  app::compare::ListedScene wishes;
  app::compare::read_wishes(content_of(file), wishes);
  scene.share = wishes.share.value_or(scene.share);
  scene.psnr = wishes.psnr;
  return scene;
}

std::vector<fs::path> scenes_below(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
    if (entry.path().extension() == ".pov") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

fs::path testscenes() { return fs::path(FIRSTLIGHT_SOURCE_DIR) / "testscenes"; }

std::vector<GoldenScene> golden_scenes() {
  std::vector<GoldenScene> scenes;
  for (const fs::path& file : scenes_below(testscenes())) {
    const fs::path relative = fs::relative(file, testscenes());
    if (*relative.begin() == "errors") continue;
    scenes.push_back(golden_scene(fs::path(relative).replace_extension().string(), file));
  }
  for (const std::string_view example : kExamples) {
    const std::string name = fs::path(example).replace_extension().string();
    scenes.push_back(golden_scene("povray_examples/" + name, fs::path(kExamplesFolder) / example));
  }
  return scenes;
}

std::vector<fs::path> error_scenes() { return scenes_below(testscenes() / "errors"); }

std::vector<ExpectedError> expected_errors(const fs::path& scene) {
  constexpr std::string_view kMark = "// expect error ";
  std::vector<ExpectedError> errors;
  const std::string content = content_of(scene);
  for (std::size_t at = content.find(kMark); at != std::string::npos; at = content.find(kMark, at + 1)) {
    std::string_view rest = std::string_view(content).substr(at + kMark.size());
    rest = rest.substr(0, rest.find_first_of("\r\n"));
    std::string file = scene.filename().string();
    const std::size_t colon = rest.find(':');
    if (colon != std::string_view::npos && rest.substr(0, colon).find('.') != std::string_view::npos) {
      file = rest.substr(0, colon);
      rest.remove_prefix(colon + 1);
    }
    const auto line = take_number<int>(rest);
    if (!line || !rest.starts_with(':')) continue;
    rest.remove_prefix(1);
    const auto column = take_number<int>(rest);
    if (!column || !rest.starts_with(": ")) continue;
    errors.push_back({std::move(file), *line, *column, std::string(rest.substr(2))});
  }
  return errors;
}

std::string test_name(std::string text) {
  for (char& c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return text;
}

std::string program_under_test() {
  const char* chosen = std::getenv("FIRSTLIGHT_PROGRAM");
  return chosen != nullptr ? chosen : FIRSTLIGHT_PROGRAM;
}

}  // namespace firstlight::golden
