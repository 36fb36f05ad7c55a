#include "validate/code_tables.h"

namespace coif {
namespace {

using enum IssueGroup;
using enum Severity;

constexpr const char* kCookAgain = "Cook the source again.";

constexpr IssueCode kCodes[] = {
    {"S101", kSource, kError, "source cannot be imported", "The file is damaged, or breaks its format's rules.",
     "Export it again; the message names the place."},
    {"S102", kSource, kError, "format not supported", "The file's format, or this variant of it, is not read.",
     "Export glTF 2.0 (.glb), FBX 7 (2011 or later), OBJ or COLLADA."},
    {"S103", kSource, kError, "recipe unusable", "The recipe has an unknown key or a value out of its range.",
     "'coif cook --print-recipe' prints all keys with their ranges."},
    {"S104", kSource, kError, "no hair found", "Nothing in the source is hair, so that a cook ends here.",
     "Name it in the recipe: \"hair.meshes\", \"hair.materials\" or \"hair.bones\"."},
    {"S201", kSource, kWarning, "repaired by the import", "Something in the file is wrong and was repaired or dropped.",
     "Correct it in the modeller; the message names the place."},
    {"S202", kSource, kWarning, "doubtful choice of hair", "The hair was found, but not beyond doubt.",
     "Name it in the recipe: \"hair.meshes\", \"hair.materials\" or \"hair.bones\"."},
    {"S203", kSource, kInfo, "hair without texture coordinates",
     "It shows one texel of a texture, and the strands' direction is guessed from their shape.",
     "Unwrap the strips along their length."},
    {"S204", kSource, kInfo, "hair without bones", "It follows no bone of the file; chains are fitted to it.",
     "Nothing, where the fitted chains look well; else give the model bones and weights."},
    {"S205", kSource, kWarning, "not of a head's size",
     "The hair is less than 0.05 m or more than 3 m large, so that gravity and inertia look wrong.",
     "Set the file's unit: \"source.metres_per_unit\"."},
    {"S206", kSource, kWarning, "hair in fragments", "Patches would have less than four triangles on average.",
     "Set \"patches.connectivity\" to \"position\" or \"index\"."},
    {"R101", kSource, kError, "cooked from other bytes", "The source has changed since the asset was cooked.",
     kCookAgain},
    {"R102", kSource, kError, "cooked by another recipe",
     "The recipe's values have changed since the asset was cooked.", kCookAgain},
    {"R103", kSource, kWarning, "cooked by another version", "A cook by this version may give other bytes.",
     "Cook the source again, or find out with --recook."},
    {"R104", kSource, kWarning, "read by another importer", "This version of the importer may read other values.",
     "Cook the source again, or find out with --recook."},
    {"R105", kSource, kError, "origin unknown", "The asset does not say what it was cooked from.",
     "Cook with \"scene.provenance\": true, or find out with --recook."},
    {"R106", kSource, kError, "a new cook differs",
     "Source, recipe, the textures they name or the tools have changed since the asset was cooked.", kCookAgain},
};

}  // namespace

std::span<const IssueCode> origin_codes() { return kCodes; }

}  // namespace coif
