#include "validate/issue_codes.h"

namespace coif::validate {
namespace {

using enum IssueGroup;
using enum Severity;

// clang-format off
constexpr IssueCode kCookIssueCodes[] = {
    {"C102", kPatches, kWarning, "override of no patch", "An entry of \"patches.overrides\" selects nothing.",
     "'coif cook SOURCE --list patches' prints the patches with their numbers."},
    {"C111", kDynamics, kWarning, "hair inside the head", "Much of the hair lies inside what is taken for the head.",
     "Set \"head.center\" and \"head.radii\"."},
    {"C112", kSkeleton, kWarning, "no bone carries the hair", "The hair follows the head rigidly.",
     "Parent the hair's bones to the head, or let chains be fitted with \"chains.source\": \"fit\"."},
    {"C113", kSkeleton, kWarning, "weight on foreign bones", "Hair is weighted to bones that are not below the head: that part follows the head rigidly.",
     "Clean the weights in the modeller, or name the head by \"skeleton.head\"."},
    {"C114", kSkeleton, kWarning, "saved in a pose", "Bones stand otherwise than when the hair was bound to them: that pose becomes the hair's shape at rest.",
     "Put the armature into its rest position and export again, or acknowledge the code."},
    {"C115", kPatches, kWarning, "meshes on each other", "Two meshes of the hair have one shape, one of them in fewer triangles, and both are drawn.",
     "Where one is a level of detail of the other, name the finer in \"hair.meshes\"; else acknowledge the code."},
    {"C121", kSkeleton, kWarning, "two bones of one name", "A game finds bones that carry body colliders by their names.",
     "Rename one in the model."},
    {"C122", kDynamics, kWarning, "override that moves no chain", "An entry of \"patches.overrides\" is of patches that are not most of what any chain carries.",
     "Select all patches of the chain."},
    {"C123", kDynamics, kWarning, "head pushes the hair at rest", "Bones end inside the head: a fitted head is made smaller, a declared one pushes them out.",
     "Set smaller \"head.radii\", or move the hair outwards."},
    {"C124", kDynamics, kWarning, "bones inside a collider at rest", "They are pushed out of the modelled pose at once.",
     "Make the collider or the hit radius smaller, or set \"head.shape\"."},
    {"C131", kQuality, kWarning, "not tuned", "No motion of this hair could be computed within the work that a cook may take.",
     "Make it softer (\"dynamics.preset\"), or its bones fewer (\"chains.max_bones\")."},
    {"C132", kDynamics, kWarning, "motion depends on the frame rate", "A chain has no motion that all frame rates agree on.",
     "Raise \"dynamics.resistance\", or use fewer bones."},
    {"C133", kDynamics, kWarning, "bones without a spring", "\"dynamics.source\" is \"springs\", and the file has none for some bones: they move by the recipe's curves.",
     "Give them springs, or leave \"dynamics.source\" to the cooker."},
    {"C134", kDynamics, kWarning, "gravity that is not vertical", "Only the vertical part of a spring's gravity is kept.",
     "Let the game's wind push sideways."},
    {"C135", kDynamics, kWarning, "spring with a center", "Hair feels every motion of the head, where the spring would not.",
     "Raise its drag where it swings too much."},
    {"C136", kDynamics, kWarning, "torsion without twist", "The passive model has no twist.",
     "Set \"dynamics.model\": \"cascade\" for one, or leave \"dynamics.torsion\" out."},
    {"C141", kTextures, kWarning, "hair changes with distance", "Mips of the texture cover more or less than the texture itself.",
     "Paint its alpha with fewer faint texels."},
    {"C142", kTextures, kWarning, "alpha that is not used", "The material is opaque, and much of its texture is transparent.",
     "Export the material as blended, or set \"material.opaque_threshold\"."},
    {"C143", kTextures, kWarning, "no opaque core", "Hardly any texel is opaque: hair sorts badly.",
     "Paint opaque cores, or lower \"material.opaque_threshold\"."},
    {"C144", kTextures, kWarning, "texture not found", "The material names a file that is not there, or outside of the source's folder: it is cooked without.",
     "Put the file beside the source, allow its folder with --root, or set \"textures.base_color\"."},
    {"C145", kTextures, kWarning, "texture found elsewhere", "The file that the material names is not where it says.",
     "Export again with relative paths, or acknowledge the code."},
    {"C146", kTextures, kWarning, "texture guessed", "No material names a texture, and an image beside the source is taken, or several may be meant.",
     "Set \"textures.base_color\"."},
    {"C147", kTextures, kWarning, "texture cannot be read", "It is damaged or of a format that is not read: it is cooked without.",
     "Save it as PNG."},
    {"C149", kTextures, kWarning, "normal map not used", "It is none of normals, or damaged.",
     "Bake it as a tangent-space map."},
    {"C150", kTextures, kWarning, "materials that cannot be joined", "The hair has materials that look different, and all of it gets one.",
     "Give all hair one material, or lower the sizes of their textures."},
    {"C151", kTextures, kWarning, "strips that end hard", "They are opaque up to an edge about as wide as the strip.",
     "Let the texture's alpha fade towards the tips, or model the strips to a point."},
    {"C152", kTextures, kWarning, "vertex colours that are not kept", "Triangles share texels, or no image can hold what vertices say of colour and alpha.",
     "Give each strip texels of its own, paint the colours into the texture, or set \"textures.vertex_colors\"."},
    {"C153", kTextures, kWarning, "texture shown beyond its edge", "It is clamped or mirrored there, and what is shown cannot be stored.",
     "Unwrap the hair within the texture."},
};
// clang-format on

}  // namespace

std::span<const IssueCode> cook_codes() { return kCookIssueCodes; }

}  // namespace coif::validate
