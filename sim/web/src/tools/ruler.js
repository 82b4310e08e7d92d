/**
 * A ruler that is laid against the picture: its two ends are pulled there or moved by their sliders, and
 * it reads the length between them. What it says comes from where its ends lie, not from the run.
 */

import { fixed, px } from "../../../view/numbers.js";
import { need, put, say } from "../shared/dom.js";
import { followPointer } from "../shared/follow.js";

/** @param {HTMLElement} scene its inside may be drawn anew: the scene itself is listened to */
export function workRuler(scene) {
  scene.addEventListener("input", ({ target }) => {
    if (/** @type {Element} */ (target).closest('[data-tool="ruler"]')) lay(scene);
  });
  scene.addEventListener("pointerdown", (event) => {
    const end = /** @type {Element} */ (event.target).closest(".carts-tape-end");
    if (end) pull(scene, end, event);
  });
}

/** Draws the ruler between the two places that its sliders have. @param {HTMLElement} scene */
function lay(scene) {
  const tool = need(scene, '[data-tool="ruler"]');
  const decimals = Number(tool.dataset.decimals);
  const slider = (/** @type {string} */ key) =>
    /** @type {HTMLInputElement} */ (need(tool, `[data-end="${key}"]`));
  const [from, to] = [slider("from"), slider("to")];
  for (const one of [from, to]) {
    put(one, "aria-valuetext", `${fixed(one.valueAsNumber, decimals)} m`);
  }
  const length = fixed(Math.abs(to.valueAsNumber - from.valueAsNumber), decimals);
  say(need(tool, "output"), length);
  for (const tape of scene.querySelectorAll(".carts-tape")) {
    const { origin, scale, y } = /** @type {SVGElement} */ (tape).dataset;
    const at = (/** @type {HTMLInputElement} */ one) =>
      Number(origin) + one.valueAsNumber * Number(scale);
    for (const one of [from, to]) {
      const end = need(tape, `[data-end="${one.dataset.end}"]`);
      put(end, "transform", `translate(${px(at(one))} 0)`);
    }
    put(need(tape, '[data-part="tape"]'), "d", `M${px(at(from))} ${y}H${px(at(to))}`);
    const text = need(tape, '[data-part="length"]');
    put(text, "x", px((at(from) + at(to)) / 2));
    say(text, `${length} m`);
  }
}

/** Moves the slider of an end with the finger. @param {HTMLElement} scene @param {Element} end @param {PointerEvent} down */
function pull(scene, end, down) {
  const tape = /** @type {SVGElement} */ (end.closest(".carts-tape"));
  const stage = /** @type {SVGSVGElement} */ (tape.ownerSVGElement);
  const key = end.getAttribute("data-end");
  const slider = need(scene, `[data-tool="ruler"] [data-end="${key}"]`);
  const { valueAsNumber: start } = /** @type {HTMLInputElement} */ (slider);
  const units = stage.viewBox.baseVal.width / stage.getBoundingClientRect().width;
  const metres = units / Number(tape.dataset.scale);
  down.preventDefault();
  followPointer(down, (pixels) => {
    /** @type {HTMLInputElement} */ (slider).valueAsNumber = start + pixels * metres;
    lay(scene);
  });
}
