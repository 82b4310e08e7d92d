/** The picture of a map on a canvas. */

import { palette, pixels } from "../../../view/map/pixels.js";

/** @typedef {import("../../../view/map/types.js").Scale} Scale */
/** @typedef {import("../../../view/map/types.js").Grid} Grid */

/** @param {HTMLCanvasElement} canvas @param {Pick<Grid, "values" | "columns">} grid @param {Scale} scale */
export function paint(canvas, { values, columns }, scale) {
  const { places, width, height } = pixels(values, columns, scale);
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
  const context = canvas.getContext("2d");
  if (!context) return;
  const image = context.createImageData(width, height);
  const words = new Uint32Array(image.data.buffer);
  const colours = packed(scale);
  for (let at = 0; at < places.length; at += 1) words[at] = Number(colours[Number(places[at])]);
  context.putImageData(image, 0, 0);
}

/** @param {Scale} scale @returns {Uint32Array} as a little-endian machine stores a pixel */
function packed(scale) {
  return Uint32Array.from(palette(scale), ([r, g, b]) => (255 << 24) | (b << 16) | (g << 8) | r);
}
