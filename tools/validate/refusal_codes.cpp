#include "validate/issue_codes.h"

namespace coif::validate {
namespace {

constexpr const char* kCookSourceAgain = "Cook its source again; if the new file is refused too, the cooker has a bug.";
constexpr const char* kTransfer =
    "Copy the file again, in binary mode and whole; keep line endings and version control's filters away from it.";
constexpr const char* kSameVersion = "Cook its source with the version of the tools that the game was built with.";

constexpr IssueCode refused(const char* code, IssueGroup group, const char* title, const char* meaning,
                            const char* cure = kCookSourceAgain) {
  return {code, group, Severity::kError, title, meaning, cure};
}

using enum IssueGroup;

constexpr IssueCode kRefusalCodes[] = {
    refused("F101", kContainer, "file cannot be read", "The file is absent, a folder, a pipe or not readable.",
            "Check the path and its permissions."),
    refused("A101", kContainer, "too short", "The file is shorter than an asset's header.", kTransfer),
    refused("A102", kContainer, "misaligned memory",
            "The memory that was given does not start at a multiple of 64. No file is at fault, and no file raises it "
            "here.",
            "Load assets to memory aligned to 64 bytes."),
    refused("A103", kContainer, "not an asset", "The first bytes are not those of a cooked hair asset.",
            "Give a file written by 'coif cook'."),
    refused("A104", kContainer, "other major version", "The file was cooked for another major version of the format.",
            kSameVersion),
    refused("A105", kContainer, "wrong size", "The file was truncated, or has bytes added at its end.", kTransfer),
    refused("A106", kContainer, "too many chunks",
            "The header counts more chunks than the format allows, or than the file can hold."),
    refused("A107", kContainer, "hash differs", "Bytes were changed after cooking.", kTransfer),
    refused("A108", kContainer, "chunk out of place",
            "A chunk lies outside of the file, overlaps another, or is out of order or not aligned."),
    refused("A109", kContainer, "chunk twice", "Two chunks have the same name."),
    refused("A110", kContainer, "unknown chunk", "A chunk must be understood and is not known to this version.",
            kSameVersion),
    refused("A111", kContainer, "chunk absent", "A chunk that another one needs is not there."),
    refused("A112", kContainer, "chunk of odd size",
            "A chunk's size does not fit its records, or the count declared elsewhere."),
    refused("A113", kContainer, "reserved bits set", "A field that must be zero is not.", kSameVersion),
    refused("A114", kContainer, "bad number", "A number is infinite, not a number, or outside of its range."),
    refused("A115", kContainer, "unknown value", "A field has a value that this version does not know.", kSameVersion),
    refused("A116", kContainer, "dangling index", "An index points outside of the array that it refers to."),
    refused("A117", kSkeleton, "bones out of order", "Bones are not sorted head, scalp, simulated with parents first."),
    refused("A118", kSkeleton, "bones not joined", "A bone does not start where its simulated parent ends."),
    refused("A119", kDynamics, "impossible set of colliders",
            "A bone's set names colliders that are not there, or belongs to a rigid bone."),
    refused("A120", kSkeleton, "chains do not fit bones", "Chains do not cover the simulated bones exactly once."),
    refused("A121", kSkeleton, "too many open bones",
            "A chain's order keeps more bones waiting for their children than a solver has room for."),
    refused("A122", kPatches, "patches do not fit triangles",
            "Patches do not cover the triangles exactly once, in order."),
    refused("A123", kGeometry, "levels do not fit patches",
            "Levels of detail do not cover the patches exactly once, in order."),
    refused("A124", kGeometry, "levels out of order",
            "Screen sizes do not fall to 0 from level to level, or errors do not grow from 0."),
    refused("A125", kGeometry, "levels do not fit bones",
            "A bone is simulated in levels of detail where it cannot be, or not in the finest."),
    refused("A126", kOrders, "order does not fit triangles",
            "A draw order does not draw every triangle of a level of detail exactly once."),
    refused("A127", kSkin, "weights do not add up", "The skin weights of a vertex do not add up to one."),
    refused("A128", kSkeleton, "names cut off", "The list of bone names does not end with a zero byte."),
    refused("A129", kSkeleton, "links out of order",
            "Links are not trees between bones of equal depth in different chains, by depth."),
};

}  // namespace

std::span<const IssueCode> refusal_codes() { return kRefusalCodes; }

namespace {

using enum Severity;

constexpr const char* kCookAgain = "Cook the source again.";

/// For a source that breaks the rules of its format in a way that a cook can handle.
constexpr IssueCode broken(const char* code, const char* title, const char* meaning, const char* cure) {
  return {code, kSource, kError, title, meaning, cure, true};
}

constexpr IssueCode kOriginCodes[] = {
    {"S101", kSource, kError, "source cannot be imported", "The file is damaged, or breaks its format's rules.",
     "Export it again; the message names the place."},
    {"S102", kSource, kError, "format not supported", "The file's format, or this variant of it, is not read.",
     "Export glTF 2.0 (.glb), FBX 7 (2011 or later), OBJ or COLLADA."},
    {"S103", kSource, kError, "recipe unusable", "The recipe has an unknown key or a value out of its range.",
     "'coif cook --print-recipe' prints all keys with their ranges."},
    {"S104", kSource, kError, "no hair found", "Nothing in the source is hair, so that a cook ends here.",
     "Name it in the recipe: \"hair.meshes\", \"hair.materials\", \"hair.bones\" or \"hair.parts\"; 'coif cook --list "
     "candidates' prints the lines."},
    {"S105", kSource, kError, "cannot be cooked", "The source is read and has hair, and a cook ends with an error.",
     "The message names the place and the cure."},
    broken("S111", "breaks glTF's rules",
           "Chunks, references, types or sizes are not as the format has them: other programs may refuse the file.",
           "Export it again, or repair it with a glTF tool; the message names the place."),
    broken("S112", "index of no vertex",
           "Triangles have corners that are not there, among them the number that means none: they are left out.",
           "Clean up loose geometry in the modeller and export again."),
    broken("S113", "no number",
           "A number is infinite, not a number or out of its range: vertices and what hangs on them are left out, or "
           "set to something.",
           "Delete or move what the message names, and export again."),
    broken("S114", "joints of a vertex",
           "A joint holds a vertex twice, where weights are added, or is none of the skin's, where it holds nothing.",
           "Clean the weights in the modeller, and export mesh and armature together."),
    broken("S115", "weights of a vertex",
           "Weights are below zero or do not add up to one: each is divided by their sum.",
           "Normalize the weights in the modeller."),
    broken("S116", "no unit length",
           "Normals, tangents or rotations are not of length one: they are made so, or normals are taken from the "
           "surface.",
           "Recalculate normals in the modeller and export again."),
    broken("S117", "wrong bounds",
           "'min' and 'max' are not those of the numbers: a cook does not read them, other programs hide what is seen.",
           "Export the file again."),
    broken("S118", "animation out of order",
           "Key times do not ascend, or keys have no values: a clip of it is refused or jumps.",
           "Bake the animation and export again."),
    {"S201", kSource, kWarning, "repaired by the import",
     "Triangles, vertices, normals or colours are wrong and were repaired or dropped.",
     "Correct it in the modeller; the message names the place."},
    {"S202", kSource, kWarning, "doubtful choice of hair", "The hair was found, but not beyond doubt.",
     "Name it in the recipe: \"hair.meshes\", \"hair.materials\", \"hair.bones\" or \"hair.parts\"; 'coif cook --list "
     "candidates' prints the lines."},
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
    {"S207", kSource, kWarning, "another unit than the file's",
     "In the file's unit the model has the size of no head, body or hair; in another common one it has, and that was "
     "taken.",
     "Export in the right unit, or set \"source.metres_per_unit\"; the message has the lengths."},
    {"S208", kSource, kWarning, "unit in doubt",
     "The unit that holds, the file's or the recipe's, gives unusual lengths, and another common one would not.",
     "Set \"source.metres_per_unit\" to the right one; the message has the lengths."},
    {"S209", kSource, kWarning, "another up axis than the file's",
     "Bones and hair stand up along another axis, and the model was turned.",
     "Export with the right axis, or set \"source.up_axis\"; the message says what speaks for the other."},
    {"S210", kSource, kWarning, "up axis in doubt",
     "The axis that holds, the file's or the recipe's, is hardly likelier than another, or less likely.",
     "Set \"source.up_axis\" to the right one; the message says what speaks for the other."},
    {"S211", kSource, kWarning, "points or lines left out",
     "The file has points or lines beside triangles, too few or too short for strands of hair.",
     "Delete loose geometry in the modeller; hair of lines wants some dozens of strands of four points."},
    {"S212", kSource, kWarning, "body that is not read",
     "The recipe names a body for strands, and the file has strips.", "Leave \"cards.body\" out of its recipe."},
    {"S213", kSource, kWarning, "hidden meshes left out", "The file hides meshes: they are no hair.",
     "Show what is hair in the modeller and export again, or acknowledge the code."},
    {"S214", kSource, kWarning, "coarser levels left out",
     "Of meshes that are levels of detail of one thing the finest is read; a cook makes levels of its own.",
     "Export the finest alone, or name the one that is meant in \"hair.meshes\"; or acknowledge the code."},
    {"S215", kSource, kWarning, "shape keys that are on", "They are part of the hair's shape, as the file has them.",
     "Turn them off, or apply them, and export again; or acknowledge the code."},
    {"S216", kSource, kWarning, "skin repaired", "Bones, weights or bind matrices are absent or no numbers.",
     "Clean the weights in the modeller, and export mesh and armature together."},
    {"S217", kSource, kWarning, "image left out",
     "An image inside of the file, or what a texture refers to, is absent, damaged or of a format that is not read.",
     "Save it as PNG, assign it and export again."},
    {"S218", kSource, kWarning, "material not found",
     "A mesh refers to a material, or a model to a library of materials, that is not there or not allowed.",
     "Put the file beside the model, allow its folder with --root, or export as .glb."},
    {"S219", kSource, kWarning, "extension that is not read",
     "The file uses an extension of glTF that may change shape, texture coordinates or images.",
     "Open it in Blender and export again, or acknowledge the code."},
    {"S220", kSource, kWarning, "springs repaired",
     "Spring bones or colliders of a VRM are wrong and were left out or limited.",
     "Correct them in the avatar's tool and export again."},
    {"S221", kSource, kWarning, "texture coordinates repaired",
     "They are absent or no numbers, or lie otherwise for one texture than for another.",
     "Unwrap the mesh anew, give its textures one UV map and one mapping, and export again."},
    {"S222", kSource, kWarning, "axes or transforms repaired",
     "The file's axes, its unit or a node's transform say nothing that can be.",
     "Apply transforms in the modeller and export again."},
    {"S223", kSource, kWarning, "strands repaired",
     "Strands, or what the file says of their points, are wrong and were left out or limited.",
     "Export the curves again as polylines."},
    {"S224", kSource, kWarning, "body that does not fit",
     "Strands lie elsewhere than the body that they grow on, or it has no head, or hair of its own.",
     "Give both files one unit and place, name the head's node, and leave hair out of the body."},
    {"S225", kSource, kWarning, "file name written otherwise",
     "A file that the source names lies there under another spelling: with slashes for backslashes, in other letters, "
     "or in "
     "another folder.",
     "Give the file the name that the source has, or export again with relative paths; or acknowledge the code."},
    {"S226", kSource, kWarning, "material that would not be seen",
     "As it is written it is wholly transparent, or so black that nothing is seen of its texture, or only its light "
     "has a texture; the "
     "message says what is taken.",
     "Set the material's opacity to 1 and its colour to white, connect the texture to its base colour and export "
     "again, or acknowledge the code."},
    {"S227", kSource, kWarning, "head in doubt",
     "Joints, the head's own mesh and the hair around it do not agree on one head, or none of them shows it.",
     "Set \"head.center\" and \"head.radii\" in the recipe, or acknowledge the code where the picture of look is "
     "right."},
    {"S228", kSource, kWarning, "facing in doubt", "It is not certain whether the model looks along +Z or -Z.",
     "Export with joints of eyes or toes, or acknowledge the code where pictures show the face."},
    {"S229", kSource, kWarning, "roots in doubt",
     "Of much of the hair it is not certain which ends of its strips are the roots.",
     "Set \"strands.root\", or the root of single patches by \"patches.overrides\"; 'coif cook --list patches' names "
     "them."},
    {"S230", kSource, kWarning, "chains in doubt",
     "Chains were fitted, but the hair that they move may not be what should move.",
     "Look at 'coif look'; set \"chains.max_count\", \"chains.exclude\" or bones of your own, or acknowledge the "
     "code."},
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
    {"R107", kSource, kError, "cooked as a draft", "A full cook gives another asset.", "Cook without --draft."},
};

}  // namespace

std::span<const IssueCode> origin_codes() { return kOriginCodes; }

}  // namespace coif::validate
