#include "base/words.h"
#include "cook/recipe/hair_recipe.h"
#include "cook/select/hair_evidence.h"
#include "cook/select/select_hair.h"
#include "cook/select/under_hair.h"

#include "import/source_warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <functional>

namespace coif::cook {
namespace {
using importer::SourceMesh, importer::SourceModel;

using Names = std::vector<std::string>;

constexpr double kMovedByHairBones = 0.03;  ///< Share of a piece's weight: a fringe mostly follows the head.
constexpr double kSurelyMoved = 0.4;        ///< At some vertex; faces under a fringe have only a touch of its bones.

const importer::SourceMaterial* material_of(const SourceModel& source, const SourceMesh& mesh) {
  return mesh.material < source.materials.size() ? &source.materials[mesh.material] : nullptr;
}

/// The file's own name of a texture, without the folders of the artist's machine.
std::string texture_name(const SourceModel& source, const SourceMesh& mesh) {
  const importer::SourceMaterial* material = material_of(source, mesh);
  if (!material) return "";
  const importer::SourceTexture& texture = material->base_texture;
  const std::string& name = texture.image < source.images.size() ? source.images[texture.image].name : texture.path;
  const std::size_t slash = name.find_last_of("/\\");
  return slash == std::string::npos ? name : name.substr(slash + 1);
}

tl::unexpected<ToolError> bad_input(const SourceModel& source, const std::string& what) {
  return tl::unexpected(ToolError{ToolError::Kind::kBadInput, fmt::format("{}: {}", source.path, what)});
}

/// Collects a choice mesh by mesh.
class Chooser {
 public:
  Chooser(const SourceModel& source, const HairRecipe& recipe, Findings& findings)
      : source_(source), recipe_(recipe), findings_(findings) {
    choice_.taken.resize(source.meshes.size());
  }

  [[nodiscard]] bool found() const { return found_ > 0; }
  [[nodiscard]] const HairChoice& so_far() const { return choice_; }

  void take_mesh(std::uint32_t m, const std::string& why) {
    const std::size_t count = source_.meshes[m].triangles.size() / 3;
    choice_.taken[m].assign(count, true);
    note(m, count, why);
  }

  /// Takes the pieces of mesh `m` for which `fits`.
  void take_pieces(std::uint32_t m, const std::vector<bool>& bones, std::uint32_t head, const std::string& why,
                   const std::function<bool(const PieceEvidence&)>& fits) {
    const SourceMesh& mesh = source_.meshes[m];
    const MeshPieces pieces = find_pieces(mesh, recipe_.patch_weld_distance);
    const std::vector<PieceEvidence> evidence = weigh_pieces(source_, mesh, pieces, bones, head);
    std::vector<bool> taken;
    for (std::uint32_t piece : pieces.piece_of) taken.push_back(fits(evidence[piece]));
    take_triangles(m, std::move(taken), why);
  }

  void take_triangles(std::uint32_t m, std::vector<bool> taken, const std::string& why) {
    const auto count = std::size_t(std::ranges::count(taken, true));
    if (count == 0) return;
    if (choice_.taken[m].empty()) {
      choice_.taken[m] = std::move(taken);
    } else {
      for (std::size_t t = 0; t < taken.size(); ++t) choice_.taken[m][t] = choice_.taken[m][t] || taken[t];
    }
    note(m, count, why);
  }

  HairChoice finish() && {
    for (std::uint32_t m = 0; m < source_.meshes.size(); ++m) {
      const std::size_t count = source_.meshes[m].triangles.size() / 3;
      const auto taken = std::size_t(std::ranges::count(choice_.taken[m], true));
      if (taken == 0) {
        findings_.leave_out({fmt::format("mesh '{}' ({} triangles)", source_.meshes[m].name, count), "not hair"});
      } else if (taken < count) {
        findings_.leave_out({fmt::format("mesh '{}', {} triangles", source_.meshes[m].name, count - taken),
                             "of pieces that are not hair"});
      }
    }
    return std::move(choice_);
  }

  void warn(const char* code, std::string text) { findings_.warn(code, std::move(text)); }

 private:
  void note(std::uint32_t m, std::size_t triangles, const std::string& why) {
    found_ += triangles;
    findings_.note(fmt::format("hair: mesh '{}' ({} triangles): {}", source_.meshes[m].name, triangles, why));
  }

