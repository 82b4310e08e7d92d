/** The curves of each graph. */

import { body as named, onBy } from "./bodies.js";
import { outside, partsOf } from "./effects-forces.js";
import { tr } from "./language.js";
import { styleOf } from "./markers.js";

/** @typedef {import("./types.js").Header} Header */
/** @typedef {import("./types.js").Trajectory} Trajectory */
/** @typedef {import("./types.js").Column} Column */
/** @typedef {{label: string, style: string, over: boolean, values: Column, slopes: Column | null}} Series */

/**
 * The curves of a quantity as a camera at `camera` m/s sees them. A force graph has two curves for
 * each contact, one per body; sizes by default, with a sign (+ to the right) when asked for.
 * @param {string} quantity @param {Header} header @param {Trajectory} run @param {number} camera @param {boolean} signed
 * @param {number} per m/s in the unit of the velocity graph
 * @returns {Series[]}
 */
export function seriesOf(quantity, header, run, camera, signed = false, per = 1) {
  if (quantity === "F") return forces(header, run, signed);
  if (quantity === "R") return resultants(header, run);
  const times = Float64Array.from(run.t);
  /** @type {Series[]} */
  const curves = header.bodies.map((body, i) => {
    const { name, mass } = body;
    const [x, v, a] = [run.x[name] ?? [], run.v[name] ?? [], run.a[name] ?? []];
    const seen = Float64Array.from(v, (speed) => speed - camera);
    const curve = { label: name, style: styleOf(i), over: false };
    switch (quantity) {
      case "x": {
        const values = Float64Array.from(x, (place, k) => place - camera * Number(times[k]));
        return { ...curve, values, slopes: seen };
      }
      case "v":
        return {
          ...curve,
          values: seen.map((speed) => speed / per),
          slopes: Float64Array.from(a, (rate) => rate / per),
        };
      case "a":
        return { ...curve, values: a, slopes: jerk(header, run, body, 1 / mass) };
      case "p":
        return {
          ...curve,
          values: seen.map((speed) => mass * speed),
          slopes: Float64Array.from(a, (value) => mass * value),
        };
      default:
        return {
          ...curve,
          values: seen.map((speed) => (mass * speed * speed) / 2),
          slopes: Float64Array.from(a, (rate, k) => mass * Number(seen[k]) * rate),
        };
    }
  });
  if (quantity === "p" && outside(header)) curves.push(partner(curves, outside(header)));
  if ((quantity === "p" || quantity === "energy") && curves.length > 1) curves.push(total(curves));
  return curves;
}

/** The resultant force on each cart, m a, and what it is the sum of: the forces of effects. @param {Header} header @param {Trajectory} run @returns {Series[]} */
function resultants(header, run) {
  return header.bodies.flatMap((body, i) => {
    const { name, mass } = body;
    const style = styleOf(i);
    const values = Float64Array.from(run.a[name] ?? [], (rate) => mass * rate);
    const parts = partsOf(header, run, name).map(({ by, column }) => ({
      label: tr("on {on} by {by}", { on: named(name, header.track), by }),
      style,
      over: true,
      values: column,
      slopes: null,
    }));
    const slopes = jerk(header, run, body, 1);
    return [{ label: name, style, over: false, values, slopes }, ...parts];
  });
}

/**
 * How fast the resultant on a cart grows, from the forces of its contacts; null where an effect
 * acts on it, whose forces come without their slopes.
 * @param {Header} header @param {Trajectory} run @param {{name: string}} body @param {number} per each N/s times that
 * @returns {Float64Array | null}
 */
function jerk(header, run, { name }, per) {
  if (header.effects.some(({ active, carts }) => active && carts.includes(name))) return null;
  const found = new Float64Array(run.t.length);
  for (const { pair, bodies } of header.contacts) {
    const column = bodies.includes(name) ? run.dF[pair] : null;
    const sign = bodies[0] === name ? -per : per; // its right neighbour pushes it to the left
    for (let k = 0; column && k < found.length; k += 1) {
      found[k] = Number(found[k]) + sign * Number(column[k]);
    }
  }
  return found;
}

/** What the carts have given away: to the wall, and the wall to the Earth. @param {Series[]} curves of all carts @param {string} label @returns {Series} */
function partner(curves, label) {
  const { values, slopes } = total(curves);
  const start = Number(values[0]);
  return {
    label,
    style: "wall",
    over: false,
    values: Float64Array.from(values, (value) => start - value),
    slopes: slopes && Float64Array.from(slopes, (slope) => -slope),
  };
}

/** @param {Series[]} curves @returns {Series} their sum */
function total(curves) {
  /** @param {(Column | null)[]} columns */
  const sum = (columns) => {
    const rows = Float64Array.from(columns[0] ?? []);
    for (const column of columns.slice(1)) {
      for (let k = 0; k < rows.length; k += 1) rows[k] = Number(rows[k]) + Number(column?.[k]);
    }
    return rows;
  };
  return {
    label: curves.some(({ style }) => style === "wall") ? tr("all together") : tr("all carts"),
    style: "total",
    over: false,
    values: sum(curves.map((c) => c.values)),
    slopes: curves.every((c) => c.slopes) ? sum(curves.map((c) => c.slopes)) : null,
  };
}

/** @param {Header} header @param {Trajectory} run @param {boolean} signed @returns {Series[]} */
function forces(header, run, signed) {
  const styles = new Map(header.bodies.map((body, i) => [body.name, styleOf(i)]));
  const sign = signed ? -1 : 1;
  /** @type {Series[]} */
  const curves = [];
  for (const contact of header.contacts) {
    let force = run.F[contact.pair];
    let slope = run.dF[contact.pair];
    if (!force || !slope || !Array.prototype.some.call(force, (f) => f !== 0)) continue;
    if (!signed) {
      const pulls = Array.from(force, (f) => f < 0); // sizes: a spring pulls with less than 0
      slope = Float64Array.from(slope, (s, k) => (pulls[k] ? -s : s));
      force = Float64Array.from(force, Math.abs);
    }
    const [left, right] = contact.bodies;
    curves.push({
      label: onBy(left, right, header.track),
      style: styles.get(left) ?? "wall",
      over: false,
      values: Float64Array.from(force, (f) => sign * f),
      slopes: Float64Array.from(slope, (s) => sign * s),
    });
    curves.push({
      label: onBy(right, left, header.track),
      style: styles.get(right) ?? "wall",
      over: true,
      values: force,
      slopes: slope,
    });
  }
  return curves;
}
