/** The track and its ruler, where a slider sets how long it is: they end at the wall of the run that is shown. */

import { px } from "../../../view/numbers.js";
import { need, put } from "../shared/dom.js";

const TRACK = "track.length";

export class Ground {
  /** Pieces of the ruler, each at its place, and the element that draws them. @type {{drawn: Element, pieces: {x: number, d: string}[]}[]} */
  #lines = [];
  /** @type {Element[]} */
  #numbers = [];

  /** @param {SVGElement} root @param {import("../../../view/types.js").Layout} layout @param {import("../../../view/types.js").Baked} baked */
  constructor(root, layout, { fence, run: { header } }) {
    this.layout = layout;
    this.moves =
      header.track.right === "wall" && fence.controls.some((control) => control.set === TRACK);
    if (!this.moves) return;
    const ground = need(root, '[data-part="ground"]');
    this.beam = need(ground, ".carts-beam");
    this.rule = need(ground, ".carts-rule");
    this.#numbers = [...ground.querySelectorAll(".carts-number")];
    this.#lines = Array.from(ground.querySelectorAll(".carts-fine"), (drawn) => ({
      drawn,
      pieces: (drawn.getAttribute("d") ?? "")
        .split(/(?=M)/)
        .filter(Boolean)
        .map((d) => ({ x: Number.parseFloat(d.slice(1)), d })),
    }));
  }

  /** @param {import("../../../view/types.js").Track} track */
  show({ length }) {
    if (!this.beam || !this.rule) return;
    const end = this.layout.origin + Number(length) * this.layout.scale;
    const inside = (/** @type {number} */ x) => x <= end + 1;
    const start = Number(this.beam.getAttribute("x"));
    put(this.beam, "width", px(end - start));
    put(this.rule, "d", `M${px(start)} ${px(this.layout.track)}H${px(end)}`);
    for (const { drawn, pieces } of this.#lines) {
      const d = pieces.filter(({ x }) => inside(x)).map((piece) => piece.d);
      put(drawn, "d", d.join(""));
    }
    for (const number of this.#numbers) {
      const seen = inside(Number(number.getAttribute("x")));
      put(number, "visibility", seen ? "visible" : "hidden");
    }
  }
}
