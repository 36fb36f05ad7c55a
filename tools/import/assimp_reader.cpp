#include "import/assimp_scene.h"

#include "base/files.h"
#include "base/text.h"
#include "import/asked_files.h"
#include "import/collada_document.h"
#include "import/fbx_objects.h"
#include "import/import.h"
#include "import/scene_surface.h"
#include "import/shown_meshes.h"
#include "import/source_warnings.h"

#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/version.h>
#include <fmt/format.h>
#include <assimp/Importer.hpp>

#include <algorithm>
#include <new>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace coif::importer {
namespace {

// JoinIdenticalVertices is left out on purpose: in 5.2 it leaves bone weights of vertices that it has removed.
constexpr unsigned kPostProcess = aiProcess_Triangulate | aiProcess_SortByPType;

// When the suffix's reader declines, assimp guesses from the content with any of its fifty readers. Keeping only those
// of the suffix means fewer parsers for a hostile file, and messages about the format that the artist meant.
void keep_readers_of(Assimp::Importer& importer, const std::string& suffix) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    Assimp::BaseImporter* const reader = importer.GetImporter(i);
    std::set<std::string> suffixes;
    reader->GetExtensionList(suffixes);
    if (suffixes.contains(suffix)) continue;
    importer.UnregisterLoader(reader);
    delete reader;  // Nobody's from then on: the importer forgets it and frees nothing.
  }
}

void configure(Assimp::Importer& importer, const SourceSuffix& suffix, const ImportSettings& settings) {
  keep_readers_of(importer, suffix.suffix + 1);
  // Pivots become nodes of their own, which flatten_nodes() folds again: assimp's own folding lets children inherit
  // transforms that are meant for a mesh alone.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, settings.up_axis.has_value());
}

/// The material libraries that a model names and that were not opened, each once. After each of them assimp also tries
/// a library with the model's own name, which the model may not name.
std::vector<std::string> lost_libraries(const Asked& asked, const std::string& model) {
  const std::string own = std::filesystem::path(model).replace_extension(".mtl").filename().string();
  std::vector<std::string> lost;
  for (const std::string& name : asked.not_opened) {
    const bool is_guess = !lost.empty() && std::filesystem::path(name).filename() == own;
    if (!is_guess && std::ranges::find(lost, name) == lost.end()) lost.push_back(name);
  }
  return lost;
}

/// Warns of a material library that was not read. assimp goes on without it, and the hair would silently be brown.
void warn_of_lost_library(const std::string& library, bool lies_outside, const aiScene& scene, SourceModel& model) {
  const std::string name =
      std::filesystem::path(library).lexically_proximate(std::filesystem::path(model.path).parent_path()).string();
  std::error_code error;
  const auto status = std::filesystem::symlink_status(library, error);
  const char* const why = std::filesystem::is_symlink(status)
                              ? "it is a link that leads out of the model's folder, which --root allows"
                          : !std::filesystem::exists(status) ? "there is no such file beside the model"
                          : lies_outside ? "it lies outside of the model's folder, which --root allows"
                                         : "it cannot be opened";
  const bool has_another =
      std::ranges::any_of(std::span(scene.mMaterials, scene.mNumMaterials),
                          [](const aiMaterial* m) { return m->GetName() != aiString(AI_DEFAULT_MATERIAL_NAME); });
  warn(model.warnings, source_code::kMaterials,
       "'{}' is named for the materials and was not read{}: {}; put the file beside the model, or export as .glb",
       printable_text(name, 100), has_another ? "" : ", so that none has a colour or texture", why);
}

std::string cure_for(const std::string& reason) {
  if (reason.find("referenced file") != std::string::npos)
    return "put that file beside it or export as .glb; where it lies in another folder or is a link, allow that folder "
           "with --root";
  return kReexport;
}

