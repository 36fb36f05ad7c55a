#include "bench/peers/bullet_rope.h"

#include <BulletSoftBody/btSoftBodyHelpers.h>

#include <cmath>

namespace coif {
namespace {

constexpr int kSpheres = 1;  // collision groups
constexpr int kRopes = 2;
constexpr float kMargin = 0.01f;    // m; the workload's hit radius
constexpr float kDamping = 0.033f;  // of a node's velocity in each step: the workload's friction of 2 / s

btTransform transform_of(const HeadPose& pose) {
  const Quat& turn = pose.rotation;
  return btTransform(btQuaternion(turn.x, turn.y, turn.z, turn.w),
                     btVector3(float(pose.position[0]), float(pose.position[1]), float(pose.position[2])));
}

btVector3 tip_of(const BoneRecord& bone) {
  const float* along = bone.rest_direction;
  return btVector3(bone.joint[0], bone.joint[1], bone.joint[2]) + btVector3(along[0], along[1], along[2]) * bone.length;
}

}  // namespace

BulletRopes::BulletRopes(const CrowdShape& shape, int iterations) {
  const btVector3 gravity(0, -9.81f, 0);
  world_.setGravity(gravity);
  btSoftBodyWorldInfo& info = world_.getWorldInfo();
  info.m_gravity = gravity;
  info.air_density = 0;
  info.m_broadphase = &broadphase_;
  info.m_dispatcher = &dispatcher_;
  info.m_sparsesdf.Initialize();
  const AssetContents contents = crowd_contents(shape);
  for (std::uint32_t head = 0; head < shape.heads; ++head) add_head(head, contents, iterations);
}

BulletRopes::~BulletRopes() {
  for (Rope& rope : ropes_) world_.removeSoftBody(rope.body.get());
  for (auto& head : heads_) world_.removeRigidBody(head.get());
}

void BulletRopes::add_head(std::uint32_t head, const AssetContents& contents, int iterations) {
  auto body = std::make_unique<btRigidBody>(0.0f, nullptr, &sphere_);
  body->setCollisionFlags(body->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  body->setActivationState(DISABLE_DEACTIVATION);
  body->setWorldTransform(transform_of(head_pose_at(head, 0)));
  world_.addRigidBody(body.get(), kSpheres, kRopes);
  heads_.push_back(std::move(body));
  for (const ChainRecord& chain : contents.chains) add_rope(head, contents, chain, iterations);
}

void BulletRopes::add_rope(std::uint32_t head, const AssetContents& contents, const ChainRecord& chain,
                           int iterations) {
  const BoneRecord& first = contents.bones[chain.first_bone];
  const btTransform world_from_head = transform_of(head_pose_at(head, 0));
  const btVector3 root(first.joint[0], first.joint[1], first.joint[2]);
  const btVector3 tip = tip_of(contents.bones[chain.first_bone + chain.bone_count - 1]);
  constexpr int kRootIsFixed = 1;
  const int inner_nodes = int(chain.bone_count) - 1;
  std::unique_ptr<btSoftBody> body(btSoftBodyHelpers::CreateRope(world_.getWorldInfo(), world_from_head * root,
                                                                 world_from_head * tip, inner_nodes, kRootIsFixed));
  body->m_cfg.piterations = iterations;
  body->m_cfg.kDP = kDamping;
  body->m_cfg.collisions = btSoftBody::fCollision::SDF_RS;
  body->m_materials[0]->m_kLST = 1;
  body->getCollisionShape()->setMargin(kMargin);
  body->setActivationState(DISABLE_DEACTIVATION);
  world_.addSoftBody(body.get(), kRopes, kSpheres);
  ropes_.push_back({head, root, std::move(body)});
}

void BulletRopes::move_heads(double dt) {
  seconds_ += dt;
  for (std::uint32_t head = 0; head < heads_.size(); ++head) {
    heads_[head]->setWorldTransform(transform_of(head_pose_at(head, seconds_)));
  }
  for (Rope& rope : ropes_) {
    btSoftBody::Node& root = rope.body->m_nodes[0];
    root.m_x = heads_[rope.head]->getWorldTransform() * rope.root;
    root.m_v.setZero();
  }
}

void BulletRopes::step(float dt) {
  constexpr int kMostSubsteps = 1;
  world_.stepSimulation(dt, kMostSubsteps, dt);
}

bool BulletRopes::is_sane() const {
  for (const Rope& rope : ropes_) {
    const btSoftBody::tNodeArray& nodes = rope.body->m_nodes;
    if (!std::isfinite(nodes[nodes.size() - 1].m_x.length2())) return false;
  }
  return true;
}

}  // namespace coif
