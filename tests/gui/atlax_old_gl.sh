#!/usr/bin/env bash
# On a display that offers less than OpenGL 3.3, each backend ends with a sentence that says so.
#   atlax_old_gl.sh WORK_FOLDER EXAMPLE...
set -euo pipefail
# shellcheck source=tests/gui/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
work=$1
shift
enter_work_folder "$work"

for example in "$@"; do
    for version in 2.1 3.0; do
        status=0
        MESA_GL_VERSION_OVERRIDE=$version timeout 30 "$example" --seconds 1 > said 2> log || status=$?
        [[ $status -eq 1 ]] || fail "$example: ended with $status instead of 1: $(cat said log)"
        [[ ! -s said ]] || fail "$example: the application was started: $(cat said)"
        [[ $(grep --count 'OpenGL 3.3' log) -eq 1 ]] || fail "$example: said '$(cat log)'"
        cat log
    done
done
