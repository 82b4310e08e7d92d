/**
 * Whether the page is being left. A browser that goes to another page cancels what this one still
 * loads: that is no missing file, and nobody is there to read about it.
 */

const STAYS = 3000; // ms; a page that still runs so long after “beforeunload” was not left (a download)

let leaving = false;
/** @type {(() => void)[]} */
let waiting = [];

function stay() {
  leaving = false;
  for (const go of waiting) go();
  waiting = [];
}

addEventListener("beforeunload", () => {
  leaving = true;
  setTimeout(stay, STAYS);
});
addEventListener("pagehide", () => {
  leaving = true;
});
addEventListener("pageshow", stay); // back from the history: the page goes on where it was

// Firefox keeps a page that is left for its history, frozen, and with it a worker that is just
// starting; the worker of the next page then waits for that one for ever. A page that listens to
// “unload” is not kept.
if (navigator.userAgent.includes("Firefox/")) addEventListener("unload", () => {});

/** @returns {boolean} */
export const isLeaving = () => leaving;

/** Resolves when the page stays after all, which may be never. @returns {Promise<void>} */
export function staying() {
  return leaving ? new Promise((resolve) => waiting.push(resolve)) : Promise.resolve();
}
