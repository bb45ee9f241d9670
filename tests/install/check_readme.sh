#!/usr/bin/env bash
# The C++ of README.md is that of examples/detect.cpp, and every file that the README links to is there.
set -euo pipefail
cd "$1"
diff -u <(sed -n '/^```cpp$/,/^```$/p' README.md | sed '1d;$d') \
        <(sed -n '/\[readme\]/,/\[readme\]/p' examples/detect.cpp | sed '1d;$d')
status=0
for link in $(grep -oE '\]\([^)#]+' README.md | sed 's/^](//' | grep -v '^https\?:'); do
  [[ -e $link ]] || { echo "README.md links to $link, which is not there" >&2; status=1; }
done
exit $status
