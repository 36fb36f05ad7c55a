#include "cards/hair_source.h"

#include "base/geometry.h"
#include "cards/even_strands.h"
#include "cook/select/hair_evidence.h"
#include "cook/select/head.h"
#include "grow/body_surface.h"
#include "grow/head_frame.h"
#include "import/source_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace coif::cards {
namespace {

using Eigen::Vector3f;

bool is_hair(const importer::SourceModel& body, const importer::SourceMesh& mesh) {
  return cook::is_called_hair(mesh.name) || cook::is_called_hair(importer::material_name(body, mesh));
}

struct Skin {
  std::vector<Vector3f> positions;
  std::vector<std::uint32_t> triangles;
};

Skin skin_of(const importer::SourceModel& body) {
  Skin skin;
  for (const importer::SourceMesh& mesh : body.meshes) {
    if (is_hair(body, mesh)) continue;
    const auto first = std::uint32_t(skin.positions.size());
    skin.positions.insert(skin.positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const std::uint32_t v : mesh.triangles) skin.triangles.push_back(first + v);
  }
  return skin;
}

/// Another unit and up axis that the strands' file may have.
struct OtherSpace {
  float scale = 1;
  /// The axis that became Y: 'y' unchanged, 'z' if Z was up after all, 'x' if Y was up and Z was taken for it.
  char up = 'y';

  [[nodiscard]] Vector3f of(const Vector3f& p) const {
    if (up == 'z') return scale * Vector3f(p.x(), p.z(), -p.y());
    if (up == 'x') return scale * Vector3f(p.x(), -p.z(), p.y());
    return scale * p;
  }
};

/// Some of the strands' roots.
std::vector<Vector3f> some_roots(const groom::Groom& groom) {
  constexpr std::size_t kSome = 400;
  const std::vector<std::uint8_t> reversed = find_reversed_strands(groom);
  const std::size_t step = std::max<std::size_t>(groom.strand_count() / kSome, 1);
  std::vector<Vector3f> roots;
  for (std::size_t i = 0; i < groom.strand_count(); i += step) roots.push_back(root_of(groom, reversed, i));
  return roots;
}

/// Typical distance of roots from the skin, metres.
float typical_distance(const grow::BodySurface& skin, std::span<const Vector3f> roots, const OtherSpace& space) {
  std::vector<float> distances;
  for (const Vector3f& root : roots) distances.push_back(skin.distance(space.of(root), 1e6f));
  return quantile(distances, 0.5f);
}

bool is_open(importer::Statement said) {
  return said == importer::Statement::kUsual || said == importer::Statement::kUnsaid;
}

/// The spaces that are possible for the strands' file, its own first.
std::vector<OtherSpace> spaces_for(const importer::SourceSpace& space) {
  constexpr float kScales[] = {1, 0.01f, 100, 0.001f, 1000, 0.1f, 10, 0.0254f, 1 / 0.0254f};
  std::vector<OtherSpace> spaces;
  for (const char up : {'y', 'z', 'x'}) {
    if (up != 'y' && !is_open(space.up)) continue;
    for (const float scale : kScales) {
      if (scale == 1 || is_open(space.unit)) spaces.push_back({scale, up});
    }
  }
  return spaces;
}

/// The file's own up axis then; as SourceSpace::up_axis.
char axis_after(char before, char up) {
  if (up == 'y') return before;
  return before == 'z' ? 'y' : 'z';
}

/// The head's node, kNoIndex without a node of that name. Among several the one that moves most.
std::uint32_t head_node_of(const importer::SourceModel& body) {
  if (body.head_node != importer::kNoIndex) return body.head_node;
  cook::NodeWeights weights(body.nodes.size(), 0.0);
  for (const importer::SourceMesh& mesh : body.meshes) {
    for (const importer::SourceInfluence& influence : mesh.influences) weights[influence.node] += influence.weight;
    if (mesh.influences.empty()) weights[mesh.node] += double(mesh.positions.size());
  }
  const cook::NodeWeights below = cook::weights_below(body, weights);
  std::uint32_t best = importer::kNoIndex;
  for (std::uint32_t n = 0; n < body.nodes.size(); ++n) {
    if (cook::is_called_head(body.nodes[n].name) && (best == importer::kNoIndex || below[n] > below[best])) best = n;
  }
  return best;
}

/// A node for a head that has none, and the skin above the chin on it.
std::uint32_t make_head_node(const grow::HeadFrame& head, importer::SourceModel& body) {
  importer::SourceNode node;
  node.name = "head";
  const Vector3f joint = head.center - Vector3f(0, 0.9f * head.radii.y(), 0.3f * head.radii.z());
  node.model_from_node.translate(joint.cast<double>());
  body.nodes.push_back(std::move(node));
  const auto head_node = std::uint32_t(body.nodes.size() - 1);
  for (importer::SourceMesh& mesh : body.meshes) {
    mesh.influences.clear();
    mesh.influence_begin.assign(1, 0);
    for (const Vector3f& p : mesh.positions) {
      const Vector3f off = (p - head.center).cwiseQuotient(head.radii);
      const bool follows = off.y() > -1 && std::hypot(off.x(), off.z()) < 1.4f;
      mesh.influences.push_back({follows ? head_node : mesh.node, 1.0f});
      mesh.influence_begin.push_back(std::uint32_t(mesh.influences.size()));
    }
  }
  return head_node;
}

std::uint32_t find_head_node(importer::SourceModel& body, Diagnostics& warnings) {
  if (const std::uint32_t named = head_node_of(body); named != importer::kNoIndex) return named;
  const Skin skin = skin_of(body);
  if (const auto head = grow::find_head(skin.positions, skin.triangles)) return make_head_node(*head, body);
  importer::warn(warnings, importer::source_code::kBody,
                 "{}: nothing is called head, and no skull is found at its top; name a node head", body.path);
  return importer::kNoIndex;
}

}  // namespace

