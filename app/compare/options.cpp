#include "app/compare/options.h"

#include "app/ini_file.h"
#include "app/options.h"
#include "app/pov_switches.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <system_error>

namespace firstlight::app::compare {
namespace {

namespace fs = std::filesystem;

constexpr int kMostRounds = 1000;
constexpr int kMostSeconds = 1'000'000;

/// The program's options that say how Firstlight renders, and may stand here; each has a value.
constexpr std::string_view kOurs[] = {"--scheme", "--boost", "--queue-memory", "--permissions", "--front-end"};

std::string absolute(const std::string& path) {
  std::error_code ignored;
  return fs::absolute(path, ignored).lexically_normal().string();
}

class Reader {
 public:
  explicit Reader(CompareCommandLine& line) : line_(line) {}

  void read(std::span<const std::string> arguments) {
    while (!arguments.empty()) {
      const std::string word = arguments[0];
      arguments = arguments.subspan(1);
      if (word.starts_with("--")) {
        read_option(word, arguments);
      } else if (names_ini(word)) {
        if (line_.ini) fail(fmt::format("{}: a second .ini file", word));
        line_.ini = absolute(word);
      } else if (!word.empty() && (word[0] == '+' || word[0] == '-')) {
        read_switch(word);
      } else if (!read_setting(word)) {
        line_.subjects.push_back(word);
      }
    }
  }

 private:
  void fail(std::string message) { line_.errors.push_back(std::move(message)); }

  static bool names_ini(const std::string& word) {
    std::error_code ignored;
    return is_ini_name(word) && (lower(word).find(".ini") != std::string::npos || !fs::exists(word, ignored));
  }

  void read_option(const std::string& word, std::span<const std::string>& rest) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    if (word == "--json") {
      line_.json = true;
    } else if (word == "--quiet") {
      line_.quiet = true;
    } else if (word == "--help") {
      line_.wish = CompareCommandLine::Wish::help;
    } else if (!takes_value(name)) {
      fail(fmt::format("compare: unknown option '{}'; firstlight compare --help lists all", word));
    } else if (equals != std::string::npos) {
      read_value(name, word.substr(equals + 1));
    } else if (rest.empty()) {
      fail(fmt::format("option '{}': expected a value after it", word));
    } else {
      read_value(name, rest[0]);
      rest = rest.subspan(1);
    }
  }

  static bool takes_value(std::string_view name) {
    constexpr std::string_view kOwn[] = {"--size", "--rounds",   "--threads", "--share",     "--psnr",
                                         "--keep", "--psnr-8x8", "--povray",  "--time-limit"};
    return std::ranges::find(kOwn, name) != std::end(kOwn) || std::ranges::find(kOurs, name) != std::end(kOurs);
  }

  void read_value(const std::string& name, const std::string& value) {
    CompareSettings& settings = line_.settings;
    if (name == "--size") {
      const std::size_t cross = value.find('x');
      read_int(name, value.substr(0, cross), 1, kMostPixels, settings.width);
      if (cross == std::string::npos) return fail(fmt::format("--size: expected such as 640x480, found '{}'", value));
      read_int(name, value.substr(cross + 1), 1, kMostPixels, settings.height);
    } else if (name == "--rounds") {
      read_int(name, value, 1, kMostRounds, settings.rounds);
    } else if (name == "--threads") {
      read_int(name, value, 1, kMostThreads, settings.threads);
    } else if (name == "--time-limit") {
      int seconds = 0;
      read_int(name, value, 1, kMostSeconds, seconds);
      settings.time_limit = std::chrono::seconds(seconds);
    } else if (name == "--share") {
      settings.thresholds.share = number(name, value, 100.0);
    } else if (name == "--psnr") {
      settings.thresholds.psnr = number(name, value, kMostDecibels);
    } else if (name == "--psnr-8x8") {
      settings.thresholds.psnr_8x8 = number(name, value, kMostDecibels);
    } else if (name == "--keep") {
      if (value.empty()) return fail("--keep: expected a folder");
      line_.keep = absolute(value);
    } else if (name == "--povray") {
      settings.povray = value.find('/') == std::string::npos ? value : absolute(value);
    } else {
      const bool file = name == "--permissions" || (name == "--front-end" && value.find('/') != std::string::npos);
      settings.our_words.push_back(name + "=" + (file ? absolute(value) : value));
    }
  }

  void read_switch(const std::string& word) {
    const SwitchRow* const row = find_switch(std::string_view(word).substr(1));
    if (row == nullptr) return line_.settings.words.push_back(word);  // refused when all words are looked at
    const std::string parameter = word.substr(1 + row->letters.size());
    CompareSettings& settings = line_.settings;
    switch (row->use) {
      case Use::width:
        return read_int(word, parameter, 1, kMostPixels, settings.width);
      case Use::height:
        return read_int(word, parameter, 1, kMostPixels, settings.height);
      case Use::threads:
        return read_int(word, parameter, 1, kMostThreads, settings.threads);
      case Use::input:
        return line_.subjects.push_back(parameter);
      case Use::library:
        return settings.words.push_back("+L" + absolute(parameter));
      case Use::output:
      case Use::file_type:
      case Use::write_picture:
        return fail(fmt::format("option '{}': both programs write PNG files, which --keep DIR keeps", word));
      default:
        settings.words.push_back(word);
    }
  }

