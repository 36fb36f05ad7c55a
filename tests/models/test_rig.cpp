#include "models/test_rig.h"

#include "write/pose_oscillator.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace coif {
namespace {

void store(const Vec3& v, float (&to)[3]) { to[0] = v.x, to[1] = v.y, to[2] = v.z; }

DynamicsRecord dynamics_of(const TestBone& bone) {
  constexpr float kRate = 60;
  const PoseOscillator oscillator = oscillator_of(bone.resistance, kRate);
  DynamicsRecord record{};
  record.resistance = bone.resistance;
  record.friction = bone.friction;
  record.gravity_scale = 1;
  record.authoring_rate = kRate;
  record.hit_radius = bone.hit_radius;
  record.stiffness = bone.stiffness >= 0 ? bone.stiffness : float(oscillator.stiffness);
  record.damping = bone.damping >= 0 ? bone.damping : float(oscillator.damping);
  record.torsion = bone.torsion;
  record.angle_limit = bone.angle_limit;
  record.parent_share = bone.parent_share;
  return record;
}

/// Levels want a mesh; one triangle for each will do.
void add_levels(AssetContents& contents, const std::vector<std::uint8_t>& levels) {
  const std::uint32_t count = *std::max_element(levels.begin(), levels.end());
  for (int i = 0; i < 3; ++i) {
    VertexRecord vertex{};
    vertex.normal[0] = vertex.normal[3] = vertex.tangent[1] = 32767;
    contents.vertices.push_back(vertex);
    contents.skin.push_back({{}, {255, 0, 0, 0}});
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    contents.indices.insert(contents.indices.end(), {0, 1, 2});
    contents.patches.push_back({3 * i, 3, 0, 0, i});
    contents.lods.push_back({i, 1, float(count - 1 - i), float(i)});
  }
  contents.lod_bones = levels;
}

}  // namespace

TestRig::TestRig() {
  BoneRecord head{};
  head.parent = head.chain = head.name = kNone;
  bones.push_back(head);
  dynamics.push_back(dynamics_of({}));
}

std::uint32_t TestRig::add(const TestBone& bone) {
  BoneRecord record{};
  record.parent = bone.parent;
  record.kind = BoneKind::kSimulated;
  record.chain = bone.parent != 0 ? bones[bone.parent].chain : bones.size() == 1 ? 0 : bones.back().chain + 1;
  record.name = kNone;
  const Vec3 start = bone.parent == 0 ? bone.joint : rest_ends()[bone.parent - 1];
  store(start, record.joint);
  store(bone.rest_direction, record.rest_direction);
  record.length = bone.length;
  record.colliders = ~0u;
  bones.push_back(record);
  dynamics.push_back(dynamics_of(bone));
  return std::uint32_t(bones.size() - 1);
}

std::uint32_t TestRig::add_strand(int count, const TestBone& bone) {
  TestBone next = bone;
  for (int i = 0; i < count; ++i) next.parent = add(next);
  return next.parent;
}

void TestRig::add_sphere(const Vec3& center, float radius) {
  add_ellipsoid(center, {radius, radius, radius});
  colliders.back().shape = ColliderShape::kSphere;
}

void TestRig::add_ellipsoid(const Vec3& center, const Vec3& radii, const Quat& rotation) {
  ColliderRecord record{};
  record.shape = ColliderShape::kEllipsoid;
  store(center, record.center);
  store(radii, record.radii);
  record.rotation[0] = rotation.x, record.rotation[1] = rotation.y;
  record.rotation[2] = rotation.z, record.rotation[3] = rotation.w;
  colliders.push_back(record);
}

void TestRig::add_capsule(const Vec3& from, const Vec3& to, float radius) {
  add_sphere(from, radius);
  colliders.back().shape = ColliderShape::kCapsule;
  store({to.x - from.x, to.y - from.y, to.z - from.z}, colliders.back().axis);
}

void TestRig::add_tapered_capsule(const Vec3& from, float from_radius, const Vec3& to, float to_radius) {
  add_capsule(from, to, from_radius);
  colliders.back().shape = ColliderShape::kTaperedCapsule;
  store({from_radius, to_radius, 0}, colliders.back().radii);
}

void TestRig::add_plane(const Vec3& point, const Vec3& normal) {
  add_sphere(point, 0);
  colliders.back().shape = ColliderShape::kPlane;
  store(normal, colliders.back().axis);
}

void TestRig::add_body_sphere(const Vec3& center, float radius) {
  add_sphere(center, radius);
  body_colliders.push_back(colliders.back());
  body_colliders.back().bone = std::uint32_t(body_bones.size() - 1);
  colliders.pop_back();
}

void TestRig::limit(std::uint32_t bone, LimitKind kind, float first, float second, const Quat& rotation) {
  LimitRecord none{};
  none.rotation[3] = 1;
  limits.resize(bones.size(), none);
  limits[bone] = {kind, {first, second}, 0, {rotation.x, rotation.y, rotation.z, rotation.w}};
}

void TestRig::link(std::uint32_t bone, std::uint32_t to, float stretch, float shrink) {
  const float gap = distance(rest_ends()[bone - 1], rest_ends()[to - 1]);
  links.push_back({bone, to, gap * (1 - shrink), gap * (1 + stretch)});
}

std::vector<Vec3> TestRig::rest_ends() const {
  std::vector<Vec3> ends;
  for (std::size_t i = 1; i < bones.size(); ++i) {
    const BoneRecord& b = bones[i];
    ends.push_back({b.joint[0] + b.rest_direction[0] * b.length, b.joint[1] + b.rest_direction[1] * b.length,
                    b.joint[2] + b.rest_direction[2] * b.length});
  }
  return ends;
}

