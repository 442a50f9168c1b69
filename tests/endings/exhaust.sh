#!/usr/bin/env bash
# There is no memory from the n-th piece on that a program takes, or none for that piece alone: the
# program says so and ends, or does without it; what was there before is whole, and nothing lies
# beside it.
#   exhaust.sh WORK_FOLDER FAILING_MEMORY LEVEL SCENE QUAOAR_SOLVE QUAOAR SULFURCHAMBER [SULFUR_LAB]
set -euo pipefail
# shellcheck source=tests/endings/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
failing_memory=$2 level=$3 scene=$4 solver=$5 game=$6 sandbox=$7 lab=${8-}
enter_work_folder "$1"
unset DISPLAY WAYLAND_DISPLAY
work=$PWD
older='what was there before'
tried=0 overcome=0

# count COMMAND...: into `taken`, how many pieces of memory it takes.
count() {
    env LD_PRELOAD="$failing_memory" COUNT_TO="$work/count" "$@" > said 2>&1 ||
        fail "status $? with memory enough: $*; $(cat said)"
    taken=$(< "$work/count")
}

# run_short_of N LASTS "FILES" COMMAND...
run_short_of() {
    local status=0 file files
    read -ra files <<< "$3"
    rm -rf run && mkdir run && cd run || exit
    for file in "${files[@]}"; do printf '%s\n' "$older" > "$file"; done
    env LD_PRELOAD="$failing_memory" FAIL_AT="$1" FAIL_LASTS="$2" "${@:4}" > ../said 2>&1 ||
        status=$?
    tried=$((tried + 1))
    if ((status == 0)); then
        overcome=$((overcome + 1))
    else
        ((status < 128)) || fail "status $status without memory $1 (lasts: $2): ${*:4}; $(cat ../said)"
        grep --quiet 'not enough memory' ../said ||
            fail "it does not say what it lacks, $1 (lasts: $2): ${*:4}; $(cat ../said)"
    fi
    for file in "${files[@]}"; do
        printf '%s\n' "$older" | cmp --quiet - "$file" || whole "$file" ||
            fail "without memory $1 it leaves a part of $file: ${*:4}"
    done
    [[ -z $(find . -name "*$unfinished*") ]] ||
        fail "without memory $1 it leaves $(find . -name "*$unfinished*"): ${*:4}"
    cd "$work" || exit
}

# at_many_pieces "FILES" COMMAND...: what the program takes to say its help is before its beginning,
# in which nobody could catch anything.
at_many_pieces() {
    local first last distance
    count "$2" --help
    first=$taken
    count "${@:2}"
    last=$taken
    for ((distance = 1; first + distance < last; distance = distance * 3 + 1)); do
        run_short_of $((first + distance)) 0 "$@"
        run_short_of $((last - distance)) 1 "$@"
    done
}

# Whoever begins beside the exit is there at once.
sed -E 's/("exit": \{"position": )\[[^]]*\]/\1[2.2, 0.3]/' "$level" > near.json
level=$work/near.json at_many_pieces 'way.proof way.way' "$solver" "$work/near.json" --out way.proof --tries 1 --practice 0 --polish 0
at_many_pieces '' "$game" --headless --verify "$level"
[[ -z $lab ]] ||
    at_many_pieces 'a.csv b.json' "$lab" table3 --highest 200 --resolution 1 --seconds 2 \
        --only-explosions --csv a.csv --json b.json
echo "$tried times without memory, $overcome of them overcome"
