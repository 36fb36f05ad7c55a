#pragma once

#include "cook/strands/patches.h"
#include "validate/issue_codes.h"

#include <coif/asset.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>

namespace coif::validate {

/// Cooked in a hurry.
[[nodiscard]] inline bool is_draft(const Asset& asset) {
  return asset.provenance() != nullptr && (asset.provenance()->flags & kProvenanceDraft) != 0;
}

// Possible problems of an asset that opens, subject by subject; asset_codes.cpp has the meaning of each code.

/// "bone 'fringe_2'", or "bone 7" where it has no name.
[[nodiscard]] std::string bone_place(const Asset& asset, std::size_t bone);

template <typename... Args>
void add_patch_issue(Diagnostics& issues, std::string_view code, std::size_t patch, fmt::format_string<Args...> message,
                     Args&&... args) {
  add_issue(issues, code, fmt::format("patch {}", patch), message, std::forward<Args>(args)...);
  issues.back().patch = std::uint32_t(patch);
}

void check_bones(const Asset& asset, Diagnostics& issues);       ///< A202, A207, A211, A212, A213
void check_dynamics(const Asset& asset, Diagnostics& issues);    ///< A203, A205, A221 to A224
void check_geometry(const Asset& asset, Diagnostics& issues);    ///< A201, A231 to A235
void check_patches(const Asset& asset, Diagnostics& issues);     ///< A241, A242, A243
void check_orders(const Asset& asset, Diagnostics& issues);      ///< A251, A253
void check_skin(const Asset& asset, Diagnostics& issues);        ///< A261, A262
void check_textures(const Asset& asset, Diagnostics& issues);    ///< A204, A271, A272
void check_alpha(const Asset& asset, Diagnostics& issues);       ///< A252, A273, A274, A277
void check_unwrapping(const Asset& asset, Diagnostics& issues);  ///< A275, A276
void check_quality(const Asset& asset, Diagnostics& issues);     ///< A281 to A285
void check_origin(const Asset& asset, Diagnostics& issues);      ///< A291

}  // namespace coif::validate
