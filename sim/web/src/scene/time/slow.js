/** Slow motion in contacts: which parts of a run, and how slow. */

/** @typedef {{from: number, to: number, rate: number}} SlowPart cart seconds; rate: cart seconds per second */

const WATCH = 3; // s that a contact should last on the screen, at least
const BEFORE = 0.15; // of the contact's duration, shown slow before it
const AFTER = 0.25;
const SLOWEST = 1e-12; // times the true speed
const RATES = [0.5, 0.2, 0.1];

/** @param {number} duration of a contact in s @returns {number} 1/2, 1/5, 1/10, 1/20 …: how much slower */
function rateFor(duration) {
  const wanted = duration / WATCH;
  for (let power = 1; power > SLOWEST; power /= 10) {
    for (const rate of RATES) if (rate * power <= wanted) return rate * power;
  }
  return wanted;
}

/** @param {import("../../../../view/windows.js").Touch[]} touches @returns {SlowPart[]} in order, not overlapping */
export function slowParts(touches) {
  /** @type {SlowPart[]} */
  const parts = [];
  for (const { start, end } of touches) {
    const duration = end - start;
    const rate = rateFor(duration);
    if (rate >= 1) continue;
    const part = { from: start - BEFORE * duration, to: end + AFTER * duration, rate };
    const last = parts.at(-1);
    if (last && part.from <= last.to) {
      last.to = Math.max(last.to, part.to);
      last.rate = Math.min(last.rate, rate);
    } else parts.push(part);
  }
  return parts;
}

/** @param {SlowPart[]} parts @param {number} t @returns {SlowPart | undefined} the part that t lies in */
export function slowAt(parts, t) {
  return parts.find((part) => t >= part.from && t < part.to);
}

/**
 * Where the carts are after `seconds` on the screen. Boundaries of slow parts are never jumped.
 * @param {number} t @param {number} seconds @param {number} speed @param {SlowPart[]} parts @param {number} until
 */
export function advance(t, seconds, speed, parts, until) {
  let now = t;
  let left = seconds;
  while (left > 0 && now < until) {
    const inside = slowAt(parts, now);
    const rate = inside ? Math.min(speed, inside.rate) : speed;
    const edge = inside ? inside.to : (parts.find((part) => part.from > now)?.from ?? until);
    const next = Math.min(edge, until);
    if (now + left * rate < next) return now + left * rate;
    left -= (next - now) / rate;
    now = next;
  }
  return Math.min(now, until);
}

/** @param {number} rate @returns {string} “1/50” or “10×” */
export function rateText(rate) {
  return rate < 1 ? `1/${Math.round(1 / rate)}` : `${rate}×`;
}
