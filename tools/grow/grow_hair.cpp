#include "grow/grow_hair.h"

#include "base/parallel_for.h"
#include "cook/select/hair_evidence.h"
#include "grow/body_field.h"
#include "grow/head_frame.h"
#include "grow/random.h"
#include "grow/strand_paths.h"
#include "mannequin/head_shape.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace coif::grow {

using Eigen::Vector3f;

namespace {

constexpr float kFieldSpacing = 0.007f;  // metres on a head of usual size
constexpr float kPointSpacing = 0.008f;
constexpr float kPointsOfTurn = 9;
constexpr std::size_t kFewestPoints = 12, kMostPoints = 160;

/// The body without hair, turned so that it looks along +Z.
grow::BodySurface surface_of(const importer::SourceModel& body, float turn) {
  std::vector<Vector3f> positions;
  std::vector<std::uint32_t> triangles;
  for (const importer::SourceMesh& mesh : body.meshes) {
    if (cook::is_called_hair(mesh.name) || cook::is_called_hair(importer::material_name(body, mesh))) continue;
    const auto first = std::uint32_t(positions.size());
    for (const Vector3f& p : mesh.positions) positions.emplace_back(turn * p.x(), p.y(), turn * p.z());
    for (const std::uint32_t v : mesh.triangles) triangles.push_back(first + v);
  }
  if (triangles.empty()) {
    positions.assign(3, Vector3f::Zero());
    triangles = {0, 1, 2};
  }
  return {std::move(positions), std::move(triangles)};
}

std::optional<grow::HeadFrame> head_of(const GrowGround& ground, const grow::BodySurface& surface, float turn) {
  if (!ground.head_center || !ground.head_radii) return grow::find_head(surface.positions(), surface.triangles());
  const auto& c = *ground.head_center;
  const auto& r = *ground.head_radii;
  return grow::HeadFrame{Vector3f(turn * float(c[0]), float(c[1]), turn * float(c[2])),
                         Vector3f(float(r[0]), float(r[1]), float(r[2]))};
}

/// On a head of usual size.
float longest_of(const cook::HairStyle& style) {
  const double fringe = style.grow_fringe_width > 0 ? style.grow_fringe_length : 0;
  return float(std::max(
      {style.grow_length_top, style.grow_length_front, style.grow_length_sides, style.grow_length_back, fringe}));
}

/// Number of points per strand.
std::size_t stations_for(const cook::HairStyle& style) {
  const float longest = longest_of(style);
  float spacing = std::min(kPointSpacing, longest / float(kFewestPoints - 1));
  if (style.grow_curl_radius > 0) spacing = std::min(spacing, float(style.grow_curl_pitch) / kPointsOfTurn);
  if (style.grow_wave_height > 0) spacing = std::min(spacing, float(style.grow_wave_length) / kPointsOfTurn);
  return std::clamp(std::size_t(longest / spacing) + 1, kFewestPoints, kMostPoints);
}

/// Widths and colours of strands.
class Looks {
 public:
  Looks(const cook::HairStyle& style, const grow::HeadFrame& head, std::size_t strands)
      : style_(style), dice_(style.grow_seed, grow::Purpose::kColor), width_(head.scale() * float(style.grow_width)) {
    if (width_ == 0) width_ = groom::usual_strand_width(head.mean_radius(), strands);
  }

  [[nodiscard]] float width(float t) const { return width_ * (1 - t * t * (1 - float(style_.grow_taper))); }
  [[nodiscard]] Vector3f color(std::size_t i, float t) const {
    const auto of = [](const std::array<double, 3>& c) { return Vector3f(float(c[0]), float(c[1]), float(c[2])); };
    const Vector3f mean = (1 - t) * of(style_.grow_root_color) + t * of(style_.grow_tip_color);
    const float light = 1 + float(style_.grow_color_random) * (dice_.unit(i) + dice_.unit(i, 1) - 1);
    return (light * mean).cwiseMax(0).cwiseMin(1);
  }

