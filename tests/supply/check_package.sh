#!/usr/bin/env bash
# Makes the Debian package, installs it under a root of its own, runs what was installed and removes it: nothing may
# be left.
#   check_package.sh BUILD WORK SAMPLE.pgm
set -euo pipefail
build=$1 work=$2 sample=$3
fail() { echo "check_package: $*" >&2; exit 1; }

rm -rf "$work"
mkdir -p "$work"
cpack --config "$build/CPackConfig.cmake" -B "$work" >"$work/cpack.log" 2>&1 ||
  { cat "$work/cpack.log"; fail "no package was made"; }
package=$(find "$work" -maxdepth 1 -name '*.deb')
[[ -f $package ]] || fail "there is not just one package: '$package'"

version=$("$build/bin/runmark" --version)
[[ $(dpkg-deb -f "$package" Package) == runmark ]] || fail "its name is not runmark"
[[ $(dpkg-deb -f "$package" Version) == "${version##* }" ]] || fail "its version is not that of '$version'"
# Whoever has built it has all that it needs.
dpkg-deb -f "$package" Depends | tr ',' '\n' | sed 's/ *(.*//; s/^ *//' | while read -r needed; do
  dpkg-query -W -f '${db:Status-Status}\n' "$needed" 2>/dev/null | grep -qx installed || fail "it needs $needed, which is not installed"
done

root=$work/root
mkdir -p "$root/var/lib/dpkg/"{info,updates} "$root/var/log"
touch "$root/var/lib/dpkg/status"
in_root() { dpkg --root="$root" --force-not-root --force-depends --force-script-chrootless --log=/dev/null "$@" >>"$work/dpkg.log" 2>&1; }
in_root --install "$package" || { cat "$work/dpkg.log"; fail "it cannot be installed"; }
found=$("$root/usr/bin/runmark" detect "$sample" --dict tag36h11 --format jsonl)
[[ $found == *'"id":7'* && $found == *'"id":42'* ]] || fail "the installed program found '$found'"
"$root/usr/bin/runmark-view" --help >/dev/null || fail "the installed window does not start"
[[ -f $root/usr/share/man/man1/runmark.1 && -f $root/usr/include/runmark/detector.h ]] || fail "files are missing"

in_root --purge runmark || { cat "$work/dpkg.log"; fail "it cannot be removed"; }
left=$(find "$root" -path "$root/var/lib/dpkg" -prune -o ! -type d -print)
[[ -z $left ]] || fail "it leaves behind: $left"
echo "$(basename "$package"): installed, run, removed"
