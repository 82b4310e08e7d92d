/**
 * A frame of the film on a canvas, what is marked in it, and a cross that a pointer or the arrow keys move. A
 * lens beside the cross shows what lies under it: on a phone a mark is smaller than a finger.
 */

import { clamp } from "./clamp.js";

/** @typedef {import("./along.js").Point} Point */
/** @typedef {Point & {shape: "ring" | "cross" | "end", label: string, radius?: number}} Shown pixels of the frame */

const STEP = 8; // pixels, with an arrow key
const FAR = 8; // px on the screen: no tap any more
const LENS = 0.36; // of the picture's height
const ZOOM = 3; // of the lens
const COLOURS = { ring: "#ffe14d", cross: "#ff5cf4", end: "#5ce1ff" };
const KEYS = /** @type {Record<string, [number, number]>} */ ({
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
});

export class View {
  /** @type {ImageBitmap | null} */
  #picture = null;
  /** @type {Shown[]} */
  #shown = [];
  /** @type {Point | null} */
  #cross = null;

  /** @param {HTMLCanvasElement} canvas @param {(point: Point) => void} set called when a place is chosen */
  constructor(canvas, set) {
    this.canvas = canvas;
    const pen = canvas.getContext("2d", { alpha: false });
    if (!pen) throw new Error("no canvas");
    this.pen = pen;
    let [x, y, sets] = [0, 0, true]; // where it went down; a finger sets a place by a tap, or when it goes sideways
    const far = (/** @type {PointerEvent} */ now) => {
      const [across, along] = [Math.abs(now.clientX - x), Math.abs(now.clientY - y)];
      sets ||= across > Math.max(FAR, along);
      return !sets && along > FAR;
    };
    canvas.addEventListener("pointermove", (event) => {
      if (event.isPrimary) far(event);
      this.#move(this.#at(event));
    });
    canvas.addEventListener("pointerdown", (event) => {
      if (event.button > 0 || !event.isPrimary) return; // it opens a menu, or enlarges
      canvas.setPointerCapture(event.pointerId);
      [x, y, sets] = [event.clientX, event.clientY, event.pointerType === "mouse"];
      this.#move(this.#at(event));
    });
    canvas.addEventListener("pointerup", (event) => {
      const held = event.isPrimary && canvas.hasPointerCapture(event.pointerId);
      if (!held || far(event)) return; // it scrolled
      this.#move(this.#at(event));
      if (this.#cross) set(this.#cross);
    });
    canvas.addEventListener("pointerleave", () => this.#move(null));
    canvas.addEventListener("blur", () => this.#move(null));
    canvas.addEventListener("keydown", (event) => this.#key(event, set));
  }

  /** @param {KeyboardEvent} event @param {(point: Point) => void} set */
  #key(event, set) {
    const { width, height } = this.canvas;
    const middle = { x: Math.round(width / 2), y: Math.round(height / 2) };
    const from = this.#cross ?? middle;
    const way = KEYS[event.key];
    if (way) {
      const step = event.shiftKey ? 1 : STEP;
      this.#move(this.#inside({ x: from.x + step * way[0], y: from.y + step * way[1] }));
    } else if (event.key === "Enter" || event.key === " ") {
      this.#move(from);
      if (!event.repeat) set(from);
    } else return;
    event.preventDefault();
  }

  /** @param {PointerEvent} event @returns {Point} a pixel's middle has whole numbers */
  #at(event) {
    const box = this.canvas.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * this.canvas.width - 0.5;
    const y = ((event.clientY - box.top) / box.height) * this.canvas.height - 0.5;
    return this.#inside({ x, y });
  }

  /** @param {Point} at @returns {Point} the nearest in the frame */
  #inside({ x, y }) {
    const { width, height } = this.canvas;
    return { x: clamp(x, 0, width - 1), y: clamp(y, 0, height - 1) };
  }

  /** @param {Point | null} point */
  #move(point) {
    this.#cross = point;
    this.draw();
  }

  /** The button that leads to a place stands below the frame: on a small screen it is out of sight. */
  reveal() {
    this.canvas.scrollIntoView({ block: "nearest" });
  }

  /** Puts the cross where a place is expected. @param {Point} point */
  aim(point) {
    this.#move({ ...point });
  }

