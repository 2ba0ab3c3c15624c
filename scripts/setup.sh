#!/usr/bin/env bash
# Installs the Debian packages that are missing; does nothing where none is.
# Usage: scripts/setup.sh [GROUP]    GROUP: also the packages of that group in packages.txt (checks)
set -euo pipefail

list="$(dirname "${BASH_SOURCE[0]}")/packages.txt"
mapfile -t needed < <(awk -v group="${1:-}" '!/^#/ && NF && (NF == 1 || $2 == group) { print $1 }' "$list")

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "setup: this is not Debian, so nothing is installed here. What the build needs, by its Debian names:" >&2
  echo "  ${needed[*]}" >&2
  exit 0
fi

# 'ii' is a package both wanted and installed; dpkg-query complains of names that it has never seen.
installed="$(dpkg-query -W -f='${db:Status-Abbrev}${Package}\n' "${needed[@]}" 2>/dev/null || true)"
missing=()
for package in "${needed[@]}"; do
  grep -qxF "ii $package" <<<"$installed" || missing+=("$package")
done
((${#missing[@]})) || exit 0

as_root=()
if [[ $EUID -ne 0 ]]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: these packages are missing, and neither root nor sudo is at hand. As root, run:" >&2
    echo "  apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
  [[ -t 0 ]] || as_root+=(-n)  # with nobody to type a password, fail rather than wait
fi

echo "setup: installing ${missing[*]}"
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o Dpkg::Use-Pty=0)
"${apt[@]}" update || echo "setup: apt-get update failed; going on with the package lists that are here" >&2
if ! "${apt[@]}" install -y --no-install-recommends "${missing[@]}"; then
  echo "setup: apt-get could not install: ${missing[*]}" >&2
  echo "setup: the message above says why; the packages are those of Debian 12 (bookworm)" >&2
  exit 1
fi
