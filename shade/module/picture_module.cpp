// SPDX-License-Identifier: MIT
#include "shade/module/picture_module.h"

#include <dlfcn.h>

#include <cstdlib>
#include <cstring>
#include <future>

#include "csg/base/error.h"
#include "shade/module/module_version.h"

namespace csgcast::detail {
namespace {

constexpr const char* file_name = "csgcast_pictures.so";

/// The module, or why it is not there.
struct Loaded {
  const PictureModule* module = nullptr;
  std::string problem;
};

void* open_module(std::string& problem) {
  const auto open = [&](const std::string& path) {
    void* library = ::dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (library == nullptr) problem = ::dlerror();
    return library;
  };
  if (const char* folder = std::getenv("CSGCAST_MODULES")) return open(std::string(folder) + '/' + file_name);
  void* library = open(file_name);
  return library != nullptr ? library : open(std::string(CSGCAST_MODULE_FOLDER "/") + file_name);
}

Loaded load() {
  Loaded loaded;
  void* library = open_module(loaded.problem);
  if (library == nullptr) return loaded;
  using Entry = const PictureModule* (*)();
  const auto entry = reinterpret_cast<Entry>(::dlsym(library, module_entry));
  const PictureModule* module = entry != nullptr ? entry() : nullptr;
  if (module == nullptr || std::strcmp(module->version, module_version) != 0) {
    loaded.problem = std::string(file_name) + " is of another version of csgcast";
    return loaded;
  }
  loaded.module = module;
  return loaded;
}

std::shared_future<Loaded>& loading() {
  static std::shared_future<Loaded> future = std::async(std::launch::async, load).share();
  return future;
}

}  // namespace

void prepare_picture_module() { loading(); }

const PictureModule& picture_module(const Place& place, const std::string& otherwise) {
  const Loaded& loaded = loading().get();
  if (loaded.module != nullptr) return *loaded.module;
  throw Error(ErrorCode::unsupported, place, "this kind of picture needs a module that cannot be loaded",
              loaded.problem, otherwise + ", or install csgcast with OpenImageIO");
}

}  // namespace csgcast::detail
