# rank --all-pairs: the matrix, whatever interrupts the run that makes it.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

polygons 6 >few.jsonl
printf '{"type": "bspline", "degree": 1, "points": [[0,0],[1,2],[4,4]], "name": "open"}\n' >>few.jsonl
polygons 70 >many.jsonl
many=(rank --all-pairs many.jsonl --samples 64)

# The matrix: names, zeros on the diagonal, symmetric, nothing where an open curve meets a closed one.
expect 0 rank --all-pairs few.jsonl -o few.csv
out_empty
err_has 'note: 7 x 7 costs in few\.csv'
that "the names" test "$(head -1 few.csv)" == ",polygon 1,polygon 2,polygon 3,polygon 4,polygon 5,polygon 6,open"
that "an open curve" test "$(tail -1 few.csv)" == "open,,,,,,,0"
that "symmetric" awk -F, 'NR > 1 { for (k = 2; k <= NF; ++k) cost[NR, k + 0] = $k; n = NR }
  END { for (i = 2; i <= n; ++i) for (k = 2; k <= n; ++k) if (cost[i, k] != cost[k, i]) exit 1
        for (i = 2; i <= n; ++i) if (cost[i, i] != "0") exit 1; exit !(cost[2, 3] > 0) }' few.csv
expect 0 rank --all-pairs few.jsonl -o few.npy --quiet
err_empty
that "7 x 7 numbers after the head" test "$(stat -c %s few.npy)" == $((128 + 7 * 7 * 8))
that "the head" grep -qa "NUMPY.*{'descr': '<f8', 'fortran_order': False, 'shape': (7, 7), }" few.npy
that "a cost of the .csv" test "$(od -A n -t f8 -j 136 -N 8 few.npy | awk '{ printf "%.6f", $1 }')" == \
  "$(awk -F, 'NR == 2 { printf "%.6f", $3 }' few.csv)"
that "the names beside it" test "$(head -1 few.names.txt)" == $'polygon 1\t'
that "what rank says" test "$(awk -F, 'NR == 2 { printf "%.6f", $3 }' few.csv)" == "$(
  "$TANDEM" index few.jsonl -o few.tdx --quiet && "$TANDEM" rank few.tdx#0 few.tdx --quiet | awk '/polygon 2/ { print $2 }')"
expect 0 rank --all-pairs few.tdx -o again.csv --threads 3 --quiet
that "the same from an index" cmp few.csv again.csv
only few.jsonl many.jsonl few.csv few.npy few.names.txt few.tdx again.csv
rm few.npy few.names.txt few.tdx again.csv

# What an undisturbed run makes of many.
expect 0 "${many[@]}" -o whole.npy --quiet
err_empty

# journal_size: what is in the journal of out.npy.
journal_size() { stat -c %s out.npy.partial 2>/dev/null || echo 0; }

# SIGKILL at random moments until a run gets through: nothing that was in the journal is lost. At first before
# there is a journal, then when it has grown by some of the 30 kB that it will have.
RANDOM=20240731
kills=0
while :; do
  before=$(journal_size)
  "$TANDEM" "${many[@]}" -o out.npy --threads $((1 + kills % 3)) --quiet &
  job=$!
  if ((kills == 0)); then
    sleep 0.01
  else
    goal=$((before + RANDOM % 6000))
    while (($(journal_size) < goal)) && kill -0 "$job" 2>/dev/null; do sleep 0.005; done
  fi
  kill -KILL "$job" 2>/dev/null
  wait "$job" 2>/dev/null
  status=$?
  ((status == 137)) || break
  kills=$((kills + 1))
  # Killed between its last two breaths, it has left the result, and no journal any more.
  [[ -e out.npy ]] && rm out.npy && continue
  that "the journal grows only" test "$(journal_size)" -ge "$before"
done
# Killed while the names were written, it could not tidy up.
rm -f .tandem-*-*
that "it got through" test "$status" == 0
that "it was killed on the way" test "$kills" -ge 3
that "the same bytes after $kills kills" cmp whole.npy out.npy
that "the same names" cmp whole.names.txt out.names.txt
only few.jsonl many.jsonl few.csv whole.npy whole.names.txt out.npy out.names.txt

