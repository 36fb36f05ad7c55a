#include "bench/crowd.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace coif {
namespace {

[[noreturn]] void give_up(const char* what) {
  std::fprintf(stderr, "bench: %s\n", what);
  std::exit(1);
}

HairDesc desc_of(std::uint32_t heads) { return {.instances = heads}; }

AlignedBytes memory_for(Asset& asset, AlignedBytes& file, const CrowdRun& run) {
  if (!asset.open(file.bytes())) give_up("the reader refuses the workload");
  const std::size_t bytes = bytes_to_create(asset, run.shape.heads);
  return AlignedBytes(std::vector<std::byte>(bytes));
}

}  // namespace

std::string CrowdRun::solver_name() const { return solver == Solver::kCoif ? "coif" : "thesis"; }

std::string CrowdRun::instruction_set() const { return "scalar"; }

Crowd::Crowd(const CrowdRun& run)
    : run_(run), file_(write_asset(crowd_contents(run.shape))), memory_(memory_for(asset_, file_, run)) {
  if (hair_.create(asset_, desc_of(run.shape.heads), memory_.bytes()) != Status::kOk) give_up("create() refuses");
  poses_.resize(run.shape.heads);
  plan(0);
  for (std::uint32_t head = 0; head < run.shape.heads; ++head) {
    if (hair_.reset(head, poses_[head]) != Status::kOk) give_up("reset() refuses a pose");
  }
}

void Crowd::plan(double dt) {
  seconds_ += dt;
  for (std::uint32_t head = 0; head < poses_.size(); ++head) poses_[head] = head_pose_at(head, seconds_);
}

void Crowd::set_heads() {
  for (std::uint32_t head = 0; head < poses_.size(); ++head) {
    refused_ = hair_.set_head(head, poses_[head]) != Status::kOk || refused_;
  }
}

void Crowd::step(float dt) {
  const StepSettings settings{.dt = dt, .solver = run_.solver, .substeps = run_.substeps};
  refused_ = hair_.step(settings) != Status::kOk || refused_;
}

double Crowd::bytes_per_head() const { return double(bytes_to_create(asset_, run_.shape.heads)) / run_.shape.heads; }

bool Crowd::is_sane() const {
  const float reach = 10 * (kHeadRadius + 0.08f * float(run_.shape.bones));  // Algorithm 1 stretches
  for (std::uint32_t head = 0; head < run_.shape.heads; ++head) {
    for (const Vec3& end : hair_.bone_ends(head)) {
      if (!(std::hypot(end.x, end.y, end.z) < reach)) return false;
    }
  }
  return !refused_;
}

bool create_once(const Asset& asset, std::uint32_t heads, std::span<std::byte> memory) {
  Hair hair;
  return hair.create(asset, desc_of(heads), memory) == Status::kOk;
}

std::size_t bytes_to_create(const Asset& asset, std::uint32_t heads) {
  return Hair::memory_need(asset, desc_of(heads)).bytes;
}

}  // namespace coif
