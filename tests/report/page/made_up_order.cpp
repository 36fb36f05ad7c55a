#include "report/page/made_up_order.h"

#include <cmath>

namespace coif {
namespace {

OrderError error_of(double db) {
  OrderError error;
  error.psnr_db = db;
  error.median_psnr_db = db + 1;
  error.worst_psnr_db = db - 5;
  error.rmse = std::pow(10, -db / 20);
  error.bad_pixels_pct = 100 * error.rmse;
  error.view_psnr_db = {db - 5, db, db + 2, db + 3};
  return error;
}

}  // namespace

OrderReport made_up_order() {
  OrderReport report;
  report.device = "made-up device";
  report.width = report.height = 64;
  report.opaque_threshold = 0.8;
  report.orders = 3;
  report.directions = {{0, 0}, {90, 0}, {180, 0}, {270, 10}};
  report.orbit_frames = 30;
  for (const char* pose : {"rest", "turn"}) {
    report.rows.push_back({"head", pose, false, error_of(20), 0.02, 1, 1000});
    report.rows.push_back({"view", pose, true, error_of(40), 0.01, 1.5, 3000});
    report.rows.push_back({"triangles", pose, true, error_of(44), std::nullopt, 2, 1000});
    report.gains.push_back({pose, 20});
  }
  report.modes = {{"blend", 1, "rest", error_of(40), 0.01, 1.5}, {"opaque", 1, "rest", error_of(18), 0.05, 0.5}};
  report.thresholds = {{0.8, true, error_of(40)}, {0.9, false, error_of(41)}};
  report.distance = {{512, 99.5, 0, 99.5}, {256, 98, 0, 98}, {16, 62, 2, 50}};
  report.reference = {{"again", kEqualDb, 0}};
  report.left_out = {{"bones", "this program <cannot>"}};
  report.worst = {{"head", "rest", 90, 0, 15, {1, 2, 3}}};
  return report;
}

}  // namespace coif
