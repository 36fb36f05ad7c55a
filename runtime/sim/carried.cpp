#include "rows.h"
#include "vector_math.h"

namespace coif {
namespace {

/// Everything that hangs from a bone's start, at rest: its mass (bones weigh a kilogram per metre, with the mass at
/// their ends), and its moments about that place.
struct Hanging {
  double mass = 0, first[3] = {}, second = 0;

  /// Adds `other`, whose moments are about `to`, to these, which are about `from`. Goes from bone to bone, so nothing
  /// cancels, however far hair is from the origin.
  void add(const Hanging& other, const Vec3& to, const Vec3& from) {
    const double way[3] = {double(to.x) - double(from.x), double(to.y) - double(from.y), double(to.z) - double(from.z)};
    for (int k = 0; k < 3; ++k) {
      first[k] += other.first[k] + other.mass * way[k];
      second += way[k] * (2 * other.first[k] + other.mass * way[k]);
    }
    mass += other.mass;
    second += other.second;
  }
};

}  // namespace

/// Goes from the tips upwards. The number of open sums is never larger than the number of open bones on the way down.
void find_carried(std::span<const RowBone> bones, std::uint32_t lane, BoneLanes* constants) {
  Hanging from_start[kMaxOpenBones];
  for (std::size_t i = bones.size(); i-- > 0;) {
    const RowBone& bone = bones[i];
    BoneLanes& lanes = constants[i];
    Hanging all;
    if (bone.children != 0) {
      all = from_start[bone.slot];
      from_start[bone.slot] = {};
    }
    const Vec3 start = coif::lane(lanes.joint, lane), rest = coif::lane(lanes.rest, lane);
    const double length = double(lanes.length.v[lane]);
    const double way[3] = {length * double(rest.x), length * double(rest.y), length * double(rest.z)};
    all.mass += length;
    for (int k = 0; k < 3; ++k) {
      all.first[k] += length * way[k];
      all.second += length * way[k] * way[k];
    }
    lanes.carried.v[lane] = float(all.second);
    if (bone.parent < 0) continue;
    const Vec3 above = coif::lane(constants[std::size_t(bone.parent)].joint, lane);
    from_start[bone.parent_slot].add(all, start, above);
  }
}

}  // namespace coif
