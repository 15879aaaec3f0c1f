#!/usr/bin/env bash
# Run by fresh.sh in an empty Debian 12 in which only the package of taut is installed: the first deck of README.md and
# an example, as root and as nobody, the man page, a completion. No source tree and no compiler are there.
set -euo pipefail
readonly doc=/usr/share/doc/taut

say() { printf -- '-- %s\n' "$*"; }
fail() {
  printf 'fresh: %s\n' "$*" >&2
  exit 1
}
# expect CODE COMMAND..: the exit code of a command.
expect() {
  local wanted=$1 code=0
  shift
  "$@" || code=$?
  [[ $code == "$wanted" ]] || fail "exit code $code, not $wanted: $*"
}

[[ ! -e /usr/bin/c++ ]] || fail 'a compiler is installed: this system is not empty'
taut --version
dpkg --verify taut
[[ $(dpkg-query -W -f '${Version}' taut) == "$(taut --version | cut -d ' ' -f 2)-1" ]] || fail 'another version'

first_look() {
  local folder=$1
  shift
  mkdir -m 777 "$folder"
  # the first deck of the page
  awk '/^```yaml$/ {inside = 1; next} /^```$/ && inside {exit} inside' $doc/README.md >"$folder/mast.yaml"
  cd "$folder"
  say "the first deck of README.md as $*"
  expect 0 "$@" taut run mast.yaml
  expect 0 "$@" taut run mast.yaml -o out --quiet
  grep -q '</html>' out/report.html || fail 'the report is not whole'
  expect 0 "$@" taut run $doc/examples/mast_section.yaml -o example --quiet
  expect 0 "$@" taut check $doc/examples/machines/running_skyline.yaml --quiet
  "$@" taut new closed_loop | "$@" taut run - --quiet
  # without Chromium there is no PDF, and this is said
  expect 5 "$@" taut run mast.yaml -o out --pdf --quiet 2>message
  grep -q 'package chromium' message || fail 'no word about Chromium'
  [[ -s out/result.json && ! -e out/report.pdf ]] || fail 'the result without its PDF'
}
first_look /tmp/root env
first_look /tmp/nobody setpriv --reuid=nobody --regid=nogroup --clear-groups env HOME=/nonexistent

say 'every example reads without a mistake'
for deck in "$doc"/examples/*.yaml "$doc"/examples/*/*.yaml; do
  [[ $deck == *.part.yaml ]] || expect 0 taut check "$deck" --quiet
done

if [[ -e /usr/share/taut/page/site/index.html ]]; then
  say 'taut serve'
  taut serve $doc/examples >/tmp/address 2>/tmp/said &
  server=$!
  until [[ -s /tmp/address ]]; do
    kill -0 $server || fail "no server: $(cat /tmp/said)"
    sleep 0.1
  done
  [[ $(cat /tmp/address) =~ ^http://(127.0.0.1:([0-9]+))(/\?token=.*)$ ]] || fail 'no address'
  exec 3<>"/dev/tcp/127.0.0.1/${BASH_REMATCH[2]}"
  printf 'GET %s HTTP/1.1\r\nHost: %s\r\n\r\n' "${BASH_REMATCH[3]}" "${BASH_REMATCH[1]}" >&3
  grep -q data-served <&3 || fail 'no page'
  exec 3>&-
  kill -TERM $server
  expect 0 wait $server
fi

say 'dpkg -i over itself'
dpkg -i /taut_*.deb >/dev/null

say 'completion'
# shellcheck disable=SC1091 # installed by the package
source /usr/share/bash-completion/completions/taut
COMP_WORDS=(taut new closed_) COMP_CWORD=2
_taut
[[ ${COMPREPLY[*]} == closed_loop ]] || fail "completed '${COMPREPLY[*]}'"

say 'man taut'
apt-get install -y -qq --no-install-recommends man-db >/dev/null 2>&1
man -P cat taut >/tmp/page
grep -q 'taut run DECK' /tmp/page || fail 'no man page'
[[ $(whatis taut) == taut*rope-driven* ]] || fail "whatis: $(whatis taut)"

say 'removed without a trace'
dpkg --purge taut >/dev/null
[[ ! -e $doc && ! -e /usr/bin/taut && ! -e /usr/share/taut ]] || fail 'something is left'
