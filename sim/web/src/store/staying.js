/**
 * A browser whose disk is full forgets what sites have kept, the one that was opened longest ago first.
 * One that is asked to let it stay does not; Chromium and Safari decide that by themselves. Firefox asks
 * the reader with a window of its own, over the lesson, so it is left alone. Of a folder nobody asks:
 * there all refuse. (“Storage”, WHATWG, section 5)
 */

let asked = false;

/** Called when something is about to be kept; never waited for. */
export function letItStay() {
  const storage = navigator.storage; // old browsers and plain http have none
  if (asked || !storage?.persist || location.protocol === "file:") return;
  if (CSS.supports("-moz-appearance", "none")) return;
  asked = true;
  storage.persist().catch(() => {}); // what it says changes nothing: all is kept as before
}
