#include "import/scene_surface.h"

#include "base/text.h"
#include "import/source_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>

namespace coif {
namespace {

constexpr std::size_t kLongestLine = 4096;
constexpr float kFarthestRepeat = 1e4f;

/// What a statement says: "map_Kd -s 2 2 1 -o 0.5 0 0 -clamp on my hair.png".
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

/// The words of a statement, one after the other; what is left is a path, which may have spaces.
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
  /// Up to three numbers, of which later ones may be left out; returns them in place of what `given` has.
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

ObjTexture read_statement(const std::string& statement) {
  ObjTexture texture;
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
  texture.path = printable_text(words.rest());
  return texture;
}

struct ObjTextures {
  std::map<std::string, ObjTexture> base, opacity;  ///< By the material's name.
};

void read_library(const std::string& path, ObjTextures& textures) {
  std::ifstream file(path);
  std::string material, statement;
  for (std::string line; std::getline(file, line);) {
    if (line.size() > kLongestLine) continue;
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t')) line.pop_back();
    std::istringstream words(line);
    std::string keyword;
    words >> keyword >> std::ws;
    statement.clear();
    std::getline(words, statement);
    if (keyword == "newmtl") material = printable_text(statement);
    if (keyword == "map_Kd" || keyword == "map_kd") textures.base.insert_or_assign(material, read_statement(statement));
    if (keyword == "map_d") textures.opacity.insert_or_assign(material, read_statement(statement));
  }
}

void take_over(const ObjTexture& said, SourceTexture& texture) {
  if (!said.path.empty()) texture.path = said.path;
  texture.wrap[0] = texture.wrap[1] = said.wrap;
}

const ObjTexture* said_of(const std::map<std::string, ObjTexture>& textures, const std::string& material) {
  const auto found = textures.find(material);
  return found == textures.end() ? nullptr : &found->second;
}

/// V of a model grows downwards, that of the place upwards.
void move_uvs(const TexturePlace& place, SourceMesh& mesh) {
  for (Eigen::Vector2f& uv : mesh.uvs) {
    const Eigen::Vector2f moved = place({uv.x(), 1 - uv.y()});
    const bool is_usable = moved.allFinite() && moved.cwiseAbs().maxCoeff() <= kFarthestRepeat;
    uv = is_usable ? Eigen::Vector2f(moved.x(), 1 - moved.y()) : Eigen::Vector2f(Eigen::Vector2f::Zero());
  }
}

}  // namespace

void apply_obj_options(std::span<const std::string> libraries, SourceModel& model) {
  ObjTextures textures;
  for (const std::string& library : libraries) read_library(library, textures);
  for (SourceMaterial& material : model.materials) {
    const ObjTexture *const base = said_of(textures.base, material.name), *const opacity =
                                                                              said_of(textures.opacity, material.name);
    if (base != nullptr) take_over(*base, material.base_texture);
    const bool is_own = opacity != nullptr && (base == nullptr || base->path != opacity->path);
    if (is_own) {
      take_over(*opacity, material.opacity_texture);
      material.opacity_channel = opacity->channel;
    } else if (opacity != nullptr) {
      material.opacity_texture = {};  // one image for both: its own alpha
    }
    if (is_own && base != nullptr && !(base->place == opacity->place)) {
      warn(model.warnings, source_code::kUvs,
           "material '{}': map_d is placed otherwise than map_Kd (-s, -o), whose place is taken for "
           "both; give both the same options in the .mtl",
           material.name);
    }
  }
  for (SourceMesh& mesh : model.meshes) {
    const std::string name = material_name(model, mesh);
    const ObjTexture *const base = said_of(textures.base, name), *const opacity = said_of(textures.opacity, name);
    const TexturePlace place = base != nullptr ? base->place : opacity != nullptr ? opacity->place : TexturePlace{};
    if (!(place == TexturePlace{})) move_uvs(place, mesh);
  }
}

}  // namespace coif
