#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace firstlight::app::compare {

/// How far two pictures of one size are apart. Colours are those of the files, of 255.
struct PictureDifference {
  int width = 0;
  int height = 0;
  double share = 0.0;     ///< of the pixels within 2/255 in every channel, 0 to 1
  double mean = 0.0;      ///< of all channels' differences, of 255
  double rms = 0.0;       ///< root of their mean square, of 255
  double psnr = 0.0;      ///< dB over all channels; infinite when the pictures are equal
  double psnr_8x8 = 0.0;  ///< dB between the means of 8x8 pixels: what features that draw at random are judged by
  double flip = 0.0;      ///< mean FLIP error, 0 to 1 (render/image/flip.h)
  int worst = 0;          ///< the largest difference of a channel, of 255
  int x = 0, y = 0;       ///< where that is
  std::vector<int> first, second;  ///< both colours there, with alpha if one of the pictures has it
};

/// One run of a program to its end. Times in seconds.
struct ProgramRun {
  double parse = 0.0;
  double trace = 0.0;
  double wall = 0.0;       ///< of the whole process
  double processor = 0.0;  ///< user and system time of the whole process
  long peak_bytes = 0;     ///< of memory
};

/// A feature that the scene asks for and Firstlight cannot render, where it is asked for first.
struct MissingFeature {
  std::string feature;  ///< as the message names it
  std::string file;
  int line = 0;
  int column = 0;
};

/// The outcome of one scene.
enum class Status {
  agrees,
  warns,  ///< between the thresholds for failing and for agreeing
  differs,
  other_size,      ///< the pictures have different sizes
  lacks_features,  ///< SceneRecord::missing says which
  ours_failed,     ///< Firstlight refused the scene, crashed or hung; POV-Ray rendered it
  povray_failed,   ///< the other way round
  both_failed,
};

/// One scene rendered by both programs, as often as rounds were asked for.
struct SceneRecord {
  std::string name;             ///< its path below the folder or list that was compared, without `.pov`
  std::filesystem::path scene;  ///< absolute
  Status status = Status::both_failed;
  std::optional<PictureDifference> difference;  ///< when both pictures are there and have one size
  std::vector<ProgramRun> povray;               ///< a run a round; empty when it failed
  std::vector<ProgramRun> ours;
  std::vector<MissingFeature> missing;
  std::string message;                   ///< the first error of the program that failed, in its own words
  std::string povray_message;            ///< POV-Ray's error alone, so that it can be kept; empty when it rendered
  std::filesystem::path povray_picture;  ///< empty when there is none
  std::filesystem::path our_picture;
  std::string keeping;  ///< why a picture could not be kept; empty when all are, or none was to be
};

}  // namespace firstlight::app::compare
