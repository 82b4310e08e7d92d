/** The menu of what a scene can show: graphs that are made when they are asked for, and views. */

import { sizeName } from "../../../../view/effects-words.js";
import { BOTTOM, HEIGHT, LEFT, RIGHT, TOP, WIDTH } from "../../../../view/graph.js";
import { tr } from "../../../../view/language.js";
import { speedUnit } from "../../../../view/numbers.js";
import { lower, QUANTITIES } from "../../../../view/words.js";
import { html, need, svg } from "../../shared/dom.js";

/** @typedef {{key: string, label: string, seen: boolean}} Choice */

const AREAS = tr("boxes as large as the masses");
const STILLS = tr("in stills, without motion");
const STOPS = tr("stops at touch, greatest force and parting");
/** @type {Record<string, [string, string]>} a button of its own, and the class that it has besides */
const TOGGLES = {
  F: [tr("with sign"), ""],
  energy: [tr("as a ledger"), " carts-stack"],
};
const FORCES = ["F", "a"]; // not offered where the forces are hidden

export class Choose {
  /**
   * @param {HTMLElement} root @param {import("../../../../view/types.js").Baked} baked
   * @param {Choice[]} views
   * @param {boolean} stills whether playing shows stills in place of motion
   * @param {{graph: (quantity: string, seen: boolean) => void, view: (key: string, seen: boolean) => void, playing: (key: string, on: boolean) => void, areas: (on: boolean) => void}} acts
   */
  constructor(root, baked, views, stills, acts) {
    const place = need(root, ".carts-choices");
    const { show, forces, slow } = baked.fence;
    const graphs = Object.keys(QUANTITIES)
      .filter((quantity) => forces === "shown" || !FORCES.includes(quantity))
      .map((quantity) => ({
        key: quantity,
        label: `${lower(QUANTITIES[quantity]?.[0] ?? "")} ${QUANTITIES[quantity]?.[1]}`,
        seen: show.includes(quantity),
      }));
    const lasting = baked.run.header.contacts.some(({ stiffness }) => stiffness);
    const areas = { key: "areas", label: AREAS, seen: !baked.view.alike };
    const still = { key: "stills", label: STILLS, seen: stills };
    const stops = { key: "stops", label: STOPS, seen: slow === "stops" };
    place.replaceChildren(
      group(tr("Graphs"), graphs, acts.graph),
      group(tr("Views"), views, acts.view),
      group(tr("Picture"), [areas], (_, on) => acts.areas(on)),
      group(tr("Playing"), lasting && slow !== "never" ? [stops, still] : [still], acts.playing),
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
 * An empty graph of the same parts as those that `templates/graphs.html.j2` writes.
 * @param {import("../../../../view/types.js").Baked} baked @param {string} quantity @returns {HTMLElement}
 */
export function emptyGraph(baked, quantity) {
  const [title, symbol, unit] = QUANTITIES[quantity] ?? ["", "", ""];
  const isForce = quantity === "F";
  const name = isForce ? sizeName(baked.run.header) : title;
  const graph = html("div", "carts-graph");
  graph.dataset.quantity = quantity;
  graph.setAttribute("role", "group");
  graph.setAttribute("aria-label", tr("{quantity} against time", { quantity: name }));
  const head = html("p", "carts-graph-title");
  const named = html("span", "carts-graph-name");
  const camera =
    baked.fence.camera && ["x", "v"].includes(quantity) ? tr("seen from the camera, ") : "";
  named.append(
    `${name} ${camera}`,
    html("i", "", isForce ? "|F|" : symbol),
    tr(" in {unit}", { unit: quantity === "v" ? speedUnit(baked.view.velocity)[1] : unit }),
  );
  head.append(named);
  const [text, style] = TOGGLES[quantity] ?? [];
  if (text) {
    const button = html("button", `carts-sign${style}`, text);
    button.setAttribute("type", "button");
    button.setAttribute("aria-pressed", "false");
    head.append(" ", button);
  }
  const table = document.createElement("table");
  table.className = "carts-table";
  table.append(document.createElement("thead"), document.createElement("tbody"));
  const scroll = html("div", "carts-scroll");
  scroll.append(table);
  const details = html("details", "carts-more");
  details.append(html("summary", "", tr("Table: {quantity}", { quantity: lower(name) })), scroll);
  graph.append(head, plot(`${baked.fence.id}-${quantity}-clip`, isForce), html("p", "carts-key"));
  if (isForce) graph.append(html("p", "carts-area-note carts-quiet"));
  graph.append(details);
  return graph;
}

/** @param {string} clip id @param {boolean} isForce */
function plot(clip, isForce) {
  const frame = svg("svg", {
    class: "carts-plot",
    viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    "aria-hidden": "true",
  });
  const inside = svg("clipPath", { id: clip });
  const width = RIGHT - LEFT + 1;
  inside.append(svg("rect", { x: LEFT, y: TOP - 4, width, height: BOTTOM - TOP + 8 }));
  const defs = svg("defs");
  defs.append(inside);
  const unit = svg("text", { class: "carts-unit", x: RIGHT, y: HEIGHT - 3, "text-anchor": "end" });
  unit.textContent = tr("time t in s");
  const cut = { "clip-path": `url(#${clip})` };
  const areas = svg("g", { "data-part": "areas", ...cut });
  if (isForce)
    areas.append(svg("path", { class: "carts-impulse" }), svg("path", { class: "carts-impulse" }));
  const cursor = svg("g", { "data-part": "cursor", ...cut });
  cursor.append(svg("path", { class: "carts-cursor", d: `M0 ${TOP}V${BOTTOM}` }));
  frame.append(
    defs,
    svg("g", { "data-part": "times" }),
    svg("g", { "data-part": "values" }),
    unit,
    areas,
    svg("g", { "data-part": "curves", ...cut }),
    cursor,
  );
  return frame;
}
