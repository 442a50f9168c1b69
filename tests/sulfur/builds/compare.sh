#!/usr/bin/env bash
# Compares what builds of the library make of one scene: compare.sh NAME=PROGRAM NAME=PROGRAM ...
# All must print what the first prints. A failure names the first tick, the first array and the
# first element that differ.
set -euo pipefail

[[ $# -ge 2 ]] || { echo "compare.sh: needs NAME=PROGRAM at least twice" >&2; exit 2; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The first element in which two builds differ in the tick of that line: its friction and number.
element() {
    local line=$1 ours=$2 theirs=$3 tick
    tick=$(sed -n "${line}p" "$work/first" | cut -d' ' -f2)
    "$ours" "$tick" > "$work/ours"
    "$theirs" "$tick" > "$work/theirs"
    { diff "$work/ours" "$work/theirs" || true; } | sed -n "2p;/^>/{p;q}"
}

first=${1%%=*} reference=${1#*=}
"$reference" > "$work/first"
status=0
for build in "${@:2}"; do
    name=${build%%=*} program=${build#*=}
    "$program" > "$work/other"
    if cmp -s "$work/first" "$work/other"; then
        echo "$name: the same bits as $first"
        continue
    fi
    status=1
    line=$({ cmp "$work/first" "$work/other" || true; } | sed 's/.* line //')
    echo "$name differs from $first, first in this tick:"
    diff <(sed -n "${line}p" "$work/first" | tr '|' '\n') \
         <(sed -n "${line}p" "$work/other" | tr '|' '\n') || true
    echo "and there first in this element:"
    element "$line" "$reference" "$program"
done
exit $status
