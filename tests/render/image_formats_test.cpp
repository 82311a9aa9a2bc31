#include "render/image/file_formats.h"
#include "render/image/image_io.h"

#include <gtest/gtest.h>
#include <turbojpeg.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace firstlight::render {
namespace {

namespace fs = std::filesystem;
using namespace std::string_literals;
using Bytes = Raster::Bytes;
using Words = Raster::Words;

FileBytes view(const std::string& file) { return {reinterpret_cast<const std::uint8_t*>(file.data()), file.size()}; }

// ---- PNG files, put together chunk by chunk ------------------------------------------------------------------------

std::string big_endian(std::uint32_t number) {
  std::string out;
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<char>(number >> shift & 255));
  return out;
}

std::string chunk(const std::string& name, const std::string& data) {
  const std::string body = name + data;
  const auto check = ::crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return big_endian(static_cast<std::uint32_t>(data.size())) + body + big_endian(static_cast<std::uint32_t>(check));
}

enum PngType { kGrey = 0, kColor = 2, kIndexed = 3, kGreyAlpha = 4, kColorAlpha = 6 };

std::string png_header(int width, int height, int depth, PngType type, bool interlaced = false) {
  const std::string rest = {static_cast<char>(depth), static_cast<char>(type), 0, 0, interlaced ? '\1' : '\0'};
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", big_endian(static_cast<std::uint32_t>(width)) +
                                                 big_endian(static_cast<std::uint32_t>(height)) + rest);
}

/// `rows`: each with its filter byte before it. `extra`: chunks before the pixels.
std::string png(const std::string& header, const std::string& rows, const std::string& extra = "") {
  std::string packed(::compressBound(static_cast<uLong>(rows.size())), '\0');
  uLongf size = packed.size();
  ::compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(rows.data()),
             static_cast<uLong>(rows.size()));
  packed.resize(size);
  return header + extra + chunk("IDAT", packed) + chunk("IEND", "");
}

TEST(Png, GreyOfFewBitsIsSpreadToEight) {
  const Raster one = read_png(view(png(png_header(3, 2, 1, kGrey), "\0\xa0\0\x40"s)));
  EXPECT_EQ(one.channels, 1);
  EXPECT_EQ(one.white, 255);
  EXPECT_EQ(std::get<Bytes>(one.samples), (Bytes{255, 0, 255, 0, 255, 0}));
  const Raster two = read_png(view(png(png_header(4, 1, 2, kGrey), "\0\x1b"s)));
  EXPECT_EQ(std::get<Bytes>(two.samples), (Bytes{0, 85, 170, 255}));
  const Raster four = read_png(view(png(png_header(2, 1, 4, kGrey), "\0\x3f"s)));
  EXPECT_EQ(std::get<Bytes>(four.samples), (Bytes{51, 255}));
  EXPECT_EQ(one.gamma, FileGamma());
}

TEST(Png, SixteenBitsStay) {
  const Raster grey = read_png(view(png(png_header(2, 1, 16, kGrey), "\0\x12\x34\xff\xff"s)));
  EXPECT_EQ(grey.white, 65535);
  EXPECT_EQ(std::get<Words>(grey.samples), (Words{0x1234, 0xffff}));
  EXPECT_DOUBLE_EQ(grey.value(0), 0x1234 / 65535.0);
  EXPECT_EQ(to_picture(grey).rgb, (Bytes{18, 18, 18, 255, 255, 255}));  // 4660 / 257 = 18.1
  const Raster color = read_png(view(png(png_header(1, 1, 16, kColorAlpha), "\0\0\1\0\2\0\3\0\4"s)));
  EXPECT_EQ(color.channels, 4);
  EXPECT_EQ(std::get<Words>(color.samples), (Words{1, 2, 3, 4}));
}

