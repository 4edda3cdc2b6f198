# rank --all-pairs shared out by mpirun: the same bytes, and nothing is lost when a process dies.
# In: MPIRUN (empty without the component).
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

# as_one_of SIZE ARG...: the program as mpirun would start process 0 of several, but without mpirun.
as_one_of() {
  OMPI_COMM_WORLD_SIZE=$1 OMPI_COMM_WORLD_RANK=0 "$TANDEM" "${@:2}" >.out 2>.err </dev/null
  status=$?
  out=$(<.out)
  err=$(<.err)
}

polygons 60 >shapes.jsonl
task=(rank --all-pairs shapes.jsonl --samples 64)

# Only all pairs are shared out.
as_one_of 4 rank "$square" shapes.jsonl
that "wrong usage" test "$status" == 2
err_has 'several processes share the work of rank --all-pairs only'
as_one_of 4 rank --all-pairs - -o out.npy
err_has 'cannot share standard input'
as_one_of 1 "${task[@]}" -o one.npy --quiet
that "one process is none" test "$status" == 0
err_empty

# A program without the component beside it says so.
mkdir alone && cp "$TANDEM" alone/tandem
OMPI_COMM_WORLD_SIZE=2 alone/tandem "${task[@]}" -o out.npy >.out 2>.err
status=$?
err=$(<.err)
if [[ ! $err =~ 'cannot open shared object' ]]; then
  echo "the component is installed elsewhere: not tried without it"
else
  that "not without the component" test "$status" == 1
  err_has 'started as one of 2 processes, but cannot work with others: .*TANDEM_BUILD_MPI'
fi
rm -r alone

if [[ -z ${MPIRUN-} ]]; then
  only shapes.jsonl one.npy one.names.txt
  echo "skipped the rest: built without MPI"
  finish
  exit
fi

# team SIZE ARG...: the program under mpirun, more processes than cores if need be.
team() {
  "$MPIRUN" --oversubscribe --allow-run-as-root -n "$1" "$TANDEM" "${@:2}" >.out 2>.err </dev/null
  status=$?
  out=$(<.out)
  err=$(<.err)
}

for size in 2 4; do
  rm -f out.npy out.names.txt
  team "$size" "${task[@]}" -o out.npy
  that "$size processes get through" test "$status" == 0
  that "the bytes of one process from $size" cmp one.npy out.npy
  that "the names of one process from $size" cmp one.names.txt out.names.txt
  that "one of $size speaks" test "$(grep -c 'note: 60 x 60 costs in out.npy' .err)" == 1
  out_empty
done
expect 0 "${task[@]}" -o one.csv --quiet
team 3 "${task[@]}" -o out.csv --quiet
that "a .csv, too" cmp one.csv out.csv
err_empty
only shapes.jsonl one.npy one.names.txt one.csv out.npy out.names.txt out.csv

# What goes wrong before the work begins.
team 2 rank --all-pairs missing.jsonl -o out.npy
that "not read" test "$status" != 0
err_has 'missing\.jsonl'
team 2 "${task[@]}" -o missing/out.npy
that "not written" test "$status" != 0
err_has 'missing/out\.npy\.partial'

# process RANK: the process of the run on out.npy that has this rank.
process() {
  local each
  for each in $(pgrep -x tandem); do
    [[ $(readlink "/proc/$each/cwd") == "$work" ]] || continue
    tr '\0' '\n' <"/proc/$each/environ" 2>/dev/null | grep -qx "OMPI_COMM_WORLD_RANK=$1" && echo "$each"
  done
}
journal_size() { stat -c %s out.npy.partial 2>/dev/null || echo 0; }

# Whichever process dies, the job ends with an error, and the same command completes what was begun.
polygons 100 >shapes.jsonl
expect 0 "${task[@]}" -o one.npy --quiet
for victim in 0 1 2; do
  rm -f out.npy
  "$MPIRUN" --oversubscribe --allow-run-as-root -n 3 "$TANDEM" "${task[@]}" -o out.npy --quiet >.out 2>.err </dev/null &
  job=$!
  while (($(journal_size) < 8000)) && kill -0 "$job" 2>/dev/null; do sleep 0.02; done
  kill -KILL "$(process $victim)"
  wait "$job"
  status=$?
  err=$(<.err)
  that "it fails when process $victim dies" test "$status" != 0
  err_has "process rank $victim .*exited on signal 9"
  that "no matrix" test ! -e out.npy
  kept=$(journal_size)
  that "nothing is lost when process $victim dies" test "$kept" -ge 8000
  if ((victim == 1)); then expect 0 "${task[@]}" -o out.npy; else team 2 "${task[@]}" -o out.npy; fi
  that "the same command gets through" test "$status" == 0
  err_has 'note: going on with out\.npy\.partial: [0-9]+ % are done'
  that "the same bytes after process $victim died" cmp one.npy out.npy
done

# Ctrl-C as mpirun passes it on.
rm -f out.npy
"$MPIRUN" --oversubscribe --allow-run-as-root -n 2 "$TANDEM" "${task[@]}" -o out.npy >.out 2>.err </dev/null &
job=$!
while (($(journal_size) < 8000)) && kill -0 "$job" 2>/dev/null; do sleep 0.02; done
kill -TERM "$job"
wait "$job"
that "an end by signal is no success" test $? != 0
that "and the journal stays" test "$(journal_size)" -ge 8000
team 2 "${task[@]}" -o out.npy
that "the same bytes after the signal" cmp one.npy out.npy

only shapes.jsonl one.npy one.names.txt one.csv out.npy out.names.txt out.csv
finish