namespace {

void add_body(AssetContents& contents, const TestRig& rig) {
  if (rig.body_colliders.empty()) return;
  contents.body_bones = rig.body_bones;
  contents.body_colliders = rig.body_colliders;
  contents.body_sets.assign(rig.bones.size(), (1u << rig.body_colliders.size()) - 1u);
  contents.body_sets[0] = 0;
  contents.body_bone_names.assign(rig.body_bones.size(), "arm");
}

}  // namespace

AssetContents TestRig::contents() const {
  AssetContents contents;
  contents.skeleton.head_rotation[3] = 1;
  contents.bones = bones;
  const auto existing = std::uint32_t((1ull << colliders.size()) - 1);
  for (BoneRecord& bone : contents.bones) bone.colliders &= existing;
  contents.dynamics = dynamics;
  contents.colliders = colliders;
  add_body(contents, *this);
  contents.links = links;
  contents.limits = limits;
  if (!limits.empty()) {
    LimitRecord none{};
    none.rotation[3] = 1;
    contents.limits.resize(bones.size(), none);
  }
  if (substep_rate > 0) contents.tuning = {{substep_rate, 0, 0, 0, 0, 30, 120, 1}};
  if (!levels.empty()) add_levels(contents, levels);
  for (std::uint32_t i = 1; i < bones.size(); ++i) {
    if (bones[i].chain == contents.chains.size()) contents.chains.push_back({i, 0, 0, model});
    ++contents.chains.back().bone_count;
  }
  return contents;
}

TestRig nine_bone_rig() {
  TestRig rig;
  rig.add_sphere({0, 0, 0}, 0.1f);
  const float sides[] = {-0.06f, 0.0f, 0.06f};
  for (const float side : sides) {
    std::uint32_t parent = 0;
    const float resistance[] = {0.35f, 0.2f, 0.06f};
    for (const float r : resistance) {
      parent =
          rig.add({.parent = parent, .joint = {side, 0.02f, -0.12f}, .length = 0.1f, .resistance = r, .friction = 1});
    }
  }
  return rig;
}

TestRig calm_strand(int count, float length) {
  TestRig rig;
  std::uint32_t parent = 0;
  for (int i = 0; i < count; ++i) {
    const float share = count > 1 ? float(i) / float(count - 1) : 0;
    const float stiffness = 1200 * std::pow(0.25f, share);
    parent = rig.add({.parent = parent,
                      .joint = {0, 0.02f, -0.12f},
                      .rest_direction = {0, -0.8f, -0.6f},
                      .length = length / float(count),
                      .stiffness = stiffness,
                      .damping = 2 * std::sqrt(stiffness),
                      .torsion = 20});
  }
  return rig;
}

namespace {

AlignedBytes hair_memory(Asset& asset, AlignedBytes& file, const HairDesc& desc) {
  if (!asset.open(file.bytes())) std::abort();  // the rig is the test's own
  const MemoryNeed need = Hair::memory_need(asset, desc);
  // Whatever a game's memory held before: small numbers, large ones, or none.
  static unsigned next = 0;
  constexpr unsigned char kLeftovers[] = {0x3C, 0x00, 0x7F, 0xFF};
  return AlignedBytes(std::vector<std::byte>(need.bytes, std::byte{kLeftovers[next++ % 4]}));
}

}  // namespace

TestHair::TestHair(const TestRig& rig, const HairDesc& desc)
    : file_(write_asset(rig.contents())), memory_(hair_memory(asset, file_, desc)) {
  if (hair.create(asset, desc, memory_.bytes()) != Status::kOk) std::abort();
  for (std::uint32_t i = 0; i < desc.instances; ++i) {
    if (hair.reset(i, {}) != Status::kOk) std::abort();
  }
}

std::vector<std::byte> TestHair::memory_copy() {
  const auto bytes = memory_.bytes();
  return {bytes.begin(), bytes.end()};
}

std::vector<Vec3> TestHair::ends(std::uint32_t instance) const {
  std::vector<Vec3> all(hair.bone_count());
  if (hair.bone_ends(instance, all) != Status::kOk) return {};
  all.erase(all.begin());
  return all;
}

std::vector<InstructionSet> runnable_sets() {
  std::vector<InstructionSet> sets;
  for (int i = 1; i <= int(InstructionSet::kWasm); ++i) {
    if (can_run(InstructionSet(i))) sets.push_back(InstructionSet(i));
  }
  return sets;
}

InstructionSet plainest_set() {
  return can_run(InstructionSet::kScalar) ? InstructionSet::kScalar : best_instruction_set();
}

float distance(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

float largest_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  float largest = a.size() == b.size() ? 0.0f : INFINITY;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const float d = distance(a[i], b[i]);
    largest = d <= largest ? largest : d;  // a NaN wins
  }
  return largest;
}

Quat turned_about(const Vec3& axis, double radians) {
  const float s = float(std::sin(radians / 2));
  return {axis.x * s, axis.y * s, axis.z * s, float(std::cos(radians / 2))};
}

Quat product(const Quat& a, const Quat& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
          a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

Vec3 rotated(const Quat& q, const Vec3& v) {
  const Quat turned = product(product(q, {v.x, v.y, v.z, 0}), {-q.x, -q.y, -q.z, q.w});
  return {turned.x, turned.y, turned.z};
}

double angle_between(const Quat& a, const Quat& b) {
  const Quat apart = product(a, {-b.x, -b.y, -b.z, b.w});
  return 2 * std::atan2(std::hypot(apart.x, apart.y, apart.z), std::fabs(apart.w));
}

Vec3 transformed(const Mat34& matrix, const Vec3& p) {
  float out[3];
  for (int row = 0; row < 3; ++row) {
    const float* m = matrix.m[row];
    out[row] = m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3];
  }
  return {out[0], out[1], out[2]};
}

}  // namespace coif
