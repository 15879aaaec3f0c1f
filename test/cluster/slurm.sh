#!/usr/bin/env bash
# A study on Slurm, with one node that this script starts from Debian's packages: four shards, one of them killed and
# requeued, then the merge; its summary is that of a run on threads. Called by ./dev slurm, as root; keeps nothing.
#   slurm.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
source=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")
work=$(mktemp -d "${TMPDIR:-/tmp}/taut-slurm.XXXXXX")
chmod 755 "$work"
export SLURM_CONF=$work/slurm.conf
started=()

# shellcheck disable=SC2317 # called by the trap
clean_up() {
  local code=$? pid
  for pid in "${started[@]}"; do kill "$pid" 2>/dev/null || true; done
  if ((code)); then tail -n 15 "$work"/*.log "$work"/study/slurm/*.log >&2 2>/dev/null || true; fi
  rm -rf "$work"
}
trap clean_up EXIT
trap 'exit 130' INT TERM

say() { printf '== slurm: %s\n' "$*"; }

# until_true SECONDS WORDS COMMAND...
until_true() {
  local left=$1 words=$2
  shift 2
  until "$@" >/dev/null 2>&1; do
    ((left-- > 0)) || {
      echo "slurm: $words" >&2
      exit 1
    }
    sleep 1
  done
}

start_munge() {
  munge -n </dev/null >/dev/null 2>&1 && return
  [[ -f /etc/munge/munge.key ]] || mungekey --create
  chown munge: /etc/munge/munge.key
  install -d -o munge -g munge /run/munge /var/log/munge /var/lib/munge
  runuser -u munge -- munged
  until_true 20 'munge does not answer' munge -n </dev/null
}

start_slurm() {
  local node
  node=$(hostname -s)
  mkdir -p "$work/state" "$work/spool"
  cat >"$SLURM_CONF" <<END
ClusterName=taut
SlurmctldHost=$node(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=2
ReturnToService=2
KillWait=2
MpiDefault=none
SlurmctldPort=16817
SlurmdPort=16818
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
NodeName=$node NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
  slurmctld -D >"$work/slurmctld.log" 2>&1 &
  started+=($!)
  slurmd -D -N "$node" >"$work/slurmd.log" 2>&1 &
  started+=($!)
  until_true 60 'the node does not come up' bash -c "sinfo -h -o %T | grep -q idle"
}

# What the threaded run and the cluster calculate: a line with many cases, so that a shard can be caught at work.
write_deck() {
  sed '/^analyses:/,$d' "$source/examples/machines/three_span_skyline.yaml" >"$work/deck.yaml"
  cp "$source/examples/machines/three_span_skyline.csv" "$work/"
  cat >>"$work/deck.yaml" <<'END'
analyses:
  - load_path: {carriage: car, from: 135 m, to: 230 m, steps: 30}
study:
  vary:
    machine.ropes.skyline.stiffness: {normal: {mean: 20 MN, cov: 6 %}}
    machine.loads[0].mass: {uniform: {low: 1 t, high: 2 t}}
  of: [load_path.T_max]
  samples: 4096
END
}

# The state of a task of the array, "RUNNING".
state_of() { squeue -h -o %T -j "$cases"_"$1" 2>/dev/null; }
is_running() { [[ $(state_of "$1") == RUNNING ]]; }
has_part() { (($(find "$work/study/parts" -name '*.h5' | wc -l) > 2)); }
all_ended() { [[ -z $(squeue -h) ]]; }

start_munge
start_slurm
write_deck
say 'on threads'
"$program" study run "$work/deck.yaml" -o "$work/threads" --quiet
say 'four shards'
"$program" study slurm "$work/deck.yaml" -o "$work/study" --throttle 4
# the quarter of an hour of a shard is too long for a test
sed -i -e 's/^#SBATCH --array=.*/#SBATCH --array=1-4/' -e 's|/[0-9]*" --threads|/4" --threads|' "$work/study/slurm/cases.sbatch"
cases=
while read -r line; do
  printf '%s\n' "$line"
done < <(sh -x "$work/study/slurm/submit.sh" 2>&1)
cases=$(squeue -h -o %F -n taut-cases | sort -un | head -n 1)
[[ -n $cases ]]
until_true 120 'no shard runs' is_running 2
until_true 120 'no part is written' has_part
before=$(find "$work/study/parts" -name '*.h5' -printf '%f %T@\n' | sort)
say "requeues shard 2 of job $cases"
scontrol requeue "${cases}_2"
until_true 600 'the jobs do not end' all_ended
after=$(find "$work/study/parts" -name '*.h5' -printf '%f %T@\n' | sort)
[[ -z $(comm -23 <(echo "$before") <(echo "$after")) ]] || {
  echo 'slurm: a part that was written is calculated again' >&2
  exit 1
}
for file in summary.csv series.h5; do cmp "$work/threads/$file" "$work/study/$file"; done
say 'the merged files are those of the threaded run'
