#!/bin/sh
# count_results.sh FILE...: prints "PASSED FAILED SKIPPED" over JUnit files as ctest writes them. A test that could not
# be started stands there as skipped, beside those that skipped themselves; only the latter count as skipped here, so
# that a program that was never built is a failure. A file that is absent or holds no test counts as one failure.
set -eu
passed=0
failed=0
skipped=0
for file in "$@"; do
  all=$(grep -c '<testcase ' "$file" 2>/dev/null) || all=0
  if [ "$all" -eq 0 ]; then
    echo "count_results: $file: no test ran" >&2
    failed=$((failed + 1))
    continue
  fi
  # grep -c prints 0 and fails where nothing matches.
  good=$(grep -c '<testcase .* status="run"' "$file") || true
  left_out=$(grep -c -e '<skipped message="SKIP_' -e '<testcase .* status="disabled"' "$file") || true
  passed=$((passed + good))
  skipped=$((skipped + left_out))
  failed=$((failed + all - good - left_out))
done
echo "$passed $failed $skipped"