  const SourceModel& source_;
  const HairRecipe& recipe_;
  Findings& findings_;
  HairChoice choice_;
  std::size_t found_ = 0;
};

void choose_by_recipe(const SourceModel& source, const HairRecipe& recipe, Chooser& chooser) {
  std::vector<bool> bones;
  for (const importer::SourceNode& node : source.nodes) bones.push_back(matches_any(node.name, recipe.hair_bones));
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    const SourceMesh& mesh = source.meshes[m];
    if (!recipe.hair_meshes.empty() && !matches_any(mesh.name, recipe.hair_meshes)) continue;
    if (!recipe.hair_materials.empty() && !matches_any(material_name(source, mesh), recipe.hair_materials)) continue;
    if (recipe.hair_bones.empty()) {
      chooser.take_mesh(m, "the recipe names it");
    } else {
      chooser.take_pieces(m, bones, importer::kNoIndex, "pieces that bones named in the recipe move",
                          [](const PieceEvidence& piece) { return piece.largest_triangle_share > 0.5; });
    }
  }
}

/// Another part of the same mesh has a material with a hair name: then this part is worn in the hair.
bool has_hair_beside(const SourceModel& source, const SourceMesh& mesh) {
  return std::ranges::any_of(source.meshes, [&](const SourceMesh& other) {
    return other.node == mesh.node && is_called_hair(material_name(source, other));
  });
}

/// The reason why a mesh's names make it hair; empty where they do not.
std::string named_hair(const SourceModel& source, const SourceMesh& mesh) {
  const std::string material = material_name(source, mesh), texture = texture_name(source, mesh);
  if (is_called_hair(material)) return fmt::format("its material is called '{}'", material);
  if (is_called_adornment(material) || has_hair_beside(source, mesh)) return "";
  if (is_called_hair(mesh.name)) return "its name says so";
  if (!is_called_adornment(mesh.name) && is_called_hair(texture)) {
    return fmt::format("its texture is called '{}'", texture);
  }
  return "";
}

void choose_by_name(const SourceModel& source, const std::vector<bool>& bones, std::uint32_t head, Chooser& chooser) {
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    const std::string why = named_hair(source, source.meshes[m]);
    if (why.empty()) continue;
    chooser.take_pieces(m, bones, head, why, [](const PieceEvidence& piece) { return piece.eye_bone_share < 0.5; });
  }
}

void choose_by_bones(const SourceModel& source, const std::vector<bool>& bones, std::uint32_t head, Chooser& chooser) {
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    chooser.take_pieces(m, bones, head, "pieces that hair bones move", [](const PieceEvidence& piece) {
      return piece.hair_bone_share >= kMovedByHairBones && piece.largest_hair_bone >= kSurelyMoved;
    });
  }
}

bool is_transparent(const SourceModel& source, const SourceMesh& mesh) {
  const importer::SourceMaterial* material = material_of(source, mesh);
  if (!material) return false;
  return material->alpha_use == importer::AlphaUse::kBlend || material->alpha_use == importer::AlphaUse::kMask ||
         is_called_transparent(material->name) || is_called_transparent(texture_name(source, mesh));
}

void choose_by_transparency(const SourceModel& source, const std::vector<bool>& bones, std::uint32_t head,
                            Chooser& chooser) {
  if (head == importer::kNoIndex) return;
  const double neck = source.nodes[head].model_from_node.translation().y();
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    if (!is_transparent(source, source.meshes[m])) continue;
    const bool rigid = source.meshes[m].influence_begin.empty();
    chooser.take_pieces(m, bones, head, "transparent pieces on the head", [&](const PieceEvidence& piece) {
      const bool on_head = rigid ? piece.height > neck : piece.head_share >= kOnHead;
      return on_head && piece.eye_bone_share < kMovedByEyes;
    });
  }
}

void take_caps(const SourceModel& source, Chooser& chooser) {
  const std::vector<bool> caps = find_scalp_caps(source, chooser.so_far());
  for (std::uint32_t m = 0; m < caps.size(); ++m) {
    if (!caps[m] || either_is_called(source, source.meshes[m], is_called_adornment)) continue;
    chooser.take_mesh(m, "it lies under the hair, on the scalp");
  }
}

void take_cores(const SourceModel& source, std::uint32_t head, Chooser& chooser) {
  HairChoice cores = find_hair_cores(source, chooser.so_far(), head);
  for (std::uint32_t m = 0; m < cores.taken.size(); ++m) {
    if (either_is_called(source, source.meshes[m], is_called_adornment)) continue;
    chooser.take_triangles(m, std::move(cores.taken[m]), "what hair is wrapped around, in the mesh of a head");
  }
}

/// Takes what covers the crown, too, where what was found leaves it bare.
void take_crown(HairChoice cover, Chooser& chooser) {
  chooser.warn(
      "S202",
      "what is called hair leaves the crown of the head bare; what covers it was taken, too: name the hair by the "
      "recipe's \"hair\" if that is something else");
  for (std::uint32_t m = 0; m < cover.taken.size(); ++m)
    chooser.take_triangles(m, std::move(cover.taken[m]), "it covers the crown of the head");
}

