#pragma once

#include "lab/measure_runtime.h"
#include "lab/rig.h"
#include "platform/stop.h"
#include "write/asset_writer.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace coif::cook {

/// The runtime's errors at one frame rate, over all motions of the suite.
struct MeasuredRate {
  QualityRecord quality;
  double worst_second = 0;
};

/// The chains of an asset to run, and the number of others that are neither run nor represented.
struct ChainsToRun {
  std::vector<std::uint32_t> chains;
  std::size_t left_out = 0;
};

/// Runs the runtime beside the reference, for any frame rate of the recipe's and number of parts; each is measured
/// once.
///
/// Its work is bounded by counts of steps times bones, which are equal on every machine and for any number of threads:
/// at most about ten seconds of one processor, whatever the file. Of many chains it runs those that represent most
/// others. A motion whose reference needs more than its share is as exact as that share allows, or left out. left_out()
/// lists all of it.
class TuningBench {
 public:
  TuningBench(const AssetContents& contents, std::span<const std::uint32_t> rates, const platform::Threads& threads);

  const MeasuredRate& at(std::uint32_t rate, std::uint32_t parts);

  /// No motion has a reference.
  [[nodiscard]] bool is_empty() const;
  /// Whether sub-steps of this rate may still be measured at all these frame rates.
  [[nodiscard]] bool has_work_left(std::span<const std::uint32_t> rates, std::uint32_t substep_rate) const;
  /// Sentences for the cook's notes.
  [[nodiscard]] const std::vector<std::string>& left_out() const { return left_out_; }
  [[nodiscard]] double longest() const;
  [[nodiscard]] std::vector<QualityRecord> table() const;

 private:
  TuningBench(const AssetContents& contents, const ChainsToRun& run, std::span<const std::uint32_t> rates,
              const platform::Threads& threads);
  void solve(std::span<const std::uint32_t> rates);
  void say_what_is_left_out();
  [[nodiscard]] std::uint64_t work_of(std::uint32_t rate, std::uint32_t parts) const;
  [[nodiscard]] MeasuredRate measure(std::uint32_t rate, std::uint32_t parts) const;

  lab::OpenedAsset opened_;
  lab::Rig rig_;
  platform::Threads threads_;
  std::size_t bones_ = 0, passive_ = 0, twisting_ = 0;
  std::uint64_t work_ = 0;               ///< Steps of the runtime so far, times bones.
  std::vector<lab::KnownMotion> known_;  ///< One for each motion of the suite.
  std::map<std::pair<std::uint32_t, std::uint32_t>, MeasuredRate> measured_;
  std::vector<std::string> left_out_;
};

}  // namespace coif::cook
