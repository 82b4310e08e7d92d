/**
 * Where methods break: one square for each run, the number of the scene across, the step upwards.
 * The darker, the more right digits.
 */

import { counted, tr } from "../language.js";
import { html } from "../markup.js";
import { px, short, superscript } from "../numbers.js";
import { METHODS } from "./methods.js";

/** @typedef {import("../markup.js").Markup} Markup */
/**
 * @typedef {{name: string, path: string[], values: number[], letters: Record<string, string>,
 *   lines: {contact: number[], swing: number[]}}} BreaksMap
 * @typedef {{parts: number[], limits: Record<string, number>, scene: Record<string, any>, maps: BreaksMap[]}} Breaks
 * @typedef {{column: number, row: number}} Point
 */

export const [WIDTH, HEIGHT] = [520, 372];
export const [LEFT, TOP, RIGHT, BOTTOM] = [62, 10, 510, 322];
export const TICKS_Y = BOTTOM + 16; // of the numbers across
const MADE = tr("energy was made");
const DIGITS = [0, 1, 2, 3, 4, 5, 6, 7, 8];
const UNITS = /** @type {Record<string, string>} */ ({ stiffness: "N/m", mass: "kg" });

/** @param {number} count @returns {{wide: number, high: number}} of a square */
const cell = (count) => ({ wide: (RIGHT - LEFT) / count, high: (BOTTOM - TOP) / count });

/** @param {Breaks} breaks @param {BreaksMap} map @param {string} method @returns {[string, string][]} kind of point and where it is, as a path */
export function squares({ parts }, map, method) {
  const { wide, high } = cell(parts.length);
  /** @type {Record<string, string>} */
  const paths = {};
  [...(map.letters[method] ?? "")].forEach((letter, k) => {
    const [column, row] = [Math.floor(k / parts.length), k % parts.length];
    const [x, y] = [px(LEFT + column * wide), px(BOTTOM - (row + 1) * high)];
    const box = `M${x} ${y}h${px(wide)}v${px(high)}h-${px(wide)}Z`;
    paths[letter] = (paths[letter] ?? "") + box;
  });
  return Object.entries(paths).sort();
}

/** Theory over it: a step of the contact's length, and the limit of stability. @param {Breaks} breaks @param {BreaksMap} map @param {string} method @returns {[string, string]} paths */
export function theory({ parts, limits }, map, method) {
  const { wide } = cell(parts.length);
  const limit = limits[method];
  const path = (/** @type {number[]} */ steps) =>
    steps
      .map((h, k) => [LEFT + (k + 0.5) * wide, yOf(parts, h)])
      .filter(([, y]) => Number(y) >= TOP && Number(y) <= BOTTOM)
      .map(([x, y], k) => `${k ? "L" : "M"}${px(Number(x))} ${px(Number(y))}`)
      .join("");
  return [path(map.lines.contact), limit ? path(map.lines.swing.map((h) => h * limit)) : ""];
}

/** @param {number[]} parts @param {number} h s @returns {number} beyond the picture for steps that no run has */
function yOf(parts, h) {
  const [short_, long] = [1 / Number(parts[0]), 1 / Number(parts.at(-1))];
  const part = Math.log(h / short_) / Math.log(long / short_);
  const { high } = cell(parts.length);
  return BOTTOM - high / 2 - part * (BOTTOM - TOP - high);
}

/** @param {Breaks} breaks @param {Point} point @returns {{x: string, y: string, width: string, height: string}} */
export function ring({ parts }, { column, row }) {
  const { wide, high } = cell(parts.length);
  const [x, y] = [LEFT + column * wide, BOTTOM - (row + 1) * high];
  return { x: px(x - 1), y: px(y - 1), width: px(wide + 2), height: px(high + 2) };
}

/** @param {Breaks} breaks @param {number} x @param {number} y in the units of the picture @returns {Point} */
export function pointAt({ parts }, x, y) {
  const { wide, high } = cell(parts.length);
  const within = (/** @type {number} */ k) =>
    Math.min(parts.length - 1, Math.max(0, Math.floor(k)));
  return { column: within((x - LEFT) / wide), row: within((BOTTOM - y) / high) };
}

/** @param {BreaksMap} map @param {number} value */
export function valueText(map, value) {
  const unit = UNITS[map.path.at(-1) ?? ""];
  return unit ? `${short(value)} ${unit}` : short(value);
}

/** What was found there. @param {Breaks} breaks @param {BreaksMap} map @param {string} method @param {Point} point */
export function found({ parts }, map, method, { column, row }) {
  const letter = map.letters[method]?.[column * parts.length + row] ?? "";
  return tr("{method}, {quantity} {value}, {steps} steps in 1 s: {found}.", {
    method: METHODS[method]?.label ?? method,
    quantity: map.name,
    value: valueText(map, Number(map.values[column])),
    steps: Number(parts[row]),
    found: letter === "x" ? MADE : digitsText(Number(letter)),
  });
}

/** @param {number} n */
const digitsText = (n) => counted("1 right digit", "{n} right digits", n);

