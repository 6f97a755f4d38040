#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Does a test fail for every one-token fault of faults.txt? The script makes each fault in a copy of the committed tree,
# builds it, and runs the tests that should see it. Prints a line a fault; exit status 1 when one lives.
#   tests/mutation/run.sh WORK [FIRST [LAST]]      WORK: a folder for the copy and its build
set -eu
work="$1"
first="${2:-1}"
last="${3:-999}"
here="$(cd "$(dirname "$0")" && pwd)"
mkdir -p "$work"
if [ -d "$work/tree" ]; then
  git -C "$work/tree" pull -q --ff-only
else
  git clone -q "$(git -C "$here" rev-parse --show-toplevel)" "$work/tree"
fi
cd "$work/tree"
cmake -S . -B ../build -G Ninja -DCMAKE_BUILD_TYPE=Release -DWELKIN_INSTALL=OFF >"$work/log"
programs="$(awk -F '\t' -v first="$first" -v last="$last" '
  !/^#/ && NF >= 4 && ++n >= first && n <= last { print $4 }' "$here/faults.txt" | sort -u)"
ninja -C ../build $programs >>"$work/log"  # once without a fault
number=0
lived=0
tab="$(printf '\t')"
while IFS="$tab" read -r file from to program filter; do
  case "$file" in ''|'#'*) continue ;; esac
  number=$((number + 1))
  { [ "$number" -ge "$first" ] && [ "$number" -le "$last" ]; } || continue
  FROM="$from" TO="$to" perl -0pi -e '
    my ($from, $to) = @ENV{"FROM", "TO"};
    my $count = () = /\Q$from\E/g;
    die "found $count times: $from\n" if $count != 1;
    s/\Q$from\E/$to/' "$file"
  outcome="LIVES"
  if ! ninja -C ../build "$program" >>"$work/log" 2>&1; then
    outcome="does not compile"
  elif ! "$(find ../build/tests -name "$program" -type f)" --abort $filter >"$work/out" 2>&1; then
    # The last heading: the warning of a test that passes has a heading as well.
    outcome="$(grep -A1 '^-----' "$work/out" | grep -v '^--' | grep ', ' | tail -1 || true)"
  fi
  case "$outcome" in LIVES|"does not compile") lived=1 ;; esac
  printf '%2d  %s: %s -> %s: %s\n' "$number" "$file" "$from" "$to" "$outcome"
  git checkout -q -- "$file"
done <"$here/faults.txt"
exit "$lived"
