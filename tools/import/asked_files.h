#pragma once

#include <assimp/DefaultIOSystem.h>

#include <set>
#include <string>

namespace coif {

/// Files as assimp sees them, with a record of every name that it looked for or opened, whether there was such a file or
/// not: a model changes with each of them.
class AskedFiles : public Assimp::DefaultIOSystem {
 public:
  /// `names` outlives this object.
  explicit AskedFiles(std::set<std::string>& names) : names_(names) {}

  bool Exists(const char* name) const override {
    names_.insert(name);
    return DefaultIOSystem::Exists(name);
  }

  Assimp::IOStream* Open(const char* name, const char* mode) override {
    names_.insert(name);
    return DefaultIOSystem::Open(name, mode);
  }

 private:
  std::set<std::string>& names_;
};

}  // namespace coif
