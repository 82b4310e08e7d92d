/** The places of both marks in all frames that were followed; those that were lost are set by hand or left out. */

/** @typedef {import("./along.js").Point} Point */
/** @typedef {import("./along.js").Row} Row */
/** @typedef {{row: number, mark: number}} Place */

export class Mending {
  /** @type {Set<string>} */
  #left = new Set();
  /** The place that was changed last, as it was before. @type {{place: Place, point: Point | null, left: boolean} | null} */
  #last = null;

  /** @param {Row[]} rows */
  constructor(rows) {
    this.rows = rows;
  }

  /** Lost, and neither set nor left out since. @returns {Place[]} in the order of time */
  get lost() {
    return this.rows.flatMap(({ marks }, row) =>
      marks.flatMap((place, mark) =>
        place || this.#left.has(`${row} ${mark}`) ? [] : [{ row, mark }],
      ),
    );
  }

  /** @param {string[]} names of the carts */
  counts(names) {
    return names.map((name, mark) => ({
      name,
      count: this.rows.filter(({ marks }) => !marks[mark]).length,
    }));
  }

  /** The first lost place after this one, else the first of all. @param {Place} place @returns {Place | null} */
  after({ row, mark }) {
    const { lost } = this;
    const later = lost.find((one) => one.row > row || (one.row === row && one.mark > mark));
    return later ?? lost[0] ?? null;
  }

  /** @param {Place} place @param {Point} point */
  set(place, point) {
    this.#put(place, point, false);
  }

  /** @param {Place} place */
  leave(place) {
    this.#put(place, null, true);
  }

  /** @param {Place} place @param {Point | null} point @param {boolean} left whether it is left out */
  #put(place, point, left) {
    const marks = this.rows[place.row]?.marks ?? [];
    const key = `${place.row} ${place.mark}`;
    this.#last = { place, point: marks[place.mark] ?? null, left: this.#left.has(key) };
    marks[place.mark] = point;
    if (left) this.#left.add(key);
    else this.#left.delete(key);
  }

  get undoable() {
    return this.#last !== null;
  }

  /** Takes the last change back. @returns {Place | null} whose */
  undo() {
    if (!this.#last) return null;
    const { place, point, left } = this.#last;
    this.#put(place, point, left);
    this.#last = null;
    return place;
  }

  /** Where a mark should be, from the frames before and after that show it. @param {Place} place @returns {Point | null} */
  expected({ row, mark }) {
    const seen = (/** @type {Row} */ one) => one.marks[mark] ?? null;
    const now = this.rows[row]?.t ?? 0;
    const before = this.rows.slice(0, row).findLast(seen);
    const after = this.rows.slice(row + 1).find(seen);
    const [a, b] = [before && seen(before), after && seen(after)];
    if (!a || !b || !before || !after) return a ?? b ?? null;
    const part = (now - before.t) / (after.t - before.t);
    return { x: a.x + part * (b.x - a.x), y: a.y + part * (b.y - a.y) };
  }

  /** The row whose frame is shown at this time. @param {number} time s of the film */
  at(time) {
    const later = this.rows.findIndex(({ t }) => t > time + 1e-6);
    return Math.max(0, (later < 0 ? this.rows.length : later) - 1);
  }
}
