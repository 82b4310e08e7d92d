/**
 * A stopwatch that counts the carts' time, in slow motion too, from the instant of the picture at which it
 * is started to that at which it is stopped. Started again it counts on. Time that is pulled back counts as
 * it is: nothing below zero.
 */

import { fixed } from "../../../view/numbers.js";
import { need, put, say } from "../shared/dom.js";

/** @typedef {HTMLElement & {time: number}} Scene */

const DECIMALS = 2; // of a hand-held stopwatch

/** @param {Scene} scene its inside may be drawn anew: the scene itself is listened to */
export function workStopwatch(scene) {
  let counted = 0; // s, before the last start
  /** @type {number | null} s, the instant of the last start while it runs */
  let started = null;
  let here = need(scene, '[data-tool="stopwatch"]');

  /** The stopwatch on the page: where its scene has started again, it is another reader's. */
  const tool = () => {
    const now = need(scene, '[data-tool="stopwatch"]');
    if (now !== here) [here, counted, started] = [now, 0, null];
    return here;
  };
  const reading = () => counted + (started === null ? 0 : Math.max(0, scene.time - started));
  const show = () => {
    const button = need(tool(), '[data-act="stop"]');
    const read = need(here, "output");
    put(read, "aria-live", started === null ? "polite" : "off"); // it is read out when it stands
    say(read, fixed(reading(), DECIMALS));
    say(button, (started === null ? button.dataset.start : button.dataset.stop) ?? "");
  };
  const follow = () => {
    if (started === null || !scene.isConnected) return;
    show();
    requestAnimationFrame(follow);
  };
  scene.addEventListener("click", ({ target }) => {
    const button = /** @type {Element} */ (target).closest('[data-tool="stopwatch"] [data-act]');
    if (!button) return;
    tool();
    if (button.getAttribute("data-act") === "zero") {
      counted = 0;
      if (started !== null) started = scene.time;
    } else if (started === null) {
      started = scene.time;
      follow();
    } else {
      counted = reading();
      started = null;
    }
    show();
  });
}
