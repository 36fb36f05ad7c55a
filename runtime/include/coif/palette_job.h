#pragma once

#include <coif/asset_records.h>
#include <coif/math.h>
#include <coif/particle.h>
#include <coif/status.h>

#include <span>

namespace coif {

/// Turns the particles of one instance into what a renderer needs. Reads and writes only the spans below, so jobs
/// with different outputs may run in parallel. A bone's rotation is its parent's, turned by the shortest arc that
/// brings the rest direction onto the bone's present direction; a bone of no length keeps the rest direction.
struct PaletteJob {
  Quat head_rotation;                   ///< World from head space, unit.
  std::span<const BoneRecord> bones;    ///< All bones of the asset, the simulated ones last.
  std::span<const Particle> particles;  ///< Per simulated bone.
  /// Per simulated bone: rotation from rest, world axes, of a solver that follows the bones' twist. Empty: the shortest
  /// arcs, as said above.
  std::span<const Quat> world_frames;

  std::span<Quat> frames;     ///< Out, per simulated bone: rotation from rest, head space.
  std::span<Mat34> palette;   ///< Out, per bone: rest pose in head space -> present pose in head space.
  std::span<Vec3> bone_ends;  ///< Out, per bone: particle, or joint of a rigid bone; head space, metres.

  /// Ok when run() will not read or write out of range.
  [[nodiscard]] Status validate() const;

  /// Returns what validate() returns; unless that is kOk, the outputs are untouched.
  Status run() const;
};

}  // namespace coif
