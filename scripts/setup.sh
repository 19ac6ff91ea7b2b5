# Sourced by ./start and ./check: installs what is missing and builds. Every function is quick when
# there is nothing to do and says plainly what failed.

say() { printf '\033[1m▸ %s\033[0m\n' "$*" >&2; }
fail() {
    printf '\n\033[31m%s failed: %s\033[0m\n' "${0##*/}" "$*" >&2
    exit 1
}
if [[ ! -t 2 || -n ${NO_COLOR:-} ]]; then
    say() { printf '> %s\n' "$*" >&2; }
    fail() {
        printf '\n%s failed: %s\n' "${0##*/}" "$*" >&2
        exit 1
    }
fi

build_packages=(
    build-essential ca-certificates ccache cmake git ninja-build pkg-config
    lib3mf-dev libassimp-dev libbenchmark-dev libcli11-dev libcpp-httplib-dev libdraco-dev libeigen3-dev libexpected-dev
    libgmock-dev libgtest-dev libmeshoptimizer-dev libnanoflann-dev libopenmesh-dev libpng-dev libspdlog-dev
    libocct-data-exchange-dev libseccomp-dev libsqlite3-dev libsqlitecpp-dev libsystemd-dev libtbb-dev libtinygltf-dev libvalijson-dev libxxhash-dev
    libyaml-cpp-dev libzip-dev libzstd-dev nlohmann-json3-dev prometheus-cpp-dev zlib1g-dev
)
check_packages=(chromium clang-format-14 clang-tidy-14 curl python3 zstd)
sanitizer_packages=(clang-14 libclang-rt-14-dev llvm-14)

# The oldest Node.js that the web tool chain runs on.
node_minimum=20.19.0

as_root() {
    if [[ $(id -u) == 0 ]]; then
        "$@"
    elif command -v sudo > /dev/null; then
        sudo "$@"
    else
        fail "installing packages needs root: run it as root, or install sudo"
    fi
}

# install_packages NAME…: those that are not installed yet, from Debian.
install_packages() {
    local missing=() name
    local installed
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "$@" 2> /dev/null || true)
    for name in "$@"; do
        grep -qx "installed $name" <<< "$installed" || missing+=("$name")
    done
    ((${#missing[@]})) || return 0
    say "installing ${missing[*]}"
    local log
    log=$(mktemp)
    if ! { as_root apt-get update -qq &&
        as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq \
            --no-install-recommends "${missing[@]}"; } > "$log" 2>&1; then
        tail -n 20 "$log" >&2
        rm -f "$log"
        fail "apt-get could not install ${missing[*]}"
    fi
    rm -f "$log"
}

node_is_new_enough() {
    command -v node > /dev/null || return 1
    local found
    found=$(node --version) || return 1
    [[ $(printf '%s\n%s\n' "$node_minimum" "${found#v}" | sort -V | head -n 1) == "$node_minimum" ]]
}

# Debian 12 ships Node.js 18, which is too old for the web tool chain. Where no newer one is on the
# PATH, npm brings one into build/node, for this project alone.
ensure_node() {
    local local_node=$PWD/build/node
    local certificates=/etc/ssl/certs/ca-certificates.crt
    # A Node.js from npm knows its own certificates only; Debian's knows the machine's.
    if [[ -z ${NODE_EXTRA_CA_CERTS:-} && -f $certificates ]]; then
        export NODE_EXTRA_CA_CERTS=$certificates
    fi
    if [[ -d $local_node/bin ]]; then
        PATH=$local_node/bin:$PATH
        export PATH
    fi
    if node_is_new_enough && command -v npm > /dev/null; then return 0; fi
    install_packages nodejs npm
    if node_is_new_enough; then return 0; fi
    say "installing Node.js 22 into build/node"
    local machine
    case $(uname -m) in
        x86_64) machine=x64 ;;
        aarch64) machine=arm64 ;;
        *) fail "no Node.js $node_minimum or newer for $(uname -m): install one and try again" ;;
    esac
    mkdir -p "$local_node/bin"
    (cd "$local_node" && npm install --no-save --no-audit --no-fund --loglevel=error --prefix . \
        "node-linux-$machine@22" npm@10) > build/node.log 2>&1 ||
        { tail -n 20 build/node.log >&2; fail "npm could not bring Node.js 22"; }
    ln -sf "../node_modules/node-linux-$machine/bin/node" "$local_node/bin/node"
    ln -sf ../node_modules/npm/bin/npm-cli.js "$local_node/bin/npm"
    ln -sf ../node_modules/npm/bin/npx-cli.js "$local_node/bin/npx"
    PATH=$local_node/bin:$PATH
    export PATH
    hash -r
    node_is_new_enough || fail "Node.js in build/node does not run (see build/node.log)"
}