void place_on_body(const importer::SourceModel& body, groom::Groom& groom) {
  constexpr float kOnSkin = 0.12f;  // Share of the roots' extent: caps and skulls are modelled loosely.
  constexpr float kBetter = 0.4f;
  Skin skin = skin_of(body);
  const std::vector<Vector3f> roots = some_roots(groom);
  if (skin.triangles.empty() || roots.empty()) return;
  Eigen::AlignedBox3f box;
  for (const Vector3f& root : roots) box.extend(root);
  const float extent = std::max(box.sizes().maxCoeff(), 1e-6f);
  const grow::BodySurface surface(std::move(skin.positions), std::move(skin.triangles));
  const std::vector<OtherSpace> spaces = spaces_for(groom.space);
  std::vector<float> off;  // Shares of the roots' own extent, so that scaling down does not improve the fit.
  for (const OtherSpace& space : spaces)
    off.push_back(typical_distance(surface, roots, space) / (space.scale * extent));
  if (off.front() < kOnSkin) return;
  const std::size_t best = std::size_t(std::ranges::min_element(off) - off.begin());
  const float far = off.front() * extent;
  if (off[best] >= kOnSkin || off[best] > kBetter * off.front()) {
    importer::warn(groom.warnings, importer::source_code::kBody,
                   "roots lie {:.3g} m from {}; give both files one unit, one up axis and one place, or say the "
                   "strands' own by the recipe's \"source.metres_per_unit\" and \"source.up_axis\"",
                   far, body.path);
    return;
  }
  const OtherSpace& space = spaces[best];
  for (Vector3f& point : groom.points) point = space.of(point);
  for (float& width : groom.widths) width *= space.scale;
  groom.space.metres_per_unit *= double(space.scale);
  groom.space.up_axis = axis_after(groom.space.up_axis, space.up);
  importer::warn(groom.warnings, importer::source_code::kBody,
                 "roots would lie {:.3g} m from {}; the strands are taken as of {:.4g} m per unit with {} up: set "
                 "\"source.metres_per_unit\" and \"source.up_axis\" in the recipe if that is wrong",
                 far, body.path, groom.space.metres_per_unit, char(groom.space.up_axis - 'a' + 'A'));
}

void add_body(importer::SourceModel body, importer::SourceModel& cards) {
  std::size_t dropped = 0;
  for (const importer::SourceMesh& mesh : body.meshes) dropped += is_hair(body, mesh) ? 1 : 0;
  if (dropped > 0)
    importer::warn(cards.warnings, importer::source_code::kBody,
                   "{}: {} of its meshes are called hair and left out; strands are the hair", body.path, dropped);
  std::erase_if(body.meshes, [&](const importer::SourceMesh& mesh) { return is_hair(body, mesh); });
  const std::uint32_t head = find_head_node(body, cards.warnings);
  const auto nodes = std::uint32_t(body.nodes.size());
  for (importer::SourceNode& node : cards.nodes) {
    if (node.parent != importer::kNoIndex)
      node.parent += nodes;
    else
      node.parent = head;
  }
  for (importer::SourceMesh& mesh : cards.meshes) mesh.node += nodes;
  for (importer::SourceLevel& level : cards.coarser) level.mesh.node += nodes;
  body.nodes.insert(body.nodes.end(), cards.nodes.begin(), cards.nodes.end());
  cards.nodes = std::move(body.nodes);
  cards.head_node = body.head_node != importer::kNoIndex ? body.head_node : head;
  importer::SourceMaterial skin;
  skin.name = "body";
  const auto material = std::uint32_t(cards.materials.size());
  cards.materials.push_back(std::move(skin));
  for (importer::SourceMesh& mesh : body.meshes) {
    mesh.name = "body";
    mesh.material = material;
    cards.meshes.push_back(std::move(mesh));
  }
  cards.facing = body.facing;
  cards.space = body.space;
  cards.side_files.insert(cards.side_files.end(), body.side_files.begin(), body.side_files.end());
  for (const std::string& image :
       body.named_images)  // Relative to the body's folder, which may differ from that of the strands.
    cards.named_images.push_back((std::filesystem::path(body.path).parent_path() / image).string());
  cards.warnings.insert(cards.warnings.end(), body.warnings.begin(), body.warnings.end());
}

}  // namespace coif::cards
