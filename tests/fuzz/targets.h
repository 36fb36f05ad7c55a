#pragma once
// Readers of foreign bytes, each as a function that any driver may call: libFuzzer with bytes of its own, replay.cpp with
// those of files.

#include <cstdint>
#include <span>

namespace coif::fuzz {

using Input = std::span<const std::uint8_t>;

// Each hands the bytes to one reader, and what the reader accepts to whoever comes next. True where it accepted. A promise
// of the reader that is broken ends the process.
bool try_asset(Input input);         ///< A .coif, and a game that plays it.
bool try_recipe(Input input);        ///< A recipe's text, and printing it.
bool try_vrm(Input input);           ///< The extensions of a .gltf, .glb or .vrm. False where it has no spring.
bool try_clip(Input input);          ///< The animation of a .gltf or .glb.
bool try_model_stream(Input input);  ///< What the import process sends back.
bool try_cache_entry(Input input);   ///< A file of the cache of cooks.
bool try_manifest(Input input);      ///< A list of assets to cook.
bool try_can_fail(Input input);      ///< Reads nothing, but fails at an exclamation mark.

}  // namespace coif::fuzz