# build TARGET…: configures once and builds in build/release.
build() {
    if [[ ! -f build/release/build.ninja ]]; then
        say "configuring build/release"
        cmake --preset release > build/configure.log 2>&1 ||
            { tail -n 30 build/configure.log >&2; fail "cmake could not configure (build/configure.log)"; }
    fi
    say "building $*"
    cmake --build build/release --target "$@" || fail "the build of $*"
}

# The gallery into web/dist, when its sources are newer than what is there.
build_web() {
    install_web
    if [[ -f web/dist/index.html ]] &&
        [[ -z $(find web/src web/index.html web/public web/package.json web/vite.config.ts \
            -newer web/dist/index.html -print -quit 2> /dev/null) ]]; then
        return 0
    fi
    say "building the gallery"
    (cd web && npm run --silent build) > build/web.log 2>&1 ||
        { tail -n 30 build/web.log >&2; fail "the gallery's build (build/web.log)"; }
}

# The gallery's packages, as the lock file says, when that has changed.
install_web() {
    ensure_node
    local stamp=web/node_modules/.ossuary-lock
    cmp -s web/package-lock.json "$stamp" && return 0
    say "installing the gallery's packages"
    (cd web && npm ci --no-audit --no-fund --loglevel=error) > build/npm.log 2>&1 ||
        { tail -n 30 build/npm.log >&2; fail "npm ci in web/ (build/npm.log)"; }
    cp web/package-lock.json "$stamp"
}

# The sample collection: the .off models of Debian's libcgal-demo, unpacked into build/sample/models.
# The package is downloaded and opened, not installed: its demos need a desktop.
unpack_sample() {
    local models=build/sample/models
    [[ -f $models/.complete ]] && return 0
    say "fetching the sample collection (Debian's libcgal-demo)"
    rm -rf build/sample/unpack "$models"
    mkdir -p build/sample/unpack "$models"
    local archive=/usr/share/doc/libcgal-dev/data.tar.gz
    if [[ ! -f $archive ]]; then
        if ! (cd build/sample/unpack && apt-get download -qq libcgal-demo) 2> build/sample.log; then
            as_root apt-get update -qq 2>> build/sample.log || true
            (cd build/sample/unpack && apt-get download -qq libcgal-demo) 2>> build/sample.log ||
                { tail -n 10 build/sample.log >&2; fail "apt-get could not download libcgal-demo"; }
        fi
        dpkg-deb --fsys-tarfile build/sample/unpack/libcgal-demo_*.deb |
            tar -C build/sample/unpack -xf - ./usr/share/doc/libcgal-dev/data.tar.gz ||
            fail "libcgal-demo has no usr/share/doc/libcgal-dev/data.tar.gz"
        archive=build/sample/unpack/usr/share/doc/libcgal-dev/data.tar.gz
    fi
    tar -C "$models" --wildcards --transform 's|.*/||' -xzf "$archive" '*.off' ||
        fail "the sample archive could not be unpacked"
    rm -rf build/sample/unpack
    touch "$models/.complete"
}
