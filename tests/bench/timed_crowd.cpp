#include "bench/timed_crowd.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace coif {
namespace {

[[noreturn]] void give_up(const std::string& what) {
  std::fprintf(stderr, "bench: %s\n", what.c_str());
  std::exit(1);
}

struct NamedSolver {
  const char* name;
  const Solver* solver;
};
const NamedSolver kSolvers[] = {{"coif", &kCoifSolver}, {"passive", &kPassiveSolver}, {"thesis", &kThesisSolver}};

struct NamedSet {
  const char* name;
  InstructionSet set;
};
constexpr NamedSet kSets[] = {{"avx512", InstructionSet::kAvx512}, {"avx2", InstructionSet::kAvx2},
                              {"sse4", InstructionSet::kSse4},     {"neon", InstructionSet::kNeon},
                              {"wasm", InstructionSet::kWasm},     {"portable", InstructionSet::kPortable},
                              {"scalar", InstructionSet::kScalar}};

template <class Named>
const Named& named(std::span<const Named> all, const std::string& name) {
  for (const Named& one : all) {
    if (one.name == name) return one;
  }
  give_up("there is no '" + name + "'");
}

HairDesc desc_of(const CrowdRun& run) {
  return {.instances = run.shape.heads,
          .solver = named<NamedSolver>(kSolvers, run.solver).solver,
          .instruction_set = named<NamedSet>(kSets, run.instruction_set).set};
}

HairDesc desc_of(std::uint32_t heads) { return {.instances = heads}; }

AlignedBytes memory_for(Asset& asset, AlignedBytes& file, const CrowdRun& run) {
  if (!asset.open(file.bytes())) give_up("the reader refuses the workload");
  return AlignedBytes(std::vector<std::byte>(Hair::memory_need(asset, desc_of(run)).bytes));
}

}  // namespace

std::vector<std::string> solver_names() {
  std::vector<std::string> names;
  for (const NamedSolver& solver : kSolvers) names.emplace_back(solver.name);
  return names;
}

std::vector<std::string> instruction_set_names() {
  std::vector<std::string> names;
  for (const NamedSet& set : kSets) {
    if (can_run(set.set)) names.emplace_back(set.name);
  }
  return names;
}

TimedCrowd::TimedCrowd(const CrowdRun& run)
    : run_(run), file_(write_asset(crowd_contents(run.shape))), memory_(memory_for(asset_, file_, run)) {
  settings_.substeps = run.substeps;
  settings_.sleep_after = run.sleep_after;
  if (hair_.create(asset_, desc_of(run), memory_.bytes()) != Status::kOk) give_up("create() refuses the workload");
  poses_.resize(run.shape.heads);
  plan(0);
  for (std::uint32_t head = 0; head < run.shape.heads; ++head) {
    if (hair_.reset(head, poses_[head]) != Status::kOk) give_up("reset() refuses a pose");
  }
}

void TimedCrowd::plan(double dt) {
  seconds_ += dt;
  for (std::uint32_t head = 0; head < poses_.size(); ++head) poses_[head] = head_pose_at(head, seconds_);
}

void TimedCrowd::set_heads() { refused_ = hair_.set_heads(poses_) != Status::kOk || refused_; }

void TimedCrowd::step(float dt) {
  settings_.dt = dt;
  refused_ = hair_.step(settings_) != Status::kOk || refused_;
}

void TimedCrowd::step_with(JobCrew& crew, float dt, bool is_shared) {
  settings_.dt = dt;
  refused_ = hair_.begin_step(settings_) != Status::kOk || refused_;
  const JobCrew::Work run_job = [this](std::uint32_t job) { hair_.run_job(job); };
  is_shared ? crew.run(hair_.job_count(), run_job) : crew.run_alone(hair_.job_count(), run_job);
  hair_.finish_step();
}

std::uint32_t TimedCrowd::sleeping_heads() const {
  std::uint32_t sleeping = 0;
  for (std::uint32_t head = 0; head < run_.shape.heads; ++head) sleeping += hair_.is_asleep(head) ? 1 : 0;
  return sleeping;
}

double TimedCrowd::bytes_per_head() const {
  return double(Hair::memory_need(asset_, desc_of(run_)).bytes) / run_.shape.heads;
}

bool TimedCrowd::is_sane() const {
  // Algorithm 1 stretches, but not by that much.
  const float reach = 10 * (kHeadRadius + kBoneLength * float(run_.shape.bones));
  std::vector<Vec3> ends(asset_.bones().size());
  for (std::uint32_t head = 0; head < run_.shape.heads; ++head) {
    if (hair_.bone_ends(head, ends) != Status::kOk) return false;
    for (const Vec3& end : ends) {
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
