#include "report/picture/truth_folder.h"

#include "base/files.h"
#include "base/json.h"
#include "render/camera_file.h"

#include <fmt/format.h>

namespace coif::report {
namespace {

tl::expected<TruthScene, std::string> scene_of(const nlohmann::json& json, const std::filesystem::path& folder,
                                               const Eigen::Vector3d& joint) {
  TruthScene scene;
  for (const auto& [name, text] : {std::pair{"view", &scene.view}, {"color", &scene.color}, {"light", &scene.light}}) {
    *text = printable_text_of(member(json, name));
    if (text->empty()) return tl::unexpected(fmt::format("it has no text '{}'", name));
  }
  const nlohmann::json& pictures = list_of(member(json, "pictures"));
  if (pictures.size() != 2) return tl::unexpected(std::string("'pictures' are not two files"));
  for (std::size_t i = 0; i < 2; ++i) {
    if (!pictures[i].is_string()) return tl::unexpected(std::string("'pictures' are not two files"));
    scene.files[i] = folder / pictures[i].get<std::string>();
  }
  const auto camera = render::camera_of_json(member(json, "camera"), joint);
  if (!camera) return tl::unexpected(camera.error());
  scene.camera = *camera;
  auto lights = render::lights_of_json(member(json, "lights"));
  if (!lights) return tl::unexpected(lights.error());
  scene.lights.lights = std::move(*lights);
  const auto sky = render::vector_of_json(member(json, "sky"));
  if (!sky) return tl::unexpected(std::string("it has no 'sky' of three numbers"));
  for (std::size_t k = 0; k < 3; ++k) scene.lights.sky[k] = float((*sky)[Eigen::Index(k)]);
  if (const auto color = render::vector_of_json(member(json, "base_color"))) scene.base_color = color->cast<float>();
  return scene;
}

tl::expected<LinearPicture, ToolError> read_exr(const std::filesystem::path& path) {
  const auto bytes = FileBytes::read(path);
  if (!bytes) return tl::unexpected(bytes.error());
  auto picture = decode_exr(bytes->span());
  if (!picture) return file_failure(ToolError::Kind::kBadInput, path, "{}", picture.error());
  return std::move(*picture);
}

}  // namespace

LinearPicture TruthPicture::mean() const {
  LinearPicture mean = halves[0];
  for (std::size_t i = 0; i < mean.rgba.size(); ++i) mean.rgba[i] = 0.5f * (mean.rgba[i] + halves[1].rgba[i]);
  return mean;
}

tl::expected<std::vector<TruthScene>, ToolError> read_truth_list(const std::filesystem::path& folder,
                                                                 const Eigen::Vector3d& joint) {
  const std::filesystem::path path = folder / "truth.json";
  const auto bytes = FileBytes::read(path);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto json = parse_shallow_json({reinterpret_cast<const char*>(bytes->span().data()), bytes->span().size()});
  if (!json) return file_failure(ToolError::Kind::kBadInput, path, "{}", json.error());
  std::vector<TruthScene> scenes;
  for (const nlohmann::json& one : list_of(member(*json, "scenes"))) {
    auto scene = scene_of(one, folder, joint);
    if (!scene) return file_failure(ToolError::Kind::kBadInput, path, "scene {}: {}", scenes.size(), scene.error());
    scenes.push_back(std::move(*scene));
  }
  if (scenes.empty()) return file_failure(ToolError::Kind::kBadInput, path, "it lists no 'scenes'");
  return scenes;
}

tl::expected<TruthPicture, ToolError> read_truth(const TruthScene& scene) {
  TruthPicture truth;
  for (std::size_t i = 0; i < 2; ++i) {
    auto half = read_exr(scene.files[i]);
    if (!half) return tl::unexpected(half.error());
    truth.halves[i] = std::move(*half);
  }
  const auto& [a, b] = truth.halves;
  if (a.width == b.width && a.height == b.height && std::min(a.width, a.height) >= 16) return truth;
  return file_failure(ToolError::Kind::kBadInput, scene.files[1],
                      "it and the picture beside it are of two sizes, or smaller than 16 x 16 pixels");
}

}  // namespace coif::report
