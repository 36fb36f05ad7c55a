#include "visibility/seen_lines.h"

#include "base/collider_shapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coif::visibility {
namespace {

constexpr float kUnseenShare = 1.0f / 1024;  ///< Share of a pixel.
constexpr float kFaintestOfAll = 1.0f / 512;
constexpr float kHidesAll = 0.999f;
/// Bounds of alphas in the mips of any threshold: above the first they stay solid, and at least the second share is
/// left. In two cooks, of curly hair and of 102,070 triangles, no threshold was judged more than 0.04 dB and 0.03
/// blended layers differently than without these bounds.
constexpr float kSolidInAll = 0.97f, kLeastKept = 0.7f;
constexpr float kPicturePixels = 160;
/// Factor on the hair's width in a picture: its border, and that its middle is further away than its nearest points.
constexpr float kFrame = 1.2f;

float pixel_of(std::span<const Eigen::Vector3f> positions, const ViewAxes& axes) {
  constexpr float kFar = std::numeric_limits<float>::max();
  Eigen::Array2f low(kFar, kFar), high(-kFar, -kFar);
  for (const Eigen::Vector3f& p : positions) {
    const Eigen::Array2f place(p.dot(axes.right), p.dot(axes.up));
    low = low.min(place);
    high = high.max(place);
  }
  return positions.empty() ? 1 : std::max((high - low).maxCoeff() * kFrame / kPicturePixels, 1.0e-6f);
}

ViewAxes axes_of(const Eigen::Vector3f& towards_eye) {
  ViewAxes axes;
  const Eigen::Vector3f upright = std::abs(towards_eye.y()) < 0.99f ? Eigen::Vector3f(Eigen::Vector3f::UnitY())
                                                                    : Eigen::Vector3f(Eigen::Vector3f::UnitX());
  axes.back = towards_eye;
  axes.right = upright.cross(towards_eye).normalized();
  axes.up = towards_eye.cross(axes.right);
  return axes;
}

/// Finds the visible layers of a view's lines.
class LayerLight {
 public:
  LayerLight(const SeenHair& hair, std::span<const Eigen::Vector3f> positions, const ViewAxes& axes, float pixel)
      : hair_(hair), positions_(positions), axes_(axes), lights_(lights_in(axes)), pixel_(pixel) {}

  [[nodiscard]] SeenHit hit(const Fragment& fragment, const Eigen::Vector3f& point) const {
    const auto& corners = hair_.surface.triangles[fragment.triangle].vertex;
    const Eigen::Vector2f a = flat(positions_[corners[0]]), e1 = flat(positions_[corners[1]]) - a,
                          e2 = flat(positions_[corners[2]]) - a, p = flat(point) - a;
    const float area = e1.x() * e2.y() - e1.y() * e2.x();
    const float scale = area != 0 ? 1 / area : 0;
    Eigen::Vector3f share(0, (p.x() * e2.y() - p.y() * e2.x()) * scale, (e1.x() * p.y() - e1.y() * p.x()) * scale);
    share = share.cwiseMax(0.0f).cwiseMin(1.0f);
    share[0] = std::max(0.0f, 1 - share[1] - share[2]);
    const auto& uvs = hair_.surface.uvs;
    const Eigen::Vector2f uv = share[0] * uvs[corners[0]] + share[1] * uvs[corners[1]] + share[2] * uvs[corners[2]];
    const Eigen::Vector2f du = uvs[corners[1]] - uvs[corners[0]], dv = uvs[corners[2]] - uvs[corners[0]];
    const float step = pixel_ * scale;
    const MipChoice mip =
        hair_.surface.alpha.choose_mip((du * e2.y() - dv * e1.y()) * step, (dv * e1.x() - du * e2.x()) * step);
    const Eigen::Array3f base = hair_.light.texture().at(uv, mip);
    const Eigen::Array3f color = hair_.light.of_hair(corners, share, fragment.is_front, base, lights_);
    return {color.min(1.0f), uv, mip, fragment.triangle & 0x7FFFFFFFu, fragment.is_front ? 1u : 0u};
  }

