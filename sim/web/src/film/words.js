/** What the film says to its reader. */

import { tr } from "../../../view/language.js";

/** @typedef {"A" | "B" | "one" | "other"} Aim what the next click sets */

const TRACKER = () => tr("Or follow the carts in Tracker and drop its file here.");

/** @param {string} code @param {string} detail @returns {string} why this film cannot be used, and the way out */
export function refusal(code, detail) {
  /** @type {Record<string, () => string>} */
  const reasons = {
    codec: () =>
      tr(
        "This browser cannot decode this film ({codec}). Set the camera to “most compatible” (H.264) and film again.",
        { codec: detail },
      ),
    format: () => tr("This is no film in MP4, MOV or WebM."),
    "no-picture": () => tr("There is no picture in this file."),
    "no-decoder": () =>
      tr(
        "This browser is too old to take films apart. Newer ones can: Chrome, Edge, Firefox, Safari.",
      ),
    "not-secure": () =>
      tr("Browsers decode films only on pages that come by https or lie on the computer itself."),
    broken: () => tr("This film cannot be read to its end: the file may be damaged."),
  };
  return `${(reasons[code] ?? reasons.broken)?.()} ${TRACKER()}`;
}

/** @param {Aim} aim @returns {string} what is to be done now */
export function asked(aim) {
  if (aim === "one") return tr("Click on one end of a ruler that lies along the track.");
  if (aim === "other") return tr("Click on the other end of the ruler.");
  return tr("Click on the mark of cart {name}.", { name: aim });
}

export const askLength = () => tr("Type how long the ruler is, then press “Follow”.");
export const nothingThere = () =>
  tr("Nothing stands out there. Click on a mark with a colour of its own.");
/** @param {string} name of the cart whose mark is to be set */
export const otherMark = (name) =>
  tr("That is the mark of the other cart. Click on the mark of cart {name}.", { name });

/** @param {string} problem */
export const lengthIsNone = (problem) => tr("Length of the ruler: {problem}", { problem });
export const endsAlike = () =>
  tr("Both ends of the ruler are in one place. Press the button of an end and set it anew.");

/** @param {number} frames @param {number} fewest */
export const tooFew = (frames, fewest) =>
  tr(
    "From this frame on the film is too short: {frames} of at least {fewest} frames. Set the marks earlier, or film for longer.",
    { frames, fewest },
  );
export const noCamera = () => tr("There is no camera here, or this page may not use it.");
export const cameraPicture = () => tr("picture of the camera");
export const startFilming = () => tr("Start filming");
export const stopFilming = () => tr("Stop filming");
export const opening = () => tr("Opening the film …");
export const cancelled = () => tr("Cancelled. Nothing was read.");
export const frameBroken = () => tr("This frame cannot be read.");
export const chooseMark = () =>
  tr("Press the button of a mark first; a click then sets its place anew.");
export const noneLost = () => tr("No lost place is left.");

/** @param {number} part 0 to 1 */
export const following = (part) =>
  tr("Following the marks: {percent} %", { percent: Math.round(100 * part) });

/** @param {string} name of a cart @param {string} time */
export const clickLost = (name, time) =>
  tr("Lost at {time} s. Click where the mark of cart {name} is.", { name, time });

/** @param {string} name of a cart @param {string} time */
export const setAnew = (name, time) => tr("{name} at {time} s was set anew.", { name, time });

/** @param {string} name of a cart @param {string} time */
export const asBefore = (name, time) => tr("{name} at {time} s is as it was.", { name, time });

/** @param {string} time */
export const brokenAt = (time) =>
  tr("Followed up to {time} s; the rest of the film cannot be read.", { time });

/** @param {number} frames @param {{name: string, count: number}[]} lost */
export function followed(frames, lost) {
  const counts = lost.filter(({ count }) => count);
  if (!counts.length) {
    return tr("Followed through {frames} frames. Nothing was lost.", { frames });
  }
  const names = counts.map(({ name, count }) => `${name}: ${count}`).join(", ");
  return tr("Followed through {frames} frames. Lost places, left out for now: {names}.", {
    frames,
    names,
  });
}
