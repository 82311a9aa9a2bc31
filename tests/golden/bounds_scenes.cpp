#include "tests/golden/bounds_scenes.h"

#include <array>
#include <cstddef>
#include <utility>

namespace firstlight::golden {
namespace {

using Words = std::vector<std::string>;

constexpr const char* kView = R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <2.3,3.1,-6.7> look_at 0 angle 40 right x*4/3 }
light_source { <4,6,-3> rgb 1 }
background { rgb <0.2,0.3,0.5> }
)";
/// The shadows of what is larger than its box depend on the order of the pixels in POV-Ray.
constexpr double kShareOfShadows = 98.0;

constexpr const char* kFloor = "plane { y, -1.5 pigment { checker rgb 1 rgb 0.2 } }\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

void add(std::vector<BoundsScene>& scenes, const std::string& kind, const std::string& text, const Words& words = {}) {
  std::size_t number = 1;
  for (const BoundsScene& scene : scenes) number += scene.name.starts_with(kind + '_') ? 1 : 0;
  scenes.push_back({kind + '_' + std::to_string(number), std::string(kView) + text, words});
}

/// Half spaces that end at 0, of every axis and in every place, with the moves and the sense in turn. A is the axis, B
/// and C are the other two; P is the half space.
void add_planes_at_zero(std::vector<BoundsScene>& scenes) {
  constexpr std::array kPlaces{
      "difference { sphere { 0, 1.2 } P pigment { rgb z } }",
      "intersection { P sphere { 0, 1.2 } pigment { rgb x } }",
      "intersection { box { -1, 1 } sphere { 0, 1.3 } P pigment { rgb y } }",
      "sphere { 0, 1.2 clipped_by { P } pigment { rgb <1,1,0> } }",
      "object { P clipped_by { sphere { 0, 1.4 } } pigment { rgb <0,1,1> } }",
      "difference { P cylinder { -A, A, 0.7 } pigment { checker rgb x rgb 1 } clipped_by { box { -3, 3 } } }",
      "difference { union { box { -1, 1 } sphere { 0, 1.3 } } union { P sphere { B, 0.6 } } pigment { rgb z } }",
      "merge { intersection { sphere { 0, 1.2 } P } cylinder { -B, B, 0.4 } pigment { rgb 1 } }",
      "intersection { torus { 1, 0.4 } P pigment { rgb <1,0,1> } }",
      "difference { sphere { 0, 1.3 } P pigment { rgbt <1,0.8,0.8,0.7> } interior { ior 1.4 } }",
      "union { intersection { P sphere { 0, 1 } } sphere { 2*B, 0.5 } bounded_by { box { -3, 3 } } pigment { rgb x } }",
  };
  constexpr std::array kPlanes{
      "plane { A, 0 }",
      "plane { -A, 0 }",
      "plane { A, 0 scale <2,1,3> }",
      "plane { -A, 0 rotate 30*A }",
      "plane { A, 5 translate -5*A }",
      "plane { A, 0 rotate 180*B }",
      "plane { B, 0 rotate 90*C }",
      "plane { -A, 3 translate <1e5,1e5,1e5> translate -<1e5,1e5,1e5> translate 3*A }",
      "plane { A, 0 inverse }",
      "plane { A, 1e-9 }",
      "plane { -A, 0 transform { scale 2 rotate 90*A } }",
  };
  constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};
  std::size_t turn = 0;
  for (const char* place : kPlaces) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::string text = replaced(place, "P ", std::string(kPlanes[turn++ % kPlanes.size()]) + ' ');
      text = replaced(text, "A", kAxes[axis]);
      text = replaced(text, "B", kAxes[(axis + 1) % 3]);
      text = replaced(text, "C", kAxes[(axis + 2) % 3]);
      add(scenes, "plane_at_zero", std::string(kFloor) + text);
    }
  }
}

