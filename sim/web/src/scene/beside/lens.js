/**
 * The place of contact, ten times as large as in the picture: bumpers that give way and recover,
 * and the two forces on the scale of the picture. It looks at the touch that is on, else at the one
 * that comes next, else at the last; at the end of the run, or where the two are out of its view, at the
 * instant in which they pushed hardest. Where a wall gives way further than the lens can show, in this run or
 * in a ready-made setting, it enlarges less, so that the line where the wall was stays in view.
 */

import { bodiesOf, isWall, kind, whatIs } from "../../../../view/bodies.js";
import { depthOf } from "../../../../view/deformation/things.js";
import { wallAt } from "../../../../view/deformation/walls.js";
import { contactForce } from "../../../../view/forces.js";
import { tr } from "../../../../view/language.js";
import { fixed, NOISE, px, short } from "../../../../view/numbers.js";
import { niceAbove } from "../../../../view/scales.js";
import { arrowLength, blockArrow, coil, cutArrow, isCut, spring } from "../../../../view/shapes.js";
import { valueAt } from "../../../../view/trajectory.js";
import { latestTouch } from "../../../../view/windows.js";
import { need, onResize, put, say } from "../../shared/dom.js";
import { drawThing } from "./lens-thing.js";

/** @typedef {import("../../../../view/types.js").Run} Run */
/** @typedef {import("../../../../view/windows.js").Touch} Touch */
/** @typedef {{name: string, edge: number, face: number, bumper: number}} Side one body at the contact, in m */

const TIMES = [10, 5, 2, 1]; // as large as in the picture
const MARGIN = 16; // units that the line where a wall was keeps from the edge
const WIDTH = 360;
const TRACK = 96; // y of the track
const BAR = 70; // units, the longest that the bar of lengths may be
const NAME = 42; // y of the name of a body
const ABOVE = 16; // of that of a thing, whose lines would lie under it
const SCALE = 3; // the springs are drawn so much taller than in the picture

export class Lens {
  /** @type {Run | null} */
  #run = null;
  /** @type {Touch[]} */
  #windows = [];
  #perMetre = 3000; // units
  #picture = 300; // units that one metre would take as large as in the picture
  #perForce = 100; // units of the full scale
  #t = 0;

  /** @param {HTMLElement} root @param {import("../../../../view/types.js").Baked} baked @param {() => void} redraw */
  constructor(root, baked, redraw) {
    this.root = root;
    this.view = baked.view;
    [this.layout] = baked.view.layouts; // of the picture that is seen
    this.scene = /** @type {HTMLElement} */ (root.closest("carts-scene"));
    this.plot = need(root, "svg");
    this.note = need(root, ".carts-lens-note");
    onResize(root, () => {
      this.#measure();
      redraw();
    });
  }

