/** Something takes its time: its button gives way to “Stop”, or the other way round, and the focus goes along. */

import { need } from "./dom.js";

/** @param {KeyboardEvent} event */
const still = (event) => event.repeat && event.preventDefault();

/** The focus, if it is there, goes on to the button that takes over; a key that is still held does not press that one too. @param {HTMLElement} from @param {HTMLElement} to it can have the focus */
export function passOn(from, to) {
  if (document.activeElement !== from) return;
  to.addEventListener("keydown", still);
  to.focus();
}

/** @param {HTMLElement} root @param {string} name what its parts begin with @param {boolean} on */
export function showWorking(root, name, on) {
  const part = (/** @type {string} */ what) => need(root, `.carts-${name}-${what}`);
  const [from, to] = on ? [part("go"), part("stop")] : [part("stop"), part("go")];
  to.hidden = false;
  passOn(from, to);
  from.hidden = true;
  const progress = /** @type {HTMLProgressElement} */ (part("progress"));
  progress.hidden = !on;
  progress.value = 0;
}
