#pragma once

#include <string_view>

namespace coif::cook {

// What names say, word by word (base/words.h), in the languages that modellers name things in. A name is one piece of
// evidence among others: people call things after what they are meant for, or not at all.

/// "hair", "Fringe_L", "pony tail", "kami"; not what is worn in it ("hairband") or only spelt like it ("chair").
[[nodiscard]] bool is_called_hair(std::string_view name);

/// Worn in hair ("hairband"), and not hair, though the name has the word.
[[nodiscard]] bool is_called_adornment(std::string_view name);

/// Worn on the head: "hat", "helmet", "hood".
[[nodiscard]] bool is_called_headwear(std::string_view name);

[[nodiscard]] bool is_called_skin(std::string_view name);

/// "beard", "moustache": hair that grows on the face and hangs from it.
[[nodiscard]] bool is_called_beard(std::string_view name);

/// "eyebrow_L", "lashes".
[[nodiscard]] bool is_called_brow(std::string_view name);

/// Eyes and what moves with them: lids, lashes and brows.
[[nodiscard]] bool is_called_eye(std::string_view name);

/// An eyeball, and nothing around it or aimed at.
[[nodiscard]] bool is_called_eyeball(std::string_view name);

/// A part of the face that carries no hair of the head: eyes, lids, jaw, lips, ears, ...
[[nodiscard]] bool is_called_face_part(std::string_view name);

/// "opacity", "alpha", "transparent": the exporters' names of a material with soft edges.
[[nodiscard]] bool is_called_transparent(std::string_view name);

/// "Head", "mixamorig:Head", "J_Bip_C_Head", "Bip01 Head"; not its end marker or things worn on it.
[[nodiscard]] bool is_called_head(std::string_view name);

/// The marker at the end of a bone: "HeadTop_End", "HeadNub".
[[nodiscard]] bool is_called_end(std::string_view name);

[[nodiscard]] bool is_called_neck(std::string_view name);

/// Hips, spine, chest.
[[nodiscard]] bool is_called_trunk(std::string_view name);

[[nodiscard]] bool is_called_foot(std::string_view name);

/// What an animator pulls at, and nothing that is moved itself: a target, a control.
[[nodiscard]] bool is_called_control(std::string_view name);

/// A part of arms or legs, hands and feet among them.
[[nodiscard]] bool is_called_limb(std::string_view name);

}  // namespace coif::cook
