#pragma once

#include "render/math/color.h"

#include <cstdint>
#include <string>

namespace firstlight::render {

/// Light that surfaces give to each other. Source   POV-Ray 3.7 manual, "Radiosity"; its defaults.
struct RadiositySettings {
  bool enabled = false;
  double default_importance = 1.0;  ///< of objects that do not say; of `#default`
  double brightness = 1.0;
  int count = 35;                  ///< rays a sample
  int direction_pool_size = 1600;  ///< directions to choose them from
  double error_bound = 1.8;
  double gray_threshold = 0.0;
  double low_error_factor = 0.5;
  double minimum_reuse = 0.015;  ///< share of the picture's width
  double maximum_reuse = 0.2;
  int nearest_count = 5;
  int nearest_count_pretrace = 0;  ///< for adaptive pretrace; 0: not adaptive
  int recursion_limit = 2;
  double max_sample = -1.0;  ///< brightest that a sample may be; below 0: as bright as it is
  double adc_bailout = 0.01;
  bool normal = false;
  bool media = false;
  bool subsurface = false;
  double pretrace_start = 0.08;  ///< shares of the picture's width
  double pretrace_end = 0.04;
  bool always_sample = false;
};

/// Source   POV-Ray 3.7 manual, "Photons"; the defaults of a `photons` block.
struct PhotonSettings {
  /// Radius in which photons are gathered.
  struct Radius {
    double least = -1.0;  ///< below 0: worked out from how dense the photons are
    double factor = 1.0;
  };

  bool enabled = false;
  double spacing = 1.0;  ///< scene units between photons, as they are shot
  int count = 0;         ///< photons to be shot; 0: `spacing` decides
  int gather_min = 20;
  int gather_max = 100;
  double adc_bailout = -1.0;  ///< below 0: that of the scene
  int max_trace_level = -1;   ///< below 0: that of the scene
  double jitter = 0.4;
  double autostop = 0.5;  ///< share
  double expand_tolerance = 0.2;
  double expand_min = 35.0;
  Radius surface_radius, media_radius;
  int max_media_steps = 0;  ///< 0: no photons in media
  double media_spacing_factor = 1.0;
  std::string file;  ///< where the photon map is read from or written to; empty: nowhere
  bool load = false;
};

/// Light that spreads below surfaces. Source   POV-Ray 3.7 manual, "Subsurface".
struct SubsurfaceSettings {
  bool enabled = false;
  int diffuse_samples = 50;
  int single_samples = 50;
  bool radiosity = false;
};

/// How strings of the scene text are encoded.
enum class Charset : std::uint8_t { ascii, utf8, system };

}  // namespace firstlight::render