  /** @param {ImageBitmap} picture it is this one's from now on @param {Shown[]} shown */
  show(picture, shown) {
    this.#picture?.close();
    this.#picture = picture;
    if (this.canvas.width !== picture.width || this.canvas.height !== picture.height) {
      this.canvas.width = picture.width;
      this.canvas.height = picture.height;
      const shape = `${picture.width / picture.height}`;
      this.canvas.parentElement?.style.setProperty("--carts-film-shape", shape);
    }
    this.mark(shown);
  }

  /** @param {Shown[]} shown */
  mark(shown) {
    this.#shown = shown;
    this.draw();
  }

  draw() {
    if (!this.#picture) return;
    const { pen, canvas } = this;
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.drawImage(this.#picture, 0, 0);
    const fine = canvas.width / (canvas.clientWidth || canvas.width); // pixels of the frame for one of the screen
    for (const one of this.#shown) this.#mark(one, fine);
    if (!this.#cross) return;
    this.#hair(this.#cross, fine);
    this.#lens(this.#cross, this.#picture, fine);
  }

  /** @param {Shown} one @param {number} fine */
  #mark({ x, y, shape, label, radius = 0 }, fine) {
    const reach = shape === "ring" ? Math.max(radius, 8 * fine) : 7 * fine;
    const path = new Path2D();
    if (shape === "ring") path.arc(x + 0.5, y + 0.5, reach, 0, 2 * Math.PI);
    else {
      const turn = shape === "cross" ? reach : 0; // an end of the ruler is an upright line
      path.moveTo(x + 0.5 - turn, y + 0.5 - reach);
      path.lineTo(x + 0.5 + turn, y + 0.5 + reach);
      if (turn) path.moveTo(x + 0.5 - turn, y + 0.5 + reach);
      if (turn) path.lineTo(x + 0.5 + turn, y + 0.5 - reach);
    }
    this.#line(path, COLOURS[shape], fine);
    if (!label) return;
    this.pen.font = `700 ${14 * fine}px sans-serif`;
    this.pen.textAlign = "center";
    this.pen.lineWidth = 3 * fine;
    this.pen.strokeStyle = "#000";
    this.pen.strokeText(label, x, y - reach - 4 * fine);
    this.pen.fillStyle = COLOURS[shape];
    this.pen.fillText(label, x, y - reach - 4 * fine);
  }

  /** Seen before anything: a bright line in a dark one. @param {Path2D} path @param {string} colour @param {number} fine */
  #line(path, colour, fine) {
    for (const [width, ink] of /** @type {[number, string][]} */ ([
      [4.5, "#000"],
      [2, colour],
    ])) {
      this.pen.lineWidth = width * fine;
      this.pen.strokeStyle = ink;
      this.pen.stroke(path);
    }
  }

  /** @param {Point} at @param {number} fine */
  #hair({ x, y }, fine) {
    const path = new Path2D();
    for (const [near, far] of [
      [4, 16],
      [-4, -16],
    ]) {
      path.moveTo(x + 0.5 + Number(near) * fine, y + 0.5);
      path.lineTo(x + 0.5 + Number(far) * fine, y + 0.5);
      path.moveTo(x + 0.5, y + 0.5 + Number(near) * fine);
      path.lineTo(x + 0.5, y + 0.5 + Number(far) * fine);
    }
    this.#line(path, "#fff", fine);
  }

  /** In the corner that is farthest from the cross. @param {Point} at @param {ImageBitmap} picture @param {number} fine */
  #lens({ x, y }, picture, fine) {
    const { width, height } = this.canvas;
    const side = LENS * height;
    const seen = side / ZOOM; // so much of the frame
    const left = x > width / 2 ? 0 : width - side;
    this.pen.imageSmoothingEnabled = false;
    this.pen.drawImage(
      picture,
      x + 0.5 - seen / 2,
      y + 0.5 - seen / 2,
      seen,
      seen,
      left,
      0,
      side,
      side,
    );
    const path = new Path2D();
    path.rect(left, 0, side, side);
    path.moveTo(left + side / 2, side / 2 - side / 12);
    path.lineTo(left + side / 2, side / 2 + side / 12);
    path.moveTo(left + side / 2 - side / 12, side / 2);
    path.lineTo(left + side / 2 + side / 12, side / 2);
    this.#line(path, "#fff", fine / 2);
  }

  end() {
    this.#picture?.close();
    this.#picture = null;
  }
}
