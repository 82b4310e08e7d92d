/**
 * Fast typing must not queue: while values are being written, only the newest one after them waits. Its
 * promise is that of all that it replaced, so “Saved” is said when the newest is kept.
 */

/** @typedef {(key: string, value: any, alone?: boolean) => Promise<void>} Put */
/** @typedef {{value: any, alone: boolean, written: Promise<void>, as: (start: Promise<void>) => void}} Waiting */

/** Writes under way at a time. On a slow computer the last key would wait for two ways to the disk
 * and back if there were one; the browser ends them in the order in which they began. */
const UNDER_WAY = 3;

/** @param {Put} put @returns {Put} the same, with a few writes under way for each key and at most one waiting */
export function newestFirst(put) {
  /** @type {Map<string, {count: number, next: Waiting | null}>} */
  const flights = new Map();

  /** @type {(key: string, value: any, alone: boolean) => Promise<void>} */
  function start(key, value, alone) {
    const flight = flights.get(key) ?? { count: 0, next: null };
    flights.set(key, flight);
    flight.count += 1;
    const over = () => {
      flight.count -= 1;
      const { next } = flight;
      flight.next = null;
      if (next) next.as(start(key, next.value, next.alone));
      else if (!flight.count) flights.delete(key);
    };
    const written = put(key, value, alone);
    written.then(over, over);
    return written;
  }

  return (key, value, alone = false) => {
    const flight = flights.get(key);
    if (!flight || flight.count < UNDER_WAY) return start(key, value, alone);
    if (flight.next) {
      flight.next.value = value;
      flight.next.alone &&= alone;
      return flight.next.written;
    }
    /** @type {Waiting["as"]} */
    let as = () => {};
    const written = /** @type {Promise<void>} */ (new Promise((resolve) => (as = resolve)));
    flight.next = { value, alone, written, as };
    return written;
  };
}
