#include "app/compare/scratch_folder.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <cerrno>
#include <system_error>

namespace firstlight::app::compare {

ScratchFolder::ScratchFolder() {
  std::string name = "/tmp/firstlight-XXXXXX";
  if (mkdtemp(name.data()) == nullptr) {
    error_ = fmt::format("cannot make a folder in /tmp: {}", std::generic_category().message(errno));
  } else {
    path_ = name;
  }
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

}  // namespace firstlight::app::compare
