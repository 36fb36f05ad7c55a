#include "report/cards/asset_surface.h"

#include "base/color_texels.h"
#include "base/geometry.h"
#include "cards/make_cards.h"
#include "cook/recipe/hair_recipe.h"
#include "cook/size/evidence.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace coif::report {
namespace {

constexpr double kSameBox = 0.5;   // share of both boxes that cards and their strands have in common, at least
constexpr double kClearly = 1.05;  // Factor over the file's own unit and axis: only then others are chosen.
constexpr float kFlatness =
    0.02f;  // Share of its diagonal that a box has at least in each direction, so that flat ones have a volume.

Eigen::AlignedBox3f box_of_asset(const Asset& asset) {
  Eigen::AlignedBox3f box;
  for (const std::uint32_t v : asset.lod_indices(0)) box.extend(Eigen::Vector3f(asset.vertices()[v].position));
  return box;
}

/// In the asset's axes; turns are from axis to axis, so a box stays one.
Eigen::AlignedBox3f placed(const Eigen::AlignedBox3f& box, const CookedPlace& place) {
  Eigen::AlignedBox3f there(place.of_strand(box.min()));
  return there.extend(place.of_strand(box.max()));
}

/// Volume of the intersection of two boxes divided by that of the union, 0..1.
double common_share(Eigen::AlignedBox3f a, Eigen::AlignedBox3f b) {
  const float least = kFlatness * std::max(a.diagonal().norm(), b.diagonal().norm());
  for (Eigen::AlignedBox3f* const box : {&a, &b}) {
    const Eigen::Vector3f missing = (Eigen::Vector3f::Constant(least) - box->sizes()).cwiseMax(0) / 2;
    *box = Eigen::AlignedBox3f(box->min() - missing, box->max() + missing);
  }
  const Eigen::AlignedBox3f common = a.intersection(b);
  if (common.isEmpty()) return 0;
  const double shared = double(common.volume());
  return shared / (double(a.volume()) + double(b.volume()) - shared);
}

/// The units that a cook chooses from (cook/size).
std::vector<cook::UnitPrior> units_of(const groom::Groom& groom) {
  importer::SourceModel words;  // The file's statements about its size.
  words.space = groom.space;
  return cook::unit_priors(words, {}, cards::scalp_radius_of(cards::shape_of(groom, 0).strands));
}

std::string box_text(const Eigen::AlignedBox3f& box) {
  const Eigen::Vector3f size = box.sizes(), middle = box.center();
  return fmt::format("{:.3g} x {:.3g} x {:.3g} m about ({:.3g}, {:.3g}, {:.3g})", size.x(), size.y(), size.z(),
                     middle.x(), middle.y(), middle.z());
}

}  // namespace

tl::expected<CookedPlace, ToolError> find_cooked_place(const Asset& asset, const groom::Groom& groom) {
  const Eigen::AlignedBox3f cooked = box_of_asset(asset);
  Eigen::AlignedBox3f strands;
  for (const Eigen::Vector3f& point : groom.points) strands.extend(point);
  const std::vector<cook::UnitPrior> units = units_of(groom);
  CookedPlace best;
  double most = -1;
  for (std::size_t up = 0; up < cook::kUps; ++up) {
    for (const cook::UnitPrior& unit : units) {
      const CookedPlace place{unit.factor, cook::y_up_from_direction(up).cast<float>(),
                              Eigen::Vector3f(asset.skeleton().head_joint)};
      const double share = common_share(cooked, placed(strands, place));
      if (!(share > (most < kSameBox ? most : kClearly * most))) continue;
      most = share;
      best = place;
    }
  }
  if (most >= kSameBox) return best;
  return failure(
      ToolError::Kind::kBadInput,
      fmt::format("was cooked from other strands than those of {}: its hair is {}, theirs would be {}; name the file "
                  "that it was cooked from, and with --recipe the recipe",
                  groom.path, box_text(cooked), box_text(placed(strands, best))));
}

namespace {

/// The vertices that some triangles use, numbered afresh.
class LevelVertices {
 public:
  LevelVertices(const Asset& asset, const CookedPlace& place, cards::CardSurface& surface)
      : asset_(asset), place_(place), surface_(surface), number_(asset.vertices().size(), importer::kNoIndex) {}

  std::uint32_t operator()(std::uint32_t vertex) {
    if (number_[vertex] == importer::kNoIndex) {
      number_[vertex] = std::uint32_t(surface_.positions.size());
      add(asset_.vertices()[vertex]);
    }
    return number_[vertex];
  }

 private:
  void add(const VertexRecord& vertex) {
    const auto direction = [this](const std::int16_t(&snorm)[4]) {
      const Eigen::Vector3f stored(snorm[0], snorm[1], snorm[2]);
      return (place_.turn.transpose() * stored).normalized().eval();
    };
    surface_.positions.push_back(place_.in_groom(Eigen::Vector3f(vertex.position)));
    surface_.uvs.emplace_back(vertex.uv[0], vertex.uv[1]);
    surface_.along.push_back(direction(vertex.tangent));
    surface_.across.push_back(direction(vertex.normal).cross(surface_.along.back()).normalized());
  }

  const Asset& asset_;
  const CookedPlace& place_;
  cards::CardSurface& surface_;
  std::vector<std::uint32_t> number_;
};

/// 1 everywhere without a texture.
void set_opacity(const Asset& asset, cards::CardSurface& surface) {
  const float factor = asset.material() != nullptr ? asset.material()->base_color[3] : 1.0f;
  if (asset.material() != nullptr) {
    surface.opaque_from = asset.material()->opaque_threshold;
    surface.discard_below = asset.material()->discard_threshold;
  }
  const TextureRecord* const texture = asset.texture(TextureRole::kBaseColor);
  if (texture == nullptr) {
    surface.width = surface.height = 1;
    surface.opacity = {std::min(factor, 1.0f)};
    return;
  }
  surface.width = texture->width;
  surface.height = texture->height;
  for (std::uint32_t mip = 0; mip < texture->mip_count; ++mip) {
    const auto texels = color_texels(asset, *texture, mip);
    std::vector<float>& opacity = mip == 0 ? surface.opacity : surface.smaller_opacity.emplace_back();
    for (std::size_t i = 3; i < texels.size(); i += 4)
      opacity.push_back(std::min(float(texels[i]) / 255.0f * factor, 1.0f));
  }
}

}  // namespace

cards::CardSurface surface_of_asset(const Asset& asset, std::uint32_t lod, const CookedPlace& place) {
  cards::CardSurface surface;
  LevelVertices vertices(asset, place, surface);
  for (const std::uint32_t vertex : asset.lod_indices(lod)) surface.triangles.push_back(vertices(vertex));
  set_opacity(asset, surface);
  return surface;
}

}  // namespace coif::report
