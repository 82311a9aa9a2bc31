#include "app/options.h"

#include "app/pov_options.h"
#include "priority/schemes.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <numeric>

namespace firstlight::app {
namespace {

constexpr int kMostThreads = 512;

struct LongOptions {
  LongOptions(Options& options, bool& version) {
    app.set_help_flag("--help", "Show this help and leave");
    app.add_flag("--version", version, "Show the version and leave");
    app.add_option("--threads", options.threads, "Threads that trace; all processors if not given")
        ->check(CLI::Range(1, kMostThreads))
        ->type_name("N");
    app.add_option("--scheme", options.scheme, "The order of the rays (see below)")->type_name("NAME");
    app.add_option("--stats", options.stats_file, "Write times, rays and queue sizes as JSON")->type_name("FILE");
    app.add_option("--snapshots", options.snapshots_folder, "Write intermediate pictures to a folder")
        ->type_name("DIR");
    app.add_option("--front-end", options.front_end, "Read the scene with a loadable module")->type_name("FILE");
    app.add_flag("--quiet", options.quiet, "Show errors only");
  }

  CLI::App app{"Renders a POV-Ray scene, the rays that matter most first.", "firstlight"};
};

std::vector<std::string> long_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

void check(CommandLine& line) {
  const Options& options = line.options;
  if (options.scene.empty()) line.errors.emplace_back("no scene given; usage: firstlight SCENE.pov [options]");
  if (priority::find_scheme(options.scheme) == nullptr) {
    line.errors.push_back(
        fmt::format("--scheme {}: there is no such scheme; known are {}", options.scheme, priority::scheme_names()));
  }
  if (extension_of(options.file_type).empty()) {
    line.errors.push_back(
        fmt::format("+F{}: there is no such file type; known are N (PNG), T (TGA), P (PPM), B (BMP), J (JPEG), E "
                    "(OpenEXR), H (Radiance)",
                    options.file_type));
  } else if (options.bits != 0 && (options.bits < 5 || options.bits > 16)) {
    line.errors.push_back(fmt::format("+F{}{}: bits per channel are 5 to 16", options.file_type, options.bits));
  } else if (options.bits > 8 && options.file_type == 'N') {
    line.errors.push_back(fmt::format("+FN{}: PNG files are written with 8 bits per channel", options.bits));
  }
  if (options.output == "-") line.errors.emplace_back("+O-: the picture cannot be written to the standard output");
  if (options.threads > kMostThreads) line.errors.push_back(fmt::format("more than {} threads", kMostThreads));
  // A sample's number has 32 bits.
  const auto samples = static_cast<std::int64_t>(options.width) * options.height;
  if (samples > std::numeric_limits<std::uint32_t>::max()) {
    line.errors.push_back(fmt::format("a picture of {} x {} pixels is too large", options.width, options.height));
  }
}

}  // namespace

CommandLine parse_command_line(std::span<const std::string> arguments) {
  CommandLine line;
  bool version = false;
  LongOptions long_options(line.options, version);
  PovOptions pov(line);
  std::vector<std::string> long_words;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    if (!word.starts_with("--")) {
      pov.read_word(word);
      continue;
    }
    const std::string name = word.substr(0, word.find('='));
    const CLI::Option* const option = long_options.app.get_option_no_throw(name);
    if (option == nullptr) {
      const std::string near = nearest(name, long_names(long_options.app));
      line.errors.push_back(
          fmt::format("unknown option '{}'{}", word,
                      near.empty() ? std::string("; --help lists all") : "; the nearest known one is " + near));
      continue;
    }
    long_words.push_back(word);
    if (option->get_items_expected_min() > 0 && name == word) {
      if (i + 1 == arguments.size()) {
        line.errors.push_back(fmt::format("option '{}': expected a value after it", word));
        return line;
      }
      long_words.back() += "=" + arguments[++i];
    }
  }
  pov.finish();
  try {
    std::ranges::reverse(long_words);  // as CLI11 wants them
    long_options.app.parse(std::move(long_words));
  } catch (const CLI::CallForHelp&) {
    line.wish = CommandLine::Wish::help;
    line.errors.clear();
    return line;
  } catch (const CLI::ParseError& error) {
    line.errors.emplace_back(error.what());
  }
  if (version) {
    line.wish = CommandLine::Wish::version;
    line.errors.clear();
    return line;
  }
  if (line.errors.empty()) check(line);
  return line;
}

std::string help_text() {
  Options options;
  bool version = false;
  std::string text = "Usage: firstlight SCENE.pov [switches] [options]\n\n";
  text +=
      "Renders a POV-Ray scene, the rays that matter most first, to an image file.\n\n"
      "POV-Ray's switches (no space between a switch and its value):\n"
      "  +ISCENE       the scene, also without +I\n"
      "  +OFILE        the picture; ending in a slash, its folder. Default: the scene's name in the current folder\n"
      "  +Wn +Hn       width and height in pixels; default 320 and 240\n"
      "  +LDIR         a folder to search for included files; may be repeated\n"
      "  +WTn          threads, as --threads\n"
      "  +FN           file type: N PNG, T TGA, P PPM, B BMP, J JPEG, E OpenEXR, H Radiance; -F writes no picture\n"
      "  +Kn           the scene's clock\n"
      "  declare=A=1   sets an identifier before the scene is read\n"
      "Also the long names of .ini files, such as Width=640. Switches that cannot change the picture, such as -D, -J\n"
      "and +V, are accepted and have no effect; +A and others that would are refused.\n\nOptions:\n";
  const LongOptions long_options(options, version);
  const CLI::App& app = long_options.app;
  for (const CLI::Option* option : app.get_options()) {
    const std::string left =
        option->get_name() + (option->get_items_expected_min() > 0 ? " " + option->get_type_name() : "");
    text += fmt::format("  {:<20}  {}\n", left, option->get_description());
  }
  text += "\nSchemes:\n";
  for (const priority::SchemeRow& row : priority::schemes()) {
    text += fmt::format("  {:<20}  {}{}\n", row.name, row.meaning,
                        row.name == priority::kDefaultScheme ? " (default)" : "");
  }
  return text;
}

std::string nearest(const std::string& word, const std::vector<std::string>& known) {
  std::string best;
  std::size_t fewest = std::max<std::size_t>(1, (word.size() + 1) / 3) + 1;
  for (const std::string& candidate : known) {
    // Edit distance, one row at a time.
    std::vector<std::size_t> row(candidate.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= word.size(); ++i) {
      std::size_t diagonal = row[0];
      row[0] = i;
      for (std::size_t j = 1; j <= candidate.size(); ++j) {
        const std::size_t replaced = diagonal + (word[i - 1] == candidate[j - 1] ? 0 : 1);
        diagonal = row[j];
        row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
      }
    }
    if (row.back() < fewest) {
      fewest = row.back();
      best = candidate;
    }
  }
  return best;
}

std::string_view extension_of(char file_type) {
  switch (file_type) {
    case 'N':
      return ".png";
    case 'C':
    case 'T':
      return ".tga";
    case 'P':
      return ".ppm";
    case 'B':
      return ".bmp";
    case 'J':
      return ".jpg";
    case 'E':
      return ".exr";
    case 'H':
      return ".hdr";
    default:
      return {};
  }
}

std::string picture_path(const Options& options) {
  namespace fs = std::filesystem;
  const std::string wanted(extension_of(options.file_type));
  if (options.output.empty() || options.output.ends_with('/')) {
    return options.output + fs::path(options.scene).stem().string() + wanted;
  }
  std::string extension = fs::path(options.output).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension == wanted ? options.output : options.output + wanted;
}

}  // namespace firstlight::app
