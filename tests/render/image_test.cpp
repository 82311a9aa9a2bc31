#include "render/image/compare.h"
#include "render/image/encode.h"
#include "render/image/image_io.h"
#include "render/image/row_encoder.h"
#include "render/scene/file_encoding.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <span>

namespace firstlight::render {
namespace {

namespace fs = std::filesystem;

/// An empty folder of its own for each test, gone afterwards.
class ImageFile : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
        fs::path(::testing::TempDir()) / ("firstlight_image_" + std::string(test->name()) + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

Picture example() {
  Picture picture{3, 2, {}};
  for (int i = 0; i < 18; ++i) picture.rgb.push_back(static_cast<std::uint8_t>(14 * i));
  return picture;
}

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(Encoding, LinearLightGetsTheSrgbCurve) {
  const Encoding encoding = Encoding::linear();
  EXPECT_EQ(encoding.byte(0.0f), 0);
  EXPECT_EQ(encoding.byte(0.5f), 188);  // 255 (1.055 0.5^(1/2.4) - 0.055) = 187.5
  EXPECT_EQ(encoding.byte(0.2f), 124);
  EXPECT_EQ(encoding.byte(0.001f), 3);  // 255 * 12.92 * 0.001 = 3.29
  EXPECT_EQ(encoding.byte(1.0f), 255);
}

TEST(Encoding, NumbersThatAreFileNumbersAreOnlyRounded) {
  const Encoding encoding = Encoding::as_is();
  EXPECT_EQ(encoding.byte(0.5f), 128);
  EXPECT_EQ(encoding.byte(100.4f / 255.0f), 100);
  EXPECT_EQ(encoding.byte(100.6f / 255.0f), 101);
}

TEST(Encoding, WorkingPowerIsTakenBackFirst) {
  EXPECT_EQ(Encoding::power(2.0).byte(std::sqrt(0.2f)), Encoding::linear().byte(0.2f));
  EXPECT_EQ(Encoding::power(2.2).byte(-0.5f), 0);
  EXPECT_EQ(Encoding::power(1.005).byte(0.5f), Encoding::linear().byte(0.5f));
}

TEST(Encoding, ClipsWhatAFileCannotHold) {
  for (const Encoding& encoding : {Encoding::linear(), Encoding::as_is(), Encoding::power(2.2)}) {
    EXPECT_EQ(encoding.byte(-1.0f), 0);
    EXPECT_EQ(encoding.byte(7.0f), 255);
    EXPECT_EQ(encoding.byte(std::numeric_limits<float>::infinity()), 255);
    EXPECT_EQ(encoding.byte(std::numeric_limits<float>::quiet_NaN()), 0);
  }
}

TEST(Encoding, FilesOfLightAreNotClipped) {
  EXPECT_EQ(Encoding::linear().light(7.0f), 7.0f);
  EXPECT_FLOAT_EQ(Encoding::power(2.0).light(3.0f), 9.0f);
  EXPECT_FLOAT_EQ(Encoding::as_is().light(1.0f), 1.0f);
  EXPECT_NEAR(Encoding::as_is().light(0.5f), 0.2140, 1e-4);
  EXPECT_TRUE(std::isfinite(Encoding::linear().light(std::numeric_limits<float>::infinity())));
}

TEST(Encoding, FollowsTheScenesGamma) {
  Settings settings;
  EXPECT_EQ(file_encoding(settings).byte(0.5f), 188);
  settings.gamma = WorkingGamma::unmanaged;
  EXPECT_EQ(file_encoding(settings).byte(0.5f), 128);
  settings.gamma = WorkingGamma::power;
  settings.gamma_exponent = 2.0;
  EXPECT_EQ(file_encoding(settings).byte(0.5f), Encoding::linear().byte(0.25f));
}

TEST(Encoding, FilesMayHaveAGammaOfTheirOwn) {
  EXPECT_EQ(Encoding::linear().with_file_gamma(2.0).byte(0.25f), 128);
  EXPECT_EQ(Encoding::linear().with_file_gamma(1.0).byte(0.5f), 128);
  EXPECT_EQ(Encoding::power(2.0).with_file_gamma(2.0).byte(0.5f), 128) << "two powers that undo each other";
  EXPECT_EQ(Encoding::power(4.0).with_file_gamma(2.0).byte(0.5f), 64);
  EXPECT_EQ(Encoding::srgb().byte(0.5f), 128);
  EXPECT_EQ(Encoding::srgb().with_file_gamma(1.0).byte(0.5f), 55);
  EXPECT_EQ(Encoding::as_is().with_file_gamma(3.0).byte(0.5f), 128) << "no gamma is managed";
}

TEST(Encoding, WordsHaveSixteenBits) {
  EXPECT_EQ(Encoding::as_is().word(0.5f), 32768);
  EXPECT_EQ(Encoding::linear().word(2.0f), 65535);
  EXPECT_EQ(Encoding::linear().word(-1.0f), 0);
  EXPECT_EQ(Encoding::linear().word(std::numeric_limits<float>::quiet_NaN()), 0);
  const std::array colors{Rgb(0.0f, 0.5f, 1.0f)};
  std::array<std::uint8_t, 6> bytes{};
  RowEncoder(Encoding::as_is(), {.bits = 16}, 1).encode(0, colors, bytes);
  EXPECT_EQ(bytes, (std::array<std::uint8_t, 6>{0, 0, 128, 0, 255, 255}));
}

TEST(Encoding, OfManyColorsIsThatOfEach) {
  std::vector<Rgb> colors;
  const auto add = [&](std::uint32_t bits) {
    const float number = std::bit_cast<float>(bits);
    colors.emplace_back(number, -number, number * 3.0f);
  };
  for (std::uint32_t bits = 0; bits < std::bit_cast<std::uint32_t>(4.0f); bits += 9973) add(bits);
  // Beside where bytes change, as far as POV-Ray's curve goes there.
  for (int byte = 0; byte < 255; ++byte) {
    float low = 0.0f;
    float high = 1.0f;
    while (std::nextafter(low, high) < high) {
      const float middle = (low + high) / 2.0f;
      (Encoding::linear().byte(middle) <= byte ? low : high) = middle;
    }
    for (std::uint32_t step = 0; step < 16; ++step) add(std::bit_cast<std::uint32_t>(low) + step - 8);
  }
  for (const float odd : {NAN, INFINITY, -INFINITY}) colors.emplace_back(odd, odd, odd);
  for (const Encoding& encoding : {Encoding::linear(), Encoding::as_is(), Encoding::power(2.2), Encoding::power(0.7)}) {
    const std::vector<std::uint8_t> bytes = to_bytes(colors, encoding);
    for (std::size_t i = 0; i < colors.size(); ++i) {
      for (unsigned c = 0; c < 3; ++c) ASSERT_EQ(bytes[3 * i + c], encoding.byte(colors[i][c])) << colors[i][c];
    }
  }
}

TEST(Encoding, KeepsTheOrderOfPixelsAndChannels) {
  const std::array<Rgb, 2> colors = {Rgb(0.0f, 1.0f, 0.5f), Rgb(1.0f, 0.0f, 0.0f)};
  EXPECT_EQ(to_bytes(colors, Encoding::as_is()), (std::vector<std::uint8_t>{0, 255, 128, 255, 0, 0}));
  std::vector<float> light;
  append_light(colors, Encoding::linear(), {}, light);
  EXPECT_EQ(light, (std::vector<float>{0.0f, 1.0f, 0.5f, 1.0f, 0.0f, 0.0f}));
}

TEST_F(ImageFile, LosslessFormatsComeBackAsWritten) {
  for (const char* name : {"a.png", "a.PNG", "a.tga", "a.ppm", "a.bmp"}) {
    EXPECT_EQ(write_picture(path(name), example()), "") << name;
    std::string error;
    EXPECT_EQ(read_image(path(name), error), example()) << name << " " << error;
  }
  EXPECT_EQ(files(), 5u) << "nothing but the pictures is left";
}

TEST_F(ImageFile, AlphaComesBackAsWritten) {
  const std::vector<std::uint8_t> rgba{1, 2, 3, 4, 1, 2, 3, 4, 9, 8, 7, 255, 0, 0, 0, 0, 5, 6, 7, 128, 5, 6, 7, 127};
  for (const bool runs : {false, true}) {
    const PictureRows rows{.width = 3,
                           .height = 2,
                           .make =
                               [&](int y, std::span<std::uint8_t> row) {
                                 std::ranges::copy(std::span(rgba).subspan(12 * static_cast<std::size_t>(y), 12),
                                                   row.begin());
                               },
                           .channels = 4,
                           .runs = runs};
    for (const char* name : {"a.png", "a.tga", "a.bmp"}) {
      EXPECT_EQ(write_picture(path(name), rows), "") << name;
      std::string error;
      const Picture picture = read_image(path(name), error);
      EXPECT_EQ(error, "");
      EXPECT_EQ(picture.alpha, (std::vector<std::uint8_t>{4, 4, 255, 0, 128, 127})) << name;
      EXPECT_EQ(picture.rgb, (std::vector<std::uint8_t>{1, 2, 3, 1, 2, 3, 9, 8, 7, 0, 0, 0, 5, 6, 7, 5, 6, 7})) << name;
    }
  }
}

TEST(RowEncoder, RaisesAlphaWhereSomethingClearIsBright) {
  const std::array pixels{PixelColor(Rgb(0.25f), 0.75f), PixelColor(Rgb(0.5f), 0.75f), PixelColor(Rgb(0.0f), 1.0f)};
  std::array<std::uint8_t, 12> bytes{};
  RowEncoder(Encoding::as_is(), {.alpha = true}, 3).encode(0, pixels, bytes);
  EXPECT_EQ(bytes, (std::array<std::uint8_t, 12>{255, 255, 255, 64, 255, 255, 255, 128, 0, 0, 0, 0}));
}

TEST(RowEncoder, NotANumberIsNotHandedOn) {
  std::array<Rgb, 4> row{Rgb(0.5f), Rgb(std::numeric_limits<float>::quiet_NaN()), Rgb(0.5f), Rgb(0.5f)};
  std::array<std::uint8_t, 12> bytes{};
  RowEncoder encoder(Encoding::as_is(), {.dithering = Dithering::floyd_steinberg}, 4);
  for (int y = 0; y < 3; ++y) {
    encoder.encode(y, row, bytes);
    EXPECT_EQ(bytes[3], 0);
    EXPECT_NEAR(bytes[6], 128, 1);
    EXPECT_NEAR(bytes[9], 128, 1);
  }
}

TEST_F(ImageFile, SamePictureIsTheSameBytes) {
  ASSERT_EQ(write_picture(path("a.png"), example()), "");
  ASSERT_EQ(write_picture(path("b.png"), example()), "");
  EXPECT_EQ(bytes_of(path("a.png")), bytes_of(path("b.png")));
}

TEST_F(ImageFile, PngSaysThatItIsSrgb) {
  ASSERT_EQ(write_png(path("a.png"), 3, 2, example().rgb), "");
  const std::string bytes = bytes_of(path("a.png"));
  EXPECT_NE(bytes.find("sRGB"), std::string::npos);
  EXPECT_NE(bytes.find("gAMA"), std::string::npos);
}

TEST_F(ImageFile, JpegIsNearlyThePicture) {
  const Picture grey{16, 16, std::vector<std::uint8_t>(16 * 16 * 3, 100)};
  ASSERT_EQ(write_picture(path("a.jpg"), grey), "");
  std::string error;
  const auto difference = compare(grey, read_image(path("a.jpg"), error), 2);
  ASSERT_TRUE(difference) << error;
  EXPECT_EQ(difference->share_within, 1.0);
}

TEST_F(ImageFile, LightIsKeptInFormatsOfLight) {
  const std::vector<float> light = {0.25f, 0.5f, 4.0f};
  for (const char* name : {"a.exr", "a.hdr"}) {
    EXPECT_TRUE(holds_light(name));
    EXPECT_EQ(write_light(path(name), 1, 1, light), "") << name;
    EXPECT_NE(write_picture(path(name), example()), "") << name;
  }
  EXPECT_FALSE(holds_light("a.png"));
  EXPECT_NE(write_light(path("a.png"), 1, 1, light), "");
  EXPECT_EQ(files(), 2u);
}

TEST_F(ImageFile, GivenFormatRulesOverTheExtension) {
  ASSERT_EQ(write_picture(path("picture"), example(), "png"), "");
  EXPECT_EQ(bytes_of(path("picture")).substr(1, 3), "PNG");
}

TEST_F(ImageFile, ReplacesAnOlderPicture) {
  std::ofstream(path("a.png")) << "old";
  ASSERT_EQ(write_picture(path("a.png"), example()), "");
  std::string error;
  EXPECT_EQ(read_image(path("a.png"), error), example());
  EXPECT_EQ(files(), 1u);
}

TEST_F(ImageFile, WritesThroughALink) {
  std::ofstream(path("target.png")) << "old";
  fs::create_symlink("target.png", path("link.png"));
  ASSERT_EQ(write_picture(path("link.png"), example()), "");
  EXPECT_TRUE(fs::is_symlink(path("link.png")));
  std::string error;
  EXPECT_EQ(read_image(path("target.png"), error), example());
}

TEST_F(ImageFile, MissingFolderIsNamed) {
  const std::string error = write_picture(path("no/such/a.png"), example());
  EXPECT_NE(error.find("there is no folder '" + path("no/such") + "'"), std::string::npos) << error;
  EXPECT_EQ(files(), 0u);
}

TEST_F(ImageFile, RefusesFoldersUnknownFormatsAndEmptyPictures) {
  fs::create_directory(path("folder.png"));
  EXPECT_NE(write_picture(path("folder.png"), example()).find("that is a folder"), std::string::npos);
  EXPECT_NE(write_picture(path("a.xyz"), example()).find("format is not known"), std::string::npos);
  EXPECT_NE(write_picture(path("a"), example()).find("format is not known"), std::string::npos);
  EXPECT_NE(write_picture(path("a.png"), Picture()).find("no pixels"), std::string::npos);
  EXPECT_NE(write_picture("", example(), "png"), "");
  EXPECT_EQ(files(), 1u);
}

TEST_F(ImageFile, FolderThatCannotBeWrittenLeavesNothingBehind) {
  fs::create_directory(path("locked"));
  fs::permissions(path("locked"), fs::perms::owner_read | fs::perms::owner_exec);
  if (::access(path("locked").c_str(), W_OK) == 0) GTEST_SKIP() << "this user may write everywhere";
  EXPECT_EQ(write_picture(path("locked/a.png"), example()),
            "cannot write '" + path("locked/a.png") + "': Permission denied");
  EXPECT_TRUE(fs::is_empty(path("locked")));
}

TEST_F(ImageFile, DevicesAreWrittenToAndStay) {
  EXPECT_EQ(write_picture("/dev/null", example(), "ppm"), "");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(ImageFile, FullDeviceIsAnError) {
  EXPECT_EQ(write_picture("/dev/full", example(), "png"), "cannot write '/dev/full': No space left on device");
}

TEST_F(ImageFile, UnreadablePicturesAreErrors) {
  std::string error;
  EXPECT_EQ(read_image(path("none.png"), error), Picture());
  EXPECT_NE(error.find("there is no such file"), std::string::npos);
  std::ofstream(path("text.png")) << "this is no picture";
  EXPECT_EQ(read_image(path("text.png"), error), Picture());
  EXPECT_NE(error.find("cannot read"), std::string::npos);
  EXPECT_EQ(read_image(folder_.string(), error), Picture());
  EXPECT_NE(error, "");
}

TEST_F(ImageFile, CutOffPictureIsAnErrorOrAWholePicture) {
  for (const char* name : {"a.ppm", "a.tga", "a.bmp"}) {
    ASSERT_EQ(write_picture(path(name), example()), "");
    fs::resize_file(path(name), fs::file_size(path(name)) - 20);
    std::string error;
    const Picture picture = read_image(path(name), error);
    EXPECT_TRUE(error.empty() ? picture.rgb.size() == 18 : picture.rgb.empty()) << name << " " << error;
  }
}

TEST(Compare, EqualPicturesAgreeCompletely) {
  const auto difference = compare(example(), example(), 0);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->share_within, 1.0);
  EXPECT_EQ(difference->worst, 0);
  EXPECT_EQ(difference->psnr, HUGE_VAL);
}

TEST(Compare, FindsTheShareAndTheWorstPixel) {
  Picture other = example();
  other.rgb[0] = 2;     // pixel (0, 0): by 2
  other.rgb[16] -= 10;  // pixel (2, 1): by 10
  const auto difference = compare(example(), other, 2);
  ASSERT_TRUE(difference);
  EXPECT_DOUBLE_EQ(difference->share_within, 5.0 / 6.0);
  EXPECT_EQ(difference->worst, 10);
  EXPECT_EQ(difference->worst_x, 2);
  EXPECT_EQ(difference->worst_y, 1);
  EXPECT_NEAR(difference->psnr, 10.0 * std::log10(255.0 * 255.0 * 18.0 / 104.0), 1e-9);
  EXPECT_EQ(summary(*difference, 2), "83.33 % of pixels within 2/255, worst 10 at (2, 1), 40.5 dB");
}

TEST(Compare, PicturesOfDifferentSizesCannotBeCompared) {
  EXPECT_FALSE(compare(example(), Picture{2, 3, example().rgb}, 255));
}

}  // namespace
}  // namespace firstlight::render
