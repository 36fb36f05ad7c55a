#include "fuzz/lone_file.h"

#include "fuzz/promise.h"

#include <cstdlib>
#include <fstream>
#include <string>
#include <system_error>

namespace coif::fuzz {

namespace fs = std::filesystem;

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

}  // namespace coif::fuzz
