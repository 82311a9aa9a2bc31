#pragma once
#include <string>
#include <vector>

namespace firstlight::golden {

/// A small scene whose picture depends on bounds: on the room that boxes have, or on POV-Ray's box of an object.
struct BoundsScene {
  std::string name;  ///< letters, digits and underscores
  std::string text;
  std::vector<std::string> words = {};  ///< options of both programs
  double share = 99.5;                  ///< of 100 pixels that must agree
};

/// At least six of every kind, made from lists of what is combined.
std::vector<BoundsScene> bounds_scenes();

}  // namespace firstlight::golden
