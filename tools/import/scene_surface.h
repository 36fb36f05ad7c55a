#pragma once

// What a texture of assimp's scene says of coordinates, and what its meshes say of colours.

#include "import/fbx_objects.h"
#include "import/import.h"
#include "import/source_model.h"

#include <Eigen/Core>

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace pugi {
class xml_document;
}

struct aiMaterial;
struct aiMesh;
struct aiScene;

namespace coif::importer {

struct ColladaNames;

/// Which coordinates a texture is looked up at. V grows upwards.
struct TexturePlace {
  unsigned uv_set = 0;
  /// From the set's coordinates to the texture's.
  Eigen::Matrix2f linear = Eigen::Matrix2f::Identity();
  Eigen::Vector2f offset = Eigen::Vector2f::Zero();

  [[nodiscard]] bool operator==(const TexturePlace&) const = default;
  [[nodiscard]] Eigen::Vector2f operator()(const Eigen::Vector2f& uv) const { return linear * uv + offset; }
};

/// What a COLLADA document says of its textures that assimp 5.2 passes over: which UV set <bind_vertex_input> binds a
/// texture's coordinates to, <wrap_s> and <wrap_t>, and which numbers of an opacity texture count (<transparent
/// opaque="RGB_ZERO">).
class ColladaTextures {
 public:
  enum class Use : std::uint8_t { kBase, kOpacity };

  explicit ColladaTextures(pugi::xml_document& document);
  /// Which of the sets that assimp gives the mesh; none where the document does not bind one. A geometry goes by its
  /// id, a material by its name, or its id where it has none; both as printable text.
  [[nodiscard]] std::optional<unsigned> uv_set(const std::string& geometry, const std::string& material, Use use) const;
  /// Wrap modes of base and opacity textures, channel and sense of the latter.
  void apply(std::span<SourceMaterial> materials) const;

 private:
  class Walk;
  struct Texture {
    std::string texcoord;
    std::optional<TextureWrap> wrap[2];
  };
  struct Effect {
    std::optional<Texture> base, opacity;
    TextureChannel opacity_channel = TextureChannel::kAuto;
    bool opacity_inverted = false;
  };

  std::map<std::string, Effect> effects_;         // by id
  std::map<std::string, std::string> effect_of_;  // by the material's name
  std::map<std::tuple<std::string, std::string, Use>, unsigned> uv_sets_;
};

/// Where the textures of an FBX lie, by the material's name and the image file's.
class FbxTexturePlaces {
 public:
  explicit FbxTexturePlaces(const FbxObjects& objects);
  /// Null where the file does not say. `file`: the image's path, of which the name counts.
  [[nodiscard]] const FbxTexturePlace* find(const std::string& material, const std::string& file) const;

 private:
  std::map<std::pair<std::string, std::string>, FbxTexturePlace> places_;
};

/// What is needed of the file to read its surfaces.
struct SourceSurface {
  SourceFormat format;
  std::string generator;                     ///< SourceSpace::generator: programs disagree about FBX.
  const ColladaTextures* collada = nullptr;  ///< Of a COLLADA document; outlives this.
  const ColladaNames* names = nullptr;       ///< Of such a document.
  const FbxTexturePlaces* fbx = nullptr;     ///< Of an FBX whose records can be read; outlives this.
};

/// The place of the base texture that convert_materials() takes, or of the opacity texture where there is no other. A
/// warning where both are there and differ, since a mesh keeps one set alone. `geometry` is what assimp calls the mesh.
/// assimp 5.2 hands on the transforms of FBX and COLLADA; an OBJ's library is read by apply_obj_options().
[[nodiscard]] TexturePlace texture_place(const aiMaterial& material, const std::string& geometry,
                                         const SourceSurface& surface, const std::string& label, Diagnostics& warnings);

/// How the first texture of one of assimp's types goes on outside 0..1. Of FBX assimp 5.2 does not say:
/// apply_fbx_wraps().
void read_wrap(const aiMaterial& material, unsigned type, SourceTexture& texture);

/// Colours of the first set, linear, of each vertex; empty where there are none. Formats other than glTF store what a
/// screen shows, as Blender, Maya and MeshLab write them, or whole numbers up to 255 of it.
[[nodiscard]] std::vector<Eigen::Vector4f> vertex_colors(const aiMesh& mesh);

/// What assimp 5.2 drops or misreads of an OBJ's material libraries: options of map_Kd and map_d (-s and -o, of which
/// it drops the numbers, and takes the path for one where there are two; -imfchan), and d and Tr, of which it hands on
/// no colour's alpha. Moves the coordinates of the meshes; `libraries` are plain_library_text() of files that were
/// opened.
void apply_obj_options(std::span<const std::string> libraries, SourceModel& model);

}  // namespace coif::importer