  /// The background of a line through `origin`; `height`: in the picture, 0..1.
  [[nodiscard]] Eigen::Array3f behind(const Eigen::Vector3f& origin, float height) const {
    float nearest = std::numeric_limits<float>::infinity();
    Eigen::Array3f color = backdrop(height);
    for (const ColliderRecord& solid : hair_.surface.solids) {
      const float depth = depth_along(solid, origin, -axes_.back);
      if (!(depth < nearest)) continue;
      nearest = depth;
      const Eigen::Vector3f at = origin - depth * axes_.back;
      color = light_on_head((at - Eigen::Map<const Eigen::Vector3f>(solid.center)).normalized(), lights_);
    }
    return color;
  }

 private:
  [[nodiscard]] Eigen::Vector2f flat(const Eigen::Vector3f& p) const { return {p.dot(axes_.right), p.dot(axes_.up)}; }

  const SeenHair& hair_;
  std::span<const Eigen::Vector3f> positions_;
  const ViewAxes& axes_;
  ViewLights lights_;
  float pixel_;
};

/// Hits that some layer may show which is so solid as mips of a hair texture are made at least.
void add_hits(std::span<const Fragment> fragments, float end, const LayerLight& light, const FragmentView& view,
              std::size_t line, SeenHits& seen) {
  float passes = 1;
  bool is_hidden = false;
  for (const Fragment& fragment : fragments) {
    if (fragment.depth > end || (is_hidden && passes < kUnseenShare)) break;
    seen.hits.push_back(light.hit(fragment, view.place(line, fragment.depth)));
    passes *= 1 - kLeastKept * fragment.alpha;
    is_hidden |= fragment.alpha >= kSolidInAll;
  }
}

void add_layers(std::span<const SeenHit> hits, const AlphaTexture& texture, float opaque_threshold, SeenLines& seen) {
  float passes = 1;
  bool is_hidden = false;
  for (const SeenHit& hit : hits) {
    if (is_hidden && passes < kUnseenShare) break;
    const float alpha = texture.at(hit.uv, hit.mip);
    if (alpha < kFaintestOfAll) continue;
    seen.layers.push_back({hit.color, alpha, hit.triangle, hit.is_front});
    passes *= 1 - alpha;
    is_hidden |= alpha >= opaque_threshold;
    if (alpha >= kHidesAll) break;
  }
}

}  // namespace

SeenHits see_hits(const SeenHair& hair, std::span<const Eigen::Vector3f> positions, const Eigen::Vector3f& towards_eye,
                  float spacing) {
  const ViewAxes axes = axes_of(towards_eye);
  const float pixel = pixel_of(positions, axes);
  ViewGrid grid;
  grid.towards_eye = towards_eye;
  grid.spacing = spacing;
  grid.pixel = pixel;
  grid.faintest = kFaintestOfAll;
  grid.past_head = false;
  const FragmentView view(hair.surface, positions, grid);
  const LayerLight light(hair, positions, axes, pixel);
  const float high = view.line_count() == 0 ? 0 : view.place(view.line_count() - 1, 0).dot(axes.up);
  const float low = view.line_count() == 0 ? 0 : view.place(0, 0).dot(axes.up);
  SeenHits seen;
  for (std::size_t i = 0; i < view.line_count(); ++i) {
    const auto fragments = view.line(i);
    if (fragments.empty()) continue;
    const float end = view.solid_depth(i);
    if (fragments.front().depth > end) continue;
    add_hits(fragments, end, light, view, i, seen);
    const Eigen::Vector3f origin = view.place(i, 0);
    const float height = high > low ? (origin.dot(axes.up) - low) / (high - low) : 0;
    seen.behind.push_back(light.behind(origin, height));
    seen.begin.push_back(std::uint32_t(seen.hits.size()));
  }
  seen.hits.shrink_to_fit();  // hundreds of views are kept
  return seen;
}

