#pragma once

namespace firstlight::render {

/// How much of a scene a picture shows.
/// Source   POV-Ray 3.7's levels, as its code has them: 0 and 1, 2 and 3, 6 and 7, and all from 9 on are the same.
struct Quality {
  int level = 9;

  /// Lights shine; else a surface has the colour of its pigment.
  bool has_light() const { return level >= 2; }
  bool has_shadows() const { return level >= 4; }
  /// Area lights have an area; else they are points.
  bool has_areas() const { return level >= 5; }
  /// Light passes through surfaces, bent or not.
  bool has_refraction() const { return level >= 6; }
  /// Pigments are what they are; else their quick colours, where they have one.
  bool has_pigments() const { return level >= 6; }
  bool has_reflection() const { return level >= 8; }
  /// Surfaces are tilted by their normals.
  bool has_normals() const { return level >= 8; }
  /// Fogs, rainbows, media, photons, radiosity and light below surfaces.
  bool has_matter() const { return level >= 9; }
};

}  // namespace firstlight::render
