#include "report/shadow/measure_shadows.h"

#include "base/timing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coif::report {
namespace {

bool is_of(const ShadowTotal& total, const ShadowRow& row) {
  return total.technique == row.technique && total.layers == row.layers && total.size == row.size;
}

/// Over the rows that have such points; NaN where none has.
class MeanError {
 public:
  void add(const ShadowError& error) {
    if (!std::isfinite(error.rmse)) return;
    squares_ += error.rmse * error.rmse;
    biases_ += error.bias;
    most_ = std::max(most_, error.most);
    ++count_;
  }
  [[nodiscard]] ShadowError error() const {
    return count_ == 0 ? ShadowError{} : ShadowError{std::sqrt(squares_ / count_), biases_ / count_, most_};
  }

 private:
  double squares_ = 0, biases_ = 0, most_ = 0;
  double count_ = 0;
};

void fill(std::span<const ShadowRow> rows, ShadowTotal& total) {
  MeanError hair, head;
  std::vector<double> ms, read_ns;
  for (const ShadowRow& row : rows) {
    if (!is_of(total, row)) continue;
    hair.add(row.hair);
    head.add(row.head);
    ms.push_back(row.ms);
    read_ns.push_back(row.read_ns);
    total.bytes = std::max(total.bytes, row.bytes);
    if (!(row.hair.rmse > total.worst_rmse)) continue;
    total.worst_rmse = row.hair.rmse;
    total.worst_light = row.light;
    total.worst_pose = row.pose;
  }
  total.hair = hair.error();
  total.head = head.error();
  total.ms = SideBySideTiming::summarize(std::move(ms)).seconds;
  total.read_ns = SideBySideTiming::summarize(std::move(read_ns)).seconds;
}

}  // namespace

ShadowError shadow_error(std::span<const ShadowPoint> points, std::span<const float> light, bool of_head) {
  double weights = 0, sum = 0, squares = 0, most = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].is_head != of_head) continue;
    const double weight = double(points[i].weight), error = double(light[i]) - double(points[i].transmittance);
    weights += weight;
    sum += weight * error;
    squares += weight * error * error;
    most = std::max(most, std::fabs(error));
  }
  return weights > 0 ? ShadowError{std::sqrt(squares / weights), sum / weights, most} : ShadowError{};
}

std::vector<ShadowTotal> shadow_totals(std::span<const ShadowRow> rows) {
  std::vector<ShadowTotal> totals;
  for (const ShadowRow& row : rows) {
    if (std::ranges::any_of(totals, [&](const ShadowTotal& total) { return is_of(total, row); })) continue;
    totals.push_back({.technique = row.technique, .layers = row.layers, .size = row.size});
    fill(rows, totals.back());
  }
  return totals;
}

}  // namespace coif::report
