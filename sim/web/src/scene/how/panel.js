/** What stands behind “How is this computed?”: the plan, its cost, and the switch to a stepping method. */

import { tr } from "../../../../view/language.js";
import { html, say } from "../../shared/dom.js";
import * as words from "./words.js";

/** @typedef {import("../../../../view/types.js").Run} Run */
/** @typedef {{method: string, parts: number} | {method: string, rtol: number}} Choice */

export const EXACT = "exact";
/** Primes: with round numbers a touch could fall on the end of a step by luck. */
const PARTS = [19, 37, 61, 103, 211, 499, 997, 1999, 4999];
const OPENS_AT = 3; // 103 steps: coarse enough to be seen
const TOLERANCES = [1e-3, 1e-6, 1e-9, 1e-12];
const ADAPTIVE = ["rk45", "adaptive"]; // they need scipy

export class HowPanel {
  /**
   * @param {HTMLElement} place @param {boolean} scipy whether the page can have it
   * @param {() => void} changed when the reader chooses a method or a step
   */
  constructor(place, scipy, changed) {
    this.until = 1;
    this.plan = html("ol", "carts-how-plan");
    this.plan.tabIndex = 0; // a long plan scrolls: by keys too
    this.plan.setAttribute("aria-label", tr("Plan"));
    this.cost = html("p", "carts-how-cost");
    this.method = document.createElement("select");
    this.method.className = "carts-how-method";
    this.method.append(option(EXACT, words.EXACT));
    for (const [name, label] of Object.entries(words.METHODS)) {
      if (scipy || !ADAPTIVE.includes(name)) this.method.append(option(name, label));
    }
    this.slider = document.createElement("input");
    this.slider.type = "range";
    this.slider.className = "carts-how-step";
    this.slider.min = "0";
    this.size = html("output");
    this.kind = html("span");
    this.stepRow = html("label");
    this.stepRow.append(this.kind, " ", this.slider, " ", this.size);
    const methodRow = html("label", "", `${words.METHOD} `);
    methodRow.append(this.method);
    const row = html("div", "carts-how-switch");
    row.append(methodRow, this.stepRow);
    this.note = html("p", "carts-how-note");
    this.note.setAttribute("role", "status");
    const table = html("table", "carts-table carts-how-told");
    this.told = html("tbody");
    table.append(this.told);
    this.table = html("div", "carts-scroll");
    this.table.append(table);
    place.replaceChildren(
      html("p", "carts-how-head", words.PLAN),
      this.plan,
      this.cost,
      html("p", "carts-how-head", words.SWITCH),
      row,
      this.note,
      this.table,
    );
    this.method.addEventListener("change", () => {
      this.#range();
      changed();
    });
    this.slider.addEventListener("input", () => {
      this.#size();
      changed();
    });
    this.reset();
  }

  /** @returns {Choice | null} null: exact */
  get choice() {
    const method = this.method.value;
    if (method === EXACT) return null;
    const place = this.slider.valueAsNumber;
    return ADAPTIVE.includes(method)
      ? { method, rtol: TOLERANCES[place] ?? 1e-9 }
      : { method, parts: PARTS[place] ?? 103 };
  }

  reset() {
    this.method.value = EXACT;
    this.#range();
    this.tell([]);
    say(this.note, "");
  }

  /** The plan of the exact run. @param {Run} run @param {number} decimals */
  show({ header }, decimals) {
    this.until = header.until;
    this.#size();
    const lines = header.plan.map((phase) => {
      const [times, how, why] = words.phaseWords(phase, decimals);
      const line = html("li");
      line.append(html("b", "", times), ` ${how}. `, html("span", "carts-quiet", why));
      return line;
    });
    this.plan.replaceChildren(...lines);
  }

  /** @param {[string, string][]} lines what is told of a stepped run */
  tell(lines) {
    this.table.hidden = lines.length === 0;
    const rows = lines.map(([head, value]) => {
      const row = html("tr");
      const first = html("th", "", head);
      first.setAttribute("scope", "row");
      row.append(first, html("td", "", value));
      return row;
    });
    this.told.replaceChildren(...rows);
  }

  /** The slider fits the method. */
  #range() {
    const adaptive = ADAPTIVE.includes(this.method.value);
    const kind = adaptive ? words.TOLERANCE : words.STEP;
    if (this.kind.textContent !== kind) {
      this.slider.max = String((adaptive ? TOLERANCES : PARTS).length - 1);
      this.slider.value = String(adaptive ? 1 : OPENS_AT);
    }
    say(this.kind, kind);
    this.stepRow.hidden = this.method.value === EXACT;
    this.#size();
  }

  #size() {
    const chosen = this.choice;
    if (!chosen) return;
    const text =
      "rtol" in chosen
        ? words.toleranceWords(chosen.rtol)
        : words.stepWords(this.until, chosen.parts);
    say(this.size, text);
    this.slider.setAttribute("aria-valuetext", text);
  }
}

/** @param {string} value @param {string} text */
function option(value, text) {
  const made = html("option", "", text);
  made.setAttribute("value", value);
  return made;
}
