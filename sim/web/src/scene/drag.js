/**
 * Carts and their velocity arrows can be pulled along the track at t = 0, where the lesson offers a
 * slider for that value: the pointer is a second handle of the slider, with its limits and steps.
 */

/** @typedef {import("../../../view/types.js").Control} Control */
/** @typedef {import("../../../view/types.js").Layout} Layout */

export class Drag {
  /** @type {{control: Control, from: number, x: number, perUnit: number, sent: number} | null} */
  #held = null;

  /**
   * @param {SVGElement} stage @param {Layout} layout @param {import("../../../view/types.js").Baked} baked
   * @param {{ready: () => boolean, value: (target: string) => number | null, change: (control: Control, value: number, at: number) => void}} acts
   *   value: of the run that is shown, in SI
   */
  constructor(stage, layout, baked, acts) {
    const { controls } = baked.fence;
    for (const { name } of baked.run.header.bodies) {
      for (const [key, part, metres] of /** @type {const} */ ([
        ["position", "carts-cart", 1 / layout.scale],
        ["velocity", "carts-velocity", baked.view.velocity / layout.velocity],
      ])) {
        const control = controls.find(({ set }) => set === `${name}.${key}`);
        const group = stage.querySelector(`.${part}[data-body="${name}"]`);
        if (!control || !group) continue;
        group.classList.add("carts-draggable");
        group.addEventListener("pointerdown", (event) => {
          const value = acts.value(control.set);
          if (!acts.ready() || value === null) return;
          const down = /** @type {PointerEvent} */ (event);
          const unit = layout.width / stage.getBoundingClientRect().width;
          const from = value / control.per;
          const perUnit = (metres * unit) / control.per;
          this.#held = { control, from, x: down.clientX, perUnit, sent: from };
          group.setPointerCapture(down.pointerId);
          event.preventDefault();
        });
        group.addEventListener("pointermove", (event) => {
          const held = this.#held;
          if (held?.control !== control) return;
          const move = /** @type {PointerEvent} */ (event);
          const value = onStep(held.from + (move.clientX - held.x) * held.perUnit, control);
          if (value === held.sent) return;
          held.sent = value;
          acts.change(control, value, event.timeStamp);
        });
        for (const end of ["pointerup", "pointercancel"]) {
          group.addEventListener(end, () => {
            this.#held = null;
          });
        }
      }
    }
  }
}

/** @param {number} value @param {Control} control @returns {number} the nearest value that its slider has */
function onStep(value, { low, high, step }) {
  const near = low + Math.round((value - low) / step) * step;
  return Number(Math.min(high, Math.max(low, near)).toPrecision(12));
}
