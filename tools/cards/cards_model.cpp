#include "cards/make_cards.h"

#include "base/encodings.h"
#include "import/source_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace coif::cards {
namespace {

const Eigen::Vector3f kBrown(0.36f, 0.24f, 0.15f);  // In sRGB.

std::uint8_t byte_of(float value) { return std::uint8_t(std::clamp(value, 0.0f, 1.0f) * 255 + 0.5f); }

/// An image of all cards, RGBA, from their textures.
class AtlasPicture {
 public:
  explicit AtlasPicture(const AtlasPlan& plan) : plan_(plan), rgba_(std::size_t(plan.width) * plan.height * 4, 0) {}

  /// `texel_of(i)`: the four bytes of texel i of the card's texture.
  void paint(const AtlasPlace& place, const auto& texel_of) {
    for (std::uint32_t y = 0; y < place.height; ++y) {
      for (std::uint32_t x = 0; x < place.width; ++x) {
        const std::array<std::uint8_t, 4> texel = texel_of(std::size_t(y) * place.width + x);
        std::ranges::copy(texel, &rgba_[4 * (std::size_t(place.y + y) * plan_.width + place.x + x)]);
      }
    }
  }

  [[nodiscard]] std::vector<std::uint8_t> png() const { return encode_png(rgba_, plan_.width, plan_.height); }

 private:
  const AtlasPlan& plan_;
  std::vector<std::uint8_t> rgba_;
};

/// Colour over the whole card, so that no other colour is mixed in at edges, and the coverage of strands. Strands
/// without colours differ a little, so that one can see them.
std::array<std::uint8_t, 4> color_texel(const CardTexture& texture, std::size_t i) {
  const Eigen::Vector3f color =
      texture.color.empty() ? ((0.85f + 0.3f * texture.strand[i]) * kBrown).eval() : texture.color[i];
  return {byte_of(color.x()), byte_of(color.y()), byte_of(color.z()), byte_of(texture.opacity[i])};
}

/// A texel of SourceMaterial::strand_texture. `deepest`: range of depths before and behind the card, metres.
std::array<std::uint8_t, 4> strand_texel(const CardTexture& texture, float deepest, std::size_t i) {
  const Eigen::Vector2f& along = texture.along[i];
  // The double angle's cosine and sine, times how much strands of this texel run one way.
  const float length = std::max(along.norm(), 1e-6f);
  return {byte_of(texture.strand[i]), byte_of(0.5f + 0.5f * texture.depth[i] / deepest),
          two_sided_byte(double((along.x() * along.x() - along.y() * along.y()) / length)),
          two_sided_byte(double(2 * along.x() * along.y() / length))};
}

/// All levels have one atlas.
void add_images(std::span<const Cards> levels, importer::SourceModel& model) {
  AtlasPicture colors(levels.front().plan), strands(levels.front().plan);
  for (const Cards& cards : levels) {
    for (std::size_t i = 0; i < cards.textures.size(); ++i) {
      const AtlasPlace& place = cards.plan.places[i];
      const CardTexture& texture = cards.textures[i];
      const Ribbon& ribbon = cards.wisps[cards.strips[cards.shares.drawn_from[i]].wisp].ribbon;
      const float deepest = std::max(std::ranges::max(ribbon.half_depth), 1e-9f);
      colors.paint(place, [&](std::size_t k) { return color_texel(texture, k); });
      strands.paint(place, [&](std::size_t k) { return strand_texel(texture, deepest, k); });
    }
  }
  model.images.push_back({"cards", colors.png()});
  model.images.push_back({"strands", strands.png()});
}

/// The side of a card that looks away from the middle of the hair is its front. Triangles of strips whose front is on
/// the other side are reversed.
importer::SourceLevel level_of(const Cards& cards, const Eigen::Vector3f& middle) {
  CardSurface surface = surface_of(cards);
  importer::SourceLevel level;
  importer::SourceMesh& mesh = level.mesh;
  mesh.name = "hair";
  mesh.material = 0;
  mesh.triangles = std::move(surface.triangles);
  std::size_t vertex = 0, index = 0;
  for (std::uint32_t i = 0; i < cards.strips.size(); ++i) {
    const bool is_turned = faces_inwards(cards.wisps[cards.strips[i].wisp].ribbon, middle);
    for (const std::uint8_t station : cards.strips[i].stations) {
      level.place.insert(level.place.end(), 2, float(station) / float(Ribbon::kStations - 1));
    }
    for (const std::size_t end = level.place.size(); vertex < end; ++vertex) {
      const Eigen::Vector3f normal = surface.along[vertex].cross(surface.across[vertex]).normalized();
      mesh.normals.push_back(is_turned ? -normal : normal);
    }
    level.strip_of.insert(level.strip_of.end(), cards.strips[i].triangles(), i);
    for (const std::size_t end = 3 * level.strip_of.size(); index < end; index += 3) {
      if (is_turned) std::swap(mesh.triangles[index + 1], mesh.triangles[index + 2]);
    }
  }
  mesh.positions = std::move(surface.positions);
  mesh.uvs = std::move(surface.uvs);
  level.along = std::move(surface.along);
  return level;
}

importer::SourceModel empty_model(const groom::Groom& groom) {
  importer::SourceModel model;
  model.path = groom.path;
  model.importer = groom.format;
  model.space = groom.space;
  model.made_from_strands = true;
  model.warnings = groom.warnings;
  model.nodes.push_back({"hair", importer::kNoIndex, Eigen::Affine3d::Identity()});
  importer::SourceMaterial material;
  material.name = "cards";
  material.base_texture.image = 0;
  material.strand_texture.image = 1;
  material.alpha_use = importer::AlphaUse::kBlend;
  material.double_sided = true;
  model.materials.push_back(std::move(material));
  return model;
}

void tell_width(const GroomShape& shape, Diagnostics& warnings) {
  if (!shape.width_is_guessed) return;
  constexpr float kHair = 0.0008f;  // of the head's radius, as in usual_strand_width()
  const float radius = 0.5f * box_of_roots(shape.strands).sizes().maxCoeff();
  std::string text = fmt::format(
      "the file does not say how wide its {} strands are: they are drawn {:.1f} times as wide as hairs, {:.2g} % of "
      "the "
      "head's radius, so that they cover a head",
      shape.strands.count(), shape.strands.width / (kHair * radius), 100 * shape.strands.width / radius);
  text += shape.width_is_capped ? "; they are too few to cover it: export more, or set \"cards.follow_hairs\""
                                : "; \"cards.strand_width\" sets another width";
  warnings.emplace_back(importer::source_code::kStrands, std::move(text),
                        shape.width_is_capped ? Severity::kWarning : Severity::kInfo);
}

}  // namespace

tl::expected<importer::SourceModel, ToolError> model_of_cards(const groom::Groom& groom, const CardsBudget& budget,
                                                              const platform::Threads& threads) {
  const GroomShape shape = shape_of(groom, budget.strand_width);
  const auto levels = make_card_levels(groom, shape, budget, threads);
  if (!levels) return tl::unexpected(levels.error());
  importer::SourceModel model = empty_model(groom);
  tell_width(shape, model.warnings);
  model.scalp_radius = scalp_radius_of(shape.strands);
  const Eigen::Vector3f middle = box_of_roots(shape.strands).center();
  model.meshes.push_back(level_of(levels->front(), middle).mesh);
  for (const Cards& cards : std::span(*levels).subspan(1)) model.coarser.push_back(level_of(cards, middle));
  add_images(*levels, model);
  return model;
}

}  // namespace coif::cards
