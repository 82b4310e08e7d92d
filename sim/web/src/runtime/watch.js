// A clock that counts seconds in which this page was awake. A laptop that slept for an hour, or a tab
// that was in the background, has not waited for an hour.

const SECOND = 1000;

/** In s without progress until the reader is told that it takes long: within 5 s, on a busy computer too. */
export const SLOW_AFTER = 3;

/** In s without progress after which Python, or its table of contents, counts as lost. */
export const PATIENCE = 8;

/** In s without a sign, of what takes long: readings are fitted here in a second, on a slow laptop in twenty. */
export const AT_WORK = 60;

/**
 * In s without progress while Python starts: then it is given up. A step of the plain start, without a
 * memory snapshot, is silent for two seconds here, and for half a minute on a laptop fifteen times as slow.
 */
export const LOST = 60;

/**
 * In s that a request over a network may take: two files of 1.6 MB at 140 kbit/s. One that a gateway holds
 * open without an answer tells no error; it is asked for again.
 */
export const HELD = 180;

/**
 * Calls `late` once, after `patience` such seconds without a call of `progress`; `spent`: all of them so far.
 * @param {number} patience in s
 * @param {() => void} late
 */
export function watch(patience, late) {
  let [left, spent] = [patience, 0];
  const timer = setInterval(() => {
    left -= 1;
    spent += 1;
    if (left > 0) return;
    clearInterval(timer);
    late();
  }, SECOND);
  return {
    get spent() {
      return spent;
    },
    progress() {
      left = patience;
    },
    stop() {
      clearInterval(timer);
    },
  };
}
