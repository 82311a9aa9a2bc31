// The order of the rays is free, as the command line asks for it: every scheme, mixture, expression, boost, budget and
// number of threads writes the same bytes, with and without anti-aliasing.

#include "tests/golden/render.h"
#include "tests/golden/scene_list.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace firstlight::golden {
namespace {

using Arguments = std::vector<std::string>;

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<Arguments> orders() {
  const std::vector<std::string> schemes{"level",
                                         "object",
                                         "region",
                                         "region(20,20,60,90 80,30,110,70), contribution",
                                         "surface",
                                         "complexity",
                                         "distance",
                                         "light",
                                         "light-distance",
                                         "light-colour",
                                         "sample",
                                         "ray-type(shadow transmission reflection)",
                                         "0.7*contribution + 0.3*level",
                                         "level - 2*(ray-type, distance)",
                                         "expr(weight*(level<3) + (x>80))",
                                         "expr(1/(x-y))"};
  std::vector<Arguments> all;
  for (const std::string& scheme : schemes) {
    const bool with_boosts = all.size() % 3 == 0;
    all.push_back({"--scheme", scheme, "--threads", all.size() % 2 == 0 ? "1" : "2"});
    if (with_boosts) all.back().insert(all.back().end(), {"--boost", "region 30 30 90 80 by 2", "--boost", "light 0"});
  }
  all.push_back({"--threads", "2"});  // the scheme if none is given
  return all;
}

/// A scene, and options that all its pictures have.
struct Given {
  const char* scene;
  Arguments options;
};

class OrderIsFree : public testing::TestWithParam<Given> {
 protected:
  /// The bytes of the picture that `arguments` make.
  std::string render_with(const Arguments& arguments) {
    Arguments all = GetParam().options;
    all.insert(all.end(), arguments.begin(), arguments.end());
    const auto file = scratch_ / "picture.png";
    std::filesystem::remove(file);
    const ProcessResult result =
        render(program_under_test(), testscenes() / GetParam().scene, file, scratch_.path(), all);
    EXPECT_TRUE(result.succeeded()) << result.summary() << '\n' << result.err;
    return bytes_of(file);
  }

  const ScratchFolder scratch_;
};

TEST_P(OrderIsFree, ForSchemesMixturesExpressionsAndBoosts) {
  const std::string reference = render_with({"--scheme", "recursive", "--threads", "1"});
  ASSERT_FALSE(reference.empty());
  for (const Arguments& order : orders()) {
    EXPECT_TRUE(render_with(order) == reference) << fmt::format("{}", fmt::join(order, " "));
  }
}

TEST_P(OrderIsFree, ForBudgetsWhichAreKept) {
  const std::string reference = render_with({"--scheme", "recursive", "--threads", "1"});
  ASSERT_FALSE(reference.empty());
  const std::vector<std::pair<std::string, std::size_t>> budgets{
      {"64k", 64u << 10}, {"300k", 300u << 10}, {"1M", 1u << 20}};
  for (const auto& [text, bytes] : budgets) {
    for (const char* scheme : {"contribution", "level", "ray-type, contribution"}) {
      SCOPED_TRACE(text + ", " + scheme);
      const auto stats = scratch_ / "stats.json";
      EXPECT_TRUE(render_with({"--queue-memory", text, "--scheme", scheme, "--threads", "2", "--stats",
                               stats.string()}) == reference);
      const auto numbers = nlohmann::json::parse(bytes_of(stats), nullptr, false);
      ASSERT_TRUE(numbers.is_object());
      EXPECT_LE(numbers.at("queue").at("peak_bytes").get<std::size_t>(), bytes);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, OrderIsFree,
                         testing::Values(Given{"full/mirror_room.pov", {}}, Given{"full/still_life.pov", {}},
                                         Given{"finishes/reflection_forms.pov", {}},
                                         Given{"lights/coloured_shadows.pov", {"+A0.1", "+AM2", "+R2"}},
                                         Given{"interior/refraction.pov", {"+A0.2", "+AM1", "+R2"}},
                                         Given{"cameras/aperture.pov", {"+A0.2", "+AM1", "+R2"}}),
                         [](const auto& info) { return test_name(info.param.scene); });

}  // namespace
}  // namespace firstlight::golden
