#include "view/page/asset_motion.h"

#include "base/geometry.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace coif::view {
namespace {

constexpr double kSameResistance = 1.0e-5,
                 /// Tolerance of shares that went through floats once or twice.
    kSameDamping = 1.0e-3;
constexpr float kWorldsAir = 0.99f;

double mean_of(std::size_t count, const auto& value) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += value(i);
  return sum / double(count);
}

}  // namespace

AssetMotion::AssetMotion(const Asset& asset) {
  if (asset.dynamics().empty() || asset.skeleton().simulated_count == 0) return;
  records_.assign(asset.dynamics().begin(), asset.dynamics().end());
  air_lag_ = asset.skeleton().air_lag;
  rig_ = lab::as_asked(lab::rig_of(asset));
  carried_ = lab::carried_at_rest(rig_.bones);
  bone_records_.assign(asset.bones().begin() + rig_.rigid_count, asset.bones().end());
  bones_.resize(rig_.bones.size());
  find_places(asset);
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    Bone& bone = bones_[i];
    bone.own = records_[rig_.rigid_count + i];
    bone.own.friction = float(rig_.bones[i].friction);
    bone.own.damping = float(rig_.bones[i].damping);
    bone.own.parent_share = float(rig_.bones[i].parent_share);
    bone.leans = bone.own.lean[0] != 0 || bone.own.lean[1] != 0;
    find_preset(i);
    find_ratios(i);
  }
  find_means();
}

void AssetMotion::find_places(const Asset& asset) {
  std::vector<double> ends(bones_.size()), farthest(asset.chains().size(), 0.0);
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    const lab::RigBone& bone = rig_.bones[i];
    const double start = bone.parent < 0 ? 0 : ends[std::size_t(bone.parent)];
    ends[i] = start + bone.length;
    bones_[i].place = 0.5 * (start + ends[i]);
    double& chain = farthest[bone_records_[i].chain];
    chain = std::max(chain, ends[i]);
  }
  for (std::size_t i = 0; i < bones_.size(); ++i) bones_[i].place /= farthest[bone_records_[i].chain];
}

/// Recognises a preset by the resistance that goes with the stiffness of its bending length, which nothing else gives.
/// Between two presets of one bending length, the one with the nearer friction (of loose or tied hair) is taken.
void AssetMotion::find_preset(std::size_t i) {
  Bone& bone = bones_[i];
  double nearest = 0;
  for (const cook::HairPreset& preset : cook::hair_presets()) {
    DynamicsRecord record = bone.own;
    cook::bake_natural(rig_, carried_, i, {preset.bending_length, preset.damping_ratio}, record);
    const double wanted = record.resistance;
    if (std::abs(double(bone.own.resistance) - wanted) > kSameResistance * wanted) continue;
    for (const bool is_tied : {false, true}) {
      const double gap = std::abs(cook::friction_of(preset, is_tied) - double(bone.own.friction));
      if (bone.preset != nullptr && gap >= nearest) continue;
      bone.preset = &preset;
      bone.is_tied = is_tied;
      nearest = gap;
    }
  }
}

/// Before it was made stiffer, and its damping with it, to carry its shape.
void AssetMotion::find_ratios(std::size_t i) {
  Bone& bone = bones_[i];
  const double length = rig_.bones[i].length;
  DynamicsRecord plain = bone.own;
  if (bone.preset != nullptr)
    cook::bake_natural(rig_, carried_, i, {bone.preset->bending_length, bone.preset->damping_ratio, bone.is_tied},
                       plain);
  else
    cook::bake_oscillator(std::nullopt, length, plain);
  const double stiffer = double(bone.own.stiffness) / std::max(double(plain.stiffness), 1.0e-9);
  const double damping = double(bone.own.damping) / (stiffer > 1 + kSameResistance ? std::sqrt(stiffer) : 1);
  bone.curve_ratio = (damping + double(bone.own.friction)) / (2 * cook::natural_rate(plain, length));
  bone.shown_ratio = bone.curve_ratio;
  if (bone.preset != nullptr)
    bone.shown_ratio = damping / (2 * cook::swing_rate(rig_, carried_, i, double(plain.stiffness)));
  const bool is_plain = std::abs(damping - double(plain.damping)) <= kSameDamping * double(plain.damping);
  if (!is_plain) bone.said_ratio = bone.shown_ratio;
}

