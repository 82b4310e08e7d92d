/** The exact run behind a stepped one: dashed outlines of the carts, pale curves in the graphs. */

import { path } from "../../../../view/graph.js";
import { px } from "../../../../view/numbers.js";
import { box } from "../../../../view/shapes.js";
import { valueAt } from "../../../../view/trajectory.js";
import { svg } from "../../shared/dom.js";

/** @typedef {import("../../../../view/types.js").Run} Run */
/** @typedef {import("../../../../view/series.js").Series} Series */

/** Outlines in one picture of the world. */
export class Ghost {
  /** @type {Run | null} */
  #run = null;
  /** @type {SVGElement | null} */
  #group = null;

  /** @param {import("../stage.js").Stage} stage */
  constructor(stage) {
    this.stage = stage;
  }

  /** @param {Run | null} run the exact one; null: none */
  show(run) {
    this.#run = run;
    this.#group?.remove();
    this.#group = null;
    if (!run) return;
    const { layout, view, root } = this.stage;
    const group = svg("g", { class: "carts-ghosts", "aria-hidden": "true" });
    for (const body of run.header.bodies) {
      const half = (body.length * layout.scale) / 2;
      const { height } = box(body, view, layout, 0);
      const shape = {
        x: px(-half),
        y: px(-height),
        width: px(2 * half),
        height: px(height),
        rx: 3,
      };
      group.append(svg("rect", { class: "carts-ghost", ...shape }));
    }
    const first = root.querySelector(".carts-cart");
    first?.parentNode?.insertBefore(group, first);
    this.#group = group;
  }

  /** @param {number} t in s */
  at(t) {
    if (!this.#run || !this.#group) return;
    const { header, trajectory } = this.#run;
    const { layout, camera } = this.stage;
    header.bodies.forEach(({ name }, i) => {
      const [x, v] = [trajectory.x[name] ?? [], trajectory.v[name] ?? []];
      const place = layout.origin + (valueAt(trajectory.t, x, v, t) - camera * t) * layout.scale;
      const at = `translate(${px(place)} ${px(layout.track)})`;
      this.#group?.children[i]?.setAttribute("transform", at);
    });
  }
}

/**
 * Pale curves behind those of a graph; none where `curves` is empty.
 * @param {Element} plot @param {Series[]} curves @param {ArrayLike<number>} times @param {import("../../../../view/graph.js").Plane} plane
 */
export function ghostCurves(plot, curves, times, plane) {
  const found = plot.querySelector('[data-part="ghost"]');
  if (!curves.length) return found?.remove();
  const front = plot.querySelector('[data-part="curves"]');
  const clip = front?.getAttribute("clip-path") ?? "none";
  const group = found ?? svg("g", { "data-part": "ghost", "clip-path": clip });
  if (!found) front?.before(group);
  group.replaceChildren(
    ...curves
      .filter(({ over }) => !over) // of a force and its partner, one
      .map((curve) => svg("path", { class: "carts-pale", d: path(curve, times, plane) })),
  );
}