void add_cutting_discs(std::vector<BoundsScene>& scenes) {
  constexpr std::array kObjects{
      "intersection { disc { 0, <1,3,-1>, 1 } box { -0.6, 2 } pigment { rgb z } }",
      "intersection { sphere { 0, 1.2 } disc { 0, y, 2 } pigment { rgb x } }",
      "difference { sphere { 0, 1.2 } disc { 0, <1,1,-1>, 0.8 } pigment { rgb x } }",
      "difference { disc { 0, <0,1,-1>, 1.5 } sphere { 0, 0.7 } pigment { rgb y } }",
      "sphere { 0, 1 clipped_by { disc { 0, y, 0.5 } } pigment { rgb z } }",
      "box { -1, 1 clipped_by { disc { 0, <1,2,-2>, 1 } } pigment { rgb z } }",
      "box { -1, 1 clipped_by { disc { 0, <1,2,-2>, 1 inverse } } pigment { rgb z } }",
      "cylinder { -y, y, 0.7 clipped_by { disc { 0, <1,1,-3>, 2, 1 } } rotate 30*z pigment { rgb z } }",
      "intersection { disc { 0, <1,3,-1>, 1 } box { -0.6, 2 } rotate 30*y rotate -20*x pigment { rgb <1,1,0> } }",
      "intersection { disc { 0, y, 1 } sphere { 0, 1.4 } rotate <20,0,40> scale <1,1.5,1> pigment { rgb <1,1,0> } }",
      "union { intersection { disc { 0, y, 1 } box { -1, 1 } rotate 40*z } sphere { <1.5,0,0>, 0.4 } rotate 30*y\n"
      "  rotate 20*x pigment { rgb x } }",
      "union { sphere { 0, 1 clipped_by { disc { 0, <0,1,-1>, 0.8 } } } sphere { <1.5,0,0>, 0.4 } pigment { rgb x } }",
      "union { sphere { 0, 1 clipped_by { disc { 0, <0,1,-1>, 0.8 } } } sphere { <1.5,0,0>, 0.4 } rotate 30*z\n"
      "  pigment { rgb x } }",
      "torus { 1, 0.4 clipped_by { disc { 0, <0,1,-0.2>, 1 } } rotate -40*x pigment { rgb y } }",
      "merge { intersection { disc { 0, <1,3,-1>, 1 } sphere { 0, 1 } } box { -0.5, 0.5 } pigment { rgb y } }",
      "#declare A = intersection { disc { 0, <0,1,-1>, 1 } box { -1, 1 } }\n"
      "object { A rotate 30*y pigment { rgb z } } object { A scale 0.5 rotate 50*z translate 1.5*x pigment { rgb x } }",
      "intersection { disc { 0, <1,3,-1>, 1 } box { -0.6, 2 } pigment { rgbt <1,0.7,0.7,0.6> } interior { ior 1.3 } }",
      "plane { <1,2,-3>, 0 clipped_by { disc { 0, <0,1,-1>, 1.5 } } no_shadow pigment { rgb x } }",
      "difference { box { -1, 1 } disc { 0, <1,1,0>, 1 inverse } pigment { rgb z } }",
      "intersection { disc { 0.4*y, <1,3,-1>, 1 } disc { -0.4*y, -y, 1.4 } sphere { 0, 1.3 } pigment { rgb y } }",
  };
  for (const char* object : kObjects) {
    add(scenes, "cutting_disc", std::string(kFloor) + object);
    scenes.back().share = kShareOfShadows;
  }
}

void add_starts_inside(std::vector<BoundsScene>& scenes) {
  const std::string glass = "pigment { rgbt <1,0.6,0.6,0.6> } interior { ior 1.4 fade_distance 1 fade_power 1 }";
  constexpr std::array kObjects{
      "disc { 0, z, 1.5 G }",
      "disc { 0, -z, 1.5 G }",
      "disc { <2.3,3.1,-6.6>, z, 0.1 G }",
      "sphere { 0, 3 inverse G }",
      "sphere { 0, 9 inverse G }",
      "sphere { <0,0,-5>, 4 G }",
      "box { -1, 1 inverse rotate 30*y G }",
      "box { -7.5, 7.5 inverse G }",
      "cylinder { -y, y, 1 inverse G }",
      "union { sphere { 0, 1 } box { 0.5, 1.5 } inverse G }",
      "difference { sphere { 0, 1 } box { 0, 1.5 } inverse G }",
      "plane { z, 0 clipped_by { box { -1, 1 } } G }",
      "plane { -y, -1.2 clipped_by { sphere { y, 2 } } G }",
      "sphere { <0,0,-5>, 4 clipped_by { plane { z, -5.5 } } G }",
      "sphere { <0,0,-5>, 4 clipped_by { plane { -z, 5.5 } } G }",
      "intersection { plane { z, 0 } plane { y, 4 } G }",
      "intersection { plane { <0,1,1>, 0 } plane { <1,-1,0>, 1 } G }",
      "intersection { sphere { 0, 1 inverse } plane { y, 0 inverse } G }",
      "merge { sphere { 0, 8.5 } box { -1, 1 } clipped_by { sphere { 0, 1.5 } } G }",
      "sphere { 0, 9 bounded_by { box { -1.2, 1.2 } } G }",
      "torus { 7, 1.5 G }",
      "torus { 2, 0.5 inverse G }",
      "union { plane { z, 0 clipped_by { box { -1, 1 } } } sphere { 0, 0.5 inverse } split_union off G }",
  };
  for (const char* object : kObjects) add(scenes, "start_inside", kFloor + replaced(object, "G", glass));
}

