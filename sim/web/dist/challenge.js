"use strict";
(() => {
  // ../view/language.js
  var catalogue = (
    /** @type {any} */
    globalThis.cartsWords ?? {}
  );
  function tr(sentence, values = {}) {
    return filled(catalogue[sentence] ?? sentence, values);
  }
  function filled(template, values) {
    return template.replace(/\{(\w+)\}/g, (whole, name) => String(values[name] ?? whole));
  }

  // ../view/bodies.js
  function listed(names) {
    const [first = "", second] = names;
    if (second === void 0) return first;
    const rest = names.slice(0, -1).join(", ");
    return tr("{first} and {last}", { first: rest, last: String(names.at(-1)) });
  }

  // ../view/numbers.js
  var SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  function exponent(value2) {
    return value2 ? Number(Math.abs(value2).toExponential(16).split("e")[1]) : 0;
  }
  function fixed(value2, decimals) {
    const text = Math.abs(value2).toFixed(decimals);
    return value2 < 0 && /[1-9]/.test(text) ? `−${text}` : text;
  }
  function short(value2, figures = 3) {
    const power = exponent(value2);
    if (value2 && (power <= -4 || power >= 6)) {
      const mantissa = trim(fixed(value2 / Number(`1e${power}`), figures - 1));
      return `${mantissa} × 10${superscript(power)}`;
    }
    return trim(fixed(value2, Math.max(0, figures - 1 - power)));
  }
  function superscript(power) {
    const digits = String(Math.abs(power)).replace(/\d/g, (d) => SUPERSCRIPT[Number(d)] ?? "");
    return power < 0 ? `⁻${digits}` : digits;
  }
  function trim(text) {
    return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  }

  // src/shared/dom.js
  var TEXT = 3;
  function say(element, text) {
    const only = element.firstChild;
    if (only?.nodeType === TEXT && !only.nextSibling) {
      if (only.nodeValue !== text) only.nodeValue = text;
    } else if (element.textContent !== text) element.textContent = text;
  }
  function need(root, selector) {
    const found = root.querySelector(selector);
    if (!found) throw new Error(`this page lacks ${selector}; it was built by another version`);
    return (
      /** @type {T} */
      found
    );
  }

  // src/shared/tab.js
  var TAB = () => sessionStorage;
  function recall(key, where = TAB) {
    try {
      return JSON.parse(where().getItem(key) ?? "null");
    } catch {
      return null;
    }
  }
  function retain(key, value2, where = TAB) {
    try {
      where().setItem(key, JSON.stringify(value2));
    } catch {
    }
  }

  // ../view/trajectory.js
  function rowAt(times, t) {
    let low = 0;
    let high = times.length;
    while (low < high) {
      const middle = low + high >> 1;
      if (
        /** @type {number} */
        times[middle] <= t
      ) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }
  function valueAt(times, values, slopes, t) {
    const k = rowAt(times, t);
    if (k < 0) return Number(values[0]);
    if (k >= times.length - 1) return Number(values[values.length - 1]);
    return hermite(times, values, slopes, k, t);
  }
  function hermite(times, values, slopes, k, t) {
    const at = (
      /** @type {(column: Column, k: number) => number} */
      ((c, i) => c[i])
    );
    const h = at(times, k + 1) - at(times, k);
    const s = (t - at(times, k)) / h;
    if (!slopes) return at(values, k) + (at(values, k + 1) - at(values, k)) * s;
    const r = 1 - s;
    const found = at(values, k) * (1 + 2 * s) * r * r + at(slopes, k) * h * s * r * r + at(values, k + 1) * (1 + 2 * r) * s * s - at(slopes, k + 1) * h * r * s * s;
    return Number.isFinite(found) ? found : at(values, k);
  }

  // src/question/marking/own-run.js
  function reading(run, mass, quantity, at) {
    const [what, ...rest] = quantity.split(".");
    const whose = rest.join(".");
    const column = (what === "p" ? run.v : run[String(what)])?.[whose];
    if (!column?.length) return null;
    const factor = what === "p" ? mass[whose] ?? Number.NaN : 1;
    const slopes = { x: run.v, v: run.a, p: run.a, F: run.dF }[String(what)]?.[whose] ?? null;
    if (at === "largest") {
      let most = 0;
      for (const value2 of column) if (Math.abs(value2) > Math.abs(most)) most = value2;
      return most * factor;
    }
    const t = at === "end" ? run.t[run.t.length - 1] : at === "start" ? run.t[0] : Number(at);
    return valueAt(run.t, column, slopes, t) * factor;
  }

  // src/question/marking/notation.js
  var RAISED = { "⁻": "-", "⁺": "+" };
  for (const [digit, raised] of [..."⁰¹²³⁴⁵⁶⁷⁸⁹"].entries()) RAISED[raised] = String(digit);
  var FACTOR = /\s*([/·⋅*.]?)\s*([A-Za-zµ°%]+)(?:([⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)|(?:\^|\*\*)\(?([+-]?\d(?:\.\d|\/\d)?)\)?|([+-]?\d))?/y;
  var POWER_OF_TEN = /\s*[×xX*·]\s*10(?:([⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]{1,3})|\s*(?:\^|\*\*)\s*(\(?[+-]?\d{1,3}\)?))/;
  var LONGEST = 30;
  var plain = (text) => text.replace(/[−‐‑–]/g, "-").replace(/μ/g, "µ");
  var lowered = (text) => [...text].map((sign) => RAISED[sign] ?? sign).join("");
  function number(power) {
    const [above, below] = power.split("/").map(Number);
    return Number(above) / (below ?? 1);
  }
  function factors(unit) {
    const text = plain(unit.trim());
    if (!text || text.length > LONGEST) return null;
    const powers = /* @__PURE__ */ new Map();
    for (let at = 0; at < text.length; at = FACTOR.lastIndex) {
      FACTOR.lastIndex = at;
      const found = FACTOR.exec(text);
      if (!found || at === 0 && found[1]) return null;
      const power = number(lowered(found[3] ?? "") || found[4] || found[5] || "1");
      const symbol = String(found[2]);
      powers.set(symbol, (powers.get(symbol) ?? 0) + (found[1] === "/" ? -power : power));
    }
    return [...powers].map(([symbol, power]) => `${symbol}^${power}`).sort().join(" ");
  }
  function sameUnit(one, other) {
    const read = factors(one);
    return one === other || read !== null && read === factors(other);
  }
  function withExponent(text) {
    return plain(text).replace(POWER_OF_TEN, (_, raised, power) => {
      return `e${lowered(raised ?? power).replace(/[()]/g, "")}`;
    });
  }

  // src/shared/typed.js
  function twoReadings(text) {
    const whole = text.replaceAll(",", "");
    if (text.split(",").length > 2) return tr("Type {number} without commas.", { number: whole });
    const decimal = String(Number(text.replace(",", ".")));
    return tr("{text} can mean {decimal} or {whole}: type {decimal} or {whole}", {
      text,
      decimal,
      whole
    });
  }

  // src/question/marking/typed-number.js
  var LONGEST2 = 40;
  var NUMBER = /^([+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?)\s*(.*)$/;
  var GROUPED = /^([+-]?[1-9]\d{0,2}(?:,\d{3})+)(?![\d,])/;
  function readNumber(typed, units) {
    const text = withExponent(typed.trim());
    if (!text) return { problem: tr("Type a number, for example 0.5") };
    if (text.length > LONGEST2) return { problem: tr("That is too long for a number.") };
    const grouped = GROUPED.exec(text);
    if (grouped) return { problem: twoReadings(String(grouped[1])) };
    const found = NUMBER.exec(text);
    if (!found) return { problem: tr("“{text}” is not a number. Type for example 0.5", { text }) };
    const number2 = String(found[1]);
    const unit = found[2] ?? "";
    const known = Object.keys(units).filter(Boolean);
    const own = unit ? known.find((one) => sameUnit(one, unit)) : "";
    const factor = unit ? own ? units[own] : void 0 : 1;
    if (factor === void 0) {
      const text2 = { unit, units: known.join(", ") };
      return { problem: tr("“{unit}” does not fit here. Units: {units}", text2) };
    }
    const value2 = Number(number2.replace(",", ".")) * factor;
    return Number.isFinite(value2) ? { value: value2 } : { problem: tr("{text} is too large.", { text }) };
  }

  // src/question/forms/run.js
  var KILOGRAMS = { kg: 1, g: 1e-3, mg: 1e-6, t: 1e3 };
  var changes = /* @__PURE__ */ new WeakMap();
  document.addEventListener("carts-update", (event) => {
    const { target, detail } = (
      /** @type {CustomEvent} */
      event
    );
    if (target instanceof Element) changes.set(target, detail);
  });
  function setBy(scene) {
    return changes.get(
      /** @type {Element} */
      scene
    ) ?? {};
  }
  function masses(scene) {
    const found = {};
    const baked = scene?.querySelector("script.carts-baked")?.textContent;
    for (const body of JSON.parse(baked ?? "{}").bodies ?? []) found[body.name] = body.mass;
    for (const [path, value2] of Object.entries(setBy(scene))) {
      if (!path.endsWith(".mass")) continue;
      const mass = readNumber(String(value2), KILOGRAMS);
      if ("value" in mass) found[path.slice(0, -".mass".length)] = mass.value;
    }
    return found;
  }

  // src/question/marking/goal.js
  function isMet({ left, relation, right }, run, mass, near) {
    const [a, b] = [value(left, run, mass), value(right, run, mass)];
    if (a === null || b === null) return false;
    if (relation === "<") return a < b;
    if (relation === ">") return a > b;
    const scale = Math.max(Math.abs(a), Math.abs(b));
    const beside = a === 0 || b === 0 ? largest(left.quantity || right.quantity, run, mass) : scale;
    return Math.abs(a - b) <= near * beside;
  }
  function value({ factor, quantity, at }, run, mass) {
    if (!quantity) return factor;
    const [what, whose = ""] = quantity.split(/\.(.*)/s);
    if (what !== "F" || whose in run.F) {
      const read = reading(run, mass, quantity, at);
      return read === null ? null : factor * read;
    }
    const forces = touching(run, whose).map((pair) => reading(run, mass, `F.${pair}`, at) ?? 0);
    return factor * forces.reduce((most, force) => Math.max(most, Math.abs(force)), 0);
  }
  function touching(run, name) {
    return Object.keys(run.F).filter((pair) => pair.split("-").includes(name));
  }
  function largest(quantity, run, mass) {
    const what = quantity.charAt(0);
    const names = Object.keys((what === "p" ? run.v : run[what]) ?? {});
    const all = names.map((name) => reading(run, mass, `${what}.${name}`, "largest") ?? 0);
    return Math.max(0, ...all.map(Math.abs));
  }

  // src/question/challenge.js
  var SETTLED = 800;
  var ChallengeElement = class extends HTMLElement {
    /** @type {Facts} */
    #facts = JSON.parse("{}");
    /** @type {Tries} */
    #tries = { tried: [], found: null };
    #leaving = new AbortController();
    #timer = 0;
    connectedCallback() {
      this.#facts = JSON.parse(need(this, ".carts-challenge-facts").textContent ?? "{}");
      this.#tries = kept(this.#name);
      this.#leaving = new AbortController();
      const { signal } = this.#leaving;
      for (const kind of ["carts-update", "carts-watched"]) {
        document.addEventListener(kind, (event) => this.#heard(event), { signal });
      }
      this.#show();
    }
    disconnectedCallback() {
      clearTimeout(this.#timer);
      this.#leaving.abort();
    }
    /** @param {Event} event of a scene */
    #heard({ target }) {
      if (!(target instanceof HTMLElement) || target.id !== this.#facts.scene) return;
      clearTimeout(this.#timer);
      this.#timer = setTimeout(() => this.#count(target), SETTLED);
    }
    /** A run that stands: each setting counts once. @param {HTMLElement} scene */
    #count(scene) {
      const run = (
        /** @type {any} */
        scene.trajectory
      );
      const first = scene.querySelector(".carts-end") !== null;
      if (!run || first && !("watched" in scene.dataset)) return;
      const set = setBy(scene);
      const key = JSON.stringify(Object.entries(set).sort());
      const { tried } = this.#tries;
      if (tried.includes(key)) return;
      tried.push(key);
      const { goal, near } = this.#facts;
      if (!this.#tries.found && isMet(goal, run, masses(scene), near)) {
        this.#tries.found = { run: tried.length, values: this.#told(set) };
      }
      retain(this.#name, this.#tries);
      this.#show();
    }
    /** What was set, in words. @param {Record<string, unknown>} set */
    #told(set) {
      const parts = Object.entries(set).map(([path, value2]) => {
        const { label, unit, per } = this.#facts.labels[path] ?? { label: path, unit: "", per: 1 };
        const shown = typeof value2 === "number" ? `${short(value2 / per)} ${unit}` : String(value2);
        return `${label} ${shown}`.trim();
      });
      return parts.length ? listed(parts) : tr("as the lesson sets it");
    }
    #show() {
      const { tried, found } = this.#tries;
      const tries = need(this, ".carts-challenge-tries");
      const words = found ? tr("Found in run {run} of {count}.", {
        run: String(found.run),
        count: String(tried.length)
      }) : tr("Runs you have tried: {count}. Not found yet.", { count: String(tried.length) });
      tries.hidden = tried.length === 0;
      say(tries, words);
      const place = need(this, ".carts-challenge-found");
      place.hidden = !found;
      if (found) say(place, tr("✓ {values}", { values: found.values }));
    }
    get #name() {
      return `carts-challenge ${location.pathname}#${this.id}`;
    }
  };
  function kept(name) {
    const { tried, found } = recall(name) ?? {};
    return { tried: Array.isArray(tried) ? tried : [], found: found ?? null };
  }

  // src/challenge-main.js
  customElements.define("carts-challenge", ChallengeElement);
})();