TEST(Png, AlphaAndATransparentColourAreChannels) {
  const Raster grey = read_png(view(png(png_header(2, 1, 8, kGreyAlpha), "\0\x0a\x14\x1e\x28"s)));
  EXPECT_EQ(grey.channels, 2);
  EXPECT_EQ(std::get<Bytes>(grey.samples), (Bytes{10, 20, 30, 40}));
  EXPECT_EQ(to_picture(grey).rgb, (Bytes{10, 10, 10, 30, 30, 30}));
  const std::string clear = chunk("tRNS", "\0\1\0\2\0\3"s);
  const Raster color = read_png(view(png(png_header(2, 1, 8, kColor), "\0\1\2\3\4\5\6"s, clear)));
  EXPECT_EQ(color.channels, 4);
  EXPECT_EQ(std::get<Bytes>(color.samples), (Bytes{1, 2, 3, 0, 4, 5, 6, 255}));
  EXPECT_EQ(to_picture(color).rgb, (Bytes{1, 2, 3, 4, 5, 6}));
}

TEST(Png, PaletteIsKeptOrResolved) {
  const std::string palette = chunk("PLTE", "\1\2\3\4\5\6\7\x08\x09"s);
  Raster raster = read_png(view(png(png_header(3, 1, 2, kIndexed), "\0\x84"s, palette)));
  EXPECT_EQ(std::get<Bytes>(raster.samples), (Bytes{2, 0, 1}));
  EXPECT_EQ(raster.palette, (std::vector<Raster::Color>{{1, 2, 3, 255}, {4, 5, 6, 255}, {7, 8, 9, 255}}));
  resolve_palette(raster);
  EXPECT_EQ(raster.channels, 3);
  EXPECT_EQ(std::get<Bytes>(raster.samples), (Bytes{7, 8, 9, 1, 2, 3, 4, 5, 6}));

  Raster clear = read_png(view(png(png_header(2, 1, 8, kIndexed), "\0\0\1"s, palette + chunk("tRNS", "\x40"))));
  EXPECT_EQ(clear.palette[0], (Raster::Color{1, 2, 3, 64}));
  resolve_palette(clear);
  EXPECT_EQ(std::get<Bytes>(clear.samples), (Bytes{1, 2, 3, 64, 4, 5, 6, 255}));
}

TEST(Png, InterlacedPixelsComeToTheirPlaces) {
  // The 3 x 2 pixels are in Adam7's order: the first, the third and the second of row 0, then row 1.
  const Raster raster = read_png(view(png(png_header(3, 2, 8, kGrey, true), "\0\x0a\0\x1e\0\x14\0\x28\x32\x3c"s)));
  EXPECT_EQ(std::get<Bytes>(raster.samples), (Bytes{10, 20, 30, 40, 50, 60}));
}

TEST(Png, TellsItsGamma) {
  const std::string header = png_header(1, 1, 8, kGrey);
  const Raster power = read_png(view(png(header, "\0\1"s, chunk("gAMA", big_endian(50000)))));
  EXPECT_EQ(power.gamma, (FileGamma{FileGamma::Curve::power, 2.0}));
  const Raster srgb = read_png(view(png(header, "\0\1"s, chunk("gAMA", big_endian(45455)) + chunk("sRGB", "\0"s))));
  EXPECT_EQ(srgb.gamma.curve, FileGamma::Curve::srgb);
}

