#include "render/image/file_formats.h"

#include <turbojpeg.h>

#include <array>
#include <limits>
#include <memory>
#include <string_view>

namespace firstlight::render {
namespace {

constexpr int kQuality = 85;  // POV-Ray's, with colours as fine as brightness

/// An application segment that says the colours are sRGB's, in the words of Exif 2.3: a TIFF file, of the least kind,
/// whose directory points to another with the version and the colour space.
constexpr std::array<std::uint8_t, 66> kSaysSrgb = {
    0xff, 0xe1, 0,    64,   'E', 'x', 'i', 'f', 0,   0,                                // marker, length, name
    'I',  'I',  42,   0,    8,   0,   0,   0,                                          // little endian, directory at 8
    1,    0,    0x69, 0x87, 4,   0,   1,   0,   0,   0,   26,  0,   0, 0, 0, 0, 0, 0,  // the other, at 26
    2,    0,                                                                           // two entries
    0,    0x90, 7,    0,    4,   0,   0,   0,   '0', '2', '3', '0',                    // version
    1,    0xa0, 3,    0,    1,   0,   0,   0,   1,   0,   0,   0,                      // colour space: 1, sRGB
    0,    0,    0,    0};

struct Destroy {
  void operator()(void* handle) const { tjDestroy(handle); }
  void operator()(unsigned char* bytes) const { tjFree(bytes); }
};
using Handle = std::unique_ptr<void, Destroy>;

[[noreturn]] void fail(const Handle& handle) { throw BrokenPicture(tjGetErrorStr2(handle.get())); }

/// Turns a printer's inks, whose samples are stored turned round (0 is all of the ink), into red green blue.
Raster::Bytes from_inks(const Raster::Bytes& inks) {
  Raster::Bytes rgb;
  rgb.reserve(inks.size() / 4 * 3);
  for (std::size_t i = 0; i < inks.size(); i += 4) {
    for (std::size_t c = 0; c < 3; ++c) {
      rgb.push_back(static_cast<std::uint8_t>((inks[i + c] * inks[i + 3] + 127) / 255));
    }
  }
  return rgb;
}

}  // namespace

bool is_jpeg(FileBytes file) { return file.size() >= 3 && file[0] == 0xff && file[1] == 0xd8 && file[2] == 0xff; }

Raster read_jpeg(FileBytes file) {
  const Handle handle(tjInitDecompress());
  if (!handle) throw std::bad_alloc();
  Raster raster;
  int subsampling = 0;
  int space = 0;
  if (tjDecompressHeader3(handle.get(), file.data(), file.size(), &raster.width, &raster.height, &subsampling,
                          &space) != 0) {
    fail(handle);
  }
  // A block of 64 pixels takes at least one bit.
  check_size(raster.width, raster.height, file.size(), 64 * 8);
  const bool grey = space == TJCS_GRAY;
  const bool inks = space == TJCS_CMYK || space == TJCS_YCCK;
  raster.channels = grey ? 1 : 3;
  const int format = grey ? TJPF_GRAY : inks ? TJPF_CMYK : TJPF_RGB;
  Raster::Bytes samples(static_cast<std::size_t>(raster.width) * static_cast<std::size_t>(raster.height) *
                        static_cast<std::size_t>(tjPixelSize[format]));
  if (tjDecompress2(handle.get(), file.data(), file.size(), samples.data(), 0, 0, 0, format,
                    TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS) != 0) {
    // A mere warning comes with a picture, unless the rest of it is missing.
    const bool cut = std::string_view(tjGetErrorStr2(handle.get())).find("remature end") != std::string_view::npos;
    if (cut) throw BrokenPicture(kEndsTooEarly);
    if (tjGetErrorCode(handle.get()) != TJERR_WARNING) fail(handle);
  }
  raster.samples = inks ? from_inks(samples) : std::move(samples);
  return raster;
}

void make_jpeg(const PictureRows& picture, const PutBytes& put) {
  const std::vector<std::uint8_t> rgb = whole(picture);
  const Handle handle(tjInitCompress());
  if (!handle) throw std::bad_alloc();
  unsigned char* data = nullptr;
  unsigned long size = 0;
  const int failed = tjCompress2(handle.get(), rgb.data(), picture.width, 0, picture.height, TJPF_RGB, &data, &size,
                                 TJSAMP_444, picture.quality > 1 ? picture.quality : kQuality, TJFLAG_ACCURATEDCT);
  const std::unique_ptr<unsigned char, Destroy> owner(data);
  if (failed != 0) fail(handle);
  // It begins with its mark and the JFIF segment, of 2 and 18 bytes; what says more comes then.
  constexpr std::size_t kStart = 20;
  const FileBytes bytes(data, size);
  put(bytes.first(kStart));
  put(kSaysSrgb);
  put(bytes.subspan(kStart));
}

}  // namespace firstlight::render
