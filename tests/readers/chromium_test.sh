# What Chromium shows of SVG, CSS and HTML at fixed times, against our own pictures.
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/../cli/lib.sh"
source "$here/pictures.sh"

chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || skip "no Chromium"
need_imagemagick

root=() preferences=()
((EUID != 0)) || root=(--no-sandbox)
browse() { # ARG...: Chromium without a window, and without a word
  "$chromium" --headless "${preferences[@]}" "${root[@]}" --disable-gpu --hide-scrollbars --force-color-profile=srgb \
    --force-device-scale-factor=1 --user-data-dir="$work/.chromium" "$@" 2>/dev/null
}

# shot PAGE NAME...: a picture NAME.png of every row of PAGE.
shot() {
  local page=$1 row=0 name
  shift
  # The window has a frame even where there is none to be seen: more height than the rows need.
  browse --window-size="$((width * ${#times[@]})),$((height * $# + 200))" --screenshot="$page.png" "file://$work/$page" >/dev/null
  for name; do
    cp "$page.png" "$name.png"
    mogrify -crop "$((width * ${#times[@]}))x$height+0+$((row * height))" +repage "$name.png"
    row=$((row + 1))
  done
}

page_head() { # of a page of rows of cells
  echo '<!DOCTYPE html><meta charset="utf-8"><style>body{margin:0;font-size:0}div.row{white-space:nowrap}'
  echo "svg,.cell{display:inline-block;width:${width}px;height:${height}px;overflow:hidden}"
  echo '.cell *{animation-play-state:paused !important;animation-delay:var(--at) !important}</style>'
}

# Cells of a style sheet, each with its delay.
css_row() { # SHEET MARKUP
  echo "<link rel=\"stylesheet\" href=\"$1\"><div class=\"row\">"
  for time in "${times[@]}"; do echo -n "<span class=\"cell\" style=\"--at:-${time}s\">$2</span>"; done
  echo '</div>'
}

smil_row() { # FILE.svg
  echo '<div class="row">'
  for time in "${times[@]}"; do sed "s|<svg |<svg data-time=\"$time\" |" "$1"; done | tr -d '\n'
  echo '</div><script>for (const svg of document.querySelectorAll("svg[data-time]")) { svg.pauseAnimations(); svg.setCurrentTime(+svg.dataset.time); }</script>'
}

times=(0 0.3 0.8 1.3 1.999) # seconds of 2
check() { # NAME EASING TIMES SHAPE...
  local name=$1 easing=$2 key_times=$3 positions=()
  shift 3
  for time in "${times[@]}"; do positions+=("$(eased "$easing" "$time" "$key_times")"); done
  our_sheet "$name" "${positions[@]}" -- "$@"
  expect 0 morph "$@" "${timing[@]}" -o "$name.svg" --easing "$easing" --quiet
  expect 0 morph "$@" "${timing[@]}" -o "$name.css" --easing "$easing" --quiet
  local rows=("$name.smil" "$name.css") svg row
  svg=$(sed -n '1s|^/\* \(.*\) \*/$|\1|p' "$name.css")
  {
    page_head
    smil_row "$name.svg"
    css_row "$name.css" "$svg"
  } >"$name.html"
  if [[ $name != open && $name != outline && $name != becoming ]]; then
    expect 0 morph "$@" "${timing[@]}" -o "$name.clip.css" --css clip-path --name clip --size "$size" --easing "$easing" --quiet
    css_row "$name.clip.css" '<div class="clip"></div>' >>"$name.html"
    rows+=("$name.clip")
  fi
  shot "$name.html" "${rows[@]}"
  for row in "${rows[@]}"; do same_picture "$row.png" "$name.ours.png"; done
}

check icon linear 0,1 "$DATA/icons/heart.svg" "$DATA/icons/star.svg"
other_picture icon.smil.png icon.ours.png
check holes 0.42,0,0.58,1 0,1 "$DATA/icons/cat.svg" "$DATA/icons/bird.svg"
check turn 0.25,0.1,0.25,1 0,0.5,1 'M0 0H9V2H3V5H0Z' 'M0 0V9H-2V3H-5V0Z' 'M0 0H9V9H0Z'
check open linear 0,1 'M0 0C1 5 5 5 9 0' 'M0 0C5 -5 5 5 9 9'