 private:
  const cook::HairStyle& style_;
  grow::Dice dice_;
  float width_;
};

void add_strands(const cook::HairStyle& style, const grow::HeadFrame& head, float turn, std::span<const Root> roots,
                 const grow::StrandPaths& paths, std::span<const std::uint32_t> sizes, groom::GroomBuilder& builder) {
  const Looks looks(style, head, paths.count());
  std::vector<Vector3f> points, colors;
  std::vector<float> widths;
  for (std::size_t i = 0; i < paths.count(); ++i) {
    points.clear(), colors.clear(), widths.clear();
    for (std::size_t k = 0; k < sizes[i]; ++k) {
      const float t = float(k) / float(sizes[i] - 1);
      const Vector3f& p = paths.strand(i)[k];
      points.emplace_back(turn * p.x(), p.y(), turn * p.z());
      colors.push_back(looks.color(i, roots[i].grown_share * t));
      widths.push_back(roots[i].width * looks.width(t));
    }
    builder.add(points, {widths, colors, {}});
  }
}

}  // namespace

importer::SourceModel sample_body() {
  const mannequin::SurfaceMesh bust = mannequin::make_bust();
  importer::SourceModel body;
  body.path = "the sample's bust";
  body.facing = importer::Facing::kForwards;
  body.nodes.push_back({"bust", importer::kNoIndex, Eigen::Affine3d::Identity()});
  importer::SourceMesh mesh;
  mesh.name = "bust";
  for (const Eigen::Vector3d& p : bust.positions) mesh.positions.push_back(p.cast<float>());
  for (const Eigen::Vector3d& n : bust.normals) mesh.normals.push_back(n.cast<float>());
  mesh.triangles = bust.triangles;
  body.meshes.push_back(std::move(mesh));
  return body;
}

tl::expected<groom::Groom, ToolError> grow_hair(const cook::HairStyle& style, const GrowGround& ground,
                                                const std::string& name, const platform::Threads& threads) {
  using Kind = ToolError::Kind;
  const float turn = ground.body.facing == importer::Facing::kBackwards ? -1.0f : 1.0f;
  const grow::BodySurface surface = surface_of(ground.body, turn);
  const auto head = head_of(ground, surface, turn);
  if (!head) {
    return file_failure(Kind::kBadInput, name,
                        "no head at the top of {}; say where it is by the recipe's \"head.center\" and \"head.radii\"",
                        ground.body.path);
  }
  const float scale = head->scale();
  const std::size_t stations = stations_for(style);
  if (style.grow_strands * stations > groom::kMostStrandPoints) {
    return file_failure(
        Kind::kOverBudget, name,
        "{} strands of {} points are more than the {} that hair may have; grow fewer strands, or larger curls",
        style.grow_strands, stations, groom::kMostStrandPoints);
  }
  const float reach = longest_of(style);
  Eigen::AlignedBox3f room(head->center - 1.8f * head->radii, head->center + 1.8f * head->radii);
  room.min().array() -= scale * reach;
  room.max().array() += scale * reach;
  room = room.intersection(Eigen::AlignedBox3f(surface.box().min().array() - 0.3f * head->mean_radius(),
                                               surface.box().max().array() + 0.3f * head->mean_radius()));
  const grow::BodyField body(surface, room, scale * kFieldSpacing, threads);

  const std::vector<grow::Root> roots = grow::spread_roots(style, *head, body, threads);
  if (roots.empty()) {
    return file_failure(Kind::kBadInput, name,
                        "the hairline leaves no room for hair; lower \"grow.hairline_front\" and the others");
  }
  const grow::Ground place{style, *head, body};
  grow::StrandPaths paths =
      style.grow_gather ? grow_tied(place, roots, stations, threads) : grow_open(place, roots, stations, threads);
  shape_strands(place, roots, paths, threads);
  const std::vector<std::uint32_t> sizes = cut_level(place, paths);

  groom::Groom groom;
  groom.path = name;
  groom.format = "grown";
  groom.root_first = true;
  groom::GroomBuilder builder(groom);
  add_strands(style, *head, turn, roots, paths, sizes, builder);
  if (std::string fault = builder.finish(); !fault.empty()) return file_failure(Kind::kBadInput, name, "{}", fault);
  return groom;
}

tl::expected<importer::SourceModel, ToolError> read_body(const std::filesystem::path& path,
                                                         const importer::ImportSettings& settings) {
  return path.empty() ? tl::expected<importer::SourceModel, ToolError>(sample_body())
                      : importer::import_model(path, settings);
}

tl::expected<groom::Groom, ToolError> grow_from(const cook::Recipe& recipe, const importer::SourceModel& body,
                                                const std::string& name, const platform::Threads& threads) {
  return grow_hair(recipe, {body, recipe.head_center, recipe.head_radii}, name, threads);
}

}  // namespace coif::grow
