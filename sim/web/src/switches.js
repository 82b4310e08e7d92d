/** Boxes to tick: whether an effect acts. And what the run says about sliders for effects. */

/** @typedef {import("./types.js").Header} Header */

export class Switches {
  /** @type {Map<string, HTMLInputElement>} */
  #boxes = new Map();

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

  /** Shows what acts in the run on screen. @param {Header} header */
  show(header) {
    for (const [set, box] of this.#boxes) {
      const effect = effectOf(set, header);
      if (effect) box.checked = effect.active;
    }
  }
}

/** @param {string} target such as friction.active or effects.1.force @param {Header} header */
function effectOf(target, { effects }) {
  const owner = target.slice(0, target.lastIndexOf("."));
  return effects.find(({ kind, index }) =>
    [kind, `effects.${index}`, `effects.${index}.${kind}`].includes(owner),
  );
}

/** What a run says about a slider's number of an effect; null where it has none. @param {Header} header @param {string} target @returns {number | null} */
export function effectValue(header, target) {
  const key = target.slice(target.lastIndexOf(".") + 1);
  return effectOf(target, header)?.numbers[key] ?? null;
}
