#include "import/gltf_scene.h"

#include "base/text.h"
#include "import/source_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace coif::importer {
namespace {

using nlohmann::json;

/// Extensions that the reader undoes or follows.
constexpr std::string_view kRead[] = {"KHR_mesh_quantization",
                                      "KHR_texture_transform",
                                      "KHR_draco_mesh_compression",
                                      "EXT_meshopt_compression",
                                      "KHR_meshopt_compression",
                                      "EXT_texture_webp",
                                      "EXT_mesh_gpu_instancing",
                                      "KHR_node_visibility",
                                      "KHR_materials_variants",
                                      "MSFT_lod",
                                      "VRM"};
/// Families about light, motion or names, without effect on the shape, texture or place of hair.
constexpr std::string_view kOfNoEffect[] = {"KHR_materials_",
                                            "KHR_lights_",
                                            "EXT_lights_",
                                            "KHR_xmp",
                                            "KHR_animation_pointer",
                                            "KHR_audio",
                                            "KHR_physics",
                                            "KHR_rigid",
                                            "KHR_interactivity",
                                            "KHR_node_",
                                            "KHR_accessor_float64",
                                            "VRMC_",
                                            "VCI_",
                                            "MOZ_",
                                            "OMI_",
                                            "BLENDER_",
                                            "ADOBE_materials_",
                                            "FB_",
                                            "MSFT_packing_",
                                            "AGI_",
                                            "EXT_structural",
                                            "EXT_mesh_features",
                                            "GODOT_",
                                            "UNITY_",
                                            "EPIC_"};

/// An extension that is not read, and the tool that removes it.
struct Cure {
  std::string_view name;
  const char* what;
  const char* command;
};
constexpr Cure kCures[] = {
    {"KHR_texture_basisu", "images in KTX2", "npx @gltf-transform/cli ktxdecompress OLD.glb NEW.glb"},
    {"EXT_texture_avif", "images in AVIF", "npx @gltf-transform/cli png OLD.glb NEW.glb"}};

bool is_read(std::string_view name) {
  return std::ranges::find(kRead, name) != std::end(kRead) ||
         std::ranges::any_of(kOfNoEffect, [&](std::string_view family) { return name.starts_with(family); });
}

const Cure* cure_of(std::string_view name) {
  const auto* const found = std::ranges::find(kCures, name, &Cure::name);
  return found == std::end(kCures) ? nullptr : found;
}

std::string refusal_of(const std::string& name) {
  if (const Cure* const cure = cure_of(name)) {
    return fmt::format("it requires the extension '{}', {}, which is not read; {} takes it out", name, cure->what,
                       cure->command);
  }
  return fmt::format(
      "it requires the extension '{}', which is not read; open it in Blender and export it again as .glb, which leaves "
      "it out",
      name);
}

std::vector<std::string> names_in(const json& list) {
  std::vector<std::string> names;
  for (const json& entry : list_of(list)) {
    std::string name = excerpt(printable_text_of(entry));
    if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
  }
  return names;
}

}  // namespace

GltfExtensions check_gltf_extensions(const json& document) {
  GltfExtensions out;
  for (const std::string& name : names_in(member(document, "extensionsRequired"))) {
    if (is_read(name)) continue;
    out.refusal = refusal_of(name);
    return out;
  }
  for (const std::string& name : names_in(member(document, "extensionsUsed"))) {
    if (is_read(name) || cure_of(name) != nullptr)
      continue;  // An image without another form is reported where it is missed.
    warn(out.warnings, source_code::kExtensions,
         "the extension '{}' is not read; where it changes shape, texture coordinates or images the hair "
         "differs: open it in Blender and export it again as .glb",
         name);
  }
  return out;
}

}  // namespace coif::importer
