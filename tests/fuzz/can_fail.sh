#!/bin/sh
# can_fail.sh PROGRAM WORK: fuzz_one.sh notices the planted bug of the target can_fail, and the command that it prints
# repeats it.
set -u
output=$(sh "$(dirname "$0")/fuzz_one.sh" "$1" can_fail 60 "$2") && { echo "no crash was noticed: $output"; exit 1; }
repeat=$(echo "$output" | sed -n 's/^repeat: //p')
[ -n "$repeat" ] || { echo "no command to repeat the crash: $output"; exit 1; }
$repeat 2>&1 | grep 'broken promise: no input begins with an exclamation mark'
