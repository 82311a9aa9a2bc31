#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace firstlight::render {

class Program;

/// A program, or what is wrong with the text it was to be made of.
struct CompileResult {
  std::shared_ptr<const Program> program;  ///< null on failure
  std::string error;
  std::size_t at = 0;      ///< bytes of the text before the place of the error
  std::size_t length = 1;  ///< bytes to underline
};

}  // namespace firstlight::render
