#include "grow/head_frame.h"

#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace coif::grow {
namespace {

using Eigen::Vector3f;

constexpr int kSections = 600;  // Sections of a whole body, 3 mm each.
// The widest place of a skull lies 0.53 of its mean width below the top; a little farther down face and ears begin.
constexpr float kMiddle = 0.53f;
constexpr float kFaceBegins = 0.62f;

/// Boxes of a body's surface in horizontal sections, one below the other.
std::vector<Eigen::AlignedBox2f> sections_of(std::span<const Vector3f> positions,
                                             std::span<const std::uint32_t> triangles, float top, float step) {
  std::vector<Eigen::AlignedBox2f> sections(kSections);
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3f& a = positions[triangles[i + k]];
      const Vector3f& b = positions[triangles[i + (k + 1) % 3]];
      const float first = (top - std::max(a.y(), b.y())) / step, last = (top - std::min(a.y(), b.y())) / step;
      for (int s = std::max(int(std::ceil(first)), 0); float(s) <= last && s < kSections; ++s) {
        const float share = a.y() == b.y() ? 0 : (top - step * float(s) - a.y()) / (b.y() - a.y());
        const Vector3f cut = a + share * (b - a);
        sections[std::size_t(s)].extend(Eigen::Vector2f(cut.x(), cut.z()));
      }
    }
  }
  return sections;
}

}  // namespace

std::optional<HeadFrame> find_head(std::span<const Vector3f> positions, std::span<const std::uint32_t> triangles) {
  Eigen::AlignedBox3f box;
  for (const std::uint32_t v : triangles) box.extend(positions[v]);
  if (box.isEmpty() || !(box.sizes().y() > 0)) return std::nullopt;
  const float top = box.max().y(), step = box.sizes().y() / float(kSections);
  const auto sections = sections_of(positions, triangles, top, step);
  Eigen::AlignedBox2f widest;
  for (int s = 0; s < kSections; ++s) {
    if (!sections[std::size_t(s)].isEmpty()) widest.extend(sections[std::size_t(s)]);
    const float mean = widest.isEmpty() ? 0 : widest.sizes().mean();
    if (mean > 0 && step * float(s) > kFaceBegins * mean) {
      const float proportion = widest.sizes().x() / widest.sizes().y();
      if (!(proportion > 0.4f && proportion < 2.5f)) return std::nullopt;
      const Eigen::Vector2f middle = widest.center();
      HeadFrame head;
      head.center = Vector3f(middle.x(), top - kMiddle * mean, middle.y());
      head.radii = Vector3f(0.5f * widest.sizes().x(), kMiddle * mean, 0.5f * widest.sizes().y());
      return head;
    }
  }
  return std::nullopt;
}

}  // namespace coif::grow
