// Writes those seeds of the corpora that are not text: fuzz_write_seeds FOLDER. To be run again when their format
// changes.

#include "cache/small_entry.h"
#include "cook/recipe/recipe.h"
#include "groom/groom_files.h"
#include "groom/read_groom.h"
#include "groom/strand_files.h"
#include "import/fbx_files.h"
#include "import/model_files.h"
#include "import/reader_process.h"
#include "models/small_asset.h"

#include <fmt/format.h>

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
  importer::test::ClipDocument clip;
  clip.document["nodes"] = {{{"name", "body"}, {"children", {1}}, {"translation", {0, 1, 0}}}, {{"name", "head"}}};
  clip.animate(1, "rotation", {0, 0.5f, 1}, importer::test::turns_about_x({0, 0.5f, 1}, [](double t) { return t; }));
  clip.animate(0, "translation", {0.25f, 0.75f}, {0, 1, 0, 0, 2, 0}, "STEP");
  clip.animate(1, "scale", {0}, {1, 1, 1});
  write(folder / "nod.glb", clip.glb());
  write(folder / "nod.gltf", clip.text());
}

void write_outcomes(const fs::path& folder) {
  write(folder / "model", importer::encode_outcome(importer::test::small_source_model()));
  write(folder / "error",
        importer::encode_outcome(tl::unexpected(ToolError{ToolError::Kind::kBadInput, "x.obj: broken"})));
}

std::string small_lines() {
  groom::test::Bytes buffer;
  buffer.add_all<float>({0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0}).add_all<std::uint16_t>({0, 1, 1, 2, 2, 3});
  return importer::test::glb_of(
      R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "scale": [1, 2, 1]}],
    "meshes": [{"primitives": [{"mode": 1, "attributes": {"POSITION": 0}, "indices": 1}, {"mode": 3, "attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                  {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
    "buffers": [{"byteLength": 60}]})",
      buffer.bytes);
}

void write_fbx_objects(const fs::path& folder) {
  write(folder / "text.fbx",
        importer::test::text_fbx({{1, "group", 0, "", "LodGroup"},
                                  {2,
                                   "fine",
                                   1,
                                   importer::test::fbx_property("Visibility", "Visibility", 1),
                                   "Mesh",
                                   {{"Longer", 50}, {"Wide", 20, 2, "25,100"}}},
                                  {3, "coarse", 1, importer::test::fbx_property("Visibility", "Visibility", 0)}}));
  for (const std::uint32_t version : {7400u, 7500u})
    write(folder / fmt::format("binary_{}.fbx", version), importer::test::small_binary_fbx(version));
}

void write_grooms(const fs::path& folder) {
  write(folder / "hair_file" / "all.hair", groom::test::small_hair().bytes);
  write(folder / "hair_file" / "points.hair", groom::test::small_hair(3).bytes);
  write(folder / "tressfx" / "three.tfx", groom::test::small_tfx_3().bytes);
  write(folder / "tressfx" / "four.tfx", groom::test::small_tfx_4().bytes);
  write(folder / "obj_lines" / "lines.obj",
        std::string("o hair\nv 0 0 0\nv 0 1 0\nv +1e0 2 0\ng tips\nl 1/1 2 \\\n 3\nl -2 -1\n"));
  write(folder / "gltf_lines" / "lines.glb", small_lines());
  write(folder / "groom_stream" / "groom",
        groom::encode_groom(*groom::read_hair_file(groom::test::small_hair().span())));
  write(folder / "groom_stream" / "error",
        groom::encode_groom(tl::unexpected(ToolError{ToolError::Kind::kBadInput, "x.hair: broken"})));
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
  write_fbx_objects(folder / "fbx_objects");
  write_outcomes(folder / "model_stream");
  write_grooms(folder);
  write(folder / "cache_entry" / "entry", coif::cache::encode_entry(coif::cache::small_entry()));
  write(folder / "recipe" / "every_key.recipe.json", coif::cook::print_recipe(coif::cook::default_recipe()));
}
