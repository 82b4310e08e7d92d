/** The rows of a certificate: what it is of, its two bounds, and how many digits they agree in. */

import { body } from "../../../view/bodies.js";
import { counted, inRow, tr } from "../../../view/language.js";
import { exponent, fixed, superscript } from "../../../view/numbers.js";
import { html } from "../shared/dom.js";

/** @typedef {import("../../../view/types.js").Track} Track */
/** @typedef {[string, string]} Bounds decimal text, never rounded inwards */
/**
 * @typedef {{final: {x: Record<string, Bounds>, v: Record<string, Bounds>}, order: string, reason: any,
 *   events: {t: Bounds, kind: string, bodies: string[]}[]}} Certificate
 */

const MANY = 8; // sure digits: all of a bound is shown
const MORE = 3; // digits beside the sure ones
const LEAST = 3; // decimals of a nought that are told: from there on it is one
const FINEST = 17; // digits that tell one double from the next

/** @param {Certificate} certificate @param {Track} track @returns {Element[]} events in their order, then the end */
export function rows({ final, events }, track) {
  const times = events
    .filter(({ kind }) => kind !== "end")
    .map(({ t, kind, bodies }) =>
      row(tr("t: {event}", { event: named(kind, bodies, track) }), t, "s"),
    );
  const ends = Object.keys(final.x).flatMap((cart) => [
    row(tr("x of {cart} at the end", { cart }), /** @type {Bounds} */ (final.x[cart]), "m"),
    row(tr("v of {cart} at the end", { cart }), /** @type {Bounds} */ (final.v[cart]), "m/s"),
  ]);
  return [...times, ...ends];
}

/** @param {string} kind @param {string[]} bodies @param {Track} track */
function named(kind, bodies, track) {
  const names = bodies.map((name) => body(name, track));
  const [one = "", other = ""] = names;
  if (kind === "contact") return tr("{one} and {other} touch", { one, other });
  if (kind === "peak") return tr("{one} and {other} press hardest", { one, other });
  if (kind === "separate") return tr("{one} and {other} part", { one, other });
  if (kind === "release") return tr("{one} and {other} are released", { one, other });
  if (kind === "stick") return tr("{one} and {other} stay together", { one, other });
  if (kind === "stop") return tr("{one} stops", { one: inRow(names) });
  if (kind === "start") return tr("{one} starts", { one: inRow(names) });
  return `${kind} ${inRow(names)}`;
}

/** @param {string} label @param {Bounds} bounds @param {string} unit */
function row(label, bounds, unit) {
  const line = html("tr");
  const head = html("th", "", label);
  head.setAttribute("scope", "row");
  line.append(head);
  const { texts, count } = cells(bounds);
  for (const text of texts) line.append(html("td", "carts-proof-bound", `${text} ${unit}`));
  line.append(html("td", "", count));
  return line;
}

/** What a row says of its bounds. @param {Bounds} bounds @returns {{texts: string[], count: string}} */
export function cells(bounds) {
  const sure = sureDigits(bounds);
  if (!Number.isFinite(sure)) return { texts: [...bounds], count: tr("all") };
  const decimals = noughts(bounds);
  if (decimals >= LEAST) {
    const count = counted("0, to one decimal", "0, to {n} decimals", decimals);
    return { texts: [asPower(bounds[0], -1), asPower(bounds[1], 1)], count };
  }
  return { texts: shown(bounds, sure), count: sure ? String(sure) : tr("none") };
}

/** How many decimals of a value around 0 are 0 for sure, as one would round it; 0: it is not around 0. @param {Bounds} bounds */
function noughts([low, high]) {
  if (Number(low) > 0 || Number(high) < 0) return 0;
  const size = Math.max(Math.abs(Number(low)), Math.abs(Number(high)));
  return Math.max(0, Math.floor(-Math.log10(2 * size)));
}

/** −1.06 × 10⁻³⁰, rounded outwards. @param {string} bound @param {1 | -1} side */
function asPower(bound, side) {
  const value = Number(bound);
  if (!value) return "0";
  const digits = 100 * Number(value.toExponential().split("e")[0]);
  // One unit further out than the nearest, as in `shown`: a product may be rounded.
  const outside = (side > 0 ? Math.ceil(digits) : Math.floor(digits)) + side;
  const more = Math.abs(outside) >= 1000 ? 1 : 0;
  return `${fixed(outside / 10 ** (2 + more), 2)} × 10${superscript(exponent(value) + more)}`;
}

/** Of wide bounds some digits more than are sure, rounded outwards. @param {Bounds} bounds @param {number} sure */
function shown(bounds, sure) {
  const [low, high] = bounds.map(Number);
  const size = Math.max(Math.abs(low ?? 0), Math.abs(high ?? 0));
  if (sure > MANY || !size) return bounds;
  const decimals = Math.max(0, sure + MORE - Math.floor(Math.log10(size)));
  const unit = 10 ** decimals; // one unit further out than the nearest: a product may be rounded
  return [
    ((Math.floor(Number(low) * unit) - 1) / unit).toFixed(decimals),
    ((Math.ceil(Number(high) * unit) + 1) / unit).toFixed(decimals),
  ];
}

/** How many leading digits two bounds have in common, rounded as one would write them. @param {Bounds} bounds */
export function sureDigits([low, high]) {
  const [a, b] = [Number(low), Number(high)];
  if (a === b) return Infinity;
  for (let digits = FINEST; digits > 0; digits -= 1) {
    if (Number(a.toPrecision(digits)) === Number(b.toPrecision(digits))) return digits;
  }
  return 0;
}
