#!/usr/bin/env bash
# The way of a new user, from nothing: an empty Debian 12 in a scratch folder, HEAD in it, ./dev demo, ./dev test, the
# time of a cold build; then the package installed in a second empty Debian 12. `fresh.sh package` does the latter alone,
# with the package that ./dev package has made. Called by ./dev fresh. Keeps nothing; TAUT_FRESH_KEEP=1 keeps the folder.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

((EUID == 0)) || {
  echo 'dev: fresh needs root (debootstrap, chroot)' >&2
  exit 1
}
what=${1:-all}
[[ $what == all || $what == package ]] || {
  echo "dev: fresh takes nothing, or the word package, not '$what'" >&2
  exit 2
}

readonly suite=bookworm
work=$(mktemp -d "${TMPDIR:-/var/tmp}/taut-fresh.XXXXXX")
chmod 755 "$work" # apt fetches as a user of its own
readonly user=$work/user builder=$work/builder
mounted=()

# shellcheck disable=SC2317 # called by the trap
clean_up() {
  local place
  for place in "${mounted[@]}"; do umount -l "$place" || true; done
  if [[ -n ${TAUT_FRESH_KEEP:-} ]]; then
    echo "kept: $work"
  elif grep -q " $work/" /proc/mounts; then
    # Deleting now would reach through the mount into the host.
    echo "dev: something is still mounted below $work; left as it is" >&2
  else
    rm -rf --one-file-system "$work"
  fi
}
trap clean_up EXIT
trap 'exit 130' INT TERM

say() { printf '\n== fresh: %s\n' "$*"; }
minutes() { printf '%d min %02d s' $(($1 / 60)) $(($1 % 60)); }

# The host's own mirror and settings: whoever runs this may have a local one, or a proxy.
# shellcheck disable=SC2016 # apt's variables, not ours
mirror=$(apt-get indextargets --format '$(REPO_URI) $(CODENAME) $(CREATED_BY)' 2>/dev/null |
  sed -n "s/ $suite Packages\$//p" | head -n 1)
[[ -n $mirror ]] || {
  echo "dev: the host's apt knows no mirror of $suite; run apt-get update first" >&2
  exit 1
}

# empty_debian ROOT: bootstraps it.
empty_debian() {
  local root=$1 part
  local bootstrap=(debootstrap --variant=minbase)
  local keyring=/usr/share/keyrings/debian-archive-keyring.gpg
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
}

# mount_system ROOT: what programs in it expect of a running system.
mount_system() {
  local place
  for place in /proc /sys /sys/fs/cgroup /dev /dev/pts /dev/shm; do
    [[ -d $1$place ]] || mkdir -p "$1$place"
    if mount --bind "$place" "$1$place" 2>/dev/null; then mounted=("$1$place" "${mounted[@]}"); fi
  done
}

# inside ROOT COMMAND: a command line of bash in it, with nothing of the host's environment but the proxies.
inside() {
  local root=$1 passed_on=()
  shift
  [[ -n ${http_proxy:-} ]] && passed_on+=("http_proxy=$http_proxy")
  [[ -n ${https_proxy:-} ]] && passed_on+=("https_proxy=$https_proxy")
  chroot "$root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root "${passed_on[@]}" bash -c "$*"
}

# try_package FILE: installs it in the system of a user who has nothing else, and works with it.
try_package() {
  say "lintian"
  lintian --fail-on error --display-info --allow-root "$1" || status=1
  say "the package $(basename "$1"), $(stat -c %s "$1") bytes, is installed"
  mount_system "$user"
  cp "$1" "$user/"
  cp cmake/fresh_package.sh "$user/"
  local begin=$SECONDS
  inside "$user" "apt-get update -qq && apt-get install -y -qq --no-install-recommends /taut_*.deb >/install.log 2>&1 ||
    { tail -n 20 /install.log; false; }" || status=1
  package_time=$((SECONDS - begin))
  inside "$user" bash /fresh_package.sh || status=1
}

# try_python FILE: the Python package alone; the program is not there any more.
try_python() {
  say "lintian"
  lintian --fail-on error --allow-root "$1" || status=1
  say "the package $(basename "$1"), $(stat -c %s "$1") bytes, is installed"
  cp "$1" "$user/"
  inside "$user" "apt-get install -y -qq --no-install-recommends /python3-taut_*.deb >/install.log 2>&1 ||
    { tail -n 20 /install.log; false; }" || status=1
  inside "$user" "python3 -c 'import taut; r = taut.run(taut.new(\"mast_section\")); print(r.values[\"D_tube\"]);
assert r.values.D_tube == r.values[\"D_tube\"]'" || status=1
  inside "$user" 'dpkg --verify python3-taut' || status=1
}

status=0
package_time=0
empty_debian "$user"
if [[ $what == package ]]; then
  try_package build/taut_*.deb
  for file in build/python3-taut_*.deb; do
    if [[ -e $file ]]; then try_python "$file"; fi # ./dev python makes it
  done
  say "package with what it depends on installed in $(minutes "$package_time")"
else
  cp -a "$user" "$builder"
  mount_system "$builder"
  say "HEAD ($(git rev-parse --short HEAD)) goes in"
  mkdir "$builder/taut"
  git archive HEAD | tar -x -C "$builder/taut"

  begin=$SECONDS
  say "./dev demo"
  inside "$builder" 'cd /taut && ./dev demo' || status=1
  demo_time=$((SECONDS - begin))

  say "cold build of library, program and tests"
  begin=$SECONDS
  inside "$builder" 'cd /taut && ./dev setup build test'
  setup_time=$((SECONDS - begin))
  inside "$builder" 'cd /taut && rm -rf build /root/.cache/ccache'
  begin=$SECONDS
  inside "$builder" 'cd /taut && ./dev build' || status=1
  build_time=$((SECONDS - begin))

  say "./dev test"
  begin=$SECONDS
  inside "$builder" 'cd /taut && ./dev test' || status=1
  test_time=$((SECONDS - begin))

  say "./dev slurm"
  inside "$builder" 'cd /taut && ./dev slurm' || status=1

  say "./dev package"
  if inside "$builder" 'cd /taut && ./dev package'; then
    try_package "$builder"/taut/build/taut_*.deb
  else
    status=1
  fi

  say "demo with its packages $(minutes "$demo_time"), test packages $(minutes "$setup_time")," \
    "cold build $(minutes "$build_time") on $(nproc) cores, test $(minutes "$test_time")," \
    "package installed in $(minutes "$package_time")"
fi
if ((status == 0)); then say "all well"; else say "something failed, see above"; fi
exit "$status"
