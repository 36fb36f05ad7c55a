// What open() demands of how bones move and of how the asset was tuned.

#include "models/small_asset.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace coif::open_motion_test {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A field and the values it may have; both ends belong to them.
template <typename Record>
struct Limits {
  const char* name;
  float Record::*field;
  float lowest;
  float highest;
};

/// Sets one field of small_asset() after the other, in the record that `record_of` finds.
template <typename Record, std::size_t kCount, typename RecordOf>
void expect_limits(const Limits<Record> (&table)[kCount], const RecordOf& record_of) {
  for (const Limits<Record>& limits : table) {
    const auto with = [&](float value) {
      return refusal([&](AssetContents& a) { record_of(a).*limits.field = value; });
    };
    EXPECT_EQ(with(limits.lowest), LoadCode::kOk) << limits.name;
    EXPECT_EQ(with(limits.highest), LoadCode::kOk) << limits.name;
    EXPECT_EQ(with(std::nextafter(limits.lowest, -kInfinity)), LoadCode::kNotFinite) << limits.name;
    EXPECT_EQ(with(std::nextafter(limits.highest, kInfinity)), LoadCode::kNotFinite) << limits.name;
    for (const float value : {std::nanf(""), kInfinity, -kInfinity}) {
      EXPECT_EQ(with(value), LoadCode::kNotFinite) << limits.name << " = " << value;
    }
  }
}

TEST(OpenDynamics, EveryFieldHasItsLimits) {
  using D = DynamicsRecord;
  constexpr Limits<D> kLimits[] = {{"resistance", &D::resistance, 0, 1},
                                   {"friction", &D::friction, 0, 1.0e6f},
                                   {"gravity_scale", &D::gravity_scale, -1.0e3f, 1.0e3f},
                                   {"authoring_rate", &D::authoring_rate, 1, 1.0e5f},
                                   {"hit_radius", &D::hit_radius, 0, 1.0e5f},
                                   {"stiffness", &D::stiffness, 0, 1.0e12f},
                                   {"damping", &D::damping, 0, 1.0e6f},
                                   {"torsion", &D::torsion, 0, 1.0e6f},
                                   {"angle_limit", &D::angle_limit, 0, kNoAngleLimit},
                                   {"parent_share", &D::parent_share, 0, 1}};
  for (const std::size_t bone : {0u, 2u, 4u}) {
    expect_limits(kLimits, [bone](AssetContents& a) -> D& { return a.dynamics[bone]; });
  }
}

TEST(OpenDynamics, EveryBoneHasARecordThatLeansNoFurtherThanItsLength) {
  EXPECT_EQ(refusal([](auto& a) { a.dynamics.clear(); }), LoadCode::kChunkMissing);
  EXPECT_EQ(refusal([](auto& a) { a.dynamics.pop_back(); }), LoadCode::kChunkSize);
  EXPECT_EQ(refusal([](auto& a) { a.dynamics[2].lean[0] = -1.0f; }), LoadCode::kOk);
  EXPECT_EQ(refusal([](auto& a) { a.dynamics[2].lean[0] = a.dynamics[2].lean[1] = 0.71f; }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.dynamics[2].lean[1] = std::nanf(""); }), LoadCode::kNotFinite);
}

TEST(OpenAsked, EveryFieldHasItsLimitsAndEveryBoneARecord) {
  using A = AskedRecord;
  constexpr Limits<A> kLimits[] = {{"friction", &A::friction, 0, 1.0e6f},
                                   {"damping", &A::damping, 0, 1.0e6f},
                                   {"parent_share", &A::parent_share, 0, 1}};
  for (const std::size_t bone : {0u, 4u}) {
    expect_limits(kLimits, [bone](AssetContents& a) -> AskedRecord& { return a.asked[bone]; });
  }
  EXPECT_EQ(refusal([](auto& a) { a.asked.clear(); }), LoadCode::kOk);
  EXPECT_EQ(refusal([](auto& a) { a.asked.pop_back(); }), LoadCode::kChunkSize);
}

TEST(OpenTuning, GivesBackWhatWasWritten) {
  const AssetContents contents = small_asset();
  AlignedBytes file(write_asset(contents));
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  ASSERT_NE(asset.tuning(), nullptr);
  EXPECT_EQ(std::memcmp(asset.tuning(), contents.tuning.data(), sizeof(TuningRecord)), 0);
  ASSERT_EQ(asset.quality().size(), contents.quality.size());
  EXPECT_EQ(std::memcmp(asset.quality().data(), contents.quality.data(), asset.quality().size_bytes()), 0);
}

TEST(OpenTuning, IsOptional) {
  AssetContents contents = small_asset();
  contents.tuning.clear();
  contents.quality.clear();
  AlignedBytes file(write_asset(contents));
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  EXPECT_EQ(asset.tuning(), nullptr);
  EXPECT_TRUE(asset.quality().empty());
  EXPECT_EQ(refusal([](auto& a) { a.tuning.clear(); }), LoadCode::kOk) << "quality alone";
  EXPECT_EQ(refusal([](auto& a) { a.quality.clear(); }), LoadCode::kOk) << "tuning alone";
}

