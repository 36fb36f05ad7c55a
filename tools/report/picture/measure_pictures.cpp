#include "report/picture/measure_pictures.h"

#include "render/camera_file.h"
#include "render/gallery.h"
#include "render/picture_scene.h"
#include "report/picture/truth_folder.h"

#include <algorithm>
#include <string>
#include <utility>

namespace coif::report {
namespace {

constexpr std::uint32_t kSmaller = 4;       ///< The divisor of the smaller size.
constexpr std::uint32_t kOversampling = 4;  ///< Each way: the pictures' noise is not the renderer's.

render::PictureSettings settings_of(const Asset& asset, const PictureReportSettings& settings,
                                    const TruthScene& scene) {
  render::PictureSettings picture;
  picture.camera = scene.camera;
  picture.light = scene.lights;
  picture.lod = settings.lod;
  picture.shadows = &kDeepShadow;
  picture.oversampling = kOversampling;
  picture.body = settings.body;
  picture.bust = settings.body == nullptr;
  picture.cuts_out_bodies = picture.keeps_light = true;
  picture.warm_up = false;
  picture.backdrop = render::Backdrop{.opacity = 0};
  MaterialRecord material =
      render::shaded_material(asset, settings.shading.value_or(render::own_material(asset).shading));
  if (scene.base_color) Eigen::Map<Eigen::Vector3f>{material.base_color} = *scene.base_color;
  picture.material = material;
  return picture;
}

/// Over grey, so that outlines are seen.
render::Picture developed(const LinearPicture& light) {
  render::Picture picture{light.width, light.height, {}, {}, 0};
  LinearPicture shown = light;
  for (std::size_t i = 0; i < shown.rgba.size(); i += 4) {
    const float rest = 1 - std::min(shown.rgba[i + 3], 1.0f);
    for (std::size_t k = 0; k < 3; ++k) shown.rgba[i + k] += 0.25f * rest;
    shown.rgba[i + 3] = 1;
  }
  picture.rgba = render::develop(shown.rgba, light.width, light.height, 1);
  return picture;
}

ReportSheet sheet_of(const std::string& caption, const LinearPicture& truth, const LinearPicture& ours) {
  const render::Picture left = developed(truth), right = developed(ours);
  render::Picture pair{2 * left.width, left.height, {}, {}, 0};
  for (std::size_t y = 0; y < left.height; ++y) {
    for (const render::Picture* half : {&left, &right}) {
      const auto row = half->rgba.begin() + std::ptrdiff_t(4 * y * left.width);
      pair.rgba.insert(pair.rgba.end(), row, row + std::ptrdiff_t(4 * left.width));
    }
  }
  return {caption, render::encode_png(pair)};
}

TruthPicture reduced(const TruthPicture& truth, std::uint32_t factor) {
  return {{coif::reduced(truth.halves[0], factor), coif::reduced(truth.halves[1], factor)}};
}

}  // namespace

tl::expected<PictureReport, ToolError> measure_pictures(const Asset& asset, const PictureReportSettings& settings,
                                                        const ReportProgress& progress) {
  const auto scenes = read_truth_list(settings.truth, render::joint_of(asset));
  if (!scenes) return tl::unexpected(scenes.error());
  auto maker = render::PictureMaker::create(asset);
  if (!maker) return tl::unexpected(maker.error());
  PictureReport report;
  report.truth = settings.truth.string();
  report.shading = kShadingModels[std::size_t(settings.shading.value_or(render::own_material(asset).shading))].name;
  for (const TruthScene& scene : *scenes) {
    progress(scene.name());
    const auto truth = read_truth(scene);
    if (!truth) return tl::unexpected(truth.error());
    for (const std::uint32_t factor : {1u, kSmaller}) {
      const TruthPicture wanted = factor == 1 ? *truth : reduced(*truth, factor);
      render::PictureSettings picture = settings_of(asset, settings, scene);
      picture.width = wanted.halves[0].width;
      picture.height = wanted.halves[0].height;
      const auto seen = maker->take(picture);
      if (!seen) return tl::unexpected(seen.error());
      report.device = seen->device;
      report.rows.push_back({scene.view, scene.color, scene.light, std::min(picture.width, picture.height), factor == 1,
                             compare_light(wanted, seen->light)});
      if (settings.sheets && factor == 1) {
        report.sheets.push_back(sheet_of(scene.name() + ": truth, coif", wanted.mean(), seen->light));
      }
    }
  }
  report.totals = picture_totals(report.rows);
  return report;
}

}  // namespace coif::report
