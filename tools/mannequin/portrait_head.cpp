#include "mannequin/portrait_head.h"

#include "mannequin/solid_shapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif::mannequin {
namespace {

using Eigen::Vector3d;

/// Skull, cheeks, jaw and chin. `p` has x >= 0: the head is symmetric.
double portrait_skull(const Vector3d& p) {
  const double cranium = ellipsoid(p, {0, 1.6300, -0.0120}, {0.0745, 0.0900, 0.0960});
  const double forehead = ellipsoid(p, {0, 1.6440, 0.0250}, {0.0590, 0.0560, 0.0600});
  const double face = ellipsoid(p, {0, 1.5780, 0.0160}, {0.0605, 0.0800, 0.0660});
  const double jaw_angle = rod(p, {0.0400, 1.5560, -0.0010}, {0.0290, 1.5260, 0.0330}, 0.0140, 0.0135);
  const double jaw = rod(p, {0.0290, 1.5260, 0.0330}, {0.0045, 1.5075, 0.0610}, 0.0135, 0.0120);
  const double chin = ellipsoid(p, {0, 1.5055, 0.0670}, {0.0150, 0.0120, 0.0130});
  const double cheek_bone = ellipsoid(p, {0.0450, 1.5840, 0.0430}, {0.0170, 0.0150, 0.0240});
  const double cheek = ellipsoid(p, {0.0310, 1.5640, 0.0580}, {0.0225, 0.0220, 0.0205});
  const double lower_cheek = ellipsoid(p, {0.0290, 1.5460, 0.0430}, {0.0210, 0.0240, 0.0240});
  double head = join(cranium, forehead, 0.040);
  head = join(head, face, 0.040);
  head = join(head, std::min(jaw_angle, jaw), 0.036);
  head = join(head, lower_cheek, 0.034);
  head = join(head, chin, 0.030);
  head = join(head, cheek_bone, 0.026);
  return join(head, cheek, 0.030);
}

double portrait_brow_and_socket(double head, const Vector3d& p) {
  const double brow = rod(p, {0.0150, 1.6240, 0.0735}, {0.0450, 1.6275, 0.0590}, 0.0050, 0.0050);
  const double socket = ellipsoid(p, {0.0335, 1.6060, 0.0945}, {0.0205, 0.0125, 0.0115});
  head = join(head, brow, 0.030);
  const double inner_corner = ellipsoid(p, {0.0165, 1.6045, 0.0840}, {0.0050, 0.0050, 0.0085});
  return carve(carve(head, socket, 0.026), inner_corner, 0.012);
}

/// Distance of the point from the opening between the lids: negative inside, about metres.
double lid_opening(const Vector3d& p) {
  const LidEdges edges = lid_edges(p.x());
  const double corner = (std::abs(edges.across) - 1.0) * kOpeningHalf;
  return std::max({p.y() - edges.upper, edges.lower - p.y(), corner});
}

double portrait_lids(double head, const Vector3d& p) {
  if ((p - kEyeCenter).squaredNorm() > 0.045 * 0.045) return head;
  // Thicker above: the upper lid is a fold that lies on the eye.
  const double lids = ellipsoid(p, kEyeCenter, kEyeRadii + Vector3d::Constant(0.0020));
  const double fold = ellipsoid(p, kEyeCenter + Vector3d(0, 0.0030, 0.0008), {0.0206, 0.0174, 0.0178});
  head = join(head, join(lids, fold, 0.004), 0.0085);
  const double crease = rod(p, {0.0185, 1.6148, 0.0745}, {0.0330, 1.6196, 0.0766}, 0.0005, 0.0007);
  const double outer_crease = rod(p, {0.0330, 1.6196, 0.0766}, {0.0500, 1.6128, 0.0640}, 0.0007, 0.0004);
  head = carve(head, std::min(crease, outer_crease), 0.0042);
  const double hole = std::max(lid_opening(p) + 0.0003, kEyeCenter.z() - p.z());
  head = carve(head, hole, 0.0014);
  const double tear_duct = ellipsoid(p, {0.0172, 1.6050, 0.0665}, {0.0050, 0.0040, 0.0045});
  return join(head, tear_duct, 0.002);
}

double portrait_nose(double head, const Vector3d& p) {
  if (p.z() < 0.04) return head;
  const double bridge = rod(p, {0, 1.6080, 0.0742}, {0, 1.5740, 0.0935}, 0.0050, 0.0050);
  const double side = rod(p, {0.0055, 1.6040, 0.0680}, {0.0074, 1.5700, 0.0845}, 0.0062, 0.0060);
  const double tip = ellipsoid(p, {0, 1.5670, 0.0965}, {0.0074, 0.0068, 0.0074});
  const double wing = ellipsoid(p, {0.0098, 1.5640, 0.0880}, {0.0050, 0.0052, 0.0072});
  const double column = rod(p, {0, 1.5635, 0.0955}, {0, 1.5590, 0.0880}, 0.0040, 0.0042);
  head = join(head, side, 0.022);
  head = join(head, bridge, 0.018);
  head = join(head, tip, 0.013);
  head = join(head, wing, 0.0075);
  return join(head, column, 0.007);  // The nostrils are painted: samples would cut such holes to pieces.
}

double portrait_mouth(double head, const Vector3d& p) {
  if (p.z() < 0.03) return head;
  const double teeth = ellipsoid(p, {0, 1.5370, 0.0635}, {0.0270, 0.0240, 0.0235});
  head = join(head, teeth, 0.024);
  const double under_lip = ellipsoid(p, {0, 1.5200, 0.0985}, {0.0180, 0.0050, 0.0085});
  head = carve(head, under_lip, 0.014);
  const double groove = rod(p, {0, 1.5580, 0.0942}, {0, 1.5490, 0.0970}, 0.0010, 0.0018);
  head = carve(head, groove, 0.006);
  const double bow = rod(p, {0.0044, 1.5408, 0.0882}, {0.0262, 1.5419, 0.0756}, 0.0038, 0.0010);
  const double middle = rod(p, {0, 1.5402, 0.0889}, {0.0044, 1.5405, 0.0884}, 0.0037, 0.0034);
  const double full = rod(p, {0, 1.5320, 0.0864}, {0.0095, 1.5332, 0.0846}, 0.0054, 0.0048);
  const double lower = rod(p, {0.0095, 1.5332, 0.0846}, {0.0262, 1.5407, 0.0754}, 0.0048, 0.0010);
  const double upper_lip = join(bow, middle, 0.003), lower_lip = join(full, lower, 0.004);
  // A shallow groove: the surface's samples would cut a deep one to pieces. The line itself is painted.
  return join(head, join(upper_lip, lower_lip, 0.0040), 0.0055);
}

double portrait_ear(double head, const Vector3d& p) {
  const Vector3d center{0.0745, 1.5900, -0.0080};
  if ((p - center).squaredNorm() > 0.06 * 0.06) return head;
  // In the ear's own axes: X out of its plate, Y up along it, Z to the face.
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(-0.42, Vector3d::UnitY()) * Eigen::AngleAxisd(-0.20, Vector3d::UnitX())).toRotationMatrix();
  const Vector3d q = turn.transpose() * (p - center);
  double plate = ellipsoid(q, {0.0008, 0.0030, -0.0040}, {0.0060, 0.0260, 0.0155});
  const double lobe = ellipsoid(q, {0.0008, -0.0225, 0.0015}, {0.0048, 0.0085, 0.0075});
  plate = join(plate, lobe, 0.012);
  const double bowl = ellipsoid(q, {0.0085, -0.0040, -0.0005}, {0.0070, 0.0120, 0.0080});
  plate = carve(plate, bowl, 0.006);
  const double hollow = ellipsoid(q, {0.0088, 0.0150, -0.0045}, {0.0050, 0.0100, 0.0080});
  plate = carve(plate, hollow, 0.007);
  constexpr int kPieces = 9;
  double rim = 1;
  Vector3d last;
  for (int i = 0; i <= kPieces; ++i) {
    const double angle = std::numbers::pi * (-0.10 + 1.42 * i / kPieces);
    const Vector3d at{0.0035, 0.0040 + 0.0250 * std::sin(angle), -0.0035 + 0.0150 * std::cos(angle)};
    if (i > 0) rim = std::min(rim, rod(q, last, at, 0.0030, 0.0030));
    last = at;
  }
  const double inner_rim = rod(q, {0.0040, 0.0110, -0.0085}, {0.0040, -0.0130, -0.0075}, 0.0024, 0.0026);
  const double tragus = ellipsoid(q, {0.0030, -0.0045, 0.0100}, {0.0035, 0.0055, 0.0035});
  plate = join(plate, rim, 0.006);
  plate = join(plate, inner_rim, 0.006);
  plate = join(plate, tragus, 0.006);
  return join(head, plate, 0.009);
}

