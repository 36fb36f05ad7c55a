#include "report/cards/measure_cards.h"

#include "base/parallel_for.h"
#include "report/cards/asset_surface.h"
#include "report/cards/card_sheets.h"
#include "research/cards/baseline_cards.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <string_view>
#include <utility>

namespace coif::report {
namespace {

constexpr char kOwn[] = "none", kFlat[] = "kmeans", kEven[] = "even";

tl::expected<void, ToolError> check(const Asset& asset, const CardsSettings& settings) {
  const bool budgets_ok = !settings.budgets.empty() &&
                          std::ranges::all_of(settings.budgets, [](std::size_t budget) { return budget >= 2; });
  if (!budgets_ok || settings.directions == 0 || settings.size < kLeastCardsPicture ||
      settings.size > kMostCardsPicture) {
    return failure(
        ToolError::Kind::kUsage,
        fmt::format("cards are compared with 2 triangles at least, from a direction at least, in pictures of "
                    "{} to {} pixels each way",
                    kLeastCardsPicture, kMostCardsPicture));
  }
  if (!asset.is_open() || asset.vertices().empty() || asset.indices().empty()) {
    return failure(ToolError::Kind::kBadInput,
                   "the asset has no mesh to compare with strands; cook it again without leaving the mesh out");
  }
  return {};
}

// Close-ups show what a texture has, far pictures what its mips have. A close-up has a sample per pixel, as a graphics
// card takes, and so costs as much as a far picture.
constexpr std::uint32_t kCloser = 4;        // pixels of a close-up, each way, in one of a far picture
constexpr std::size_t kCloseUpOfViews = 4;  // a close-up in each such direction

/// Each n-th direction, from the first on.
std::vector<Eigen::Vector3f> directions_of_close_ups(const std::vector<Eigen::Vector3f>& all) {
  std::vector<Eigen::Vector3f> directions;
  for (std::size_t i = 0; i < all.size(); i += kCloseUpOfViews) directions.push_back(all[i]);
  return directions;
}

/// Cards, the time that they took, and the groom's part that they were made of.
struct MadeCards {
  cards::Cards cards;
  double seconds = 0;
  std::optional<double> segments = {};
};

class CardsMeasurement {
 public:
  CardsMeasurement(const Asset& asset, const groom::Groom& groom, const CookedPlace& place,
                   const CardsSettings& settings, const ReportProgress& progress)
      : asset_(asset),
        groom_(groom),
        place_(place),
        settings_(settings),
        progress_(progress),
        shape_(cards::shape_of(groom, settings.strand_width)),
        directions_(cards::spread_directions(settings.directions)) {
    progress_("strands");
    views_.emplace(groom, shape_.strands.width, frames_around(groom, place.turn, directions_, settings.size), kThreads);
    close_ups_.emplace(groom, shape_.strands.width,
                       frames_around(groom, place.turn, directions_of_close_ups(directions_), kCloser * settings.size),
                       kThreads, 1);
    if (settings.sheets) {
      const bool faces_backwards = (asset.skeleton().flags & kSkeletonFacesBackwards) != 0;
      sheets_.emplace(groom, shape_.strands.width, place.turn, faces_backwards, kThreads);
    }
  }

  tl::expected<CardsReport, ToolError> run() {
    describe_strands();
    for (const std::size_t triangles : settings_.budgets) {
      const cards::CardsBudget budget = budget_of(triangles);
      for (const char* const baseline : {kOwn, kFlat, kEven}) measure(baseline, budget);
    }
    if (report_.summary.empty()) return tl::unexpected(*refusal_);
    for (std::uint32_t lod = 0; lod < asset_.lod_count(); ++lod) measure_level(lod);
    if (sheets_) report_.sheets = sheets_->finish();
    return std::move(report_);
  }

 private:
  using Made = tl::expected<MadeCards, ToolError>;
  static inline const unsigned kThreads = platform::all_threads();

