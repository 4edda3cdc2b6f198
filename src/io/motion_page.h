#pragma once

/// The page of plots of motions: %TITLE% and %PLOTS% are filled in, and the data goes between the two parts.
namespace tandem {
inline namespace v0 {

inline constexpr const char* kMotionHead = R"page(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<title>%TITLE%</title>
<style>
:root { --page: #f4f2ee; --card: #fffefb; --line: #d8d4cc; --ink: #232a36; --soft: #6d7482; --accent: #3f62c8; --from: #3f62c8; --to: #c2562f; }
@media (prefers-color-scheme: dark) {
  :root { --page: #14171c; --card: #1b1f26; --line: #2c323c; --ink: #e7e9ee; --soft: #98a1b0; --accent: #8ea8ff; --from: #8ea8ff; --to: #f0a37f; }
}
* { box-sizing: border-box; }
body { margin: 0; padding: clamp(.75rem, 2.5vw, 2rem); background: var(--page); color: var(--ink); font: 15px/1.45 system-ui, "Segoe UI", Roboto, sans-serif; }
main { max-width: 64rem; margin: auto; display: grid; gap: .9rem; }
h1 { margin: 0; font-size: 1.05rem; font-weight: 600; overflow-wrap: anywhere; }
.plots { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 22rem), 1fr)); gap: .6rem; }
.plot { width: 100%; background: var(--card); border: 1px solid var(--line); border-radius: 10px; }
.plot text { font: 11px system-ui, sans-serif; fill: var(--soft); }
.plot .name { font-weight: 600; fill: var(--ink); }
.box, .zero { fill: none; stroke: var(--line); }
.zero { stroke-dasharray: 3 3; }
.key, .now { fill: none; stroke-linejoin: round; }
.key { stroke-width: 1.25; opacity: .6; }
.now { stroke: var(--ink); stroke-width: 2; }
.bar { display: flex; align-items: center; gap: .8rem; position: sticky; bottom: 0; padding: .5rem 0; background: var(--page); }
#play { width: 2.5rem; height: 2.5rem; padding: 0; display: grid; place-items: center; flex: none; color: var(--accent); background: var(--card); border: 1px solid var(--line); border-radius: 999px; cursor: pointer; }
#play svg { width: 1rem; height: 1rem; fill: currentColor; }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
#s { flex: 1; min-width: 0; accent-color: var(--accent); height: 2rem; margin: 0; cursor: pointer; }
output { min-width: 3.2em; text-align: right; color: var(--soft); font-variant-numeric: tabular-nums; }
</style>
</head>
<body>
<main>
<h1>%TITLE%</h1>
<div class="plots">
%PLOTS%</div>
<div class="bar">
<button id="play" type="button" aria-label="Play"><svg viewBox="0 0 16 16" aria-hidden="true"><path id="icon" d="M4 2L14 8L4 14Z"/></svg></button>
<input id="s" type="range" min="0" max="1" step="0.001" value="0" aria-label="Position s between the motions">
<output id="value" for="s">0.00</output>
</div>
</main>
)page";

inline constexpr const char* kMotionScript = R"page(<script>
"use strict";
const motion = JSON.parse(document.getElementById("motion").textContent);
const byId = (id) => document.getElementById(id);
const [left, top_, right, low] = motion.plot;

// The last of the rising values that is no greater than x, with another one behind it, and how far x is on the way there.
function locate(values, x) {
  let i = values.length - 2;
  while (i > 0 && values[i] > x) i--;
  return [i, (x - values[i]) / (values[i + 1] - values[i])];
}
const share = ([lo, hi], x) => hi > lo ? (x - lo) / (hi - lo) : 0.5;
function line(a, b, local, c) {
  const at = (k, i) => (1 - local) * a[k][i] + local * b[k][i];
  let d = "M";
  for (let i = 0; i < a[0].length; i++) {
    const x = left + (right - left) * share(motion.ranges[0], at(0, i));
    const y = low - (low - top_) * share(motion.ranges[c], at(c, i));
    d += (i ? "L" : "") + x.toFixed(2) + " " + y.toFixed(2);
  }
  return d;
}
const plots = [...document.querySelectorAll(".plot")].map((svg, i) => {
  const path = (name) => {
    const node = document.createElementNS("http://www.w3.org/2000/svg", "path");
    node.setAttribute("class", name);
    svg.append(node);
    return node;
  };
  for (const key of motion.keys) {
    const node = path("key");
    node.setAttribute("d", line(motion.frames[key], motion.frames[key], 0, i + 1));
    node.style.stroke = `color-mix(in srgb, var(--to) ${100 * motion.times[key]}%, var(--from))`;
    if (!node.style.stroke) node.style.stroke = "var(--soft)";
  }
  return path("now");
});

let s = 0;
function show(value) {
  s = Math.min(Math.max(value, 0), 1);
  const [i, local] = locate(motion.times, s);
  plots.forEach((node, c) => node.setAttribute("d", line(motion.frames[i], motion.frames[i + 1], local, c + 1)));
  byId("s").value = s;
  byId("value").textContent = s.toFixed(2);
}

// Timing: the eased share of a stretch, which is the way from one motion to the next or all of it, and back.
const stretches = motion.stretches.map((i) => motion.times[i]);
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
function retimed(value, ease) {
  const [i, local] = locate(stretches, value);
  return stretches[i] + ease(motion.easings[Math.min(i, motion.easings.length - 1)], local) * (stretches[i + 1] - stretches[i]);
}
let playing = false, direction = 1, time = 0, before = 0;
function step(now) {
  if (!playing) return;
  time += direction * Math.min(now - before, 100) / 1000 / motion.duration;
  before = now;
  if (time > 1 && motion.alternate) { direction = -1; time = 2 - time; }
  const over = direction > 0 ? time > 1 : time < 0;
  if (over && !motion.repeat) { show(direction > 0 ? 1 : 0); direction = 1; setPlaying(false); return; }
  if (time > 1) time %= 1;
  if (time < 0) { direction = 1; time = -time; }
  show(retimed(time, ([x1, y1, x2, y2], local) => solve(x1, x2, y1, y2, local)));
  requestAnimationFrame(step);
}
function setPlaying(on) {
  if (on && !playing) {
    time = retimed(s, ([x1, y1, x2, y2], local) => solve(y1, y2, x1, x2, local));
    if (time >= 1 && !motion.alternate) time = 0;
    before = performance.now();
    requestAnimationFrame(step);
  }
  playing = on;
  byId("play").setAttribute("aria-label", on ? "Pause" : "Play");
  byId("icon").setAttribute("d", on ? "M3 2H7V14H3ZM9 2H13V14H9Z" : "M4 2L14 8L4 14Z");
}
byId("play").addEventListener("click", () => setPlaying(!playing));
byId("s").addEventListener("input", (event) => { setPlaying(false); show(+event.target.value); });

// page.html#s=0.5 opens at a place. Nothing moves before it is asked to.
const place = parseFloat(new URLSearchParams(location.hash.slice(1)).get("s"));
show(Number.isFinite(place) ? place : 0);
</script>
</body>
</html>
)page";

}  // namespace v0
}  // namespace tandem