TEST(Png, BrokenFilesAreErrors) {
  const std::string whole = png(png_header(3, 2, 8, kGrey), "\0\1\2\3\0\4\5\6"s);
  for (std::size_t size = 8; size < whole.size(); ++size) {
    const std::string cut = whole.substr(0, size);
    ASSERT_TRUE(is_png(view(cut)));
    EXPECT_THROW(read_png(view(cut)), BrokenPicture) << size;
  }
  std::string damaged = whole;
  damaged[whole.find("IDAT") + 6] ^= 0x55;
  EXPECT_THROW(read_png(view(damaged)), BrokenPicture);
  EXPECT_THROW(read_png(view(png(png_header(0, 2, 8, kGrey), "\0\1"s))), BrokenPicture);
  EXPECT_THROW(read_png(view(png(png_header(30000, 30000, 8, kGrey), "\0\1"s))), BrokenPicture);
  EXPECT_THROW(read_png(view(png(png_header(16000, 16000, 16, kColorAlpha), "\0\1"s))), BrokenPicture);
  EXPECT_THROW(read_png(view(png(png_header(1, 1, 8, kIndexed), "\0\0"s))), BrokenPicture) << "no palette";
  EXPECT_THROW(read_png(view(png(png_header(1, 1, 8, kIndexed), "\0\5"s, chunk("PLTE", "\1\2\3")))), BrokenPicture);
}

// ---- JPEG ----------------------------------------------------------------------------------------------------------

std::string jpeg(const Bytes& pixels, int width, int height, int format, int subsampling) {
  const tjhandle handle = tjInitCompress();
  unsigned char* data = nullptr;
  unsigned long size = 0;
  EXPECT_EQ(
      tjCompress2(handle, pixels.data(), width, 0, height, format, &data, &size, subsampling, 100, TJFLAG_ACCURATEDCT),
      0);
  std::string file(reinterpret_cast<const char*>(data), size);
  tjFree(data);
  tjDestroy(handle);
  return file;
}

TEST(Jpeg, GreyColourAndInksAreRead) {
  const Raster grey = read_jpeg(view(jpeg(Bytes(64, 77), 8, 8, TJPF_GRAY, TJSAMP_GRAY)));
  EXPECT_EQ(grey.channels, 1);
  EXPECT_EQ(std::get<Bytes>(grey.samples), Bytes(64, 77));
  EXPECT_EQ(to_picture(grey).rgb, Bytes(192, 77));
  Bytes red;
  for (int i = 0; i < 9 * 7; ++i) red.insert(red.end(), {200, 60, 20});
  const Raster color = read_jpeg(view(jpeg(red, 9, 7, TJPF_RGB, TJSAMP_444)));
  EXPECT_EQ(color.channels, 3);
  for (std::size_t i = 0; i < red.size(); ++i) EXPECT_NEAR(std::get<Bytes>(color.samples)[i], red[i], 1);
  Bytes inks;
  for (int i = 0; i < 64; ++i) inks.insert(inks.end(), {255, 128, 0, 200});
  const Raster printed = read_jpeg(view(jpeg(inks, 8, 8, TJPF_CMYK, TJSAMP_444)));
  EXPECT_EQ(printed.channels, 3);
  const std::array<int, 3> expected = {200, 100, 0};
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(std::get<Bytes>(printed.samples)[c], expected[c], 2);
}

TEST(Jpeg, BrokenFilesAreErrorsOrWholePictures) {
  Bytes pixels;
  for (int i = 0; i < 40 * 40 * 3; ++i) pixels.push_back(static_cast<std::uint8_t>(i * i));
  const std::string whole = jpeg(pixels, 40, 40, TJPF_RGB, TJSAMP_420);
  for (std::size_t size = 3; size + 2 < whole.size(); size += 1 + size / 20) {
    EXPECT_THROW(read_jpeg(view(whole.substr(0, size))), BrokenPicture) << size;
  }
  for (std::size_t at = 2; at < whole.size(); at += 3) {
    std::string damaged = whole;
    damaged[at] ^= 0x2a;
    try {
      const Raster raster = read_jpeg(view(damaged));
      EXPECT_EQ(std::get<Bytes>(raster.samples).size(),
                static_cast<std::size_t>(raster.width * raster.height * raster.channels));
    } catch (const BrokenPicture&) {
    }
  }
  std::string enormous = whole;  // the size it claims: 16000 x 16000
  const std::size_t frame = whole.find("\xff\xc0");
  for (const std::size_t at : {frame + 5, frame + 7}) enormous.replace(at, 2, "\x3e\x80");
  EXPECT_THROW(read_jpeg(view(enormous)), BrokenPicture);
}

