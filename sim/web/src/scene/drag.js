/**
 * Carts and their velocity arrows can be pulled along the track at t = 0, where the lesson offers a
 * slider for that value: the pointer is a second handle of the slider, with its limits and steps.
 */

import { followPointer } from "../shared/follow.js";

/** @typedef {import("../../../view/types.js").Control} Control */
/** @typedef {import("../../../view/types.js").Layout} Layout */

export class Drag {
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
        const group = /** @type {SVGElement | null} */ (
          stage.querySelector(`.${part}[data-body="${name}"]`)
        );
        if (!control || !group) continue;
        group.classList.add("carts-draggable");
        group.addEventListener("pointerdown", (event) => {
          const value = acts.value(control.set);
          if (!acts.ready() || value === null) return;
          const unit = layout.width / stage.getBoundingClientRect().width;
          const from = value / control.per;
          const perUnit = (metres * unit) / control.per;
          let sent = from;
          event.preventDefault();
          followPointer(event, (pixels, { timeStamp }) => {
            const to = onStep(from + pixels * perUnit, control);
            if (to === sent) return;
            sent = to;
            acts.change(control, to, timeStamp);
          });
        });
      }
    }
  }
}

/** @param {number} value @param {Control} control @returns {number} the nearest value that its slider has */
function onStep(value, { low, high, step }) {
  const near = low + Math.round((value - low) / step) * step;
  return Number(Math.min(high, Math.max(low, near)).toPrecision(12));
}