/// The mesh that a hint names: the first that covers the crown of the head, else the first of all.
std::string likeliest_mesh(const SourceModel& source, const CrownCover& cover) {
  for (std::size_t m = 0; m < source.meshes.size(); ++m)
    if (!cover.choice.taken[m].empty()) return source.meshes[m].name;
  return source.meshes.empty() ? "..." : source.meshes[0].name;
}

/// The error for a character on which nothing shows what hair is: a body is never cooked.
tl::unexpected<ToolError> no_hair_on(const SourceModel& source, const CrownCover& cover) {
  std::vector<std::string> meshes;
  for (const SourceMesh& mesh : source.meshes) {
    meshes.push_back(fmt::format("mesh '{}' (material '{}')", mesh.name, material_name(source, mesh)));
  }
  return bad_input(
      source, fmt::format("nothing in this character is called hair, moved by hair bones or transparent on the head; "
                          "name what is hair in a recipe, as in {{\"hair\": {{\"meshes\": [\"{}\"]}}}}; there are: {}",
                          likeliest_mesh(source, cover), fmt::join(meshes, ", ")));
}

/// Whether a file without a word of hair in it is called hair itself.
bool is_file_called_hair(const SourceModel& source) {
  return is_called_hair(std::filesystem::path(source.path).stem().string());
}

/// The error for a model with the form of a body. Exporters most often leave curves and particles out of such a file.
tl::unexpected<ToolError> no_hair_in_body(const SourceModel& source) {
  std::vector<std::string> meshes;
  for (const SourceMesh& mesh : source.meshes) {
    meshes.push_back(fmt::format("mesh '{}' (material '{}')", mesh.name, material_name(source, mesh)));
  }
  const std::string node = empty_hair_node(source);
  const bool hides_meshes = std::ranges::any_of(
      source.warnings, [](const Diagnostic& warning) { return warning.code == importer::source_code::kHidden; });
  const std::string lost = hides_meshes   ? "the file hides other meshes, which are not read: show the hair; "
                           : node.empty() ? ""
                                          : fmt::format("node '{}' has no mesh, so its hair was not exported; ", node);
  return bad_input(source,
                   fmt::format("there is no hair, only what looks like a body: {}; {}export the hair, too: Blender "
                               "leaves curves and hair particles out "
                               "unless they are meshes (Object > Convert > Mesh, then export glTF with Data > Mesh > "
                               "Loose Edges), or export strands "
                               "by themselves and name this file by \"cards.body\"; if it is hair, say so in a recipe: "
                               "{{\"hair\": {{\"meshes\": [\"{}\"]}}}}",
                               fmt::join(meshes, ", "), lost, source.meshes.empty() ? "..." : source.meshes[0].name));
}

void take_everything(const SourceModel& source, std::uint32_t head, Chooser& chooser) {
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    chooser.take_mesh(m, "nothing in the file says what is hair, so all of it is");
  }
  if (head == importer::kNoIndex) return;  // A file without a body is a hairstyle.
  chooser.warn(
      "S202",
      "nothing in the file is called hair, moved by hair bones or transparent on the head; the whole model was taken: "
      "name the hair by the recipe's \"hair\"");
}

}  // namespace

tl::expected<HairChoice, ToolError> choose_hair(const SourceModel& source, const HairRecipe& recipe,
                                                Findings& findings) {
  if (auto ok = check_hair_names(source, recipe); !ok) return tl::unexpected(ok.error());
  Chooser chooser(source, recipe, findings);
  if (!recipe.hair_meshes.empty() || !recipe.hair_materials.empty() || !recipe.hair_bones.empty()) {
    choose_by_recipe(source, recipe, chooser);
    return std::move(chooser).finish();
  }
  const std::uint32_t head = guess_head_node(source);
  const std::vector<bool> bones = find_hair_bones(source);
  choose_by_name(source, bones, head, chooser);
  if (!chooser.found()) choose_by_bones(source, bones, head, chooser);
  if (!chooser.found()) choose_by_transparency(source, bones, head, chooser);
  CrownCover cover = find_crown_cover(source, chooser.so_far(), head, recipe.patch_weld_distance);
  if (!chooser.found() && moves_limbs(source)) return no_hair_on(source, cover);
  if (chooser.found() && cover.found) take_crown(std::move(cover.choice), chooser);
  const bool is_body =
      !chooser.found() && !is_file_called_hair(source) && is_bare_body(source, recipe.patch_weld_distance);
  if (is_body) return no_hair_in_body(source);
  if (!chooser.found()) take_everything(source, head, chooser);
  take_caps(source, chooser);
  take_cores(source, head, chooser);
  return std::move(chooser).finish();
}

}  // namespace coif::cook
