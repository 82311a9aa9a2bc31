#include "app/compare/list.h"

#include "app/compare/content.h"
#include "app/ini_file.h"
#include "app/pov_switches.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <system_error>

namespace firstlight::app::compare {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool is_scene_name(const fs::path& path) { return lower(path.extension().string()) == ".pov"; }

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

/// The text behind `mark` in its line; empty when it is nowhere.
std::string_view text_behind(std::string_view text, std::string_view mark) {
  const std::size_t at = text.find(mark);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = text.substr(at + mark.size());
  return trimmed(rest.substr(0, rest.find('\n')));
}

std::optional<double> number_behind(std::string_view text, std::string_view mark) {
  const std::string_view rest = text_behind(text, mark);
  return parse<double>(rest.substr(0, rest.find_first_of(" \t")));
}

/// Below `root`, with its extension dropped.
std::string name_below(const fs::path& root, const fs::path& scene) {
  return scene.lexically_relative(root).replace_extension().generic_string();
}

void add_scene(SceneList& list, const fs::path& root, const fs::path& scene, std::vector<std::string> words) {
  ListedScene listed;
  listed.scene = scene;
  listed.name = name_below(root, scene);
  if (!words.empty()) listed.name += fmt::format(" {}", fmt::join(words, " "));
  for (std::string& word : words) {
    const std::string file = split_ini_name(word).file;
    const bool is_ini = lower(fs::path(file).extension().string()) == ".ini" && !word.starts_with('+');
    if (is_ini) {
      listed.ini = scene.parent_path() / word;
    } else {
      listed.words.push_back(std::move(word));
    }
  }
  read_wishes(read_bytes(scene), listed);
  list.scenes.push_back(std::move(listed));
}

/// Results are known by their names.
void tell_apart(std::vector<ListedScene>& scenes) {
  std::map<std::string, int> seen;
  for (ListedScene& scene : scenes) {
    if (const int before = seen[scene.name]++; before > 0) scene.name += fmt::format(" ({})", before + 1);
  }
}

}  // namespace

void read_wishes(std::string_view scene_text, ListedScene& scene) {
  scene.share = number_behind(scene_text, "// compare: share");
  scene.psnr = number_behind(scene_text, "// compare: psnr");
  const std::string_view ini = text_behind(scene_text, "// compare: ini");
  if (!scene.ini && !ini.empty()) scene.ini = scene.scene.parent_path() / ini;
}

SceneList find_scenes(const fs::path& folder) {
  SceneList list;
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  if (error || !fs::is_directory(root, error)) {
    list.errors.push_back(fmt::format("'{}' is not a folder", folder.string()));
    return list;
  }
  std::vector<fs::path> scenes;
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator at(root, options, error), end; !error && at != end; at.increment(error)) {
    if (is_scene_name(at->path()) && is_file(at->path())) scenes.push_back(at->path());
  }
  if (error) list.errors.push_back(fmt::format("cannot read the folder '{}': {}", folder.string(), error.message()));
  std::ranges::sort(scenes);
  for (const fs::path& scene : scenes) add_scene(list, root, scene, {});
  if (scenes.empty() && !error) list.errors.push_back(fmt::format("there is no .pov file below '{}'", folder.string()));
  return list;
}

SceneList parse_list(std::string_view text, const std::string& label, const fs::path& root) {
  SceneList list;
  std::error_code error;
  const fs::path whole_root = fs::canonical(root, error);
  if (error) {
    list.errors.push_back(fmt::format("'{}' is not a folder", root.string()));
    return list;
  }
  for (IniLine& line : parse_ini(text, "").lines) {
    fs::path scene = (whole_root / line.words.front()).lexically_normal();
    if (!is_file(scene) && !is_scene_name(scene)) scene += ".pov";
    if (!is_file(scene)) {
      list.errors.push_back(fmt::format("{}:{}: there is no scene '{}' below '{}'", label, line.number,
                                        line.words.front(), root.string()));
      continue;
    }
    line.words.erase(line.words.begin());
    add_scene(list, whole_root, scene, std::move(line.words));
    const auto& ini = list.scenes.back().ini;
    if (ini && !is_file(split_ini_name(ini->string()).file)) {
      list.errors.push_back(fmt::format("{}:{}: there is no .ini file '{}'", label, line.number, ini->string()));
    }
  }
  if (list.scenes.empty() && list.errors.empty()) list.errors.push_back(fmt::format("{}: names no scene", label));
  tell_apart(list.scenes);
  return list;
}

SceneList read_list(const fs::path& file, const fs::path& root) {
  if (!is_file(file)) return {{}, {fmt::format("there is no list '{}'", file.string())}};
  const std::string text = read_bytes(file);
  if (text.find('\0') != std::string::npos) return {{}, {fmt::format("{}: this is not a text file", file.string())}};
  return parse_list(text, file.string(), root);
}

}  // namespace firstlight::app::compare
