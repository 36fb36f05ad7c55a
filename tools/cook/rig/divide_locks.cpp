#include "cook/recipe/rig_recipe.h"
#include "cook/rig/fit_chains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace coif::cook {
namespace {

constexpr std::size_t kTurns = 72;  ///< Sectors around the head's upright axis in which hair is counted.
constexpr double kTurn = 2 * std::numbers::pi;
/// Share of the head's radius: nearer to the axis the angle says nothing.
constexpr double kBesideAxis = 0.4;
constexpr double kEmpty = 0.1;  ///< Share of the mean sector's area: less is a gap, or a wisp.
/// A lock wider than the second is divided into parts of about the first, radians around the head.
constexpr double kPart = std::numbers::pi / 3, kWidest = 1.25 * kPart;
constexpr double kWidestLock = 1.1;  ///< Share of the head's radius: what is narrower than this stays one lock.

/// 0 at the front .. 1 around the head; over +X first.
double turn_of(const HangingHair& hair, const FittedHead& head, std::uint32_t cell) {
  const Eigen::Vector3d from = hair.cells.middle[cell] - head.center;
  const double turn = std::atan2(from.x(), from.z()) / kTurn;
  return turn < 0 ? turn + 1 : turn;
}

double beside_axis(const HangingHair& hair, const FittedHead& head, std::uint32_t cell) {
  const Eigen::Vector3d from = hair.cells.middle[cell] - head.center;
  return std::hypot(from.x(), from.z());
}

/// What a lock covers of the circle around the head.
struct LockArc {
  double first = 0;   ///< Turn at which it begins.
  double extent = 0;  ///< Turns from there on; 0: it lies around the axis.
  double radius = 0;  ///< Mean distance from the axis, metres.
};

/// All but the widest gap.
LockArc arc_of(const HangingHair& hair, const FittedHead& head, const HairLock& lock) {
  std::array<double, kTurns> area{};
  double all = 0;
  LockArc arc;
  for (const std::uint32_t c : lock.cells) {
    const double radius = beside_axis(hair, head, c);
    if (radius < kBesideAxis * head.radii.mean()) continue;
    area[std::min(kTurns - 1, std::size_t(turn_of(hair, head, c) * double(kTurns)))] += hair.cells.area[c];
    arc.radius += hair.cells.area[c] * radius;
    all += hair.cells.area[c];
  }
  if (all <= 0) return arc;
  arc.radius /= all;
  const double least = kEmpty * all / double(kTurns);
  std::size_t widest = 0, end = 0, run = 0;
  for (std::size_t i = 0; i < 2 * kTurns; ++i) {
    run = area[i % kTurns] < least ? run + 1 : 0;
    if (run <= widest || run > kTurns) continue;
    widest = run;
    end = i + 1;
  }
  // A ring without a gap is cut at the front, where faces are.
  arc.first = double(end % kTurns) / double(kTurns);
  arc.extent = double(kTurns - widest) / double(kTurns);
  return arc;
}

std::size_t parts_of(const LockArc& arc, double head_radius) {
  const double width = kTurn * arc.extent;
  if (width < kWidest || width * arc.radius < kWidestLock * head_radius) return 1;
  return std::max<std::size_t>(2, std::size_t(std::lround(width / kPart)));
}

/// The cells of each part, and the turn of its middle.
std::vector<HairLock> divided(const HangingHair& hair, const FittedHead& head, const HairLock& lock, const LockArc& arc,
                              std::size_t count) {
  std::vector<HairLock> parts(count);
  for (std::size_t part = 0; part < count; ++part) {
    parts[part].turn = arc.first + arc.extent * (double(part) + 0.5) / double(count);
  }
  for (const std::uint32_t c : lock.cells) {
    double turn = turn_of(hair, head, c) - arc.first;
    if (turn < 0) turn += 1;
    // A wisp in the gap belongs to the nearer end.
    if (turn > arc.extent) turn = turn - arc.extent < 1 - turn ? arc.extent : 0;
    parts[std::min(count - 1, std::size_t(turn / arc.extent * double(count)))].cells.push_back(c);
  }
  std::erase_if(parts, [](const HairLock& part) { return part.cells.empty(); });
  return parts;
}

/// Measures the parts' hair again, and finds their tips.
void measure(HangingHair& hair, std::vector<HairLock>& locks, double shortest) {
  std::vector<std::uint32_t> part(hair.cells.count(), importer::kNoIndex);
  for (std::uint32_t l = 0; l < locks.size(); ++l) {
    if (!locks[l].turn) continue;
    for (const std::uint32_t c : locks[l].cells) part[c] = l;
  }
  measure_parts(hair, part);
  const auto depth = [&](std::uint32_t c) { return hair.depth[c]; };
  for (HairLock& lock : locks) {
    if (!lock.turn) continue;
    const std::uint32_t tip = *std::ranges::max_element(lock.cells, {}, depth);
    for (std::uint32_t c = tip; c != importer::kNoIndex; c = hair.from[c]) lock.ways.push_back(c);
    std::ranges::sort(lock.ways);
    lock.length = hair.depth[tip];
    lock.moves = lock.length >= shortest;
  }
}

}  // namespace

std::vector<HairLock> divide_wide_locks(HangingHair& hair, std::vector<HairLock> locks, const FittedHead& head,
                                        const RigRecipe& recipe) {
  auto moving = std::size_t(std::ranges::count(locks, true, &HairLock::moves));
  std::vector<HairLock> all;
  for (HairLock& lock : locks) {
    const LockArc arc = lock.moves ? arc_of(hair, head, lock) : LockArc{};
    const std::size_t room = recipe.chain_max_count - std::min<std::size_t>(moving, recipe.chain_max_count) + 1;
    const std::size_t parts = lock.moves ? std::min(room, parts_of(arc, head.radii.mean())) : 1;
    if (parts < 2) {
      all.push_back(std::move(lock));
      continue;
    }
    moving += parts - 1;
    for (HairLock& part : divided(hair, head, lock, arc, parts)) all.push_back(std::move(part));
  }
  measure(hair, all, recipe.chain_shortest);
  return all;
}

}  // namespace coif::cook
