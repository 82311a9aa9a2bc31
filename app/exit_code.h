#pragma once

#include <string_view>

namespace firstlight::app {

constexpr int kExitFailure = 1;
constexpr int kExitInterrupted = 130;  ///< as a shell reports a program ended by Ctrl-C

// How commands end. Each says what there is to say, and returns the exit code.

int fail(std::string_view why, int code = kExitFailure);
/// `loss`: what there is not, for the user wanted an end: "; no picture written".
int interrupted(std::string_view loss);
/// Prints what the program was run for on the standard output. Returns `code`, or `failure` when not all of it can be
/// written.
int print(std::string_view result, int code = 0, int failure = kExitFailure);

}  // namespace firstlight::app
