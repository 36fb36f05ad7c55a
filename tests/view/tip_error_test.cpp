#include "view/page/motion_figures.h"

#include "models/drawn_card.h"
#include "models/small_asset.h"

#include <gtest/gtest.h>

#include <vector>

namespace coif::view::tip_error_test {

using Source = TipErrorSource;

QualityRecord row(float rate, std::uint32_t substeps, float rms) {
  QualityRecord row{};
  row.frame_rate = rate;
  row.substeps = substeps;
  row.rms_error = rms;
  row.max_error = 10 * rms;
  return row;
}

AssetContents measured(std::vector<QualityRecord> rows) {
  AssetContents contents = small_asset();
  contents.quality = std::move(rows);
  return contents;
}

const Asset& some_asset() {
  static const DrawnAsset asset(measured({row(30, 1, 0.09f), row(30, 4, 0.04f), row(60, 1, 0.05f), row(60, 2, 0.02f),
                                          row(60, 4, 0.01f), row(120, 1, 0.03f)}));
  return *asset;
}

TEST(RecordedTipError, IsTheRowOfThisRateWithTheseSubsteps) {
  for (const QualityRecord& known : some_asset().quality()) {
    const RecordedTipError error = tip_error_of(some_asset(), {known.frame_rate, known.substeps});
    EXPECT_EQ(error.source, Source::kMeasured) << known.frame_rate << " Hz, " << known.substeps;
    EXPECT_EQ(error.rms, known.rms_error);
    EXPECT_EQ(error.max, known.max_error);
  }
}

TEST(RecordedTipError, OfARateFromItsStepIsThatRates) {
  EXPECT_EQ(tip_error_of(some_asset(), {1 / (1 / 60.0f), 2}).source, Source::kMeasured);
  EXPECT_EQ(tip_error_of(some_asset(), {1 / float(1 / 30.0), 1}).source, Source::kMeasured);
}

TEST(RecordedTipError, BetweenRatesIsThatOfTheNextSlowerOneWithSubstepsNoShorter) {
  const auto expect = [](SimulatedSo so, float rms) {
    const RecordedTipError error = tip_error_of(some_asset(), so);
    EXPECT_EQ(error.source, Source::kCoarser) << so.rate << " Hz, " << so.substeps;
    EXPECT_TRUE(is_known(error));
    EXPECT_EQ(error.rms, rms) << so.rate << " Hz, " << so.substeps;
  };
  expect({75, 2}, 0.02f);   // sub-steps of 1/150 s: 60 Hz in two parts
  expect({100, 1}, 0.05f);  // of 1/100 s: 60 Hz in one, not in two
  expect({240, 1}, 0.03f);
  expect({60, 3}, 0.02f);  // this rate, but not these parts
  expect({59, 4}, 0.04f);  // the next slower one has sub-steps of 1/120 s
}

TEST(RecordedTipError, IsNotKnownWhereAllThatWasMeasuredIsFiner) {
  EXPECT_EQ(tip_error_of(some_asset(), {15, 1}).source, Source::kTooCoarse);
  const DrawnAsset fine(measured({row(60, 4, 0.01f)}));
  EXPECT_EQ(tip_error_of(*fine, {60, 2}).source, Source::kTooCoarse);
  EXPECT_FALSE(is_known(tip_error_of(*fine, {60, 2})));
  EXPECT_EQ(tip_error_of(*fine, {60, 2}).rms, 0);
}

TEST(RecordedTipError, IsNotThatOfAnotherSolverOrOtherDynamics) {
  for (const Solver* solver : {&kThesisSolver, &kPassiveSolver, &kCascadeSolver}) {
    EXPECT_EQ(tip_error_of(some_asset(), {60, 2, solver}).source, Source::kOtherSolver);
  }
  EXPECT_EQ(tip_error_of(some_asset(), {60, 2, &kCoifSolver, true}).source, Source::kOtherDynamics);
}

TEST(RecordedTipError, IsNotKnownOfDraftsAndOfWhatWasNotMeasured) {
  AssetContents contents = measured({});
  ASSERT_FALSE(contents.provenance.empty());
  contents.provenance[0].flags = 0;
  const DrawnAsset plain(contents);
  EXPECT_EQ(tip_error_of(*plain, {60, 1}).source, Source::kNotMeasured);
  contents.provenance[0].flags = kProvenanceDraft;
  const DrawnAsset draft(contents);
  EXPECT_EQ(tip_error_of(*draft, {60, 1}).source, Source::kDraft);
}

}  // namespace coif::view::tip_error_test
