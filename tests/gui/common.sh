# shellcheck shell=bash
# What the scripts of this folder share. They run inside xvfb-run and work in a folder of their
# own, which they get as their first argument.

fail() { printf 'FAILED: %s\n' "$*" >&2; exit 1; }

# Leaves the user's settings and sound alone, and starts in an empty folder.
enter_work_folder() {
    rm -rf "$1"
    mkdir -p "$1"
    cd "$1" || exit
    export XDG_CONFIG_HOME=$PWD/config XDG_DATA_HOME=$PWD/data XDG_CACHE_HOME=$PWD/cache
    export XDG_STATE_HOME=$PWD/state
    export ALSOFT_DRIVERS=null SDL_VIDEODRIVER=x11 GDK_BACKEND=x11 NO_AT_BRIDGE=1
    export GSETTINGS_BACKEND=memory
}

# wait_until SECONDS COMMAND...: tries ten times a second.
wait_until() {
    local end=$((SECONDS + $1))
    shift
    until "$@"; do
        [[ $SECONDS -lt $end ]] || return 1
        sleep 0.1
    done
}

take_picture() { import -window root "$1"; }
colours_of() { identify -format '%k' "$1"; }

# pixels_like PICTURE COLOUR WIDTHxHEIGHT+X+Y: how many pixels of a part have nearly this colour.
pixels_like() {
    convert "$1" -crop "$3" -fuzz 18% -fill black +opaque "$2" -fill white +opaque black \
        -format '%[fx:round(mean*w*h)]' info:
}

# changed_pixels PICTURE PICTURE: how many pixels differ clearly.
changed_pixels() {
    { compare -metric AE -fuzz 8% "$1" "$2" null: 2>&1 || true; } | awk '{ printf "%d", $1 }'
}
