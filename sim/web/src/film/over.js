/** What is drawn over a frame: ends of the ruler, rings where the marks are, crosses where the model's carts are. */

/** @typedef {import("./along.js").Point} Point */
/** @typedef {import("./along.js").Row} Row */
/** @typedef {import("./view.js").Shown} Shown */

export const NAMES = ["A", "B"]; // of the carts

/**
 * @param {import("./setup.js").Setup["points"]} points that were clicked @param {Row | null} row of the frame, once it was followed
 * @returns {Shown[]}
 */
export function marked(points, row) {
  const ends = [points.one, points.other].flatMap((at) =>
    at ? [{ ...at, shape: /** @type {const} */ ("end"), label: "" }] : [],
  );
  const rings = NAMES.flatMap((label, k) => {
    const clicked = points[/** @type {"A"} */ (label)];
    const at = row ? row.marks[k] : clicked;
    const shape = /** @type {const} */ ("ring");
    return at ? [{ ...at, radius: clicked?.radius ?? 0, shape, label }] : [];
  });
  return [...ends, ...rings];
}

/** @param {Record<string, number>} model m, by cart @param {import("./along.js").Along | null} along @param {Row[]} rows @returns {Shown[]} */
export function crosses(model, along, rows) {
  if (!along) return [];
  return NAMES.flatMap((name, k) => {
    const [x, base] = [model[name], rows.find(({ marks }) => marks[k])?.marks[k]];
    if (x === undefined || !base) return [];
    return [{ ...along.place(x, base), shape: /** @type {const} */ ("cross"), label: "" }];
  });
}
