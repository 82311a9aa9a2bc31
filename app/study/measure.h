#pragma once

#include "app/session.h"
#include "app/study/study.h"
#include "priority/scheme.h"
#include "render/film/film.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace firstlight::app {

/// A plan says what is to be measured, and how.
struct StudyPlan {
  struct Entry {
    std::string text;
    /// Null: the traditional order. Made anew for each picture: a scheme learns while it is used.
    std::function<std::shared_ptr<const priority::Scheme>(const render::Film&)> make;
  };

  const Session* session = nullptr;  ///< built
  int rounds = 1;
  std::vector<Entry> schemes;
  std::function<void(const std::string&)> say;  ///< what is being done; may be empty
  /// Takes a picture of a moment; working colours, rows from the top. May be empty.
  std::function<std::string(std::size_t scheme, double share, std::span<const render::Rgb> colors)> keep_picture;
};

/// Fills in all of `study` that is measured. Empty, or what went wrong; to be stopped is no error.
/// Order    Every scheme once, with rests to look at the picture; then rounds without rests, each of which begins with
///          another scheme.
std::string measure(const StudyPlan& plan, Study& study);

}  // namespace firstlight::app
