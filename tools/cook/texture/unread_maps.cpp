#include "cook/texture/source_images.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif::cook {

// What a material has beside its base colour: who made it should hear that it does not count.

void SourceImages::tell_other_maps(const importer::SourceMaterial& material) {
  const auto leave_out = [&](const std::string& map, const char* why) {
    LeftOut part{fmt::format("material '{}': {}", material.name, map), why};
    const bool is_new = std::ranges::find(findings_.left_out, part.what, &LeftOut::what) == findings_.left_out.end();
    if (is_new) findings_.leave_out(std::move(part));
  };
  for (const std::string& map : material.other_textures)
    leave_out(map, "it is not read; light is computed from the hair's form");
}

}  // namespace coif::cook
