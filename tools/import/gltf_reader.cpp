#include "import/gltf_scene.h"

#include "base/text.h"
#include "gltf/document.h"
#include "import/shown_meshes.h"
#include "import/source_warnings.h"
#include "import/vrm_springs.h"

#include <iterator>

namespace coif::importer {
namespace {

using nlohmann::json;

tl::unexpected<ToolError> unreadable(const std::filesystem::path& path, const std::string& why,
                                     ToolError::Kind kind = ToolError::Kind::kBadInput) {
  return file_failure(kind, path, "cannot be read as glTF 2.0: {}", why);
}

/// glTF is in metres with Y up, unless the caller knows better.
Eigen::Affine3d model_from_gltf(const json& document, const ImportSettings& settings, SourceSpace& space) {
  space.generator = printable_text_of(member(member(document, "asset"), "generator"));
  space.unit = settings.metres_per_unit ? Statement::kGiven : Statement::kDeclared;
  space.up = settings.up_axis ? Statement::kGiven : Statement::kDeclared;
  space.unit_words = "glTF is in metres";
  space.up_words = "glTF has Y up";
  space.metres_per_unit = settings.metres_per_unit.value_or(1);
  const UpAxis up = settings.up_axis.value_or(UpAxis::kY);
  space.up_axis = up == UpAxis::kX ? 'x' : up == UpAxis::kY ? 'y' : 'z';
  Eigen::Affine3d out = Eigen::Affine3d::Identity();
  out.linear() = space.metres_per_unit * y_up_from(up);
  return out;
}

std::vector<std::string> names_of_images(const json& document) {
  std::vector<std::string> names;
  for (const json& image : list_of(member(document, "images"))) {
    const json& uri = member(image, "uri");
    if (uri.is_string() && !uri.get_ref<const std::string&>().starts_with("data:"))
      names.push_back(uri.get<std::string>());
  }
  return names;
}

bool hides_all_meshes(const json& document, const GltfNodes& nodes) {
  bool hides_one = false;
  for (std::size_t n = 0; n < nodes.in_file.size(); ++n) {
    const bool has_mesh =
        nodes.in_file[n] != kNoIndex && !member(list_of(member(document, "nodes"))[nodes.in_file[n]], "mesh").is_null();
    if (has_mesh && !nodes.is_hidden[n]) return false;
    hides_one = hides_one || has_mesh;
  }
  return hides_one;
}

}  // namespace

tl::expected<SourceModel, ToolError> read_gltf_model(const std::filesystem::path& path,
                                                     const ImportSettings& settings) {
  const auto document = gltf::read_gltf_json(path);
  if (!document) return unreadable(path, fmt::format("{}; {}", document.error(), kReexport));
  const GltfExtensions extensions = check_gltf_extensions(*document);
  if (!extensions.refusal.empty()) return unreadable(path, extensions.refusal, ToolError::Kind::kUnsupported);
  SourceModel model;
  model.path = path.string();
  set_importer(model);
  model.warnings = extensions.warnings;
  const Eigen::Affine3d to_model = model_from_gltf(*document, settings, model.space);
  gltf::GltfBuffers buffers(path, *document, settings.roots);
  const GltfNodes nodes = read_gltf_nodes(*document, to_model, model);
  const auto uvs = read_gltf_materials(*document, buffers, model);
  std::string bad = uvs ? read_gltf_meshes(*document, buffers, nodes, *uvs, settings.variant, model) : uvs.error();
  if (!bad.empty()) return unreadable(path, fmt::format("{}; {}", bad, kReexport));
  warn_of_respelled(buffers.respelled(), model.warnings);
  Diagnostics faults = check_gltf(path, *document, buffers);
  model.named_images = names_of_images(*document);
  model.side_files.assign(buffers.side_files().begin(), buffers.side_files().end());
  model.warnings.insert(model.warnings.end(), std::make_move_iterator(faults.begin()),
                        std::make_move_iterator(faults.end()));
  read_vrm_extensions(member(*document, "extensions"), nodes.of_file, to_model, model);
  if (auto kept = keep_shown_meshes(path, hides_all_meshes(*document, nodes), settings.meshes, model); !kept)
    return tl::unexpected(kept.error());
  return model;
}

}  // namespace coif::importer
