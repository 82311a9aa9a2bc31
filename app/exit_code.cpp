#include "app/exit_code.h"

#include "app/output.h"

#include <string>

namespace firstlight::app {

int fail(std::string_view why, int code) {
  say_error(why);
  return code;
}

int interrupted(std::string_view loss) {
  say("firstlight: interrupted" + std::string(loss));
  return kExitInterrupted;
}

int print(std::string_view result, int code, int failure) {
  const std::string problem = print_result(result);
  return problem.empty() ? code : fail(problem, failure);
}

}  // namespace firstlight::app
