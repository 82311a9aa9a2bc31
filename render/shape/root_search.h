#pragma once

#include "render/math/columns.h"
#include "render/shape/ray_field.h"

#include <array>
#include <cstdint>
#include <vector>

namespace firstlight::render {

/// Where roots of the fields along some rays are searched.
struct SearchedPart {
  Column<double> begin;
  Column<double> at_begin;  ///< the field there
  Column<double> end;
  Column<double> at_end;
  Column<double> high;      ///< what begins beyond need not be searched
  Column<double> speed;     ///< the length of the ray's direction
  Column<double> gradient;  ///< which the field is taken to have at most
};

/// Finds where fields along rays first fall below 0, by POV-Ray's rule: stretches of a ray are halved, the nearer half
/// first, but those whose ends are too far above 0 for the gradient; the answer is the end of the first that is shorter
/// than `accuracy` and ends below 0. A gradient that is too small so leaves the holes that it leaves there.
///
/// Order    The rays are searched together: in each round, all halve the stretches that they must look at anyway,
///          and the field is asked for all of these at once. A ray's answer is the same in any company.
/// Threads  One search at a time a thread.
class RootSearch {
 public:
  RootSearch(const RayFields& fields, double accuracy) : fields_(fields), accuracy_(accuracy) {}

  /// Finds the first root of each ray in `who`; the bits of those that have one. None that lies in a stretch beyond
  /// `high`.
  std::uint64_t first(std::uint64_t who, const SearchedPart& part, Column<double>& root) const;

 private:
  class Rounds;

  const RayFields& fields_;
  double accuracy_;
};

/// The same where the gradient is found on the way [POV-Ray 3.7, `evaluate`]: before each search it shrinks by the
/// third number if it is above the first; it grows where it is less than the second number times one that is met, to
/// the second number's square times that.
class LearningSearch {
 public:
  LearningSearch(const RayFields& fields, double accuracy, const std::array<double, 3>& evaluate)
      : fields_(fields), accuracy_(accuracy), evaluate_(evaluate) {}

  /// `part` gets the gradients that were found.
  std::uint64_t first(std::uint64_t who, SearchedPart& part, Column<double>& root);
  int evaluations() const { return evaluations_; }  ///< so far, of all rays

 private:
  struct Stretch {
    double begin;
    double at_begin;
    double end;
    double at_end;
    double length;  ///< halved from one to the next, not the difference of the ends
    double climb;   ///< how much the field may change along it, at most
  };
  enum class Next : std::uint8_t { halve, found, nothing };

  Next look(std::size_t ray, SearchedPart& part, std::vector<Stretch>& waiting) const;

  const RayFields& fields_;
  double accuracy_;
  std::array<double, 3> evaluate_;
  int evaluations_ = 0;
};

}  // namespace firstlight::render