  [[nodiscard]] cards::CardsBudget budget_of(std::size_t triangles) const {
    cards::CardsBudget budget{triangles, settings_.texels, settings_.rounds, settings_.strand_width, settings_.caps};
    budget.wisps = settings_.wisps;
    return budget;
  }

  [[nodiscard]] static cards::CardSurface drawn_surface_of(const cards::Cards& cards) {
    cards::CardSurface surface = cards::surface_of(cards);
    cards::draw_as_cooked(surface);
    return surface;
  }

  /// Makes one set of cards. The time is that of making it, as by a cook.
  [[nodiscard]] Made make(std::string_view baseline, const cards::CardsBudget& budget) const {
    const auto segments = baseline != kEven ? 0
                          : budget.plan     ? std::size_t(budget.plan->quads)
                                            : research::even_segments(groom_, shape_, budget, kThreads);
    const auto begin = std::chrono::steady_clock::now();
    auto cards = baseline == kFlat   ? research::make_flat_cards(groom_, shape_, budget, kThreads)
                 : baseline == kEven ? research::make_even_cards(groom_, shape_, budget, segments, kThreads)
                                     : cards::make_cards(groom_, shape_, budget, kThreads);
    if (!cards) return tl::unexpected(cards.error());
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    MadeCards made{std::move(*cards), taken.count()};
    if (baseline == kEven) made.segments = double(segments);
    return made;
  }

  /// The same construction without the fit of opacity, without cards on the scalp, without shared textures where there
  /// are any, and without several of these.
  void ablate(const char* baseline, cards::CardsBudget budget, bool shares) {
    const auto wisps = budget.wisps;
    for (const bool is_shared : {true, false}) {
      if (!is_shared && !shares) continue;
      budget.wisps = is_shared ? wisps : std::size_t{0};
      for (const bool is_fitted : {true, false}) {
        for (const bool has_caps : {true, false}) {
          budget.rounds = is_fitted ? settings_.rounds : 0;
          budget.caps = has_caps ? settings_.caps : 0;
          ablate_one({.baseline = baseline, .fitted = is_fitted, .caps = has_caps, .shared = shares && is_shared},
                     budget);
        }
      }
    }
  }

  void ablate_one(CardsAblation row, const cards::CardsBudget& budget) {
    progress_(fmt::format("{} triangles, {}, ablation", budget.triangles, cards_name(row.baseline)));
    const Made made = make(row.baseline, budget);
    if (!made) return;
    const cards::CardSurface surface = drawn_surface_of(made->cards);
    row.triangles = budget.triangles;
    row.cards = made->cards.strips.size();
    row.figures = figures_of(surface, views_->compare(surface));
    row.seconds = made->seconds;
    report_.ablation.push_back(std::move(row));
  }

  void describe_strands() {
    report_.source = groom_.path;
    report_.strands = groom_.strand_count();
    report_.strand_width = double(shape_.strands.width);
    report_.size = settings_.size;
    report_.close_size = kCloser * settings_.size;
    report_.directions = settings_.directions;
    report_.asset_factor = place_.factor;
  }