double portrait_body(const Vector3d& p) {
  double neck = rod(p, {0, 1.5250, -0.0230}, {0, 1.3900, -0.0400}, 0.0425, 0.0475);
  const double throat = rod(p, {0, 1.5000, 0.0080}, {0, 1.4050, -0.0020}, 0.0240, 0.0200);
  const double sinew = rod(p, {0.0460, 1.5430, -0.0220}, {0.0120, 1.3950, 0.0090}, 0.0085, 0.0065);
  neck = join(neck, throat, 0.030);
  neck = join(neck, sinew, 0.022);
  const double trapezius = rod(p, {0.0220, 1.4200, -0.0560}, {0.1400, 1.3600, -0.0420}, 0.0340, 0.0330);
  const double shoulder = ellipsoid(p, {0.1530, 1.3320, -0.0360}, {0.0470, 0.0640, 0.0480});
  const double arm = rod(p, {0.1640, 1.3270, -0.0360}, {0.1900, 1.0000, -0.0360}, 0.0410, 0.0350);
  const double chest = ellipsoid(p, {0, 1.2600, -0.0260}, {0.1650, 0.1420, 0.0900});
  const double breast = ellipsoid(p, {0.0720, 1.2300, 0.0420}, {0.0560, 0.0600, 0.0480});
  double body = join(trapezius, chest, 0.060);
  body = join(body, shoulder, 0.045);
  body = join(body, arm, 0.030);
  body = join(body, breast, 0.050);
  const double waist = ellipsoid(p, {0, 1.0900, -0.0200}, {0.1180, 0.1700, 0.0840});
  body = join(body, waist, 0.060);
  body = join(body, neck, 0.045);
  const double collar_bone = rod(p, {0.0150, 1.3850, 0.0220}, {0.0800, 1.3870, 0.0120}, 0.0060, 0.0065);
  const double collar_end = rod(p, {0.0800, 1.3870, 0.0120}, {0.1450, 1.3880, -0.0240}, 0.0065, 0.0070);
  body = join(body, std::min(collar_bone, collar_end), 0.018);
  const double notch = ellipsoid(p, {0, 1.3930, 0.0300}, {0.0100, 0.0110, 0.0120});
  body = carve(body, notch, 0.016);
  const double hollow = ellipsoid(p, {0.0600, 1.4080, 0.0180}, {0.0320, 0.0100, 0.0150});
  return carve(body, hollow, 0.022);
}

