/** Choosing one answer, several, or how sure one is. Options keep their ids wherever they stand. */

import { plainText } from "../plain-text.js";

/** @typedef {import("../element.js").Form} Form */

/** @param {HTMLElement} root @param {() => void} changed @returns {Form} */
export function choiceForm(root, changed) {
  const body = /** @type {HTMLElement} */ (root.querySelector(".carts-q-body"));
  const inputs = /** @type {HTMLInputElement[]} */ ([...body.querySelectorAll("input")]);
  const several = inputs.some((input) => input.type === "checkbox");
  for (const input of inputs) input.addEventListener("change", changed);
  const picked = () => inputs.filter((input) => input.checked);
  return {
    get value() {
      const values = picked().map((input) => input.value);
      return several ? values.sort() : (values[0] ?? null);
    },
    set value(value) {
      const values = several ? (Array.isArray(value) ? value : []) : [value];
      for (const input of inputs) input.checked = values.includes(input.value);
    },
    enable(on) {
      for (const input of inputs) input.disabled = !on;
    },
    said: () =>
      picked()
        .map((input) => words(input.closest("label")))
        .join("; "),
  };
}

/** @param {Element | null} label */
function words(label) {
  const letter = label?.querySelector(".carts-q-letter")?.textContent;
  const text = plainText(label?.querySelector(".carts-q-text"));
  return letter ? `${letter}: ${text}` : text;
}
