#include "import/asked_files.h"

#include "base/files.h"
#include "base/text.h"

#include <assimp/MemoryIOWrapper.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string_view>

namespace coif::importer {
namespace {

namespace fs = std::filesystem;

/// A stream of a copy of the bytes.
Assimp::IOStream* stream_of(std::string_view bytes) {
  auto* const copy = new std::uint8_t[std::max<std::size_t>(bytes.size(), 1)];
  std::ranges::copy(bytes, copy);
  return new Assimp::MemoryIOStream(copy, bytes.size(), true);
}

}  // namespace

std::vector<char> bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  std::vector<char> bytes(size > 0 ? std::size_t(size) : 0);
  file.seekg(0);
  file.read(bytes.data(), std::streamsize(bytes.size()));
  bytes.resize(file ? bytes.size() : 0);
  return bytes;
}

bool AskedFiles::is_allowed(const fs::path& name) const { return name == model_ || lies_in(name, folders_); }

bool AskedFiles::Exists(const char* name) const {
  asked_.names.insert(name);
  return is_allowed(name) && DefaultIOSystem::Exists(name);
}

Assimp::IOStream* AskedFiles::Open(const char* name, const char* mode) {
  const bool is_for_reading = std::string_view(mode).find_first_of("wa+") == std::string_view::npos;
  Assimp::IOStream* const file = !is_for_reading             ? nullptr
                                 : is_obj_ && name != model_ ? open_library(name)
                                                             : open_plainly(name, mode);
  if (file == nullptr) asked_.not_opened.emplace_back(name);
  return file;
}

Assimp::IOStream* AskedFiles::open_plainly(const std::string& name, const char* mode) {
  asked_.names.insert(name);
  if (!is_allowed(name)) return nullptr;
  if (text_ && name == model_) return stream_of(*text_);
  if (!is_obj_) return DefaultIOSystem::Open(name.c_str(), mode);
  const std::vector<char> bytes = bytes_of(name);
  std::string_view text(bytes.data(), bytes.size());
  const bool has_mark = text.starts_with(kByteOrderMark);
  if (has_mark) text.remove_prefix(kByteOrderMark.size());
  if (const auto even = text_with_even_colors(text)) return stream_of(*even);
  return has_mark ? stream_of(text) : DefaultIOSystem::Open(name.c_str(), mode);
}

/// `name`: the statement's path without the model's folder.
Assimp::IOStream* AskedFiles::open_library(const std::string& name) {
  const fs::path folder = model_.parent_path();
  const std::string before = folder.empty() ? "" : folder.string() + '/';
  const std::string written = name.starts_with(before) ? name.substr(before.size()) : name;
  const ObjLibraries found = find_libraries(folder, written);
  if (found.paths.empty() ||
      !std::ranges::all_of(found.paths, [&](const fs::path& path) { return is_allowed(path); })) {
    asked_.names.insert(name);
    return nullptr;
  }
  std::string text, names;
  for (const fs::path& path : found.paths) {
    asked_.names.insert(path.string());
    const std::vector<char> bytes = bytes_of(path);
    text += plain_library_text({bytes.data(), bytes.size()});
    names += (names.empty() ? "" : " ") + shown_from(folder, path);
  }
  if (found.is_respelled) asked_.respelled.push_back({printable_text(written, 100), names});
  asked_.libraries.push_back(text);
  return stream_of(text);
}

}  // namespace coif::importer
