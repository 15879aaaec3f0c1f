#!/usr/bin/env bash
# The way of a new user, from nothing: an empty Debian 12 in a scratch folder, HEAD in it, ./dev demo, ./dev test, and
# the time of a cold build. Called by ./dev fresh. Keeps nothing; TAUT_FRESH_KEEP=1 keeps the folder to look at.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

((EUID == 0)) || {
  echo 'dev: fresh needs root (debootstrap, chroot)' >&2
  exit 1
}

readonly suite=bookworm
root=$(mktemp -d "${TMPDIR:-/var/tmp}/taut-fresh.XXXXXX")
chmod 755 "$root" # apt fetches as a user of its own
mounted=()

# shellcheck disable=SC2317 # called by the trap
clean_up() {
  local place
  for place in "${mounted[@]}"; do umount -l "$root$place" || true; done
  if [[ -n ${TAUT_FRESH_KEEP:-} ]]; then
    echo "kept: $root"
  elif grep -q " $root/" /proc/mounts; then
    # Deleting now would reach through the mount into the host.
    echo "dev: something is still mounted below $root; left as it is" >&2
  else
    rm -rf --one-file-system "$root"
  fi
}
trap clean_up EXIT
trap 'exit 130' INT TERM

say() { printf '\n== fresh: %s\n' "$*"; }

# The host's own mirror and settings: whoever runs this may have a local one, or a proxy.
# shellcheck disable=SC2016 # apt's variables, not ours
mirror=$(apt-get indextargets --format '$(REPO_URI) $(CODENAME) $(CREATED_BY)' 2>/dev/null |
  sed -n "s/ $suite Packages\$//p" | head -n 1)
[[ -n $mirror ]] || {
  echo "dev: the host's apt knows no mirror of $suite; run apt-get update first" >&2
  exit 1
}

bootstrap=(debootstrap --variant=minbase)
keyring=/usr/share/keyrings/debian-archive-keyring.gpg
[[ -f $keyring ]] && bootstrap+=(--keyring="$keyring")
[[ $mirror == https:* ]] && bootstrap+=(--include=ca-certificates)
# debootstrap fetches with wget, which does not read apt's settings.
eval "$(apt-config shell http_setting Acquire::http::Proxy https_setting Acquire::https::Proxy)"
[[ -z ${http_setting:-} || $http_setting == DIRECT ]] || export http_proxy=$http_setting
[[ -z ${https_setting:-} || $https_setting == DIRECT ]] || export https_proxy=$https_setting

say "an empty $suite in $root"
"${bootstrap[@]}" "$suite" "$root" "${mirror%/}" >"$root.log" 2>&1 || {
  tail -n 20 "$root.log" >&2
  exit 1
}
rm -f "$root.log"

# apt inside asks where apt outside asks: sources, pins, keys, how to fetch, certificates, names of hosts. Not the rest
# of apt.conf: its hooks call programs that an empty system does not have.
rm -f "$root/etc/apt/sources.list"
for part in sources.list sources.list.d preferences.d trusted.gpg.d keyrings; do
  if [[ -e /etc/apt/$part ]]; then cp -aL "/etc/apt/$part" "$root/etc/apt/"; fi
done
apt-config dump | grep -E '^Acquire::(http|https|Retries|Queue-Mode|Check-Valid-Until|ForceIPv[46])(::| )' \
  >"$root/etc/apt/apt.conf.d/90host" || true
mkdir -p "$root/usr/share/keyrings"
cp -aL /usr/share/keyrings/. "$root/usr/share/keyrings/" 2>/dev/null || true
for part in /usr/local/share/ca-certificates /etc/ssl/certs; do
  [[ -d $part ]] || continue
  mkdir -p "$root$part"
  cp -aL "$part/." "$root$part/" 2>/dev/null || true
done
for part in /etc/resolv.conf /etc/hosts; do
  if [[ -e $part ]]; then cp -L "$part" "$root$part"; fi
done

for place in /proc /sys /dev /dev/pts /dev/shm; do
  [[ -d $root$place ]] || mkdir -p "$root$place"
  if mount --bind "$place" "$root$place" 2>/dev/null; then mounted=("$place" "${mounted[@]}"); fi
done

say "HEAD ($(git rev-parse --short HEAD)) goes in"
mkdir "$root/taut"
git archive HEAD | tar -x -C "$root/taut"

inside() {
  local passed_on=()
  [[ -n ${http_proxy:-} ]] && passed_on+=("http_proxy=$http_proxy")
  [[ -n ${https_proxy:-} ]] && passed_on+=("https_proxy=$https_proxy")
  chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root "${passed_on[@]}" \
    bash -c "cd /taut && $*"
}
minutes() { printf '%d min %02d s' $(($1 / 60)) $(($1 % 60)); }

status=0
begin=$SECONDS
say "./dev demo"
inside ./dev demo || status=1
demo_time=$((SECONDS - begin))

say "cold build of library, program and tests"
begin=$SECONDS
inside './dev setup build test'
setup_time=$((SECONDS - begin))
inside 'rm -rf build /root/.cache/ccache'
begin=$SECONDS
inside ./dev build || status=1
build_time=$((SECONDS - begin))

say "./dev test"
begin=$SECONDS
inside ./dev test || status=1
test_time=$((SECONDS - begin))

say "demo with its packages $(minutes "$demo_time"), test packages $(minutes "$setup_time")," \
  "cold build $(minutes "$build_time") on $(nproc) cores, test $(minutes "$test_time")"
if ((status == 0)); then say "all well"; else say "something failed, see above"; fi
exit "$status"
