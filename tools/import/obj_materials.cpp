#include "import/scene_surface.h"

#include "base/text.h"
#include "import/source_warnings.h"

#include <assimp/material.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

namespace coif::importer {
namespace {

constexpr std::size_t kLongestLine = 4096;
constexpr float kFarthestRepeat = 1e4f;

/// The parts of a statement such as "map_Kd -s 2 2 1 -o 0.5 0 0 -clamp on my hair.png".
struct ObjTexture {
  std::string path;
  TexturePlace place;
  TextureChannel channel = TextureChannel::kAuto;
  TextureWrap wrap = TextureWrap::kRepeat;
};

std::optional<float> written_number(const std::string& word) {
  char* end = nullptr;
  const float number = std::strtof(word.c_str(), &end);
  const bool is_whole = !word.empty() && end == word.c_str() + word.size();
  return is_whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

TextureChannel channel_called(const std::string& word) {
  constexpr std::pair<std::string_view, TextureChannel> kChannels[] = {
      {"r", TextureChannel::kRed},   {"g", TextureChannel::kGreen},     {"b", TextureChannel::kBlue},
      {"m", TextureChannel::kAlpha}, {"l", TextureChannel::kLuminance}, {"z", TextureChannel::kAuto}};
  const auto* const found =
      std::ranges::find(kChannels, std::string_view(word), &std::pair<std::string_view, TextureChannel>::first);
  return found == std::end(kChannels) ? TextureChannel::kAuto : found->second;
}

/// Reads the words of a statement one after the other; the rest is a path, which may contain blanks.
class ObjWords {
 public:
  explicit ObjWords(const std::string& statement) : text_(statement) { skip(); }

  [[nodiscard]] std::string next() const { return text_.substr(at_, text_.find_first_of(" \t", at_) - at_); }
  [[nodiscard]] std::string rest() const { return text_.substr(at_); }
  std::string take() {
    const std::string word = next();
    at_ += word.size();
    skip();
    return word;
  }
  /// Reads up to three numbers; later ones may be missing and are then taken from `given`.
  Eigen::Vector3f take_numbers(Eigen::Vector3f given) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto number = written_number(next());
      if (!number) break;
      given[axis] = *number;
      (void)take();
    }
    return given;
  }

 private:
  void skip() { at_ = std::min(text_.find_first_not_of(" \t", at_), text_.size()); }