# The styles of the inputs: lines that grow, colours that mix, a fill that fades in while lines widen.
styled_shapes
# Chromium blurs lines that are turned by an animation: these are not.
timing=(--no-rotate)
check outline linear 0,1 ring.svg zigzag.svg
timing=()
check colors 0.42,0,0.58,1 0,1 red.svg blue.svg
check becoming linear 0,0.5,1 ring.svg both.svg red.svg
# The comparison sees colours.
expect 0 morph "$DATA/icons/heart.svg" blue.svg --at 0 -o black.png --quiet
sed 's|<svg |<svg fill="#ff0000" |' "$DATA/icons/heart.svg" >red-heart.svg
expect 0 morph red-heart.svg blue.svg --at 0 -o red.png --quiet
that "colours differ" less "$alike" "$(difference black.png red.png)"

# Keys at times of their own, every step with its own easing; and a smooth way that is eased as a whole.
timing=(--times 0,0.3,1)
check timed '0.42,0,1,1;0,0,0.58,1' 0,0.3,1 "$DATA/icons/heart.svg" "$DATA/icons/star.svg" "$DATA/icons/cat.svg"
timing=(--times 0,0.6,1 --smooth)
check smooth 0.42,0,0.58,1 0,1 'M0 0H9V2H3V5H0Z' 'M0 0V9H-2V3H-5V0Z' 'M0 0H9V9H0Z'
timing=()

# The player rests where its address says, with the points of our own in-between (of an affine blend: others are
# near between the frames that are written).
expect 0 morph "$DATA/icons/heart.svg" "$DATA/icons/star.svg" --blend affine -o player.html --quiet
expect 0 morph "$DATA/icons/heart.svg" "$DATA/icons/star.svg" --blend affine --at 0.37 -o - --quiet
ours=$(grep -o '"d": "[^"]*"' <<<"$out" | head -1)
theirs=$(browse --dump-dom "file://$work/player.html#s=0.37" | grep -o '<g id="shape"><path class="layer" d="[^"]*"' | sed 's/.* d=/d=/')
that "the player's in-between" same_numbers "$ours" "$theirs"
that "another in-between is another" other_numbers "$ours" "${theirs/M/M1}"

# Motions: the plot at a place is the one of our own in-between.
printf 'time,a,b,c\n0,0,1,2\n1,3,1,0\n2,1,5,1\n3,0,2,2\n' >slow.csv
printf 'time,a,b,c\n0,1,1,2\n2,5,1,0\n3,1,4,3\n5,0,2,1\n' >fast.csv
expect 0 morph slow.csv fast.csv -o motions.html --quiet
expect 0 morph slow.csv fast.csv -o motions.svg --at 0.37 --quiet
ours=$(grep -o 'class="motion between" [^>]*' motions.svg | head -1 | sed 's/.* d=/d=/')
theirs=$(browse --dump-dom "file://$work/motions.html#s=0.37" | grep -o '<path class="now"[^>]*' | head -1 | sed 's/.* d=/d=/')
near() { # TEXT TEXT: the same numbers within a tenth of a pixel
  paste <(grep -oE -- '-?[0-9.]+' <<<"$1") <(grep -oE -- '-?[0-9.]+' <<<"$2") |
    awk '{ n++; if (NF != 2 || ($1 - $2) ^ 2 > 0.01) bad++ } END { exit !(n > 100 && !bad) }'
}
far() { ! near "$@"; }
that "the plot of the in-between" near "$ours" "$theirs"
theirs=$(browse --dump-dom "file://$work/motions.html#s=0.5" | grep -o '<path class="now"[^>]*' | head -1 | sed 's/.* d=/d=/')
that "another in-between has another plot" far "$ours" "$theirs"

# Who prefers reduced motion sees the last shape, at rest.
preferences=(--force-prefers-reduced-motion)
our_sheet still 1 1 1 1 1 -- "$DATA/icons/heart.svg" "$DATA/icons/star.svg"
{
  page_head
  smil_row icon.svg
  css_row icon.css "$(sed -n '1s|^/\* \(.*\) \*/$|\1|p' icon.css)"
  css_row icon.clip.css '<div class="clip"></div>'
} >still.html
shot still.html still.smil still.css still.clip
for row in smil css clip; do same_picture "still.$row.png" still.ours.png; done
theirs=$(browse --dump-dom "file://$work/player.html" | grep -o '<output[^>]*>[^<]*')
that "the player waits: $theirs" test "${theirs#*>}" == 0.00
finish
