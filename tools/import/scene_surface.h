#pragma once

// Texture coordinates of textures in assimp's scene, and colours of its meshes.

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

/// The coordinates of a texture. V grows upwards.
struct TexturePlace {
  unsigned uv_set = 0;
  /// From the set's coordinates to the texture's.
  Eigen::Matrix2f linear = Eigen::Matrix2f::Identity();
  Eigen::Vector2f offset = Eigen::Vector2f::Zero();

  [[nodiscard]] bool operator==(const TexturePlace&) const = default;
  [[nodiscard]] Eigen::Vector2f operator()(const Eigen::Vector2f& uv) const { return linear * uv + offset; }
};

/// Data about textures in a COLLADA document that assimp 5.2 ignores: the UV set that <bind_vertex_input> binds,
/// <wrap_s> and <wrap_t>, and the channel of an opacity texture (<transparent opaque="RGB_ZERO">).
class ColladaTextures {
 public:
  enum class Use : std::uint8_t { kBase, kOpacity };

  explicit ColladaTextures(pugi::xml_document& document);
  /// The index of the UV set in assimp's mesh; none where the document does not bind one. `geometry` is an id;
  /// `material` is a name, or an id if it has none. Both as printable text.
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

  std::map<std::string, Effect> effects_;         // By id.
  std::map<std::string, std::string> effect_of_;  // By the material's name.
  std::map<std::tuple<std::string, std::string, Use>, unsigned> uv_sets_;
};

/// The placement of an FBX's textures, by the names of the material and of the image file.
class FbxTexturePlaces {
 public:
  explicit FbxTexturePlaces(const FbxObjects& objects);
  /// Null where the file has none. `file`: the image's path, of which only the name counts.
  [[nodiscard]] const FbxTexturePlace* find(const std::string& material, const std::string& file) const;

 private:
  std::map<std::pair<std::string, std::string>, FbxTexturePlace> places_;
};

/// The data of the file that reading its surfaces needs.
struct SourceSurface {
  SourceFormat format;
  std::string generator;                     ///< SourceSpace::generator: programs disagree about FBX.
  const ColladaTextures* collada = nullptr;  ///< For a COLLADA document; must outlive this.
  const ColladaNames* names = nullptr;       ///< For a COLLADA document.
  const FbxTexturePlaces* fbx = nullptr;     ///< For an FBX whose records can be read; must outlive this.
};

/// The placement of the base texture that convert_materials() takes, or else of the opacity texture. Warns if both
/// exist and differ, since a mesh keeps only one set. `geometry` is assimp's name of the mesh. assimp 5.2 reports the
/// transforms of FBX and COLLADA; apply_obj_options() reads an OBJ's library.
[[nodiscard]] TexturePlace texture_place(const aiMaterial& material, const std::string& geometry,
                                         const SourceSurface& surface, const std::string& label, Diagnostics& warnings);

/// Sets how the first texture of one of assimp's types continues outside 0..1. For FBX assimp 5.2 does not report it:
/// apply_fbx_wraps().
void read_wrap(const aiMaterial& material, unsigned type, SourceTexture& texture);

/// The first set's colour of each vertex, linear; empty where there is none. Formats other than glTF store the colours
/// of a screen, as Blender, Maya and MeshLab write them, or these as whole numbers up to 255.
[[nodiscard]] std::vector<Eigen::Vector4f> vertex_colors(const aiMesh& mesh);

/// Applies what assimp 5.2 drops or misreads in an OBJ's material libraries: options of map_Kd and map_d (it drops the
/// numbers of -s and -o, and takes the path for an option where there are two; -imfchan), and d and Tr, which it does
/// not report. Moves the coordinates of the meshes. `libraries` are plain_library_text() of files that were opened.
void apply_obj_options(std::span<const std::string> libraries, SourceModel& model);

}  // namespace coif::importer