void add_bounded(std::vector<BoundsScene>& scenes) {
  constexpr std::array kObjects{
      "sphere { 0, 1 pigment { rgb x } bounded_by { box { -0.5, 0.5 } } }",
      "box { -1, 1 bounded_by { sphere { 0, 1.1 } } rotate 30*y pigment { rgb x } }",
      "torus { 1, 0.3 bounded_by { cylinder { -0.2*y, 0.2*y, 1 } } rotate -30*x pigment { rgb y } }",
      "union { sphere { 0, 1 } box { 0.3, 1.5 } bounded_by { box { -0.5, 0.8 } } pigment { rgb z } }",
      "union { sphere { 0, 1 } box { 0.3, 1.5 } bounded_by { sphere { 0.3, 0.9 } } rotate 40*z pigment { rgb z } }",
      "union { plane { y, -1.2 } sphere { 0, 1 } bounded_by { sphere { 0, 1.2 } } no_shadow pigment { rgb z } }",
      "union { sphere { 0, 1 bounded_by { box { -0.5, 0.5 } } } sphere { 1.5*x, 0.5 } pigment { rgb x } }",
      "union { sphere { 0, 1 bounded_by { box { -0.5, 0.5 } } } sphere { 1.5*x, 0.5 } rotate 20*y pigment { rgb x } }",
      "plane { y, -1 bounded_by { box { <-2,-1.1,-2>, <2,-0.9,2> } } no_shadow pigment { rgb x } }",
      "plane { <1,2,-3>, 0 bounded_by { sphere { 0, 1 } } no_shadow pigment { rgb x } }",
      "difference { box { -1, 1 } sphere { -z, 0.8 } bounded_by { box { <-0.6,-0.6,-2>, <0.9,0.9,2> } } rotate 30*y\n"
      "  pigment { rgb y } }",
      "intersection { box { -1, 1 } sphere { 0, 1.3 } bounded_by { sphere { 0, 0.9 } } pigment { rgb y } }",
      "merge { box { -1, 1 } sphere { x, 0.8 } bounded_by { box { -0.9, 1.2 rotate 30*z } } pigment { rgb y } }",
      "union { sphere { -x, 0.7 } sphere { x, 0.7 } bounded_by { box { -1.2, 1.2 inverse } } pigment { rgb z } }",
      "sphere { 0, 1 bounded_by { sphere { 0.5*x, 0.8 } sphere { -0.5*x, 0.8 } } pigment { rgb z } }",
      "sphere { 0, 1 clipped_by { box { -0.8, 0.8 } } bounded_by { clipped_by } pigment { rgb z } }",
      "sphere { 0, 1.5 bounded_by { box { -1, 0.9 } } clipped_by { bounded_by } pigment { rgb z } }",
      "object { sphere { 0, 1 bounded_by { box { -0.5, 0.5 } } } rotate 45*y scale 1.2 pigment { rgb x } }",
      "union { sphere { 0, 1 } torus { 1.4, 0.1 } bounded_by { disc { 0, y, 1 } } no_shadow pigment { rgb x } }",
      "sphere { 0, 1 bounded_by { box { 2, 3 } } pigment { rgb z } }",
  };
  const std::array<Words, 4> switches{Words{}, Words{"-UR"}, Words{"+SU"},
                                      Words{"Remove_Bounds=Off", "Split_Unions=On"}};
  for (std::size_t i = 0; i < kObjects.size(); ++i) {
    for (const Words& words : {switches[0], switches[1 + i % 3]}) {
      add(scenes, "bounded", std::string(kFloor) + kObjects[i], words);
      scenes.back().share = kShareOfShadows;
    }
  }
}

