#!/usr/bin/env bash
# SIGINT or SIGTERM in the middle of every long command: it ends within a second and by the signal,
# and each of its files is whole or as it was.
#   interrupt.sh WORK_FOLDER SLOW_DISK LEVEL SCENE QUAOAR_SOLVE QUAOAR SULFURCHAMBER [SULFUR_LAB]
set -euo pipefail
# shellcheck source=tests/endings/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
slow_disk=$2 level=$3 scene=$4 solver=$5 game=$6 sandbox=$7 lab=${8-}
enter_work_folder "$1"
unset DISPLAY WAYLAND_DISPLAY
pid=
trap '[[ -z $pid ]] || kill -KILL $pid 2> /dev/null || true' EXIT
tried=0 slowest=0
older='what was there before'

# Half of the files are there before, with another content.
prepare() {
    cd "$work" || exit
    rm -rf run
    mkdir run
    cd run || exit
    local file nth=0
    for file in "${files[@]}"; do
        mkdir -p "$(dirname "$file")"
        ((nth++ % 2)) || printf '%s\n' "$older" > "$file"
    done
}

# Milliseconds of processor time of all that this shell has waited for.
sum_up() {
    times > "$work/times"
    spent=$(awk 'NR == 2 { for (i = 1; i <= 2; ++i) { split($i, t, "m"); s += 60 * t[1] + t[2] } }
        END { printf "%d", 1000 * s }' "$work/times")
}

# end_by SIGNAL: sends it and judges how much the command goes on to do, and what it leaves. Time on
# the clock, of which others take a part, has a wider bound.
end_by() {
    local began before worked status=0 file
    runs || fail "it has ended by itself before SIG$1: $what; $(cat ../said)"
    sum_up
    before=$spent worked=$(awk -v unit="$(getconf CLK_TCK)" '{ print int(1000 * ($14 + $15) / unit) }' \
        "/proc/$pid/stat" 2> /dev/null) ||
        fail "it has ended by itself, just before SIG$1: $what; $(cat ../said)"
    began=$SECONDS
    kill -s "$1" "$pid"
    while runs; do
        ((SECONDS - began < 10)) || fail "it goes on after SIG$1: $what"
        sleep 0.1
    done
    wait "$pid" || status=$?
    pid=
    sum_up
    took=$((spent - before - worked))
    ((took < 1000)) || fail "it goes on for $took ms after SIG$1: $what"
    ((took <= slowest)) || slowest=$took
    tried=$((tried + 1))
    ((status == 128 + $(kill -l "$1"))) || fail "status $status after SIG$1: $what; $(cat ../said)"
    while IFS= read -r file; do
        [[ " ${files[*]} " == *" $file "* ]] || fail "SIG$1 leaves $file: $what"
        printf '%s\n' "$older" | cmp --quiet - "$file" || whole "$file" ||
            fail "SIG$1 leaves a part of $file: $what"
    done < <(find . -type f -printf '%P\n')
}

end_after() {
    prepare
    hears_signals "${command[@]}" > ../said 2>&1 &
    pid=$!
    sleep "$1"
    end_by "$2"
}
# at_moments "FILES" COMMAND...: the command is long, and is ended at two moments.
at_moments() {
    read -ra files <<< "$1"
    command=("${@:2}") what="${*:2}"
    end_after 0.15 INT
    end_after 0.4 TERM
}

stands_unfinished() { compgen -G "$file$unfinished*" > /dev/null || ! runs; }
end_at_file() {
    prepare
    LD_PRELOAD=$slow_disk SLOW_DISK=200 hears_signals "${command[@]}" > ../said 2>&1 &
    pid=$!
    wait_until 60 stands_unfinished || fail "it does not write $file: $what; $(cat ../said)"
    end_by "$1"
}
# while_writing "FILES" COMMAND...: the command is short, and is ended while it writes each file.
while_writing() {
    read -ra files <<< "$1"
    command=("${@:2}") what="${*:2}"
    local file signal=INT
    for file in "${files[@]}"; do
        end_at_file $signal
        [[ $signal == INT ]] && signal=TERM || signal=INT
    done
}

work=$PWD

at_moments way.proof "$solver" "$level" --out way.proof --tries 64
mapfile -t levels < <(yes "$level" | head -1000)
at_moments '' "$game" --headless --verify "${levels[@]}"
at_moments a.png "$game" --screenshot a.png --level "$level" --at 3600
at_moments a.png "$sandbox" --picture a.png --at 3600 "$scene"
# Whoever begins beside the exit is there at once.
sed -E 's/("exit": \{"position": )\[[^]]*\]/\1[2.2, 0.3]/' "$level" > "$work/near.json"
level=$work/near.json while_writing 'way.proof way.way' "$solver" "$work/near.json" --out way.proof --tries 1 --practice 0 --polish 0
while_writing a.png "$game" --screenshot a.png --level "$level" --at 0.1
while_writing a.png "$sandbox" --picture a.png --at 0.1 "$scene"
[[ -z $lab ]] || {
    for experiment in 'stability' 'stability --battery' 'stability --battery --group random' \
        'stability --battery --group random --shrink' accuracy broadphase bench table2 table3 \
        table4 scaling skip memory; do
        # shellcheck disable=SC2086
        at_moments 'a.csv b.json' "$lab" $experiment --csv a.csv --json b.json --plot plots
    done
    quick=(--highest 200 --resolution 1 --seconds 2 --only-explosions)
    while_writing 'a.csv b.json plots/table3.svg' "$lab" table3 "${quick[@]}" \
        --csv a.csv --json b.json --plot plots
    older='date,version,scene,variant,setting,ms_per_s,error_name,error'
    while_writing history.csv "$lab" bench --quick --scene S4 --engine sulfur --rounds 1 \
        --no-stages --history history.csv
}
echo "$tried interrupted, each within $slowest ms of work"
