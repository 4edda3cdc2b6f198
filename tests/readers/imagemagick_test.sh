# What ImageMagick reads of GIF and PNG: sizes, delays, loops and pixels, against our own pictures and rsvg-convert's.
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../cli/lib.sh"
source "$here/pictures.sh"

need_imagemagick

shapes=("$DATA/icons/cat.svg" "$DATA/icons/bird.svg")
delays() { identify -format '%T ' "$1"; }
sum() { awk '{ for (i = 1; i <= NF; ++i) n += $i; print n }'; }

# 25 frames a second, there and back without the ends twice.
expect 0 morph "${shapes[@]}" -o loop.gif --duration 1 --size 120 --quiet
that "50 frames" test "$(identify loop.gif | wc -l)" == 50
that "every 4 hundredths" test "$(delays loop.gif | tr ' ' '\n' | grep -v '^$' | sort -u)" == 4
that "for ever" test "$(identify -format '%[gif:iterations]\n' loop.gif 2>/dev/null | sed -n 1p)" != 1
that "the Netscape loop" grep -aq NETSCAPE2.0 loop.gif
read -r width height < <(identify -format '%W %H\n' 'loop.gif[0]')
that "120 pixels wide" test "$width" == 120
expect 0 morph "${shapes[@]}" -o once.gif --duration 1 --size 120 --play once --frames 8 --quiet
that "8 frames" test "$(identify once.gif | wc -l)" == 8
that "once" bash -c '! grep -aq NETSCAPE2.0 once.gif'
delays once.gif >once.delays
that "7 delays of 14 or 15, and the last one's: $(cat once.delays)" test "$(cut -d' ' -f1-7 once.delays | sum)" == 100
expect 0 morph "${shapes[@]}" -o round.gif --duration 1 --size 120 --play loop --frames 8 --quiet
that "8 frames round and round" test "$(identify round.gif | wc -l)" == 8

# Pixels: every frame is the in-between of its time, with the eased s; frames hold only what has changed.
times=(0 0.4 0.8 1.2 1.6 2)
positions=()
for time in "${times[@]}"; do positions+=("$(eased 0.42,0,1,1 "$time" 0,1)"); done
our_sheet gif "${positions[@]}" -- "${shapes[@]}"
expect 0 morph "${shapes[@]}" -o eased.gif --easing ease-in --play once --frames 6 --size "$size" --quiet
mkdir frames
mogrify -coalesce -format png -path frames eased.gif || fail "the frames cannot be taken apart"
montage frames/eased-*.png -geometry +0+0 -tile 6x1 gif.png
same_picture gif.png gif.ours.png
that "pixel by pixel" test "$(compare -metric AE -fuzz 1% gif.png gif.ours.png null: 2>&1)" == 0
other_picture gif.png gif.ours.png

# In colours: frames of one colour have all their shades, those of two sixteen of each.
styled_shapes
for pair in 'red.svg blue.svg' 'ring.svg both.svg'; do
  read -ra shapes <<<"$pair"
  our_sheet colors "${positions[@]}" -- "${shapes[@]}"
  expect 0 morph "${shapes[@]}" -o colors.gif --easing ease-in --play once --frames 6 --size "$size" --quiet
  rm -rf frames && mkdir frames
  mogrify -coalesce -format png -path frames colors.gif || fail "the frames cannot be taken apart"
  montage frames/colors-*.png -geometry +0+0 -tile 6x1 colors.png
  same_picture colors.png colors.ours.png
done
other_picture colors.png colors.ours.png
shapes=("$DATA/icons/cat.svg" "$DATA/icons/bird.svg")

# PNG: what another renderer makes of our still SVG.
if command -v rsvg-convert >/dev/null; then
  for at in 0 0.37 1.2; do
    expect 0 morph "${shapes[@]}" -o still.svg --at "$at" --quiet
    expect 0 morph "${shapes[@]}" -o still.png --at "$at" --size 300 --quiet
    read -r width height < <(identify -format '%w %h\n' still.png)
    rsvg-convert -w "$width" -h "$height" still.svg -o rsvg.png
    mogrify -background white -alpha remove still.png rsvg.png
    same_picture rsvg.png still.png
  done
  for at in 0 0.37 1; do
    expect 0 morph ring.svg both.svg -o still.svg --at "$at" --quiet
    expect 0 morph ring.svg both.svg -o still.png --at "$at" --size 300 --quiet
    rsvg-convert -w 300 -h 300 still.svg -o rsvg.png
    mogrify -background white -alpha remove still.png rsvg.png
    same_picture rsvg.png still.png
  done
  expect 0 morph 'M0 0C1 5 5 5 9 0M5 9V9.5' 'M0 0C5 -5 5 5 9 9M5 5Q7 7 9 0' -o still.svg --at 0.5 --quiet
  expect 0 morph 'M0 0C1 5 5 5 9 0M5 9V9.5' 'M0 0C5 -5 5 5 9 9M5 5Q7 7 9 0' -o still.png --at 0.5 --size 300 --quiet
  read -r width height < <(identify -format '%w %h\n' still.png)
  rsvg-convert -w "$width" -h "$height" still.svg -o rsvg.png
  mogrify -background white -alpha remove still.png rsvg.png
  same_picture rsvg.png still.png
fi
finish
