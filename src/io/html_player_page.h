#pragma once

/// The HTML player's page: %TITLE% is filled in, and the data of the morph goes between the two parts.
namespace tandem {
inline namespace v0 {

inline constexpr const char* kPlayerHead = R"page(<!DOCTYPE html>
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
  --page: #f4f2ee; --card: #fffefb; --line: #e2ded6; --ink: #232a36; --soft: #6d7482; --accent: #3f62c8;
  --skin: #3f62c8; --from: #3f62c8; --to: #c2562f;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #14171c; --card: #1b1f26; --line: #2c323c; --ink: #e7e9ee; --soft: #98a1b0; --accent: #8ea8ff;
    --skin: #8ea8ff; --from: #8ea8ff; --to: #f0a37f;
  }
}
* { box-sizing: border-box; }
html, body { height: 100%; }
body {
  margin: 0; padding: clamp(.75rem, 2.5vw, 2rem); display: flex; justify-content: center;
  background: var(--page); color: var(--ink); font: 15px/1.45 system-ui, "Segoe UI", Roboto, sans-serif;
}
main { width: min(100%, 54rem); min-height: 100%; display: flex; flex-direction: column; gap: .9rem; }
h1 { margin: 0; font-size: 1.05rem; font-weight: 600; letter-spacing: .005em; overflow-wrap: anywhere; }
.stage {
  flex: 1 1 0; min-height: 14rem; position: relative; background: var(--card); border: 1px solid var(--line);
  border-radius: 14px; overflow: hidden;
}
.stage svg { position: absolute; inset: 0; width: 100%; height: 100%; }
.fill { fill: var(--ink); }
.stroke { fill: none; stroke: var(--ink); stroke-linecap: butt; stroke-linejoin: round; }
#skins path { fill: none; vector-effect: non-scaling-stroke; stroke-width: 1.25px; }
.onion .fill { fill-opacity: .14; }
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
.strip { display: grid; grid-auto-flow: column; grid-auto-columns: 1fr; gap: .4rem; }
.strip button {
  height: auto; padding: 0; border-radius: 8px; aspect-ratio: 1; overflow: hidden; border-color: transparent;
  background: none;
}
.strip button.near { background: var(--card); border-color: var(--line); }
.strip button.key { color: var(--accent); }
.strip svg { display: block; width: 100%; height: 100%; }
.strip .fill { fill: var(--soft); }
.strip .stroke { stroke: var(--soft); }
.strip .key .fill { fill: var(--ink); }
.strip .key .stroke { stroke: var(--ink); }
.keys { margin: 0; color: var(--soft); font-size: .8rem; }
kbd { font: inherit; border: 1px solid var(--line); border-radius: 4px; padding: 0 .35em; }
@media (max-width: 34rem) { .strip button:nth-child(even) { display: none; } .keys { display: none; } #label { display: none; } }
</style>
</head>
<body>
<main>
<h1>%TITLE%</h1>
<div class="stage" id="stage">
<svg id="picture" role="img" aria-label="The in-between at the slider's position"><g id="skins"></g><path class="fill" id="fill"/><path class="stroke" id="stroke"/></svg>
</div>
<div class="bar">
<button id="play" type="button" aria-label="Play"><svg viewBox="0 0 16 16" aria-hidden="true"><path id="icon" d="M4 2L14 8L4 14Z"/></svg></button>
<input id="s" type="range" min="0" max="1" step="0.001" value="0" aria-label="Position s between the shapes" list="ticks">
<datalist id="ticks"></datalist>
<output id="value" for="s">0.00</output>
<button id="onion" type="button" aria-pressed="false" title="Show all in-betweens at once">Onion skin</button>
</div>
<div class="strip" id="strip"></div>
<p class="keys"><kbd>Space</kbd> play or pause &ensp; <kbd>←</kbd> <kbd>→</kbd> step &ensp; <kbd>O</kbd> onion skin</p>
</main>
)page";