SeenLines lines_of(const SeenHits& hits, const AlphaTexture& alpha, float opaque_threshold) {
  SeenLines seen;
  for (std::size_t i = 0; i < hits.behind.size(); ++i) {
    const auto line = std::span(hits.hits).subspan(hits.begin[i], hits.begin[i + 1] - hits.begin[i]);
    add_layers(line, alpha, opaque_threshold, seen);
    if (seen.layers.size() == seen.begin.back()) continue;
    seen.behind.push_back(hits.behind[i]);
    seen.begin.push_back(std::uint32_t(seen.layers.size()));
  }
  return seen;
}

SeenLines see_lines(const SeenHair& hair, std::span<const Eigen::Vector3f> positions,
                    const Eigen::Vector3f& towards_eye, float spacing, float opaque_threshold) {
  return lines_of(see_hits(hair, positions, towards_eye, spacing), hair.surface.alpha, opaque_threshold);
}

namespace {

struct DrawnLayer {
  std::uint64_t key;
  const SeenLayer* layer;
  float share;  ///< Share in the pixel, if sorted by depth.
};

/// Squared differences of one line. Its memory is shared by calls.
class PictureError {
 public:
  PictureError(std::span<const std::uint32_t> rank, const DrawRule& rule) : rank_(rank), rule_(rule) {}

  double operator()(std::span<const SeenLayer> line, const Eigen::Array3f& behind) {
    blended_.clear();
    Eigen::Array3f exact = Eigen::Array3f::Zero();
    const SeenLayer* solid = nullptr;
    float passes = 1, unsolved = 1;
    for (const SeenLayer& layer : line) {
      const float share = layer.alpha * passes;
      if (solid == nullptr && layer.alpha >= rule_.opaque_threshold) {
        solid = &layer;
        unsolved = passes * (1 - layer.alpha);
      } else if (solid == nullptr && layer.alpha >= rule_.discard_threshold) {
        blended_.push_back({key_of(layer), &layer, share});
      }
      exact += share * layer.color;
      passes *= 1 - layer.alpha;
    }
    exact += passes * behind;
    double unseen = solid == nullptr ? 0 : 2 * double(unsolved) * double(unsolved);
    const Eigen::Array3f drawn = draw(solid == nullptr ? behind : solid->color, unseen);
    return double((encode_srgb(exact) - encode_srgb(drawn)).square().mean()) +
           kOtherLightSpread * kOtherLightSpread * unseen;
  }

 private:
  [[nodiscard]] std::uint64_t key_of(const SeenLayer& layer) const {
    const bool later = !rule_.faces_together && layer.is_front != 0;
    return std::uint64_t(later) << 32 | (rank_.empty() ? 0 : rank_[layer.triangle]);
  }

  /// `unseen`: plus the squared differences of shares, whatever the colours.
  Eigen::Array3f draw(const Eigen::Array3f& under, double& unseen) {
    std::ranges::reverse(blended_);
    std::ranges::stable_sort(blended_, {}, &DrawnLayer::key);
    Eigen::Array3f color = under;
    for (const DrawnLayer& blended : blended_) {
      const float alpha = blended.layer->alpha;
      color = color * (1 - alpha) + alpha * blended.layer->color;
    }
    float passes = 1;
    for (std::size_t i = blended_.size(); i-- > 0;) {
      const double off = double(blended_[i].layer->alpha * passes - blended_[i].share);
      unseen += off * off;
      passes *= 1 - blended_[i].layer->alpha;
    }
    return color;
  }

  std::span<const std::uint32_t> rank_;
  DrawRule rule_;
  std::vector<DrawnLayer> blended_;
};

}  // namespace

double picture_error(const SeenLines& lines, std::span<const std::uint32_t> rank, const DrawRule& rule) {
  PictureError error_of(rank, rule);
  double sum = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) sum += error_of(lines.line(i), lines.behind[i]);
  return sum;
}

double blended_layers(const SeenLines& lines, const DrawRule& rule) {
  std::size_t blended = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const SeenLayer& layer : lines.line(i)) {
      if (layer.alpha >= rule.opaque_threshold) break;
      blended += layer.alpha >= rule.discard_threshold ? 1 : 0;
    }
  }
  return lines.size() == 0 ? 0 : double(blended) / double(lines.size());
}

}  // namespace coif::visibility
