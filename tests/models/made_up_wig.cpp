#include "models/skinned_asset.h"
#include "write/asset_writer.h"
#include "write/pose_oscillator.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace coif {
namespace {

DynamicsRecord swinging(float resistance) {
  constexpr float kRate = 60;
  const PoseOscillator oscillator = oscillator_of(resistance, kRate);
  DynamicsRecord record{};
  record.resistance = resistance;
  record.friction = 2;
  record.gravity_scale = 1;
  record.authoring_rate = kRate;
  record.stiffness = float(oscillator.stiffness);
  record.damping = float(oscillator.damping);
  record.angle_limit = kNoAngleLimit;
  record.parent_share = 1;
  return record;
}

using Eigen::Vector3f;

const Vector3f kHeadCenter(0.0f, 0.08f, 0.02f);
const Eigen::Array3f kHeadRadii(0.075f, 0.115f, 0.095f);
constexpr std::uint32_t kRows = 14;  // of quads along a strip
constexpr float kHalfWidth = 0.03f;
constexpr float kPi = std::numbers::pi_v<float>;

struct Strip {
  float azimuth;  // 0: over the face
  float layer;    // metres off the head
  float length;   // metres
  std::uint32_t chain;
};

/// Down over the head from the crown, then straight down: the strip's centre line.
Vector3f center_line(const Strip& strip, float along) {
  const float distance = 0.02f + along * strip.length;
  const float polar = std::min(distance / 0.105f, 0.62f * kPi);
  const Eigen::Array3f unit(std::sin(polar) * std::sin(strip.azimuth), std::cos(polar),
                            std::sin(polar) * std::cos(strip.azimuth));
  Vector3f place = kHeadCenter + ((kHeadRadii + strip.layer) * unit).matrix();
  place.y() -= std::max(distance - 0.105f * 0.62f * kPi, 0.0f);
  return place;
}

std::int16_t wig_snorm(float value) {
  return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0f, 1.0f) * 32767));
}

void add_vertex(AssetContents& out, const Strip& strip, float along, float across) {
  const Vector3f tangent = (center_line(strip, along + 0.01f) - center_line(strip, along)).normalized();
  const Vector3f outward = center_line(strip, along) - kHeadCenter;
  const Vector3f side = tangent.cross(outward).normalized();
  const Vector3f normal = (side.cross(tangent) + 0.5f * across * side).normalized();
  const Vector3f n = (normal - tangent * normal.dot(tangent)).normalized();
  const float width = kHalfWidth * (0.55f + 0.9f * along - 0.6f * along * along);
  const Vector3f p = center_line(strip, along) + side * (across * width) - n * (0.006f * across * across);

  VertexRecord v{};
  for (int i = 0; i < 3; ++i) {
    v.position[i] = p[i];
    v.normal[i] = wig_snorm(n[i]);
    v.tangent[i] = wig_snorm(tangent[i]);
  }
  v.normal[3] = wig_snorm(1);
  v.tangent[3] = wig_snorm(along);
  v.uv[0] = 0.5f * across + 0.5f;
  v.uv[1] = along;
  out.vertices.push_back(v);
}

void add_skin(AssetContents& out, const WigSettings& settings, const Strip& strip, float along) {
  const float place = along * static_cast<float>(settings.bones_per_chain);
  const auto below = std::min(static_cast<std::uint32_t>(place), settings.bones_per_chain - 1);
  const std::uint32_t first = 1 + strip.chain * settings.bones_per_chain;
  const auto share = static_cast<std::uint8_t>(std::lround(255 * std::min(place - static_cast<float>(below), 1.0f)));
  const auto lower = static_cast<std::uint8_t>(first + below);
  const auto upper = static_cast<std::uint8_t>(below == 0 ? 0 : lower - 1);
  out.skin.push_back({{lower, upper, 0, 0}, {share, static_cast<std::uint8_t>(255 - share), 0, 0}});
}

void add_strip(AssetContents& out, const WigSettings& settings, const Strip& strip) {
  const auto first_vertex = static_cast<std::uint32_t>(out.vertices.size());
  const auto first_index = static_cast<std::uint32_t>(out.indices.size());
  for (std::uint32_t row = 0; row <= kRows; ++row) {
    const float along = static_cast<float>(row) / kRows;
    for (const float across : {-1.0f, 0.0f, 1.0f}) {
      add_vertex(out, strip, along, across);
      add_skin(out, settings, strip, along);
    }
  }
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t column = 0; column < 2; ++column) {
      const std::uint32_t a = first_vertex + 3 * row + column;
      out.indices.insert(out.indices.end(), {a, a + 1, a + 4, a, a + 4, a + 3});
    }
  }
  const auto count = static_cast<std::uint32_t>(out.indices.size()) - first_index;
  out.patches.push_back({first_index, count, 0.1f + strip.layer, 1 + strip.chain * settings.bones_per_chain,
                         std::uint32_t(out.patches.size())});
}

void add_chain(AssetContents& out, const WigSettings& settings, const Strip& strip) {
  const auto first = static_cast<std::uint32_t>(out.bones.size());
  for (std::uint32_t i = 0; i < settings.bones_per_chain; ++i) {
    const float step = 1.0f / static_cast<float>(settings.bones_per_chain);
    const Vector3f start = center_line(strip, static_cast<float>(i) * step);
    const Vector3f end = center_line(strip, static_cast<float>(i + 1) * step);
    const Vector3f direction = (end - start).normalized();
    BoneRecord bone{};
    bone.parent = i == 0 ? 0 : first + i - 1;
    bone.kind = BoneKind::kSimulated;
    bone.chain = strip.chain;
    bone.name = kNone;
    bone.length = (end - start).norm();
    for (int k = 0; k < 3; ++k) {
      bone.joint[k] = start[k];
      bone.rest_direction[k] = direction[k];
    }
    out.bones.push_back(bone);
    out.dynamics.push_back(swinging(0.6f / static_cast<float>(i + 1)));
  }
  out.chains.push_back({first, settings.bones_per_chain, 0, {}});
}

