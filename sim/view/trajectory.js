/** A finished run and its values at any instant. */

/** @typedef {import("./types.js").Header} Header */
/** @typedef {import("./types.js").Trajectory} Trajectory */
/** @typedef {import("./types.js").Column} Column */

/**
 * Views into the worker's numbers: column k is numbers[k·rows, (k+1)·rows).
 * @param {Header} header @param {Float64Array} numbers @returns {Trajectory}
 */
export function fromWire(header, numbers) {
  const { rows, columns, events } = header;
  /** @type {any} */
  const parts = { t: new Float64Array(0), x: {}, v: {}, a: {}, F: {}, dF: {}, E: {}, events };
  columns.forEach(([quantity, ...key], k) => {
    const column = numbers.subarray(k * rows, (k + 1) * rows);
    const name = String(quantity);
    if (!key.length) parts[name] = column;
    else {
      parts[name] ??= {};
      parts[name][key.join(" ")] = column;
    }
  });
  return parts;
}

/**
 * The run that the generator baked into the page.
 * @param {Record<string, any>} numbers @param {import("./types.js").RunEvent[]} events @returns {Trajectory}
 */
export function fromBaked(numbers, events) {
  /** @type {any} */
  const parts = { t: Float64Array.from(numbers.t), events };
  for (const quantity of ["x", "v", "a", "F", "dF", "E"]) {
    parts[quantity] = {};
    for (const [key, column] of Object.entries(numbers[quantity] ?? {})) {
      parts[quantity][key] = Float64Array.from(/** @type {number[]} */ (column));
    }
  }
  return parts;
}

/** Whether this is a run; before a prediction is locked the page has its first row only. @param {import("./types.js").Run} run */
export function isTold({ trajectory }) {
  return trajectory.t.length > 1;
}

/** @param {Column} times @param {number} t @returns {number} last row at or before t; at a jump the one after it */
export function rowAt(times, t) {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (/** @type {number} */ (times[middle]) <= t) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

/**
 * Cubic Hermite between rows, straight lines without slopes, never across a jump.
 * @param {Column} times @param {Column} values @param {Column | null} slopes @param {number} t @returns {number}
 */
export function valueAt(times, values, slopes, t) {
  const k = rowAt(times, t);
  if (k < 0) return Number(values[0]);
  if (k >= times.length - 1) return Number(values[values.length - 1]);
  return hermite(times, values, slopes, k, t);
}

/**
 * The curve between row k and the next one.
 * @param {Column} times @param {Column} values @param {Column | null} slopes @param {number} k @param {number} t @returns {number}
 */
export function hermite(times, values, slopes, k, t) {
  const at = /** @type {(column: Column, k: number) => number} */ ((c, i) => c[i]);
  const h = at(times, k + 1) - at(times, k);
  const s = (t - at(times, k)) / h;
  if (!slopes) return at(values, k) + (at(values, k + 1) - at(values, k)) * s;
  const r = 1 - s;
  const found =
    at(values, k) * (1 + 2 * s) * r * r +
    at(slopes, k) * h * s * r * r +
    at(values, k + 1) * (1 + 2 * r) * s * s -
    at(slopes, k + 1) * h * r * s * s;
  return Number.isFinite(found) ? found : at(values, k); // slopes beyond all numbers: a step
}

/**
 * Where the curve turns between row k and the next, as a cart does on a slope within one flight;
 * exact where its slope is a straight line.
 * @param {Column} times @param {Column} values @param {Column | null} slopes @param {number} k
 * @returns {number | null} the value there; null where it does not turn
 */
export function turnAfter(times, values, slopes, k) {
  const [before, after] = [Number(slopes?.[k]), Number(slopes?.[k + 1])];
  const [begin, span] = [Number(times[k]), Number(times[k + 1]) - Number(times[k])];
  if (!slopes || !(before * after < 0) || !(span > 0)) return null;
  return hermite(times, values, slopes, k, begin + (span * before) / (before - after));
}
