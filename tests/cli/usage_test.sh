# Wrong usage: exit status 2, a message that helps, nothing on standard output.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

wrong() { # wrong PATTERN ARG...
  local pattern=$1
  shift
  expect 2 "$@"
  out_empty
  err_has "$pattern"
}

expect 0 --version
out_has '^tandem [0-9]+\.[0-9]+\.[0-9]+$'
err_empty
expect 0 --help
out_has 'match.*morph.*info.*convert'
expect 0 match --help
out_has '--norm'
expect 0 morph -h
out_has '--easing'

wrong 'Usage|usage'
wrong 'did you mean match' mach "$square" "$triangle"
wrong 'font is not available yet' font "$square" "$triangle"
wrong 'no option --versoin; did you mean --version' --versoin
wrong 'match has no option --metod; did you mean --method' match "$square" "$triangle" --metod paper
wrong 'did you mean --samples' match --sample=20 "$square" "$triangle"
wrong 'no option -x' match "$square" "$triangle" -x
wrong '--pin takes x1,y1=x2,y2' morph "$square" "$triangle" -o out.svg --pin '0,0=1'
wrong '--pin takes x1,y1=x2,y2' match "$square" "$triangle" --pin '0,0'
wrong '--pin takes x1,y1=x2,y2' match "$square" "$triangle" --pin '0,0,0=1,1'
wrong '--pin' match "$square" "$triangle" --pin '0,x=1,1'
wrong '--reduce does not go with --pin' match "$square" "$triangle" --pin '0,0=2,0' --reduce 20
wrong '--closed pinned does not go with --pin' match "$square" "$triangle" --pin '0,0=2,0' --closed pinned
wrong 'takes 2 curves or shapes, not 1' match "$square"
wrong 'takes 2 curves or shapes, not 3' match "$square" "$square" "$square"
wrong 'takes 2 or more' morph "$square" -o out.svg
wrong 'takes 1 curve or shape, not 0' info
wrong 'only once' match - -

wrong '--samples does not go with --method segments' match "$square" "$triangle" --method segments --samples 50
wrong '--norm does not go with --method segments' match "$square" "$triangle" --method segments --norm ruled
wrong '--closed pinned does not go with --method segments' match "$square" "$triangle" --method segments --closed pinned
wrong '--split goes with --method segments only' match "$square" "$triangle" --split uniform
wrong '--segment-cost goes with --method segments only' morph "$square" "$triangle" -o out.svg --segment-cost paper
wrong '--split takes one of proportional, uniform' match "$square" "$triangle" --method segments --split even
wrong 'one of elastic, paper, segments, not' match "$square" "$triangle" --method Paper
wrong 'one of tangent, ruled, distance, bottleneck, not' match "$square" "$triangle" --norm angle
wrong '--samples takes a whole number' match "$square" "$triangle" --samples 1
wrong '--samples' match "$square" "$triangle" --samples 99999999999999999999
wrong '--samples takes a whole number from 2 to 6000' match "$square" "$triangle" --samples 6001
wrong '--samples takes a whole number from 2 to 10000' match "$square" "$triangle" --samples 10001 --method paper
wrong '--samples' match "$square" "$triangle" --samples -5
wrong '--samples' match "$square" "$triangle" --samples ''
wrong '--samples' match "$square" "$triangle" --samples 10,
wrong '--samples' match "$square" "$triangle" --samples 10,20,30
wrong '--samples' match "$square" "$triangle" --samples nan
wrong '--sampling' match "$square" "$triangle" --sampling even
wrong '--features' match "$square" "$triangle" --features curvature
wrong '--tolerance takes a finite number' match "$square" "$triangle" --tolerance nan
wrong '--tolerance takes a finite number' match "$square" "$triangle" --tolerance inf
wrong '--tolerance needs a value' match "$square" "$triangle" --tolerance ''
wrong '--tolerance takes a finite number' match "$square" "$triangle" --tolerance 0x1
wrong '--tolerance takes a finite number' match "$square" "$triangle" --tolerance 1e-3x
wrong '--tolerance takes a number from' match "$square" "$triangle" --tolerance 0
wrong '--tolerance takes a number from' match "$square" "$triangle" --tolerance -1
wrong 'exclude each other' match "$square" "$triangle" --tolerance 1e-3 --reduce 20
wrong '--reduce takes a whole number from 4' match "$square" "$triangle" --reduce 3 --order 4
wrong '--order' match "$square" "$triangle" --order 1
wrong '--direction' match "$square" "$triangle" --direction back
wrong '--closed' match "$square" "$triangle" --closed maybe
wrong '--low-pass' match "$square" "$triangle" --low-pass nan
wrong '--threads' match "$square" "$triangle" --threads 0
wrong '--rotate does not go with --norm ruled' match "$square" "$triangle" --rotate --norm ruled
wrong '--rotate excludes --no-rotate' match "$square" "$triangle" --rotate --no-rotate
wrong '--fill-rule' match "$square" "$triangle" --fill-rule odd
wrong 'requires|required|missing' match "$square" "$triangle" --norm
wrong 'ending' match "$square" "$triangle" -o out.txt
wrong 'ending' match "$square" "$triangle" -o out.html
wrong '-o.*needs a value' match "$square" "$triangle" -o ''
wrong '--to takes one of json, svg' match "$square" "$triangle" -o - --to html

