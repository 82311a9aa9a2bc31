#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace firstlight::golden {

/// A scene of testscenes/ or of POV-Ray's examples that is rendered by both programs.
struct GoldenScene {
  std::string name;            ///< what the test is called: shapes_sphere
  std::filesystem::path file;  ///< absolute
  /// How many of 100 pixels must agree; a scene whose parts are small asks for more: `// compare: share 99.9`.
  double share = 98;
  /// Set by the comment `// compare: psnr 35` in a scene whose pixels depend on chance: the pictures are then compared
  /// by PSNR, in dB, and not pixel by pixel.
  std::optional<double> psnr;
};

/// An error that a scene of testscenes/errors says it must give: `// expect error 4:1: expected '}' to close`, or with
/// the name of the file it includes: `// expect error part.inc:2:5: ...`.
struct ExpectedError {
  std::string file;  ///< without its folder
  int line = 0;
  int column = 0;
  std::string message;  ///< a part of the message
};

std::filesystem::path testscenes();

/// Every scene of testscenes/ but those of errors/, and the examples of POV-Ray that must agree; sorted by name.
std::vector<GoldenScene> golden_scenes();

/// The scenes of testscenes/errors, sorted.
std::vector<std::filesystem::path> error_scenes();
std::vector<ExpectedError> expected_errors(const std::filesystem::path& scene);

/// A name that GoogleTest takes: letters, digits and underscores.
std::string test_name(std::string text);

/// The program under test: the environment's FIRSTLIGHT_PROGRAM, or the one that was built.
std::string program_under_test();

}  // namespace firstlight::golden
