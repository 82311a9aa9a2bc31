#include "parser/text/own_work.h"

#include <sys/stat.h>
#include <sys/xattr.h>

#include <string>

namespace firstlight::parser {
namespace {

constexpr const char* kAttribute = "user.firstlight.made";

std::string time_of_change(const struct stat& file) {
  return std::to_string(file.st_mtim.tv_sec) + "." + std::to_string(file.st_mtim.tv_nsec);
}

}  // namespace

void mark_own_work(int descriptor) {
  struct stat file {};
  if (fstat(descriptor, &file) != 0) return;
  const std::string mark = time_of_change(file);
  fsetxattr(descriptor, kAttribute, mark.data(), mark.size(), 0);
}

bool is_own_work(const std::filesystem::path& path) {
  struct stat file {};
  if (lstat(path.c_str(), &file) != 0 || !S_ISREG(file.st_mode)) return false;
  std::string mark(64, '\0');
  const ssize_t size = lgetxattr(path.c_str(), kAttribute, mark.data(), mark.size());
  return size > 0 && mark.substr(0, static_cast<std::size_t>(size)) == time_of_change(file);
}

}  // namespace firstlight::parser
