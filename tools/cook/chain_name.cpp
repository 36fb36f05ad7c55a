#include "cook/chain_name.h"

#include <fmt/format.h>

namespace coif {

std::string chain_name(const AssetContents& contents, std::uint32_t chain) {
  const std::uint32_t bone = contents.chains[chain].first_bone;
  const bool named = bone < contents.bone_names.size() && !contents.bone_names[bone].empty();
  return named ? fmt::format("'{}'", contents.bone_names[bone]) : fmt::format("{}", chain);
}

}  // namespace coif
