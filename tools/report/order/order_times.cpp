#include "report/order/order_times.h"

#include "report/order/drawn_orders.h"
#include "timing.h"

#include <functional>

namespace coif {
namespace {

constexpr ViewAngle kView{30, 5};

}  // namespace

std::vector<double> measure_order_times(OrderPictures& pictures, const PictureComparer& comparer,
                                        std::span<const DrawnWay> ways, const PosedHair& hair,
                                        std::span<const std::uint32_t> indices, double seconds) {
  std::vector<std::function<void()>> works;
  for (const DrawnWay& way : ways) {
    const HairShot shot = comparer.shot(way, hair, kView);
    const Eigen::Vector3f eye = pictures.eye(shot).cast<float>();
    works.emplace_back([&pictures, &hair, indices, shot, eye, &way] {
      if (!way.sorted_units.empty()) (void)far_to_near(indices, way.sorted_units, hair.positions, eye);
      (void)pictures.draw(shot);
    });
  }
  const SideBySideTiming timing({.clock = TimingClock::kWall, .seconds = seconds, .batch_seconds = 0});
  std::vector<double> milliseconds;
  for (const Timing& measured : timing.run(works)) milliseconds.push_back(1e3 * measured.seconds);
  return milliseconds;
}

}  // namespace coif
