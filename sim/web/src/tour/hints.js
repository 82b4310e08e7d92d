/** What a first reader is shown on the first scene, and how one sees that it can be done and was done. */

import { tr } from "../../../view/language.js";

/** @typedef {HTMLElement & {time: number}} Scene */
/**
 * @typedef {{name: string, text: (scene: Scene) => string, place: (scene: Scene) => Element | null,
 *   can: (scene: Scene) => boolean}} Hint
 *   `place`: what the hint is about, null where there is none; `can`: whether it can be done now
 */

const PULLED = ".carts-draggable";

/** The first that can be done and was never done is shown. @type {Hint[]} */
export const HINTS = [
  {
    name: "drag",
    text: (scene) =>
      pulled(scene)?.classList.contains("carts-cart")
        ? tr("Pull a cart: where shall it start?")
        : tr("Pull the arrow: how fast shall the cart start?"),
    place: pulled,
    can: (scene) => scene.time === 0 && scene.querySelector(".carts-panel input:enabled") !== null,
  },
  {
    name: "play",
    text: () => tr("Press Play."),
    place: (scene) => scene.querySelector(".carts-play:enabled"),
    can: (scene) => scene.time === 0,
  },
  {
    name: "back",
    text: () => tr("Pull the time back: you see it again."),
    place: (scene) => scene.querySelector(".carts-scrub:enabled"),
    can: (scene) => scene.time > 0,
  },
];

/** What can be pulled in the picture that is seen: a cart, or else its arrow. @param {Element} scene */
function pulled(scene) {
  const seen = [...scene.querySelectorAll(PULLED)].filter((part) => part.getClientRects().length);
  return seen.find((part) => part.classList.contains("carts-cart")) ?? seen[0] ?? null;
}

/** Whether something that can be pulled was taken hold of. @param {Event} event */
export function isPulled(event) {
  return event.target instanceof Element && event.target.closest(PULLED) !== null;
}
