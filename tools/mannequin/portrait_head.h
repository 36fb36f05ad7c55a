#pragma once

#include "mannequin/head_shape.h"

#include <Eigen/Core>

#include <array>

namespace coif::mannequin {

// The portrait's bust as a signed distance field, with the proportions of drawing lessons: eyes at half the head's
// height, each a fifth of its width, and as far apart; brow, nose and chin each a third of the face below the one
// before; the mouth a third of the way from nose to chin. Source: Loomis, "Drawing the Head and Hands", 1956. Model
// space, metres, face towards +Z.

inline constexpr double kCrown = 1.720, kChin = 1.488;
inline constexpr double kEyeLine = 1.6060;
inline constexpr double kBrowLine = 1.6262;
inline constexpr double kNoseBase = 1.5590;
inline constexpr double kMouthLine = 1.5372;

inline const Eigen::Vector3d kEyeCenter{0.0320, kEyeLine, 0.0602};  ///< The left eyeball (+X).
inline const Eigen::Vector3d kEyeRadii{0.0186, 0.0166, 0.0164};     ///< Broader than round: it fills the lids' corners.

inline constexpr double kOpeningMiddle = 0.0318, kOpeningHalf = 0.0172;  ///< The left eye's lids, X.

/// The opening between the lids of the left eye, in the plane of the face: Y of both edges at x, which meet in the
/// corners.
struct LidEdges {
  double upper, lower;
  double across;  ///< -1 at the inner corner, 1 at the outer; beyond them there is no opening.
};
[[nodiscard]] LidEdges lid_edges(double x);

/// Distance to the skin of head, neck and shoulders.
[[nodiscard]] double portrait_distance(const Eigen::Vector3d& point);

/// Unit gradient of portrait_distance(): outwards.
[[nodiscard]] Eigen::Vector3d portrait_normal(const Eigen::Vector3d& point);

/// Distance to the bust's clothes.
[[nodiscard]] double garment_distance(const Eigen::Vector3d& point);

}  // namespace coif::mannequin
