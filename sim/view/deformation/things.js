/**
 * What is drawn at an end of the track instead of a wall: foam that is squeezed, a spring that gets
 * shorter, a board that bends; each before a mounting, which stands still.
 */

import { px } from "../numbers.js";
import { coil } from "../shapes.js";
import { bubbles } from "./bubbles.js";
import { ROOM, SEEN, THICK } from "./walls.js";

/** @typedef {import("../types.js").Layout} Layout */
/** @typedef {import("./walls.js").Wall} Wall */
/** @typedef {[number, number]} Point x, y */
/** @typedef {{own: Point[], lines: string}} Made the outline of a thing, and thin lines on it */
/** @typedef {{x: (y: number, behind?: number) => number, heights: number[], back: number, depth: number}} Place `x` of what is touched at a height, or of what lies so far behind it; `heights` of its corners, from above; `back`: x of the mounting, `depth`: how far that is while nothing pushes */

const SHARE = 0.5; // of the picture beyond the end of the track, for the thing
const LEAST = 30; // units that it takes in any case
const MOST = 60;
const SHALLOW = 0.6; // of that, for a board
const SOLID = 8; // units that are left of what is squeezed most: further the mounting gives way
const ARM = 12; // units of the mounting that a board hangs from
const PLATE = 4; // units, before a spring
const PLANK = 8;
const PITCH = 9; // units between two turns of a spring
const HIGH = 13; // units, half the height of its coil

/** @type {Record<string, (place: Place) => Made>} */
const MADE = {
  foam(place) {
    const { x, heights, back, depth } = place;
    const [top, foot] = endsOf(heights);
    const above = `M${px(x(top))} ${px(top)}H${px(back)}`;
    const inside = bubbles(x, back, depth, [top, foot]);
    return { own: [...face(place), [back, foot], [back, top]], lines: above + inside };
  },
  spring(place) {
    const { x, heights, back, depth } = place;
    const [top, foot] = endsOf(heights);
    const [from, to] = [x(top, PLATE), back].sort((a, b) => a - b);
    const turns = Math.round(depth / PITCH);
    const wire = coil(Number(from), Number(to), (top + foot) / 2, turns, HIGH);
    const plate = slab(place, PLATE);
    return { own: plate, lines: area(plate) + wire };
  },
  board(place) {
    const plank = slab(place, PLANK);
    return { own: plank, lines: area(plank) + line(face(place, PLANK / 2)) };
  },
};

/** @param {string} what @param {Wall} wall @param {Layout} layout @returns {number} units from its face to its mounting while nothing pushes */
export function depthOf(what, { edge, way }, { width }) {
  const beyond = way > 0 ? width - edge : edge;
  const depth = Math.max(LEAST, Math.min(MOST, SHARE * beyond));
  return what === "board" ? SHALLOW * depth : depth;
}

/**
 * @param {string} what @param {Wall} wall @param {Layout} layout @param {number} dent how far it gives way @param {number} height of the cart that presses
 * @returns {{body: string, hatch: string, face: string, was: string, lines: string}} paths as those of a wall; `hatch`: its mounting, `lines`: thin ones
 */
export function thingPaths(what, wall, layout, dent, height) {
  const place = pressed(what, wall, layout, dent, height);
  const { own, lines } = /** @type {(place: Place) => Made} */ (MADE[what])(place);
  const inner = mounting(what, wall, layout, place.back);
  const far = wall.edge + wall.way * THICK;
  const behind = area([...inner, [far, wall.top], [far, layout.track + layout.beam]]);
  const [begin = 0] = place.heights.slice(-3); // above it nothing has moved
  return {
    body: behind + area(own),
    hatch: behind,
    face: line(face(place)) + line(inner),
    was: dent < SEEN ? "" : `M${px(wall.edge)} ${px(begin)}V${px(layout.track)}`,
    lines,
  };
}

/** The shape of what is touched, when it gives way: a board bends from its arm on. @param {string} what @param {Wall} wall @param {Layout} layout @param {number} dent @param {number} height @returns {Place} */
function pressed(what, wall, layout, dent, height) {
  const { edge, way, top } = wall;
  const foot = layout.track;
  const depth = depthOf(what, wall, layout);
  const back = edge + way * Math.max(depth, dent + SOLID);
  const place = (/** @type {number[]} */ heights, /** @type {(y: number) => number} */ give) => ({
    x: (/** @type {number} */ y, behind = 0) => edge + way * (give(y) + behind),
    heights,
    back,
    depth,
  });
  if (what === "spring" || dent === 0) return place([top, foot], () => dent);
  const high = Math.max(top, foot - height - ROOM);
  const shoulder = Math.max(top, Math.min(high, what === "board" ? top + ARM : high - dent));
  const part = (/** @type {number} */ y) => (y < high ? (y - shoulder) / (high - shoulder) : 1);
  return place([top, shoulder, high, foot], (y) => dent * Math.max(0, part(y)));
}

/** The line between the room that a thing has and what it is mounted on. @param {string} what @param {Wall} wall @param {Layout} layout @param {number} back @returns {Point[]} from below to above */
function mounting(what, { edge, way, top }, { track, beam }, back) {
  const held = edge + way * PLANK;
  /** @type {Point[]} */
  const arm =
    what === "board"
      ? [
          [back, top + ARM],
          [held, top + ARM],
          [held, top],
        ]
      : [[back, top]];
  return [[edge, track + beam], [edge, track], [back, track], ...arm];
}

/** @param {number[]} heights @returns {[number, number]} y of the top and of the foot */
function endsOf(heights) {
  return [Math.min(...heights), Math.max(...heights)];
}

/** @param {Place} place @param {number} behind @returns {Point[]} from above to below */
function face({ x, heights }, behind = 0) {
  return heights.map((y) => [x(y, behind), y]);
}

/** @param {Place} place @param {number} thick @returns {Point[]} an outline */
function slab(place, thick) {
  return [...face(place), ...face(place, thick).reverse()];
}

/** @param {Point[]} points @returns {string} a path */
function line(points) {
  return `M${points.map(([x, y]) => `${px(x)} ${px(y)}`).join("L")}`;
}

/** @param {Point[]} points @returns {string} a closed path */
function area(points) {
  return `${line(points)}Z`;
}
