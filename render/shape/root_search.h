#pragma once

#include "render/shape/ray_field.h"

#include <array>
#include <optional>
#include <vector>

namespace firstlight::render {

/// The gradient that a field is taken to have at most.
struct FieldGradient {
  double most;
  /// Null: it is given. Else it is found on the way [POV-Ray 3.7, `evaluate`]: before each search it shrinks by the third
  /// number if it is above the first; it grows where it is less than the second number times one that is met, to the
  /// second number's square times that.
  const std::array<double, 3>* evaluate = nullptr;
};

/// Finds where a field along a ray first falls below 0, by POV-Ray's rule: stretches of the ray are halved, the nearer half
/// first, but those whose ends are too far above 0 for the gradient; the answer is the end of the first that is shorter
/// than `accuracy` and ends below 0. A gradient that is too small so leaves the holes that it leaves there.
///
/// Order    Stretches that must be looked at anyway are halved together; that changes no answer.
/// Threads  One search at a time a thread.
class RootSearch {
 public:
  /// `speed`: the length of the ray's direction.
  RootSearch(const RayField& field, double speed, double accuracy, FieldGradient gradient)
      : field_(field), speed_(speed), accuracy_(accuracy), gradient_(gradient) {}

  const FieldGradient& gradient() const { return gradient_; }
  int evaluations() const { return evaluations_; }  ///< of the last search
  /// The first root between two depths, of which the field is known; none that lies in a stretch beyond `high`.
  std::optional<double> first(double begin, double at_begin, double end, double at_end, double high);

 private:
  struct Stretch {
    double begin;
    double at_begin;
    double end;
    double at_end;
    double length;  ///< halved from one to the next, not the difference of the ends
    double climb;   ///< how much the field may change along it, at most
    bool is_found = false;
  };

  static std::vector<Stretch>& waiting();  ///< the nearest is the last
  void add(Stretch stretch, double high);
  void halve_some(double high);
  std::optional<double> learning(const Stretch& whole);

  const RayField& field_;
  double speed_;
  double accuracy_;
  FieldGradient gradient_;
  int evaluations_ = 0;
};

}  // namespace firstlight::render
