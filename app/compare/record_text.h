#pragma once

#include "app/compare/record.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace firstlight::app::compare {

/// A summary of several runs of a program, or of several ratios.
struct Spread {
  double median = 0.0;
  double least = 0.0;
  double most = 0.0;
};
/// Pre: not empty.
Spread spread_of(std::span<const double> values);

/// A measure of ProgramRun, as it is printed.
struct Measure {
  std::string_view label;  ///< "whole, wall"
  std::string_view name;   ///< of JSON: "wall_s"
  std::string_view unit;
  double scale;  ///< what a number is multiplied with for that unit
  double (*of)(const ProgramRun&);
};
std::span<const Measure> measures();

/// POV-Ray's number over ours, a number a round. What is compared is paired: a machine that is slower for a minute is
/// slower for both. Empty when a number of ours is 0.
std::vector<double> ratios(const SceneRecord& record, const Measure& measure);

/// "98.53 % of the pixels agree, PSNR 41.2 dB, worst pixel (12, 80): (1, 2, 3) against (1, 2, 34), 31 of 255 apart"
std::string summary(const PictureDifference& difference);

/// Some lines of numbers. `first` and `second` say whose colours are meant.
std::string to_text(const PictureDifference& difference, std::string_view first, std::string_view second);
/// A table of the times and memory of both programs; empty when one has not rendered.
std::string times_to_text(const SceneRecord& record);
/// The features that a scene lacks, a line each, with its place.
std::string to_text(std::span<const MissingFeature> missing);

/// Where the maps that were kept lie; empty when none were.
struct KeptMaps {
  std::string difference, flip;
};
/// The record as record_json.h has it, with the medians of the runs, the ratios and the maps. docs/compare.md has the keys.
std::string scene_json(const SceneRecord& record, const KeptMaps& kept);
/// The record of two pictures; nothing of `difference` when they could not be compared, `message` then says why.
std::string pictures_json(std::string_view first, std::string_view second, std::string_view status,
                          const PictureDifference* difference, std::string_view message, const KeptMaps& kept);

}  // namespace firstlight::app::compare
