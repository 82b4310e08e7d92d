/** The world view: moves the picture that `sim/view/skeleton/stage.js` wrote. Draws a run, knows no physics. */

import { squeezes } from "../../../view/deformation/squeezes.js";
import { tr } from "../../../view/language.js";
import { styleOf } from "../../../view/markers.js";
import { fixed, NOISE, px, speedUnit } from "../../../view/numbers.js";
import * as shapes from "../../../view/shapes.js";
import { SKINS } from "../../../view/skins.js";
import { valueAt } from "../../../view/trajectory.js";
import { pullable } from "../predict/pull.js";
import { need, put, say, svg } from "../shared/dom.js";
import { Effects } from "./effects.js";
import { Ground } from "./ground.js";
import { Pushes } from "./pushes.js";
import { Walls } from "./walls.js";

/** @typedef {import("../../../view/types.js").Baked} Baked */
/** @typedef {import("../../../view/types.js").Run} Run */
/** @typedef {{half: number, edge: number, bumper: number, height: number, lift: number, top: number, lane: number, group: Element, mass: Element, velocity: Element}} Cart */

const HANDLE = 9; // units from the tip of an arrow to its handle

export class Stage {
  /** @type {Run} */
  #run;
  /** @type {Cart[]} */
  #carts = [];
  /** @type {Walls} */
  #walls;
  /** @type {Ground} */
  #ground;
  /** @type {Pushes} */
  #pushes;
  /** @type {Effects} */
  #effects;

  /** @param {SVGElement} root @param {Baked} baked */
  constructor(root, baked) {
    const layout = baked.view.layouts.find((one) => one.kind === root.dataset.kind);
    if (!layout) throw new Error(`no layout for ${root.dataset.kind}`);
    this.root = root;
    this.torn = false; // whether a box is taller than the picture can show
    this.layout = layout;
    this.view = baked.view;
    this.camera = baked.fence.camera;
    this.skins = baked.fence.skins;
    this.starts = baked.run.header.bodies.map(({ velocity }) => velocity);
    this.#run = baked.run;
    this.#walls = new Walls(root, layout, baked);
    this.#ground = new Ground(root, layout, baked);
    this.#pushes = new Pushes(root, layout, baked.view);
    this.#effects = new Effects(root, layout, baked.view.force, baked.fence.forces === "shown");
  }

