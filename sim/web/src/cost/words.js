/** What is said while a reader compares and measures. */

import { joined, tr } from "../../../view/language.js";

export const POINT_RUNS = tr("The point of the map is being run …");
export const LOADING = tr("Python’s scipy is being loaded …");
export const LOADING_BOTH = tr("Python’s numpy and scipy are being loaded …");
export const [PLAY, PAUSE] = [tr("Play"), tr("Pause")];

/** @param {string} point what was found at a point of the map */
export const fromMap = (point) =>
  tr("From the map below: {point} Change anything here to go back.", { point });

/** @param {number} n rows */
export const stoppedWords = (n) => tr("Stopped after {n} rows.", { n });

/** @param {Map<string, string>} refused by method, what one says that cannot follow the scene */
export function doneWords(refused) {
  const just = tr("Measured just now, by Python in this browser.");
  const left = [...refused].map(([method, reason]) =>
    tr("{method}: {reason}.", { method, reason }),
  );
  return joined([just, ...left]);
}

/** @param {string | undefined} when with what, and on which day */
export const measuredWords = (when) =>
  when ? tr("Measured {when}.", { when }) : tr("Not measured yet.");

/** @param {string} reason */
export const keptWords = (reason) => tr("{reason} What was prepared stays as it is.", { reason });
