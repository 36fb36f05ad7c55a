#!/bin/sh
# Installs what is missing, builds, runs every test. The last line is "N passed, N failed, N skipped"; the exit code is
# 0 only when something passed and nothing failed.
#   tests/run.sh [release] [asan]     which halves to run; both when none is named
# The asan half repeats, under sanitizers, the tests of the parts that read foreign bytes or run in a game. Drawing and
# command-line tests are left out of it: they would watch the driver, and start hundreds of slow processes.
set -u
cd "$(dirname "$0")/.."
halves=${*:-release asan}
sanitized_folders="formats sim import cook"
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

# run_folder PRESET FOLDER: every test that ctest knows in that folder of the build tree.
run_folder() {
  file=$PWD/build/$1/$2/results.xml
  rm -f "$file"
  ctest --test-dir "build/$1/$2" --parallel "$jobs" --output-on-failure --output-junit "$file"
  results="$results $file"
}

run_release() { build release all && run_folder release .; }

run_asan() {
  targets=
  for folder in $sanitized_folders; do targets="$targets tests/$folder/all"; done
  build asan $targets || return
  for folder in $sanitized_folders; do run_folder asan "tests/$folder"; done
}

sh tools/install_packages.sh || broken=$((broken + 1))
for half in $halves; do
  case $half in
    release | asan) "run_$half" ;;
    *) echo "run.sh: '$half' is neither release nor asan" >&2; broken=$((broken + 1)) ;;
  esac
done

read -r passed failed skipped <<EOF
$(sh tests/count_results.sh $results)
EOF
failed=$((failed + broken))
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
