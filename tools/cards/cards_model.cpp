#include "cards/cards_model.h"

#include "base/encodings.h"

#include <algorithm>
#include <utility>

namespace coif {
namespace {

const Eigen::Vector3f kBrown(0.36f, 0.24f, 0.15f);  // as screens have it

Eigen::Vector3f mean_color(const Groom& groom, const Wisp& wisp) {
  if (groom.colors.empty()) return kBrown;
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (const std::uint32_t i : wisp.members) sum += groom.colors[groom.begin[i]];
  return sum / float(wisp.members.size());
}

std::uint8_t byte_of(float value) { return std::uint8_t(std::clamp(value, 0.0f, 1.0f) * 255 + 0.5f); }

/// The atlas's picture: colour wherever a card is, so that nothing else is mixed in at edges, and how much strands cover.
class AtlasPicture {
 public:
  explicit AtlasPicture(const AtlasPlan& plan) : plan_(plan), rgba_(std::size_t(plan.width) * plan.height * 4, 0) {}

  void paint(const AtlasPlace& place, const CardTexture& texture, const Eigen::Vector3f& color) {
    for (std::uint32_t y = 0; y < place.height; ++y) {
      for (std::uint32_t x = 0; x < place.width; ++x) {
        const std::size_t from = std::size_t(y) * texture.width + x;
        const float shade = texture.opacity[from] > 0 ? 0.85f + 0.3f * texture.strand[from] : 1.0f;
        std::uint8_t* const to = &rgba_[4 * (std::size_t(place.y + y) * plan_.width + place.x + x)];
        for (int k = 0; k < 3; ++k) to[k] = byte_of(color[k] * shade);
        to[3] = byte_of(texture.opacity[from]);
      }
    }
  }

  [[nodiscard]] std::vector<std::uint8_t> png() const { return encode_png(rgba_, plan_.width, plan_.height); }

 private:
  const AtlasPlan& plan_;
  std::vector<std::uint8_t> rgba_;
};

/// The side of a card that looks away from the middle of the hair is its front.
bool faces_inwards(const Ribbon& ribbon, const Eigen::Vector3f& middle) {
  float outwards = 0;
  for (std::size_t k = 0; k < Ribbon::kStations; ++k) {
    outwards += ribbon.along[k].cross(ribbon.across[k]).dot(ribbon.middle[k] - middle);
  }
  return outwards < 0;
}

/// Triangles of strips whose front is the other side are turned round.
SourceMesh mesh_of(const Cards& cards, const Eigen::Vector3f& middle) {
  CardSurface surface = surface_of(cards);
  SourceMesh mesh;
  mesh.name = "hair";
  mesh.material = 0;
  mesh.triangles = std::move(surface.triangles);
  std::size_t vertex = 0, index = 0;
  for (std::size_t i = 0; i < cards.strips.size(); ++i) {
    const bool is_turned = faces_inwards(cards.wisps[i].ribbon, middle);
    for (const std::size_t end = vertex + 2 * cards.strips[i].stations.size(); vertex < end; ++vertex) {
      const Eigen::Vector3f normal = surface.along[vertex].cross(surface.across[vertex]).normalized();
      mesh.normals.push_back(is_turned ? -normal : normal);
    }
    for (const std::size_t end = index + 3 * cards.strips[i].triangles(); index < end; index += 3) {
      if (is_turned) std::swap(mesh.triangles[index + 1], mesh.triangles[index + 2]);
    }
  }
  mesh.positions = std::move(surface.positions);
  mesh.uvs = std::move(surface.uvs);
  return mesh;
}

SourceModel empty_model(const Groom& groom) {
  SourceModel model;
  model.path = groom.path;
  model.importer = groom.format;
  model.space = groom.space;
  model.warnings = groom.warnings;
  model.nodes.push_back({"hair", kNoIndex, Eigen::Affine3d::Identity()});
  SourceMaterial material;
  material.name = "cards";
  material.base_texture.image = 0;
  material.alpha_use = AlphaUse::kBlend;
  material.double_sided = true;
  model.materials.push_back(std::move(material));
  return model;
}

}  // namespace

tl::expected<SourceModel, ToolError> model_of_cards(const Groom& groom, const CardsBudget& budget, unsigned threads) {
  const GroomShape shape = shape_of(groom, budget.strand_width);
  const auto cards = make_cards(groom, shape, budget, threads);
  if (!cards) return tl::unexpected(cards.error());
  SourceModel model = empty_model(groom);
  model.meshes.push_back(mesh_of(*cards, box_of_roots(shape.strands).center()));
  AtlasPicture picture(cards->plan);
  for (std::size_t i = 0; i < cards->wisps.size(); ++i) {
    picture.paint(cards->plan.places[i], cards->textures[i], mean_color(groom, cards->wisps[i]));
  }
  model.images.push_back({"cards", picture.png()});
  return model;
}

}  // namespace coif
