/** The map of where methods break: another method, another number across, and any point run above. */

import {
  command,
  found,
  pointAt,
  ring,
  sceneOf,
  squares,
  TICKS_Y,
  theory,
  ticks,
  unitText,
  valueText,
} from "../../../view/cost/breaks.js";
import { px } from "../../../view/numbers.js";
import { html, need, put, say, svg } from "../shared/dom.js";

/** @typedef {import("../../../view/cost/breaks.js").Breaks} Breaks */
/** @typedef {(point: {scene: object, method: string, parts: number, told: string}) => void} Run */

const PARTS = ["method", "map", "value", "step", "run"];

export class BreaksFigure {
  /** @param {HTMLElement} root @param {Breaks} breaks @param {Run} run */
  constructor(root, breaks, run) {
    this.root = root;
    this.breaks = breaks;
    for (const part of PARTS) this.#part(part).disabled = false;
    this.#part("method").addEventListener("change", () => this.#draw());
    this.#part("map").addEventListener("change", () => this.#draw(true));
    this.#part("value").addEventListener("change", () => this.#tell());
    this.#part("step").addEventListener("change", () => this.#tell());
    this.#part("run").addEventListener("click", () => {
      const { point, scene, method, parts } = this.#chosen;
      run({ scene, method, parts, told: found(this.breaks, this.#map, method, point) });
    });
    const picture = need(root, ".carts-breaks-picture");
    picture.addEventListener("click", (event) => {
      const { left, top, width, height } = picture.getBoundingClientRect();
      const { clientX, clientY } = /** @type {MouseEvent} */ (event);
      const [wide, high] = (picture.getAttribute("viewBox") ?? "").split(" ").slice(2).map(Number);
      const x = ((clientX - left) / width) * Number(wide);
      const { column, row } = pointAt(breaks, x, ((clientY - top) / height) * Number(high));
      this.#part("value").value = String(column);
      this.#part("step").value = String(row);
      this.#tell();
    });
  }

  /** @param {string} part @returns {HTMLSelectElement} */
  #part(part) {
    return /** @type {HTMLSelectElement} */ (need(this.root, `.carts-breaks-${part}`));
  }

  get #map() {
    return /** @type {Breaks["maps"][0]} */ (this.breaks.maps[Number(this.#part("map").value)]);
  }

  get #chosen() {
    const point = {
      column: Number(this.#part("value").value),
      row: Number(this.#part("step").value),
    };
    const method = this.#part("method").value;
    const parts = Number(this.breaks.parts[point.row]);
    return { point, method, parts, scene: sceneOf(this.breaks, this.#map, point.column) };
  }

  /** @param {boolean} [values] whether other values stand across now */
  #draw(values) {
    const [map, method] = [this.#map, this.#part("method").value];
    const kinds = squares(this.breaks, map, method).map(([kind, d]) =>
      svg("path", { class: `carts-breaks-${kind}`, d }),
    );
    need(this.root, ".carts-breaks-squares").replaceChildren(...kinds);
    const [contact, limit] = theory(this.breaks, map, method);
    put(need(this.root, ".carts-breaks-picture > .carts-breaks-contact"), "d", contact);
    put(need(this.root, ".carts-breaks-picture > .carts-breaks-limit"), "d", limit);
    if (values) {
      const texts = ticks(map).map(([x, text]) => {
        const made = svg("text", { class: "carts-tick-x", x: px(x), y: TICKS_Y });
        made.textContent = text;
        return made;
      });
      need(this.root, ".carts-breaks-ticks").replaceChildren(...texts);
      say(need(this.root, ".carts-breaks-unit"), unitText(map));
      const options = map.values.map((value, k) => {
        const option = html("option", "", valueText(map, value));
        option.setAttribute("value", String(k));
        return option;
      });
      this.#part("value").replaceChildren(...options);
    }
    this.#tell();
  }

  #tell() {
    const { point, method, parts, scene } = this.#chosen;
    const mark = need(this.root, ".carts-breaks-ring");
    for (const [name, value] of Object.entries(ring(this.breaks, point))) put(mark, name, value);
    put(mark, "visibility", "visible");
    say(need(this.root, ".carts-breaks-found"), found(this.breaks, this.#map, method, point));
    const line = need(this.root, ".carts-breaks-command");
    line.hidden = false;
    say(line, command(scene, method, parts));
  }
}
