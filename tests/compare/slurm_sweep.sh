#!/usr/bin/env bash
# A sweep through a real Slurm of this one machine, outside the default suite: tests/compare/slurm_sweep.sh
# Needs root and Debian's slurm-wlm, munge and snakemake. Its table must be that of the same sweep without Slurm, but for the seconds.
set -euo pipefail
source_folder=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
host=$(hostname -s)
mkdir "$work/state" "$work/spool"
cat >"$work/slurm.conf" <<EOF
ClusterName=one
SlurmctldHost=$host
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
AccountingStorageType=accounting_storage/none
ReturnToService=2
NodeName=$host CPUs=$(nproc) RealMemory=2000 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
EOF
export SLURM_CONF=$work/slurm.conf
# munged of the machine, or one for the length of this test.
munged_is_ours=
if ! munge -n >/dev/null 2>&1; then
  install -d -o munge -g munge /run/munge
  runuser -u munge -- /usr/sbin/munged --pid-file=/run/munge/munged.pid
  munged_is_ours=1
fi
stop() {
  for pid in "$work"/slurmd.pid "$work"/slurmctld.pid ${munged_is_ours:+/run/munge/munged.pid}; do
    [ ! -f "$pid" ] || kill "$(cat "$pid")" || true
  done
  sleep 1
  rm -rf "$work"
}
trap stop EXIT
slurmctld
slurmd
sleep 3

sweep=("$source_folder/scripts/sweep" "$source_folder/tests/support/small_layer.toml" --vary md.seed=1:2)
"${sweep[@]}" --out "$work/here" >"$work/here.log" 2>&1
"${sweep[@]}" --out "$work/there" -- --cluster "sbatch --parsable --output=slurm-%j.log" --jobs 4 \
  --group-components runs=4 comparisons=4 --latency-wait 20 >"$work/there.log" 2>&1 || { tail -n 20 "$work/there.log"; exit 1; }
ls "$work"/there/slurm-*.log >/dev/null
/usr/bin/python3 - "$work/here/table.csv" "$work/there/table.csv" <<'EOF'
import csv, sys
tables = [[{k: v for k, v in row.items() if "seconds" not in k} for row in csv.DictReader(open(path))] for path in sys.argv[1:]]
assert tables[0] == tables[1], "the tables differ"
print(f"{len(tables[0])} rows alike with and without Slurm")
EOF