TEST(Jpeg, WrittenOnesSayThatTheyAreSrgb) {
  const Bytes rgb(8 * 8 * 3, 50);
  Bytes file;
  make_jpeg(rows_of(8, 8, rgb), [&](FileBytes part) { file.insert(file.end(), part.begin(), part.end()); });
  const std::string text(file.begin(), file.end());
  EXPECT_EQ(text.substr(6, 4), "JFIF");
  EXPECT_EQ(text.substr(24, 4), "Exif");
  EXPECT_EQ(std::get<Bytes>(read_jpeg(file).samples), rgb);
}

// ---- PNM -----------------------------------------------------------------------------------------------------------

TEST(Pnm, TextIsRead) {
  const Raster bits = read_pnm(view("P1 # a bitmap\n3 2\n101 0 1\n# and more\n0\n"));
  EXPECT_EQ(bits.white, 1);
  EXPECT_EQ(std::get<Bytes>(bits.samples), (Bytes{0, 1, 0, 1, 0, 1}));
  EXPECT_EQ(to_picture(bits).rgb, (Bytes{0, 0, 0, 255, 255, 255, 0, 0, 0, 255, 255, 255, 0, 0, 0, 255, 255, 255}));
  const Raster grey = read_pnm(view("P2 2 1 100 50 100"));
  EXPECT_EQ(grey.white, 100);
  EXPECT_DOUBLE_EQ(grey.value(0), 0.5);
  EXPECT_EQ(to_picture(grey).rgb, (Bytes{128, 128, 128, 255, 255, 255}));
  const Raster color = read_pnm(view("P3#c\n1 1#c\n65535 1 2 65535"));
  EXPECT_EQ(color.channels, 3);
  EXPECT_EQ(std::get<Words>(color.samples), (Words{1, 2, 65535}));
}

TEST(Pnm, BinaryIsRead) {
  const Raster bits = read_pnm(view("P4\n10 2\n\xaa\x80\x55\x40"s));
  EXPECT_EQ(std::get<Bytes>(bits.samples), (Bytes{0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0}));
  const Raster grey = read_pnm(view("P5\n2 1\n255\n\n\x80"s));  // the first pixel is what would be white space
  EXPECT_EQ(std::get<Bytes>(grey.samples), (Bytes{10, 128}));
  const Raster words = read_pnm(view("P6 1 1 1000 \1\2\0\3\x0f\xff"s));
  EXPECT_EQ(words.white, 1000);
  EXPECT_EQ(std::get<Words>(words.samples), (Words{258, 3, 1000})) << "what is above the greatest number is that";
}

TEST(Pnm, BrokenFilesAreErrors) {
  for (const std::string& file : {"P6"s,
                                  "P6 "s,
                                  "P6 2"s,
                                  "P6 2 2 255"s,
                                  "P6 2 2 255\nabc"s,
                                  "P6 0 2 255\nabc"s,
                                  "P6 -1 2 255\nabc"s,
                                  "P5 1 1 0 a"s,
                                  "P5 1 1 65536 aaa"s,
                                  "P5 99999999999999999999 1 255 a"s,
                                  "P5 16000 16000 255 a"s,
                                  "P5 30000 30000 255 a"s,
                                  "P4 100000 100 a"s,
                                  "P2 2 1 255 7"s,
                                  "P2 2 1 255 7 x"s,
                                  "P2 2 1 9 7 10"s,
                                  "P1 2 1 1 2"s,
                                  "P1 2 1 1"s,
                                  "P3 1 1 255 1 2"s,
                                  "P2 # no end"s,
                                  "P5 2 1 300 aaa"s}) {
    EXPECT_THROW(read_pnm(view(file)), BrokenPicture) << file;
  }
}

