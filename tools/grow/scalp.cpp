#include "grow/strand_paths.h"

#include "base/parallel_for.h"
#include "grow/flow.h"
#include "grow/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace coif::grow {
namespace {

using Eigen::Vector3f;

struct Knot {
  float azimuth, value;
};

/// Smooth through the knots, flat at each.
template <std::size_t N>
float between(const std::array<Knot, N>& knots, float azimuth) {
  for (std::size_t i = 1; i < N; ++i) {
    if (azimuth > knots[i].azimuth) continue;
    const float share = ramp(knots[i - 1].azimuth, knots[i].azimuth, azimuth);
    return knots[i - 1].value + share * (knots[i].value - knots[i - 1].value);
  }
  return knots.back().value;
}

/// A curve through knots that never passes beyond two neighbours, flat at both ends. Source: Fritsch and Butland 1984,
/// "A method for constructing local monotone piecewise cubic interpolants".
template <std::size_t N>
float along_curve(const std::array<Knot, N>& knots, float azimuth) {
  const auto rise = [&](std::size_t i) {
    return (knots[i + 1].value - knots[i].value) / (knots[i + 1].azimuth - knots[i].azimuth);
  };
  const auto slope = [&](std::size_t i) {
    if (i == 0 || i + 1 == N || rise(i - 1) * rise(i) <= 0) return 0.0f;
    return 2 * rise(i - 1) * rise(i) / (rise(i - 1) + rise(i));
  };
  std::size_t i = 0;
  while (i + 2 < N && azimuth > knots[i + 1].azimuth) ++i;
  const float width = knots[i + 1].azimuth - knots[i].azimuth;
  const float t = std::clamp((azimuth - knots[i].azimuth) / width, 0.0f, 1.0f), u = 1 - t;
  return u * u * ((1 + 2 * t) * knots[i].value + t * width * slope(i)) +
         t * t * ((1 + 2 * u) * knots[i + 1].value - u * width * slope(i + 1));
}

/// Direction `i` of `count` that lie evenly over the sphere, shaken a little: a lattice shows as rows of roots. Source:
/// Swinbank and Purser 2006, "Fibonacci grids".
Vector3f spread_on_sphere(std::size_t i, std::size_t count, const Dice& dice) {
  constexpr double kGoldenAngle = 2.399963229728653;
  const double y = 1 - (2 * double(i) + 1) / double(count), around = kGoldenAngle * double(i);
  const double side = std::sqrt(std::max(1 - y * y, 0.0));
  const float spacing = std::sqrt(4 * std::numbers::pi_v<float> / float(count));
  const Vector3f even(float(side * std::cos(around)), float(y), float(side * std::sin(around)));
  return (even + 0.45f * spacing * dice.in_cube(i)).normalized();
}

/// The outermost skin in a direction; the ray to the head's middle meets it from outside.
Vector3f skin_in(const Vector3f& direction, const HeadFrame& head, const BodyField& body) {
  constexpr int kSteps = 48;
  constexpr float kBeginning = 1.7f;  // head radii
  const Vector3f ray = head.radii.cwiseProduct(direction);
  const float length = ray.norm();
  float at = kBeginning;
  for (int i = 0; i < kSteps && at > 0.2f; ++i) {
    const float away = body.distance(head.center + at * ray);
    if (std::abs(away) < 1e-3f * length) break;
    at -= 0.9f * away / length;
  }
  return head.center + at * ray;
}

/// Degrees: no hairline is ruled.
float raggedness(const cook::HairStyle& style, float azimuth) {
  const Dice dice(style.grow_seed, Purpose::kHairline);
  return 0.18f * std::min(float(style.grow_hairline_fade), 10.0f) * dice.smooth(0, azimuth / 5).x();
}

bool grows_at(const Vector3f& direction, std::size_t i, const cook::HairStyle& style, const Flow& flow,
              const Dice& dice) {
  constexpr float kElsewhere = 0.4f;  // Density of roots relative to places where no other hair lies over them.
  const float azimuth = azimuth_of(direction);
  const float above = elevation_of(direction) - hairline(style, azimuth) + raggedness(style, azimuth);
  const auto fade = float(style.grow_hairline_fade);
  if (above < -0.3f * fade) return false;
  const float dense = kElsewhere + (1 - kElsewhere) * flow.leaves_bare(direction);
  return dice.unit(i) <= dense * (0.12f + 0.88f * ramp(-0.3f * fade, fade, above));
}

/// Those of `count` directions all around in which hair grows.
std::vector<std::uint32_t> hairy(std::size_t count, const cook::HairStyle& style, const Flow& flow) {
  const Dice roots(style.grow_seed, Purpose::kRoot), fade(style.grow_seed, Purpose::kFade);
  std::vector<std::uint32_t> found;
  for (std::size_t i = 0; i < count; ++i) {
    if (grows_at(spread_on_sphere(i, count, roots), i, style, flow, fade)) found.push_back(std::uint32_t(i));
  }
  return found;
}

/// Hair at the hairline: some of it stays short, and all is finer.
void thin_out(const cook::HairStyle& style, const HeadFrame& head, std::size_t i, float above, Root& root) {
  constexpr float kShortest = 0.008f, kLongest = 0.045f;  // metres
  const Dice dice(style.grow_seed, Purpose::kHairline);
  const float fewer = root.is_fringe ? 0.4f : 1.0f;
  const float near =
      fewer * float(style.grow_hairline_wisps) * (1 - ramp(0, 1.8f * float(style.grow_hairline_fade), above));
  root.width = 1 - near * (0.3f + 0.4f * dice.unit(i, 1));
  if (dice.unit(i, 2) >= near) return;
  const float share = dice.unit(i, 3);
  const float length = head.scale() * (kShortest + share * share * (kLongest - kShortest));
  if (length >= root.length) return;
  root.is_wisp = true;
  root.grown_share *= length / root.length;
  root.length = length;
}

void settle(const cook::HairStyle& style, const HeadFrame& head, std::size_t i, Root& root) {
  const float azimuth = azimuth_of(root.direction), elevation = elevation_of(root.direction);
  const float above = elevation - hairline(style, azimuth), room = 90 - hairline(style, azimuth);
  root.height = std::clamp(above / std::max(room, 1.0f), 0.0f, 1.0f);
  const Dice dice(style.grow_seed, Purpose::kLength);
  const std::array<Knot, 4> around{{{0, float(style.grow_length_front)},
                                    {50, float(style.grow_length_front)},
                                    {95, float(style.grow_length_sides)},
                                    {165, float(style.grow_length_back)}}};
  const float low = between(around, std::abs(azimuth));
  root.length = low + ramp(35, 65, elevation) * (float(style.grow_length_top) - low);
  const float ragged = float(style.grow_fringe_depth) * (1 + 0.15f * dice.signed_unit(i, 1));
  root.is_fringe =
      std::abs(azimuth) < float(style.grow_fringe_width) * (1 + 0.06f * dice.signed_unit(i, 2)) && above < ragged;
  // Equal lengths below the hairline, wherever the hair begins.
  if (root.is_fringe) {
    const float longer = root.length;
    root.length = float(style.grow_fringe_length) + kUsualRadius * kRadians * std::max(above, 0.0f);
    root.grown_share = std::min(root.length / longer, 1.0f);
  }
  root.length *= head.scale() * (1 - float(style.grow_length_random) * dice.unit(i));
  thin_out(style, head, i, above, root);
}

}  // namespace

