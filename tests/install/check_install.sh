#!/usr/bin/env bash
# Installs runmark under a prefix of its own and uses it as a stranger would: the examples are built outside the
# tree with find_package and with pkg-config, and run on a picture.
#   check_install.sh static SOURCE BUILD WORK SAMPLE.pgm   installs what BUILD holds
#   check_install.sh shared SOURCE BUILD WORK SAMPLE.pgm   builds the shared library in WORK first, and checks
#                                                          its SONAME, its exports and what it needs
set -euo pipefail
kind=$1 source=$2 build=$3 work=$4 sample=$5

fail() { echo "check_install: $*" >&2; exit 1; }

# SONAME, exports and what it needs: LIBRARY SONAME_VERSION LIST_OF_EXPORTS
check_shared() {
  local so=$lib/$1.so soname needed
  soname=$(readelf -d "$so" | sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p')
  [[ -e $lib/$soname && $soname =~ ^$1\.so\.$2$ ]] || fail "SONAME is '$soname'"
  nm -D --defined-only "$so" | c++filt | sed 's/^[0-9a-f]* [A-Z] //; s/std::__cxx11::/std::/g' | LC_ALL=C sort -u \
    >"$work/$3"
  diff -u "$source/tests/install/$3" "$work/$3" ||
    fail "the exports differ from tests/install/$3; if that is meant, copy $work/$3 there"
  needed=$(readelf -d "$so" | sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p' | grep -vE '^(librunmark(_measure)?|libstdc\+\+|libhwy|libm|libgcc_s|libc|ld-linux.*)\.so' || true)
  [[ -z $needed ]] || fail "$1 needs $needed"
}

prefix=$work/prefix
rm -rf "$prefix" "$work/consumer" "$work/examples"
mkdir -p "$work/consumer"

if [[ $kind == shared ]]; then
  launcher=$(sed -n 's/^CMAKE_CXX_COMPILER_LAUNCHER:[A-Z]*=//p' "$build/CMakeCache.txt")
  cmake -S "$source" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON \
    -DRUNMARK_TOOLS=OFF -DRUNMARK_TESTS=OFF ${launcher:+-DCMAKE_CXX_COMPILER_LAUNCHER="$launcher"} >/dev/null
  cmake --build "$work/build" -- -d stats >"$work/build.log" || { cat "$work/build.log"; fail "shared build failed"; }
  build=$work/build
fi
! grep -q -e '-march=native' "$build/compile_commands.json" || fail "-march=native is in the build"
cmake --install "$build" --prefix "$prefix" >/dev/null
lib=$(dirname "$(find "$prefix" -name pkgconfig -type d)")

if [[ $kind == shared ]]; then
  check_shared librunmark '[0-9]+\.[0-9]+' exported_symbols.txt
  check_shared librunmark_c '[0-9]+' exported_c_symbols.txt
  abi_version=$(sed -n 's/^#define RUNMARK_ABI_VERSION //p' "$prefix/include/runmark/runmark.h")
  [[ -e $lib/librunmark_c.so.$abi_version ]] || fail "the SONAME of librunmark_c is not of ABI version $abi_version"
else
  [[ -f $lib/librunmark.a ]] || fail "no librunmark.a in $lib"
  version=$("$prefix/bin/runmark" --version)
  grep -q "^.TH RUNMARK 1 .*\"$version\"" "$prefix/share/man/man1/runmark.1" || fail "manual page is not of $version"
fi

# A copy elsewhere: nothing of the source tree is in reach.
cp "$source"/examples/{CMakeLists.txt,*.c,*.cpp,*.h} "$work/consumer"
cmake -S "$work/consumer" -B "$work/examples" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$prefix" >/dev/null
cmake --build "$work/examples" >/dev/null

PKG_CONFIG_PATH=$lib/pkgconfig pkg-config --print-errors --exists "runmark >= 0.1" || fail "pkg-config"
# Its output is a list of words.
# shellcheck disable=SC2046
"${CXX:-g++}" -std=c++20 "$work/consumer/detect.cpp" -o "$work/detect_by_pkg_config" \
  $(PKG_CONFIG_PATH=$lib/pkgconfig pkg-config --cflags --libs runmark)

# A C compiler alone: whoever links the static libraries asks pkg-config for what they need.
static=()
if [[ $kind == static ]]; then static=(--static); fi
# shellcheck disable=SC2046
"${CC:-gcc}" -std=c99 -Wall -Wextra -pedantic -Werror "$work/consumer/detect.c" -o "$work/detect_in_c" \
  $(PKG_CONFIG_PATH=$lib/pkgconfig pkg-config --cflags --libs "${static[@]}" runmark_c)

export LD_LIBRARY_PATH=$lib
for program in "$work"/examples/example_{detect,detect_c,stream_rows} "$work"/detect_{by_pkg_config,in_c}; do
  found=$("$program" "$sample" | cut -d: -f1 | tr '\n' ',')
  [[ $found == "tag36h11 7,tag36h11 42," ]] || fail "$program found '$found'"
done

# The parts with needs of their own: a component each.
camera=$work/camera.yml
echo 'camera_matrix: {data: [300, 0, 159.5, 0, 300, 119.5, 0, 0, 1]}' >"$camera"
found=$("$work/examples/example_pose" "$sample" "$camera" 0.1 | cut -d: -f1 | tr '\n' ',')
[[ $found == "tag36h11 7,tag36h11 42," ]] || fail "example_pose found '$found'"
for part in measure print; do
  PKG_CONFIG_PATH=$lib/pkgconfig pkg-config --print-errors --exists "runmark_$part >= 0.1" || fail "pkg-config runmark_$part"
done
echo "installed $kind, built with find_package and pkg-config, ran"