  void measure(const char* baseline, const cards::CardsBudget& budget) {
    progress_(fmt::format("{} triangles, {}", budget.triangles, cards_name(baseline)));
    const Made made = make(baseline, budget);
    if (!made) {
      report_.left_out.push_back({baseline, budget.triangles, made.error().message});
      if (!refusal_) refusal_ = made.error();
      return;
    }
    const cards::CardSurface surface = drawn_surface_of(made->cards);
    CardsSummary summary{.baseline = baseline, .triangles = budget.triangles, .texels = budget.texels};
    summary.cards = made->cards.strips.size();
    summary.textures = made->cards.textures.size();
    summary.made_triangles = surface.triangles.size() / 3;
    summary.made_texels = std::uint64_t{surface.width} * surface.height;
    summary.segments = made->segments;
    summary.seconds = made->seconds;
    const std::vector<cards::HairLikeness> likeness = views_->compare(surface);
    summary.figures = figures_of(surface, likeness);
    for (std::size_t i = 0; i < likeness.size(); ++i) {
      const Eigen::Vector3d direction = directions_[i].cast<double>();
      report_.rows.push_back({baseline,
                              budget.triangles,
                              budget.texels,
                              {direction.x(), direction.y(), direction.z()},
                              likeness[i].coverage_iou,
                              cards::psnr_db(likeness[i].error)});
    }
    const bool shares = summary.textures < summary.cards;
    report_.summary.push_back(std::move(summary));
    if (settings_.ablation) {
      cards::CardsBudget same = budget;
      same.plan = made->cards.made_by;
      ablate(baseline, same, shares);
    }
    if (sheets_ && std::string_view(baseline) == kOwn)
      sheets_->add(fmt::format("{} triangles", budget.triangles), surface);
  }

  void measure_level(std::uint32_t lod) {
    progress_(fmt::format("the asset's level {}", lod));
    const cards::CardSurface surface = surface_of_asset(asset_, lod, place_);
    report_.asset.push_back({lod, surface.triangles.size() / 3, std::uint64_t{surface.width} * surface.height,
                             figures_of(surface, views_->compare(surface))});
    if (sheets_ && lod == 0)
      sheets_->add(fmt::format("the asset, {} triangles", surface.triangles.size() / 3), surface);
  }

  [[nodiscard]] CardsFigures figures_of(const cards::CardSurface& surface,
                                        const std::vector<cards::HairLikeness>& likeness) const {
    CardsFigures figures;
    figures.worst_iou = 1;
    figures.worst_psnr_db = cards::psnr_db(0);
    const auto count = double(likeness.size());
    for (const cards::HairLikeness& one : likeness) {
      const double psnr = cards::psnr_db(one.error);
      figures.mean_iou += one.coverage_iou / count;
      figures.worst_iou = std::min(figures.worst_iou, one.coverage_iou);
      figures.mean_psnr_db += psnr / count;
      figures.worst_psnr_db = std::min(figures.worst_psnr_db, psnr);
      figures.mean_error += one.error / count;
    }
    for (const cards::HairLikeness& one : close_ups_->compare(surface)) {
      figures.close_iou += one.coverage_iou / double(close_ups_->count());
      figures.close_error += one.error / double(close_ups_->count());
    }
    figures.vertices = surface.positions.size();
    const cards::SurfaceCost cost = views_->cost(surface);
    figures.fragments = cost.fragments;
    figures.layers = cost.layers;
    return figures;
  }

  const Asset& asset_;
  const groom::Groom& groom_;
  const CookedPlace& place_;
  const CardsSettings& settings_;
  const ReportProgress& progress_;
  cards::GroomShape shape_;
  std::vector<Eigen::Vector3f> directions_;
  std::optional<GroomViews> views_, close_ups_;
  std::optional<CardSheets> sheets_;
  std::optional<ToolError> refusal_;  ///< The first set of cards that could not be made.
  CardsReport report_;
};

}  // namespace

tl::expected<CardsReport, ToolError> measure_cards(const Asset& asset, const groom::Groom& groom,
                                                   std::uint64_t groom_hash, const CardsSettings& settings,
                                                   const ReportProgress& progress) {
  if (const auto checked = check(asset, settings); !checked) return tl::unexpected(checked.error());
  const auto place = find_cooked_place(asset, groom);
  if (!place) return tl::unexpected(place.error());
  auto report = CardsMeasurement(asset, groom, *place, settings, progress).run();
  if (!report) return report;
  const ProvenanceRecord* const provenance = asset.provenance();
  report->is_its_source = provenance != nullptr && provenance->source_hash == groom_hash;
  return report;
}

}  // namespace coif::report
