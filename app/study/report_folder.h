#pragma once

#include "app/study/study.h"
#include "render/image/encode.h"
#include "render/math/color.h"

#include <span>
#include <string>
#include <utility>

namespace firstlight::app {

/// Where a report is written: the page, the CSV files, and the pictures of moments in full size.
class ReportFolder {
 public:
  ReportFolder(std::string path, int width, int height, const render::Encoding& encoding)
      : path_(std::move(path)), width_(width), height_(height), encoding_(encoding) {}

  /// Makes the folder where it is missing. Empty, or what is wrong.
  std::string prepare() const;
  /// Writes a picture of a scheme's moment (`number` 0 is the first scheme) and returns a small one as the bytes of a
  /// PNG file. The first failure is kept for error().
  std::string keep_picture(std::size_t number, const std::string& scheme, double share,
                           std::span<const render::Rgb> colors);
  /// Writes the page and the CSV files. Empty, or what is wrong.
  std::string write(const Study& study) const;

  std::string page() const;
  const std::string& error() const { return error_; }

 private:
  std::string path_;
  int width_;
  int height_;
  render::Encoding encoding_;
  std::string error_;
};

/// "02-contribution-5": the part of a file's name that tells scheme and moment, of letters, digits, dots and hyphens.
std::string picture_name(std::size_t number, const std::string& scheme, double share);

}  // namespace firstlight::app
