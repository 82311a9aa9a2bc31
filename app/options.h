#pragma once

#include "render/film/antialias_settings.h"
#include "render/image/dither.h"
#include "render/scene/bounding_rules.h"
#include "render/scene/nearest.h"
#include "render/scene/quality.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace firstlight::app {

/// The user's wishes. Defaults are POV-Ray's own without an .ini file.
struct Options {
  std::string scene;
  std::string output;  ///< as given with +O; empty: the scene's name in the current folder
  int width = 320;     ///< pixels
  int height = 240;
  int threads = 0;  ///< 0: one for each processor
  bool write_picture = true;
  char file_type = 'N';  ///< POV-Ray's letter, upper case
  int bits = 8;          ///< per channel, where the file type lets one choose: 5 to 16
  bool grey = false;     ///< shades of grey instead of colours
  bool alpha = false;    ///< a channel for what does not show through
  int compression = 0;   ///< of JPEG files, their quality: 2 to 100; else the usual one
  render::Dithering dithering = render::Dithering::none;
  double file_gamma = 0.0;  ///< numbers in the file are light ^ (1 / file_gamma); 0: on the sRGB curve
  std::vector<std::string> library_paths;
  std::vector<std::pair<std::string, std::string>> declares;  ///< name, number
  double clock = 0.0;
  render::BoundingRules bounding;
  render::Quality quality;
  std::optional<render::AntialiasSettings> antialias;  ///< none: one sample a pixel

  std::string scheme = "contribution";        ///< a scheme or a mixture, as priority::Order::parse reads it
  std::vector<std::string> boosts;            ///< as parse_boost reads them
  std::size_t queue_memory = 0;               ///< bytes; 0: a share of the machine's memory
  double stop_at_error = 0.0;                 ///< 0: never
  double stop_after = 0.0;                    ///< seconds; 0: never
  std::string steer;                          ///< path of a socket, "-" for the standard input; empty: none
  std::string stats_file;                     ///< empty: none
  std::string snapshots_folder;               ///< empty: none
  std::vector<std::string> permission_files;  ///< povray.conf's syntax; none: what a plain installation permits
  std::string front_end;                      ///< loadable module that reads the scene; empty: our own
  bool quiet = false;
  bool parse_only = false;  ///< read the scene, say what it is made of, and leave
  bool json = false;        ///< of parse_only: say it as JSON
};

struct CommandLine {
  enum class Wish { render, help, version };

  Wish wish = Wish::render;
  Options options;
  std::vector<std::string> warnings;
  std::vector<std::string> errors;  ///< when not empty, nothing else counts
};

constexpr int kMostThreads = 512;

/// Reads the arguments after the program's name: POV-Ray's switches in any order, our own long options, and the names
/// of .ini files that hold more of both.
CommandLine parse_command_line(std::span<const std::string> arguments);

std::string help_text();

using render::nearest;

/// How many bits per channel files of a type have; 0 where one may choose from 5 to 16.
int fixed_bits_of(char file_type);

/// Extension, with its dot, of the files of a type given by POV-Ray's letter; empty when there is no such type.
std::string_view extension_of(char file_type);

/// The file that the picture is written to. As POV-Ray names it: the type's extension is appended unless it is there
/// already, and an output name that ends in a slash is a folder.
std::string picture_path(const Options& options);

}  // namespace firstlight::app
