#pragma once

#include "animation/recording.h"
#include "render/picture.h"

#include <CLI/CLI.hpp>
#include <Eigen/Core>

#include <optional>
#include <string>

namespace coif::cli {

/// --transparency, --order, --shadows, --head, --lights, --backdrop, --ground, --margin, with the defaults of pictures
/// to look at; `picture` must outlive the parsing.
void add_picture_options(CLI::App& app, render::PictureSettings& picture);

/// --shading; none: as cooked.
CLI::Option* add_shading(CLI::App& app, std::optional<ShadingModel>& choice);

// Options of `coif simulate` alone: what the head does and how long frames are, for who checks hair by its CSV.

/// --attitude X,Y,Z: where the head's up axis points to once the head was turned.
CLI::Option* add_attitude(CLI::App& app, std::optional<Eigen::Vector3d>& attitude);

/// --scale, in the range of HeadPose::scale.
CLI::Option* add_scale(CLI::App& app, float& scale);

/// --frame-lengths S[,S...] and --jitter SHARE[,SEED].
void add_frame_lengths(CLI::App& app, animation::FrameLengths& lengths);

/// "60 per second", or how frame lengths alternate and vary at random.
[[nodiscard]] std::string pace_text(const animation::RecordingSettings& recording);

}  // namespace coif::cli