  /** What one metre of the picture takes on the screen, in units of this drawing. */
  #measure() {
    for (const layout of this.view.layouts) {
      const stage = this.scene.querySelector(`.carts-stage-${layout.kind}`);
      const [shown, own] = [stage?.clientWidth ?? 0, this.plot.clientWidth];
      if (!shown || !own) continue;
      const unit = (shown / layout.width) * (WIDTH / own);
      this.layout = layout;
      this.#picture = layout.scale * unit;
      this.#perForce = layout.force * unit;
    }
    this.#enlarge();
  }

  /** As large as this run allows, and a bar that tells how large. */
  #enlarge() {
    const give = Math.max(this.view.gives, this.#run ? wallGives(this.#run) : 0);
    const room = WIDTH / 2 - MARGIN;
    const times = TIMES.find((one) => give * one * this.#picture <= room) ?? 1;
    this.#perMetre = times * this.#picture;
    say(need(this.root, ".carts-heading"), tr("Lens on the contact, ×{times}", { times }));
    const length = niceAbove(BAR / this.#perMetre / 2.5);
    const bar = px(length * this.#perMetre);
    put(need(this.root, '[data-part="bar"]'), "d", `M10 16v-5m0 2.5h${bar}m0 -2.5v5`);
    const text = need(this.root, '[data-part="bar-text"]');
    put(text, "x", px(Number(bar) + 16));
    say(text, length < 0.01 ? `${short(length * 1000)} mm` : `${short(length * 100)} cm`);
  }

  /** @param {Run} run @param {Touch[]} windows */
  show(run, windows) {
    this.#run = run;
    this.#windows = windows;
    this.#enlarge();
  }

  /** @param {number} t in s */
  at(t) {
    const run = this.#run;
    const coming = this.#windows.find(({ end }) => t <= end);
    const past = latestTouch(this.#windows, t);
    const touch = coming ?? past;
    put(this.plot, "visibility", touch ? "visible" : "hidden");
    this.root.classList.toggle(
      "carts-is-slow",
      Boolean(touch && t >= touch.start && t <= touch.end),
    );
    if (!run || !touch) return say(this.note, tr("Nothing touches in this run."));
    this.#t = t;
    const faces = [this.#side(run, touch, 0).face, this.#side(run, touch, 1).face];
    const out = (Number(faces[1]) - Number(faces[0])) * this.#perMetre > WIDTH;
    const over = past && t > past.end && (out || t >= run.header.until);
    say(need(this.root, '[data-part="when"]'), over ? tr("when they pushed hardest") : "");
    if (over) this.#t = hardest(run, past);
    this.#show(run, over ? past : touch);
  }

  /** @param {Run} run @param {Touch} touch */
  #show(run, touch) {
    const t = this.#t;
    const [left, right] = [this.#side(run, touch, 0), this.#side(run, touch, 1)];
    const overlap = Math.max(0, left.face - right.face);
    const give = Math.min(overlap, left.bumper + right.bumper);
    const share = Math.min(left.bumper, left.bumper && right.bumper ? give / 2 : give);
    const touched = isWall(left.name) ? right.face + give : left.face - share;
    const middle = overlap > 0 ? touched : (left.face + right.face) / 2;
    const faces = overlap > 0 ? [touched, touched] : [left.face, right.face];
    const force = contactForce(run, touch.pair, t, NOISE * (this.view.force || 1));
    [left, right].forEach((side, k) => {
      this.#draw(run, k, side, Number(faces[k]), middle, force);
    });
    const pushed = touch.loose && t >= touch.start && t <= touch.end;
    const at = (/** @type {number} */ x) => WIDTH / 2 + (x - middle) * this.#perMetre;
    const wall = [left, right].find(({ name }) => isWall(name));
    const was = wall && overlap > 0 ? `M${px(at(wall.face))} 22V${TRACK}` : "";
    put(need(this.root, '[data-part="was"]'), "d", was); // where its surface is when nothing pushes it
    const wire = coil(at(left.face), at(right.face), TRACK - 14, undefined, 6);
    put(need(this.root, '[data-part="between"]'), "d", pushed ? wire : "");
    const pair = bodiesOf(touch.bodies, run.header.track);
    const gap = right.face - left.face;
    const apart =
      gap > 0
        ? tr("{length} apart", { length: lengthText(gap) })
        : tr("squeezed by {length}", { length: lengthText(overlap) });
    const size = fixed(force, this.view.decimals.F ?? 2);
    const push = tr("{size} on each", { size: `${size}\u00a0N` });
    say(this.note, `${pair}: ${apart}, ${push}; t = ${fixed(t, 4)} s`);
  }

  /** @param {Run} run @param {Touch} touch @param {number} k 0: left body @returns {Side} */
  #side({ header, trajectory }, touch, k) {
    const name = String(touch.bodies[k]);
    const cart = header.bodies.find((one) => one.name === name);
    if (!cart) {
      const wall = name === "left" ? 0 : (header.track.length ?? 0);
      return { name, edge: wall, face: wall, bumper: 0 };
    }
    const { t, x, v } = trajectory;
    const centre = valueAt(t, x[name] ?? [], v[name] ?? [], this.#t);
    const way = k === 0 ? 1 : -1;
    const face = centre + (way * cart.length) / 2;
    return { name, face, edge: face - way * cart.bumper_length, bumper: cart.bumper_length };
  }

  /** @param {Run} run @param {number} k 0: left body @param {Side} side @param {number} face in m, drawn @param {number} middle of the drawing in m @param {number} force in N */
  #draw(run, k, side, face, middle, force) {
    const at = (/** @type {number} */ x) => WIDTH / 2 + (x - middle) * this.#perMetre;
    const group = need(this.root, `[data-side="${k}"]`);
    const { bodies, track } = run.header;
    const index = bodies.findIndex(({ name }) => name === side.name);
    put(group, "class", index < 0 ? "carts-wall" : `carts-b${index % 8}`);
    const way = k === 0 ? 1 : -1;
    const end = at(face);
    const edge = index < 0 ? end : at(side.edge); // a wall gives way where it is touched
    const rect = need(group, '[data-part="body"]');
    put(rect, "x", px(k === 0 ? edge - 2 * WIDTH : edge));
    const what = index < 0 ? whatIs(side.name, track) : "wall";
    const depth = this.#depth(side.name, what, track.length);
    drawThing(group, what, { end, was: at(side.face), out: way > 0 ? -1 : 1, depth });
    const bent = need(group, '[data-part="spring"]');
    put(bent, "d", side.bumper ? spring(edge / SCALE, end / SCALE) : "");
    put(bent, "transform", `translate(0 ${TRACK}) scale(${SCALE})`);
    const plate = need(group, '[data-part="face"]');
    put(plate, "transform", `translate(${px(end - 3 * way)} 0)`);
    const name = need(group, '[data-part="name"]');
    const inside = Math.min(WIDTH - 34, Math.max(34, edge - 22 * way));
    put(name, "x", px(inside));
    put(name, "y", String(what === "wall" ? NAME : ABOVE));
    say(name, index < 0 ? kind(side.name, track) : side.name);
    const arrow = need(group, '[data-part="arrow"]');
    const cut = isCut(force, this.view.force);
    const length = -way * arrowLength(force, this.view.force, this.#perForce);
    put(arrow, "d", (cut ? cutArrow : blockArrow)(end, TRACK - 46, length));
  }

  /** @param {string} side @param {string} what @param {number | null} length of the track in m @returns {number} units from what stands there to its mounting, enlarged as all else */
  #depth(side, what, length) {
    if (!this.layout || what === "wall") return 0;
    const wall = wallAt(side === "left" ? "left" : "right", length, this.layout, 0);
    return (depthOf(what, wall, this.layout) / this.layout.scale) * this.#perMetre;
  }
}

/** When they pushed hardest, or touched. @param {Run} run @param {Touch} touch */
function hardest({ header }, { pair, start, end }) {
  const peak = header.events.find(
    (one) => one.kind === "peak" && one.bodies.join("-") === pair && one.t >= start && one.t <= end,
  );
  return peak?.t ?? start;
}

/** How far a wall gives way at most: what the bumper of the cart at it does not. @param {Run} run @returns {number} in m */
function wallGives({ header: { bodies, track }, trajectory: { x } }) {
  const ends = [
    { wall: track.left, at: 0, cart: bodies[0], way: -1 },
    { wall: track.right, at: track.length ?? 0, cart: bodies.at(-1), way: 1 },
  ];
  const gives = ends.map(({ wall, at, cart, way }) => {
    if (wall !== "wall" || !cart) return 0;
    const reach = cart.length / 2 - cart.bumper_length;
    return Array.from(x[cart.name] ?? []).reduce(
      (most, centre) => Math.max(most, way * (centre - at) + reach),
      0,
    );
  });
  return Math.max(...gives);
}

/** @param {number} metres @returns {string} */
function lengthText(metres) {
  return metres < 0.1 ? `${fixed(metres * 1000, 1)}\u00a0mm` : `${fixed(metres * 100, 1)}\u00a0cm`;
}
