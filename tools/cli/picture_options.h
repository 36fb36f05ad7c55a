#pragma once

#include "render/picture.h"

#include <CLI/CLI.hpp>

namespace coif::cli {

/// --transparency, --order, --shadows, --head, --lights, --backdrop, --ground, --margin, with the defaults of pictures
/// to look at; `picture` must outlive the parsing.
void add_picture_options(CLI::App& app, render::PictureSettings& picture);

}  // namespace coif::cli
