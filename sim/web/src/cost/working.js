/** Whether a measurement is on: its button gives way to “Stop” and a bar. */

import { need } from "../shared/dom.js";

/** @param {HTMLElement} root @param {boolean} on */
export function showWorking(root, on) {
  const [go, stop] = [need(root, ".carts-cost-go"), need(root, ".carts-cost-stop")];
  const focused = document.activeElement === (on ? go : stop);
  go.hidden = on;
  stop.hidden = !on;
  const progress = /** @type {HTMLProgressElement} */ (need(root, ".carts-cost-progress"));
  progress.hidden = !on;
  progress.value = 0;
  if (focused) (on ? stop : go).focus();
}
