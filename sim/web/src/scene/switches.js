/** Boxes to tick: whether an effect acts. And what the run says about sliders for effects. */

import { effectOf } from "../../../view/effects.js";
import { need, say } from "../shared/dom.js";

/** @typedef {import("../../../view/types.js").Header} Header */

export class Switches {
  /** @type {Map<string, HTMLInputElement>} */
  #boxes = new Map();
  /** @type {Header | null} of the run on screen */
  #header = null;

  /**
   * @param {HTMLElement} root @param {{set: string, value: boolean}[]} switches
   * @param {(target: string, value: boolean, at: number) => void} change `at`: time of the input
   */
  constructor(root, switches, change) {
    for (const { set } of switches) {
      const box = /** @type {HTMLInputElement | null} */ (
        root.querySelector(`[data-switch="${CSS.escape(set)}"]`)
      );
      if (!box) continue;
      this.#boxes.set(set, box);
      box.addEventListener("change", (event) => change(set, box.checked, event.timeStamp));
    }
  }

  /** @param {boolean} on */
  enable(on) {
    for (const box of this.#boxes.values()) box.disabled = !on;
  }

  /** Shows what acts in the run on screen; a box that was ticked since stays so. @param {Header} header @param {Set<string>} pending */
  show(header, pending = new Set()) {
    this.#header = header;
    for (const [set, box] of this.#boxes) {
      if (pending.has(set)) continue;
      const effect = effectOf(set, header);
      if (effect) box.checked = effect.active;
      need(/** @type {Element} */ (box.closest(".carts-switch")), ".carts-error").hidden = true;
    }
  }

  /** A switch that was refused goes back, and says why. @param {string} target @param {string} message @returns {boolean} whether there is such a switch */
  complain(target, message) {
    const box = this.#boxes.get(target);
    if (!box) return false;
    if (this.#header) this.show(this.#header);
    const error = need(/** @type {Element} */ (box.closest(".carts-switch")), ".carts-error");
    say(error, message);
    error.hidden = false;
    return true;
  }
}

/** What a run says about a slider's number of an effect; null where it has none. @param {Header} header @param {string} target @returns {number | null} */
export function effectValue(header, target) {
  const key = target.slice(target.lastIndexOf(".") + 1);
  return effectOf(target, header)?.numbers[key] ?? null;
}

/**
 * Where a scene as its author wrote it has what a change names; null where that is no effect.
 * @param {Record<string, any>} scene @param {string[]} keys of the change, such as friction, coefficient
 * @returns {string[] | null}
 */
export function effectPath({ effects }, keys) {
  if (!Array.isArray(effects)) return null;
  const kind = keys[0] === "effects" ? "" : String(keys[0]);
  const index = kind ? effects.findIndex((entry) => kind in entry) : Number(keys[1]);
  const entry = effects[index];
  return entry && keys.length > 1
    ? ["effects", String(index), String(Object.keys(entry)[0]), String(keys.at(-1))]
    : null;
}
