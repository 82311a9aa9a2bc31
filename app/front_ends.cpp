#include "app/front_ends.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace firstlight::app {
namespace {

template <class Function>
Function* find(void* library, const char* symbol) {
  return reinterpret_cast<Function*>(dlsym(library, symbol));
}

}  // namespace

void FrontEndModule::Close::operator()(void* library) const { dlclose(library); }

std::unique_ptr<FrontEndModule> FrontEndModule::open(const std::string& path, std::string& error) {
  // A name without a slash would be searched for among the system's libraries; a file was meant.
  const std::string file = path.find('/') == std::string::npos ? "./" + path : path;
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    error = fmt::format("front end '{}': there is no such file", path);
    return nullptr;
  }
  // To open a pipe would wait for a writer.
  if (!std::filesystem::is_regular_file(file, ignored)) {
    error = fmt::format("front end '{}': that is no regular file", path);
    return nullptr;
  }
  std::unique_ptr<void, Close> library(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL));
  if (library == nullptr) {
    const char* const why = dlerror();
    error = fmt::format("front end '{}' cannot be loaded: {}", path, why != nullptr ? why : "no reason given");
    return nullptr;
  }
  auto* const abi = find<int()>(library.get(), render::kFrontEndAbiSymbol);
  auto* const make = find<const render::FrontEnd*()>(library.get(), render::kFrontEndSymbol);
  if (abi == nullptr || make == nullptr) {
    error = fmt::format("front end '{}': the module exports no front end ({}, {})", path, render::kFrontEndAbiSymbol,
                        render::kFrontEndSymbol);
    return nullptr;
  }
  if (const int version = abi(); version != render::kFrontEndAbi) {
    error = fmt::format("front end '{}' is made for interface version {}, this program has version {}", path, version,
                        render::kFrontEndAbi);
    return nullptr;
  }
  const render::FrontEnd* const front_end = make();
  if (front_end == nullptr) {
    error = fmt::format("front end '{}': the module gave no front end", path);
    return nullptr;
  }
  return std::unique_ptr<FrontEndModule>(new FrontEndModule(std::move(library), front_end));
}

ChosenFrontEnd::ChosenFrontEnd(const std::string& module) {
  if (!module.empty()) module_ = FrontEndModule::open(module, error_);
}

}  // namespace firstlight::app
