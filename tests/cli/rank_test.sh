# rank and index: the same answer from files and from an index, and what is broken does not end the run.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

mkdir -p corpus/animals corpus/empty
cp "$DATA"/icons/*.svg corpus/
icon=$(ls corpus/*.svg | head -1)
count=$(ls corpus/*.svg | wc -l)

# A table, best first; the query finds itself.
expect 0 rank "$icon" corpus --threads 2
out_has '^ rank +cost +turn +mirrored +name'
out_has "    1   0\.000000     0\.0°  no        $icon"
that "as many rows as icons" test "$(wc -l <.out)" -le $((count + 1))

# JSON lines; threads, pruning and an index change nothing.
expect 0 rank "$icon" corpus --json --top 5 --mirror --threads 1 --quiet
err_empty
first=$out
that "five lines" test "$(wc -l <.out)" == 5
out_has '^\{"rank": 1, "name": "corpus/[^"]*", "label": null, "index": 0, "cost": [0-9.e-]+, "degrees": 0, "rotation": \[1, 0\], "mirrored": false'
expect 0 rank "$icon" corpus --json --top 5 --mirror --exhaustive --threads 3 --quiet
that "the same without pruning" test "$out" == "$first"
expect 0 index corpus -o corpus.tdx
err_has 'shapes in corpus.tdx'
out_empty
expect 0 rank "$icon" corpus.tdx --json --top 5 --mirror --quiet
that "the same from an index" test "$out" == "$first"
expect 0 rank corpus.tdx#0 corpus.tdx --top 1
out_has '    1   0\.000000 '
err_has 'note: the best 1 of'
expect 0 rank "corpus.tdx#$icon" corpus.tdx --top 0
expect 0 rank "$icon" corpus -o best.jsonl --top 5 --mirror --quiet
out_empty
that "-o writes the same" test "$(<best.jsonl)" == "$first"
expect 0 rank "$icon" corpus -o best.html --top 3
that "a page with pictures" grep -q '<path class="query"' best.html
that "and nothing from the network" bash -c '! grep -Eq "(src|href)=\"?http|url\(" best.html'

# Turned, mirrored, moved and scaled shapes.
flag='M0 0H6V4H3V2H1V9H0Z'
turned='M100 100V112H92V106H96V102H82V100Z'     # by a quarter, twice as large
flipped='M100 0H94V4H97V2H99V9H100Z'
expect 0 rank "$flag" "$turned" "$flipped" "$triangle" --json
out_has '"rank": 1, "name": "'"$turned"'", "label": null, "index": 0, "cost": 0.*"degrees": 90,'
expect 0 rank "$flag" "$turned" "$flipped" "$triangle" --json --mirror
out_has '"rank": 2, "name": "'"$flipped"'", "label": null, "index": 1, "cost": 0.*"mirrored": true'
expect 0 rank "$flag" "$turned" "$flipped" --no-rotate --mirror
out_has '1   0\.000000     0\.0°  yes       M100 0'
for cost in paper elastic; do
  expect 0 rank "$flag" "$turned" "$triangle" --cost $cost
  out_has '1   0\.00000.    90\.0°  no        M100 100'
done

# JSON lines as a corpus, with names and labels; a broken line is passed over.
cat >shapes.jsonl <<'JSON'
{"type": "bspline", "degree": 1, "points": [[0,0],[4,0],[4,4],[0,4],[0,0]], "name": "square", "label": "box"}

{"type": "bspline", "degree": 1, "points": [[0,0],[4,0],[2,4],[0,0]]}
{"type": "bspline", "degree": 1, "points": [[0,0],[1]]}
{"type": "bspline", "degree": 1, "points": [[0,0],[4,1]], "name": "a line"}
JSON
expect 0 rank "$square" shapes.jsonl --json
out_has '"rank": 1, "name": "square", "label": "box", "index": 0'
out_has '"rank": 2, "name": "shapes.jsonl#1", "label": null, "index": 1'
err_has 'warning: shapes.jsonl#2: shapes.jsonl:4:[0-9]+: .*point 1 has 1 coordinates'
err_has '1 of 4 candidates cannot be compared'
expect 0 info shapes.jsonl#1
expect 3 info shapes.jsonl#9
err_has 'there is no line #9; it has 4'
expect 3 info shapes.jsonl

# Labels from directories; broken files there are warnings, and an error when they are named.
cp "$icon" corpus/animals/cow.svg
echo '<svg' >corpus/animals/broken.svg
expect 0 rank "$icon" corpus --json --top 2
out_has '"name": "corpus/animals/cow.svg", "label": "animals"'
err_has 'warning: corpus/animals/broken.svg'
expect 3 rank "$icon" corpus corpus/animals/broken.svg
out_empty
for i in {1..12}; do echo '<svg' >corpus/animals/$i.svg; done
expect 0 rank "$icon" corpus --top 2
err_has '13 candidates could not be read'
expect 1 rank "$icon" missing.svg
expect 1 rank "$icon" missing/
expect 3 rank "$icon" corpus/empty
err_has 'none of 0 candidates'
expect 3 rank "$square" 'M0 0L4 4'
expect 3 rank corpus.tdx corpus.tdx
err_has 'holds several shapes'
expect 3 rank corpus.tdx#999999 corpus.tdx
expect 3 index corpus/empty -o none.tdx
expect 3 info corpus.tdx

# Damaged indices.
head -c 300 corpus.tdx >cut.tdx
expect 3 rank "$square" cut.tdx
err_has 'is cut off: it has 0 of'
printf 'hello' >no.tdx
expect 3 rank "$square" no.tdx
err_has 'is no .tdx index'

# Standard input, and standard output.
"$TANDEM" rank - "$triangle" "$square" <<<"$square" >.out 2>.err
status=$?
out=$(<.out)
that "a query from standard input" test $status == 0
out_has "1   0.000000 .*$square"
expect 0 rank "$square" "$triangle" -o - --quiet
out_has '^\{"rank": 1,'
"$TANDEM" index corpus -o - --quiet >piped.tdx 2>.err
"$TANDEM" index corpus -o again.tdx --threads 1 --quiet
that "an index on standard output" cmp -s piped.tdx again.tdx

# Wrong usage.
expect 2 rank "$square"
err_has 'rank takes a query and one or more candidates, not 1 name'
expect 2 rank - -
expect 2 rank "$square" "$triangle" --cost cheap
err_has 'one of symmetric, paper, elastic'
expect 2 rank "$square" "$triangle" --top -1
expect 2 rank "$square" "$triangle" --samples 2
expect 2 rank "$square" "$triangle" --rotate --no-rotate
expect 2 rank "$square" "$triangle" --cost paper --charge 1
expect 2 rank "$square" "$triangle" -o best.svg
expect 2 index corpus
expect 2 index -o x.tdx
expect 2 index corpus -o x.json

rm -r corpus
only again.tdx best.html best.jsonl corpus.tdx cut.tdx no.tdx piped.tdx shapes.jsonl
finish