/// Coverage 0..1 of strands at a place of the strip; each column of texels belongs to one strand.
class Strands {
 public:
  explicit Strands(std::uint32_t columns) : columns_(columns) {
    std::mt19937 random(7);
    for (std::uint32_t i = 0; i < columns; ++i) {
      const auto value = [&] { return static_cast<float>(random() & 0xFFFF) / 65535.0f; };
      strands_.push_back({value(), value(), value()});
    }
  }
  [[nodiscard]] float alpha(float u, float v) const {
    const Strand& s = at(u);
    const float border = std::min({u, 1 - u, 0.08f}) / 0.08f;
    const float ends = 0.62f + 0.38f * s.length;  // strands end at different places
    const float tip = std::clamp((ends - v) / 0.12f, 0.0f, 1.0f);
    const float body = std::clamp(0.42f + 1.44f * s.body, 0.0f, 1.0f);
    return body * std::clamp(border * (0.6f + s.body), 0.0f, 1.0f) * tip;
  }
  [[nodiscard]] float shade(float u) const { return 0.55f + 0.45f * at(u).tone; }
  [[nodiscard]] float tone(float u) const { return at(u).tone; }

 private:
  struct Strand {
    float body, length, tone;
  };
  [[nodiscard]] const Strand& at(float u) const {
    return strands_[std::min(static_cast<std::uint32_t>(u * static_cast<float>(columns_)), columns_ - 1)];
  }
  std::uint32_t columns_;
  std::vector<Strand> strands_;
};

std::byte unorm(float value) { return static_cast<std::byte>(std::lround(255 * std::clamp(value, 0.0f, 1.0f))); }

void add_textures(AssetContents& out, std::uint32_t size) {
  const Strands strands(size / 3);
  for (const TexelFormat format : {TexelFormat::kSrgb8Alpha8, TexelFormat::kRg8}) {
    const bool color = format == TexelFormat::kSrgb8Alpha8;
    out.texels.resize((out.texels.size() + 15) / 16 * 16);  // textures start at multiples of 16
    const std::uint64_t begin = out.texels.size();
    std::uint32_t mips = 0;
    for (std::uint32_t side = size; side > 0; side /= 2, ++mips) {
      for (std::uint32_t i = 0; i < side * side; ++i) {
        const float u = (static_cast<float>(i % side) + 0.5f) / static_cast<float>(side);
        const float v = (static_cast<float>(i / side) + 0.5f) / static_cast<float>(side);
        if (color) {
          const float shade = strands.shade(u);
          out.texels.insert(out.texels.end(), {unorm(0.58f * shade), unorm(0.38f * shade), unorm(0.24f * shade),
                                               unorm(strands.alpha(u, v))});
        } else {
          const float tone = strands.tone(u);
          out.texels.insert(out.texels.end(), {unorm(0.4f + 0.2f * tone), unorm(1.3f * tone - 0.1f)});
        }
      }
    }
    const TextureRole role = color ? TextureRole::kBaseColor : TextureRole::kShiftMask;
    out.textures.push_back({role, format, size, size, mips, 0, begin, out.texels.size() - begin});
  }
}

MaterialRecord brown() {
  MaterialRecord m{};
  std::fill_n(m.base_color, 4, 1.0f);
  std::fill_n(m.ambient, 3, 0.12f);
  m.opaque_threshold = 0.85f;
  m.discard_threshold = 0.02f;
  m.flags = kMaterialDoubleSided;
  const float primary[] = {0.9f, 0.85f, 0.75f};
  const float secondary[] = {1.1f, 0.7f, 0.4f};
  std::copy_n(primary, 3, m.primary_color);
  std::copy_n(secondary, 3, m.secondary_color);
  m.primary_exponent = 150;
  m.secondary_exponent = 30;
  m.primary_shift = 0.7f;
  m.secondary_shift = 0.5f;
  return m;
}

}  // namespace

std::vector<std::byte> made_up_wig(const WigSettings& settings) {
  AssetContents out;
  out.skeleton.head_rotation[3] = 1;
  BoneRecord head{};
  head.parent = head.chain = head.name = kNone;
  out.bones.push_back(head);
  out.dynamics.push_back(swinging(1));

  for (std::uint32_t i = 0; i < settings.strips; ++i) {
    const float turn = static_cast<float>(i) / static_cast<float>(settings.strips);
    const float layer = 0.006f + 0.006f * static_cast<float>(3 * i / settings.strips);  // inner strips first
    const float azimuth = 2 * kPi * std::fmod(turn * 3.0f + 0.11f * layer * 100, 1.0f);
    const float face = std::max(std::cos(azimuth), 0.0f);
    const Strip strip{azimuth, layer, 0.27f - 0.17f * face * face * face, i};
    add_chain(out, settings, strip);
    add_strip(out, settings, strip);
  }
  ColliderRecord collider{};
  collider.shape = ColliderShape::kEllipsoid;
  for (int i = 0; i < 3; ++i) {
    collider.center[i] = kHeadCenter[i];
    collider.radii[i] = kHeadRadii[i];
  }
  collider.rotation[3] = 1;
  out.colliders.push_back(collider);
  add_textures(out, settings.texture_size);
  out.material.push_back(brown());
  return write_asset(out);
}

}  // namespace coif
