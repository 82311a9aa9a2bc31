#pragma once

#include "render/math/shared.h"
#include "render/math/vec.h"

namespace firstlight::render {

/// An affine map with its inverse, in POV-Ray's convention: points are row vectors, p' = p * matrix, axes are
/// left-handed, so `first.then(second)` multiplies matrices in reading order of the scene text. A small value: copies
/// share the matrices, and most transformations of a scene are the identity, which has none.
class Transform {
 public:
  Transform() = default;
  /// Pre: `matrix` is affine and can be inverted (see is_invertible()).
  explicit Transform(const Mat4& matrix);

  static Transform translation(const Vec3& offset);
  /// Degrees about x, then y, then z.
  static Transform rotation(const Vec3& degrees);
  /// Pre: no component is zero.
  static Transform scaling(const Vec3& factors);
  /// Degrees about `axis` (any length but zero).
  static Transform rotation_about(const Vec3& axis, double degrees);
  /// The same in radians.
  static Transform turning(const Vec3& axis, double radians);
  static bool is_invertible(const Mat4& matrix);

  bool is_identity() const { return matrices_.is_initial(); }
  const Mat4& matrix() const { return matrices_->forth; }
  const Mat4& inverse_matrix() const { return matrices_->back; }
  Transform inverse() const;
  Transform then(const Transform& next) const;

  Vec3 point(const Vec3& p) const;
  Vec3 direction(const Vec3& d) const;
  /// Surface normals go by the transposed inverse; the result is not normalised.
  Vec3 normal(const Vec3& n) const;
  Vec3 inverse_point(const Vec3& p) const;
  Vec3 inverse_direction(const Vec3& d) const;
  /// The ray seen from the untransformed space; its direction keeps the length that makes depths equal.
  Ray inverse_ray(const Ray& ray) const;
  Box3 box(const Box3& b) const;

 private:
  struct Matrices {
    Mat4 forth;
    Mat4 back;
  };

  explicit Transform(const Matrices& matrices);

  Shared<Matrices> matrices_;  ///< initial: the identity
};

}  // namespace firstlight::render
