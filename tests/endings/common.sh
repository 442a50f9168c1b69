# shellcheck shell=bash
# What the scripts of this folder share, beside those of tests/gui.
# shellcheck source=tests/gui/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/../gui/common.sh"

# Every name that a file has while it is written begins like this after the file's own.
unfinished=.new

# whole FILE: whether nothing of the file is missing.
whole() {
    case ${1%.bak} in
        *.csv) sed 's/"[^"]*"//g' "$1" | awk -F, 'NR == 1 { n = NF } NF != n { exit 1 }' &&
            ends_with "$1" $'\n' ;;
        *.json) [[ $(head -c 1 "$1") == '{' ]] && ends_with "$1" $'}\n' ;;
        *.svg) ends_with "$1" $'</svg>\n' ;;
        *.png) identify "$1" > /dev/null 2>&1 ;;
        *.proof) "$solver" "$level" --check "$1" 2> /dev/null ;;
        *.way) ends_with "$1" $'\nend\n' ;;
        *) false ;;
    esac
}
ends_with() { tail -c ${#2} "$1" | cmp --quiet - <(printf %s "$2"); }

# Without an own group of jobs a script's children would not hear SIGINT.
hears_signals() { exec env --default-signal=HUP,INT,TERM "$@"; }

runs() { kill -0 "$pid" 2> /dev/null; }
