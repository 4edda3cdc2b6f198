#include "io/page.h"

#include <fmt/format.h>

#include "io/html.h"

namespace tandem {
inline namespace v0 {
namespace {

/// %TITLE% is filled in; --width is the page's own.
constexpr const char* kHead = R"page(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<title>%TITLE%</title>
<style>
:root {
  --page: #f4f2ee; --card: #fffefb; --line: #e2ded6; --ink: #1f2733; --soft: #6d7482; --accent: #3f62c8;
  --from: #3f62c8; --to: #c2562f;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #14171c; --card: #1b1f26; --line: #2c323c; --ink: #e7e9ee; --soft: #98a1b0; --accent: #8ea8ff;
    --from: #8ea8ff; --to: #f0a37f;
  }
}
* { box-sizing: border-box; }
html, body { height: 100%; }
body {
  margin: 0; padding: clamp(.75rem, 2.5vw, 2rem); display: flex; justify-content: center;
  background: var(--page); color: var(--ink); font: 15px/1.45 system-ui, "Segoe UI", Roboto, sans-serif;
}
main { width: min(100%, var(--width)); min-height: 100%; display: flex; flex-direction: column; gap: .9rem; }
h1 { margin: 0; font-size: 1.05rem; font-weight: 600; letter-spacing: .005em; overflow-wrap: anywhere; }
.stage {
  flex: 1 1 0; min-height: 14rem; position: relative; background: var(--card); border: 1px solid var(--line);
  border-radius: 14px; overflow: hidden;
}
.bar { display: flex; align-items: center; gap: .8rem; }
button {
  font: inherit; color: inherit; background: var(--card); border: 1px solid var(--line); border-radius: 999px;
  height: 2.5rem; padding: 0 1rem; cursor: pointer;
}
button:hover { border-color: var(--accent); }
button[aria-pressed="true"] { border-color: var(--accent); color: var(--accent); }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
#play { width: 2.5rem; padding: 0; display: grid; place-items: center; flex: none; color: var(--accent); }
#play svg { width: 1rem; height: 1rem; fill: currentColor; }
#s { flex: 1; min-width: 0; accent-color: var(--accent); height: 2rem; margin: 0; cursor: pointer; }
output { min-width: 3.2em; text-align: right; color: var(--soft); font-variant-numeric: tabular-nums; }
.keys { margin: 0; color: var(--soft); font-size: .8rem; }
kbd { font: inherit; border: 1px solid var(--line); border-radius: 4px; padding: 0 .35em; }
)page";

constexpr const char* kPlayBar = R"page(<div class="bar">
<button id="play" type="button" aria-label="Play"><svg viewBox="0 0 16 16" aria-hidden="true"><path id="icon" d="M4 2L14 8L4 14Z"/></svg></button>
<input id="s" type="range" min="0" max="1" step="0.001" value="0" aria-label="%LABEL%">
<output id="value" for="s">0.00</output>
%MORE%</div>
)page";

constexpr const char* kPlayScript =
    R"page(// Film: times, keys, stretches, easings, duration, alternate, repeat; show(s) shows the in-between at s.
let film, show, s = 0;

// The last of the rising values that is no greater than x, with another one behind it, and how far x is on the way there.
function locate(values, x) {
  let i = values.length - 2;
  while (i > 0 && values[i] > x) i--;
  return [i, (x - values[i]) / (values[i + 1] - values[i])];
}

// Timing: the eased share of a stretch, which is the way from one key to the next or all of it, and back again from a place
// to its time.
const bezier = (p, q, t) => 3 * p * t * (1 - t) * (1 - t) + 3 * q * t * t * (1 - t) + t * t * t;
function solve(p1, p2, q1, q2, x) {
  if (p1 === q1 && p2 === q2) return x;
  let lo = 0, hi = 1;
  for (let i = 0; i < 40; i++) {
    const t = (lo + hi) / 2;
    if (bezier(p1, p2, t) < x) lo = t; else hi = t;
  }
  return bezier(q1, q2, (lo + hi) / 2);
}
function retimed(value, share) {
  const stretches = film.stretches.map((i) => film.times[i]);
  const [i, local] = locate(stretches, value);
  return stretches[i] + share(film.easings[Math.min(i, film.easings.length - 1)], local) * (stretches[i + 1] - stretches[i]);
}
const timeToS = (time) => retimed(time, ([x1, y1, x2, y2], local) => solve(x1, x2, y1, y2, local));
const sToTime = (value) => retimed(value, ([x1, y1, x2, y2], local) => solve(y1, y2, x1, x2, local));

let playing = false, direction = 1, time = 0, before = 0;
function step(now) {
  if (!playing) return;
  time += direction * Math.min(now - before, 100) / 1000 / film.duration;
  before = now;
  const turning = time > 1 && film.alternate;
  const over = turning ? false : direction > 0 ? time > 1 : time < 0;
  if (over && !film.repeat) {
    goTo(direction > 0 ? 1 : 0);
    direction = 1;
    pause();
    return;
  }
  if (turning) { direction = -1; time = Math.max(2 - time, 0); }
  if (time > 1) time %= 1;
  if (time < 0) { direction = 1; time = Math.min(-time, 1); }
  goTo(timeToS(time));
  requestAnimationFrame(step);
}
function setPlaying(on) {
  if (on && !playing) {
    time = sToTime(s);
    if (time >= 1 && !film.alternate) time = 0;
    before = performance.now();
    requestAnimationFrame(step);
  }
  playing = on;
  byId("play").setAttribute("aria-label", on ? "Pause" : "Play");
  byId("icon").setAttribute("d", on ? "M3 2H7V14H3ZM9 2H13V14H9Z" : "M4 2L14 8L4 14Z");
}
const pause = () => setPlaying(false);

function goTo(value) {
  s = Math.min(Math.max(value, 0), 1);
  byId("s").value = s;
  byId("value").textContent = s.toFixed(2);
  show(s);
}

// page.html#s=0.5 opens at a place, at rest: true.
const wanted = new URLSearchParams(location.hash.slice(1));
function open_(data, shows) {
  [film, show] = [data, shows];
  byId("play").addEventListener("click", () => setPlaying(!playing));
  byId("s").addEventListener("input", (event) => { pause(); goTo(+event.target.value); });
  const place = parseFloat(wanted.get("s"));
  goTo(Number.isFinite(place) ? place : 0);
  return Number.isFinite(place);
}
)page";

}  // namespace

std::string format_page(const Page& page) {
  std::string text = replace_all(kHead, "%TITLE%", escape_html(page.title)) + page.style +
                     "</style>\n</head>\n<body>\n<main>\n" +
                     (page.lead.empty() ? "<h1>" + escape_html(page.title) + "</h1>" : page.lead) + '\n' +
                     page.body + "</main>\n";
  if (!page.script.empty()) {
    text += "<script type=\"application/json\" id=\"data\">\n" + page.data +
            "\n</script>\n<script>\n\"use strict\";\nconst byId = (id) => document.getElementById(id);\n"
            "const data = JSON.parse(byId(\"data\").textContent);\n" +
            page.script + "</script>\n";
  }
  return text + "</body>\n</html>\n";
}

std::string play_bar(const std::string& label, const std::string& more) {
  return replace_all(replace_all(kPlayBar, "%LABEL%", label), "%MORE%", more);
}

std::string play_script() {
  return kPlayScript;
}

}  // namespace v0
}  // namespace tandem
