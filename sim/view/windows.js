/** When bodies touch, or push each other by a spring that is let go. */

import { pairsApart } from "./effects.js";
import { rowAt } from "./trajectory.js";

/** @typedef {import("./types.js").RunEvent} RunEvent */
/** @typedef {{pair: string, bodies: string[], start: number, end: number, loose?: boolean, near?: boolean, lasts?: boolean}} Touch `loose`: by a spring; `near`: by a force that acts across the room between them; `lasts`: the bodies never part */

/**
 * Contacts that last, in order of their start. One that does not end lasts until its peak.
 * @param {RunEvent[]} events @param {number} until in s @returns {Touch[]}
 */
export function touches(events, until) {
  /** @type {Map<string, {touch: Touch, before: Record<string, number>}>} */
  const open = new Map(); // contacts by pair, springs by “loose A-B”
  /** @type {Map<string, number>} */
  const peaks = new Map();
  /** @type {Map<string, number>} */
  const anew = new Map();
  /** @type {Touch[]} */
  const found = [];
  for (const event of events) {
    const { bodies, before, t: start } = event;
    const pair = bodies.join("-");
    const touch = { pair, bodies, start, end: start };
    if (event.kind === "contact" && !event.impulse) {
      const old = open.get(pair); // parts and touches anew at one instant: the contact is told first
      if (old) found.push({ ...old.touch, end: start });
      if (old) anew.set(pair, start);
      open.set(pair, { touch, before });
    } else if (event.kind === "release" && !event.impulse) {
      open.set(`loose ${pair}`, { touch: { ...touch, loose: true }, before });
    } else if (event.kind === "peak") {
      peaks.set(pair, event.t);
    } else if (event.kind === "separate" && anew.get(pair) === start) {
      anew.delete(pair); // that was the old one
    } else if (event.kind === "separate" || event.kind === "stick") {
      const keys = [`loose ${pair}`, pair].filter((key) => open.has(key));
      const key = keys.length < 2 || begunWith(before, open.get(String(keys[0]))) ? keys[0] : pair;
      const over = key && open.get(key);
      if (!over) continue;
      open.delete(key);
      found.push({ ...over.touch, end: event.t });
    }
  }
  for (const { touch } of open.values()) {
    const peak = touch.loose ? until : (peaks.get(touch.pair) ?? until);
    found.push({ ...touch, end: peak > touch.start ? peak : until, lasts: true });
  }
  return found.filter((touch) => touch.end > touch.start).sort((a, b) => a.start - b.start);
}

/** @param {Record<string, number>} before @param {{before: Record<string, number>} | undefined} one */
function begunWith(before, one) {
  return Object.entries(one?.before ?? {}).every(([name, v]) => before[name] === v);
}

const ROUNDED = 1 + 1e-9; // times a force; two rows of one instant differ by less
const FELT = 0.1; // of the greatest force; less is not what one wants to see slowly

/**
 * Contacts, and the times in which pairs that never touch push each other most, in order.
 * @param {import("./types.js").Run} run @returns {Touch[]}
 */
export function windowsOf({ header, trajectory }) {
  const found = touches(header.events, header.until);
  const { t, F } = trajectory;
  for (const event of header.events) {
    const pair = event.bodies.join("-");
    const column = F[pair];
    const within = found.some(
      (touch) => touch.pair === pair && touch.start <= event.t && event.t <= touch.end,
    );
    if (event.kind !== "peak" || within || !column || t.length < 2) continue;
    const felt = (/** @type {number} */ k) => Number(column[k]) > FELT * (event.force ?? 0);
    let [first, last] = [rowAt(t, event.t), rowAt(t, event.t)];
    while (first > 0 && felt(first)) first -= 1;
    while (last < t.length - 1 && felt(last)) last += 1;
    const window = { start: Number(t[first]), end: Number(t[last]) };
    found.push({ pair, bodies: event.bodies, ...window, near: true });
  }
  for (const bodies of pairsApart(header)) {
    const pair = bodies.join("-");
    const end = letGo(t, F[pair] ?? []);
    const within = found.some((touch) => touch.pair === pair && touch.start <= 0);
    if (end && !within) found.push({ pair, bodies, start: 0, end, near: true });
  }
  return found.sort((a, b) => a.start - b.start);
}

/**
 * Until when carts that were let go beside each other are felt; 0 where their push does not fade.
 * @param {ArrayLike<number>} t in s @param {ArrayLike<number>} force in N, at those times
 */
function letGo(t, force) {
  const first = Number(force[0]);
  for (let row = 1; row < force.length; row += 1) {
    const now = Number(force[row]);
    if (now > first * ROUNDED) return 0; // they come nearer: that has its peak
    if (now < FELT * first) return Number(t[row]);
  }
  return 0;
}

/** @param {Touch[]} windows @param {number} t in s @returns {Touch | undefined} the touch that began last, up to t */
export function latestTouch(windows, t) {
  return windows.findLast((touch) => touch.start <= t);
}
