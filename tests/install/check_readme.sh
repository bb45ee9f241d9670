#!/usr/bin/env bash
# The C++ of README.md is that of examples/detect.cpp, and what a page of ours links to is there.
set -euo pipefail
cd "$1"
diff -u <(sed -n '/^```cpp$/,/^```$/p' README.md | sed '1d;$d') \
        <(sed -n '/\[readme\]/,/\[readme\]/p' examples/detect.cpp | sed '1d;$d')
status=0
for page in *.md docs/*.md; do
  while read -r link; do
    [[ -e $(dirname "$page")/$link ]] || { echo "$page links to $link, which is not there" >&2; status=1; }
  done < <(grep -oE '\]\([^)#]+' "$page" | sed 's/^](//' | grep -vE '^(https?|mailto):')
done
exit $status