float hairline(const cook::HairStyle& style, float azimuth) {
  const auto front = float(style.grow_hairline_front), temples = float(style.grow_hairline_temples),
             recess = float(style.grow_hairline_recess), sides = float(style.grow_hairline_sides),
             nape = float(style.grow_hairline_nape);
  // A head that is bald at the sides has no sideburns.
  const float burns = sides - float(style.grow_hairline_sideburns) * (1 - ramp(45, 90, sides));
  const auto towards_nape = [&](float share) { return sides + share * (nape - sides); };
  const std::array<Knot, 14> knots{{{0, front},
                                    {20, front + 0.25f * recess},
                                    {38, 0.45f * front + 0.55f * temples + recess},
                                    {55, temples},
                                    {65, temples + 0.6f * (burns - temples)},
                                    {71, temples + 0.96f * (burns - temples)},
                                    {76, burns},
                                    {81, burns + 0.55f * (sides - burns)},
                                    {86, burns + 0.97f * (sides - burns)},
                                    {98, sides},
                                    {108, towards_nape(0.4f)},
                                    {122, towards_nape(0.76f)},
                                    {145, towards_nape(0.96f)},
                                    {165, nape}}};
  return along_curve(knots, std::abs(azimuth));
}

std::vector<Root> spread_roots(const cook::HairStyle& style, const HeadFrame& head, const BodyField& body,
                               const platform::Threads& threads) {
  constexpr std::size_t kTrial = 16384;
  const Flow flow(style, head);
  const std::size_t wanted = style.grow_strands, sample = hairy(kTrial, style, flow).size();
  if (sample == 0) return {};
  // Makes a few more than wanted, and leaves out the last ones of a random order.
  std::size_t all = kTrial * wanted / sample + kTrial / 8;
  std::vector<std::uint32_t> found = hairy(all, style, flow);
  while (found.size() < wanted) found = hairy(all += all / 8, style, flow);
  const Dice dice(style.grow_seed, Purpose::kRoot);
  std::ranges::nth_element(found, found.begin() + std::ptrdiff_t(wanted) - 1, {},
                           [&](std::uint32_t i) { return std::pair(dice.unit(i, 99), i); });
  found.resize(wanted);
  std::ranges::sort(found);
  std::vector<Root> roots(found.size());
  parallel_for(found.size(), threads, [&](std::size_t k) {
    const Vector3f ray = spread_on_sphere(found[k], all, dice);
    roots[k].place = skin_in(ray, head, body);
    roots[k].direction = head.direction(roots[k].place);
    settle(style, head, k, roots[k]);
  });
  return roots;
}

}  // namespace coif::grow
