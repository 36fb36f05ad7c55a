#include "animation/recording.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <iterator>
#include <string_view>

namespace coif {
namespace {

// RFC 4180: a field with a comma, a quote or a line end is quoted, quotes inside are doubled.
std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

Eigen::Vector3d to_world(const HeadPose& head, const Vec3& point) {
  const Quat& q = head.rotation;
  const Eigen::Quaterniond rotation(double(q.w), double(q.x), double(q.y), double(q.z));
  return rotation * Eigen::Vector3f(point.x, point.y, point.z).cast<double>() +
         Eigen::Map<const Eigen::Vector3d>(head.position);
}

}  // namespace

std::string to_csv(const Asset& asset, const Recording& recording) {
  std::vector<std::string> names;
  for (std::uint32_t bone = 0; bone < asset.bones().size(); ++bone) names.push_back(csv_field(asset.bone_name(bone)));

  std::string text = "frame,seconds,bone,name,x,y,z,world_x,world_y,world_z\n";
  auto out = std::back_inserter(text);
  for (std::size_t f = 0; f < recording.frames.size(); ++f) {
    const RecordedFrame& frame = recording.frames[f];
    for (std::size_t bone = 0; bone < frame.bone_ends.size(); ++bone) {
      const Vec3& p = frame.bone_ends[bone];
      const Eigen::Vector3d world = to_world(frame.head, p);
      fmt::format_to(out, "{},{:.6f},{},{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", f, frame.seconds, bone,
                     names[bone], p.x, p.y, p.z, world.x(), world.y(), world.z());
    }
  }
  return text;
}

}  // namespace coif