constexpr double kBustBase = 1.0500;  // cut flat there

}  // namespace

LidEdges lid_edges(double x) {
  LidEdges edges;
  edges.across = (x - kOpeningMiddle) / kOpeningHalf;
  const double t = std::clamp(edges.across, -1.0, 1.0);
  const double corner = kEyeLine - 0.0006 + 0.0012 * t;  // the outer one is higher
  const double arch = 1.0 - t * t;
  edges.upper = corner + (0.0071 + 0.0005 * t) * std::pow(arch, 0.70);
  edges.lower = corner - (0.0045 + 0.0005 * t) * std::pow(arch, 0.85);
  return edges;
}

double portrait_distance(const Vector3d& point) {
  const Vector3d p{std::abs(point.x()), point.y(), point.z()};
  double head = 1;
  if (p.y() > 1.40) {
    head = portrait_brow_and_socket(portrait_skull(p), p);
    head = portrait_nose(head, p);
    head = portrait_mouth(head, p);
    head = portrait_lids(head, p);
    head = portrait_ear(head, p);
  }
  double bust = head;
  if (p.y() < 1.62) bust = join(head, portrait_body(p), 0.022);
  return std::max(bust, kBustBase - p.y());
}

Vector3d portrait_normal(const Vector3d& point) { return unit_gradient(portrait_distance, point, 1.5e-4); }

double garment_distance(const Vector3d& point) {
  const Vector3d p{std::abs(point.x()), point.y(), point.z()};
  const double cloth = portrait_body(p) - 0.0045;
  // A neckline that is wide and falls towards the front.
  const double neckline = ellipsoid(p, {0, 1.4400, 0.0050}, {0.1020, 0.0920, 0.1500});
  return std::max(carve(cloth, neckline, 0.004), kBustBase - p.y());
}

}  // namespace coif::mannequin
