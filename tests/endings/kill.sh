#!/usr/bin/env bash
# SIGKILL at random moments, every second time while the program writes. Nothing is lost that was
# saved, nothing is half, and after the next write no stray file is left.
#   kill.sh WORK_FOLDER SLOW_DISK LEVEL QUAOAR_SOLVE QUAOAR SULFURCHAMBER
# runs inside xvfb-run. KILLS=50 in the environment kills each program 50 times; SEED=N repeats.
set -euo pipefail
# shellcheck source=tests/endings/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
slow_disk=$2 first_level=$3 solver=$4 game=$5 sandbox=$6
kills=${KILLS:-2}
RANDOM=${SEED:=$(($$ % 32768))}
enter_work_folder "$1"
pid=
trap '[[ -z $pid ]] || kill -KILL $pid 2> /dev/null || true' EXIT

# some_way_into_writing MILLISECONDS: up to so much later it writes still, or again.
some_way_into_writing() {
    wait_until 60 writes
    pause_up_to "$1"
    wait_until 2 writes || true
}
pause_up_to() { sleep "$(printf '0.%03d' $((RANDOM % $1)))"; }
fast() { exec "$@" > said 2>&1; }
slow() { LD_PRELOAD=$slow_disk SLOW_DISK=250 exec "$@" > said 2>&1; }
# starts writing|anywhere COMMAND...
starts() {
    : > said
    if [[ $1 == writing ]]; then slow "${@:2}" & else fast "${@:2}" & fi
    pid=$!
}
unfinished() { find . -name "*$unfinished*"; }
writes() { [[ -n $(unfinished) ]] || ! runs; }
kill_now() {
    runs || return 1
    [[ -z $(unfinished) ]] || hits=$((hits + 1))
    kill -KILL "$pid" 2> /dev/null || return 1
    wait "$pid" 2> /dev/null || true
    pid=
    killed=$((killed + 1))
}

# --- quaoar_solve: a proof is written over another ------------------------------------------------

solve() { "$1" "$solver" level.json --out way.proof --tries 1 --practice 0 --polish 0 --seed $((RANDOM + 1)); }
solver_begins() {
    level=level.json
    # Whoever begins beside the exit is there at once.
    sed -E 's/("exit": \{"position": )\[[^]]*\]/\1[2.2, 0.3]/' "$first_level" > $level
    (solve fast)
}
solver_is_killed() {
    solve "$([[ $1 == writing ]] && echo slow || echo fast)" &
    pid=$!
    if [[ $1 == writing ]]; then
        some_way_into_writing 300
    else
        pause_up_to 60
    fi
    kill_now || true
    whole way.proof || fail 'the proof is gone or half'
}
solver_writes() { (solve fast) || fail "it does not solve: $(cat said)"; }

# --- quaoar: settings with a best time, and the recording of an attempt ---------------------------

game_settings=config/quaoar/settings.json
recording_is_whole() {
    ! "$solver" "$first_level" --check way.rec > check 2>&1 && grep --quiet 'does not hold' check
}
game_starts() { starts "$1" "$game" --level "$first_level" --size 320x180 --record way.rec; }
plays() { grep --quiet 'begins$' said || ! runs; }
# What is closed keeps its settings and, once it was played, the recording.
game_closes() {
    wait_until 30 plays || fail "it does not begin: $(cat said)"
    sleep 0.3
    kill -TERM "$pid"
}
game_begins() {
    mkdir -p config/quaoar
    echo '{"version": 1, "settings": {"language": "de", "best.01-cold-wake": 12.5}}' \
        > $game_settings
    game_writes
}
game_is_killed() {
    game_starts "$1"
    if [[ $1 == writing ]]; then
        game_closes
        some_way_into_writing 999  # settings, their backup, the recording
    else
        pause_up_to 999
        pause_up_to 999
    fi
    kill_now || true
    whole $game_settings || fail "the settings are half: $(cat $game_settings)"
    for kept in '"language": "de"' '"best.01-cold-wake": 12.5'; do
        grep --quiet "$kept" $game_settings || fail "$kept is lost: $(cat $game_settings)"
    done
    recording_is_whole || fail "the recording is gone or half: $(cat check)"
}
# Where nothing was played yet, nothing is recorded: then once more.
game_writes() {
    touch before
    until [[ way.rec -nt before ]]; do
        game_starts anywhere
        game_closes
        wait "$pid" || fail "it ended with status $?: $(cat said)"
        pid=
    done
}

