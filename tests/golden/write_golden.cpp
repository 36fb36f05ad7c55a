// Writes the pictures that golden_test compares with: write_golden ASSET FOLDER

#include "golden/golden_cases.h"

#include <cstdio>
#include <fstream>

int main(int argc, char** argv) {
  if (argc != 3) return std::fputs("usage: write_golden ASSET FOLDER\n", stderr), 1;
  const coif::GoldenAsset sample(argv[1]);
  for (const coif::GoldenCase& golden : coif::golden_cases()) {
    const auto picture = coif::render::render_picture(sample.asset(), golden.settings);
    if (!picture) {
      std::fprintf(stderr, "%s: %s\n", golden.name.c_str(), picture.error().message.c_str());
      return 1;
    }
    const std::vector<std::uint8_t> png = coif::render::encode_png(*picture);
    const std::string path = std::string(argv[2]) + "/" + golden.name + ".png";
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(png.data()), std::streamsize(png.size()));
    if (!file.flush()) {
      std::fprintf(stderr, "%s: cannot write\n", path.c_str());
      return 1;
    }
  }
  return 0;
}
