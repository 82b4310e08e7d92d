/** The menu of what a scene can show: graphs that are made when they are asked for, and views. */

import { tr } from "../../../../view/language.js";
import { graph } from "../../../../view/skeleton/graph.js";
import { lower, QUANTITIES } from "../../../../view/words.js";
import { html, need, parsed } from "../../shared/dom.js";

/** @typedef {{key: string, label: string, seen: boolean}} Choice */

const AREAS = tr("boxes as large as the masses");
const STILLS = tr("in stills, without motion");
const STOPS = tr("stops at touch, greatest force and parting");
const SOUND = tr("a click at each contact, as loud as its force");
const FORCES = ["F", "R", "a"]; // not offered where the forces are not shown

export class Choose {
  /**
   * @param {HTMLElement} root @param {import("../../../../view/types.js").Baked} baked
   * @param {Choice[]} views
   * @param {{stills: boolean, sound: boolean}} now whether playing shows stills in place of motion, and is heard
   * @param {{graph: (quantity: string, seen: boolean) => void, view: (key: string, seen: boolean) => void, playing: (key: string, on: boolean) => void, areas: (on: boolean) => void}} acts
   */
  constructor(root, baked, views, now, acts) {
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
    const still = { key: "stills", label: STILLS, seen: now.stills };
    const sound = { key: "sound", label: SOUND, seen: now.sound };
    const stops = { key: "stops", label: STOPS, seen: slow === "stops" };
    place.replaceChildren(
      group(tr("Graphs"), graphs, acts.graph),
      group(tr("Views"), views, acts.view),
      group(tr("Picture"), [areas], (_, on) => acts.areas(on)),
      group(
        tr("Playing"),
        [
          ...(lasting && slow !== "never" ? [stops] : []),
          still,
          ...(baked.run.header.contacts.length ? [sound] : []),
        ],
        acts.playing,
      ),
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

/** @param {import("../../../../view/types.js").Baked} baked @param {string} quantity @returns {HTMLElement} a graph to draw in */
export function emptyGraph(baked, quantity) {
  return parsed(graph(baked, quantity).text);
}