# --- sulfurchamber: a scene that grows from save to save, and its settings ------------------------

sandbox_settings=config/sulfurchamber/settings.json
bodies() { grep -c '"id"' "$1"; }
sandbox_begins() {
    cat > scene.json <<'E'
{"format": "sulfur-scene", "version": 1,
 "blueprints": {"floor": {"shape": "floor", "from": [-5, 0], "to": [5, 0]}},
 "bodies": [{"id": "floor", "blueprint": "floor"}]}
E
    cp scene.json small.json
    mkdir -p config/sulfurchamber
    echo '{"version": 1, "settings": {"view.strain": true}}' > $sandbox_settings
    echo 'save scene.json' > once
    for _ in {1..200}; do printf 'do drop\nsave scene.json\n'; done > growing
    sandbox_writes
}
sandbox_opened() { xdotool search --onlyvisible --class sulfurchamber > window 2> /dev/null; }
has_grown() { (($(bodies scene.json) > before)) || ! runs; }
sandbox_is_killed() {
    if [[ $1 == writing ]] && ((round % 4 == 3)); then
        settings_are_killed
        return
    fi
    # Not too large, or the saves are most of the time.
    (($(bodies scene.json) < 300)) || cp small.json scene.json
    before=$(bodies scene.json)
    starts "$1" "$sandbox" --script growing scene.json
    wait_until 60 has_grown || fail "nothing is saved: $(cat said)"
    if [[ $1 == writing ]]; then
        some_way_into_writing 500
    else
        pause_up_to 999
    fi
    before=$(bodies scene.json)
    kill_now || fail "it has ended by itself: $(cat said)"
    whole scene.json || fail 'the scene is half'
    (($(bodies scene.json) >= before)) || fail "of $before bodies $(bodies scene.json) are left"
    [[ ! -e scene.json.bak ]] || whole scene.json.bak || fail 'the backup is half'
}
# It notes at once which file was opened.
settings_are_killed() {
    starts writing "$sandbox" scene.json
    some_way_into_writing 700
    kill_now || fail "it has ended by itself: $(cat said)"
    whole $sandbox_settings || fail "the settings are half: $(cat $sandbox_settings)"
    grep --quiet '"view.strain": true' $sandbox_settings || fail 'a setting is lost'
    sandbox_notes
}
sandbox_notes() {
    starts anywhere "$sandbox" scene.json
    wait_until 60 sandbox_opened || fail "no window: $(cat said)"
    xdotool windowfocus "$(tail -1 window)"
    until ! runs; do xdotool key ctrl+q sleep 0.3; done
    wait "$pid" || fail "it ended with status $?: $(cat said)"
    pid=
}
# Opening refuses what is half, too.
sandbox_writes() {
    "$sandbox" --script once scene.json > said 2>&1 || fail "it ended with $?: $(cat said)"
}

for program in solver game sandbox; do
    killed=0 hits=0
    "${program}_begins"
    # Now and then one has ended before.
    for ((round = 1; killed < kills; ++round)); do
        ((round <= 2 * kills)) || fail "$program was seldom there to be killed"
        ((round % 2)) && moment=writing || moment=anywhere
        "${program}_is_killed" "$moment"
        "${program}_writes"
        [[ -z $(unfinished) ]] || fail "left after the next write: $(unfinished)"
    done
    echo "$program: killed $killed times, $hits of them while it wrote"
    ((hits >= kills / 4)) || fail "$program seldom wrote when it was killed"
done
