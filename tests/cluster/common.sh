# What the tests of rendering on many machines share: sourced by them, in the top folder of the repository.

# A picture of two kinds: a built-in scene, and a file whose samples adapt.
card=(card --size 64x50 --samples 4)
balls=(tests/data/nff/balls_s1.nff --size 40x31 --samples 16 --adaptive 0.05)

# Builds the tool, and the pictures to compare with, made at once on this machine.
prepare_pictures() {
    if [[ -z ${RENDER:-} ]]; then
        cargo build --release --example render
        RENDER=${CARGO_TARGET_DIR:-target}/release/examples/render
    fi
    RENDER=$(realpath -e "$RENDER")
    export RENDER
    "$RENDER" "${card[@]}" -o "$work/expected.png"
    "$RENDER" "${balls[@]}" -o "$work/expected.exr"
}

expect_same() {
    cmp "$1" "$2" || fail "$1 is not the picture that is rendered at once"
}

# By Debian's apt-get, if it can be had; whether it was is for the caller to see.
install() {
    command -v apt-get >/dev/null || return 0
    local as_root=(env)
    [[ $(id -u) -eq 0 ]] || as_root=(sudo -n env)
    "${as_root[@]}" apt-get update || true
    "${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends --no-remove "$@" || true
}

# A program, and the packages that it comes in.
need() {
    local program=$1
    shift
    PATH=$PATH:/usr/sbin # Where servers are.
    command -v "$program" >/dev/null || install "$@"
    command -v "$program" >/dev/null || fail "there is no $program: install $*"
}

fail() {
    echo "$0: $*" >&2
    exit 1
}
