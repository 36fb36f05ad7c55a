#include "fuzz/targets.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <system_error>

namespace coif::fuzz {

namespace fs = std::filesystem;

void promise(bool kept, const char* what) {
  if (kept) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

const Target* find_target(std::string_view name, const char* usage) {
  for (const Target& target : all_targets()) {
    if (target.name == name) return &target;
  }
  std::fprintf(stderr, "%s\ntargets:", usage);
  for (const Target& target : all_targets()) std::fprintf(stderr, " %s", target.name.data());
  std::fprintf(stderr, "\n");
  return nullptr;
}

LoneFile::LoneFile(const char* name) {
  std::string pattern = (fs::temp_directory_path() / "coif_fuzz_XXXXXX").string();
  promise(mkdtemp(pattern.data()) != nullptr, "there is a folder for temporary files");
  folder_ = pattern;
  path_ = folder_ / name;
}

LoneFile::~LoneFile() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

const fs::path& LoneFile::with(Input bytes) const {
  std::ofstream file(path_, std::ios::binary | std::ios::trunc);
  file.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  file.close();
  promise(bool(file), "temporary files can be written");
  return path_;
}

bool try_can_fail(Input input) {
  promise(input.empty() || input[0] != '!', "no input begins with an exclamation mark");
  return true;
}

}  // namespace coif::fuzz