tl::unexpected<ToolError> refusal(const std::filesystem::path& path, const SourceSuffix& suffix,
                                  const char* assimp_text) {
  std::string reason = printable_text(assimp_text, 300);
  if (reason.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
  if (reason.find("No suitable reader") != std::string::npos) reason = "the content is not of that format, or damaged";
  while (reason.ends_with('.') || reason.ends_with(' ')) reason.pop_back();
  const std::string cure = cure_for(reason);
  return file_failure(ToolError::Kind::kBadInput, path, "cannot be read as {}: {}; {}", format_name(suffix.format),
                      reason, cure);
}

bool hides_all_meshes(const SceneNodes& nodes) {
  bool hides_one = false;
  for (std::size_t n = 0; n < nodes.origin.size(); ++n) {
    const bool has_mesh = nodes.origin[n]->mNumMeshes != 0;
    if (has_mesh && !nodes.is_hidden[n]) return false;
    hides_one = hides_one || has_mesh;
  }
  return hides_one;
}

void give_own_names(const UniqueFbxBones& bones, SceneNodes& nodes) {
  for (std::size_t n = 0; n < nodes.nodes.size(); ++n) {
    const auto found = nodes.model[n] == nullptr ? bones.names.end() : bones.names.find(nodes.model[n]->id);
    if (found != bones.names.end()) nodes.nodes[n].name = printable_text(found->second);
  }
}

/// Data of the file that assimp does not read: for FBX and COLLADA documents.
struct SourceText {
  std::vector<char> bytes = {};
  std::optional<UniqueFbxBones> unique_bones = {};
  std::optional<FbxObjects> objects = {};  ///< With the bones' unique names, as in assimp's scene.

  [[nodiscard]] std::string_view file() const { return {bytes.data(), bytes.size()}; }
};

void read_fbx_objects(SourceText& text) {
  text.objects = FbxObjects::read(text.file());
  if (text.objects) text.unique_bones = with_unique_bones(*text.objects, text.file());
  if (text.unique_bones) text.objects = FbxObjects::read(text.unique_bones->file);
}

tl::expected<SourceModel, ToolError> convert_scene(const aiScene& scene, const std::filesystem::path& path,
                                                   const SourceSuffix& suffix, const ImportSettings& settings,
                                                   const SourceText& text) {
  SourceModel model;
  model.path = path.string();
  set_importer(model);
  const Eigen::Affine3d to_model = model_from_scene(scene, suffix.format, settings, model.space, model.warnings);
  SceneNodes nodes = flatten_nodes(scene, to_model, model.warnings);
  const std::optional<FbxObjects>& objects = text.objects;
  if (objects) {
    add_fbx_objects(*objects, scene, nodes);
    if (text.unique_bones) give_own_names(*text.unique_bones, nodes);
    connect_fbx_textures(*objects, scene, model.warnings);
  }
  convert_materials(scene, suffix.format, model);
  if (objects) apply_fbx_wraps(*objects, model.materials);
  pugi::xml_document document = suffix.format == SourceFormat::kDae ? parse_collada(text.file()) : pugi::xml_document();
  mark_hidden_by_collada(document, nodes);
  const ColladaNames names(document);
  for (SourceNode& node : nodes.nodes) node.name = ColladaNames::find(names.nodes, node.name);
  const ColladaTextures collada(document);
  collada.apply(model.materials);
  warn_of_weights(document, model.warnings);
  model.named_images = named_images(scene);
  const auto places = objects ? std::optional(FbxTexturePlaces(*objects)) : std::nullopt;
  const SourceSurface surface{suffix.format, model.space.generator, &collada, &names, places ? &*places : nullptr};
  model.meshes = convert_meshes(scene, nodes, surface, model.warnings);
  const bool hides_all = hides_all_meshes(nodes);
  model.nodes = std::move(nodes.nodes);
  if (auto kept = keep_shown_meshes(path, hides_all, settings.meshes, model); !kept)
    return tl::unexpected(kept.error());
  return model;
}

}  // namespace

tl::expected<SourceModel, ToolError> read_with_assimp(const std::filesystem::path& path, const SourceSuffix& suffix,
                                                      const ImportSettings& settings) try {
  std::optional<std::string> plain;
  Diagnostics warnings;  // Warnings about what was normalised.
  SourceText text;
  if (suffix.format == SourceFormat::kDae) {
    text.bytes = bytes_of(path);
    if (auto fault = overrun_array(text.file())) return refusal(path, suffix, fault->c_str());
    plain = plain_collada(text.file(), warnings);
  }
  if (suffix.format == SourceFormat::kFbx) {
    text.bytes = bytes_of(path);
    read_fbx_objects(text);
    if (text.unique_bones) plain = text.unique_bones->file;
  }
  Asked asked;
  Assimp::Importer importer;
  const std::vector<std::filesystem::path> folders = folders_of_source(path, settings.roots);
  importer.SetIOHandler(new AskedFiles(path, std::move(plain), folders, suffix.format == SourceFormat::kObj,
                                       asked));  // Owned by the importer.
  configure(importer, suffix, settings);
  const aiScene* scene = importer.ReadFile(path.string(), kPostProcess);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    return refusal(path, suffix, importer.GetErrorString());
  }
  auto model = convert_scene(*scene, path, suffix, settings, text);
  asked.names.erase(path.string());
  if (model) model->warnings.insert(model->warnings.begin(), warnings.begin(), warnings.end());
  if (model) model->side_files.assign(asked.names.begin(), asked.names.end());
  if (model && suffix.format == SourceFormat::kObj) {
    apply_obj_options(asked.libraries, *model);
    warn_of_respelled(asked.respelled, model->warnings);
    for (const std::string& library : lost_libraries(asked, model->path)) {
      warn_of_lost_library(library, !lies_in(library, folders), *scene, *model);
    }
  }
  return model;
} catch (const std::bad_alloc&) {
  throw;
} catch (const std::exception& error) {
  return refusal(path, suffix, error.what());
}

void set_importer(SourceModel& model) {
  model.importer = importer_name();
  model.importer_version[0] = static_cast<std::uint16_t>(aiGetVersionMajor());
  model.importer_version[1] = static_cast<std::uint16_t>(aiGetVersionMinor());
  model.importer_version[2] = static_cast<std::uint16_t>(aiGetVersionPatch());
}

std::string importer_name() {
  return fmt::format("assimp {}.{}.{}", aiGetVersionMajor(), aiGetVersionMinor(), aiGetVersionPatch());
}

}  // namespace coif::importer
