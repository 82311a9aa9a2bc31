// Textures that the standard includes declare look as POV-Ray shows them: each name on a ball of its own, many balls a
// picture, and the pixels around each ball compared by themselves.

#include "tests/golden/picture.h"
#include "tests/golden/run.h"
#include "tests/golden/scene_list.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

namespace firstlight::golden {
namespace {

namespace fs = std::filesystem;

constexpr int kColumns = 8, kRows = 6, kCell = 32;
constexpr std::chrono::seconds kLimit{120};
constexpr double kShare = 0.98;
constexpr double kPsnr = 35;  // between the means of 8x8 pixels, where a finish draws at random

fs::path includes() { return "/usr/share/povray-3.7/include"; }

/// The text without its comments.
std::string code_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  std::string code;
  for (std::size_t at = 0; at < text.size();) {
    if (text.compare(at, 2, "//") == 0) {
      at = std::min(text.find('\n', at), text.size());
    } else if (text.compare(at, 2, "/*") == 0) {
      at = std::min(text.find("*/", at), text.size() - 2) + 2;
    } else {
      code += text[at++];
    }
  }
  return code;
}

struct Declared {
  std::string name;
  std::string kind;  ///< the word that its value begins with
  bool draws;        ///< has `crand`, itself or in what it is made of
};

/// Whether one of the words of `text` is in `names`.
bool names_one_of(const std::set<std::string>& names, const std::string& text) {
  static const std::regex kWord(R"(\w+)");
  return std::any_of(std::sregex_iterator(text.begin(), text.end(), kWord), std::sregex_iterator(),
                     [&](const std::smatch& word) { return names.contains(word.str()); });
}

/// The names of `file` that a ball can wear, in their order. A value that is another name is of that name's kind.
std::vector<Declared> declared_in(const std::string& file) {
  static const std::regex kDeclare(R"(#declare\s+(\w+)\s*=\s*(\w+))");
  static const std::set<std::string> kWorn = {"texture", "material", "pigment",   "finish",
                                              "normal",  "interior", "color_map", "colour_map"};
  const std::string code = code_of(includes() / (file + ".inc"));
  std::vector<Declared> all;
  std::map<std::string, std::string> kinds;
  std::set<std::string> drawing = {"crand"};
  if (file == "stoneold") {  // other names for what is there
    for (const Declared& other : declared_in("stones1"))
      if (other.draws) drawing.insert(other.name);
  }
  for (auto match = std::sregex_iterator(code.begin(), code.end(), kDeclare); match != std::sregex_iterator();
       ++match) {
    Declared declared{(*match)[1], (*match)[2], false};
    const auto begin = static_cast<std::size_t>(match->position(2));
    declared.draws = names_one_of(drawing, code.substr(begin, code.find('#', begin) - begin));
    if (declared.draws) drawing.insert(declared.name);
    if (const auto other = kinds.find(declared.kind); other != kinds.end()) declared.kind = other->second;
    if (!kWorn.contains(declared.kind) || !kinds.emplace(declared.name, declared.kind).second) continue;
    all.push_back(std::move(declared));
  }
  return all;
}

/// The text for a ball that wears `declared`, with the rest made up.
std::string worn(const Declared& declared) {
  const std::string& name = declared.name;
  if (declared.kind == "texture" || declared.kind == "material") return fmt::format("{} {{ {} }}", declared.kind, name);
  if (declared.kind == "pigment") return fmt::format("pigment {{ {} }} finish {{ diffuse 0.8 }}", name);
  if (declared.kind == "finish") return fmt::format("pigment {{ rgb <0.8, 0.6, 0.3> }} finish {{ {} }}", name);
  if (declared.kind == "normal") return fmt::format("pigment {{ rgb <0.8, 0.6, 0.3> }} normal {{ {} }}", name);
  if (declared.kind == "interior")
    return fmt::format("pigment {{ rgbf <0.9, 0.95, 1, 0.9> }} interior {{ {} }} finish {{ reflection 0.1 }}", name);
  return fmt::format("pigment {{ wood turbulence 0.2 color_map {{ {} }} scale 0.4 }}", name);
}

/// Up to kColumns x kRows balls in front of a chequered wall, each in its own square of the picture.
std::string balls(const std::string& file, const std::vector<Declared>& worn_by) {
  std::string text = fmt::format(
      "#version 3.7;\nglobal_settings {{ assumed_gamma 1 max_trace_level 6 }}\n#include \"colors.inc\"\n"
      "#include \"{}.inc\"\ncamera {{ orthographic location -20*z look_at 0 right {}*x up {}*y }}\n"
      "light_source {{ <-30, 40, -50> rgb 1 }}\nbackground {{ rgb <0.3, 0.4, 0.6> }}\n"
      "plane {{ z, 3 pigment {{ checker rgb 0.9, rgb <0.3, 0.4, 0.2> scale 0.7 }} }}\n",
      file, 2 * kColumns, 2 * kRows);
  for (std::size_t i = 0; i < worn_by.size(); ++i) {
    text +=
        fmt::format("sphere {{ 0, 0.94 {} translate <{}, {}, 0> }}\n", worn(worn_by[i]),
                    2 * static_cast<int>(i % kColumns) - kColumns + 1, kRows - 1 - 2 * static_cast<int>(i / kColumns));
  }
  return text;
}

std::optional<Picture> picture_by(const std::string& program, const std::string& scene) {
  const ScratchFolder scratch;
  const fs::path file = scratch.write("balls.pov", scene), picture = scratch / "balls.png";
  const ProcessResult result =
      run_process({program, "+I" + file.string(), "+O" + picture.string(), fmt::format("+W{}", kColumns * kCell),
                   fmt::format("+H{}", kRows * kCell), "-J", "-A", "-D", "+FN", "+L" + includes().string()},
                  scratch.path(), scratch.path(), kLimit);
  std::string why;
  auto read = read_picture(picture, why);
  EXPECT_TRUE(read) << program << ": " << result.err.substr(0, 3000);
  return read;
}

Picture cell_of(const Picture& picture, std::size_t number) {
  Picture cell{kCell, kCell, {}};
  const std::size_t left = number % kColumns * kCell, top = number / kColumns * kCell;
  for (std::size_t y = top; y < top + kCell; ++y) {
    const auto row = picture.rgb.begin() + static_cast<std::ptrdiff_t>(3 * (y * kColumns * kCell + left));
    cell.rgb.insert(cell.rgb.end(), row, row + 3 * kCell);
  }
  return cell;
}

class IncludeTextures : public testing::TestWithParam<const char*> {};

TEST_P(IncludeTextures, AgreeWithPovRay) {
  const std::string file = GetParam();
  const std::vector<Declared> all = declared_in(file);
  ASSERT_FALSE(all.empty()) << "nothing in " << includes() / file << ".inc (Debian package povray-includes?)";
  const std::size_t most = kColumns * kRows;
  for (std::size_t first = 0; first < all.size(); first += most) {
    const std::vector<Declared> some(all.begin() + static_cast<std::ptrdiff_t>(first),
                                     all.begin() + static_cast<std::ptrdiff_t>(std::min(first + most, all.size())));
    const std::string scene = balls(file, some);
    const auto theirs = picture_by("povray", scene), ours = picture_by(program_under_test(), scene);
    ASSERT_TRUE(theirs && ours);
    for (std::size_t i = 0; i < some.size(); ++i) {
      const PictureDifference apart = difference(cell_of(*theirs, i), cell_of(*ours, i));
      EXPECT_TRUE(some[i].draws ? apart.psnr_8x8 >= kPsnr : apart.share >= kShare)
          << some[i].kind << ' ' << some[i].name << ": " << summary(apart);
    }
  }
  std::cout << file << ": " << all.size() << " balls\n";
}

INSTANTIATE_TEST_SUITE_P(Files, IncludeTextures,
                         testing::Values("finish", "glass", "glass_old", "golds", "metals", "skies", "stoneold",
                                         "stones1", "stones2", "textures", "woodmaps", "woods"),
                         [](const auto& info) { return info.param; });

/// The clouds that are a whole sky.
TEST(IncludeSkies, AgreeWithPovRay) {
  static const std::regex kSky(R"(#declare\s+((S|O)_\w+)\s*=)");
  const std::string code = code_of(includes() / "skies.inc");
  int skies = 0;
  for (auto match = std::sregex_iterator(code.begin(), code.end(), kSky); match != std::sregex_iterator(); ++match) {
    const std::string name = (*match)[1];
    const std::string scene =
        "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#include \"colors.inc\"\n#include \"skies.inc\"\n"
        "camera { location 0 look_at <0, 0.6, 1> angle 80 }\nlight_source { <100, 200, -100> rgb 1 }\n" +
        fmt::format("{} {{ {} }}\n", name[0] == 'S' ? "sky_sphere" : "object", name);
    const auto theirs = picture_by("povray", scene), ours = picture_by(program_under_test(), scene);
    ASSERT_TRUE(theirs && ours) << name;
    const PictureDifference apart = difference(*theirs, *ours);
    EXPECT_GE(apart.share, kShare) << name << ": " << summary(apart);
    ++skies;
  }
  EXPECT_GE(skies, 7);
}

}  // namespace
}  // namespace firstlight::golden
