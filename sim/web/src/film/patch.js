/**
 * A piece of a frame, as the search sees it: brightness and two differences of colours, slightly smoothed.
 *
 * The eye tells a mark by its colour rather than by its brightness, which changes along a track; so brightness
 * counts half. A camera's own blur and the binomial filter here make edges so soft that the distance between
 * two pictures is a parabola near its least, which the subpixel place is read from.
 */

/**
 * @typedef {{left: number, top: number, width: number, height: number}} Box whole pixels of the frame
 * @typedef {Box & {channels: Float32Array[]}} Patch three channels, row after row
 */

const [FAR, NEAR, MID] = [1 / 16, 4 / 16, 6 / 16]; // the binomial filter: five pixels

/** @param {Uint8ClampedArray | Uint8Array} rgba of the box, row after row @param {Box} box @returns {Patch} */
export function patchOf(rgba, box) {
  const { left, top, width, height } = box;
  const raw = [0, 1, 2].map(() => new Float32Array(width * height));
  const [light, blue, red] = /** @type {[Float32Array, Float32Array, Float32Array]} */ (raw);
  for (let k = 0, at = 0; k < width * height; k += 1, at += 4) {
    const r = value(rgba, at);
    const b = value(rgba, at + 2);
    const y = 0.299 * r + 0.587 * value(rgba, at + 1) + 0.114 * b;
    light[k] = 0.5 * y;
    blue[k] = b - y;
    red[k] = r - y;
  }
  const spare = new Float32Array(width * height);
  for (const channel of raw) smooth(channel, spare, width, height);
  return { left, top, width, height, channels: raw };
}

/** A number of an array within its bounds, for the types: the loops below run millions of times a second. */
/** @param {ArrayLike<number>} values @param {number} k */
export const value = (values, k) => /** @type {number} */ (values[k]);

/** In place, along rows and then along columns; at the borders the last pixel goes on. */
/** @param {Float32Array} values @param {Float32Array} spare @param {number} width @param {number} height */
function smooth(values, spare, width, height) {
  for (let y = 0; y < height; y += 1) line(values, spare, y * width, 1, width);
  for (let x = 0; x < width; x += 1) line(spare, values, x, width, height);
}

/** @param {Float32Array} from @param {Float32Array} to @param {number} first @param {number} step @param {number} count */
function line(from, to, first, step, count) {
  const last = first + (count - 1) * step;
  let a = value(from, first);
  let b = a;
  let c = a;
  let d = value(from, Math.min(last, first + step));
  for (let k = first; k <= last; k += step) {
    const e = value(from, Math.min(last, k + 2 * step));
    to[k] = FAR * (a + e) + NEAR * (b + d) + MID * c;
    a = b;
    b = c;
    c = d;
    d = e;
  }
}

/** The box around a place that lies in the picture. */
/** @param {number} x @param {number} y @param {number} across half of its width @param {number} up half of its height @param {{width: number, height: number}} picture @returns {Box} */
export function boxAround(x, y, across, up, picture) {
  const left = Math.max(0, Math.min(picture.width - 1, Math.floor(x - across)));
  const top = Math.max(0, Math.min(picture.height - 1, Math.floor(y - up)));
  const right = Math.min(picture.width, Math.max(left + 1, Math.ceil(x + across) + 1));
  const bottom = Math.min(picture.height, Math.max(top + 1, Math.ceil(y + up) + 1));
  return { left, top, width: right - left, height: bottom - top };
}