  /// "Width=640". False when it is no setting.
  bool read_setting(const std::string& word) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) return false;
    const std::string name = lower(std::string_view(word).substr(0, equals));
    const Setting* const setting = find_setting(name);
    if (name != "declare" && setting == nullptr) return false;
    constexpr std::string_view kTakenApart[] = {"W", "H", "WT", "I", "L", "O", "F"};
    if (setting != nullptr && std::ranges::find(kTakenApart, setting->letters) != std::end(kTakenApart)) {
      read_switch(fmt::format("+{}{}", setting->letters, word.substr(equals + 1)));
    } else {
      line_.settings.words.push_back(word);
    }
    return true;
  }

  void read_int(const std::string& name, std::string_view text, int least, int most, int& target) {
    const auto value = parse<int>(text);
    if (value && *value >= least && *value <= most) {
      target = *value;
    } else {
      fail(fmt::format("{}: expected a number from {} to {}, found '{}'", name, least, most, text));
    }
  }

  double number(const std::string& name, const std::string& text, double most) {
    const auto value = parse<double>(text);
    if (value && *value >= 0.0 && *value <= most) return *value;
    fail(fmt::format("{}: expected a number from 0 to {}, found '{}'", name, most, text));
    return 0.0;
  }

  static constexpr int kMostPixels = 1 << 20;
  static constexpr double kMostDecibels = 1000.0;

  CompareCommandLine& line_;
};

/// The scene that an .ini file names: as it says, or beside the file.
std::string scene_of(const fs::path& ini) {
  const std::string scene = parse_command_line(std::vector<std::string>{ini.string()}).options.scene;
  std::error_code ignored;
  return scene.empty() || fs::exists(scene, ignored) ? scene : (ini.parent_path() / scene).string();
}

}  // namespace

CompareCommandLine parse_compare_command_line(std::span<const std::string> arguments) {
  CompareCommandLine line;
  Reader(line).read(arguments);
  if (line.wish == CompareCommandLine::Wish::help) {
    line.errors.clear();
    return line;
  }
  // Words for the programs are looked at by the same eyes as words for Firstlight itself.
  std::vector<std::string> words{"scene.pov"};
  words.insert(words.end(), line.settings.words.begin(), line.settings.words.end());
  words.insert(words.end(), line.settings.our_words.begin(), line.settings.our_words.end());
  const CommandLine looked_at = parse_command_line(words);
  line.errors.insert(line.errors.end(), looked_at.errors.begin(), looked_at.errors.end());
  if (line.subjects.empty() && line.ini) {
    if (std::string scene = scene_of(*line.ini); !scene.empty()) line.subjects.push_back(std::move(scene));
  }
  return line;
}

std::string compare_help_text() {
  return fmt::format(
      "Usage: firstlight compare SCENE.pov [FILE.ini] [switches] [options]\n"
      "       firstlight compare A.png B.png [options]\n\n"
      "Renders a scene with POV-Ray and with Firstlight and says how far the pictures are apart and what each program\n"
      "took; or compares two pictures. Docs: docs/compare.md.\n\n"
      "  --size WxH, +Wn +Hn     The size in pixels; default 320x240, or what the .ini file says\n"
      "  --threads N, +WTn       Threads of each program; default 1\n"
      "  --rounds N              Run the programs in turn, so often; medians and ranges are told\n"
      "  --time-limit SECONDS    For one run of a program; default {}\n"
      "  --povray PROGRAM        POV-Ray's program; default povray\n"
      "  --share PERCENT         The pictures agree if so many pixels are within 2/255; default {}\n"
      "  --psnr DB               They agree if their PSNR is so high; with --share both count\n"
      "  --psnr-8x8 DB           Pictures that do not agree only warn if the PSNR of their means of 8x8 pixels is so\n"
      "                          high; default {}\n"
      "  --keep DIR              Keep the pictures, their difference and the FLIP map\n"
      "  --json                  Say it as JSON\n"
      "  --quiet                 No progress\n"
      "POV-Ray's switches that change the picture go to both programs: +A0.3, +AM2, +R3, +J, +L, +K, declare=A=1. For\n"
      "Firstlight alone: --scheme, --boost, --queue-memory, --permissions, --front-end.\n\n"
      "Exit status: 0 the pictures agree, 1 they warn, 2 they differ, 3 they have different sizes, 4 there are not "
      "two\n"
      "pictures: one cannot be read, or a program did not render, or an option is wrong.\n",
      CompareSettings().time_limit.count(), kShare, Thresholds().psnr_8x8);
}

}  // namespace firstlight::app::compare
