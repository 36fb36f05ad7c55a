#!/bin/sh
# Builds the fuzzers and runs each for a while: tests/fuzz/fuzz.sh [SECONDS_PER_TARGET] [JOBS] [TARGET...]
# 60 seconds, one target at a time, all targets where none is named. One line of figures for each; exits with 1 where
# anything crashed, hung for 10 s or took over 1 GiB. COIF_FUZZ_WORK: the folder for logs, findings and grown corpora.
set -u
cd "$(dirname "$0")/../.."
seconds=${1:-60}
jobs=${2:-1}
[ $# -gt 2 ] && shift 2 && targets=$* || targets='asset cache_entry clip fbx_objects gltf_lines groom_stream hair_file manifest model_stream obj_lines recipe tressfx vrm'
build=build/fuzz
work=${COIF_FUZZ_WORK:-$PWD/$build/tests/fuzz/work}

program=fuzz_strands
for target in $targets; do
  case $target in gltf_lines | groom_stream | hair_file | obj_lines | tressfx) ;; *) program=fuzz_readers ;; esac
done
cmake --preset fuzz >/dev/null && cmake --build --preset fuzz --parallel "$(nproc)" --target "$program" || exit 1
echo $targets | tr ' ' '\n' |
  xargs -P "$jobs" -I '{}' sh tests/fuzz/fuzz_one.sh "$PWD/$build/tests/fuzz/$program" '{}' "$seconds" "$work" || exit 1
