#include "head_collision.h"

#include "vector_math.h"

namespace coif {
namespace {

/// Squared share of the radius below which a direction is noise.
constexpr float kCentre2 = 1e-12f;

void push_out_of_sphere(const Vec3& center, float radius, const Vec3& up, std::span<Particle> particles) {
  const float radius2 = radius * radius;
  for (Particle& particle : particles) {
    const Vec3 offset = particle.position - center;
    const float distance2 = dot(offset, offset);
    if (!(distance2 < radius2)) continue;
    const bool central = distance2 < kCentre2 * radius2;
    particle.position = center + (central ? up * radius : offset * (radius / std::sqrt(distance2)));
  }
}

void push_out_of_ellipsoid(const Vec3& center, const Vec3& radii, const Quat& rotation, std::span<Particle> particles) {
  const Quat to_axes = conjugate(rotation);
  for (Particle& particle : particles) {
    const Vec3 offset = rotate(to_axes, particle.position - center);
    const Vec3 unit{offset.x / radii.x, offset.y / radii.y, offset.z / radii.z};
    const float distance2 = dot(unit, unit);
    if (!(distance2 < 1.0f)) continue;
    const Vec3 surface = distance2 < kCentre2 ? Vec3{0.0f, radii.y, 0.0f} : offset * (1.0f / std::sqrt(distance2));
    particle.position = center + rotate(rotation, surface);
  }
}

}  // namespace

void push_out(const ColliderRecord& collider, const Quat& head_rotation, std::span<Particle> particles) {
  const Vec3 center = rotate(head_rotation, to_vec3(collider.center));
  const Vec3 radii = to_vec3(collider.radii);
  const Quat rotation = head_rotation * to_quat(collider.rotation);
  if (collider.shape == ColliderShape::kSphere) {
    push_out_of_sphere(center, radii.x, rotate(rotation, Vec3{0.0f, 1.0f, 0.0f}), particles);
  } else {
    push_out_of_ellipsoid(center, radii, rotation, particles);
  }
}

}  // namespace coif
