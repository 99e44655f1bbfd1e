#!/usr/bin/env bash
# Builds README and docs as a website with a search, in target/site/book. Needs mdbook:
#
#   docs/site.sh [MDBOOK]
#
# The order of the pages is that of the links under "Read on" in the README. Links to files that are no pages lead to the
# repository.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

main() {
  local mdbook=${1:-mdbook} site=target/site repository page
  repository=$(sed -n 's/^repository = "\(.*\)"/\1/p' Cargo.toml)
  rm -rf "$site"
  mkdir -p "$site/src/docs"
  cp README.md CONTRIBUTING.md CHANGELOG.md SECURITY.md "$site/src"
  cp -r docs/*.md docs/pictures docs/foxglove "$site/src/docs"
  for page in "$site"/src/*.md; do
    sed -i -E "s#\]\(\.\./\.\./(actions|releases)#](${repository}/\1#g; s#\]\(((crates|examples|vectors|page|python|tests|LICENSE)[^)]*)#](${repository}/blob/main/\1#g" "$page"
  done
  for page in "$site"/src/docs/*.md; do
    sed -i -E "s#\]\(\.\./((\.[a-z]|ci\.sh|crates|examples|vectors|page|python|release|tests|fuzz|Cargo|_typos|clippy|rustfmt|LICENSE)[^)]*)#](${repository}/blob/main/\1#g" "$page"
  done
  summary >"$site/src/SUMMARY.md"
  cat >"$site/book.toml" <<END
[book]
title = "dobot"
description = "The original Dobot Arm, real or virtual"
language = "en"
[output.html]
git-repository-url = "$repository"
no-section-label = true
END
  "$mdbook" build "$site" >&2
  python3 - "$site/book" <<<"$CHECK"
}

# The pages that the README names, and then the others.
summary() {
  local page
  echo "[dobot](README.md)"
  echo
  for page in $( { sed -n '/^## Read on/,$p' README.md | grep -oE '\]\([A-Za-z/_-]+\.md' | cut -c3- && ls docs/*.md; } |
    awk '!seen[$0]++' | grep -vE '^(vectors|crates|page)/'); do
    echo "- [$(sed -n '/^# /{s///p;q}' "$page")]($page)"
  done
}

# Every link to a file of the site leads to one.
readonly CHECK='
import re, sys
from pathlib import Path
from urllib.parse import unquote
site = Path(sys.argv[1])
lost = set()
pages = [page for page in site.rglob("*.html") if page.name not in ("print.html", "404.html", "toc.html")]
for page in pages:
    for link in re.findall(r"(?:href|src)=\"([^\"#?]+)", page.read_text()):
        if not re.match(r"[a-z]+:", link) and not (page.parent / unquote(link)).exists():
            lost.add(f"{page.relative_to(site)}: {link}")
if lost:
    sys.exit("links that lead nowhere:\n" + "\n".join(sorted(lost)))
print(f"{len(pages)} pages in {site}; every link leads somewhere")
'

main "$@"
