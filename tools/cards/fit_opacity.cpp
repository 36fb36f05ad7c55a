#include "cards/fit_opacity.h"

#include "base/parallel_for.h"
#include "cards/fit_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace coif::cards {
namespace {

constexpr double kLeastFall = 0.02;      // Share of the error that makes another round worthwhile.
constexpr float kLittleSeen = 0.3f;      // samples: texels that are seen less than this change less
constexpr float kOnwards = 0.5f;         // Share of a texel's last change that is repeated.
constexpr std::size_t kSpreadAlong = 4;  // texels
constexpr float kEdge = 0.12f;           // Share of a card's width and length.

/// The change that views request for every texel of the atlas.
class AtlasChange {
 public:
  AtlasChange(std::uint32_t width, std::uint32_t height)
      : width_(width), asked_(std::size_t(width) * height, 0), seen_(asked_.size(), 0) {}

  /// Adds one card's part of a view: the share of each sample that is seen through everything else, and the coverage
  /// that its pixel lacks.
  void add(const FitView& view, std::size_t card) {
    for (const SeenTexel& seen : view.of_card(card)) {
      const float lacking = view.lacking(seen), through = view.weight(seen) * view.through(seen);
      const float below = through * seen.down, above = through - below;
      add_to(seen.texel, above * (1 - seen.right), lacking);
      add_to(seen.texel + 1, above * seen.right, lacking);
      add_to(seen.texel + width_, below * (1 - seen.right), lacking);
      add_to(seen.texel + width_ + 1, below * seen.right, lacking);
    }
  }

  /// Returns the requested changes of a card's texels, row by row, and clears them.
  [[nodiscard]] std::vector<float> take(const AtlasPlace& place) {
    const std::vector<float> asked = spread(taken(place, asked_), place), seen = spread(taken(place, seen_), place);
    std::vector<float> change(asked.size());
    for (std::size_t i = 0; i < change.size(); ++i) change[i] = asked[i] / (seen[i] + kLittleSeen);
    return change;
  }

 private:
  void add_to(std::size_t texel, float through, float lacking) {
    asked_[texel] += through * lacking;
    seen_[texel] += through;
  }

  [[nodiscard]] std::vector<float> taken(const AtlasPlace& place, std::vector<float>& values) const {
    std::vector<float> out;
    out.reserve(std::size_t(place.width) * place.height);
    for (std::uint32_t y = place.y; y < place.y + place.height; ++y) {
      const auto row = values.begin() + std::ptrdiff_t(std::size_t(y) * width_ + place.x);
      out.insert(out.end(), row, row + place.width);
      std::fill_n(row, place.width, 0.0f);
    }
    return out;
  }

  /// Sums over the texels before and behind each, along the card.
  static std::vector<float> spread(const std::vector<float>& values, const AtlasPlace& place) {
    const std::size_t count = place.height, step = place.width;
    std::vector<float> sums(values.size(), 0);
    for (std::size_t y = 0; y < count; ++y) {
      const std::size_t first = y - std::min(y, kSpreadAlong), last = std::min(y + kSpreadAlong, count - 1);
      for (std::size_t k = first; k <= last; ++k) {
        for (std::size_t x = 0; x < step; ++x) sums[y * step + x] += values[k * step + x];
      }
    }
    return sums;
  }

  std::uint32_t width_;
  std::vector<float> asked_, seen_;  ///< The gaps between cards receive what their edges request beyond them.
};

/// Cards whose opacity changes, round by round.
class OpacityRounds {
 public:
  OpacityRounds(FitTarget& target, Cards& cards, const platform::Threads& threads)
      : target_(target),
        cards_(cards),
        threads_(threads),
        change_(cards.plan.width, cards.plan.height),
        views_(threads.count) {
    for (const CardStrip& strip : cards.strips) {
      first_triangle_.push_back(first_triangle_.back() + std::uint32_t(strip.triangles()));
      last_change_.emplace_back();
    }
  }

