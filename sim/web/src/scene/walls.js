/** Walls of the picture, which give way to a cart that has no bumper to do so. */

import { wallAt, wallPaths } from "../../../view/deformation/walls.js";
import { px } from "../../../view/numbers.js";
import { need, put } from "../shared/dom.js";

/** @typedef {import("../../../view/types.js").Layout} Layout */
/** @typedef {"left" | "right"} Side */

export class Walls {
  /** @type {{side: Side, wall: import("../../../view/deformation/walls.js").Wall, group: Element}[]} */
  #walls = [];

  /** @param {SVGElement} root @param {Layout} layout @param {import("../../../view/types.js").Baked} baked */
  constructor(root, layout, { run: { header }, view }) {
    this.layout = layout;
    this.was = need(root, ".carts-was");
    this.#walls = Array.from(root.querySelectorAll("[data-wall]"), (group) => {
      const side = group.getAttribute("data-wall") === "left" ? "left" : "right";
      return { side, wall: wallAt(side, header.track.length, layout, view.tallest), group };
    });
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
    const lines = this.#walls.map(({ side, wall, group }) => {
      const { dent, height } = pressed[side];
      const { body, face, was } = wallPaths(wall, this.layout, dent, height);
      put(need(group, ".carts-wall"), "d", body);
      put(need(group, "[fill]"), "d", body);
      put(need(group, ".carts-wall-face"), "d", face);
      return was;
    });
    put(this.was, "d", lines.join(""));
    put(this.was, "transform", `translate(${px(-shift)} 0)`);
  }
}
