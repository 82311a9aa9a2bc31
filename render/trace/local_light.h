#pragma once

#include "render/light/light.h"
#include "render/math/color.h"
#include "render/texture/finish.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace firstlight::render {

/// Empirical Fresnel term by which metals lose their tint at grazing angles; `cosine` is of the angle to the normal.
/// Source   POV-Ray 3.7: F = 0.014567225 / (x - 1.12)^2 - 0.011612903, x = angle / 90 degrees, kept within [0, 1].
inline double metallic_fresnel(double cosine) {
  const double x = std::abs(std::acos(std::clamp(cosine, -1.0, 1.0))) / (std::numbers::pi / 2.0);
  const double f = 0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903;
  return std::clamp(f, 0.0, 1.0);
}

/// `base` tinted by the surface colour as far as the finish is metallic and the angle steep.
inline Rgb metallic_tint(const Rgb& base, const Rgb& surface, double metallic, double cosine) {
  const float share = static_cast<float>(metallic * (1.0 - metallic_fresnel(cosine)));
  return base * (Rgb(1.0f) + (surface - Rgb(1.0f)) * share);
}

/// Diffuse term: diffuse * opacity * |N.L|^brilliance * surface * light.
inline Rgb diffuse_light(const Finish& finish, double amount, const Vec3& normal, const Illumination& light,
                         const Rgb& surface, double opacity) {
  if (amount <= 0.0) return Rgb(0.0f);
  const double cosine = std::abs(normal.dot(light.direction));
  const double falloff = finish.brilliance == 1.0 ? cosine : std::pow(cosine, finish.brilliance);
  return surface * light.color * static_cast<float>(falloff * amount * opacity);
}

/// Highlight by the mirrored eye ray: phong * (R.L)^phong_size. `eye` points along the ray.
inline Rgb phong_light(const Finish& finish, const Vec3& eye, const Vec3& normal, const Illumination& light,
                       const Rgb& surface) {
  constexpr double kSmallestCosine = 0.0008;  // below it, large sizes underflow
  const Vec3 mirrored = eye - normal * (2.0 * eye.dot(normal));
  const double cosine = mirrored.dot(light.direction);
  if (cosine <= 0.0 || (finish.phong_size >= 60.0 && cosine <= kSmallestCosine)) return Rgb(0.0f);
  const float intensity = static_cast<float>(finish.phong * std::pow(cosine, finish.phong_size));
  if (finish.metallic <= 0.0) return light.color * intensity;
  return metallic_tint(light.color, surface, finish.metallic, normal.dot(light.direction)) * intensity;
}

/// Highlight by the vector halfway between eye and light: specular * (N.H)^(1/roughness).
inline Rgb specular_light(const Finish& finish, const Vec3& eye, const Vec3& normal, const Illumination& light,
                          const Rgb& surface) {
  const Vec3 halfway = (light.direction - eye) * 0.5;
  const double length = halfway.length();
  if (length <= 0.0) return Rgb(0.0f);
  const double cosine = halfway.dot(normal) / length;
  if (cosine <= 0.0) return Rgb(0.0f);
  const float intensity = static_cast<float>(finish.specular * std::pow(cosine, finish.roughness_exponent));
  if (finish.metallic <= 0.0) return light.color * intensity;
  return metallic_tint(light.color, surface, finish.metallic, normal.dot(light.direction)) * intensity;
}

}  // namespace firstlight::render
