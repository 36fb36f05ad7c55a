// Writes those seeds of the corpora that are not text: fuzz_write_seeds FOLDER. To be run again when their format changes.

#include "cache/small_entry.h"
#include "cook/recipe/recipe.h"
#include "import/model_files.h"
#include "import/model_stream.h"
#include "models/small_asset.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

namespace coif::fuzz {
namespace {

namespace fs = std::filesystem;

template <class Bytes>
void write(const fs::path& file, const Bytes& bytes) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
}

void write_assets(const fs::path& folder) {
  AssetContents asset = small_asset();
  write(folder / "every_chunk.coif", write_asset(asset));
  AssetContents bones;
  bones.skeleton = asset.skeleton;
  bones.bones = asset.bones;
  bones.chains = asset.chains;
  bones.dynamics = asset.dynamics;
  for (BoneRecord& bone : bones.bones) bone.colliders = 0;
  write(folder / "bones_alone.coif", write_asset(bones));
  for (DynamicsRecord& dynamics : asset.dynamics) {
    dynamics.torsion = kShortestArc;
    dynamics.angle_limit = 0.5f;
  }
  asset.lods.clear();
  asset.lod_bones.clear();
  asset.orders.clear();
  asset.order_views.clear();
  asset.textures.clear();
  asset.texels.clear();
  write(folder / "one_level.coif", write_asset(asset));
}

void write_clips(const fs::path& folder) {
  test::ClipDocument clip;
  clip.document["nodes"] = {{{"name", "body"}, {"children", {1}}, {"translation", {0, 1, 0}}}, {{"name", "head"}}};
  clip.animate(1, "rotation", {0, 0.5f, 1}, test::turns_about_x({0, 0.5f, 1}, [](double t) { return t; }));
  clip.animate(0, "translation", {0.25f, 0.75f}, {0, 1, 0, 0, 2, 0}, "STEP");
  clip.animate(1, "scale", {0}, {1, 1, 1});
  write(folder / "nod.glb", clip.glb());
  write(folder / "nod.gltf", clip.text());
}

void write_outcomes(const fs::path& folder) {
  write(folder / "model", encode_outcome(test::small_source_model()));
  write(folder / "error", encode_outcome(tl::unexpected(ToolError{ToolError::Kind::kBadInput, "x.obj: broken"})));
}

}  // namespace
}  // namespace coif::fuzz

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: fuzz_write_seeds FOLDER\n");
    return 2;
  }
  using namespace coif::fuzz;
  const std::filesystem::path folder = argv[1];
  write_assets(folder / "asset");
  write_clips(folder / "clip");
  write_outcomes(folder / "model_stream");
  write(folder / "cache_entry" / "entry", coif::encode_entry(coif::small_entry()));
  write(folder / "recipe" / "every_key.recipe.json", coif::print_recipe(coif::default_recipe()));
}
