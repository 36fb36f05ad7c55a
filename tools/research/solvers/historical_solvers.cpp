#include "research/solvers/historical_solvers.h"

#include <memory>

namespace coif::research {
namespace {

template <typename Solver>
std::unique_ptr<lab::ChainSolver> iterated(const lab::Rig& rig, const lab::SolverScene& scene, int iterations) {
  return std::make_unique<Solver>(rig, scene, iterations);
}

template <typename Solver>
std::unique_ptr<lab::ChainSolver> sub_stepped(const lab::Rig& rig, const lab::SolverScene& scene, int count) {
  return in_sub_steps(std::make_unique<Solver>(rig, scene), count);
}

constexpr std::string_view kIterations = "iterations";
constexpr std::string_view kSubSteps = "sub-steps";

constexpr int kFew[] = {1, 2, 4, 8};
constexpr int kNewton[] = {1, 2, 3, 4};
constexpr int kSmallSteps[] = {1, 2, 4, 8, 16, 32};
constexpr int kExplicit[] = {4, 16, 64, 256};  // At 60 fps, below 4 even three bones explode.
// Three bones hold with the first; a hinge is as strong as all that hangs from it.
constexpr int kHinged[] = {16, 64, 256};

const ListedSolver kSolvers[] = {
    {"mass-spring", "point masses on stiff springs, integrated explicitly",
     "thesis 3.1 and 5.2, initial attempt; Rosenblum et al. 1991", kSubSteps, kExplicit, sub_stepped<MassSpringSolver>,
     true},
    {"angular-springs", "the mass-spring system, its pose held by springs at the hinges that turn both segments",
     "thesis 3.1, Figure 5; Rosenblum et al. 1991", kSubSteps, kHinged, sub_stepped<AngularSpringSolver>, true},
    {"impulse", "errors of length and collision become impulses, the pose a constant pull",
     "thesis 5.2, replacing the springs", kIterations, kFew, iterated<ImpulseSolver>},
    {"separate", "positions are put right directly and velocities adjusted to match",
     "thesis 5.2, adjusting positions and velocities separately", kIterations, kFew, iterated<SeparateSolver>},
    {"implicit", "the mass-spring system by backward Euler, one linear solve per step",
     "thesis 3.1; Baraff and Witkin 1998", kSubSteps, kFew, sub_stepped<ImplicitSolver>, true},
    {"projective", "rigid sticks, one equation of motion for each of two angles",
     "thesis 3.2; Anjyo, Usami and Kurihara 1992", kSubSteps, kFew, sub_stepped<ProjectiveSolver>, true},
    {"follow-leader", "dynamic follow-the-leader, one pass from root to tip", "Mueller, Kim and Chentanez 2012",
     kSubSteps, kFew, sub_stepped<FollowLeaderSolver>, true},
    {"tridiagonal", "all lengths of a strand by one direct solve per Newton step", "Han and Harada 2013", kIterations,
     kNewton, iterated<TridiagonalSolver>},
    {"xpbd", "extended position-based dynamics with small steps of one iteration", "Macklin et al. 2016 and 2019",
     kSubSteps, kSmallSteps, sub_stepped<XpbdSolver>, true},
};

}  // namespace

std::span<const ListedSolver> historical_solvers() { return kSolvers; }

}  // namespace coif::research