inline constexpr const char* kPlayerScript = R"page(<script>
"use strict";
const morph = JSON.parse(document.getElementById("morph").textContent);
const keyTimes = morph.keys.map((i) => morph.times[i]);
const last = keyTimes.length - 1;
const byId = (id) => document.getElementById(id);
const size = Math.max(morph.view[2], morph.view[3]);
const still = matchMedia("(prefers-reduced-motion: reduce)").matches;

// The last of the rising values that is no greater than x, with another one behind it, and how far x is on the way there.
function locate(values, x) {
  let i = values.length - 2;
  while (i > 0 && values[i] > x) i--;
  return [i, (x - values[i]) / (values[i + 1] - values[i])];
}

// The library's blend: evenly from frame to frame, turned and moved with the moving frame.
function mover(i, local) {
  if (!morph.poses) return (x, y) => [x, y];
  const [cx, cy, degrees] = morph.poses[i].map((a, k) => (1 - local) * a + local * morph.poses[i + 1][k]);
  const cosine = Math.cos(degrees * Math.PI / 180), sine = Math.sin(degrees * Math.PI / 180);
  return (x, y) => [cosine * x - sine * y + cx, sine * x + cosine * y + cy];
}

function blend(s) {
  const [i, local] = locate(morph.times, s);
  const place = mover(i, local);
  const parts = { fill: "", stroke: "" };
  for (const contour of morph.contours) {
    const a = contour.frames[i], b = contour.frames[i + 1];
    let at = 0;
    const next = () => (1 - local) * a[at] + local * b[at++];
    const point = () => place(next(), next()).map((x) => +x.toPrecision(8)).join(" ");
    let d = "M" + point();
    for (const command of contour.commands) {
      d += command + point();
      if (command === "C") d += " " + point() + " " + point();
    }
    parts[contour.closed ? "fill" : "stroke"] += contour.closed ? d + "Z" : d;
  }
  return parts;
}

const svg = (name, attributes) => {
  const node = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const key in attributes) node.setAttribute(key, attributes[key]);
  return node;
};

const box = morph.view.join(" ");
byId("picture").setAttribute("viewBox", box);
for (const id of ["fill", "stroke"]) {
  byId(id).setAttribute("fill-rule", morph.rule);
  byId(id).setAttribute("stroke-width", id === "stroke" ? size * 0.012 : 0);
}

// Film strip: every key and evenly spaced in-betweens.
const each = Math.max(1, Math.round(8 / last));
const strip = last * each;
const stripTimes = [];
for (let i = 0; i <= strip && strip <= 24; i++) {
  const button = document.createElement("button");
  button.type = "button";
  const isKey = i % each === 0;
  const key = Math.min(Math.floor(i / each), last - 1);
  const at = keyTimes[key] + (i / each - key) * (keyTimes[key + 1] - keyTimes[key]);
  stripTimes.push(at);
  button.className = isKey ? "key" : "";
  button.setAttribute("aria-label", isKey ? "Key " + (i / each + 1) : "In-between at " + at.toFixed(2));
  const picture = svg("svg", { viewBox: box, "aria-hidden": "true" });
  const parts = blend(at);
  picture.append(svg("path", { class: "fill", d: parts.fill, "fill-rule": morph.rule }),
                 svg("path", { class: "stroke", d: parts.stroke, "stroke-width": size * 0.02 }));
  button.append(picture);
  button.addEventListener("click", () => { pause(); show(at); });
  byId("strip").append(button);
}
for (const time of last > 1 ? keyTimes : []) {
  const tick = document.createElement("option");
  tick.value = time;
  byId("ticks").append(tick);
}

// Onion skin: outlines of all in-betweens, tinted from the first shape's colour to the last one's.
const skins = Math.max(12, last * 4);
function setOnion(on) {
  byId("onion").setAttribute("aria-pressed", on);
  byId("stage").classList.toggle("onion", on);
  byId("skins").replaceChildren();
  for (let i = 0; on && i <= skins; i++) {
    const parts = blend(i / skins);
    const end = i === 0 || i === skins;
    const path = svg("path", { d: parts.fill + parts.stroke, "stroke-opacity": end ? 0.95 : 0.45 });
    path.style.stroke = `color-mix(in srgb, var(--to) ${100 * i / skins}%, var(--from))`;
    if (!path.style.stroke) path.style.stroke = "var(--skin)";
    byId("skins").append(path);
  }
}