void AssetMotion::find_means() {
  const std::size_t count = bones_.size();
  mean_.liveliness = std::clamp(1 - mean_of(count, [&](std::size_t i) { return bones_[i].shown_ratio; }), 0.0, 1.0);
  mean_.friction = mean_of(count, [&](std::size_t i) { return bones_[i].own.friction; });
  mean_.gravity_scale = mean_of(count, [&](std::size_t i) { return bones_[i].own.gravity_scale; });
  mean_.angle_limit = mean_of(count, [&](std::size_t i) { return double(bones_[i].own.angle_limit) / kDegree; });
  mean_.air_follow = 1 - double(air_lag_);
  const auto same = [&](const Bone& bone) { return bone.preset == bones_[0].preset; };
  if (std::all_of(bones_.begin(), bones_.end(), same)) preset_ = bones_[0].preset;
  const auto is_of_springs = [](const Bone& bone) { return bone.preset == nullptr && !bone.leans; };
  has_springs_ = air_lag_ > kWorldsAir && std::all_of(bones_.begin(), bones_.end(), is_of_springs);
}

/// A file's springs have frictions and weights of their own, which recipes change by taking their place.
bool AssetMotion::goes_by_curve(const MotionTuning& tuning) const {
  return !tuning.resistance.empty() || (has_springs_ && (tuning.friction || tuning.gravity_scale));
}

bool AssetMotion::says_ratio() const {
  const auto says = [](const Bone& bone) { return bone.said_ratio || bone.preset != nullptr; };
  return std::any_of(bones_.begin(), bones_.end(), says);
}

void AssetMotion::bake(std::size_t i, const MotionTuning& tuning, lab::Rig& rig, DynamicsRecord& record) const {
  const Bone& bone = bones_[i];
  record = bone.own;
  if (tuning.friction) record.friction = float(*tuning.friction);
  if (tuning.gravity_scale) record.gravity_scale = float(*tuning.gravity_scale);
  if (tuning.angle_limit) record.angle_limit = std::min(float(*tuning.angle_limit * kDegree), kNoAngleLimit);
  rig.bones[i].gravity_scale = record.gravity_scale;
  std::optional<double> ratio = bone.said_ratio;
  if (tuning.liveliness) ratio = 1 - *tuning.liveliness;
  if (!tuning.damping_ratio.empty()) ratio = cook::evaluate_curve(tuning.damping_ratio, bone.place);
  const bool by_curve = !tuning.resistance.empty();
  if (by_curve) record.resistance = float(cook::evaluate_curve(tuning.resistance, bone.place));
  if (by_curve || bone.preset == nullptr) return cook::bake_oscillator(ratio, rig.bones[i].length, record);
  const cook::HairPreset& preset = tuning.preset != nullptr ? *tuning.preset : *bone.preset;
  const bool has_presets_friction = record.friction == float(cook::friction_of(*bone.preset, bone.is_tied));
  if (!tuning.friction && has_presets_friction) record.friction = float(cook::friction_of(preset, bone.is_tied));
  const bool is_tied = bone.is_tied && !ratio;
  cook::bake_natural(rig, carried_, i, {preset.bending_length, ratio.value_or(preset.damping_ratio), is_tied}, record);
}

/// Adds what the cook added; otherwise the chain's motion might not be well-defined.
void AssetMotion::add_conditioning(std::size_t i, DynamicsRecord& record) const {
  const DynamicsRecord &given = records_[rig_.rigid_count + i], &asked = bones_[i].own;
  record.friction += std::max(given.friction - asked.friction, 0.0f);
  record.damping += std::max(given.damping - asked.damping, 0.0f);
  record.parent_share = std::min(record.parent_share, given.parent_share);
}

std::vector<DynamicsRecord> AssetMotion::tuned(const MotionTuning& said) const {
  std::vector<DynamicsRecord> all = records_;
  if (said == MotionTuning{} || is_empty()) return all;
  const MotionTuning tuning = completed(said);
  const bool any_leans = std::any_of(bones_.begin(), bones_.end(), [](const Bone& bone) { return bone.leans; });
  const bool all_lean = any_leans && !tuning.resistance.empty();
  const auto records = std::span(all).subspan(rig_.rigid_count);
  lab::Rig rig = rig_;
  std::vector<bool> leans;
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    bake(i, tuning, rig, records[i]);
    leans.push_back(all_lean || bones_[i].leans);
  }
  cook::lean_against_weight(rig, bone_records_, leans, records);
  for (std::size_t i = 0; i < bones_.size(); ++i) add_conditioning(i, records[i]);
  return all;
}

float AssetMotion::air_lag(const MotionTuning& tuning) const {
  return tuning.air_follow ? float(1 - *tuning.air_follow) : air_lag_;
}

}  // namespace coif::view
