/** The menu of what a scene can show: graphs that are made when they are asked for, and views. */

import { html, need, say } from "./dom.js";
import { speedUnit } from "./numbers.js";
import { QUANTITIES } from "./words.js";

/** @typedef {{key: string, label: string, seen: boolean}} Choice */

const STOPS = "stops at touch, greatest force and parting";
const FORCES = ["F", "a"]; // not offered where the forces are hidden

export class Choose {
  /**
   * @param {HTMLElement} root @param {import("./types.js").Baked} baked
   * @param {Choice[]} views
   * @param {{graph: (quantity: string, seen: boolean) => void, view: (key: string, seen: boolean) => void, halting: (on: boolean) => void}} acts
   */
  constructor(root, baked, views, acts) {
    const place = need(root, ".carts-choices");
    const { show, forces, slow } = baked.fence;
    const graphs = Object.keys(QUANTITIES)
      .filter((quantity) => forces === "shown" || !FORCES.includes(quantity))
      .map((quantity) => ({
        key: quantity,
        label: `${QUANTITIES[quantity]?.[0].toLowerCase()} ${QUANTITIES[quantity]?.[1]}`,
        seen: show.includes(quantity),
      }));
    const lasting = baked.run.header.contacts.some(({ stiffness }) => stiffness);
    const stops = { key: "stops", label: STOPS, seen: slow === "stops" };
    place.replaceChildren(
      group("Graphs", graphs, acts.graph),
      group("Views", views, acts.view),
      group("Playing", lasting && slow !== "never" ? [stops] : [], (_, on) => acts.halting(on)),
    );
  }
}

/** @param {string} title @param {Choice[]} choices @param {(key: string, seen: boolean) => void} act */
function group(title, choices, act) {
  const set = document.createElement("fieldset");
  set.append(html("legend", "", title));
  for (const { key, label, seen } of choices) {
    const line = html("label");
    const box = document.createElement("input");
    box.type = "checkbox";
    box.checked = seen;
    box.dataset.choice = key;
    box.addEventListener("change", () => act(key, box.checked));
    line.append(box, ` ${label}`);
    set.append(line);
  }
  set.hidden = choices.length === 0;
  return set;
}

/**
 * An empty graph, made from the pattern that the generator wrote.
 * @param {HTMLElement} root @param {import("./types.js").Baked} baked @param {string} quantity @returns {HTMLElement}
 */
export function emptyGraph(root, baked, quantity) {
  const pattern = /** @type {HTMLTemplateElement} */ (
    /** @type {unknown} */ (need(root, "template.carts-graph-pattern"))
  );
  const graph = /** @type {HTMLElement} */ (pattern.content.firstElementChild?.cloneNode(true));
  const [title, symbol, unit] = QUANTITIES[quantity] ?? ["", "", ""];
  const isForce = quantity === "F";
  graph.dataset.quantity = quantity;
  const name = isForce ? "Size of the contact force" : title;
  graph.setAttribute("aria-label", `${name} against time`);
  const camera =
    baked.fence.camera && ["x", "v"].includes(quantity) ? "seen from the camera, " : "";
  need(graph, ".carts-graph-name").replaceChildren(
    `${name} ${camera}`,
    html("i", "", isForce ? "|F|" : symbol),
    ` in ${quantity === "v" ? speedUnit(baked.view.velocity)[1] : unit}`,
  );
  say(need(graph, "summary"), `Table: ${name.toLowerCase()}`);
  for (const clip of graph.querySelectorAll("[clip-path]")) {
    clip.setAttribute("clip-path", `url(#${baked.fence.id}-${quantity}-clip)`);
  }
  need(graph, "clipPath").id = `${baked.fence.id}-${quantity}-clip`;
  for (const button of graph.querySelectorAll("[data-for]")) {
    if (/** @type {HTMLElement} */ (button).dataset.for !== quantity) button.remove();
  }
  return graph;
}
