/**
 * Arrows of a prediction are drawn by pulling: the handle at the tip is a second handle of the slider
 * in the form, which stays the way for keyboards.
 */

import { svg } from "../shared/dom.js";
import { followPointer } from "../shared/follow.js";

/**
 * A group that moves a slider when it is pulled along the track.
 * @param {Element} stage the picture @param {HTMLInputElement} slider
 * @param {number} full units of the picture, with a sign, for the slider's greatest value
 * @param {number} width of the picture in units
 */
export function pullable(stage, slider, full, width) {
  const group = svg("g", {});
  group.addEventListener("pointerdown", (event) => {
    const down = /** @type {PointerEvent} */ (event);
    if (slider.disabled) return;
    event.preventDefault();
    const start = slider.valueAsNumber || 0;
    const perPixel = ((width / stage.getBoundingClientRect().width) * Number(slider.max)) / full;
    followPointer(down, (pixels) => {
      if (slider.disabled) return; // locked while it is being pulled
      const before = slider.value;
      slider.valueAsNumber = start + pixels * perPixel;
      if (slider.value !== before || slider.dataset.pulled === undefined) {
        slider.dataset.pulled = "";
        slider.dispatchEvent(new Event("input", { bubbles: true }));
      }
    });
  });
  return group;
}
