#pragma once

#include "bench/workload.h"

#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace coif {

/// The crowd of ../workload.h as Bullet's soft bodies: one rope for each chain, its root node fixed to the head, which
/// is a kinematic sphere.
class BulletRopes {
 public:
  BulletRopes(const CrowdShape& shape, int iterations);
  ~BulletRopes();
  BulletRopes(const BulletRopes&) = delete;
  BulletRopes& operator=(const BulletRopes&) = delete;

  /// Moves heads and roots on by `dt` seconds.
  void move_heads(double dt);
  void step(float dt);
  /// False where a rope is not finite.
  [[nodiscard]] bool is_sane() const;

 private:
  struct Rope {
    std::uint32_t head;
    btVector3 root;  ///< Head space, metres.
    std::unique_ptr<btSoftBody> body;
  };

  void add_head(std::uint32_t head, const AssetContents& contents, int iterations);
  void add_rope(std::uint32_t head, const AssetContents& contents, const ChainRecord& chain, int iterations);

  btSoftBodyRigidBodyCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btSoftRigidDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  btSphereShape sphere_{kHeadRadius};  ///< All heads share it, and its signed distance field.
  std::vector<std::unique_ptr<btRigidBody>> heads_;
  std::vector<Rope> ropes_;
  double seconds_ = 0;
};

}  // namespace coif
