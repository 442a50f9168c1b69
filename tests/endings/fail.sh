#!/usr/bin/env bash
# The disk is full at the n-th thing that a program does to its files, for every n: the program says
# so and does not claim success, what was there before is whole, and nothing lies beside it.
#   fail.sh WORK_FOLDER FAILING_DISK LEVEL SCENE QUAOAR_SOLVE QUAOAR SULFURCHAMBER [SULFUR_LAB]
# runs inside xvfb-run.
set -euo pipefail
# shellcheck source=tests/endings/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
failing_disk=$2 level=$3 scene=$4 solver=$5 game=$6 sandbox=$7 lab=${8-}
enter_work_folder "$1"
work=$PWD
older='what was there before'
tried=0

# at_every_file "FILES" COMMAND...: the files are there before, unless the command reads one.
at_every_file() {
    local files status file n
    read -ra files <<< "$1"
    shift
    for ((n = 1;; ++n)); do
        ((n < 100)) || fail "it does not end to write: $*"
        rm -rf run && mkdir run && cd run || exit
        for file in "${files[@]}"; do
            mkdir -p "$(dirname "$file")"
            if [[ -e ../$file ]]; then cp "../$file" "$file"; else printf '%s\n' "$older" > "$file"; fi
            cp "$file" "../$(basename "$file").before"
        done
        status=0
        LD_PRELOAD=$failing_disk FAIL_BELOW=$work/run FAIL_AT=$n "$@" > ../said 2>&1 || status=$?
        if [[ ! -e failed ]]; then
            ((status == 0)) || fail "status $status although nothing failed: $*; $(cat ../said)"
            cd "$work" && return
        fi
        tried=$((tried + 1))
        if [[ $(cat failed) == linking* ]]; then  # a file system without links: it is copied
            ((status == 0)) || fail "status $status after $(cat failed) ($n): $*; $(cat ../said)"
        else
            ((status > 0 && status < 128)) ||
                fail "status $status after $(cat failed) ($n): $*; $(cat ../said)"
            [[ -s ../said ]] || fail "it says nothing of $(cat failed) ($n): $*"
        fi
        for file in "${files[@]}"; do
            cmp --quiet "$file" "../$(basename "$file").before" || whole "$file" ||
                fail "$(cat failed) ($n) leaves a part of $file: $*"
        done
        [[ -z $(find . -name "*$unfinished*") ]] ||
            fail "$(cat failed) ($n) leaves $(find . -name "*$unfinished*"): $*"
        cd "$work" || exit
    done
}

# Whoever begins beside the exit is there at once.
sed -E 's/("exit": \{"position": )\[[^]]*\]/\1[2.2, 0.3]/' "$level" > near.json
echo 'save scene.json' > once
cp "$scene" scene.json
level=$work/near.json at_every_file 'way.proof way.way' "$solver" "$work/near.json" --out way.proof --tries 1 --practice 0 --polish 0
at_every_file a.png "$game" --screenshot a.png --level "$level" --at 0.1
at_every_file a.png "$sandbox" --picture a.png --at 0.1 "$scene"
at_every_file scene.json "$sandbox" --script "$work/once" scene.json
[[ -z $lab ]] ||
    at_every_file 'a.csv b.json plots/table3.svg' "$lab" table3 --highest 200 --resolution 1 \
        --seconds 2 --only-explosions --csv a.csv --json b.json --plot plots
echo "$tried times the disk was full"
