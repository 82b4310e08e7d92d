/**
 * One scene for the whole class: full screen, large type, a count of hands for each option, “Reveal”
 * without a prediction of its own, and “Next” for the next scene of the page. Key P, or the button.
 * The class watches too: the run plays, and its curves grow. Nothing of it is kept.
 */

import { tr } from "../../../view/language.js";
import { html, need, say } from "../shared/dom.js";
import { PROJECTED } from "./time/watch.js";

/** @typedef {HTMLElement & {reveal?: () => Promise<void>, conceal?: () => Promise<void>}} Scene */

const MOST_HANDS = 999;
/** @type {WeakSet<Scene>} scenes that listen to keys; their inside may be put there anew */
const listening = new WeakSet();

/** @param {Scene} scene */
export function offerProjector(scene) {
  const button = /** @type {HTMLButtonElement} */ (need(scene, ".carts-project"));
  button.disabled = false;
  const bar = html("p", "carts-project-bar");
  const [reveal, next] = [
    made("carts-button", tr("Reveal")),
    made("carts-button", tr("Next scene")),
  ];
  bar.append(reveal, " ", next);
  need(scene, ".carts-frame").append(bar);
  button.addEventListener("click", () => void project(scene, !isOn(scene)));
  reveal.addEventListener("click", () => void scene.reveal?.());
  next.addEventListener("click", () => {
    const all = /** @type {Scene[]} */ ([...document.querySelectorAll("carts-scene")]);
    const following = all[(all.indexOf(scene) + 1) % all.length];
    if (following) void project(following, true);
  });
  for (const option of scene.querySelectorAll(".carts-options label")) count(scene, option);
  if (listening.has(scene)) return;
  listening.add(scene);
  scene.addEventListener("keydown", (event) => {
    const typing = /** @type {Element} */ (event.target).matches(
      "input:not([type=range]), textarea, select",
    );
    if (typing || event.repeat || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key.toLowerCase() === "p") void project(scene, !isOn(scene));
  });
}

document.addEventListener("keydown", (event) => {
  if (event.key === "Escape") for (const scene of shown()) void project(scene, false);
});

let left = 0; // times that the full screen was left from here and the browser has not told of yet

document.addEventListener("fullscreenchange", () => {
  const own = left > 0; // its scene is off already; another one may be on by now
  left = document.fullscreenElement ? 0 : Math.max(0, left - 1);
  if (document.fullscreenElement || own) return;
  for (const scene of shown()) mark(scene, false);
});

const shown = () => /** @type {NodeListOf<Scene>} */ (document.querySelectorAll(`.${PROJECTED}`));

/** @param {Scene} scene */
const isOn = (scene) => scene.classList.contains(PROJECTED);

/** @param {Scene} scene @param {boolean} on */
async function project(scene, on) {
  for (const other of shown()) if (other !== scene) mark(other, false);
  mark(scene, on);
  if (!on) {
    if (!document.fullscreenElement) return;
    left += 1;
    await document.exitFullscreen().catch(() => (left = 0));
    return;
  }
  await document.documentElement.requestFullscreen?.().catch(() => {}); // it fills the window then
  need(scene, ".carts-project").focus();
}

/** @param {Scene} scene @param {boolean} on */
function mark(scene, on) {
  if (!on && isOn(scene)) void scene.conceal?.();
  scene.classList.toggle(PROJECTED, on);
  document.documentElement.classList.toggle("carts-projecting", shown().length > 0);
  const button = scene.querySelector(".carts-project");
  if (button) say(button, on ? tr("Leave projector (Esc)") : tr("projector"));
}

/** A box for the number of hands, and a bar as long as its part of all. @param {Scene} scene @param {Element} option */
function count(scene, option) {
  const line = html("span", "carts-hands");
  const box = document.createElement("input");
  box.type = "number";
  box.min = "0";
  box.max = String(MOST_HANDS);
  box.setAttribute(
    "aria-label",
    tr("hands for: {option}", { option: String(option.textContent?.trim()) }),
  );
  const bar = document.createElement("meter");
  bar.setAttribute("aria-hidden", "true");
  const part = html("span");
  line.append(box, bar, part);
  option.after(line);
  box.addEventListener("input", () => {
    const boxes = /** @type {NodeListOf<HTMLInputElement>} */ (
      scene.querySelectorAll(".carts-hands input")
    );
    const hands = (/** @type {HTMLInputElement} */ one) =>
      Math.min(MOST_HANDS, Math.max(0, Math.round(one.valueAsNumber || 0)));
    const all = [...boxes].reduce((sum, one) => sum + hands(one), 0);
    for (const one of boxes) {
      const share = all ? hands(one) / all : 0;
      const meter = /** @type {HTMLMeterElement} */ (one.nextElementSibling);
      meter.value = share;
      say(
        /** @type {Element} */ (meter.nextElementSibling),
        tr("{part} of {all}", { part: hands(one), all }),
      );
    }
  });
}

/** @param {string} className @param {string} text @returns {HTMLButtonElement} */
function made(className, text) {
  const button = document.createElement("button");
  button.type = "button";
  button.className = className;
  button.textContent = text;
  return button;
}
