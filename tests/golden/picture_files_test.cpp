// Dithered pictures, shades of gray and the quality of JPEG files are POV-Ray's.

#include "render/image/image_io.h"
#include "tests/golden/render.h"
#include "tests/golden/scene_list.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace firstlight::golden {
namespace {

namespace fs = std::filesystem;

/// Errors are handed on from pixel to pixel, so the colours have to be POV-Ray's to the last bit.
constexpr const char* kEvenSlopes =
    "#version 3.7; global_settings { assumed_gamma 1 }\n"
    "camera { orthographic location -5*z right 4*x up 3*y look_at 0 }\n"
    "plane { z, 0 pigment { gradient x+0.3*y color_map { [0 rgb <0, 0.2, 0.1>] [1 rgb <1.1, 0.3, 0.7>] } scale 5 }\n"
    "  finish { ambient 1 diffuse 0 } }\n";

class PictureFiles : public testing::Test {
 protected:
  std::vector<double> numbers_of(const std::string& program, const std::string& file,
                                 const std::vector<std::string>& words) {
    const ProcessResult result = render(program, scene_, scratch_ / file, scratch_.path(), words);
    EXPECT_TRUE(result.succeeded()) << result.summary() << '\n' << result.err;
    std::string error;
    const render::Raster raster = render::read_raster((scratch_ / file).string(), error);
    EXPECT_EQ(error, "");
    channels_ = raster.channels;
    white_ = raster.white;
    std::vector<double> numbers(static_cast<std::size_t>(raster.width * raster.height * raster.channels));
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = raster.value(i);
    return numbers;
  }
  /// The share of the numbers that are within `tolerance` of 1.
  static double share(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
    if (a.size() != b.size() || a.empty()) return 0.0;
    std::size_t near = 0;
    for (std::size_t i = 0; i < a.size(); ++i) near += std::abs(a[i] - b[i]) <= tolerance ? 1 : 0;
    return static_cast<double>(near) / static_cast<double>(a.size());
  }

  const ScratchFolder scratch_;
  const fs::path scene_ = scratch_.write("scene.pov", kEvenSlopes);
  int channels_ = 0;
  int white_ = 0;
};

TEST_F(PictureFiles, AreDitheredAsPovRays) {
  const std::vector<double> plain = numbers_of(program_under_test(), "plain.png", {"+FN5"});
  for (const char* method : {"+THB2", "+THB3", "+THB4", "+THD1", "+THD2", "+THFS", "+TH"}) {
    const std::vector<double> theirs = numbers_of("povray", "theirs.png", {"+FN5", method});
    const std::vector<double> ours = numbers_of(program_under_test(), "ours.png", {"+FN5", method});
    EXPECT_GE(share(ours, theirs, 0.0), 0.999) << method;
    EXPECT_LT(share(ours, plain, 0.0), 0.9) << method << ": nothing to be seen of it";
  }
}

TEST_F(PictureFiles, AreDitheredInTheOrderOfTheirRows) {
  for (const char* type : {"+FB", "+FT", "+FP"}) {
    const std::string end = std::string(type) == "+FB" ? ".bmp" : std::string(type) == "+FT" ? ".tga" : ".ppm";
    const std::vector<double> theirs = numbers_of("povray", "theirs" + end, {type, "+THFS"});
    const std::vector<double> ours = numbers_of(program_under_test(), "ours" + end, {type, "+THFS"});
    EXPECT_GE(share(ours, theirs, 0.0), 0.999) << type;
  }
}

TEST_F(PictureFiles, HaveTheShadesOfGrayOfPovRays) {
  for (const std::vector<std::string>& words : {std::vector<std::string>{"+FNg"},
                                                {"+FPg", "Bits_Per_Color=16"},
                                                {"+FN", "Grayscale_Output=on"},
                                                {"+FNg", "File_Gamma=1"}}) {
    const std::string end = words[0] == "+FPg" ? ".ppm" : ".png";
    const std::vector<double> theirs = numbers_of("povray", "theirs" + end, words);
    const std::vector<double> ours = numbers_of(program_under_test(), "ours" + end, words);
    EXPECT_EQ(channels_, 1) << words[0];
    EXPECT_EQ(white_, 65535) << words[0];
    EXPECT_GE(share(ours, theirs, 1.5 / 65535), 0.999) << words[0];
  }
}

TEST_F(PictureFiles, HaveTheDepthThatIsAskedFor) {
  for (const char* bits : {"+FN5", "+FN7", "+FN10", "+FP6", "+FP12"}) {
    const std::string end = std::string(bits).starts_with("+FP") ? ".ppm" : ".png";
    const std::vector<double> theirs = numbers_of("povray", std::string("theirs") + end, {bits});
    const int white = white_;
    EXPECT_GE(share(numbers_of(program_under_test(), "ours" + end, {bits}), theirs, 0.0), 0.999) << bits;
    EXPECT_EQ(white_, white) << bits;
  }
}

TEST_F(PictureFiles, OfJpegHaveTheQualityOfPovRays) {
  std::vector<std::uintmax_t> sizes;
  for (const char* word : {"Compression=10", "Compression=1", "Compression=98"}) {
    const std::vector<double> theirs = numbers_of("povray", "theirs.jpg", {"+FJ", word});
    const std::vector<double> ours = numbers_of(program_under_test(), "ours.jpg", {"+FJ", word});
    EXPECT_GE(share(ours, theirs, 2.0 / 255), 0.99) << word;
    sizes.push_back(fs::file_size(scratch_ / "ours.jpg"));
  }
  EXPECT_LT(sizes[0], sizes[1]);
  EXPECT_LT(sizes[1], sizes[2]);
}

}  // namespace
}  // namespace firstlight::golden
