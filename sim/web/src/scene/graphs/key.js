/** Below a graph: which line is whose, and what the graph cannot show. */

import { MARKERS } from "../../../../view/markers.js";
import { html, svg } from "../../shared/dom.js";

/** @typedef {import("../../../../view/series.js").Series} Series */

export class Key {
  #told = "";

  /** @param {HTMLElement} root */
  constructor(root) {
    this.root = root;
  }

  /** @param {Series[]} curves @param {string} note */
  show(curves, note) {
    const wanted = [...curves.map((c) => `${c.style}${c.over}${c.label}`), note].join("|");
    if (this.#told === wanted && this.root.firstChild) return;
    this.#told = wanted;
    this.root.replaceChildren(...curves.map(entry), ...(note ? [html("span", "", note)] : []));
  }

  /** Something else was written in its place. */
  forget() {
    this.#told = "";
  }
}

/** @param {Series} curve @returns {HTMLElement} */
function entry({ style, over, label }) {
  const made = html("span", `carts-${style}`);
  const size = { viewBox: "0 0 26 10", width: 26, height: 10, "aria-hidden": "true" };
  const sample = svg("svg", size);
  const line = { class: `carts-curve carts-${style}${over ? " carts-over" : ""}`, d: "M0 5H26" };
  const marker = { class: `carts-dot carts-${style}`, d: MARKERS[style] ?? "" };
  sample.append(svg("path", line), svg("path", { ...marker, transform: "translate(13 5)" }));
  made.append(sample, label);
  return made;
}
