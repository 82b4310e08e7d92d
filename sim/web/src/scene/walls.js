/** Walls of the picture, or what stands there instead: they give way to a cart that has no bumper to do so. */

import { whatIs } from "../../../view/bodies.js";
import { thingPaths } from "../../../view/deformation/things.js";
import { wallAt, wallPaths } from "../../../view/deformation/walls.js";
import { px } from "../../../view/numbers.js";
import { need, put, svg } from "../shared/dom.js";

/** @typedef {import("../../../view/types.js").Layout} Layout */
/** @typedef {"left" | "right"} Side */
/** @typedef {{side: Side, what: string, wall: import("../../../view/deformation/walls.js").Wall, group: Element}} Standing */

const THING = '[data-part="thing"]'; // thin lines that no wall has

export class Walls {
  /** @type {Standing[]} */
  #walls = [];

  /** @param {SVGElement} root @param {Layout} layout @param {import("../../../view/types.js").Baked} baked */
  constructor(root, layout, { run: { header }, view }) {
    this.layout = layout;
    this.tallest = view.tallest;
    this.was = need(root, ".carts-was");
    this.#walls = Array.from(root.querySelectorAll("[data-wall]"), (group) => {
      const side = group.getAttribute("data-wall") === "left" ? "left" : "right";
      const wall = wallAt(side, header.track.length, layout, view.tallest);
      return { side, what: "wall", wall, group };
    });
  }

  /** What stands there in this run. @param {import("../../../view/types.js").Track} track */
  show(track) {
    for (const one of this.#walls) {
      one.what = whatIs(one.side, track);
      one.wall = wallAt(one.side, track.length, this.layout, this.tallest);
      const drawn = one.group.querySelector(THING);
      if (one.what === "wall") drawn?.remove();
      else if (!drawn) one.group.append(svg("path", { "data-part": "thing" }));
    }
  }

  /** @param {number} shift of the picture to the left, in units @returns {import("../../../view/deformation/squeezes.js").Faces} */
  faces(shift) {
    const at = (/** @type {Side} */ side) => {
      const found = this.#walls.find((one) => one.side === side);
      return found ? found.wall.edge - shift : null;
    };
    return { left: at("left"), right: at("right") };
  }

  /**
   * @param {Record<Side, {dent: number, height: number}>} pressed how far each gives way, and to a cart of which height, in units
   * @param {number} shift of the picture to the left, in units
   */
  at(pressed, shift) {
    const lines = this.#walls.map((one) => this.#draw(one, pressed[one.side]));
    put(this.was, "d", lines.join(""));
    put(this.was, "transform", `translate(${px(-shift)} 0)`);
  }

  /** @param {Standing} standing @param {{dent: number, height: number}} pressed @returns {string} where its face was */
  #draw({ what, wall, group }, { dent, height }) {
    const { body, hatch, face, was, lines } =
      what === "wall"
        ? { ...wallPaths(wall, this.layout, dent, height), hatch: null, lines: "" }
        : thingPaths(what, wall, this.layout, dent, height);
    put(need(group, ".carts-wall"), "d", body);
    put(need(group, "[fill]"), "d", hatch ?? body);
    put(need(group, ".carts-wall-face"), "d", face);
    if (lines) {
      const thing = need(group, THING);
      put(thing, "class", what === "spring" ? "carts-coil" : "carts-fine");
      put(thing, "d", lines);
    }
    return was;
  }
}
