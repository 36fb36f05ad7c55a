#pragma once
// Why a value is refused. A game that calls none of these functions links none of their text.

#include <coif/export.h>
#include <coif/hair.h>

#include <cstddef>
#include <span>

namespace coif {

// Each writes one sentence about the first thing for which a call with this value gives an error: the member, what it
// is and what it may be, such as "StepSettings: inertia is 1.5, above 1". It ends with a zero and is cut where `text`
// is too short, which may be empty. Returns the length of the whole sentence without the zero; 0 where nothing is
// wrong, then `text` is empty. Allocates nothing.

COIF_API std::size_t explain(const HairDesc& desc, std::span<char> text);            ///< Hair::create()
COIF_API std::size_t explain(const WorldDesc& desc, std::span<char> text);           ///< HairWorld::create()
COIF_API std::size_t explain(const StepSettings& settings, std::span<char> text);    ///< step(), settle()
COIF_API std::size_t explain(const HeadPose& pose, std::span<char> text);            ///< set_head(), add_head()
COIF_API std::size_t explain(const DynamicsScale& scale, std::span<char> text);      ///< set_dynamics()
COIF_API std::size_t explain(const MovingCollider& collider, std::span<char> text);  ///< set_colliders()
COIF_API std::size_t explain(const HeadAir& air, std::span<char> text);              ///< set_air()
COIF_API std::size_t explain(const Gusts& gusts, std::span<char> text);              ///< set_gusts()
COIF_API std::size_t explain(const Impulse& impulse, std::span<char> text);          ///< push()

/// create() and memory_need() with this asset: says also what the asset lacks.
COIF_API std::size_t explain(const Asset& asset, const HairDesc& desc, std::span<char> text);

}  // namespace coif
