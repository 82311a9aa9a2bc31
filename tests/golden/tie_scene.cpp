#include "tests/golden/random_scene.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace firstlight::golden {
namespace {

/// Objects with a face in the plane z = -1, without their closing brace.
constexpr std::array<std::string_view, 10> kFlat = {
    "box { <-0.7, -0.6, -1>, <0.5, 0.8, 1>",
    "cylinder { <0, 0, -1>, <0.2, 0.1, 1>, 0.6",
    "cylinder { <0.1, 0.1, -1>, <0.1, 0.1, 0.5>, 0.7",
    "cone { <0, 0.1, -1>, 0.8, <0, 0.1, 0.6>, 0.2",
    "disc { <0, 0, -1>, z, 0.9, 0.2",
    "triangle { <-0.9, -0.7, -1>, <0.9, -0.5, -1>, <0.1, 0.9, -1>",
    "plane { -z, 1",
    "intersection { sphere { <0, 0, -0.8>, 0.9 } plane { -z, 1 }",
    "union { box { <-0.8, -0.8, -1>, <-0.2, 0.3, 0> } sphere { <0.4, 0, -0.4>, 0.5 }",
    "difference { box { <-0.8, -0.7, -1>, <0.8, 0.4, 0> } cylinder { <0, 0, -2>, <0, 0, 2>, 0.3 }",
};

/// Surfaces that are round, in pairs of the same place.
constexpr std::array<std::array<std::string_view, 2>, 8> kRound = {{
    {"sphere { 0, 0.9", "sphere { 0, 0.9"},
    {"sphere { 0, 0.9", "intersection { sphere { 0, 0.9 } box { <-1, -0.3, -1>, <1, 0.6, 1> }"},
    {"sphere { 0, 0.9", "difference { sphere { 0, 0.9 } cylinder { -2*z, 2*z, 0.4 }"},
    {"cylinder { -y, y, 0.7", "cylinder { -0.5*y, 0.6*y, 0.7"},
    {"cone { -y, 0.9, y, 0.1", "intersection { cone { -y, 0.9, y, 0.1 } box { -1, <1, 0.3, 0.4> }"},
    {"torus { 0.7, 0.25 rotate -60*x", "torus { 0.7, 0.25 rotate -60*x"},
    {"torus { 0.7, 0.25 rotate -60*x", "difference { torus { 0.7, 0.25 rotate -60*x } box { 0, 1 }"},
    {"union { sphere { 0, 0.9 } box { <-0.3, 0.5, -0.3>, <0.3, 1, 0.3> }", "sphere { 0, 0.9"},
}};

constexpr std::uint64_t kPairs = kFlat.size() * kFlat.size() + 2 * kRound.size();
/// With and without an infinite plane, few and many other objects.
constexpr std::uint64_t kSurroundings = 6;

std::array<std::string_view, 2> pair_of(std::uint64_t number) {
  if (number < kFlat.size() * kFlat.size()) return {kFlat[number % kFlat.size()], kFlat[number / kFlat.size()]};
  number -= kFlat.size() * kFlat.size();
  const auto& [first, second] = kRound[number / 2];
  return number % 2 == 0 ? std::array{first, second} : std::array{second, first};
}

}  // namespace

const std::uint64_t kTieScenes = kPairs * kSurroundings;

std::string tie_scene(std::uint64_t number) {
  const auto [first, second] = pair_of(number % kPairs);
  const std::uint64_t surroundings = number / kPairs % kSurroundings;
  std::string text =
      "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#default { finish { ambient 0.3 diffuse 0.6 } }\n"
      "camera { location <1.1, 1.3, -5> look_at 0 angle 40 right x*4/3 }\nlight_source { <4, 6, -9>, 1 }\n";
  text += fmt::format("{} pigment {{ rgb x }} }}\n{} pigment {{ rgb z }} }}\n", first, second);
  if (surroundings % 2 == 1) text += "plane { y, -2 pigment { rgb y } }\nplane { y, -2 pigment { rgb 1 } }\n";
  constexpr std::array<int, 3> kOthers = {0, 3, 40};
  for (int i = 0; i < kOthers[surroundings / 2]; ++i) {
    text += fmt::format("sphere {{ <{:.2f}, {:.2f}, {:.2f}>, 0.15 pigment {{ rgb <0.5, 0.5, {:.2f}> }} }}\n",
                        -2.0 + 0.4 * (i % 11), -1.6 + 0.9 * (i / 11), 0.3 * (i % 5), 0.02 * i);
  }
  return text;
}

}  // namespace firstlight::golden
