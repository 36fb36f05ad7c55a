#pragma once

#include "report/particle_solver.h"

namespace coif {

/// `position` (metres from the head, world axes) moved to where bone `i` keeps its hit radius from every collider it may
/// touch, one collider after another, the short way. Shapes and limits are the runtime's
/// (runtime/sim/lanes/particle_contact-inl.h), in double precision: on overlapping colliders the last has its way, and an
/// ellipsoid is left along the radius of the space where it is a unit sphere.
[[nodiscard]] Eigen::Vector3d clear_of_colliders(const Rig& rig, std::size_t i, const Eigen::Quaterniond& head_rotation,
                                                 const Eigen::Vector3d& position);

/// For methods that keep lengths exactly: a point at the bone's length from `start` and clear of the colliders, as near
/// to `position` as some rounds of one after the other get. Where they cannot both be had the length is.
[[nodiscard]] Eigen::Vector3d clear_of_colliders_at_length(const Rig& rig, std::size_t i,
                                                           const Eigen::Quaterniond& head_rotation,
                                                           const Eigen::Vector3d& start,
                                                           const Eigen::Vector3d& position);

/// For methods that do not derive velocities from positions: moves a particle to the surface and takes what its
/// velocity has into it, seen from the moving head. True where something was touched.
bool push_out(const Rig& rig, std::size_t i, const ParticleStep& step, Eigen::Vector3d& position,
              Eigen::Vector3d& velocity);

}  // namespace coif
