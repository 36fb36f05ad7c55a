#pragma once

#include "view/page/asset_motion.h"
#include "view/page/view_settings.h"

namespace coif::view {

/// The settings with what the asset itself says of how hair moves.
[[nodiscard]] ViewSettings with_motion(ViewSettings settings, const AssetMotion& motion);

/// What `settings` say of how hair moves that `before` do not.
[[nodiscard]] MotionTuning tuning_between(const ViewSettings& before, const ViewSettings& settings);

}  // namespace coif::view
