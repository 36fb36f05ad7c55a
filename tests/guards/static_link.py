#!/usr/bin/env python3
"""A statically linked program holds what it uses and nothing else. PROGRAMS says what each small program of
tests/consumer uses; every other feature must have left no symbol in it. The programs are linked without --gc-sections:
what keeps features apart is that they lie in object files of their own.

usage: static_link.py NM PROGRAM... | --self-test NM COMPILER AR
"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

# Feature -> what its functions and constants are called, demangled and without `coif::`.
FEATURES = {
    "reader": r"Asset::open|check_\w+\(coif::Asset",
    "hash": r"xxh64|asset_hash",
    "asset access for tools and renderers": r"Asset::(bone_name|lod_\w+|texture|texels)\(",
    "load messages": r"describe\(coif::Load",
    "status messages": r"describe\(coif::Status",
    "sentences about values": r"coif::explain\(|explain\(coif::",
    "levels of detail": r"choose_lod|screen_share",
    "heads on bones": r"head_pose_of_bone|is_mirrored",
    "crowd": r"\bHair::|step_block|WorldState",
    "world of many assets": r"kSharedCode|run_bundles|join_shapes",
    "the solver that an asset asks for": r"kCoifSolver",
    "solver cascade": r"kCascadeSolver|coif_row_code",
    "solver passive": r"kPassiveSolver|passive_row_code",
    "solver thesis": r"kThesisSolver|thesis_row_code",
    "hair on a character": r"kCharacter\w*Solver|kCharacterCode|character_\w+_code|begin_colliders",
    "air of single heads, and gusts": r"HairWorld::set_(air|gusts)|waves_of|gust_at\(",
    "sets of dynamics": r"HairWorld::(set|choose)_dynamics",
    "impulses": r"HairWorld::push",
    "settling": r"(Hair|HairWorld)::settle",
    "skinning": r"skin_vertices",
    "bones relative to parents": r"bone_transforms",
    "the last frame's matrices": r"keep_palettes",
    "bounds": r"find_bone_boxes|bound_hair|bounds_in_world",
    "lines of bones": r"draw_bone_lines",
    "lines of limits": r"draw_limit_lines",
    "lines of a character's colliders": r"debug_body_collider",
    "lines of colliders": r"draw_collider_lines",
    "lines of contacts": r"draw_contact_lines",
    "vectors of motion": r"draw_motion_vectors|kShaderHairMotion",
    "renderer": r"HairRenderer::create",
    "what any renderer computes": r"VisibleCrowd::|fill_draw_block|drawn_hair_of",
    "drawing": r"HairRenderer::draw",
    "upload": r"HairModel::upload|upload_texture",
    "blended hair": r"kBlendMode",
    "opaque hair": r"kOpaqueMode",
    "hair by coverage": r"kCoverageMode|kShaderKeepSharpened",
    "hair by counted samples": r"kProportionalMode|kShaderKeepProportional",
    "hair by jittered samples": r"kJitteredMode|kShaderKeep(Jittered|Masked)",
    "alpha to coverage": r"draw_co(ver|unt)ed|kShaderCoverageOutput",
    "screen-door hair": r"kScreenDoorMode|kShaderKeepScreenDoor",
    "screen-door by checkerboard": r"kCheckerboardMode|kShaderKeepCheckerboard",
    "screen-door by Bayer's pattern": r"kBayerMode|kShaderKeepBayer",
    "hashed hair": r"kHashedMode|kShaderKeepHashed",
    "bones sorted in each frame": r"BoneOrder::",
    "shadows": r"HairShadow::(create|begin|draw|uniforms)",
    "plain shadow maps": r"kPlainShadow|kShaderHairShadowPlain",
    "deep opacity maps": r"kDeepOpacityShadow|kShaderHair(ShadowDeep|Layers)",
    "opacity shadow maps": r"kOpacityShadow|kShaderHair(ShadowSlices|Slices)",
    "deep shadow maps": r"kDeepShadow\b|kShaderHair(ShadowSteps|Steps|Peel|Unpeeled)",
    "exact hair": r"kExactMode|exact_memory|draw_(lists|peeled)|kShader(FragmentLists|List|Peel|KeepPeeled)",
}

DRAWING = {"renderer", "drawing", "what any renderer computes", "upload", "asset access for tools and renderers"}

# Program -> the features it uses.
PROGRAMS = {
    "only_open": {"reader", "hash"},
    "only_lod": {"levels of detail"},
    "only_head_bone": {"heads on bones"},
    "load_and_step": {"reader", "hash", "crowd", "the solver that an asset asks for", "solver cascade", "solver passive",
                      "load messages"},
    "step_cascade": {"crowd", "solver cascade"},
    "step_by_thesis": {"crowd", "solver thesis"},
    "step_character": {"crowd", "hair on a character"},
    "step_world": {"crowd", "world of many assets", "solver cascade"},
    "only_skin": {"skinning"},
    "only_skeleton": {"bones relative to parents"},
    "only_cull": {"what any renderer computes"},
    "only_bound": {"bounds"},
    "only_lines": {"lines of bones"},
    "make_renderer": {"renderer"},
    "only_draw": DRAWING | {"blended hair"},
    "draw_motion": DRAWING | {"blended hair", "vectors of motion"},
    "draw_hashed": DRAWING | {"hashed hair"},
    "draw_jittered": DRAWING | {"hair by jittered samples", "hair by counted samples", "hair by coverage", "alpha to coverage"},
    "draw_by_bones": DRAWING | {"blended hair", "bones sorted in each frame"},
    "cast_plainly": DRAWING | {"opaque hair", "shadows", "plain shadow maps"},
    "draw_exactly": DRAWING | {"exact hair"},
}


def features_in(nm, program):
    """The features that left a symbol in the program, and how many symbols of ours it has."""
    listing = subprocess.run([nm, "-C", "--defined-only", program], check=True, capture_output=True, text=True).stdout
    ours = [line.split(" ", 2)[2].replace("coif::(anonymous namespace)::", "coif::") for line in listing.splitlines()
            if "coif::" in line]
    found = {feature for feature, pattern in FEATURES.items()
             if any(re.search(rf"\bcoif::(?:{pattern})", symbol) for symbol in ours)}
    return found, len(ours)


def check(nm, programs):
    seen, bad = 0, [] if programs else ["no program: nothing was checked"]
    for program in programs:
        name = Path(program).name
        if name not in PROGRAMS:
            bad.append(f"{name}: not in PROGRAMS; say what it uses")
            continue
        found, symbols = features_in(nm, program)
        seen += symbols
        bad += [f"{name}: does not use '{feature}', yet holds it" for feature in sorted(found - PROGRAMS[name])]
        bad += [f"{name}: '{feature}' left no symbol; is its pattern out of date?" for feature in
                sorted(PROGRAMS[name] - found)]
    return seen, bad


def self_test(nm, compiler, ar):
    """An archive of one object file with two features fails; of two object files passes."""
    lod = "namespace coif { float screen_share() { return 1; } }\n"
    reader = "namespace coif { struct Asset { void open(); }; void Asset::open() {} void xxh64() {} }\n"
    main = "namespace coif { float screen_share(); } int main() { return int(coif::screen_share()); }\n"
    cases = [("only_lod", [lod + reader], True), ("only_lod", [lod, reader], False), ("only_open", [lod, reader], True),
             ("nobody_knows", [lod], True)]
    bad = []
    for name, files, must_fail in cases:
        with tempfile.TemporaryDirectory() as folder:
            for number, text in enumerate(files):
                Path(folder, f"{number}.cpp").write_text(text)
            Path(folder, "main.cpp").write_text(main)
            objects = [f"{number}.o" for number in range(len(files))]
            for command in ([compiler, "-c", *(f"{number}.cpp" for number in range(len(files)))],
                            [ar, "cr", "library.a", *objects], [compiler, "main.cpp", "library.a", "-o", name]):
                subprocess.run(command, check=True, cwd=folder)
            problems = check(nm, [Path(folder, name)])[1]
            if bool(problems) != must_fail:
                bad.append(f"{name} of {len(files)} object files: {problems or 'did not fire'}")
    if not check(nm, [])[1]:
        bad.append("no program passed")
    return len(cases) + 1, bad


if __name__ == "__main__":
    if sys.argv[1] == "--self-test":
        count, complaints = self_test(*sys.argv[2:])
    else:
        count, complaints = check(sys.argv[1], sys.argv[2:])
    print("\n".join(complaints) or f"static link: {count} symbols or cases checked")
    sys.exit(1 if complaints else 0)