  /// Looks from a round's directions; returns the coverage error of cards, as a share of the strands' coverage.
  double look(int round) {
    const CardSurface surface = surface_of(cards_);
    constexpr std::size_t kViews = FitTarget::kViews;
    double error = 0, covered = 0;
    // As many views at once as there are threads. Texels add them up one after the other, so the number of threads
    // changes nothing.
    for (std::size_t first = 0; first < kViews; first += views_.size()) {
      const std::size_t count = std::min(views_.size(), kViews - first);
      parallel_for(count, threads_,
                   [&](std::size_t i) { look_along(FitTarget::view_of(round, first + i), surface, views_[i]); });
      parallel_for(cards_.strips.size(), threads_, [&](std::size_t card) {
        for (std::size_t i = 0; i < count; ++i) change_.add(views_[i], card);
      });
      for (std::size_t i = 0; i < count; ++i) {
        error += views_[i].error();
        covered += views_[i].covered();
      }
    }
    return covered > 0 ? error / covered : 0;
  }

  /// Applies the changes of the last look.
  void change() {
    parallel_for(cards_.strips.size(), threads_, [&](std::size_t card) {
      change_card(change_.take(cards_.plan.places[card]), last_change_[card], cards_.textures[card]);
    });
  }

 private:
  void look_along(std::size_t view, const CardSurface& surface, FitView& seen) {
    seen.look(surface, first_triangle_, target_.frame(view));
    seen.compare(target_.coverage(view));
  }

  /// A part of the last change is made again.
  static void change_card(const std::vector<float>& change, std::vector<float>& last, CardTexture& texture) {
    last.resize(change.size(), 0);
    for (std::uint32_t y = 0; y < texture.height; ++y) {
      for (std::uint32_t x = 0; x < texture.width; ++x) {
        const std::size_t i = std::size_t(y) * texture.width + x;
        const float wanted = kOnwards * last[i] + (change[i] > 0 ? rise(texture, x, y) * change[i] : change[i]);
        const float opacity = std::clamp(texture.opacity[i] + wanted, 0.0f, 1.0f);
        last[i] = opacity - texture.opacity[i];
        texture.opacity[i] = opacity;
      }
    }
  }

  /// Adds nothing at a card's sides and tip, whose straight edges would be visible.
  static float rise(const CardTexture& texture, std::uint32_t x, std::uint32_t y) {
    const float across = (float(x) + 0.5f) / float(texture.width), along = (float(y) + 0.5f) / float(texture.height);
    return std::min(std::min({across, 1 - across, 1 - along}) / kEdge, 1.0f);
  }

  FitTarget& target_;
  Cards& cards_;
  platform::Threads threads_;
  std::vector<std::uint32_t> first_triangle_{0};
  AtlasChange change_;
  std::vector<std::vector<float>> last_change_;  ///< For each card, its texels' last change.
  std::vector<FitView> views_;
};

std::vector<std::vector<float>> opacities_of(const Cards& cards) {
  std::vector<std::vector<float>> opacities;
  for (const CardTexture& texture : cards.textures) opacities.push_back(texture.opacity);
  return opacities;
}

}  // namespace

OpacityFit fit_opacity(FitTarget& target, int rounds, Cards& cards, const platform::Threads& threads) {
  OpacityFit fit;
  if (rounds <= 0) return fit;
  OpacityRounds fitting(target, cards, threads);
  std::vector<std::vector<float>> best;
  for (int round = 0; round <= rounds; ++round) {
    const double error = fitting.look(round), before = fit.errors.empty() ? error : fit.errors.back();
    fit.errors.push_back(error);
    if (round > 0 && error > before) {
      for (std::size_t i = 0; i < best.size(); ++i) cards.textures[i].opacity = std::move(best[i]);
      break;
    }
    if (round == rounds || (round > 0 && error > (1 - kLeastFall) * before)) break;
    best = opacities_of(cards);
    fitting.change();
  }
  return fit;
}

}  // namespace coif::cards
