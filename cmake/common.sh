# shellcheck shell=bash
# What ./play and ./test share: Debian packages and building. Sourced by bash.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '%s\n' "$*"; }
die() { printf '%s: %s\n' "${0##*/}" "$*" >&2; exit 1; }

# Prints the lines of packages.txt that belong to the given sections.
packages_of() {
    local section line current=
    while IFS= read -r line; do
        case $line in
            '' | '#'*) continue ;;
            '['*']') current=${line:1:-1}; continue ;;
        esac
        for section in "$@"; do
            [[ $section != "$current" ]] || printf '%s\n' "$line"
        done
    done < "$root/cmake/packages.txt"
}

is_installed() {
    [[ $(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]
}

# apt-get as root, never asking anything, waiting for another package manager to finish.
as_root_apt_get() {
    local become_root=()
    [[ $EUID -eq 0 ]] || become_root=(sudo)
    "${become_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get --yes --quiet \
        -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=300 "$@" < /dev/null
}

# The index is fetched only when it is too old or empty to know the packages.
apt_install() {
    if ! apt-get install --simulate --no-install-recommends "$@" > /dev/null 2>&1; then
        as_root_apt_get update || return 1
    elif as_root_apt_get install --no-install-recommends "$@"; then
        return 0
    else
        say "The package index may be out of date: fetching it and trying once more."
        as_root_apt_get update || return 1
    fi
    as_root_apt_get install --no-install-recommends "$@"
}

# Installs what is missing of the given sections.
install_packages() {
    local line missing=() reasons=()
    command -v apt-get > /dev/null ||
        die "this machine has no apt: install what cmake/packages.txt lists by other means," \
            "then start again with --no-install"
    while IFS= read -r line; do
        is_installed "${line%% *}" && continue
        missing+=("${line%% *}")
        reasons+=("  $line")
    done <<< "$(packages_of "$@")"
    [[ ${#missing[@]} -gt 0 ]] || return 0

    say "These Debian packages are missing and will be installed with apt-get:"
    printf '%s\n' "${reasons[@]}"
    if [[ $EUID -ne 0 ]]; then
        command -v sudo > /dev/null ||
            die "installing needs root, and there is no sudo here: run as root" \
                "'apt-get install --no-install-recommends ${missing[*]}', then start again"
        say "This needs root: sudo may ask for your password."
    fi
    apt_install "${missing[@]}" ||
        die "apt-get could not install the packages; its own message is above." \
            "Without them nothing can be built"
}

# configure_and_build PRESET TARGET...: no target means everything. Quiet until something fails.
configure_and_build() {
    local preset=$1 target_options=() log
    shift
    [[ $# -eq 0 ]] || target_options=(--target "$@")
    if [[ -z ${CMAKE_CXX_COMPILER_LAUNCHER-} ]] && command -v ccache > /dev/null; then
        export CMAKE_CXX_COMPILER_LAUNCHER=ccache
        # Without these, what uses a precompiled header is never found in the cache.
        export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros}
        # Preprocessed, a header whose comments alone have changed looks as before, and the cache
        # hands out a precompiled header that is of the old file: its #pragma once no longer holds.
        export CCACHE_DEPEND=${CCACHE_DEPEND:-1}
    fi
    mkdir -p "$root/build"
    log=$root/build/configure-$preset.log
    (cd "$root" && cmake --preset "$preset") > "$log" 2>&1 || {
        cat "$log" >&2
        die "the build could not be configured; CMake's message is above"
    }
    cmake --build "$root/build/$preset" "${target_options[@]}" ||
        die "the build failed; the compiler's message is above"
}
