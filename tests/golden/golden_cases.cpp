#include "golden/golden_cases.h"

#include "render/transparency_modes.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

namespace coif {
namespace {

constexpr std::uint32_t kWidth = 160, kHeight = 120;

const TransparencyMode* mode_called(std::string_view name) {
  for (const TransparencyMode* mode : transparency_modes()) {
    if (name == name_of(*mode)) return mode;
  }
  return &kBlendMode;
}

GoldenCase golden(const char* name, double yaw, double pitch, const char* transparency = "blend") {
  GoldenCase made{name, {}};
  made.settings.width = kWidth;
  made.settings.height = kHeight;
  made.settings.yaw_degrees = yaw;
  made.settings.pitch_degrees = pitch;
  made.settings.transparency = mode_called(transparency);
  return made;
}

GoldenCase moving(GoldenCase made, Motion motion, double seconds) {
  made.settings.motion = motion;
  made.settings.time = seconds;
  return made;
}

}  // namespace

std::vector<GoldenCase> golden_cases() {
  return {golden("front", 20, 5),
          golden("back", 200, 10),
          golden("above", -60, 60),
          moving(golden("turn", 90, 0), Motion::kTurn, 0.45),
          golden("coverage", 20, 5, "coverage"),
          golden("opaque", 20, 5, "opaque")};
}

LoadedAsset::LoadedAsset(const std::string& path) {
  constexpr std::size_t kAlignment = 64;  // what Asset::open() may ask for
  std::error_code failed;
  const std::uintmax_t size = std::filesystem::file_size(path, failed);
  if (failed) return;
  const std::size_t rounded = (std::size_t(size) / kAlignment + 1) * kAlignment;
  bytes_.reset(static_cast<std::byte*>(std::aligned_alloc(kAlignment, rounded)));
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(bytes_.get()), std::streamsize(size));
  if (file) (void)asset_.open({bytes_.get(), std::size_t(size)});
}

}  // namespace coif
