#include "cards/judge_cards.h"

#include "base/parallel_for.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace coif::cards {
namespace {

constexpr double kLayersCount = 0.1;        // exponent of the layers in the price
constexpr std::uint32_t kFar = 4;           // pixels of a close picture in one of a far picture, each way
constexpr std::uint32_t kJudged = 128;      // pixels of a close picture of the finest level
constexpr std::uint32_t kLeastJudged = 64;  // of any level
constexpr int kJudgedRounds = 2;            // of fit_opacity()
constexpr double kMostLayers = 3;           // times the fewest of all plans
constexpr std::size_t kFewJudgedTexels = std::size_t{1} << 16;
constexpr std::size_t kJudgedTexels = 4;  // the texels are divided by this
/// What is tried of each construction: quads per card.
constexpr double kBentQuads[] = {1, 1.5, 2, 3, 4, 5, 6.5, 9, 12, 16, 20, 26},
                 kEvenQuads[] = {1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 25}, kFlatQuads[] = {1};
constexpr double kUsualQuads = 3;  // where the search begins

std::span<const double> quads_of(Construction construction) {
  switch (construction) {
    case Construction::kBent: return kBentQuads;
    case Construction::kEven: return kEvenQuads;
    case Construction::kFlat: break;
  }
  return kFlatQuads;
}

/// The picture with `kFar` x `kFar` pixels made one.
HairPicture far_picture(const HairPicture& close) {
  HairPicture out = blank_picture(close.size / kFar);
  constexpr float kShare = 1.0f / float(kFar * kFar);
  for (std::uint32_t y = 0; y < out.size * kFar; ++y) {
    for (std::uint32_t x = 0; x < out.size * kFar; ++x) {
      const std::size_t from = std::size_t(y) * close.size + x, to = std::size_t(y / kFar) * out.size + x / kFar;
      out.coverage[to] += kShare * close.coverage[from];
      out.shade[to] += kShare * close.shade[from];
    }
  }
  return out;
}

/// The cards' triangles alone.
CardSurface bare_surface_of(const ChosenCards& chosen) {
  Cards cards;
  cards.wisps = chosen.wisps;
  cards.strips = chosen.strips;
  cards.plan.width = cards.plan.height = 4;
  cards.shares = own_textures(cards.strips.size());
  cards.plan.places.resize(cards.strips.size());
  return surface_of(cards);
}

/// Tries plans one after the other.
class PlanSearch {
 public:
  PlanSearch(const groom::Groom& groom, const GroomShape& shape, const PlanBudget& budget,
             const platform::Threads& threads)
      : groom_(groom),
        shape_(shape),
        budget_(budget),
        threads_(threads),
        judge_(groom, shape.strands.width, size_of(budget), threads),
        target_(groom, shape.strands.width, size_of(budget)) {}

  /// From the usual number of quads on, or that of the best plan so far, as long as fewer or more are better.
  void search(Construction construction) {
    const std::span<const double> quads = quads_of(construction);
    const double usual = std::isfinite(least_) ? best_.quads : kUsualQuads;
    const auto first =
        std::min<std::size_t>(std::size_t(std::ranges::lower_bound(quads, usual) - quads.begin()), quads.size() - 1);
    double least = price({construction, quads[first]});
    bool has_fewer = false;
    for (std::size_t i = first; i-- > 0; has_fewer = true) {
      const double found = price({construction, quads[i]});
      if (!(found < least)) break;
      least = found;
    }
    if (has_fewer) return;
    for (std::size_t i = first + 1; i < quads.size(); ++i) {
      const double found = price({construction, quads[i]});
      if (!(found < least) && std::isfinite(least)) break;  // Fewer cards may fit where more do not.
      least = std::min(least, found);
    }
  }

  [[nodiscard]] const CardsPlan& best() const { return best_; }

 private:
  static std::uint32_t size_of(const PlanBudget& budget) {
    return std::max(std::uint32_t(budget.scale * float(kJudged)), kLeastJudged) / kFar * kFar;
  }

  [[nodiscard]] std::size_t texels() const {
    return std::max(budget_.texels / kJudgedTexels, std::min(budget_.texels, kFewJudgedTexels));
  }

  /// Infinite for cards that cannot be made, and for those in very many layers, whose fit takes long.
  double price(const CardsPlan& plan) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    if (double(budget_.triangles) < 2 * plan.quads) return kNone;
    ChosenCards chosen = construct_cards(groom_, shape_.strands, plan, budget_.triangles, threads_);
    const double layers = judge_.layers(bare_surface_of(chosen), threads_);
    fewest_layers_ = std::min(fewest_layers_, layers);
    if (layers > kMostLayers * fewest_layers_) return kNone;
    auto cards = texture_cards(groom_, shape_, std::move(chosen), texels(), threads_);
    if (!cards) return kNone;
    fit_opacity(target_, std::min(kJudgedRounds, budget_.rounds), *cards, threads_);
    CardSurface surface = surface_of(*cards);
    draw_as_cooked(surface);
    const double price = judge_.judge(surface, threads_).price();
    if (price < least_) {
      least_ = price;
      best_ = plan;
    }
    return price;
  }

  const groom::Groom& groom_;
  const GroomShape& shape_;
  PlanBudget budget_;
  platform::Threads threads_;
  CardsJudge judge_;
  FitTarget target_;
  CardsPlan best_{Construction::kBent, 1};
  double least_ = std::numeric_limits<double>::infinity(), fewest_layers_ = least_;
};

}  // namespace

double CardsMerit::price() const { return 0.5 * (close_error + far_error) * std::pow(layers, kLayersCount); }

CardsJudge::CardsJudge(const groom::Groom& groom, float strand_width, std::uint32_t size,
                       const platform::Threads& threads) {
  const ShownBall ball = ball_around(groom.points);
  const Eigen::Matrix3f turn = Eigen::AngleAxisf(1.1f, Eigen::Vector3f::UnitX()).toRotationMatrix();
  for (const Eigen::Vector3f& direction : spread_directions(kViews)) {
    frames_.push_back(frame_along(turn * direction, ball, size));
    strands_.push_back(draw_strands(groom, frames_.back(), strand_width, threads));
  }
}

CardsMerit CardsJudge::judge(const CardSurface& surface, const platform::Threads& threads) const {
  CardsMerit merit;
  for (std::size_t i = 0; i < kViews; ++i) {
    const HairPicture seen = draw_cards(surface, frames_[i], threads);
    merit.close_error += compare_hair(strands_[i], seen).error / double(kViews);
    merit.far_error += compare_hair(far_picture(strands_[i]), far_picture(seen)).error / double(kViews);
  }
  merit.layers = layers(surface, threads);
  return merit;
}

double CardsJudge::layers(const CardSurface& surface, const platform::Threads& threads) const {
  std::vector<double> layers(kViews);
  parallel_for(kViews, threads, [&](std::size_t i) { layers[i] = cost_of(surface, frames_[i]).layers; });
  double mean = 0;
  for (const double one : layers) mean += one / double(kViews);
  return mean;
}

CardsPlan choose_plan(const groom::Groom& groom, const GroomShape& shape, std::span<const Construction> constructions,
                      const PlanBudget& budget, const platform::Threads& threads) {
  PlanSearch search(groom, shape, budget, threads);
  for (const Construction construction : constructions) search.search(construction);
  return search.best();
}

}  // namespace coif::cards
