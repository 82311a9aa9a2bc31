#pragma once

#include "parser/parser.h"
#include "render/scene/front_end.h"

#include <memory>
#include <string>

namespace firstlight::app {

/// A scene language in a loadable module.
/// Lifetime  must outlive every scene it made: their code is in the module.
class FrontEndModule {
 public:
  /// Opens the module at `path`; on failure the result is null and `error` says why.
  static std::unique_ptr<FrontEndModule> open(const std::string& path, std::string& error);

  const render::FrontEnd& front_end() const { return *front_end_; }

 private:
  struct Close {
    void operator()(void* library) const;
  };
  FrontEndModule(std::unique_ptr<void, Close> library, const render::FrontEnd* front_end)
      : library_(std::move(library)), front_end_(front_end) {}

  std::unique_ptr<void, Close> library_;
  const render::FrontEnd* front_end_;
};

/// The scene language that the user chose: a loadable module, or our own.
/// Lifetime  as FrontEndModule.
class ChosenFrontEnd {
 public:
  /// `module` empty: our own. When a module cannot be opened, error() says why and there is no front end.
  explicit ChosenFrontEnd(const std::string& module);

  const std::string& error() const { return error_; }
  const render::FrontEnd& operator*() const { return module_ ? module_->front_end() : pov_; }

 private:
  parser::PovFrontEnd pov_;
  std::unique_ptr<FrontEndModule> module_;
  std::string error_;
};

}  // namespace firstlight::app
