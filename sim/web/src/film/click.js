/** A click while a film is set up: an end of the ruler, or the mark that is found under it in this frame. */

import * as words from "./words.js";

const ENDS = ["one", "other"];

/**
 * Sets what is aimed at. A frame that is on its way takes no mark: it would be one of the frame before.
 * @param {{helper: import("./helper.js").Helper, frames: import("./frames.js").Frames, setup: import("./setup.js").Setup}} film
 * @param {import("./along.js").Point} point @returns {Promise<string>} why nothing was set; empty: it was, or another frame is shown now
 */
export async function click({ helper, frames, setup }, point) {
  const { aim } = setup;
  if (frames.coming) return "";
  if (ENDS.includes(aim)) {
    setup.set(point);
    return "";
  }
  const { time } = frames;
  const asked = { do: "mark", time, click: point };
  const { mark } = await helper.ask(asked).catch(() => ({ mark: null }));
  if (setup.aim !== aim || frames.time !== time || frames.coming) return "";
  if (!mark) return words.nothingThere();
  if (setup.isOther(mark)) return words.otherMark(aim);
  setup.set(mark);
  return "";
}
