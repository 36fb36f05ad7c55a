// A shadow's view from its light, and where a point lies in its map.

#include "gl/shadow/shadow_state.h"

#include <cmath>

namespace coif {
namespace {

constexpr double kNearestLight = 1.05;  // Share of the ball's radius, from its centre.

double dot(const double (&a)[3], const double (&b)[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

void cross(const double (&a)[3], const double (&b)[3], double (&out)[3]) {
  for (int i = 0; i < 3; ++i) out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/// Returns false for a vector without direction.
bool normalize(double (&v)[3]) {
  const double length = std::sqrt(dot(v, v));
  if (!(length > 0.0 && std::isfinite(length))) return false;
  for (double& x : v) x /= length;
  return true;
}

/// Fills the map's axes to the right and to the top, at right angles to the third.
void fill_axes(double (&axes)[3][3]) {
  const bool is_steep = std::fabs(axes[2][1]) > 0.99;
  const double upright[3] = {is_steep ? 1.0 : 0.0, is_steep ? 0.0 : 1.0, 0.0};
  cross(upright, axes[2], axes[0]);
  normalize(axes[0]);
  cross(axes[2], axes[0], axes[1]);
}

/// Rounds to whole texels, so that the shadow's edges do not crawl while the ball moves.
void snap(const double (&axes)[3][3], double texel, double (&center)[3]) {
  for (int k = 0; k < 2; ++k) {
    const double place = dot(axes[k], center);
    const double moved = std::floor(place / texel + 0.5) * texel - place;
    for (int i = 0; i < 3; ++i) center[i] += moved * axes[k][i];
  }
}

bool is_finite(const ShadowBall& ball) {
  return std::isfinite(ball.center[0]) && std::isfinite(ball.center[1]) && std::isfinite(ball.center[2]) &&
         std::isfinite(ball.radius) && ball.radius > 0.0f;
}

}  // namespace

bool aim(const Light& light, const ShadowBall& ball, std::uint32_t size, ShadowView& view) {
  if (!is_finite(ball) || light.kind > Light::Kind::kSpot) return false;
  view = {};
  view.radius = double(ball.radius);
  const double place[3] = {double(light.from.x), double(light.from.y), double(light.from.z)};
  const bool is_directional = light.kind == Light::Kind::kDirectional;
  for (int i = 0; i < 3; ++i) {
    view.axes[2][i] = is_directional ? place[i] : place[i] - ball.center[i];
    view.eye[i] = is_directional ? ball.center[i] : place[i];
  }
  if (!is_directional) view.distance = std::sqrt(dot(view.axes[2], view.axes[2]));
  if (!normalize(view.axes[2])) return false;
  fill_axes(view.axes);
  if (!is_directional) return view.distance >= kNearestLight * view.radius;
  snap(view.axes, 2 * view.radius / size, view.eye);
  return true;
}

// Maps to 0..1 within the map, with depth growing away from the light; homogeneous for a light with a position.
void ShadowState::map_from_origin(const Vec3& origin, double (&rows)[4][4]) const {
  const double offset[3] = {double(origin.x) - view.eye[0], double(origin.y) - view.eye[1],
                            double(origin.z) - view.eye[2]};
  double seen[3][4];  // Coordinates along the view's axes.
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) seen[k][i] = view.axes[k][i];
    seen[k][3] = dot(view.axes[k], offset);
  }
  const double r = view.radius, d = view.distance;
  const bool is_directional = d == 0.0;
  const double nearest = d - r, farthest = d + r;
  const double tangent = is_directional ? r : r / std::sqrt(d * d - r * r);
  const double steep = is_directional ? 0.5 / r : farthest / (farthest - nearest);
  const double last[4] = {0, 0, 0, 1};
  for (int i = 0; i < 4; ++i) {
    rows[3][i] = is_directional ? last[i] : -seen[2][i];
    rows[0][i] = 0.5 * (seen[0][i] / tangent + rows[3][i]);
    rows[1][i] = 0.5 * (seen[1][i] / tangent + rows[3][i]);
    rows[2][i] = (is_directional ? 0.5 : -steep * nearest) * last[i] - steep * seen[2][i];
  }
}

void ShadowState::clip_from_origin(const Vec3& origin, float (&clip)[16]) const {
  double rows[4][4];
  map_from_origin(origin, rows);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const double value = row < 3 ? 2 * rows[row][column] - rows[3][column] : rows[3][column];
      clip[4 * column + row] = static_cast<float>(value);
    }
  }
}

ShadowUniforms ShadowState::uniforms(const Vec3& origin) const {
  ShadowUniforms uniforms;
  double rows[4][4];
  map_from_origin(origin, rows);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      uniforms.map_from_origin[4 * column + row] = static_cast<float>(rows[row][column]);
    }
  }
  const double r = view.radius, d = view.distance;
  const bool is_directional = d == 0.0;
  const double texel = 2 * r / desc.size;
  uniforms.depth[0] = static_cast<float>(is_directional ? 0.0 : d - r);
  uniforms.depth[1] = static_cast<float>(is_directional ? 2 * r : 0.0);
  uniforms.depth[2] = static_cast<float>(is_directional ? 0.0 : -2 * r / (d + r));
  uniforms.depth[3] = static_cast<float>(double(desc.bias) + double(desc.technique->texel_bias) * texel);
  uniforms.map[0] = static_cast<float>(desc.size);
  const auto first_layer = desc.technique->first_layer;
  uniforms.map[1] = first_layer == nullptr ? 0.0f : first_layer(*this);
  uniforms.map[2] = opacity_unit;
  uniforms.map[3] = static_cast<float>(texel);
  return uniforms;
}

void HairShadow::clip_from_origin(const Vec3& origin, float (&clip)[16]) const {
  if (is_created()) state_->clip_from_origin(origin, clip);
}

ShadowUniforms HairShadow::uniforms(const Vec3& origin) const {
  return is_created() ? state_->uniforms(origin) : ShadowUniforms{};
}

ShadowUniforms uniforms_of(const ShadowState& shadow, const Vec3& origin) { return shadow.uniforms(origin); }

}  // namespace coif
