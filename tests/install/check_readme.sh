#!/usr/bin/env bash
# The programs in README.md are those of examples/, and what a page of ours links to is there.
set -euo pipefail
cd "$1"
check_snippet() { # LANGUAGE FILE: the README's block of the language is what stands between the file's marks
  diff -u <(sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/p" README.md | sed '1d;$d') \
          <(sed -n '/\[readme\]/,/\[readme\]/p' "$2" | sed '1d;$d')
}
check_snippet cpp examples/detect.cpp
check_snippet c examples/detect.c
check_snippet python examples/detect.py
status=0
for page in *.md docs/*.md; do
  while read -r link; do
    [[ -e $(dirname "$page")/$link ]] || { echo "$page links to $link, which is not there" >&2; status=1; }
  done < <(grep -oE '\]\([^)#]+' "$page" | sed 's/^](//' | grep -vE '^(https?|mailto):')
done
exit $status
