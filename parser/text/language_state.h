#pragma once

#include "render/scene/scene.h"

namespace firstlight::parser {

/// Which version of the language is in force, and what the scene's colour numbers mean. Versions are 100 * version.
/// Source   POV-Ray 3.7: `#version`, `assumed_gamma`, and what it does at the end of a scene that has neither.
class LanguageState {
 public:
  static constexpr int kNewest = 380;

  /// The version that `version` gives and most rules ask for; 3.7 until a #version.
  int version() const { return version_; }
  /// The version that rules about old scenes ask for: a scene that never states one counts as 3.62.
  int effective_version() const { return version_stated_ ? version_ : 362; }
  bool version_stated() const { return version_stated_; }
  bool version_stated_late() const { return version_stated_late_; }
  /// `first` when nothing significant stands before the directive.
  void set_version(int version, bool first);

  /// The meaning of the bytes of a string literal that are not ASCII.
  render::Charset charset() const { return charset_; }
  void set_charset(render::Charset charset) { charset_ = charset; }
  /// The generator of functions and of patterns that choose none: the one in global_settings, or else the version's.
  int noise_generator() const { return noise_generator_ != 0 ? noise_generator_ : version_ >= 350 ? 2 : 1; }
  void set_noise_generator(int generator) { noise_generator_ = generator; }

  bool gamma_stated() const { return gamma_stated_; }
  render::WorkingGamma gamma() const { return gamma_; }
  double gamma_exponent() const { return exponent_; }
  /// `assumed_gamma`. False when there was one before; then nothing changes.
  bool set_assumed_gamma(render::WorkingGamma gamma, double exponent);
  /// A component of an `srgb` colour as a number of the scene. Pre: gamma_stated().
  float from_srgb(float component) const;

  /// Settles what was left open; call at the end of the scene.
  void store(render::Settings& settings) const;

 private:
  int version_ = 370;
  int noise_generator_ = 0;  ///< 0: not stated
  bool version_stated_ = false;
  bool version_stated_late_ = false;
  render::Charset charset_ = render::Charset::ascii;
  bool gamma_stated_ = false;
  render::WorkingGamma gamma_ = render::WorkingGamma::unmanaged;
  double exponent_ = 1.0;
};

}  // namespace firstlight::parser
