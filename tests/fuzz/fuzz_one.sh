#!/bin/sh
# Runs the fuzzer on one target: fuzz_one.sh PROGRAM TARGET SECONDS WORK. Prints one line of figures; where something was
# found, the end of its log and how to repeat it, and exits with 1. WORK/TARGET keeps the log, the findings and what corpus
# grew.
set -u
program=$1
export COIF_FUZZ_TARGET="$2"
name=$2
seconds=$3
here=$(cd "$(dirname "$0")" && pwd)
work=$4/$name
log=$work/log.txt
mkdir -p "$work/corpus" "$work/tmp"

# Before bash's own words: the seeds, findings of old, words of the format.
set -- "$work/corpus"
for folder in "$here/corpus/$name" "$here/regressions/$name"; do
  [ -d "$folder" ] && set -- "$@" "$folder"
done
[ -f "$here/dictionaries/$name.dict" ] && set -- "-dict=$here/dictionaries/$name.dict" "$@"
TMPDIR=$work/tmp "$program" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=1024 -malloc_limit_mb=256 \
  -max_len=65536 -print_final_stats=1 -artifact_prefix="$work/" "$@" >"$log" 2>&1
code=$?

figure() { sed -n "s/.*$1 *\([0-9][0-9]*\).*/\1/p" "$log" | tail -n 1; }
executions=$(figure 'number_of_executed_units:')
crashes=0
[ "$code" -eq 0 ] || crashes=1
echo "$name: ${executions:-0} executions, cov $(figure 'cov:'), ft $(figure ' ft:'), corpus $(figure ' corp:')," \
  "$(figure 'peak_rss_mb:') MiB, $seconds s, $crashes crashes"
[ "$crashes" -eq 0 ] && [ "${executions:-0}" -gt 0 ] && exit 0

tail -n 40 "$log"
finding=$(sed -n 's/.*Test unit written to //p' "$log" | tail -n 1)
echo "$name: exit code $code, log $log"
[ -z "$finding" ] || echo "repeat: env COIF_FUZZ_TARGET=$name $program $finding"
exit 1
