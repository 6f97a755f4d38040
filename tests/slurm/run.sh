#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Bakes a level by tools/slurm on a Slurm of its own on this machine, and compares with a bake in one process.
#   tests/slurm/run.sh WELKIN WORK        needs root and what tools/setup.sh --tests unpacks; without: status 77
# ROOT: a folder with Debian's slurmctld, slurmd and slurm-client, unpacked (default: build/slurm); empty: installed.
set -eu
welkin=$(readlink -f "$1")
rm -rf "$2"
mkdir -p "$2"
work=$(cd "$2" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
root=${ROOT-$(cd "$here/../.." && pwd)/build/slurm}
export PATH="$root/usr/bin:$root/usr/sbin:$PATH"
export LD_LIBRARY_PATH="$root/usr/lib/x86_64-linux-gnu:$root/usr/lib/x86_64-linux-gnu/slurm-wlm"
plugins="$root/usr/lib/x86_64-linux-gnu/slurm-wlm"
if ! command -v slurmctld-wlm >/dev/null || [ "$(id -u)" -ne 0 ]; then
  echo "skipped: no Slurm here, or not root"
  exit 77
fi

mkdir "$work/state" "$work/spool"
host=$(hostname -s)
export SLURM_CONF="$work/slurm.conf"
cat >"$SLURM_CONF" <<CONF
ClusterName=welkin
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/none
CredType=cred/none
PluginDir=$plugins
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SlurmUser=root
SlurmdUser=root
SlurmdParameters=config_overrides
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
ReturnToService=2
SchedulerParameters=batch_sched_delay=0,sched_interval=1
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=bake Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
# Without this slurmd wants /sys/fs/cgroup, which a bare root has not.
echo "CgroupPlugin=cgroup/v1" >"$work/cgroup.conf"
slurmctld-wlm -D -c >"$work/slurmctld.log" 2>&1 &
controller=$!
slurmd-wlm -D -d "$root/usr/sbin/slurmstepd-wlm" >"$work/slurmd.log" 2>&1 &
node=$!
trap 'kill $controller $node 2>/dev/null || true' EXIT
tries=0
until sinfo -h -o %T 2>/dev/null | grep -q idle; do
  tries=$((tries + 1))
  [ $tries -lt 60 ] || { cat "$work/slurmctld.log" "$work/slurmd.log"; echo "skipped: Slurm does not start here"; exit 77; }
  sleep 1
done

# The jobs run in the folder that sbatch is called from.
cd "$work"
level="$here/../../examples/island/level.toml"
merge=$(WELKIN=$welkin SBATCH_OPTIONS="--ntasks=1 --cpus-per-task=1" \
  "$here/../../tools/slurm/bake_level.sh" "$level" "$work/farm" 3 --quality draft --certify none)
tries=0
while squeue -h -j "$merge" 2>/dev/null | grep -q .; do
  tries=$((tries + 1))
  [ $tries -lt 600 ] || { squeue; exit 1; }
  sleep 1
done
[ -f "$work/farm/level.welkin" ] || { echo "no index"; cat "$work"/slurm-*.out; exit 1; }
"$welkin" bake "$level" -o "$work/one" --progress none --quality draft --certify none 2>/dev/null
for file in sky.welkin level.welkin sectors; do
  diff -r "$work/one/$file" "$work/farm/$file"
done
echo "the same bytes by 3 jobs and by one process: $(find "$work/farm/sectors" -name '*.welkin' | wc -l) sectors"
