#pragma once

#include <array>

namespace coif {

// Lights and backdrop of the tools' pictures, for code that draws them and for code that predicts them. Linear colours.

/// A directional light that moves with the camera.
struct StudioLight {
  std::array<float, 3> towards;  ///< Right, up, back of the camera; not unit.
  std::array<float, 3> color;
};

/// Photographer's lights: key, fill and rim. Shifted tangents want the half vector some 30 degrees above the normal, so
/// only a light from the top puts both highlights where they are seen, around the head's widest part. Fill and rim come
/// from low, where their own highlights miss the hair: more than two bands would read as noise.
inline constexpr std::array<StudioLight, 3> kStudioLights = {{{{-0.3f, 1.0f, 0.2f}, {1.2f, 1.17f, 1.12f}},
                                                              {{0.4f, -0.3f, 1.0f}, {0.22f, 0.23f, 0.25f}},
                                                              {{0.9f, 0.1f, -0.6f}, {0.15f, 0.17f, 0.22f}}}};

inline constexpr std::array<float, 3> kClay = {0.42f, 0.33f, 0.28f};  ///< A mannequin's head.
inline constexpr float kClayAmbient = 0.12f;                          ///< Light on it from everywhere.
inline constexpr float kClayWrap = 0.25f;                             ///< How far its light reaches around.

inline constexpr std::array<float, 3> kBackdropBottom = {0.36f, 0.36f, 0.37f}, kBackdropTop = {0.17f, 0.19f, 0.22f};

}  // namespace coif