  /** Takes a run: boxes for its masses. @param {Run} run @param {import("../../../view/windows.js").Touch[]} windows */
  show(run, windows) {
    this.#run = run;
    const { layout, view } = this;
    const boxes = run.header.bodies.map((body, i) =>
      shapes.box(body, view, layout, i, this.skins[body.name]),
    );
    this.torn = boxes.some((box) => box.cut);
    const tallest = Math.max(...boxes.map((box) => box.height));
    this.#carts = run.header.bodies.map((body, i) => {
      const group = need(this.root, `.carts-cart[data-body="${body.name}"]`);
      const box = /** @type {shapes.Box} */ (boxes[i]);
      drawBox(group, body.name, box);
      const skin = SKINS[this.skins[body.name] ?? ""];
      const front = Number(this.starts[i]) < 0 ? -1 : 1;
      const lift = skin?.lift ?? 0;
      if (skin) put(need(group, '[data-part="skin"]'), "d", skin.lines(box, front));
      return {
        half: (body.length * layout.scale) / 2,
        edge: -box.x,
        bumper: Math.max(0, (body.length * layout.scale) / 2 + box.x),
        height: box.height + lift,
        lift,
        top: layout.track - lift + shapes.labelTop(box),
        lane: shapes.lane(i, tallest, layout),
        group,
        mass: this.#mass(body.name, box, lift),
        velocity: need(this.root, `.carts-velocity[data-body="${body.name}"]`),
      };
    });
    this.#walls.show(run.header.track);
    this.#ground.show(run.header.track);
    this.#pushes.show(run, windows);
    this.#effects.show(run);
  }

  /** Draws the instant t. @param {number} t in s */
  at(t) {
    const { header, trajectory } = this.#run;
    const shift = this.camera * t;
    put(
      need(this.root, '[data-part="ground"]'),
      "transform",
      `translate(${px(-shift * this.layout.scale)} 0)`,
    );
    const centres = header.bodies.map((body) => {
      const x = valueAt(
        trajectory.t,
        trajectory.x[body.name] ?? [],
        trajectory.v[body.name] ?? [],
        t,
      );
      return this.layout.origin + (x - shift) * this.layout.scale;
    });
    const walls = this.#walls.faces(shift * this.layout.scale);
    const { left, right, dents } = squeezes(this.#carts, centres, walls);
    this.#walls.at(
      {
        left: { dent: dents.left, height: this.#carts[0]?.height ?? 0 },
        right: { dent: dents.right, height: this.#carts.at(-1)?.height ?? 0 },
      },
      shift * this.layout.scale,
    );
    this.#carts.forEach((cart, i) => {
      const centre = Number(centres[i]);
      const faces = /** @type {const} */ ([
        -cart.half + Number(left[i]),
        cart.half - Number(right[i]),
      ]);
      const foot = this.layout.track - cart.lift;
      put(cart.group, "transform", `translate(${px(centre)} ${px(foot)})`);
      put(cart.mass, "x", px(centre));
      put(need(cart.group, '[data-part="spring-left"]'), "d", shapes.spring(-cart.edge, faces[0]));
      put(need(cart.group, '[data-part="spring-right"]'), "d", shapes.spring(cart.edge, faces[1]));
      put(need(cart.group, '[data-part="face-left"]'), "transform", `translate(${px(faces[0])} 0)`);
      put(
        need(cart.group, '[data-part="face-right"]'),
        "transform",
        `translate(${px(faces[1])} 0)`,
      );
      this.#velocity(cart, header.bodies[i]?.name ?? "", centre, t);
    });
    /** @type {import("./pushes.js").Face} */
    const face = (name, side) => {
      const i = header.bodies.findIndex((body) => body.name === name);
      if (i < 0) {
        const wall = name === "left" ? 0 : (header.track.length ?? 0);
        const dent = name === "left" ? -dents.left : dents.right;
        return this.layout.origin + (wall - shift) * this.layout.scale + dent;
      }
      const half = this.#carts[i]?.half ?? 0;
      const centre = Number(centres[i]);
      return side === "left" ? centre - half + Number(left[i]) : centre + half - Number(right[i]);
    };
    this.#pushes.at(t, face);
    this.#effects.at(t, face, (name) =>
      Number(centres[header.bodies.findIndex((body) => body.name === name)]),
    );
  }

  /**
   * Hollow arrows of a prediction, at the start: tail on the body's own bumper face, and a handle at
   * the tip to pull it by; of one that is not drawn yet, the handle.
   * @param {import("../predict/arrows.js").Guess[]} guesses
   */
  guess(guesses) {
    const { header } = this.#run;
    const group = need(this.root, '[data-part="guess"]');
    const full = this.view.force || 10;
    const parts = guesses.flatMap(({ pair, on, side, size, slider }) => {
      const i = header.bodies.findIndex((body) => body.name === on);
      const body = header.bodies[i];
      const half = (body?.length ?? 0) / 2;
      const wall = on === "left" ? 0 : (header.track.length ?? 0);
      const x = body ? body.position + (side === "left" ? half : -half) : wall;
      const way = side === "left" ? -1 : 1;
      const length = way * shapes.arrowLength(size ?? 0, full, this.layout.force);
      const from = this.layout.origin + x * this.layout.scale;
      const y = this.layout.track - shapes.PUSH;
      const draw = shapes.isCut(size ?? 0, full) ? shapes.cutArrow : shapes.blockArrow;
      const style = `carts-${i < 0 ? "wall" : styleOf(i)}`;
      const arrow = svg("path", {
        class: `carts-guessed ${style}`,
        d: draw(from, y, length),
        "data-pair": pair,
        "data-on": on,
      });
      const tip = from + length + way * HANDLE;
      const handle = pullable(this.root, slider, way * this.layout.force, this.layout.width);
      handle.setAttribute("class", `carts-pull ${style}`);
      handle.append(
        svg("circle", { cx: px(tip), cy: px(y), r: 16, class: "carts-pull-room" }),
        svg("circle", { cx: px(tip), cy: px(y), r: 8 }),
        svg("path", {
          d: `M${px(tip - 2.5)} ${px(y - 2.5)}l-2.5 2.5l2.5 2.5M${px(tip + 2.5)} ${px(y - 2.5)}l2.5 2.5l-2.5 2.5`,
        }),
      );
      return size === null ? [handle] : [arrow, handle];
    });
    group.replaceChildren(...parts);
  }

  /** The mass, written over all boxes: a neighbour may be taller. @param {string} name @param {shapes.Box} box @param {number} lift */
  #mass(name, box, lift) {
    const mass = need(this.root, `.carts-mass[data-body="${name}"]`);
    put(mass, "y", px(this.layout.track - lift + box.labelY));
    say(mass, box.label);
    return mass;
  }

  /** @param {Cart} cart @param {string} name @param {number} x @param {number} t */
  #velocity(cart, name, x, t) {
    const { trajectory } = this.#run;
    const { layout, view } = this;
    const v =
      valueAt(trajectory.t, trajectory.v[name] ?? [], trajectory.a[name] ?? [], t) - this.camera;
    const seen = Math.abs(v) < NOISE * view.velocity ? 0 : v;
    const exact = shapes.arrowLength(seen, view.velocity, layout.velocity, shapes.FASTEST);
    const length = shapes.keptInside(x, exact, layout.width);
    const [at, anchor] = shapes.velocityText(x, length, layout.width);
    put(need(cart.velocity, '[data-part="arrow"]'), "d", shapes.lineArrow(x, cart.lane, length));
    put(
      need(cart.velocity, '[data-part="leader"]'),
      "d",
      `M${px(x)} ${px(cart.lane)}V${px(cart.top)}`,
    );
    const shortened = length !== exact || shapes.isCut(seen, view.velocity, shapes.FASTEST);
    const cut = shortened ? tr(", arrow cut") : "";
    const [per, unit] = speedUnit(view.velocity);
    const speed = `${fixed(seen / per, view.decimals.v ?? 2)} ${unit}${cut}`;
    const text = need(cart.velocity, '[data-part="text"]');
    const outside = x < 0 || x > layout.width;
    put(text, "x", px(outside ? (x < 0 ? 8 : layout.width - 8) : at));
    put(text, "y", px(cart.lane + 5));
    put(text, "text-anchor", outside ? (x < 0 ? "start" : "end") : anchor);
    say(text, outside ? tr("{name} is outside: {speed}", { name, speed }) : speed);
  }
}

/** @param {Element} group @param {string} name @param {shapes.Box} box */
function drawBox(group, name, box) {
  const rect = need(group, '[data-part="box"]');
  put(rect, "x", px(box.x));
  put(rect, "y", px(-box.height));
  put(rect, "width", px(box.width));
  put(rect, "height", px(box.height));
  const wheels = group.querySelector('[data-part="wheels"]');
  if (wheels) put(wheels, "d", shapes.wheels(box));
  const cut = need(group, '[data-part="break"]');
  put(cut, "visibility", box.cut ? "visible" : "hidden");
  const title = need(group, '[data-part="name"]');
  put(title, "y", px(box.nameY ?? 0));
  put(title, "visibility", box.nameY === null ? "hidden" : "visible");
  say(title, name);
}