// ---- TGA -----------------------------------------------------------------------------------------------------------

struct Tga {
  int kind = 2;
  int width = 2, height = 2;
  int bits = 24;
  int descriptor = 0;
  int palette_first = 0, palette_length = 0, palette_bits = 0;
  std::string id = {};

  std::string file(const std::string& data) const {
    std::string out;
    for (const int byte :
         {static_cast<int>(id.size()), palette_length > 0 ? 1 : 0, kind, palette_first, 0, palette_length, 0,
          palette_bits, 0, 0, 0, 0, width & 255, width >> 8, height & 255, height >> 8, bits, descriptor}) {
      out.push_back(static_cast<char>(byte));
    }
    return out + id + data;
  }
};

TEST(Tga, AllFourOrientationsAreRead) {
  const auto read = [](int descriptor) {
    const std::string file = Tga{.kind = 3, .bits = 8, .descriptor = descriptor}.file("\1\2\3\4");
    EXPECT_TRUE(is_tga(view(file)));
    return std::get<Bytes>(read_tga(view(file)).samples);
  };
  EXPECT_EQ(read(0x00), (Bytes{3, 4, 1, 2}));
  EXPECT_EQ(read(0x10), (Bytes{4, 3, 2, 1}));
  EXPECT_EQ(read(0x20), (Bytes{1, 2, 3, 4}));
  EXPECT_EQ(read(0x30), (Bytes{2, 1, 4, 3}));
}

TEST(Tga, DepthsAndChannelsAreRead) {
  const Tga row{.height = 1, .id = "a name"};
  const auto read = [&](int kind, int bits, const std::string& data) {
    Tga tga = row;
    tga.kind = kind;
    tga.bits = bits;
    return read_tga(view(tga.file(data)));
  };
  EXPECT_EQ(std::get<Bytes>(read(2, 24, "\3\2\1\6\5\4").samples), (Bytes{1, 2, 3, 4, 5, 6}));
  const Raster alpha = read(2, 32, "\3\2\1\x09\6\5\4\x08");
  EXPECT_EQ(alpha.channels, 4);
  EXPECT_EQ(std::get<Bytes>(alpha.samples), (Bytes{1, 2, 3, 9, 4, 5, 6, 8}));
  const Raster fives = read(2, 15, "\x3f\x7c\x20\0"s);
  EXPECT_EQ(fives.white, 31);
  EXPECT_EQ(fives.channels, 3);
  EXPECT_EQ(std::get<Bytes>(fives.samples), (Bytes{31, 1, 31, 0, 1, 0}));
  EXPECT_EQ(std::get<Bytes>(read(2, 16, "\x3f\xfc\x20\0"s).samples), (Bytes{31, 1, 31, 31, 0, 1, 0, 0}));
  const Raster grey = read(3, 16, "\1\2\3\4");
  EXPECT_EQ(grey.channels, 2);
  EXPECT_EQ(std::get<Bytes>(grey.samples), (Bytes{1, 2, 3, 4}));
}

