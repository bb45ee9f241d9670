#!/usr/bin/env bash
# Installs runmark under a prefix of its own and uses it as a stranger would: the examples are built outside the
# tree with find_package and with pkg-config, and run on a picture.
#   check_install.sh static SOURCE BUILD WORK SAMPLE.pgm   installs what BUILD holds
#   check_install.sh shared SOURCE BUILD WORK SAMPLE.pgm   builds the shared library in WORK first, and checks
#                                                          its SONAME, its exports and what it needs
set -euo pipefail
kind=$1 source=$2 build=$3 work=$4 sample=$5

fail() { echo "check_install: $*" >&2; exit 1; }

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
  so=$lib/librunmark.so
  soname=$(readelf -d "$so" | sed -n 's/.*SONAME.*\[\(.*\)\]/\1/p')
  [[ -e $lib/$soname && $soname =~ ^librunmark\.so\.[0-9]+\.[0-9]+$ ]] || fail "SONAME is '$soname'"
  nm -D --defined-only "$so" | c++filt | sed 's/^[0-9a-f]* [A-Z] //; s/std::__cxx11::/std::/g' | LC_ALL=C sort -u \
    >"$work/exported.txt"
  diff -u "$source/tests/install/exported_symbols.txt" "$work/exported.txt" ||
    fail "the exports differ from tests/install/exported_symbols.txt; if that is meant, copy $work/exported.txt there"
  needed=$(readelf -d "$so" | sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p' | grep -vE '^(libstdc\+\+|libhwy|libm|libgcc_s|libc|ld-linux.*)\.so' || true)
  [[ -z $needed ]] || fail "the library needs $needed"
else
  [[ -f $lib/librunmark.a ]] || fail "no librunmark.a in $lib"
  version=$("$prefix/bin/runmark" --version)
  grep -q "^.TH RUNMARK 1 .*\"$version\"" "$prefix/share/man/man1/runmark.1" || fail "manual page is not of $version"
fi

# A copy elsewhere: nothing of the source tree is in reach.
cp "$source"/examples/{CMakeLists.txt,*.cpp,*.h} "$work/consumer"
cmake -S "$work/consumer" -B "$work/examples" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$prefix" >/dev/null
cmake --build "$work/examples" >/dev/null

PKG_CONFIG_PATH=$lib/pkgconfig pkg-config --print-errors --exists "runmark >= 0.1" || fail "pkg-config"
# Its output is a list of words.
# shellcheck disable=SC2046
"${CXX:-g++}" -std=c++20 "$work/consumer/detect.cpp" -o "$work/detect_by_pkg_config" \
  $(PKG_CONFIG_PATH=$lib/pkgconfig pkg-config --cflags --libs runmark)

export LD_LIBRARY_PATH=$lib
for program in "$work/examples/example_detect" "$work/detect_by_pkg_config" "$work/examples/example_stream_rows"; do
  found=$("$program" "$sample" | cut -d: -f1 | tr '\n' ',')
  [[ $found == "tag36h11 7,tag36h11 42," ]] || fail "$program found '$found'"
done
echo "installed $kind, built with find_package and pkg-config, ran"