  std::string text_;
  std::size_t at_ = 0;
};

/// Moves options that some programs write after the file's name ("hair.png -s 2 2 1") to the front. They are recognised
/// after the suffix.
std::string with_options_first(const std::string& statement) {
  constexpr std::string_view kOptions[] = {"-s",      "-o",      "-t",  "-mm",    "-clamp", "-imfchan", "-blendu",
                                           "-blendv", "-texres", "-bm", "-boost", "-cc",    "-type"};
  if (statement.starts_with('-')) return statement;
  for (std::size_t at = statement.find(" -"); at != std::string::npos; at = statement.find(" -", at + 1)) {
    const std::string word = statement.substr(at + 1, statement.find_first_of(" \t", at + 1) - at - 1);
    const std::string path = statement.substr(0, statement.find_last_not_of(" \t", at) + 1);
    const bool ends_in_suffix =
        path.find_last_of('.') != std::string::npos && path.size() - path.find_last_of('.') <= 5;
    if (ends_in_suffix && std::ranges::find(kOptions, word) != std::end(kOptions))
      return statement.substr(at + 1) + ' ' + path;
  }
  return statement;
}

ObjTexture read_statement(const std::string& written) {
  ObjTexture texture;
  const std::string statement = with_options_first(written);
  ObjWords words(statement);
  while (words.next().starts_with('-')) {
    const std::string option = words.take();
    if (option == "-s") {
      texture.place.linear = words.take_numbers({1, 1, 1}).head<2>().asDiagonal();
    } else if (option == "-o") {
      texture.place.offset = words.take_numbers({0, 0, 0}).head<2>();
    } else if (option == "-t" || option == "-mm") {
      (void)words.take_numbers({0, 0, 0});
    } else if (option == "-clamp") {
      texture.wrap = words.take() == "on" ? TextureWrap::kClamp : TextureWrap::kRepeat;
    } else if (option == "-imfchan") {
      texture.channel = channel_called(words.take());
    } else {
      (void)words.take();  // the word that each of the other options has
    }
  }
  texture.path = printable_text(utf8_of(words.rest()));
  return texture;
}

/// A material in a library, with the values that assimp does not report.
struct ObjMaterial {
  std::optional<ObjTexture> base, opacity;
  std::optional<float> dissolve, transparency;  ///< "d" and "Tr".
  std::string transparency_map;                 ///< "map_Tr", which is no part of the format; "": none.
};
using ObjMaterials = std::map<std::string, ObjMaterial>;  // By name.

void read_library(const std::string& text, ObjMaterials& materials) {
  std::istringstream lines(text);
  ObjMaterial* material = nullptr;
  std::string statement;
  for (std::string line; std::getline(lines, line);) {
    if (line.size() > kLongestLine) continue;
    std::istringstream words(line);
    std::string keyword;
    words >> keyword >> std::ws;
    statement.clear();
    std::getline(words, statement);
    if (keyword == "newmtl") material = &materials[printable_text(statement)];
    if (material == nullptr) continue;
    if (keyword == "map_Kd") material->base = read_statement(statement);
    if (keyword == "map_d") material->opacity = read_statement(statement);
    if (keyword == "d") material->dissolve = written_number(statement);
    if (keyword == "map_Tr") material->transparency_map = read_statement(statement).path;
    if (keyword == "Tr") material->transparency = written_number(statement);
  }
}

void take_over(const ObjTexture& said, SourceTexture& texture) {
  if (!said.path.empty()) texture.path = said.path;
  texture.wrap[0] = texture.wrap[1] = said.wrap;
}

/// V of a model grows downwards, V of the placement upwards.
void move_uvs(const TexturePlace& place, SourceMesh& mesh) {
  for (Eigen::Vector2f& uv : mesh.uvs) {
    const Eigen::Vector2f moved = place({uv.x(), 1 - uv.y()});
    const bool is_usable = moved.allFinite() && moved.cwiseAbs().maxCoeff() <= kFarthestRepeat;
    uv = is_usable ? Eigen::Vector2f(moved.x(), 1 - moved.y()) : Eigen::Vector2f(Eigen::Vector2f::Zero());
  }
}

/// The opacity of a material as a whole, a factor on its texture's alpha. Nobody makes a fully transparent material for
/// hair: exporters write "d 0" or "Tr 1" beside a texture whose alpha is meant, and some write Tr for d. So that is
/// ignored.
void take_over_dissolve(const ObjMaterial& said, SourceMaterial& material, Diagnostics& warnings) {
  constexpr float kSeen = 1e-3f;
  if (!said.dissolve && !said.transparency) return;
  const float alpha = said.dissolve ? *said.dissolve : 1 - *said.transparency;
  if (alpha >= 1) return;
  if (alpha > kSeen) {
    material.base_color.w() = alpha;
    material.alpha_use = AlphaUse::kBlend;
    return;
  }
  warn(warnings, source_code::kClear,
       "material '{}': its .mtl says that it is wholly transparent ({}), and nothing would be seen; it is taken for "
       "opaque but for the alpha of its textures; set its opacity to 1 and export again",
       material.name, said.dissolve ? "d 0" : "Tr 1");
}

/// The colour multiplies the texture; exporters that mean the texture alone write black.
void take_over_color(const ObjMaterial& said, SourceMaterial& material, Diagnostics& warnings) {
  if (!said.base || !material.base_color.head<3>().isZero(0)) return;
  material.base_color.head<3>().setOnes();
  warn(warnings, source_code::kClear,
       "material '{}': its .mtl says that it is black (Kd 0 0 0), and nothing would be seen of '{}'; the texture is "
       "taken as "
       "it is; set the diffuse colour to white and export again",
       material.name, said.base->path);
}

void take_over_textures(const ObjMaterial& said, SourceMaterial& material, Diagnostics& warnings) {
  if (said.base) take_over(*said.base, material.base_texture);
  if (!said.transparency_map.empty() && !said.opacity) {
    warn(warnings, source_code::kImages,
         "material '{}': map_Tr '{}' is not read, since programs disagree whether its white is clear; name it map_d in "
         "the "
         ".mtl, or in the recipe as \"textures.opacity\"",
         material.name, said.transparency_map);
  }
  if (!said.opacity) return;
  if (said.base && said.base->path == said.opacity->path) {
    material.opacity_texture = {};  // One image for both: its own alpha.
    return;
  }
  take_over(*said.opacity, material.opacity_texture);
  material.opacity_channel = said.opacity->channel;
  if (!said.base || said.base->place == said.opacity->place) return;
  warn(warnings, source_code::kUvs,
       "material '{}': map_d is placed otherwise than map_Kd (-s, -o), whose place is taken for "
       "both; give both the same options in the .mtl",
       material.name);
}

TexturePlace place_of(const ObjMaterial& said) {
  return said.base ? said.base->place : said.opacity ? said.opacity->place : TexturePlace{};
}

/// assimp makes a plain material for each name that is in no library.
void warn_of_absent(const ObjMaterials& materials, const SourceModel& model, Diagnostics& warnings) {
  std::set<std::string> absent;
  for (const SourceMesh& mesh : model.meshes) {
    const std::string name = material_name(model, mesh);
    if (name.empty() || name == AI_DEFAULT_MATERIAL_NAME || materials.contains(name) || !absent.insert(name).second)
      continue;
    warn(warnings, source_code::kMaterials,
         "mesh '{}' has the material '{}', which its .mtl does not have, so that it has no colour and no texture; name "
         "one of those in the .mtl, or export both files together",
         mesh.name, name);
  }
}

}  // namespace

void apply_obj_options(std::span<const std::string> libraries, SourceModel& model) {
  ObjMaterials materials;
  for (const std::string& library : libraries) read_library(library, materials);
  if (!materials.empty()) warn_of_absent(materials, model, model.warnings);
  for (SourceMaterial& material : model.materials) {
    const auto said = materials.find(material.name);
    if (said == materials.end()) continue;
    take_over_textures(said->second, material, model.warnings);
    take_over_dissolve(said->second, material, model.warnings);
    take_over_color(said->second, material, model.warnings);
    for (const auto* const texture : {&said->second.base, &said->second.opacity}) {
      if (*texture && !(*texture)->path.empty()) model.named_images.push_back((*texture)->path);
    }
  }
  std::ranges::sort(model.named_images);
  model.named_images.erase(std::unique(model.named_images.begin(), model.named_images.end()), model.named_images.end());
  for (SourceMesh& mesh : model.meshes) {
    const auto said = materials.find(material_name(model, mesh));
    if (said == materials.end()) continue;
    const TexturePlace place = place_of(said->second);
    if (!(place == TexturePlace{})) move_uvs(place, mesh);
  }
}

}  // namespace coif::importer
