#!/usr/bin/env bash
# Arrows run one way: server → index → engine, and inside the engine from the later stage to the
# earlier; a third party's headers stay behind the files that adapt them; text leaves the program
# only where it is made fit to show. Fails on whatever runs back or past, and proves first, on a
# planted tree, that it can fail. The gallery's imports are held by
# web/tests/layering.test.ts.
set -euo pipefail

stages=(core mesh voxel skeleton chain_code matching descriptor ranking registration decomposition)

# Sets `rank` to that of the layer that a path lies in; empty for paths outside the layers (tests).
layer() {
    local i
    rank=
    case $1 in
        engine/*)
            for i in "${!stages[@]}"; do
                [[ $1 == engine/"${stages[i]}"/* ]] && { rank=$i; return; }
            done
            rank=unknown
            ;;
        index/*) rank=50 ;;
        server/*) rank=60 ;;
        tests/*) rank=90 ;;
    esac
}

# header pattern | where it may be included
adapters=(
    'OpenMesh/|^engine/mesh/'
    '(sqlite3|SQLiteCpp)[./]|^index/(store|migrate)'
    'httplib|^server/http_library\.'
    'png\.h|^index/thumbnail/'
    'zstd\.h|^index/packed_bytes'
    'prometheus/|^server/metrics'
    'CLI/|^(index/cli|server)/'
    'nlohmann/|^(index|server)/'
    'tbb/|^engine/core/'
    'zlib\.h|^engine/core/'
    '(Common/NMR_|Model/COM/|tiny_gltf|draco/|seccomp|zip\.h|assimp/)|^index/reader/'
)

# check_tree ROOT: prints each violation; returns 1 when there is one.
check_tree() {
    local root=$1 bad=0 file line included from to rule rank
    while IFS=: read -r file line included; do
        layer "$file"
        from=$rank
        if [[ $included =~ \"([^\"]+)\" ]]; then
            local target=${BASH_REMATCH[1]}
            layer "$target"
            to=$rank
            if [[ $to == unknown ]]; then
                echo "$file:$line: $target lies in no stage of the engine"; bad=1
            elif [[ -n $to && -n $from && $to -gt $from ]]; then
                echo "$file:$line: an arrow runs back: $target"; bad=1
            elif [[ -z $to ]]; then
                echo "$file:$line: write the include from the root of the repository: $target"; bad=1
            fi
        fi
        for rule in "${adapters[@]}"; do
            if [[ $included =~ [\<\"](${rule%%|^*}) && ! $file =~ ^tests/ ]] &&
                ! [[ $file =~ ^(${rule#*|^}) ]]; then
                echo "$file:$line: a third party's header outside its adapter: $included"; bad=1
            fi
        done
    done < <(cd "$root" && grep -rnE '^[[:space:]]*#[[:space:]]*include' --include='*.h' \
        --include='*.cpp' --exclude-dir=build engine index server tests 2> /dev/null || true)
    # Text that others wrote leaves the program in two ways that make it fit to show.
    while IFS=: read -r file line found; do
        [[ $file == index/json_text.h ]] && continue
        echo "$file:$line: JSON is written by json_text alone: $found"; bad=1
    done < <(cd "$root" && grep -rnE '[.>]dump\(' --include='*.h' --include='*.cpp' engine index server \
        2> /dev/null || true)
    while IFS=: read -r file line found; do
        echo "$file:$line: lines for people are written with terminal_format: $found"; bad=1
    done < <(cd "$root" && grep -rnE 'std::c(out|err) << (fmt::format|[a-z_.>]*(name|path|message)\b)' \
        --include='*.cpp' index/cli 2> /dev/null || true)
    # Each folder of the engine is a namespace; core holds the words that all of them share.
    for rule in "${stages[@]:1}"; do
        while read -r file; do
            echo "$file: does not lie in namespace ossuary::$rule"; bad=1
        done < <(cd "$root" && grep -rL --include='*.h' --include='*.cpp' \
            "^namespace ossuary::$rule" "engine/$rule" 2> /dev/null || true)
    done
    return $bad
}

planted=$(mktemp -d)
trap 'rm -rf "$planted"' EXIT
mkdir -p "$planted"/{engine/core,engine/voxel,engine/ranking,index/cli,server,tests}
echo '#include "engine/ranking/ranker.h"' > "$planted/engine/voxel/back.cpp"
echo '#include "server/http.h"' > "$planted/index/back.cpp"
echo '#include <httplib.h>' > "$planted/server/handler.cpp"
echo '#include "result.h"' > "$planted/engine/core/local.cpp"
echo 'namespace ossuary { struct Path; }' > "$planted/engine/voxel/elsewhere.h"
printf '%s\n' '#include "engine/core/result.h"' 'namespace ossuary::voxel {' '}' \
    > "$planted/engine/voxel/fine.cpp"
echo 'write(json.dump(2));' > "$planted/index/writer.cpp"
echo 'std::cerr << fmt::format("{}\n", name);' > "$planted/index/cli/raw.cpp"
echo 'std::cout << model.name;' > "$planted/index/cli/rawer.cpp"
found=$(check_tree "$planted" || true)
for expected in engine/voxel/back.cpp index/back.cpp server/handler.cpp engine/core/local.cpp \
    engine/voxel/elsewhere.h index/writer.cpp index/cli/raw.cpp index/cli/rawer.cpp; do
    grep -q "^$expected:" <<< "$found" || { echo "the check does not see $expected"; exit 1; }
done
! grep -q fine.cpp <<< "$found" || { echo "the check blames fine.cpp"; exit 1; }

check_tree "$1" && echo "no arrow runs back"
