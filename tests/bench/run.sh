#!/bin/sh
# Builds for release, times everything on one core, adds the medians to results/PROCESSOR.csv and prints them.
#   tests/bench/run.sh [REPETITIONS [FILTER]]     (7, everything)   FILTER: regular expression on benchmark names
# BENCH_BUILD: build folder (build/bench). BENCH_CORE: core to run on (the last). Peers that are not there are left out,
# with a line that says so; none of them is built into or installed with the project.
set -eu
cd "$(dirname "$0")/../.."
repetitions=${1:-7}
filter=${2:-.}
build=${BENCH_BUILD:-build/bench}
core=${BENCH_CORE:-$(($(nproc) - 1))}
bench=$build/tests/bench
results=

cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCOIF_BENCH=ON >/dev/null
cmake --build "$build" --target coif_bench_all
commit=$(git describe --always --dirty)  # of what was built, whatever happens while it is timed

# measure PROGRAM NAME [CORES]: on one core, repetitions of all benchmarks shuffled, so that a slow minute does not hit
# just one.
measure() {
  echo "measuring $2"
  rm -f "$bench/$2.json"
  taskset -c "${3:-$core}" "$1" --benchmark_filter="$filter" --benchmark_repetitions="$repetitions" \
    --benchmark_min_time=0.1 --benchmark_enable_random_interleaving=true --benchmark_report_aggregates_only=true \
    --benchmark_out="$bench/$2.json" --benchmark_out_format=json >/dev/null 2>&1
  results="$results $bench/$2.json"
}

# The registry is asked once; later runs need no network. `npm ci` refuses what does not have the hashes of the lock file.
fetch_spring_bones() {
  command -v npm >/dev/null && command -v node >/dev/null || return 1
  mkdir -p "$bench/peers"
  cp tests/bench/peers/package.json tests/bench/peers/package-lock.json tests/bench/peers/spring_bones.mjs "$bench/peers"
  [ -d "$bench/peers/node_modules" ] || npm ci --prefix "$bench/peers" --ignore-scripts >/dev/null 2>&1
}

measure_spring_bones() {
  echo "measuring three-vrm-springbone"
  taskset -c "$core" node "$bench/peers/spring_bones.mjs" "$repetitions" 120 >"$bench/spring_bones.json"
  results="$results $bench/spring_bones.json"
}

# Measures the build of the preset web, if there is one.
measure_wasm() {
  echo "measuring WebAssembly"
  mkdir -p "$bench/web"
  "$bench/coif_write_workloads" "$bench/web"
  taskset -c "$core" node tests/bench/web/wasm_crowds.mjs build/web/npm "$bench/web" "$repetitions" 120 >"$bench/wasm.json"
  results="$results $bench/wasm.json"
}

measure_cooking() {
  echo "measuring coif cook"
  taskset -c "$core" python3 -B tests/bench/cook_samples.py "$build/tools/cli/coif" 3 >"$bench/cook.json"
  results="$results $bench/cook.json"
}

measure_fused_arithmetic() {
  echo "measuring fused arithmetic"
  taskset -c "$core" python3 -B tests/bench/fused_arithmetic.py "$build" "$repetitions" >"$bench/fused.json"
  results="$results $bench/fused.json"
}

measure "$bench/coif_bench" coif
if [ "$filter" = . ]; then
  if [ "$(nproc)" -gt 1 ]; then measure "$bench/coif_bench_threads" threads "0-$(($(nproc) - 1))"; fi
  measure_fused_arithmetic
  if [ -x "$build/tools/cli/coif" ]; then measure_cooking; fi
  if [ -x "$bench/coif_bench_bullet" ]; then
    measure "$bench/coif_bench_bullet" bullet
  else
    echo "without Bullet: libbullet-dev and pkg-config were not found when the build was configured"
  fi
  if [ -e build/web/npm/coif.wasm ] && command -v node >/dev/null; then
    measure_wasm
  else
    echo "without WebAssembly: no node, or no build/web; 'tests/run.sh web' makes it"
  fi
  if fetch_spring_bones; then
    measure_spring_bones
  else
    echo "without three-vrm-springbone: no node and npm, or the npm registry cannot be reached"
  fi
fi
python3 -B tests/bench/record_results.py "$commit" $results
