/** Answers that are typed: a number with a unit, a few words, several sentences. */

import { readNumber, withoutUnit, withUnit } from "../marking/typed-number.js";

/** @typedef {import("../element.js").Form} Form */

/** @param {HTMLElement} root @param {() => void} changed @returns {Form} */
export function wordsForm(root, changed) {
  const box = typedBox(root, changed);
  return {
    get value() {
      return box.value;
    },
    set value(value) {
      box.value = typeof value === "string" ? value : "";
    },
    enable: (on) => {
      box.readOnly = !on;
    },
    said: () => box.value,
  };
}

/** @param {HTMLElement} root @param {() => void} changed @param {Record<string, any>} facts @returns {Form} */
export function numberForm(root, changed, facts) {
  const box = typedBox(root, changed);
  const read = () => readNumber(box.value, facts.units);
  return {
    get value() {
      if (!box.value.trim()) return null;
      const found = read();
      return "value" in found ? found.value : box.value;
    },
    set value(value) {
      box.value = value === null || value === undefined ? "" : String(value);
    },
    enable: (on) => {
      box.readOnly = !on;
    },
    said: () => withUnit(box.value, facts.unit),
    recall: (said) => {
      box.value = withoutUnit(said, facts.unit);
    },
    problem: () => {
      const found = read();
      return "problem" in found ? found.problem : "";
    },
  };
}

/** @param {HTMLElement} root @param {() => void} changed */
function typedBox(root, changed) {
  const box = /** @type {HTMLInputElement | HTMLTextAreaElement} */ (
    root.querySelector(".carts-q-typed")
  );
  box.addEventListener("input", changed);
  return box;
}
