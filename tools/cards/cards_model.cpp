#include "cards/cards_model.h"

#include "base/encodings.h"
#include "base/parallel_for.h"
#include "cards/card_atlas.h"
#include "cards/card_strip.h"
#include "cards/card_texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace coif {
namespace {

constexpr std::size_t kQuadsOfCard = 6;      // on the average: fewer bend no lock, more leave too few cards
constexpr std::size_t kFewestTexels = 4096;  // 64 x 64
constexpr float kHairsOfHead = 100000;       // of people, each kHairWidth of a head's radius wide
constexpr float kHairWidth = 0.0008f;
const Eigen::Vector3f kBrown(0.36f, 0.24f, 0.15f);  // as screens have it

Eigen::AlignedBox3f box_of_roots(const EvenStrands& strands) {
  Eigen::AlignedBox3f roots;
  for (std::size_t i = 0; i < strands.count(); ++i) roots.extend(strands.strand(i).front());
  return roots;
}

/// Fewer strands than a head has stand for as many: as wide as covers the same.
float strand_width_of(const Groom& groom, const EvenStrands& strands) {
  const float radius = 0.5f * box_of_roots(strands).sizes().maxCoeff();
  return kHairWidth * radius * std::sqrt(std::max(kHairsOfHead / float(groom.strand_count()), 1.0f));
}

std::vector<CardSize> sizes_of(std::span<const Wisp> wisps) {
  std::vector<CardSize> sizes;
  for (const Wisp& wisp : wisps)
    sizes.push_back({2 * std::ranges::max(wisp.ribbon.half_width), length_of(wisp.ribbon)});
  return sizes;
}

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

void add_strip(const Wisp& wisp, const CardStrip& strip, const AtlasPlan& plan, const AtlasPlace& place,
               const Eigen::Vector3f& middle, SourceMesh& mesh) {
  const float side = faces_inwards(wisp.ribbon, middle) ? -1.0f : 1.0f;
  const auto first = std::uint32_t(mesh.positions.size());
  for (const std::uint8_t station : strip.stations) {
    const auto edge = edge_at(wisp.ribbon, station);
    const float v = float(place.y) + float(place.height) * float(station) / float(Ribbon::kStations - 1);
    for (int end = 0; end < 2; ++end) {
      mesh.positions.push_back(edge[std::size_t(end)]);
      mesh.normals.push_back(side * wisp.ribbon.along[station].cross(wisp.ribbon.across[station]).normalized());
      const float u = float(place.x) + float(place.width) * float(end);
      mesh.uvs.emplace_back(u / float(plan.width), v / float(plan.height));
    }
  }
  for (std::uint32_t k = 0; k + 1 < strip.stations.size(); ++k) {
    const std::uint32_t a = first + 2 * k, b = a + 1, c = a + 2, d = a + 3;
    const std::uint32_t out[6] = {a, c, b, b, c, d}, in[6] = {a, b, c, b, d, c};
    mesh.triangles.insert(mesh.triangles.end(), side > 0 ? std::begin(out) : std::begin(in),
                          side > 0 ? std::end(out) : std::end(in));
  }
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
  if (budget.triangles < 2 || budget.texels < kFewestTexels) {
    return file_failure(ToolError::Kind::kOverBudget, groom.path,
                        "cards need 2 triangles and {} texels at least; allow them more", kFewestTexels);
  }
  const auto reversed = find_reversed_strands(groom);
  EvenStrands strands = even_strands(groom, budget.strand_width, reversed);
  if (!(strands.width > 0)) strands.width = strand_width_of(groom, strands);
  const std::size_t cards = std::max<std::size_t>(budget.triangles / (2 * kQuadsOfCard), 1);
  const std::vector<Wisp> wisps = find_wisps(strands, cards, threads);
  const std::vector<CardStrip> strips = make_strips(wisps, budget.triangles);
  const AtlasPlan plan = plan_atlas(sizes_of(wisps), budget.texels);
  if (plan.places.empty()) {
    return file_failure(ToolError::Kind::kOverBudget, groom.path,
                        "{} cards do not fit into {} texels; allow more texels, or fewer triangles", wisps.size(),
                        budget.texels);
  }
  std::vector<CardTexture> textures(wisps.size());
  parallel_for(wisps.size(), threads, [&](std::size_t i) {
    textures[i] = draw_on_card(groom, reversed, wisps[i], strands.width, plan.places[i].width, plan.places[i].height);
  });

  SourceModel model = empty_model(groom);
  AtlasPicture picture(plan);
  const Eigen::Vector3f middle = box_of_roots(strands).center();
  SourceMesh mesh;
  mesh.name = "hair";
  mesh.material = 0;
  for (std::size_t i = 0; i < wisps.size(); ++i) {
    picture.paint(plan.places[i], textures[i], mean_color(groom, wisps[i]));
    add_strip(wisps[i], strips[i], plan, plan.places[i], middle, mesh);
  }
  model.meshes.push_back(std::move(mesh));
  model.images.push_back({"cards", picture.png()});
  return model;
}

}  // namespace coif
