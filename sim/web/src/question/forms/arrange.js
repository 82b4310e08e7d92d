/** Putting lines in order with two buttons each, and joining pairs with a list each: no dragging. */

import { tr } from "../../../../view/language.js";
import { need, say } from "../../shared/dom.js";
import { plainText } from "../plain-text.js";
import { mark } from "./part-mark.js";

/** @typedef {import("../element.js").Form} Form */

/** @param {HTMLElement} root @param {() => void} changed @returns {Form} */
export function orderForm(root, changed) {
  const list = /** @type {HTMLElement} */ (root.querySelector(".carts-q-lines"));
  let touched = false;
  const items = () => /** @type {HTMLElement[]} */ ([...list.children]);
  const buttons = () => /** @type {HTMLButtonElement[]} */ ([...list.querySelectorAll("button")]);
  list.addEventListener("click", ({ target }) => {
    const button = /** @type {Element} */ (target).closest("button");
    const item = button?.closest("li");
    if (!button || !item) return;
    const up = button.classList.contains("carts-q-up");
    const other = up ? item.previousElementSibling : item.nextElementSibling;
    if (other) list.insertBefore(up ? item : other, up ? other : item);
    touched = true;
    button.focus();
    changed();
    const [k, all] = [items().indexOf(item) + 1, items().length];
    const told = tr("Now {k} of {all}: {text}", { k, all, text: textOf(item) });
    say(need(root, ".carts-q-picked"), told);
  });
  return {
    get value() {
      return touched ? items().map((item) => item.dataset.line) : null;
    },
    set value(value) {
      touched = Array.isArray(value) && value.length > 0;
      const order =
        Array.isArray(value) && touched
          ? value
          : [...items().map((item) => item.dataset.line)].sort();
      for (const line of order) {
        const item = items().find((one) => one.dataset.line === line);
        if (item) list.append(item);
      }
    },
    enable(on) {
      for (const button of buttons()) button.disabled = !on;
    },
    said: () => (touched ? items().map(textOf).join(" → ") : ""),
  };
}

/** @param {HTMLElement} root @param {() => void} changed @returns {Form} */
export function matchForm(root, changed) {
  const rows = /** @type {HTMLElement[]} */ ([...root.querySelectorAll("[data-left]")]);
  const select = (/** @type {HTMLElement} */ row) =>
    /** @type {HTMLSelectElement} */ (row.querySelector("select"));
  for (const row of rows) {
    select(row).addEventListener("change", () => {
      for (const other of rows) mark(other, "");
      changed();
    });
  }
  const chosen = () => rows.filter((row) => select(row).value);
  return {
    get value() {
      return Object.fromEntries(chosen().map((row) => [row.dataset.left, select(row).value]));
    },
    set value(value) {
      for (const row of rows) {
        const left = String(row.dataset.left);
        select(row).value = value && Object.hasOwn(value, left) ? String(value[left]) : "";
        mark(row, ""); // what stood beside it was of another pair
      }
    },
    enable(on) {
      for (const row of rows) select(row).disabled = !on;
    },
    said: () =>
      chosen()
        .map((row) => {
          const right = root.querySelector(`[data-right="${CSS.escape(select(row).value)}"]`);
          return `${textOf(row)} – ${textOf(right)}`;
        })
        .join("; "),
    marked: (shown) => {
      for (const row of chosen())
        mark(row, shown.includes(`pair-${row.dataset.left}`) ? "right" : "wrong");
    },
  };
}

/** What a line says. @param {Element | null} line */
function textOf(line) {
  return plainText(line?.querySelector(".carts-q-text"));
}
