/**
 * From places in the picture to readings along the track.
 *
 * The track's direction is the one in which the marks move most: the first principal axis of both marks'
 * motions, each about its own mean. It points to the right of the picture, and downwards where the track is
 * steeper than 45°: a film on its side, whose track would else point up or down by chance.
 * Lengths come from the ruler; what lies nearer to the camera than the ruler looks longer, and is no fault
 * that readings could show.
 */

/** @typedef {{x: number, y: number}} Point pixels; y points down */
/** @typedef {{t: number, marks: (Point | null)[]}} Row of one frame; null: lost or left out */
/** @typedef {{ends: [Point, Point], length: number}} Ruler length in m */

/** @param {Row[]} rows @returns {Point} of length 1 */
export function direction(rows) {
  let [xx, xy, yy] = [0, 0, 0];
  for (const k of [0, 1]) {
    const seen = rows.flatMap(({ marks }) => marks[k] ?? []);
    const mean = {
      x: seen.reduce((sum, { x }) => sum + x, 0) / seen.length,
      y: seen.reduce((sum, { y }) => sum + y, 0) / seen.length,
    };
    for (const { x, y } of seen) {
      xx += (x - mean.x) ** 2;
      xy += (x - mean.x) * (y - mean.y);
      yy += (y - mean.y) ** 2;
    }
  }
  const angle = 0.5 * Math.atan2(2 * xy, xx - yy); // between −90° and 90°: to the right
  const down = angle < -Math.PI / 4 ? -1 : 1;
  return { x: down * Math.cos(angle), y: down * Math.sin(angle) };
}

/** @param {Ruler} ruler @returns {number} m for each pixel */
function scaleOf({ ends: [a, b], length }) {
  return length / Math.hypot(b.x - a.x, b.y - a.y);
}

/** How places in the picture and metres along the track belong together. */
export class Along {
  /** @param {Row[]} rows @param {Ruler} ruler */
  constructor(rows, ruler) {
    this.axis = direction(rows);
    this.scale = scaleOf(ruler);
  }

  /** @param {Point} place @returns {number} m, 0 at the left upper corner of the picture */
  metres({ x, y }) {
    return this.scale * (x * this.axis.x + y * this.axis.y);
  }

  /** The place on the line through `base` along the track. @param {number} metres @param {Point} base @returns {Point} */
  place(metres, base) {
    const on = (metres - this.metres(base)) / this.scale;
    return { x: base.x + on * this.axis.x, y: base.y + on * this.axis.y };
  }
}

/**
 * The readings as a file of readings would say them: an empty cell where a mark was lost or left out.
 * @param {Row[]} rows @param {Ruler} ruler @param {{names: string[], slower: number, remarks: string[]}} how slower: times that the film runs slower than life
 * @returns {string}
 */
export function readings(rows, ruler, { names, slower, remarks }) {
  const along = new Along(rows, ruler);
  const start = rows[0]?.t ?? 0;
  const lines = rows.map(({ t, marks }) => {
    const cells = marks.map((mark) => (mark ? along.metres(mark).toFixed(6) : ""));
    return [((t - start) / slower).toFixed(6), ...cells].join(";");
  });
  const head = ["t (s)", ...names.map((name) => `x_${name} (m)`)].join(";");
  return [...remarks.map((one) => `# ${one}`), head, ...lines, ""].join("\n");
}
