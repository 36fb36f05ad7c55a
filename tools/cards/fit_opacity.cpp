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
constexpr std::size_t kSpreadAlong = 4;  // texels, at least
// Shared textures with more texels than these have texels that are smaller than the pictures' samples.
constexpr std::uint32_t kSeenAcross = 30, kSeenAlong = 120;
constexpr float kEdge = 0.12f;  // Share of a card's width and length.

/// Texels of a texture before and behind each in a row, and in a column.
struct Reach {
  std::size_t across = 0, along = 0;
};

/// The cards that show each texture.
std::vector<std::vector<std::size_t>> cards_by_texture(const Cards& cards) {
  std::vector<std::vector<std::size_t>> shown(cards.textures.size());
  for (std::size_t card = 0; card < cards.strips.size(); ++card) shown[cards.shares.texture_of[card]].push_back(card);
  return shown;
}

/// What one sample of a picture sees at once of a texture: of one that many cards share, several texels. Others are
/// about as fine as pictures.
std::vector<Reach> seen_at_once(const AtlasPlan& plan, std::span<const std::vector<std::size_t>> cards_showing) {
  std::vector<Reach> reach(cards_showing.size());
  for (std::size_t i = 0; i < reach.size(); ++i) {
    const AtlasPlace& place = plan.places[i];
    if (cards_showing[i].size() > 1) reach[i] = {place.width / kSeenAcross, place.height / kSeenAlong};
  }
  return reach;
}

/// Where what is asked of a texel is done: along the card, where its strands lie.
Reach spread_of(const Reach& seen) { return {seen.across, kSpreadAlong * std::max<std::size_t>(seen.along, 1)}; }

/// Replaces each value of a line of `count` by the sum from `reach` before it to as many behind it.
void sum_line(std::span<float> values, std::size_t step, std::size_t count, std::size_t reach) {
  std::vector<double> before(count + 1, 0);
  for (std::size_t i = 0; i < count; ++i) before[i + 1] = before[i] + double(values[i * step]);
  for (std::size_t i = 0; i < count; ++i)
    values[i * step] = float(before[std::min(i + reach + 1, count)] - before[i - std::min(i, reach)]);
}

/// Sums over the texels around each of a texture's, row by row.
std::vector<float> sums_around(std::vector<float> values, std::size_t width, const Reach& reach) {
  const std::size_t height = values.size() / width;
  for (std::size_t y = 0; reach.across > 0 && y < height; ++y)
    sum_line(std::span(values).subspan(y * width), 1, width, reach.across);
  for (std::size_t x = 0; reach.along > 0 && x < width; ++x)
    sum_line(std::span(values).subspan(x), width, height, reach.along);
  return values;
}