wrong 'align needs -o' align "$square" "$triangle"
wrong 'ending' align "$square" "$triangle" -o out.css
wrong '--precision' align "$square" "$triangle" -o out.json --precision x
wrong 'morph needs -o' morph "$square" "$triangle"
wrong '--blend takes one of' morph "$square" "$triangle" -o out.svg --blend linear
wrong '--at takes a finite number' morph "$square" "$triangle" -o - --at 0,nan
wrong '--at takes a list' morph "$square" "$triangle" -o - --at 0,,1
wrong '--at' morph "$square" "$triangle" -o - --at ''
wrong '--at' morph "$square" "$triangle" -o out.html --at 0.5
for file in out.css out.lottie.json out.avd.xml out.gif; do
  wrong "--at does not go with [.]${file#out.}" morph "$square" "$triangle" -o "$file" --at 0.5
done
wrong '.png holds one in-between' morph "$square" "$triangle" -o out.png
wrong 'takes one number' morph "$square" "$triangle" -o out.png --at 0,1
wrong '--css takes one of d, clip-path' morph "$square" "$triangle" -o out.css --css path
wrong '--name takes' morph "$square" "$triangle" -o out.css --name 'a b'
wrong '--play takes one of' morph "$square" "$triangle" -o out.css --play twice
wrong '--size' morph "$square" "$triangle" -o out.gif --size 0
wrong '--size' morph "$square" "$triangle" -o out.gif --size 9000
wrong '--precision' morph "$square" "$triangle" -o out.svg --precision -1
wrong '50 a second' morph "$square" "$triangle" -o out.gif --duration 1 --frames 52
wrong '--to takes one of lottie, avd, json, svg, html, css, gif, png, csv, not' morph "$square" "$triangle" -o - --to tiff
wrong 'takes one number' morph "$square" "$triangle" -o out.svg --at 0,1
wrong 'exclude each other' morph "$square" "$triangle" -o - --at 0 --frames 3
wrong '--frames' morph "$square" "$triangle" -o - --frames 1
wrong '--frames' morph "$square" "$triangle" -o - --frames 1e3
wrong '--duration' morph "$square" "$triangle" -o out.svg --duration 0
wrong '--duration' morph "$square" "$triangle" -o out.svg --duration inf
wrong '--easing' morph "$square" "$triangle" -o out.svg --easing bouncy
wrong '--easing' morph "$square" "$triangle" -o out.svg --easing 2,0,1,1
wrong '--easing' morph "$square" "$triangle" -o out.svg --easing 0,nan,1,1
wrong '--easing' morph "$square" "$triangle" -o out.svg --easing ''
wrong '--easing' morph "$square" "$triangle" "$square" -o out.svg --easing 'ease;'
wrong '--easing takes one easing for all, or one for each of the 2 steps' morph "$square" "$triangle" "$square" -o out.svg --easing 'ease;ease;ease'
wrong '--easing takes one easing for all' morph "$square" "$triangle" -o out.svg --easing ease --easing ease
wrong '--times takes a time for each of the 3 shapes' morph "$square" "$triangle" "$square" -o out.svg --times 0,1
wrong '--times takes times that rise from 0 to 1,' morph "$square" "$triangle" "$square" -o out.svg --times 0,0.5,0.9
wrong '--times takes times that rise from 0 to 100%' morph "$square" "$triangle" "$square" -o out.svg --times 0%,50%,90%
wrong '--times takes times that rise from 0 to the duration' morph "$square" "$triangle" "$square" -o out.svg --times 0s,2s,1s
wrong '--times takes times of one kind' morph "$square" "$triangle" "$square" -o out.svg --times 0,50%,1
wrong '--times' morph "$square" "$triangle" "$square" -o out.svg --times 0,x,1
wrong '--duration does not go with' morph "$square" "$triangle" "$square" -o out.svg --times 0s,1s,2s --duration 2
wrong 'convert needs -o' convert "$square"
wrong 'ending' convert "$square" -o out.html
wrong ending convert "$square" -o out

# Silence is total.
expect 2 match "$square" --quiet
out_empty
err_empty

only
finish
