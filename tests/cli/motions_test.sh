# Motions: CSV files blended in time and in value.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

# A swing of period 1, and one of period 2 with twice the amplitude, both from rest to rest.
table() { # PERIOD AMPLITUDE ROWS
  echo 'time,"left arm",right'
  awk -v p="$1" -v a="$2" -v n="$3" 'BEGIN { for (i = 0; i < n; ++i) { t = 2 * p * i / (n - 1); x = 6.2831853 * t / p
    printf "%.6f,%.6f,%.6f\n", t, a * sin(x), a * cos(x + 0.4) } }'
}
table 1 10 80 | sed 's/$/,0/; 1s/0$/rest/' >slow.csv
table 2 20 120 | sed 's/$/,0/; 1s/0$/rest/' >wide.csv

expect 0 morph slow.csv wide.csv --at 0.5 -o half.csv
err_empty
that "the columns of the first file" test "$(head -1 half.csv)" == 'time,"left arm",right,rest'
that "rows between both" test "$(wc -l <half.csv)" == 101
that "time between both" awk -F, 'NR == 2 && $1 != 0 { exit 1 } END { exit !($1 > 2.9999 && $1 < 3.0001) }' half.csv
that "values between both" awk -F, '$2 > m && NR > 1 { m = $2 } END { exit !(m > 14.7 && m < 15.3) }' half.csv
for end in 0 1; do
  expect 0 morph slow.csv wide.csv --at "$end" -o end.csv
  input=$([[ $end == 0 ]] && echo slow.csv || echo wide.csv)
  that "s = $end is $input" bash -c "paste -d, $input end.csv | awk -F, 'NR > 1 { for (i = 1; i <= 4; ++i) if ((\$i - \$(i + 4)) ^ 2 > 1e-8) exit 1 }'"
done

# Forced moments.
expect 0 morph slow.csv wide.csv --at 1 -o - --pin 0.5=1.3
out_has '"columns": \["time", "left arm", "right", "rest"\], "rows": \[\[0, '
out_has '"curves": \[\{"type": "bspline".*"time": \{"type": "bspline"'
out_has '"report": \{'
expect 0 match slow.csv wide.csv --pin 0.5=1.3 --json
out_has '"correspondence"'
expect 3 morph slow.csv wide.csv --at 1 -o - --pin 0.5=9
expect 2 morph slow.csv wide.csv --at 1 -o - --pin 0.5
err_has '--pin takes t1=t2'
expect 2 morph slow.csv wide.csv slow.csv --at 1 -o - --pin 0.5=1
err_has 'two motions'

# Plots, tables of many in-betweens, key times.
expect 0 morph slow.csv wide.csv -o plots.svg
that "a plot for each column" test "$(grep -c '<g transform' plots.svg)" == 3
that "two motions and three between" test "$(grep -c 'class="motion' plots.svg)" == 15
expect 0 morph slow.csv wide.csv -o plots.svg --at 0.5
that "one between" test "$(grep -c 'between"' plots.svg)" == 3
expect 0 morph slow.csv wide.csv -o plots.html --easing ease
that "a page without network" bash -c 'grep -q "<html" plots.html && ! grep -qE "(src|href)=\"?https?:" plots.html'
expect 0 morph slow.csv wide.csv slow.csv -o tables/ --to csv --frames 5 --smooth --times 0,0.25,1
that "five tables" test "$(ls tables | tr '\n' ' ')" == 'frame_000.csv frame_001.csv frame_002.csv frame_003.csv frame_004.csv '
that "the second motion at its time" bash -c "paste -d, wide.csv tables/frame_001.csv | awk -F, 'NR > 1 { for (i = 1; i <= 4; ++i) if ((\$i - \$(i + 4)) ^ 2 > 1e-8) exit 1 }'"

expect 2 morph slow.csv wide.csv -o half.csv
err_has 'one in-between'
expect 2 morph "$square" "$triangle" -o half.csv --at 0.5
err_has 'a .csv holds a motion'
expect 3 morph slow.csv wide.csv -o half.gif
err_has 'motions go to'
cut -d, -f1-3 slow.csv >two.csv
expect 3 morph slow.csv two.csv -o half.csv --at 0.5
err_has 'two\.csv has 2 columns of values, expected 3 as in slow\.csv'
expect 3 morph slow.csv wide.csv --at 1 -o - --pin 0.5=9
err_has 'slow\.csv, wide\.csv: '
printf 'time,a,b\n' >empty.csv
expect 3 morph slow.csv empty.csv --at 1 -o -
err_has 'empty\.csv.*no row of numbers'

# Columns belong together by name, wherever they stand.
awk -F, '{ print $1 "," $4 "," $2 "," $3 }' wide.csv >mixed.csv
expect 0 morph slow.csv wide.csv --at 0.5 -o half.csv
expect 0 morph slow.csv mixed.csv --at 0.5 -o other.csv
err_has 'the columns of mixed\.csv stand in another order'
that "the same in-between" cmp half.csv other.csv
expect 0 morph mixed.csv slow.csv wide.csv --at 0.5 -o other.csv --quiet
that "the order of the first file" test "$(head -1 other.csv)" == 'time,rest,"left arm",right'
sed '1s/right/RIGHT/' mixed.csv >names.csv
expect 0 morph slow.csv names.csv --at 0.5 -o other.csv
err_has 'warning.*names\.csv has rest, left arm, RIGHT.*in the order in which they stand'
that "by their places" bash -c '! cmp -s half.csv other.csv'
for name in slow mixed; do sed 1d $name.csv >nameless.$name.csv; done
expect 0 morph nameless.slow.csv nameless.mixed.csv --at 0.5 -o other.csv
err_empty
expect 0 morph slow.csv wide.csv --at 0.5 -o half.csv --smooth
err_has 'note.*--smooth'
# Two columns of values are a drawing, unless a table is wanted.
expect 0 morph two.csv two.csv -o - --at 0.5
out_has '"d": "M'
expect 0 morph two.csv two.csv -o two.out.csv --at 0.5
that "two columns" test "$(head -1 two.out.csv)" == 'time,"left arm",right'
expect 0 morph two.csv two.csv -o both/ --to csv --frames 3
that "tables of two columns" test "$(head -1 both/frame_001.csv)" == 'time,"left arm",right'
finish