TEST(OpenTuning, IsOneRecord) {
  EXPECT_EQ(refusal([](auto& a) { a.tuning.push_back(a.tuning[0]); }), LoadCode::kChunkSize);
}

TEST(OpenTuning, EveryFieldHasItsLimits) {
  using T = TuningRecord;
  const T good = small_asset().tuning[0];
  const Limits<T> limits[] = {{"substep_rate", &T::substep_rate, 0, 1.0e5f},
                              {"asked_error", &T::asked_error, 0, 1.0e3f},
                              {"reached_error", &T::reached_error, 0, 1.0e3f},
                              {"asked_cost", &T::asked_cost, 0, 1.0e12f},
                              {"cost", &T::cost, 0, 1.0e12f},
                              {"slowest_rate", &T::slowest_rate, 1, good.fastest_rate},
                              {"fastest_rate", &T::fastest_rate, good.slowest_rate, 1.0e5f}};
  expect_limits(limits, [](AssetContents& a) -> T& { return a.tuning[0]; });
  EXPECT_EQ(refusal([](auto& a) { a.tuning[0].met = 0; }), LoadCode::kOk);
  EXPECT_EQ(refusal([](auto& a) { a.tuning[0].met = 2; }), LoadCode::kNotFinite);
}

TEST(OpenTuning, EveryFieldOfQualityHasItsLimits) {
  using Q = QualityRecord;
  constexpr Limits<Q> kLimits[] = {{"frame_rate", &Q::frame_rate, 1, 1.0e5f},   {"rms_error", &Q::rms_error, 0, 1.0e3f},
                                   {"max_error", &Q::max_error, 0, 1.0e3f},     {"stretch", &Q::stretch, 0, 1.0e3f},
                                   {"penetration", &Q::penetration, 0, 1.0e3f}, {"cost", &Q::cost, 0, 1.0e12f}};
  for (const std::size_t row : {0u, 1u}) {
    expect_limits(kLimits, [row](AssetContents& a) -> Q& { return a.quality[row]; });
  }
  const auto with_substeps = [](std::uint32_t n) { return refusal([n](auto& a) { a.quality[1].substeps = n; }); };
  EXPECT_EQ(with_substeps(0), LoadCode::kNotFinite);
  EXPECT_EQ(with_substeps(1024), LoadCode::kOk);
  EXPECT_EQ(with_substeps(1025), LoadCode::kNotFinite);
}

TEST(OpenTuning, AWorstMotionIsOneOfTheAssetsOwn) {
  const auto with_motion = [](std::uint32_t n) { return refusal([n](auto& a) { a.quality[1].worst_motion = n; }); };
  EXPECT_EQ(with_motion(6), LoadCode::kOk);
  EXPECT_EQ(with_motion(7), LoadCode::kReference) << "it has seven";
  const auto with_another = [](std::uint32_t n) {
    return refusal([n](auto& a) {
      a.motion_names.push_back({"a new one"});
      a.quality[1].worst_motion = n;
    });
  };
  EXPECT_EQ(with_another(7), LoadCode::kOk) << "the format has no list of its own";
  EXPECT_EQ(with_another(8), LoadCode::kReference);
}

TEST(OpenTuning, AssetsFromBeforeMotionsHadNamesOpen) {
  for (const std::uint32_t number : {0u, 9u, 10u, 0xFFFFFFFFu}) {
    EXPECT_EQ(refusal([number](AssetContents& a) {
                a.motion_names.clear();
                a.quality[1].worst_motion = number;
              }),
              LoadCode::kOk);
  }
}

TEST(OpenTuning, NamesOfMotionsEndWithinTheirRecord) {
  const auto with_byte = [](std::size_t at, char c) {
    return refusal([=](AssetContents& a) { a.motion_names[1].name[at] = c; });
  };
  EXPECT_EQ(with_byte(3, 's'), LoadCode::kOk);
  EXPECT_EQ(with_byte(0, 0), LoadCode::kReference) << "empty, with bytes behind the end";
  EXPECT_EQ(with_byte(4, 's'), LoadCode::kReference) << "a byte behind the end";
  EXPECT_EQ(refusal([](auto& a) { a.motion_names[1] = {}; }), LoadCode::kReference);
  EXPECT_EQ(refusal([](auto& a) { std::memset(a.motion_names[1].name, 'n', sizeof a.motion_names[1].name); }),
            LoadCode::kReference)
      << "no end";
}

TEST(OpenTuning, RefusalsNameTheRow) {
  AssetContents contents = small_asset();
  contents.quality[1].cost = -1;
  const LoadStatus status = open_written(contents);
  EXPECT_EQ(status.chunk, chunk::kQuality);
  EXPECT_EQ(status.item, 1u);
  contents.tuning[0].cost = -1;
  EXPECT_EQ(open_written(contents).chunk, chunk::kTuning);
}

}  // namespace coif::open_motion_test
