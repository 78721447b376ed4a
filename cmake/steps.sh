# shellcheck shell=bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What ./demo and ./check share: a step is one calm line, its talk goes to a log, which is shown when the step fails.

# step LABEL LOG COMMAND...: runs it; "  LABEL: 12 s". On failure the end of the log, and exit 1.
step() {
    local label=$1 log=$2 began=$SECONDS
    shift 2
    mkdir -p "$(dirname "$log")"
    if ! "$@" >"$log" 2>&1 </dev/null; then
        {
            grep -nE 'error|warning|FAILED|\*\*\*' "$log" | head -40 || true
            echo "  ... end of $log:"
            tail -30 "$log"
            echo "  $label: failed (all of it is in $log)"
        } >&2
        exit 1
    fi
    echo "  $label: $((SECONDS - began)) s"
}

# configure_and_build PRESET [TARGET...] [-- CMAKE-OPTIONS...]
configure_and_build() {
    local preset=$1
    shift
    local targets=() options=()
    while [ $# -gt 0 ] && [ "$1" != -- ]; do
        targets+=(--target "$1")
        shift
    done
    [ $# -gt 0 ] && shift && options=("$@")
    cmake --preset "$preset" "${options[@]}" && cmake --build --preset "$preset" "${targets[@]}"
}
