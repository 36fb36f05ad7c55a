#include "view/page/tunable_motion.h"

#include <algorithm>
#include <span>
#include <utility>

namespace coif::view {
namespace {

/// The caller's own memory, which an open asset only shows.
template <typename Record>
std::span<Record> writable(std::span<const Record> records) {
  return {const_cast<Record*>(records.data()), records.size()};
}

}  // namespace

TunableMotion::TunableMotion(AssetMotion motion, const ViewSettings& settings)
    : motion_(std::move(motion)), first_motion_(motion_), cooked_{settings, {}}, first_(cooked_) {}

MotionTuning TunableMotion::Base::to(const ViewSettings& now, const MotionTuning& drawn) const {
  MotionTuning tuning = tuning_between(settings, now);
  if (drawn.resistance != curves.resistance) tuning.resistance = drawn.resistance;
  if (drawn.damping_ratio != curves.damping_ratio) tuning.damping_ratio = drawn.damping_ratio;
  return tuning;
}

void TunableMotion::go_on(const TunableMotion& before) {
  first_motion_ = before.first_motion_;
  first_ = before.first_;
  curves_ = before.curves_;
}

void TunableMotion::accept(const ViewSettings& settings, bool recipe_says_it) {
  if (recipe_says_it) {
    cooked_ = {settings, curves_};
  } else {
    first_motion_ = motion_;
    first_ = cooked_;
  }
}

bool TunableMotion::is_applied(const ViewSettings& settings) const {
  return motion_.is_empty() || cooked_.to(settings, curves_) == written_;
}

void TunableMotion::apply(const ViewSettings& settings, const Asset& asset) {
  if (is_applied(settings)) return;
  const MotionTuning tuning = cooked_.to(settings, curves_);
  const std::vector<DynamicsRecord> records = motion_.tuned(tuning);
  std::copy(records.begin(), records.end(), writable(asset.dynamics()).begin());
  const auto asked = writable(asset.asked());
  for (std::size_t b = 0; b < asked.size() && tuning.friction; ++b) asked[b].friction = float(*tuning.friction);
  const_cast<SkeletonRecord&>(asset.skeleton()).air_lag = motion_.air_lag(tuning);
  written_ = tuning;
}

std::string TunableMotion::recipe(const ViewSettings& settings) const {
  return first_motion_.recipe(first_.to(settings, curves_));
}

}  // namespace coif::view