/// Gives a surface the opacity that samples of a picture see: means, where these see several texels at once.
void blur_fine_textures(const Cards& cards, std::span<const Reach> seen, CardSurface& surface) {
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].across == 0 && seen[i].along == 0) continue;
    const AtlasPlace& place = cards.plan.places[i];
    const std::vector<float> sums = sums_around(cards.textures[i].opacity, place.width, seen[i]),
                             counts = sums_around(std::vector<float>(sums.size(), 1), place.width, seen[i]);
    for (std::size_t k = 0; k < sums.size(); ++k) {
      surface.opacity[(place.y + k / place.width) * surface.width + place.x + k % place.width] = sums[k] / counts[k];
    }
  }
}

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

  /// Forgets what was requested.
  void clear() {
    std::ranges::fill(asked_, 0.0f);
    std::ranges::fill(seen_, 0.0f);
  }

  /// Returns the requested changes of a texture's texels, summed over what is around each, and clears them.
  [[nodiscard]] std::vector<float> take(const AtlasPlace& place, const Reach& spread) {
    const std::vector<float> asked = sums_around(taken(place, asked_), place.width, spread),
                             seen = sums_around(taken(place, seen_), place.width, spread);
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
        cards_showing_(cards_by_texture(cards)),
        seen_(seen_at_once(cards.plan, cards_showing_)),
        change_(cards.plan.width, cards.plan.height),
        last_change_(cards.textures.size()),
        views_(threads.count) {
    for (const CardStrip& strip : cards.strips) {
      first_triangle_.push_back(first_triangle_.back() + std::uint32_t(strip.triangles()));
    }
  }

  /// Looks from a round's directions; returns the coverage error of cards, as a share of the strands' coverage.
  double look(int round) {
    CardSurface surface = surface_of(cards_);
    blur_fine_textures(cards_, seen_, surface);
    constexpr std::size_t kViews = FitTarget::kViews;
    double error = 0, covered = 0;
    // As many views at once as there are threads. Texels add them up one after the other, so the number of threads
    // changes nothing.
    for (std::size_t first = 0; first < kViews; first += views_.size()) {
      const std::size_t count = std::min(views_.size(), kViews - first);
      parallel_for(count, threads_,
                   [&](std::size_t i) { look_along(FitTarget::view_of(round, first + i), surface, views_[i]); });
      parallel_for(cards_.textures.size(), threads_, [&](std::size_t texture) {
        for (const std::size_t card : cards_showing_[texture]) {
          for (std::size_t i = 0; i < count; ++i) change_.add(views_[i], card);
        }
      });
      for (std::size_t i = 0; i < count; ++i) {
        error += views_[i].error();
        covered += views_[i].covered();
      }
    }
    return covered > 0 ? error / covered : 0;
  }

  /// Takes back half of the changes since these opacities, and changes half as much from now on.
  void step_back(const std::vector<std::vector<float>>& before) {
    step_ *= 0.5f;
    change_.clear();
    parallel_for(cards_.textures.size(), threads_, [&](std::size_t texture) {
      std::vector<float>& opacity = cards_.textures[texture].opacity;
      for (std::size_t i = 0; i < opacity.size(); ++i) opacity[i] = 0.5f * (opacity[i] + before[texture][i]);
      last_change_[texture].clear();
    });
  }

  /// Applies the changes of the last look.
  void change() {
    parallel_for(cards_.textures.size(), threads_, [&](std::size_t texture) {
      change_texture(change_.take(cards_.plan.places[texture], spread_of(seen_[texture])), last_change_[texture],
                     cards_.textures[texture]);
    });
  }

 private:
  void look_along(std::size_t view, const CardSurface& surface, FitView& seen) {
    seen.look(surface, first_triangle_, target_.frame(view));
    seen.compare(target_.coverage(view));
  }

  /// A part of the last change is made again.
  void change_texture(const std::vector<float>& change, std::vector<float>& last, CardTexture& texture) const {
    last.resize(change.size(), 0);
    for (std::uint32_t y = 0; y < texture.height; ++y) {
      for (std::uint32_t x = 0; x < texture.width; ++x) {
        const std::size_t i = std::size_t(y) * texture.width + x;
        const float asked = change[i] > 0 ? rise(texture, x, y) * change[i] : change[i];
        const float wanted = kOnwards * last[i] + step_ * asked;
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
  std::vector<std::vector<std::size_t>> cards_showing_;  ///< Each texture.
  std::vector<Reach> seen_;                              ///< What a sample sees at once, of each texture.
  AtlasChange change_;
  std::vector<std::vector<float>> last_change_;  ///< For each texture, its texels' last change.
  std::vector<FitView> views_;
  float step_ = 1;  ///< Share of what is asked that is done.
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
  std::vector<std::vector<float>> best = opacities_of(cards);
  fit.errors.push_back(fitting.look(0));
  bool goes_on = true;
  for (int round = 1; round <= rounds && goes_on; ++round) {
    fitting.change();
    const double error = fitting.look(round);
    if (error > fit.errors.back()) {
      fitting.step_back(best);
      continue;
    }
    goes_on = error <= (1 - kLeastFall) * fit.errors.back();
    fit.errors.push_back(error);
    best = opacities_of(cards);
  }
  for (std::size_t i = 0; i < best.size(); ++i) cards.textures[i].opacity = std::move(best[i]);
  return fit;
}

}  // namespace coif::cards
