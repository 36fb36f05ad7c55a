#include "report/order/drawn_way.h"

#include "lab/rig.h"
#include "motion/head_path.h"
#include "render/picture.h"
#include "render/stage_renderer.h"
#include "visibility/hair_surface.h"

#include <coif/research.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace coif::report {
namespace {

constexpr std::uint32_t kCoverageSamples = 4;

bool draws_faces_together(const AssetContents& contents) {
  return !contents.material.empty() && (contents.material.front().flags & kMaterialFacesTogether) != 0;
}

std::uint64_t index_bytes(const AssetContents& contents) {
  constexpr std::size_t kMostShort = 1u << 16;
  const std::size_t bytes = contents.vertices.size() <= kMostShort ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
  return bytes * contents.indices.size() * (1 + 3 * contents.orders.size() / contents.indices.size());
}

class WayMaker {
 public:
  WayMaker(const Asset& asset, render::OrderPictures& pictures)
      : pictures_(pictures),
        ways_{.finest = finest_level(asset),
              .exact = {},
              .exact_material = nullptr,
              .own = {},
              .orders = {},
              .modes = {},
              .left_out = {}} {}

  tl::expected<OrderWays, ToolError> make() {
    const AssetContents& finest = ways_.finest;
    if (!add("file", in_file_order(finest)) || !add("head", in_head_order(finest)) ||
        !add("best", in_stored_order(finest)) || !add_own()) {
      return tl::unexpected(error_);
    }
    ways_.exact_material = std::make_unique<MaterialRecord>(with_true_alphas(pictures_.material(ways_.own.model)));
    ways_.exact = ways_.own;
    ways_.exact.name = name_of(kExactMode);
    ways_.exact.transparency = &kExactMode;
    ways_.exact.material = ways_.exact_material.get();
    if (!add_bones() || !add_triangles()) return tl::unexpected(error_);
    add_modes();
    return std::move(ways_);
  }

 private:
  [[nodiscard]] bool add(const char* name, const AssetContents& contents) {
    const lab::OpenedAsset variant(contents);
    const auto model = pictures_.add(variant.asset());
    if (!model) {
      error_ = model.error();
      return false;
    }
    ways_.orders.push_back({.name = name,
                            .model = *model,
                            .faces_together = draws_faces_together(contents),
                            .bytes = index_bytes(contents)});
    return true;
  }

  [[nodiscard]] bool add_own() {
    if (!ways_.finest.orders.empty()) {
      if (!add("view", ways_.finest)) return false;
    } else {
      ways_.left_out.push_back({"view", "the asset has one order for all directions"});
    }
    ways_.own = ways_.orders.back();
    return true;
  }

  [[nodiscard]] bool add_triangles() {
    AssetContents contents = in_stored_order(ways_.finest);
    set_faces(contents, true);
    if (!add("triangles", contents)) return false;
    ways_.orders.back().sorted_units = each_triangle(ways_.finest);
    return true;
  }

  [[nodiscard]] bool add_bones() {
    if (ways_.finest.skin.empty()) {
      ways_.left_out.push_back({"bones", "all hair hangs on the head itself"});
      return true;
    }
    const AssetContents& contents = ways_.finest;
    if (!add("bones", in_stored_order(contents))) return false;
    const lab::OpenedAsset opened(contents);
    auto bones = render::KeptBoneOrder::create(opened.asset());
    if (!bones) {
      error_ = bones.error();
      return false;
    }
    ways_.orders.back().bytes += (*bones)->bytes();
    ways_.orders.back().bones = std::move(*bones);
    return true;
  }

  void add_modes() {
    for (const TransparencyMode* mode : render::transparency_modes()) {
      if (mode == &kExactMode) continue;
      DrawnWay way = ways_.own;
      way.name = name_of(*mode);
      way.transparency = mode;
      way.samples = render::covers_samples(*mode) ? kCoverageSamples : 1;
      ways_.modes.push_back(std::move(way));
    }
  }

  render::OrderPictures& pictures_;
  OrderWays ways_;
  ToolError error_;
};

}  // namespace

MaterialRecord with_true_alphas(MaterialRecord material) {
  if (!blends(material)) return material;
  constexpr float kUnseen = 1.0f / 512;  // rounds to nothing; texels that are empty need no place in lists
  material.opaque_threshold = 1;
  material.discard_threshold = kUnseen;
  return material;
}

tl::expected<OrderWays, ToolError> make_order_ways(const Asset& asset, render::OrderPictures& pictures) {
  return WayMaker(asset, pictures).make();
}

namespace {

struct MovingPose {
  motion::Motion motion;
  const char* name;
  double seconds[3];
};
/// The cook looks for its orders in moments of the first two; it does not know the last.
constexpr MovingPose kMovingPoses[] = {{motion::Motion::kTurn, "turn", {0.2, 0.45, 0.7}},
                                       {motion::Motion::kCharge, "charge", {0.15, 0.35, 0.8}},
                                       {motion::Motion::kTumble, "tumble", {0.25, 0.5, 0.85}}};

tl::expected<PosedHair, ToolError> posed(const Asset& asset, const Solver& solver, const motion::HeadPath* path,
                                         double seconds) {
  auto pose = motion::simulate_pose(asset, path, seconds, {}, &solver);
  if (!pose) return tl::unexpected(pose.error());
  std::vector<Eigen::Vector3f> positions = visibility::posed_positions(asset, pose->palette);
  return PosedHair{std::move(pose->palette), std::move(positions)};
}

}  // namespace

tl::expected<std::vector<OrderPose>, ToolError> make_order_poses(const Asset& asset, const Solver& solver) {
  auto rest = posed(asset, solver, nullptr, 0);
  if (!rest) return tl::unexpected(rest.error());
  std::vector<OrderPose> poses = {{"rest", {std::move(*rest)}}};
  if (asset.dynamics().empty()) return poses;
  for (const MovingPose& moving : kMovingPoses) {
    poses.push_back({moving.name, {}});
    for (const double seconds : moving.seconds) {
      auto moment = posed(asset, solver, motion::path_of(moving.motion).get(), seconds);
      if (!moment) return tl::unexpected(moment.error());
      poses.back().moments.push_back(std::move(*moment));
    }
  }
  return poses;
}

std::vector<ViewAngle> spread_directions(std::uint32_t count) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  constexpr double kTurn = 360 / std::numbers::phi;
  std::vector<ViewAngle> angles;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double height = 1 - (2 * i + 1.0) / count;
    angles.push_back({std::fmod(kTurn * i, 360), kDegrees * std::asin(height)});
  }
  return angles;
}

}  // namespace coif::report