let s = 0;
function show(value) {
  s = Math.min(Math.max(value, 0), 1);
  const parts = blend(s);
  byId("fill").setAttribute("d", parts.fill);
  byId("stroke").setAttribute("d", parts.stroke);
  byId("s").value = s;
  byId("value").textContent = s.toFixed(2);
  const distance = (at) => Math.abs(at - s);
  const near = stripTimes.reduce((best, at, i) => distance(at) < distance(stripTimes[best]) ? i : best, 0);
  [...byId("strip").children].forEach((button, i) => button.classList.toggle("near", i === near));
}

// Timing: the eased share of a stretch, which is the way from one key to the next or all of it, and back again from a place
// to its time.
const stretches = morph.stretches.map((i) => morph.times[i]);
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
  const [i, local] = locate(stretches, value);
  return stretches[i] + share(morph.easings[Math.min(i, morph.easings.length - 1)], local) * (stretches[i + 1] - stretches[i]);
}
const timeToS = (time) => retimed(time, ([x1, y1, x2, y2], local) => solve(x1, x2, y1, y2, local));
const sToTime = (value) => retimed(value, ([x1, y1, x2, y2], local) => solve(y1, y2, x1, x2, local));

let playing = false, direction = 1, time = 0, before = 0;
function step(now) {
  if (!playing) return;
  time += direction * Math.min(now - before, 100) / 1000 / morph.duration;
  before = now;
  const turning = time > 1 && morph.alternate;
  const over = turning ? false : direction > 0 ? time > 1 : time < 0;
  if (over && !morph.repeat) {
    show(direction > 0 ? 1 : 0);
    direction = 1;
    pause();
    return;
  }
  if (turning) { direction = -1; time = Math.max(2 - time, 0); }
  if (time > 1) time %= 1;
  if (time < 0) { direction = 1; time = Math.min(-time, 1); }
  show(timeToS(time));
  requestAnimationFrame(step);
}
function setPlaying(on) {
  if (on && !playing) {
    time = sToTime(s);
    if (time >= 1 && !morph.alternate) time = 0;
    before = performance.now();
    requestAnimationFrame(step);
  }
  playing = on;
  byId("play").setAttribute("aria-label", on ? "Pause" : "Play");
  byId("icon").setAttribute("d", on ? "M3 2H7V14H3ZM9 2H13V14H9Z" : "M4 2L14 8L4 14Z");
}
const pause = () => setPlaying(false);

byId("play").addEventListener("click", () => setPlaying(!playing));
byId("s").addEventListener("input", (event) => { pause(); show(+event.target.value); });
byId("onion").addEventListener("click", () => setOnion(byId("onion").getAttribute("aria-pressed") !== "true"));
document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const control = event.target.closest("button, input");
  if (event.key === " " && !(control && control.tagName === "BUTTON")) { setPlaying(!playing); event.preventDefault(); }
  else if (event.key === "o" || event.key === "O") byId("onion").click();
  else if (event.key.startsWith("Arrow") && !(control && control.tagName === "INPUT")) {
    const by = { ArrowRight: 0.02, ArrowUp: 0.02, ArrowLeft: -0.02, ArrowDown: -0.02 }[event.key];
    pause(); show(s + by); event.preventDefault();
  }
});

// player.html#s=0.5&onion opens at a place, at rest.
const wanted = new URLSearchParams(location.hash.slice(1));
const place = parseFloat(wanted.get("s"));
show(Number.isFinite(place) ? place : 0);
setOnion(wanted.has("onion"));
if (!still && !Number.isFinite(place)) setPlaying(true);
</script>
</body>
</html>
)page";

}  // namespace v0
}  // namespace tandem
