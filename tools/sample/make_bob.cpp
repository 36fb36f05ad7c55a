// coif_make_sample OUT.glb: writes the sample head of hair.

#include "sample/bob.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

namespace {

/// Beside the target first, then renamed: a reader never sees half a file.
bool write_file(const std::filesystem::path& path, const std::vector<std::uint8_t>& bytes) {
  const std::filesystem::path draft = path.string() + ".tmp";
  std::ofstream out(draft, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(draft, path, error);
  const bool written = out && !error;
  if (!written) std::filesystem::remove(draft, error);
  return written;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: coif_make_sample OUT.glb\n", stderr);
    return 1;
  }
  const std::vector<std::uint8_t> bytes = coif::sample::make_bob();
  if (!write_file(argv[1], bytes)) {
    std::fprintf(stderr, "coif_make_sample: error: %s: cannot write; check that the folder exists and is writable\n",
                 argv[1]);
    return 2;
  }
  std::printf("%s: %zu bytes\n", argv[1], bytes.size());
  return 0;
}
