#!/bin/sh
# Installs what is missing, builds, runs the tests. The last line is "N passed, N failed, N skipped"; the exit code is 0
# only when something passed and nothing failed.
#   tests/run.sh [PART...]   plain, when none is named: everything that a change can break
#     asan    under sanitizers: readers of foreign bytes, and what runs in a game; asan-cook: the cooker, batches, checks and the
#             local server, which take as long again. Drawing and the command line are in neither: they would watch the driver,
#             and start hundreds of slow processes
#     fuzz    10 s of libFuzzer for each reader of foreign bytes; see tests/fuzz/README.md
#     farm    many machines, emulated on this one: Slurm and GNU parallel, killed nodes and lost hosts
#     web     in WebAssembly: the npm package gives the same bits in node, hair in three's scenes and the page of coif view in Chromium
#     blender   what is read of FBX, OBJ and COLLADA is what Blender reads of it
#     truth   hair beside the same strands path-traced by Blender, small
#     variants  reader and simulation, by other compilers and flags, in 32 bits and for ARM, give the same bits; or one of them by
#             its preset: fma, avx2, native, clang, x86-32, arm64
#     calm    hair of heads that are held comes to rest, in every way to run each of the artists' files; ten minutes
#     agree   coif cook and coif validate find the same in every shared file; an hour
#     style   every C++ and C file is in the form of .clang-format
#     tidy    clang-tidy has nothing to say about any source; an hour
#     debug   the program, compiled for a debugger, cooks the bytes that the one for release cooks
#     all     all of these
set -u
cd "$(dirname "$0")/.."
jobs=$(nproc)
results=
broken=0

# install GROUPS...
install() { sh tools/install_packages.sh "$@" || broken=$((broken + 1)); }

# build PRESET OPTION TARGETS...
build() {
  preset=$1
  option=$2
  shift 2
  cmake --preset "$preset" "$option" >/dev/null && cmake --build --preset "$preset" --parallel "$jobs" --target "$@" && return
  echo "run.sh: the build '$preset' broke" >&2
  broken=$((broken + 1))
  return 1
}

# run PRESET PART ARGUMENTS...: the tests of that build tree which the arguments choose. A part that skips all is broken.
run() {
  preset=$1
  part=$2
  file=$PWD/build/$preset/results.$part.xml
  shift 2
  rm -f "$file"
  ctest --test-dir "build/$preset" "$@" --parallel "$jobs" --output-on-failure --output-junit "$file"
  results="$results $file"
  case $(sh tests/count_results.sh "$file") in
    0\ *)
      echo "run.sh: no test of the part '$part' passed" >&2
      broken=$((broken + 1))
      ;;
  esac
}

# sanitize PART FOLDERS...
sanitize() {
  part=$1
  shift
  targets=
  for folder in "$@"; do targets="$targets coif_${folder}_test"; done
  [ "$1" = formats ] && targets="$targets coif_sim_allocation_test"
  build asan -DCOIF_TESTS=ON $targets || return
  run asan "$part" -L "^($(echo "$*" | tr ' ' '|'))\$" -E '^(validate[.]schema|cook[.]artists_files)'
}

# The same bits, or LaneDeterminism fails; and no fused instruction, or guard.no_fused_arithmetic does.
try_variant() {
  chosen=.
  # Emulated, all of it would take half an hour.
  [ "$1" = arm64 ] && chosen='^(LaneDeterminism|FloatEnvironment|Hitch|NoTime|Open|guard)'
  build "$1" -DCOIF_TESTS=ON all && run "$1" "$1" -R "$chosen"
}

test_web() {
  install web && build web -DCOIF_TESTS=OFF coif_web coif_view_html && build release -DCOIF_TESTS=ON coif_cli coif_step_motions coif_print_model &&
    run release web -L '^web$'
}

compare_builds() {
  build debug -DCOIF_TESTS=OFF coif_cli && build release -DCOIF_TESTS=ON coif_cli &&
    run release debug -R '^cli[.]builds_cook_alike$'
}

install program tests
for part in ${*:-plain}; do
  [ "$part" = all ] && part='plain asan asan-cook fuzz farm web blender truth variants calm agree style tidy debug'
  for part in $part; do
    case $part in
      plain) build release -DCOIF_TESTS=ON all && run release plain -LE '^(farm|other_builds|web|blender|truth|calm_all|agree_all|style|tidy)$' ;;
      asan) sanitize asan formats sim c import groom ;;
      asan-cook) sanitize asan-cook cook cache validate view ;;
      fuzz) install fuzz && build fuzz -DCOIF_TESTS=ON fuzz_readers && run fuzz fuzz ;;
      farm) install farm && build release -DCOIF_TESTS=ON coif_cli && run release farm -L '^farm$' ;;
      web) test_web ;;
      blender) install blender && build release -DCOIF_TESTS=ON coif_print_model && run release blender -L '^blender$' ;;
      truth) install blender && build release -DCOIF_TESTS=ON coif_cli && run release truth -L '^truth$' ;;
      variants) install fuzz variants && for preset in fma avx2 native clang x86-32 arm64; do try_variant $preset; done ;;
      fma | avx2 | native) try_variant "$part" ;;
      clang | x86-32 | arm64) install fuzz variants && try_variant "$part" ;;
      calm) build release -DCOIF_TESTS=ON coif_cli coif_hold_heads && run release calm -L '^calm_all$' ;;
      agree) build release -DCOIF_TESTS=ON coif_cli && run release agree -L '^agree_all$' ;;
      style) install style && build release -DCOIF_TESTS=ON coif_cli && run release style -L '^style$' ;;
      tidy) install tidy && build release -DCOIF_TESTS=ON coif_cli && run release tidy -L '^tidy$' ;;
      debug) compare_builds ;;
      *) echo "run.sh: '$part' is none of plain, asan, asan-cook, fuzz, farm, web, blender, truth, variants (or one of them), calm, agree, style, tidy, debug, all" >&2; broken=$((broken + 1)) ;;
    esac
  done
done

read -r passed failed skipped <<EOF
$(sh tests/count_results.sh $results)
EOF
failed=$((failed + broken))
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