# stopped SIGNAL: a run that this signal ends in the middle; its journal stays.
stopped() {
  rm -f out.npy
  "$TANDEM" "${many[@]}" -o out.npy --threads 1 >.out 2>.err &
  job=$!
  while (($(journal_size) < 3000)) && kill -0 "$job" 2>/dev/null; do sleep 0.02; done
  kill "-$1" "$job"
  wait "$job" 2>/dev/null
  status=$?
  err=$(<.err)
}

# A tail that was torn off, and one of garbage.
stopped KILL
that "killed in the middle" test "$status" == 137
head -c 2500 out.npy.partial >kept
for tail in '' 'garbage' "$(printf 'x%.0s' {1..3000})"; do
  { cat kept && printf %s "$tail"; } >out.npy.partial
  expect 0 "${many[@]}" -o out.npy
  err_has 'note: going on with out\.npy\.partial: [0-9]+ % are done'
  that "the same bytes after a torn tail" cmp whole.npy out.npy
done

# Killed while the matrix was being put together: what was left behind is used up.
stopped KILL
head -c 1000 whole.npy >.tandem-out.npy
expect 0 "${many[@]}" -o out.npy --quiet
that "the same bytes" cmp whole.npy out.npy
only few.jsonl many.jsonl few.csv whole.npy whole.names.txt out.npy out.names.txt kept

# Ctrl-C says how to go on. (Jobs in groups of their own, with Ctrl-C not ignored.)
set -m
stopped INT
set +m
that "130 after Ctrl-C" test "$status" == 130
err_has 'note: [0-9]+ % are done; the same command goes on from there \(with out\.npy\.partial\)'
that "no matrix yet" test ! -e out.npy
expect 0 "${many[@]}" -o out.npy
that "the same bytes after Ctrl-C" cmp whole.npy out.npy

# Another corpus or other options begin anew; a file that is no journal is left alone.
stopped KILL
cp out.npy.partial kept
expect 0 "${many[@]}" --cost paper -o out.npy
err_has 'warning: out\.npy\.partial was begun with other shapes or options: starting anew'
that "other costs" test -n "$(cmp whole.npy out.npy)"
cp kept out.csv.partial
expect 0 rank --all-pairs few.jsonl -o out.csv
err_has 'starting anew'
that "of the other corpus" cmp few.csv out.csv
echo notes >out.csv.partial
expect 1 rank --all-pairs few.jsonl -o out.csv
err_has 'out\.csv\.partial: is not the journal'
that "not touched" test "$(<out.csv.partial)" == notes
rm out.csv.partial

# Two at a time do not mix.
"$TANDEM" "${many[@]}" -o out.npy --quiet &
job=$!
while ! (($(journal_size) > 0)) && kill -0 "$job" 2>/dev/null; do sleep 0.01; done
expect 1 "${many[@]}" -o out.npy
err_has 'another process is at work on it'
wait "$job"
that "the first one is not disturbed" cmp whole.npy out.npy

# Wrong usage.
expect 2 rank --all-pairs -o out.npy
expect 2 rank --all-pairs few.jsonl
expect 2 rank --all-pairs few.jsonl -o -
err_has 'needs -o FILE\.npy or FILE\.csv'
expect 2 rank --all-pairs few.jsonl -o out.json
err_has '\.npy, \.csv'
expect 2 rank --all-pairs few.jsonl -o out.npy --top 3
expect 2 rank --all-pairs few.jsonl -o out.npy --json
expect 2 rank --all-pairs few.jsonl -o out.npy --exhaustive
expect 1 rank --all-pairs few.jsonl -o missing/out.npy
mkdir directory
expect 1 rank --all-pairs few.jsonl -o directory --to npy
err_has 'directory: is not a regular file'
rmdir directory
expect 1 rank --all-pairs missing.jsonl -o out.npy
printf '{"no": "curve"}\n' >broken.jsonl
expect 3 rank --all-pairs broken.jsonl -o broken.npy
err_has 'no shape to compare'
only few.jsonl many.jsonl few.csv whole.npy whole.names.txt out.npy out.names.txt kept out.csv broken.jsonl
finish
