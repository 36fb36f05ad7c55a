#!/bin/sh
# Installs what is missing, builds, runs every test. The last line is "N passed, N failed, N skipped"; the exit code is
# 0 only when something passed and nothing failed.
#   tests/run.sh [release] [asan] [fuzz] [asan-cook] [debug]   which parts to run; the first three when none is named
# asan repeats, under sanitizers, the tests of what reads foreign bytes or runs in a game; asan-cook those of the cooker, of
# batches and of checks, which take as long again. Drawing and command-line tests are in neither: they would watch the driver,
# and start hundreds of slow processes. fuzz: 10 s of libFuzzer for each reader of foreign bytes, see tests/fuzz/README.md. debug: the
# program, compiled for a debugger, cooks the bytes that the one for release cooks.
set -u
cd "$(dirname "$0")/.."
parts=${*:-release asan fuzz}
jobs=$(nproc)
results=
broken=0

# build PRESET TARGETS...
build() {
  preset=$1
  shift
  cmake --preset "$preset" >/dev/null && cmake --build --preset "$preset" --parallel "$jobs" --target "$@" && return
  echo "run.sh: the build '$preset' broke" >&2
  broken=$((broken + 1))
  return 1
}

# run_folder PRESET FOLDER [ARGUMENTS...]: every test that ctest knows in that folder of the build tree, or some of them.
run_folder() {
  place=build/$1/$2
  shift 2
  file=$PWD/$place/results${*:+.chosen}.xml
  rm -f "$file"
  ctest --test-dir "$place" "$@" --parallel "$jobs" --output-on-failure --output-junit "$file"
  results="$results $file"
}

run_release() { build release all && run_folder release .; }

# sanitize FOLDERS...
sanitize() {
  targets=
  for folder in "$@"; do targets="$targets tests/$folder/all"; done
  build asan $targets || return
  for folder in "$@"; do run_folder asan "tests/$folder"; done
}

# The test that the release leaves out where there is no other build.
compare_builds() {
  build debug coif_cli && build release coif_cli && run_folder release tests/cli -R '^cli[.]builds_cook_alike$'
}

sh tools/install_packages.sh || broken=$((broken + 1))
for part in $parts; do
  case $part in
    release) run_release ;;
    asan) sanitize formats sim import ;;
    asan-cook) sanitize cook pipeline validate ;;
    fuzz) build fuzz fuzzers && run_folder fuzz tests/fuzz ;;
    debug) compare_builds ;;
    *) echo "run.sh: '$part' is none of release, asan, fuzz, asan-cook, debug" >&2; broken=$((broken + 1)) ;;
  esac
done

read -r passed failed skipped <<EOF
$(sh tests/count_results.sh $results)
EOF
failed=$((failed + broken))
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
