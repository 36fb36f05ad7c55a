// coif_make_sample OUT.glb [QUADS [COPIES]]: writes the sample head of hair; with numbers, one of another density.

#include "sample/bob.h"

#include <cstdio>
#include <cstdlib>
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
  coif::sample::BobDensity density;
  if (argc > 2) density.quads = std::atof(argv[2]);
  if (argc > 3) density.copies = std::atoi(argv[3]);
  const bool in_range = density.quads > 0 && density.quads <= 100 && density.copies >= 1 && density.copies <= 1000;
  if (argc < 2 || argc > 4 || !in_range) {
    std::fputs(
        "usage: coif_make_sample OUT.glb [QUADS [COPIES]]\n"
        "  QUADS   rows and columns of each strip, as a share of the sample's, up to 100\n"
        "  COPIES  strips in place of each, 1 to 1000\n",
        stderr);
    return 1;
  }
  const std::vector<std::uint8_t> bytes = coif::sample::make_bob(density);
  if (!write_file(argv[1], bytes)) {
    std::fprintf(stderr, "coif_make_sample: error: %s: cannot write; check that the folder exists and is writable\n",
                 argv[1]);
    return 2;
  }
  std::printf("%s: %zu bytes\n", argv[1], bytes.size());
  return 0;
}
