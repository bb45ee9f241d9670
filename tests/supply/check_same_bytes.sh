#!/usr/bin/env bash
# Builds a target again from a copy of the sources in another folder, without a compiler cache: it must have the
# bytes of the first build.
#   check_same_bytes.sh SOURCE BUILD WORK TARGET FILE     FILE is that of TARGET in BUILD
set -euo pipefail
source=$1 build=$2 work=$3 target=$4 file=$5
fail() { echo "check_same_bytes: $*" >&2; exit 1; }

elsewhere="$work/quite another place"
rm -rf "$elsewhere"
mkdir -p "$elsewhere/source"
(cd "$source" && git ls-files -z --cached --others --exclude-standard) |
  while IFS= read -r -d '' name; do [[ -f $source/$name ]] && printf '%s\0' "$name"; done |
  (cd "$source" && tar --null -T - -cf -) | tar -xf - -C "$elsewhere/source"
option() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }
cmake -S "$elsewhere/source" -B "$elsewhere/build" -G Ninja -DCMAKE_BUILD_TYPE="$(option CMAKE_BUILD_TYPE)" \
  -DRUNMARK_TOOLS="$(option RUNMARK_TOOLS)" -DRUNMARK_TESTS=OFF >/dev/null
CCACHE_DISABLE=1 cmake --build "$elsewhere/build" --target "$target" >"$work/build.log" ||
  { cat "$work/build.log"; fail "the second build failed"; }
cmp "$build/$file" "$elsewhere/build/$file" || fail "$file differs: something of the folder or the time is in it"
rm -rf "$elsewhere"
echo "$file: the same bytes"
