#include "parser/text/language_state.h"

#include <algorithm>
#include <cmath>

namespace firstlight::parser {

void LanguageState::set_version(int version, bool first) {
  if (!version_stated_ && !first) version_stated_late_ = true;
  version_stated_ = true;
  version_ = version;
}

bool LanguageState::set_assumed_gamma(render::WorkingGamma gamma, double exponent) {
  if (gamma_stated_) return false;
  gamma_stated_ = true;
  gamma_ = gamma;
  exponent_ = exponent;
  return true;
}

float LanguageState::from_srgb(float component) const {
  if (gamma_ == render::WorkingGamma::srgb) return component;
  // IEC 61966-2-1: the straight piece ends at 0.04045.
  const float linear = component <= 0.04045f ? component / 12.92f : std::pow((component + 0.055f) / 1.055f, 2.4f);
  if (gamma_ != render::WorkingGamma::power) return linear;
  return static_cast<float>(std::pow(std::max(linear, 0.0f), static_cast<float>(1.0 / exponent_)));
}

void LanguageState::store(render::Settings& settings) const {
  // Before 3.5 the renderer's rules are 3.5's: POV-Ray reads such scenes but does not render by their rules either.
  settings.language_version = std::max(effective_version(), 350);
  settings.noise_generator = noise_generator();
  if (gamma_stated_) {
    settings.gamma = gamma_;
    settings.gamma_exponent = exponent_;
    return;
  }
  settings.gamma = effective_version() < 370 ? render::WorkingGamma::unmanaged : render::WorkingGamma::linear;
  settings.gamma_exponent = 1.0;
}

}  // namespace firstlight::parser
