#pragma once

#include "render/scene/diagnostic.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>

namespace firstlight::app {

/// Which warnings have been shown before: in a loop, or in a long file that a program has written, the same comes
/// thousands of times.
/// Memory   Bounded: of each text a few places, and of texts kMostTexts.
class Repeats {
 public:
  static constexpr std::size_t kMostPlaces = 5;  ///< that one text is shown of
  static constexpr std::size_t kMostTexts = 10'000;

  /// Whether it is to be shown: anything but a warning; a warning at a new place, of which few have been shown.
  bool is_new(const render::Diagnostic& diagnostic);
  /// Notes on the warnings that were not shown each time, in the order of their first: "this warning came 257 times".
  render::Diagnostics counts() const;

 private:
  using Place = std::tuple<std::string, std::size_t, std::size_t>;  // file, line, column
  struct Entry {
    render::Diagnostic first;
    std::uint64_t times = 0;
    std::set<Place> places;  // shown
    std::size_t number = 0;
  };
  std::map<std::string, Entry> entries_;  // by the text
};

}  // namespace firstlight::app
