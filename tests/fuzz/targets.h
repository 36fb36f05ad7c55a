#pragma once
// Readers of foreign bytes, each as a function that any driver may call: libFuzzer with bytes of its own, replay.cpp
// with those of files.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace coif::fuzz {

using Input = std::span<const std::uint8_t>;

/// Hands the bytes to one reader, and what the reader accepts to whoever comes next. True where it accepted. A promise
/// of the reader that is broken ends the process.
struct Target {
  std::string_view name;
  bool (*run)(Input);
};

bool try_asset(Input input);         ///< A .coif, and a game that plays it.
bool try_cache_entry(Input input);   ///< A file of the cache of cooks.
bool try_can_fail(Input input);      ///< Reads nothing, but fails at an exclamation mark.
bool try_clip(Input input);          ///< The animation of a .gltf or .glb.
bool try_fbx_objects(Input input);   ///< The records of an .fbx that assimp passes over.
bool try_gltf_lines(Input input);    ///< Lines of a .gltf or .glb.
bool try_groom_stream(Input input);  ///< What the process that reads strands sends back.
bool try_hair_file(Input input);     ///< A .hair.
bool try_manifest(Input input);      ///< A list of assets to cook.
bool try_model_stream(Input input);  ///< What the import process sends back.
bool try_obj_lines(Input input);     ///< Lines of an .obj.
bool try_recipe(Input input);        ///< A recipe's text, and printing it.
bool try_tressfx(Input input);       ///< A .tfx.
bool try_vrm(Input input);           ///< The extensions of a .gltf, .glb or .vrm. False where it has no spring.

/// Those of the program: target_table.cpp has all, strand_table.cpp those that need no more than the readers of
/// strands.
std::span<const Target> all_targets();

/// Null where there is no target of that name; `usage` is then printed to the standard error output, with the names.
const Target* find_target(std::string_view name, const char* usage);

/// Ends the process, as a crash would, where `kept` is false.
void promise(bool kept, const char* what);

/// A file alone in a folder of its own, for readers that want a path. The folder goes with the object.
class LoneFile {
 public:
  explicit LoneFile(const char* name);
  ~LoneFile();
  LoneFile(const LoneFile&) = delete;
  LoneFile& operator=(const LoneFile&) = delete;

  /// The file with these bytes, instead of those before.
  const std::filesystem::path& with(Input bytes) const;

 private:
  std::filesystem::path folder_, path_;
};

}  // namespace coif::fuzz
