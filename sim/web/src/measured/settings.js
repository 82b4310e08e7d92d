/** Units, the span of time, the law, what else is fitted, and what was weighed: asked once, always shown. */

import { tr } from "../../../view/language.js";
import { html, need } from "../shared/dom.js";
import { complain, complainUnlessPositive, ifTyped, numberIn } from "../shared/number-box.js";

/** @typedef {import("../../../view/measured/types.js").Kept} Kept */
/** @typedef {import("../../../view/measured/types.js").Read} Read */

export class Settings {
  /** @type {HTMLInputElement[]} */
  #masses = [];
  /** @type {string[]} */
  #names = ["A", "B"];
  #wanted = ""; // the run that was chosen at an earlier visit

  /** @param {HTMLElement} root @param {(again: boolean) => void} changed again: the readings are others now */
  constructor(root, changed) {
    const find = (/** @type {string} */ name) =>
      /** @type {HTMLInputElement} */ (need(root, `.carts-measured-${name}`));
    this.from = find("from");
    this.until = find("until");
    this.law = find("law");
    this.effect = find("effect");
    this.distance = find("distance");
    this.together = find("together");
    this.run = /** @type {HTMLSelectElement} */ (need(root, ".carts-measured-run"));
    this.place = need(root, ".carts-measured-masses");
    /** @type {HTMLSelectElement[]} */
    this.units = [...root.querySelectorAll(".carts-measured-unit")].map(
      (select) => /** @type {HTMLSelectElement} */ (select),
    );
    this.changed = changed;
    for (const input of [...this.units, this.run, this.from, this.until]) {
      input.addEventListener("change", () => changed(true));
    }
    for (const box of [this.from, this.until, this.distance]) {
      box.addEventListener("change", () => complain(box, ifTyped(box)));
    }
    for (const input of [this.law, this.effect, this.distance, this.together]) {
      input.addEventListener("change", () => changed(false));
    }
  }

  /** Boxes for the masses of two carts. @param {string[]} names */
  named(names) {
    if (this.#masses.length && names.join() === this.#names.join()) return;
    const before = this.#masses.map((box) => box.value);
    this.#names = names;
    this.#masses = names.map((_, k) => {
      const box = /** @type {HTMLInputElement} */ (html("input"));
      Object.assign(box, {
        type: "text",
        inputMode: "decimal",
        autocomplete: "off",
        value: before[k] ?? "",
      });
      box.addEventListener("change", () => {
        complainUnlessPositive(box, ifTyped(box));
        this.changed(false);
      });
      return box;
    });
    this.place.replaceChildren(
      html("span", "", `${tr("weighed:")} `),
      ...names.flatMap((name, k) => {
        const label = html("label", "", `${name} `);
        label.append(/** @type {HTMLInputElement} */ (this.#masses[k]), " kg");
        return [label, " "];
      }),
      html("span", "carts-quiet", tr("if you have a balance")),
    );
  }

  /** What these readings leave open: units that no file names, and the run of a log that was read (the first may have been stopped at once). @param {Read} read */
  offer({ assumed, runs = [], run = "" }) {
    for (const select of this.units) {
      const open = assumed.some((kind) => kind === select.dataset.kind);
      select.closest("label")?.toggleAttribute("hidden", !open);
    }
    this.run.closest("label")?.toggleAttribute("hidden", runs.length < 2);
    if (this.run.options.length === runs.length) return;
    this.run.replaceChildren(...runs.map((name) => new Option(name)));
    this.run.value = this.#wanted;
    if (this.run.selectedIndex < 0) this.run.value = run;
  }

  /** Another film has another clock and other carts, another log other runs. @param {string} effect the usual one of these readings @param {import("./films.js").Same} same */
  clear(effect, same) {
    if (same === "clock") return;
    const ours = same ? [] : [...this.#masses, this.distance];
    for (const box of [...ours, this.from, this.until]) {
      box.value = "";
      complain(box, "");
    }
    if (same) return;
    this.effect.value = effect;
    this.together.checked = false;
    this.#wanted = "";
    this.run.replaceChildren();
  }

  /** @param {Kept} kept */
  fill(kept) {
    for (const select of this.units) {
      const kind = /** @type {"time"} */ (select.dataset.kind);
      if (kept.units[kind]) select.value = kept.units[kind];
    }
    this.#wanted = kept.run ?? "";
    this.from.value = kept.from;
    this.until.value = kept.until;
    this.law.value = kept.law;
    this.effect.value = kept.effect;
    this.distance.value = kept.distance;
    this.together.checked = kept.together ?? false;
    this.named(this.#names);
    for (const [k, box] of this.#masses.entries()) box.value = kept.masses[k] ?? "";
  }

  /** @returns {import("../../../view/measured/types.js").Units} */
  get chosen() {
    const units = { time: "", length: "", force: "" };
    for (const select of this.units) {
      units[/** @type {"time"} */ (select.dataset.kind)] = select.value;
    }
    return units;
  }

  /** Of these, what is kept. */
  get kept() {
    return {
      units: this.chosen,
      run: this.run.value || this.#wanted,
      from: this.from.value,
      until: this.until.value,
      law: this.law.value,
      effect: this.effect.value,
      distance: this.distance.value,
      together: this.together.checked,
      masses: this.#masses.map((box) => box.value),
    };
  }

  /** Of these, what Python is told. */
  get asked() {
    /** @type {Record<string, number>} */
    const masses = {};
    for (const [k, name] of this.#names.entries()) {
      const box = this.#masses[k];
      const mass = box && numberIn(box);
      if (mass && mass > 0) masses[name] = mass;
    }
    return {
      units: this.chosen,
      run: this.run.value || this.#wanted,
      from: numberIn(this.from),
      until: numberIn(this.until),
      law: this.law.value,
      effect: this.effect.value,
      distance: numberIn(this.distance),
      together: this.together.checked,
      masses,
    };
  }
}
