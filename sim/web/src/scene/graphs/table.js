/**
 * The table of values behind a graph.
 * It is filled when a reader opens it or the page comes to rest: drawing must not wait for it.
 */

import { tr } from "../../../../view/language.js";
import { fixed, NOISE, speedUnit } from "../../../../view/numbers.js";
import { span, ticks } from "../../../../view/scales.js";
import { valueAt } from "../../../../view/trajectory.js";
import { windowsOf } from "../../../../view/windows.js";
import { QUANTITIES } from "../../../../view/words.js";
import { html, need } from "../../shared/dom.js";

/** @typedef {import("../../../../view/types.js").Run} Run */
/** @typedef {import("../../../../view/series.js").Series} Series */
/** @typedef {{run: Run, curves: Series[], rows: ArrayLike<number>}} Shown rows: s, of the curves' values */

const ROWS = 10;
const MOST_EVENTS = 24;
const WITHIN = 9; // instants within a contact, where forces are told
const MOST_CONTACTS = 3;
const OF_CONTACTS = ["F", "R", "a"];
const REST = 250; // ms without a new run before a closed table is filled

export class Table {
  /** @type {Shown | null} */
  #waiting = null;
  #timer = 0;
  #seen = Infinity; // s, as far as the run was watched
  /** @type {Shown | null} */
  #shown = null;
  #rows = 0;

  /** @param {HTMLElement} details @param {string} quantity @param {import("../../../../view/types.js").View} view */
  constructor(details, quantity, view) {
    this.details = /** @type {HTMLDetailsElement} */ (details);
    this.quantity = quantity;
    this.view = view;
    details.addEventListener("toggle", () => {
      this.#waiting = this.#shown; // an open one has more rows than the page was built with
      this.fill();
    });
  }

  /** @param {Run} run @param {Series[]} curves @param {ArrayLike<number>} rows in s, those of the curves */
  show(run, curves, rows) {
    this.#waiting = { run, curves, rows };
    this.#shown = this.#waiting;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.fill(), this.details.open ? 0 : REST);
  }

  /** @param {number} seen s, as far as the run was watched */
  grow(seen) {
    this.#seen = seen;
    if (!this.#shown || this.#times(this.#shown.run).length === this.#rows) return;
    this.#waiting = this.#shown;
    if (this.details.open || seen === Infinity) this.fill();
  }

  fill() {
    if (!this.#waiting) return;
    const { run, curves, rows: instants } = this.#waiting;
    this.#waiting = null;
    const speed = speedUnit(this.view.velocity)[1];
    const unit = this.quantity === "v" ? speed : (QUANTITIES[this.quantity]?.[2] ?? "");
    const head = html("tr");
    head.append(
      heading(tr("t in s")),
      ...curves.map((curve) => heading(`${curve.label}, ${unit}`)),
    );
    need(this.details, "thead").replaceChildren(head);
    const decimals = this.view.decimals[this.quantity] ?? 3;
    const scale = greatest(curves);
    const times = this.#times(run);
    this.#rows = times.length;
    const rows = times.map((t) => {
      const row = html("tr");
      row.append(html("td", "", fixed(t, this.view.decimals.t ?? 3)));
      for (const { values, slopes } of curves) {
        const value = valueAt(instants, values, slopes, t);
        row.append(html("td", "", fixed(Math.abs(value) < NOISE * scale ? 0 : value, decimals)));
      }
      return row;
    });
    need(this.details, "tbody").replaceChildren(...rows);
  }

  /** @param {Run} run */
  #times(run) {
    const told = this.details.open && OF_CONTACTS.includes(this.quantity);
    const within = told ? contactTimes(run) : [];
    const times = new Set([...tableTimes(run), ...within]);
    return [...times].filter((t) => t <= this.#seen).sort((a, b) => a - b);
  }
}

/** Instants within the first contacts that last. @param {Run} run @returns {number[]} */
function contactTimes(run) {
  const { trajectory } = run;
  const last = Number(trajectory.t[trajectory.t.length - 1]);
  return windowsOf(run)
    .slice(0, MOST_CONTACTS)
    .flatMap(({ start, end }) =>
      Array.from({ length: WITHIN }, (_, k) => start + ((k + 1) / (WITHIN + 1)) * (end - start)),
    )
    .filter((t) => t <= last);
}

/** @param {Run} run @returns {number[]} round times and the times of the events, as far as the run got */
function tableTimes({ header, trajectory }) {
  const times = new Set([...ticks(span(0, header.until, ROWS)), header.until]);
  for (const event of header.events.slice(0, MOST_EVENTS)) times.add(event.t);
  const last = Number(trajectory.t[trajectory.t.length - 1]);
  return [...times].filter((t) => t <= last).sort((a, b) => a - b);
}

/** @param {string} text */
function heading(text) {
  const cell = html("th", "", text);
  cell.setAttribute("scope", "col");
  return cell;
}

/** @param {Series[]} curves */
function greatest(curves) {
  let found = 0;
  for (const { values } of curves) {
    for (let k = 0; k < values.length; k += 1) found = Math.max(found, Math.abs(Number(values[k])));
  }
  return found || 1;
}
