#pragma once

#include "app/desk.h"
#include "priority/steering.h"

#include <span>
#include <string>
#include <string_view>

namespace firstlight::app {

/// The language in which a program or a person steers a picture: a line in, a line out. docs/steering.md has it.
///
/// Threads  Any, one line at a time.
class SteerCommands {
 public:
  struct Answer {
    std::string text;      ///< "ok ...", or "error ..."; one line, without its end; empty: none
    bool goodbye = false;  ///< the connection is to be closed
  };

  SteerCommands(priority::Steering& steering, Desk& desk) : steering_(steering), desk_(desk) {}

  Answer answer(std::string_view line);

 private:
  struct Row {
    std::string_view name;
    std::string_view parameters;
    bool needs_more;  ///< nothing behind the name is a mistake
    /// `text`: what stands behind the name, without blanks around it. Returns the answer.
    std::string (SteerCommands::*run)(std::string_view text);
  };
  static std::span<const Row> rows();
  /// The answer to a command that there is not.
  static std::string unknown(std::string_view name);

  std::string scheme(std::string_view text);
  std::string boost(std::string_view text);
  std::string drop(std::string_view text);
  std::string pause(std::string_view);
  std::string resume(std::string_view);
  std::string stop(std::string_view);
  std::string save(std::string_view text);
  std::string status(std::string_view);
  std::string help(std::string_view);

  priority::Steering& steering_;
  Desk& desk_;
};

/// One line of JSON: how far the picture is, and its order.
std::string status_json(const priority::Progress& progress, const priority::Steering& steering);

/// `text` up to its first line end, without control characters, which would end an answer or garble a terminal.
std::string one_line(std::string_view text);

}  // namespace firstlight::app
