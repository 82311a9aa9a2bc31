#pragma once

#include "render/feature/feature.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace firstlight::render {

/// The means that an evaluation of functions needs beside its arguments, and may use up. One for each thread.
struct Evaluation {
  static constexpr std::uint64_t kMostSteps = 200'000'000;

  int noise_generator = 2;                ///< the scene's own, for `f_noise3d`
  std::uint64_t steps_left = kMostSteps;  ///< of loops; at 0 they end early and their value means nothing
};

/// A function of some numbers that gives 1 to 5 numbers: an expression of the scene language, one of its built-in
/// functions, a spline, a transformation, a pattern, a pigment.
///
/// Cost     evaluate() allocates nothing.
/// Threads  Immutable.
class Function {
 public:
  static constexpr std::size_t kMostParameters = 56;  ///< as in POV-Ray
  static constexpr std::size_t kMostResults = 5;
  static constexpr std::uint32_t kDeepestCalls = 1000;  ///< POV-Ray allows 1024
  static constexpr std::uint64_t kMostCost = 100'000'000;

  virtual ~Function() = default;
  /// Pre: as many arguments as parameters; room for as many results as there are.
  virtual void evaluate(const double* arguments, double* results, Evaluation& evaluation) const = 0;

  /// The same of `count` points: arguments[p][i] is parameter p of point i, results[r][i] its result r. Costs less than
  /// one by one where functions are made of instructions or patterns; else it is that. Each point may take as many
  /// steps as there are; those that the longest took are used up.
  virtual void evaluate_many(const double* const* arguments, double* const* results, std::size_t count,
                             Evaluation& evaluation) const;

  std::size_t parameter_count() const { return parameters_; }
  std::size_t result_count() const { return results_; }
  /// Levels of calls below this function, and about how many instructions a call takes, loops turning once. Whoever
  /// makes functions of functions keeps below the limits above, or a short text could describe endless work.
  std::uint32_t depth() const { return depth_; }
  std::uint64_t cost() const { return cost_; }
  /// The parts of it that cannot be rendered; they give 0.
  const FeatureUses& unrendered() const { return unrendered_; }

 protected:
  Function(std::size_t parameters, std::size_t results, std::uint64_t cost = 10, std::uint32_t depth = 0,
           FeatureUses unrendered = {})
      : parameters_(parameters), results_(results), cost_(cost), depth_(depth), unrendered_(std::move(unrendered)) {}

 private:
  std::size_t parameters_;
  std::size_t results_;
  std::uint64_t cost_;
  std::uint32_t depth_;
  FeatureUses unrendered_;
};

using FunctionPtr = std::shared_ptr<const Function>;

}  // namespace firstlight::render
