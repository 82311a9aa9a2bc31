#pragma once

#include "app/descriptor.h"

#include <sys/types.h>

#include <optional>
#include <string>

namespace firstlight::app {

/// A Unix socket in the file system that others can connect to; only its owner may. The file is removed at the end.
class LocalListener {
 public:
  /// A socket that nobody listens at any more is replaced; anything else at `path` is left alone and is an error, told
  /// in `error`, and the result is empty.
  static std::optional<LocalListener> open(const std::string& path, std::string& error);

  LocalListener(LocalListener&&) = default;
  LocalListener& operator=(LocalListener&&) = delete;
  ~LocalListener();

  int descriptor() const { return socket_.get(); }
  /// The next who wants to connect; empty when there is none. Does not wait, neither here nor when it is read.
  Descriptor accept() const;

 private:
  LocalListener(Descriptor socket, std::string path, dev_t device, ino_t inode)
      : socket_(std::move(socket)), path_(std::move(path)), device_(device), inode_(inode) {}

  Descriptor socket_;
  std::string path_;
  dev_t device_;  // with the inode: whether the file at the path is still ours
  ino_t inode_;
};

/// Connects to a listener; on failure the result is empty and `error` says why.
Descriptor connect_to(const std::string& path, std::string& error);

}  // namespace firstlight::app
