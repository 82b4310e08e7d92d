/** What can be mended now; from a button that cannot be pressed any more the focus goes on. */

import { need } from "../shared/dom.js";
import { passOn } from "../shared/working.js";

/** @param {HTMLElement} root @param {import("./mending.js").Mending} mending @param {string} aim whose place a click would set */
export function offerMending(root, mending, aim) {
  const of = (/** @type {string} */ name) =>
    /** @type {HTMLButtonElement} */ (need(root, `.carts-film-${name}`));
  const can = { undo: mending.undoable, next: mending.lost.length > 0, leave: aim !== "" };
  for (const [name, on] of Object.entries(can)) {
    if (!on) passOn(of(name), of("read"));
    of(name).disabled = !on;
  }
}
