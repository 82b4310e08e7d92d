/** When bodies touch, or push each other by a spring that is let go. */

/** @typedef {import("./types.js").RunEvent} RunEvent */
/** @typedef {{pair: string, bodies: string[], start: number, end: number, loose?: boolean}} Touch `loose`: by a spring */

/**
 * Contacts that last, in order of their start. One that does not end lasts until its peak.
 * @param {RunEvent[]} events @param {number} until in s @returns {Touch[]}
 */
export function touches(events, until) {
  /** @type {Map<string, Touch>} */
  const open = new Map();
  /** @type {Map<string, number>} */
  const peaks = new Map();
  /** @type {Touch[]} */
  const found = [];
  for (const event of events) {
    const pair = event.bodies.join("-");
    const touch = open.get(pair);
    if (event.kind === "contact" && !event.impulse) {
      open.set(pair, { pair, bodies: event.bodies, start: event.t, end: event.t });
    } else if (event.kind === "release" && !event.impulse) {
      open.set(pair, { pair, bodies: event.bodies, start: event.t, end: event.t, loose: true });
    } else if (event.kind === "peak") {
      peaks.set(pair, event.t);
    } else if (touch && (event.kind === "separate" || event.kind === "stick")) {
      open.delete(pair);
      found.push({ ...touch, end: event.t });
    }
  }
  for (const touch of open.values()) {
    const peak = peaks.get(touch.pair) ?? until;
    found.push({ ...touch, end: peak > touch.start ? peak : until });
  }
  return found.filter((touch) => touch.end > touch.start).sort((a, b) => a.start - b.start);
}

/** @param {Touch[]} windows @param {number} t in s @returns {Touch | undefined} the touch that began last, up to t */
export function latestTouch(windows, t) {
  return windows.findLast((touch) => touch.start <= t);
}
