#include "app/options.h"

#include "app/argument_reader.h"
#include "app/boost_text.h"
#include "app/long_options.h"
#include "app/terminal_keys.h"
#include "priority/schemes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <limits>

namespace firstlight::app {
namespace {

bool is_plain_name(std::string_view text) {
  return std::ranges::all_of(text, [](unsigned char c) { return std::isalpha(c) || c == '-'; });
}

struct FileType {
  char letter;
  std::string_view extension;
  int bits;                  ///< per channel; 0: as many as are asked for
  bool may_be_grey = false;  ///< with 16 bits
};

constexpr FileType kFileTypes[] = {
    {'N', ".png", 0, true}, {'T', ".tga", 8}, {'C', ".tga", 8},  {'P', ".ppm", 0, true},
    {'B', ".bmp", 8},       {'J', ".jpg", 8}, {'E', ".exr", 32}, {'H', ".hdr", 8},
};

const FileType* find_file_type(char letter) {
  const auto* const found = std::ranges::find(kFileTypes, letter, &FileType::letter);
  return found == std::end(kFileTypes) ? nullptr : found;
}

void check(CommandLine& line) {
  const Options& options = line.options;
  if (options.scene.empty()) line.errors.emplace_back("no scene given; usage: firstlight SCENE.pov [options]");
  // Mixtures and schemes with arguments need the scene to be understood; a plain wrong name need not wait for it.
  if (is_plain_name(options.scheme) && priority::find_scheme(options.scheme) == nullptr) {
    line.errors.push_back(
        fmt::format("--scheme {}: there is no such scheme; known are {}", options.scheme, priority::scheme_names()));
  }
  if (const FileType* const type = find_file_type(options.file_type); type == nullptr) {
    line.errors.push_back(
        fmt::format("+F{}: there is no such file type; known are N (PNG), T and C (TGA), P (PPM), B (BMP), J (JPEG), E "
                    "(OpenEXR), H (Radiance)",
                    options.file_type));
  } else if (options.grey && !type->may_be_grey) {
    line.errors.push_back(fmt::format("+F{}: only PNG and PPM files are written in shades of gray", type->letter));
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
  ArgumentReader reader(line);
  reader.read(arguments);
  reader.finish();
  if (line.wish != CommandLine::Wish::render) {
    line.errors.clear();
  } else if (line.errors.empty()) {
    check(line);
  }
  return line;
}

std::string help_text() {
  CommandLine defaults;
  std::string text =
      "Usage: firstlight SCENE.pov [switches] [options]\n"
      "       firstlight SETTINGS.ini[section] ...\n"
      "       firstlight steer SOCKET [command]\n"
      "       firstlight study SCENE.pov [options], see `firstlight study --help`\n"
      "       firstlight compare SCENE.pov [options], see `firstlight compare --help`\n\n"
      "Renders a POV-Ray scene, the rays that matter most first, to an image file.\n\n"
      "POV-Ray's switches (no space between a switch and its value):\n"
      "  +ISCENE       the scene, also without +I\n"
      "  +OFILE        the picture; ending in a slash, its folder. Default: the scene's name in the current folder\n"
      "  +Wn +Hn       width and height in pixels; default 320 and 240\n"
      "  +LDIR         a folder to search for included files; may be repeated\n"
      "  +WTn          threads, as --threads\n"
      "  +FN           file type: N PNG, T TGA, P PPM, B BMP, J JPEG, E OpenEXR, H Radiance; -F writes no picture\n"
      "  +FN16 +FNg    16 bits per channel, shades of gray, for PNG and PPM; Compression=n is the quality of JPEG, 2 "
      "to 100\n"
      "  +UA           an alpha channel, in PNG, TGA, BMP and OpenEXR files\n"
      "  +THFS         dithering, by B2 B3 B4 (Bayer), D1 D2 or FS (error diffusion); +TH means FS\n"
      "  +Kn           the scene's clock\n"
      "  +A0.3 +AM1    anti-aliasing: its threshold, and its method 1 or 2; -A switches it off. With it +R3 (depth),\n"
      "                +J0.5 or -J (jitter), +AG2.5 (gamma), +BS32 (block size); see docs/antialiasing.md\n"
      "  +Q9           quality: 9 all, 8 without fog and matter, 7 nor mirrors and normals, 5 nor what is behind "
      "glass, with\n"
      "                quick colors, 4 with lights as points, 3 without shadows, 1 without lights\n"
      "  -UR +SU       bounded_by counts of single shapes too, and not of unions of finite objects\n"
      "  declare=A=1   sets an identifier before the scene is read\n"
      "Also the long names of .ini files, such as Width=640. Switches that cannot change the picture, such as -D and\n"
      "+V, are accepted and have no effect; others that would are refused. An .ini file may hold all of these, and "
      "the\n"
      "options below as Scheme=, Queue_Memory=, Stop_After= and so on.\n\nOptions:\n";
  text += LongOptions(defaults).help();
  text += "\nSchemes, alone or mixed (docs/schemes.md):\n";
  for (const priority::SchemeRow& row : priority::schemes()) {
    text += fmt::format("  {:<25}  {}{}\n", fmt::format("{}{}", row.name, row.arguments), row.meaning,
                        row.name == priority::kDefaultScheme ? " (default)" : "");
  }
  text += fmt::format("\nBoosts:\n{}", boost_help());
  text += fmt::format("\nWhile it renders, on a terminal:\n{}", keys_help());
  return text;
}

int fixed_bits_of(char file_type) {
  const FileType* const type = find_file_type(file_type);
  return type == nullptr ? 0 : type->bits;
}

std::string_view extension_of(char file_type) {
  const FileType* const type = find_file_type(file_type);
  return type == nullptr ? std::string_view() : type->extension;
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
