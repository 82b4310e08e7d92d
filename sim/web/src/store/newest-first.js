/**
 * Fast typing must not queue: while a value is being written, only the newest one after it waits. Its
 * promise is that of all that it replaced, so “Saved” is said when the newest is kept. To forget a key
 * (`GONE` under it) waits in the same line: what was typed before it does not come back, what after stays.
 */

export const GONE = Symbol("forgotten");

/** @typedef {(key: string, value: any, alone?: boolean) => Promise<void>} Put */

/** @param {Put} put @returns {Put} the same, with one write in flight for each key and at most one waiting */
export function newestFirst(put) {
  /** @type {Map<string, {next: {value: any, alone: boolean, anew: boolean, written: Promise<void>} | null, now: Promise<void>}>} */
  const flights = new Map();

  /** @type {(key: string, value: any, alone: boolean) => Promise<void>} */
  function start(key, value, alone) {
    const now = put(key, value, alone);
    flights.set(key, { now, next: null });
    const over = () => {
      if (flights.get(key)?.now === now && !flights.get(key)?.next) flights.delete(key);
    };
    now.then(over, over);
    return now;
  }

  return (key, value, alone = false) => {
    const flight = flights.get(key);
    if (!flight) return start(key, value, alone);
    if (flight.next) {
      flight.next.value = value;
      flight.next.alone &&= alone;
      flight.next.anew ||= value === GONE;
      return flight.next.written;
    }
    const next = { value, alone, anew: value === GONE, written: Promise.resolve() };
    const begin = () => start(key, next.value, next.alone || next.anew);
    next.written = flight.now.then(begin, begin);
    flight.next = next;
    return next.written;
  };
}
