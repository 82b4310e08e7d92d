/** Questions on a scene of the page: a reading off the student's own run, and a drawn prediction. */

import { tr } from "../../../../view/language.js";
import { isEmpty } from "../../answers/entry.js";
import { RESET } from "../../shared/waiting.js";
import { reading } from "../marking/own-run.js";
import { readNumber } from "../marking/typed-number.js";

const KILOGRAMS = { kg: 1, g: 0.001, mg: 1e-6, t: 1000 };

/** What the student's own run says, in the question's unit; null: there is no run yet. */
/** @param {Record<string, any>} facts @returns {{own: number | null, set: Record<string, unknown>}} */
function ownReading(facts) {
  const scene = /** @type {any} */ (document.getElementById(facts.scene));
  const run = scene?.trajectory;
  const set = setBy(scene);
  if (!run) return { own: null, set };
  const value = reading(run, masses(scene), facts.quantity, facts.at);
  return { own: value === null ? null : value / facts.per, set };
}

/** The entry with the run that its number is read off, and without an earlier one. @param {Record<string, any>} facts @param {any} entry */
export function readOff(facts, entry) {
  const { own, set } = ownReading(facts);
  delete entry.own;
  delete entry.set;
  return own === null ? entry : Object.assign(entry, { own, set });
}

/** @type {WeakMap<Element, Record<string, unknown>>} what the student set in each scene */
const changes = new WeakMap();
document.addEventListener("carts-update", (event) => {
  const { target, detail } = /** @type {CustomEvent} */ (event);
  if (target instanceof Element) changes.set(target, detail);
});

document.addEventListener(RESET, ({ target }) => {
  if (target instanceof Element) changes.delete(target);
});

/** What the student set in a scene. @param {Element | null} scene @returns {Record<string, unknown>} */
export function setBy(scene) {
  return changes.get(/** @type {Element} */ (scene)) ?? {};
}

/** @param {Element | null} scene @returns {Record<string, number>} kg, by cart, as set by the student */
export function masses(scene) {
  /** @type {Record<string, number>} */
  const found = {};
  const baked = scene?.querySelector("script.carts-baked")?.textContent;
  for (const body of JSON.parse(baked ?? "{}").bodies ?? []) found[body.name] = body.mass;
  for (const [path, value] of Object.entries(setBy(scene))) {
    if (!path.endsWith(".mass")) continue;
    const mass = readNumber(String(value), KILOGRAMS);
    if ("value" in mass) found[path.slice(0, -".mass".length)] = mass.value;
  }
  return found;
}

/** @param {HTMLElement} root @param {() => void} _changed @param {Record<string, any>} facts @returns {import("../element.js").Form} */
export function drawnForm(root, _changed, facts) {
  const done = /** @type {HTMLElement} */ (root.querySelector(".carts-q-done"));
  return {
    value: null,
    enable: () => {},
    said: () => "",
    follow: (book) => {
      const entry = book.get("worksheet", facts.scene);
      const locked = entry && !isEmpty(entry.value) && entry.locked;
      done.textContent = locked ? tr("✓ done") : "";
    },
  };
}
