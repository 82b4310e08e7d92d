/** What both ways of predicting arrows share: the rows of their form, and a drawn arrow. */

import { body, forceOn } from "../../../view/bodies.js";
import { blockArrow, cutArrow } from "../../../view/shapes.js";
import { need, svg } from "../shared/dom.js";

export const ALIKE = 0.06; // of the longer arrow: nearer than this two were meant to be equal
export const LONG = 120; // units of the comparison that stand for the full scale

/**
 * Which force a row of the form asks for, its name, and its slider.
 * @param {HTMLElement} element @param {import("../../../view/types.js").Header} header
 */
export function asked(element, { contacts, track }) {
  const { pair = "", on = "" } = element.dataset;
  const bodies = contacts.find((contact) => contact.pair === pair)?.bodies ?? [on, on];
  const side = /** @type {"left" | "right"} */ (bodies[0] === on ? "left" : "right");
  const by = (side === "left" ? bodies[1] : bodies[0]) ?? "";
  return {
    pair,
    on,
    name: forceOn(body(on, track), body(by, track)),
    side,
    style: element.className.split(" ").find((name) => /^carts-(b\d|wall)$/.test(name)) ?? "",
    slider: /** @type {HTMLInputElement} */ (need(element, 'input[type="range"]')),
  };
}

/** Greatest contact force of a pair in N. @param {import("../../../view/types.js").Run} run @param {string} pair */
export function greatest(run, pair) {
  const [left, right] = run.header.contacts.find((contact) => contact.pair === pair)?.bodies ?? [];
  const peak = run.header.events.find(
    (event) => event.kind === "peak" && event.bodies[0] === left && event.bodies[1] === right,
  );
  if (typeof peak?.force === "number") return peak.force;
  return Math.max(0, ...Array.from(run.trajectory.F[pair] ?? []));
}

/** @param {number} length @param {string} className @param {"left" | "right"} side @param {boolean} cut */
export function pulled(length, className, side, cut = false) {
  const width = Math.max(length, 6) + 4;
  const picture = svg("svg", {
    viewBox: `0 0 ${width} 20`,
    width,
    height: 20,
    "aria-hidden": "true",
  });
  const draw = cut ? cutArrow : blockArrow;
  const d = side === "left" ? draw(width, 10, -length) : draw(0, 10, length);
  picture.append(svg("path", { class: className, d }));
  return picture;
}