TEST(Tga, RunsMayCrossRows) {
  const Tga tga{.kind = 10, .width = 3, .height = 2, .descriptor = 0x20};
  const Raster raster = read_tga(view(tga.file("\x83\3\2\1\1\6\5\4\x09\x08\7"s)));
  EXPECT_EQ(std::get<Bytes>(raster.samples), (Bytes{1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST(Tga, PalettesAreKept) {
  const Tga tga{.kind = 1, .width = 3, .height = 1, .bits = 8, .palette_length = 2, .palette_bits = 24};
  const Raster raster = read_tga(view(tga.file("\3\2\1\6\5\4\0\1\0"s)));
  EXPECT_EQ(raster.palette, (std::vector<Raster::Color>{{1, 2, 3, 255}, {4, 5, 6, 255}}));
  EXPECT_EQ(std::get<Words>(raster.samples), (Words{0, 1, 0}));
  Tga later = tga;  // its palette begins at the colour 10
  later.palette_first = 10;
  later.palette_bits = 16;
  later.kind = 9;
  Raster runs = read_tga(view(later.file("\x1f\x80\0\x7c\x80\x0b\1\x0a\x0b"s)));
  EXPECT_EQ(runs.palette, (std::vector<Raster::Color>{{0, 0, 255, 255}, {255, 0, 0, 0}}));
  resolve_palette(runs);
  EXPECT_EQ(std::get<Bytes>(runs.samples), (Bytes{255, 0, 0, 0, 0, 0, 255, 255, 255, 0, 0, 0}));
}

TEST(Tga, BrokenFilesAreErrors) {
  const std::string whole = Tga{.kind = 10}.file("\x82\1\2\3\0\1\2\3"s);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THROW(read_tga(view(whole.substr(0, size))), BrokenPicture) << size;
  }
  EXPECT_EQ(std::get<Bytes>(read_tga(view(whole)).samples).size(), 12u);
  EXPECT_THROW(read_tga(view(Tga{.width = 0}.file("\1\2\3"))), BrokenPicture);
  EXPECT_THROW(read_tga(view(Tga{.kind = 4}.file("\1\2\3"))), BrokenPicture);
  EXPECT_THROW(read_tga(view(Tga{.kind = 10, .width = 65535, .height = 65535}.file("\xff\1\2\3"))), BrokenPicture);
  EXPECT_THROW(read_tga(view(Tga{.kind = 10, .width = 16000, .height = 16000}.file("\xff\1\2\3"))), BrokenPicture);
  EXPECT_THROW(read_tga(view(Tga{.kind = 1, .bits = 8}.file("\1\2\3\4"))), BrokenPicture) << "no palette";
  const Tga beyond{.kind = 1, .width = 1, .height = 1, .bits = 8, .palette_length = 1, .palette_bits = 24};
  EXPECT_THROW(read_tga(view(beyond.file("\1\2\3\1"))), BrokenPicture);
}

TEST(Tga, OtherFilesAreNotTakenForIt) {
  EXPECT_FALSE(is_tga(view("this is no picture, only some text")));
  EXPECT_FALSE(is_tga(view(std::string(100, '\0'))));
  EXPECT_FALSE(is_tga(view("\0\0\2\0\1\0\x20\x20\0\0\0\0\1\0\x20\0\x18\0 a cursor of Windows"s)));
  EXPECT_FALSE(is_tga(view("BM2\xe1\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\xa1\0\0\0"s)));
}

// ---- Through files -------------------------------------------------------------------------------------------------

class RasterFile : public ::testing::Test {
 protected:
  void TearDown() override { fs::remove(path_); }
  /// Reads `content` as a file whose name says nothing.
  Raster read(const std::string& content, Palette palette = Palette::resolve) {
    std::ofstream(path_, std::ios::binary) << content;
    return read_raster(path_, error_, palette);
  }

  std::string path_ = (fs::path(::testing::TempDir()) / ("firstlight_raster" + std::to_string(::getpid()))).string();
  std::string error_;
};

TEST_F(RasterFile, FormatIsToldByTheContent) {
  EXPECT_EQ(read("P2 1 1 255 7").white, 255);
  EXPECT_EQ(read(png(png_header(1, 1, 16, kGrey), "\0\1\2"s)).white, 65535);
  EXPECT_EQ(read(Tga{.bits = 15}.file("abcdefgh")).white, 31);
  EXPECT_EQ(read(jpeg(Bytes(64, 77), 8, 8, TJPF_GRAY, TJSAMP_GRAY)).channels, 1);
  EXPECT_EQ(error_, "");
}

TEST_F(RasterFile, PaletteIsSeenByThoseWhoAskForIt) {
  const std::string file = png(png_header(1, 1, 8, kIndexed), "\0\0"s, chunk("PLTE", "\1\2\3"));
  EXPECT_EQ(std::get<Bytes>(read(file).samples), (Bytes{1, 2, 3}));
  EXPECT_EQ(std::get<Bytes>(read(file, Palette::keep).samples), (Bytes{0}));
}

TEST_F(RasterFile, LightComesAsFloats) {
  const std::vector<float> light = {0.25f, 0.5f, 4.0f};
  ASSERT_EQ(write_light(path_, 1, 1, light, "exr"), "");
  const Raster raster = read_raster(path_, error_);
  EXPECT_EQ(error_, "");
  EXPECT_EQ(std::get<Raster::Floats>(raster.samples), light);
  EXPECT_EQ(raster.value(2), 4.0);
  EXPECT_EQ(raster.gamma, (FileGamma{FileGamma::Curve::power, 1.0}));
  EXPECT_EQ(to_picture(raster).rgb, (Bytes{64, 128, 255}));
}

const std::string kGif("GIF89a\1\0\1\0\x81\0\0\0\0\0Z\0\0\xb4\0\0\xff\0\0,\0\0\0\0\1\0\1\0\0\2\2\x4c\1\0;", 41);

TEST_F(RasterFile, GifHasIndicesAndAPalette) {
  std::ofstream(path_, std::ios::binary) << kGif;
  const Raster raster = read_raster(path_, error_, Palette::keep);
  EXPECT_EQ(error_, "");
  EXPECT_EQ(raster.width, 1);
  ASSERT_EQ(raster.palette.size(), 4u);
  EXPECT_EQ(raster.palette[1], (Raster::Color{90, 0, 0, 255}));
  EXPECT_EQ(std::get<Raster::Bytes>(raster.samples), Raster::Bytes{1});
  for (std::size_t size = 13; size + 2 < kGif.size(); ++size) {
    std::ofstream(path_, std::ios::binary) << kGif.substr(0, size);
    read_raster(path_, error_);
    EXPECT_NE(error_, "") << size;
  }
}

TEST_F(RasterFile, RadianceRowsArePlainOrPacked) {
  const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 8\n";
  const auto read_light = [&](const std::string& row) {
    std::ofstream(path_, std::ios::binary) << header << row;
    return read_raster(path_, error_);
  };
  const Raster packed = read_light(std::string("\2\2\0\x08", 4) + "\x88\x80" + "\x88\x40" + std::string("\x88\0", 2) + "\x88\x81");
  EXPECT_EQ(error_, "");
  ASSERT_EQ(std::get<Raster::Floats>(packed.samples).size(), 24u);
  EXPECT_FLOAT_EQ(static_cast<float>(packed.value(3)), 128.5f / 128.0f);
  EXPECT_FLOAT_EQ(static_cast<float>(packed.value(4)), 64.5f / 128.0f);
  const Raster plain = read_light(std::string("\x80\x40\0\x81", 4) + "\1\1\1\7");
  EXPECT_EQ(error_, "");
  EXPECT_EQ(std::get<Raster::Floats>(plain.samples), std::get<Raster::Floats>(packed.samples));
  read_light(std::string("\x80\x40\0\x81", 4) + "\1\1\1\x09");
  EXPECT_NE(error_, "");
}

TEST_F(RasterFile, BrokenFileIsNamed) {
  const Raster raster = read("P5 100 100 255\nabc");
  EXPECT_EQ(error_, "cannot read '" + path_ + "': the file ends too early");
  EXPECT_EQ(raster.width, 0);
  read("");
  EXPECT_NE(error_, "");
}

TEST_F(RasterFile, EnormousFileIsNotReadIntoMemory) {
  std::ofstream(path_) << "P6 1 1 255\n";
  fs::resize_file(path_, std::uintmax_t{1} << 32);
  read_raster(path_, error_);
  EXPECT_EQ(error_, "cannot read '" + path_ + "': it is too large for a picture");
}

}  // namespace
}  // namespace firstlight::render