/// Shadows of what is farther away than most shapes are seen from.
void add_far_shadows(std::vector<BoundsScene>& scenes) {
  constexpr std::array kObjects{
      "sphere { <0,2e7,0>, 5e6 M }",
      "sphere { <0,0.9e7,0>, 2e6 M }",
      "sphere { 0, 1 scale <5e6,1e6,5e6> translate 2e7*y M }",
      "sphere { 0, 5e6 scale <1,0.9,1> translate 2e7*y M }",
      "box { <-5e6,2e7,-5e6>, <5e6,2.1e7,5e6> M }",
      "cylinder { 2e7*y, 2.1e7*y, 5e6 M }",
      "cone { 2e7*y, 5e6, 2.1e7*y, 1e6 M }",
      "torus { 5e6, 4.9e6 translate 2e7*y M }",
      "disc { 2e7*y, y, 5e6 M }",
      "disc { 0.9e7*y, y, 5e6 M }",
      "triangle { <-9e6,2e7,-9e6>, <9e6,2e7,-9e6>, <0,2e7,9e6> M }",
      "plane { y, 2e7 M }",
      "intersection { sphere { <0,2e7,0>, 5e6 } plane { y, 2e7 } M }",
      "sphere { <0,2e7,0>, 5e6 pigment { rgbf <1,0.5,0.5,0.8> } }",
  };
  constexpr const char* kScene = R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <1,4,-6> look_at 0 angle 40 right x*4/3 }
light_source { <0,5e7,0> rgb 1 }
plane { y, -1 pigment { checker rgb 1 rgb 0.2 } }
sphere { 0, 1 pigment { rgb x } }
)";
  int number = 0;
  for (const char* object : kObjects) {
    scenes.push_back({"far_shadow_" + std::to_string(++number), kScene + replaced(object, "M", "pigment { rgb 1 }")});
  }
}

void add_negative_radii(std::vector<BoundsScene>& scenes) {
  constexpr std::array kObjects{
      "sphere { 0, -1 M }",
      "sphere { 0, -1 scale <1,1.3,1> M }",
      "sphere { 0, -0.5 scale 2 rotate 30*x translate 0.3*y M }",
      "sphere { 0, -1 inverse M }",
      "intersection { sphere { 0, -1 } box { -0.8, 0.8 } M }",
      "difference { box { -0.8, 0.8 } sphere { <0.8,0.8,-0.8>, -0.7 } M }",
      "union { sphere { 0, -1 } sphere { x, 0.5 } M }",
      "merge { sphere { 0, -0.5 } sphere { x, 0.5 } M }",
      "merge { sphere { 0, -0.5 } sphere { x, 0.5 } rotate 30*y M }",
      "box { -1, 1 clipped_by { sphere { 0, -1.2 } } M }",
      "sphere { 0, 1 bounded_by { sphere { 0, -0.6 } } M }",
      "cylinder { -y, y, -0.6 M }",
      "cone { -y, -0.9, y, -0.3 M }",
      "cone { -y, 1, y, -0.5 M }",
      "difference { cone { -y, -0.4, y, 0.9 } box { <0,-2,-2>, <2,2,0> } M }",
      "torus { 1, -0.3 M }",
      "torus { -1, 0.3 M }",
      "torus { -1, 0.3 rotate -70*x M }",
      "torus { -1, -0.3 rotate -30*x M }",
      "difference { torus { -1, 0.6 } plane { z, 0 } M }",
      "disc { 0, <0,1,-1>, -1 M }",
      "disc { 0, <0,1,-1>, -1, -0.5 M }",
  };
  for (const char* object : kObjects) {
    add(scenes, "negative_radius", kFloor + replaced(object, "M", "pigment { rgb <1,0.5,0> }"));
  }
}

void add_reflection_exponents(std::vector<BoundsScene>& scenes) {
  for (const char* exponent : {"0.5", "0.25", "2", "0.4", "1/3", "-0.5"}) {
    for (const char* background : {"<-0.3,0.4,0.9>", "<-0.3,-0.6,-1>"}) {
      add(scenes, "reflection_exponent",
          std::string("background { rgb ") + background + " }\nsphere { 0, 1.3 pigment { rgb <0.1,0.7,0.2> }\n" +
              "  finish { reflection { 0.5 exponent " + exponent + " } } }\n");
    }
  }
}

}  // namespace

std::vector<BoundsScene> bounds_scenes() {
  std::vector<BoundsScene> scenes;
  add_planes_at_zero(scenes);
  add_cutting_discs(scenes);
  add_starts_inside(scenes);
  add_bounded(scenes);
  add_far_shadows(scenes);
  add_negative_radii(scenes);
  add_reflection_exponents(scenes);
  return scenes;
}

}  // namespace firstlight::golden