/** The scene of a point. @param {Breaks} breaks @param {BreaksMap} map @param {number} column */
export function sceneOf({ scene }, map, column) {
  const plain = structuredClone(scene);
  let place = plain;
  for (const key of map.path.slice(0, -1)) place = place[key];
  place[map.path.at(-1) ?? ""] = map.values[column];
  return plain;
}

/** The same run at a command line. @param {object} scene @param {string} method @param {number} parts */
export function command(scene, method, parts) {
  return `echo '${JSON.stringify(scene)}' | carts run - --method ${method} --step ${1 / parts}`;
}

/** @param {BreaksMap} map @returns {[number, string][]} where across, and what stands there */
export function ticks(map) {
  const [low, high] = [Number(map.values[0]), Number(map.values.at(-1))];
  const { wide } = cell(map.values.length);
  const grows = high / low > 100 && map.path.at(-1) !== "restitution";
  const places = grows
    ? [-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7, 8].map((k) => 10 ** k)
    : [0.2, 0.4, 0.6, 0.8, 1];
  const part = (/** @type {number} */ v) =>
    grows ? Math.log(v / low) / Math.log(high / low) : (v - low) / (high - low);
  return places
    .filter((v) => part(v) > -0.03 && part(v) < 1.03)
    .map((v) => [
      LEFT + wide / 2 + part(v) * (RIGHT - LEFT - wide),
      grows && (v >= 1000 || v < 0.01) ? `10${superscript(Math.round(Math.log10(v)))}` : short(v),
    ]);
}

/** @param {Breaks} breaks @returns {Markup} the part of `<carts-cost>` below the figure */
export function breaksPart(breaks) {
  const first = /** @type {BreaksMap} */ (breaks.maps[0]);
  const names = Object.keys(first.letters);
  const method = "verlet";
  const steps = [0.001, 0.01, 0.1].map(
    (h) =>
      html`<text class="carts-tick-y" x=${LEFT - 7} y=${px(yOf(breaks.parts, h) + 4)}>${short(h)}</text>`,
  );
  const [contact, limit] = theory(breaks, first, method);
  return html`<div class="carts-cost-breaks">
<p class="carts-heading">${tr("Where methods break")}</p>
<div class="carts-cost-choice"><label>${tr("method")} <select autocomplete="off" class="carts-breaks-method" disabled>${names.map((name) => html`<option value=${name}${name === method && html` selected`}>${METHODS[name]?.label}</option>`)}</select></label>
<label>${tr("across")} <select autocomplete="off" class="carts-breaks-map" disabled>${breaks.maps.map(({ name }, k) => html`<option value=${k}>${name}</option>`)}</select></label></div>
<svg class="carts-breaks-picture" viewBox="0 0 ${WIDTH} ${HEIGHT}" width=${WIDTH} height=${HEIGHT} role="img" aria-label=${tr("right digits of the velocities for each step and each value; the lists below reach every point")}>
<g class="carts-breaks-squares">${squares(breaks, first, method).map(([kind, d]) => html`<path class="carts-breaks-${kind}" d=${d}/>`)}</g>
<path class="carts-breaks-contact" d=${contact}/><path class="carts-breaks-limit" d=${limit}/>
${steps}<g class="carts-breaks-ticks">${ticks(first).map(([x, text]) => html`<text class="carts-tick-x" x=${px(x)} y=${TICKS_Y}>${text}</text>`)}</g>
<text class="carts-unit carts-breaks-unit" x=${RIGHT} y=${BOTTOM + 36} text-anchor="end">${unitText(first)}</text>
<text class="carts-unit" transform="translate(14 ${(TOP + BOTTOM) / 2}) rotate(-90)" text-anchor="middle">${tr("step in s")}</text>
<rect class="carts-breaks-ring" visibility="hidden"/>
</svg>
<ul class="carts-cost-key">${DIGITS.map((k) => sample(`${k}`, SQUARE, k === 8 ? digitsText(k) : `${k}`))}${sample("x", SQUARE, MADE)}${sample("contact", DASH, tr("a step as long as the contact"))}${sample("limit", DASH, tr("limit of stability"))}</ul>
<div class="carts-cost-choice"><label>${tr("value")} <select autocomplete="off" class="carts-breaks-value" disabled>${first.values.map((value, k) => html`<option value=${k}>${valueText(first, value)}</option>`)}</select></label>
<label>${tr("steps in 1 s")} <select autocomplete="off" class="carts-breaks-step" disabled>${breaks.parts.map((n, k) => html`<option value=${k}>${n}</option>`)}</select></label> <button type="button" class="carts-button carts-breaks-run" disabled>${tr("Run it above")}</button></div>
<p class="carts-breaks-found" role="status"></p>
<pre class="carts-breaks-command" hidden></pre>
</div>`;
}

const [SQUARE, DASH] = ["M0 0H16V16H0Z", "M0 8H16"];

/** An entry of the key. @param {string} kind of point or line @param {string} d @param {string} text */
function sample(kind, d, text) {
  return html`<li><svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path class="carts-breaks-${kind}" d=${d}/></svg> ${text}</li>`;
}

/** @param {BreaksMap} map */
export function unitText(map) {
  const unit = UNITS[map.path.at(-1) ?? ""];
  return unit ? tr("{label} in {unit}", { label: map.name, unit }) : map.name;
}
