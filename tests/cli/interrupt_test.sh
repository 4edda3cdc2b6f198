# Ctrl-C ends the work with 130 and leaves nothing behind.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"
set -m # jobs in groups of their own, with Ctrl-C not ignored

circle='M10 0A10 10 0 1 1 -10 0A10 10 0 1 1 10 0Z'
wave="M0 0$(printf 'q5 9 10 0t10 0%.0s' {1..40})V-30H0Z"
long=(--samples 3000 --quiet) # many seconds

# All times are of the processor, not of the clock: other work on the machine must not decide.
# working JOB: comes back when the program has used 0.3 s, that is, is in the middle of its work.
working() {
  local used ticks=$((3 * $(getconf CLK_TCK) / 10))
  while used=$(sed 's/.*) //' "/proc/$1/stat" 2>/dev/null | awk '{ print $12 + $13 }') && [[ -n $used ]]; do
    ((used < ticks)) || return 0
    sleep 0.02
  done
}

# used: hundredths of a second that the programs have used which were waited for.
used() {
  times | tail -1 | awk -F '[ms ]+' '{ printf "%d", 100 * (60 * $1 + $2 + 60 * $3 + $4) }'
}

# interrupted WANTED SIGNAL ARG...: the signal arrives in the middle of the work, which ends with this status.
interrupted() {
  local wanted=$1 signal=$2
  shift 2
  "$TANDEM" "$@" >.out 2>.err </dev/null &
  local job=$!
  working "$job"
  kill "-$signal" "$job" 2>/dev/null || fail "the work was over before the signal came"
  wait "$job" 2>/dev/null
  status=$?
  out=$(head -c 1000 .out)
  err=$(<.err)
  that "status $wanted after $signal: tandem ${*:0:40}" test "$status" == "$wanted"
}

interrupted 130 INT match "$circle" "$wave" "${long[@]}" -o out.json
interrupted 130 INT match "$circle" "$wave" "${long[@]}" --json
out_empty
interrupted 130 INT match "$circle" "$wave" --samples 3000
err_empty # standard error is no terminal: no bar, and the shell knows why it ended
interrupted 130 INT morph "$circle" "$wave" "${long[@]}" -o frames/
interrupted 143 TERM morph "$circle" "$wave" "${long[@]}" -o out.svg

# Laws of high degree are slow to compose and to look at; between them the program looks up.
awk 'BEGIN {
  for (k = 0; k < 2; ++k) {
    printf "%s{\"degree\": 33, \"points\": [", k ? ", " : "{\"curves\": ["
    for (i = 0; i <= 3000; ++i) printf "%s[%.6f,%.6f,%.6f]", i ? "," : "", i / 300, sin(i / 10 + 0.3 * k), k
    printf "]}"
  }
  print "]}"
}' >high.json
before=$(used)
interrupted 143 TERM rule high.json#0 high.json#1 -o x.json --quiet
[[ -n ${SANITIZE-} ]] || that "soon" test $(($(used) - before)) -le 2000
rm high.json

# While frames are written: the directory is taken away again.
interrupted 130 INT morph 'M0 0L4 4' 'M0 1L5 2' -o many/ --frames 100000 --quiet

# In the middle of a corpus: no ranking of a part of it.
for i in {1..4000}; do echo '{"degree": 1, "points": [[0,0],[4,0],[4,'"$i"'],[0,4],[0,0]]}'; done >many.jsonl
interrupted 130 INT rank "$circle" many.jsonl --samples 1000 --quiet -o best.jsonl
interrupted 130 INT index many.jsonl --samples 2000 --quiet -o many.tdx
rm many.jsonl

# Work that does not look up for a while: the second signal ends it at once.
"$TANDEM" match "$circle" "$wave" --samples 2000 -o out.json >.out 2>.err </dev/null &
job=$!
working "$job"
kill -INT "$job"
sleep 0.2
before=$(used)
kill -INT "$job" 2>/dev/null
wait "$job" 2>/dev/null
that "130 after the second Ctrl-C" test $? == 130
that "at once" test $(($(used) - before)) -le 300

# Waiting for standard input is left at once.
mkfifo pipe
sleep 20 >pipe &
"$TANDEM" info - <pipe >.out 2>.err &
job=$!
sleep 0.3
kill -INT "$job"
wait "$job" 2>/dev/null
that "130 after Ctrl-C while waiting for input" test $? == 130
kill %+ 2>/dev/null
rm pipe

# A signal that the caller ignores stays ignored.
(trap '' INT && exec "$TANDEM" match "$circle" "$wave" --samples 1200 -o ignored.json --quiet) &
job=$!
working "$job"
kill -INT "$job"
wait "$job" 2>/dev/null
that "an ignored Ctrl-C does nothing" test $? == 0

only ignored.json
finish
