#include "render/gallery.h"

#include "base/color_texels.h"
#include "base/geometry.h"
#include "base/srgb.h"
#include "motion/head_path.h"

#include <coif/hair.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <numbers>
#include <span>
#include <string_view>
#include <utility>

namespace coif::render {
namespace {

PictureSettings of_size(const GallerySettings& settings) {
  PictureSettings picture;
  picture.width = settings.width;
  picture.height = settings.height;
  picture.solver = settings.solver;
  picture.warm_up = false;
  return picture;
}

Gallery components(const Asset& asset, const PictureSettings& picture) {
  constexpr std::pair<const char*, Component> kParts[] = {
      {"all components", Component::kAll},        {"ambient", Component::kAmbient},
      {"diffuse", Component::kDiffuse},           {"both highlights", Component::kSpecular},
      {"primary highlight", Component::kPrimary}, {"secondary highlight", Component::kSecondary}};
  Gallery gallery{1, "Gallery 1: components of the shading", {}};
  for (const auto& [caption, component] : kParts) {
    PictureSettings& part = gallery.pictures.emplace_back(caption, picture).settings;
    part.component = component;
    part.material = thesis_material(asset);
  }
  return gallery;
}

/// Adds a picture of all components, and those of the changing ones.
void add_highlights(Gallery& gallery, const std::string& caption, PictureSettings picture) {
  gallery.pictures.push_back({caption, picture});
  picture.component = Component::kSpecular;
  gallery.pictures.push_back({caption + " (highlights only)", picture});
}

/// The values for the first and the second highlight.
using Pair = std::pair<float, float>;

/// Sets the material's members `first` and `second` to each of `pairs`, with `caption` to distinguish them.
void add_pairs(const Asset& asset, PictureSettings picture, std::initializer_list<Pair> pairs,
               float MaterialRecord::*first, float MaterialRecord::*second, const char* caption, Gallery& gallery) {
  for (const auto& [primary, secondary] : pairs) {
    picture.material = thesis_material(asset);
    (*picture.material).*first = primary;
    (*picture.material).*second = secondary;
    add_highlights(gallery, fmt::format(fmt::runtime(caption), primary, secondary), picture);
  }
}

Gallery shifts(const Asset& asset, const PictureSettings& picture) {
  Gallery gallery{2, "Gallery 2: shifts of the highlights along the strands", {}};
  add_pairs(asset, picture, {{0.7f, 0.5f}, {0.9f, 0.3f}, {0.5f, 0.7f}}, &MaterialRecord::primary_shift,
            &MaterialRecord::secondary_shift, "primary {:.1f}, secondary {:.1f}", gallery);
  return gallery;
}

Gallery exponents(const Asset& asset, const PictureSettings& picture) {
  Gallery gallery{3, "Gallery 3: exponents of the highlights", {}};
  add_pairs(asset, picture, {{150, 30}, {1000, 70}, {5000, 100}}, &MaterialRecord::primary_exponent,
            &MaterialRecord::secondary_exponent, "primary {:g}, secondary {:g}", gallery);
  return gallery;
}

Gallery colors(const Asset& asset, PictureSettings picture) {
  const std::pair<const char*, Eigen::Vector3d> kColors[] = {
      {"brown", {0.09, 0.04, 0.02}}, {"green", {0.04, 0.13, 0.03}},    {"purple", {0.08, 0.025, 0.14}},
      {"red", {0.19, 0.022, 0.015}}, {"black", {0.010, 0.009, 0.010}}, {"yellow", {0.40, 0.27, 0.07}}};
  Gallery gallery{4, "Gallery 4: colours", {}};
  for (const auto& [caption, color] : kColors) {
    picture.material = dyed_material(asset, color);
    gallery.pictures.push_back({caption, picture});
  }
  return gallery;
}

struct Movement {
  std::string title;
  std::string motion;  ///< The motion's name.
  std::shared_ptr<const motion::HeadPath> path;
  double yaw_degrees;                           ///< The best viewing direction.
  std::array<double, kGalleryColumns> moments;  ///< Seconds.
};

constexpr const char* kCharge = "charge";

/// A movement of head_looks().
Movement looking(const char* name, double yaw_degrees, const std::array<double, kGalleryColumns>& moments) {
  const motion::HeadLook& look =
      *std::ranges::find(motion::head_looks(), std::string_view(name), &motion::HeadLook::name);
  return {std::string("Gallery 5: ") + look.caption, name, motion::path_of(look), yaw_degrees, moments};
}

std::vector<Movement> movements() {
  return {looking("look-down", 60, {0, 0.2, 0.3, 0.4, 0.5, 1.5}),
          looking("look-aside", 150, {0, 0.1, 0.15, 0.2, 0.3, 0.6}),
          looking("look-up", 90, {0, 0.2, 0.3, 0.4, 0.5, 1.5}),
          {"Gallery 5: charging forward",
           kCharge,
           motion::path_of(motion::Motion::kCharge),
           75,
           {0, 0.08, 0.16, 0.3, 0.4, 1.5}}};
}

void add_motion(PictureSettings picture, std::vector<Gallery>& galleries) {
  const char* const by = picture.solver == &kThesisSolver ? ", by Algorithm 1" : "";
  for (const Movement& movement : movements()) {
    Gallery gallery{5, movement.title + by, {}, movement.motion};
    picture.clip = movement.path;
    picture.yaw_degrees = movement.yaw_degrees;
    for (const double moment : movement.moments) {
      picture.time = moment;
      gallery.pictures.push_back({fmt::format("{:.2f} s", moment), picture});
    }
    galleries.push_back(std::move(gallery));
  }
}

void add_swings(PictureSettings picture, std::vector<Gallery>& galleries) {
  constexpr int kMoments = 2 * int(kGalleryColumns);
  constexpr double kFirst = 0.15, kStep = 0.15;  // Seconds; from 0.3 on the head moves steadily.
  picture.clip = motion::path_of(motion::Motion::kCharge);
  picture.yaw_degrees = 75;
  for (const Solver* const solver : {&kCoifSolver, &kThesisSolver}) {
    Gallery gallery{
        6, solver == &kCoifSolver ? "Swing after a charge, as cooked" : "The same by Algorithm 1", {}, kCharge};
    picture.solver = solver;
    if (solver == &kThesisSolver) picture.step.iterations = 8;
    for (int i = 0; i < kMoments; ++i) {
      picture.time = kFirst + i * kStep;
      gallery.pictures.push_back({fmt::format("{:.2f} s", picture.time), picture});
    }
    galleries.push_back(std::move(gallery));
  }
}

}  // namespace

std::vector<Gallery> thesis_galleries(const Asset& asset, const GallerySettings& settings) {
  const PictureSettings picture = of_size(settings);
  std::vector<Gallery> galleries{components(asset, picture), shifts(asset, picture), exponents(asset, picture),
                                 colors(asset, picture)};
  add_motion(picture, galleries);
  add_swings(picture, galleries);
  add_character_galleries(asset, picture, galleries);
  if (settings.only > 0) std::erase_if(galleries, [&](const Gallery& g) { return g.number != settings.only; });
  return galleries;
}

tl::expected<void, ToolError> check_tile_size(std::uint32_t width, std::uint32_t height) {
  const auto side_ok = [](std::uint32_t side) { return side >= 64 && side <= 1024; };
  if (side_ok(width) && side_ok(height)) return {};
  return usage(fmt::format("a picture of a sheet has 64 to 1024 pixels each way, not {} x {}", width, height));
}

tl::expected<GallerySheet, ToolError> draw_sheet(const Asset& asset, std::span<const Gallery> galleries,
                                                 std::uint32_t columns, std::vector<SheetSection> last,
                                                 const std::function<void(const std::string&)>& progress) {
  auto maker = PictureMaker::create(asset);
  if (!maker) return tl::unexpected(maker.error());
  GallerySheet result;
  double draw_ms = 0;
  std::string device;
  std::vector<SheetSection> sections;
  for (const Gallery& gallery : galleries) {
    SheetSection& section = sections.emplace_back(gallery.title);
    for (const auto& [caption, picture] : gallery.pictures) {
      progress(gallery.title + ", " + caption);
      auto taken = maker->take(picture);
      if (!taken) return tl::unexpected(taken.error());
      draw_ms += taken->draw_ms;
      device = taken->device;
      section.tiles.push_back({caption, std::move(*taken)});
      ++result.pictures;
    }
  }
  std::ranges::move(last, std::back_inserter(sections));
  result.sheet = contact_sheet(sections, columns);
  result.sheet.device = device;
  result.sheet.draw_ms = draw_ms;
  return result;
}

tl::expected<GallerySheet, ToolError> render_gallery(const Asset& asset, const GallerySettings& settings,
                                                     const std::function<void(const std::string&)>& progress) {
  if (const auto checked = check_tile_size(settings.width, settings.height); !checked)
    return tl::unexpected(checked.error());
  if (settings.only > kGalleries) {
    return usage("there is no gallery " + std::to_string(settings.only) + "; there are 1 to 7");
  }
  return draw_sheet(asset, thesis_galleries(asset, settings), kGalleryColumns, {}, progress);
}

namespace {

constexpr double kMaxColor = 1000;  // The largest value in a material: formats/SPECIFICATION.md.

double linear(std::byte srgb) { return decode_srgb(std::to_integer<int>(srgb) / 255.0); }

MaterialRecord first_gallery() {
  MaterialRecord material{};
  std::fill_n(material.base_color, 4, 1.0f);
  std::fill_n(material.ambient, 3, 0.1f);
  std::fill_n(material.primary_color, 3, 0.5f);
  std::fill_n(material.secondary_color, 3, 0.4f);
  material.opaque_threshold = 0.85f;
  material.primary_exponent = 150;
  material.secondary_exponent = 30;
  material.primary_shift = 0.7f;
  material.secondary_shift = 0.5f;
  material.discard_threshold = 0.02f;
  material.flags = kMaterialDoubleSided;
  return material;
}

}  // namespace

MaterialRecord thesis_material(const Asset& asset) {
  MaterialRecord material = asset.material() != nullptr ? *asset.material() : first_gallery();
  material.shading = ShadingModel::kThesis;
  material.light_cut = 0;  // Bounded models may have one; the published model has none.
  return material;
}

Eigen::Vector3d mean_base_color(const Asset& asset) {
  const TextureRecord* const texture = asset.texture(TextureRole::kBaseColor);
  if (texture == nullptr) return Eigen::Vector3d::Ones();
  const std::vector<std::byte> texels = color_texels(asset, *texture, 0);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weight = 0;
  for (std::size_t i = 0; i + 3 < texels.size(); i += 4) {
    const double alpha = std::to_integer<int>(texels[i + 3]);
    sum += alpha * Eigen::Vector3d(linear(texels[i]), linear(texels[i + 1]), linear(texels[i + 2]));
    weight += alpha;
  }
  if (weight == 0) return Eigen::Vector3d::Ones();
  return sum / weight;
}

MaterialRecord dyed_material(const Asset& asset, const Eigen::Vector3d& color) {
  MaterialRecord material = thesis_material(asset);
  const Eigen::Vector3d mean = mean_base_color(asset);
  for (int channel = 0; channel < 3; ++channel) {
    const double factor = color[channel] / std::max(mean[channel], 1e-4);
    material.base_color[channel] = float(std::min(factor, kMaxColor));
  }
  return material;
}

}  // namespace coif::render
