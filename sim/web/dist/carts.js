"use strict";
(() => {
  // src/shared/older.js
  function add(owner, name, value) {
    if (!(name in owner)) {
      Object.defineProperty(owner, name, { value, configurable: true, writable: true });
    }
  }
  function findLastIndex(fits2) {
    for (let k = this.length - 1; k >= 0; k -= 1) if (fits2(this[k], k, this)) return k;
    return -1;
  }
  function findLast(fits2) {
    return this[findLastIndex.call(this, fits2)];
  }
  function at(index) {
    return this[index < 0 ? this.length + index : index];
  }
  for (const kind2 of [Array, Float64Array, Uint8Array]) {
    add(kind2.prototype, "findLast", findLast);
    add(kind2.prototype, "findLastIndex", findLastIndex);
    add(kind2.prototype, "at", at);
  }
  add(String.prototype, "at", at);
  add(
    Object,
    "hasOwn",
    (owner, name) => (
      // biome-ignore lint/suspicious/noPrototypeBuiltins: this is what stands in for Object.hasOwn
      Object.prototype.hasOwnProperty.call(owner, name)
    )
  );
  add(
    globalThis,
    "structuredClone",
    (value) => JSON.parse(JSON.stringify(value))
  );

  // ../view/language.js
  var catalogue = globalThis.cartsWords ?? {};
  var FORMS = "\0";
  var RULE = catalogue["\0"] ?? "";
  function tr(sentence, values = {}) {
    return filled(catalogue[sentence] ?? sentence, values);
  }
  function counted(one, more, n3, values = {}) {
    return filled(form(one, more, n3), { n: n3, ...values });
  }
  function form(one, more, n3) {
    const ours = catalogue[more]?.split(FORMS);
    if (!ours) return n3 === 1 ? one : more;
    const english = n3 === 1 ? 0 : 1;
    const asked4 = RULE ? Number(RULE[n3 < RULE.length ? n3 : 100 + n3 % 100]) : english;
    return String(ours[Math.min(asked4, ours.length - 1)]);
  }
  function told(sentence) {
    if (typeof sentence === "string") return catalogue[sentence] ?? sentence;
    const values = Object.entries(sentence.values).map(([name, value]) => [name, told(value)]);
    const { code, one } = sentence;
    const n3 = Number(String(sentence.values.n).replace(/,/g, ""));
    const template = one ? form(one, code, n3) : catalogue[code] ?? code;
    return filled(template, Object.fromEntries(values));
  }
  function inRow(parts2) {
    const [head = "", ...tail3] = parts2;
    return tail3.reduce((first, second) => tr("{first}, {second}", { first, second }), head);
  }
  function joined(sentences) {
    const [head = "", ...tail3] = sentences.filter(Boolean);
    return tail3.reduce((first, then) => tr("{first} {then}", { first, then }), head);
  }
  function ended(sentence) {
    return tr("{sentence}.", { sentence });
  }
  function filled(template, values) {
    return template.replace(/\{(\w+)\}/g, (whole, name) => String(values[name] ?? whole));
  }

  // ../view/numbers.js
  var SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  var NOISE = 1e-9;
  var MAX_DECIMALS = 12;
  var SLOW = 0.01;
  function exponent(value) {
    return value ? Number(Math.abs(value).toExponential(16).split("e")[1]) : 0;
  }
  function fixed(value, decimals) {
    const text = Math.abs(value).toFixed(decimals);
    return value < 0 && /[1-9]/.test(text) ? `−${text}` : text;
  }
  function decimalsFor(scale, figures2 = 3) {
    return Math.min(MAX_DECIMALS, Math.max(0, figures2 - 1 - exponent(scale)));
  }
  function short(value, figures2 = 3) {
    const power2 = exponent(value);
    if (value && (power2 <= -4 || power2 >= 6)) {
      const [digits = "", tens] = Math.abs(value).toExponential(figures2 - 1).split("e");
      return `${value < 0 ? "−" : ""}${trim(digits)} × 10${superscript(Number(tens))}`;
    }
    return trim(fixed(value, Math.max(0, figures2 - 1 - power2)));
  }
  function figures(value, count2 = 3) {
    const power2 = exponent(value);
    return power2 <= -4 || power2 >= 6 ? short(value, count2) : fixed(value, decimalsFor(value, count2));
  }
  function superscript(power2) {
    const digits = String(Math.abs(power2)).replace(/\d/g, (d2) => SUPERSCRIPT[Number(d2)] ?? "");
    return power2 < 0 ? `⁻${digits}` : digits;
  }
  function decimalsOf(value, figures2 = 6) {
    const text = Math.abs(value).toFixed(decimalsFor(value, figures2));
    return trim(text).split(".")[1]?.length ?? 0;
  }
  function speedUnit(scale) {
    return scale <= SLOW ? [1e-3, "mm/s"] : [1, "m/s"];
  }
  function trim(text) {
    return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  }
  function px(value, decimals = 1) {
    const factor = 10 ** decimals;
    const rounded = Math.floor(value * factor + 0.5) / factor;
    return String(rounded === 0 ? 0 : rounded);
  }

  // ../view/cost/methods.js
  var METHODS = {
    exact: {
      label: tr("exact, closed form"),
      mark: "M0-6L1.6-2 6-2 2.5 1 4 6 0 3-4 6-2.5 1-6-2-1.6-2Z",
      colour: "#0072b2"
    },
    "exact-run": { label: tr("exact, any scene"), mark: "M0-5L5 0 0 5-5 0Z", colour: "#0072b2" },
    certified: {
      label: tr("certificate, proved"),
      mark: "M0-6L5.2-3V3L0 6-5.2 3V-3Z",
      colour: "#0072b2"
    },
    euler: { label: "Euler", mark: "M-4-4H4V4H-4Z", colour: "#c04a00" },
    "semi-implicit": { label: tr("semi-implicit Euler"), mark: "M0-5L5 4H-5Z", colour: "#00805d" },
    verlet: { label: tr("velocity Verlet"), mark: "M0 5L5-4H-5Z", colour: "#a8457f" },
    yoshida: {
      label: tr("Yoshida, order 4, symplectic"),
      mark: "M-5 0L0-5 5 0M-5 4L0-1 5 4 0 2Z",
      colour: "#a8457f"
    },
    richardson: {
      label: "Verlet + Richardson",
      mark: "M-5-4H5V-1H-5ZM-5 1H5V4H-5Z",
      colour: "#8a5f00"
    },
    rk4: { label: "RK4", mark: "M-4.5 0a4.5 4.5 0 1 0 9 0a4.5 4.5 0 1 0-9 0Z", colour: "#8a5f00" },
    "rk4-events": {
      label: tr("RK4 + located touches"),
      mark: "M-5-1.5H-1.5V-5H1.5V-1.5H5V1.5H1.5V5H-1.5V1.5H-5Z",
      colour: "#2779a7"
    },
    rk45: {
      label: tr("adaptive RK45 + located touches"),
      mark: "M-5-3.5H5L0 0L5 3.5H-5L0 0Z",
      colour: "#6b3f7d"
    },
    adaptive: {
      label: tr("adaptive DOP853 + located touches"),
      mark: "M-5 0L-1.5-4H1.5L5 0 1.5 4H-1.5Z",
      colour: "#555"
    }
  };
  var STEPLESS = ["exact", "exact-run", "certified"];
  var stepping = () => Object.keys(METHODS).filter((name) => !STEPLESS.includes(name));

  // ../view/cost/words.js
  var [MANY, HUGE] = [1e3, 1e4];
  var FEW = 10;
  var ENDLESS = tr("beyond all numbers");
  function percent(part, whole) {
    return `${plain(100 * part / whole, 1)} %`;
  }
  var inParts = (start, most) => start > 0 && most < FEW * start;
  function joules(value) {
    return `${Math.abs(value) < 0.1 ? short(value) : plain(value, 3)} J`;
  }
  function plain(value, decimals) {
    return Math.abs(value) < HUGE ? fixed(value, decimals) : short(value);
  }
  function told2({ v: v2, energy, evaluations }) {
    const speeds = Object.entries(v2.stepped).map(([name, speed]) => {
      const got = speed === null ? ENDLESS : `${plain(speed, 4)} m/s`;
      return [
        tr("velocity of {name} at the end", { name }),
        got,
        `${plain(Number(v2.exact[name]), 4)} m/s`
      ];
    });
    const { initial, stepped, exact, imbalance } = energy;
    const part = inParts(initial, exact);
    const amount3 = (value) => part ? percent(value, initial) : joules(value);
    return [
      ...speeds,
      [
        part ? tr("energy at the end, of that at the start") : tr("energy at the end"),
        stepped === null ? ENDLESS : amount3(stepped),
        amount3(exact)
      ],
      [tr("energy made from nothing"), imbalance === null ? ENDLESS : `${short(imbalance)} J`, "0 J"],
      [tr("times that all forces were computed"), String(evaluations), "0"]
    ];
  }
  function toleranceText(rtol) {
    return tr("tolerance {size}", { size: `1e${Math.round(Math.log10(rtol))}` });
  }
  function cells(row, until) {
    let size = "–";
    if (row.rtol) size = toleranceText(row.rtol);
    else if (row.step) size = `${short(until)} s / ${Math.round(until / row.step)}`;
    const ratio = row.time_ratio;
    return [
      METHODS[row.method]?.label ?? row.method,
      size,
      String(row.evaluations),
      ratio >= MANY ? String(Math.round(ratio)) : short(ratio),
      errorText(row, row.error_v),
      errorText(row, row.energy_error)
    ];
  }
  function errorText({ evaluations }, error) {
    if (error !== null) return short(error, 2);
    return evaluations ? ENDLESS : "–";
  }
  function rowOf(rows, until, { method, rtol, parts: parts2 }) {
    return rows.find((row) => {
      if (row.method !== method) return false;
      return row.rtol ? row.rtol === rtol : Math.round(until / Number(row.step)) === parts2;
    });
  }

  // src/shared/dom.js
  var SVG = "http://www.w3.org/2000/svg";
  function svg(tag, attributes = {}) {
    const made4 = document.createElementNS(SVG, tag);
    for (const [name, value] of Object.entries(attributes)) made4.setAttribute(name, String(value));
    return made4;
  }
  function html(tag, className = "", text = "") {
    const made4 = document.createElement(tag);
    if (className) made4.className = className;
    if (text) made4.textContent = text;
    return made4;
  }
  function put(element, name, value) {
    if (element.getAttribute(name) !== value) element.setAttribute(name, value);
  }
  function fit(group2, count2, make) {
    while (group2.children.length > count2) group2.lastElementChild?.remove();
    while (group2.children.length < count2) group2.append(make());
  }
  var TEXT = 3;
  function say(element, text) {
    const only = element.firstChild;
    if (only?.nodeType === TEXT && !only.nextSibling) {
      if (only.nodeValue !== text) only.nodeValue = text;
    } else if (element.textContent !== text) element.textContent = text;
  }
  function need(root, selector) {
    const found3 = root.querySelector(selector);
    if (!found3) throw new Error(`this page lacks ${selector}; it was built by another version`);
    return found3;
  }
  function parsed(markup) {
    const holder = document.createElement("template");
    holder.innerHTML = markup;
    return holder.content.firstElementChild;
  }
  function onResize(element, act) {
    if (typeof ResizeObserver === "function") new ResizeObserver(act).observe(element);
  }

  // src/scene/element-words.js
  var ASK_FIRST = tr("Make your prediction and lock it first.");
  var LIVE = tr("live: Python computes in this page");
  var NOT_STARTED = tr("Python could not start.");
  var STILL_PLAYS = tr("The prepared run still plays; values cannot be changed.");
  var NOT_SHOWN = tr("Your prediction is kept; the run cannot be shown.");
  var STEPWISE = tr("The scene still works: its sliders go from one prepared run to the next.");
  var SLOW2 = {
    slow: tr("This computer needs long to start Python. It is still trying."),
    "slow-line": tr(
      "The network is slow: Python is still on its way. You need not load the page again."
    )
  };
  var LONG_RUN = tr("This computer needs long for this run. It is still computing.");
  var PREDICTION_KEPT = tr("Your prediction is kept.");
  var slow = (what, stepwise) => stepwise ? `${SLOW2[what]} ${STEPWISE}` : SLOW2[what];
  function without(told4, stepwise) {
    if (stepwise) return STEPWISE;
    return told4 ? STILL_PLAYS : NOT_SHOWN;
  }
  function note(scene, message) {
    const place4 = need(scene, ".carts-note");
    place4.hidden = !message;
    place4.classList.remove("carts-passing");
    say(place4, message);
  }
  function passing(scene, message, on) {
    const place4 = need(scene, ".carts-note");
    if (!on && place4.textContent !== message) return;
    note(scene, on ? message : "");
    place4.classList.toggle("carts-passing", on);
    if (on) place4.style.top = `${need(scene, ".carts-top").offsetHeight}px`;
  }
  function noteBeside(scene, message) {
    const why = scene.dataset.state === "failed" ? need(scene, ".carts-note").dataset.why : "";
    note(scene, `${why ?? ""} ${message}`.trim());
  }
  function planOf(run) {
    return (run?.header.plan ?? []).map((phase) => ({ ...phase, why: told(phase.why) }));
  }
  function offerUndo(scene, on) {
    const undo = scene.querySelector(".carts-undo");
    if (undo instanceof HTMLButtonElement) undo.disabled = !on;
  }

  // src/scene/time/slow.js
  var WATCH = 3;
  var BEFORE = 0.15;
  var AFTER = 0.25;
  var SLOWEST = 1e-12;
  var RATES = [0.5, 0.2, 0.1];
  function rateFor(duration2) {
    const wanted2 = duration2 / WATCH;
    for (let power2 = 1; power2 > SLOWEST; power2 /= 10) {
      for (const rate of RATES) if (rate * power2 <= wanted2) return rate * power2;
    }
    return wanted2;
  }
  function slowParts(touches2) {
    const parts2 = [];
    for (const { start, end: end2 } of touches2) {
      const duration2 = end2 - start;
      const rate = rateFor(duration2);
      if (rate >= 1) continue;
      const part = { from: start - BEFORE * duration2, to: end2 + AFTER * duration2, rate };
      const last = parts2.at(-1);
      if (last && part.from <= last.to) {
        last.to = Math.max(last.to, part.to);
        last.rate = Math.min(last.rate, rate);
      } else parts2.push(part);
    }
    return parts2;
  }
  function slowAt(parts2, t3) {
    return parts2.find((part) => t3 >= part.from && t3 < part.to);
  }
  function advance(t3, seconds, speed, parts2, until) {
    let now = t3;
    let left2 = seconds;
    while (left2 > 0 && now < until) {
      const inside2 = slowAt(parts2, now);
      const rate = inside2 ? Math.min(speed, inside2.rate) : speed;
      const edge3 = inside2 ? inside2.to : parts2.find((part) => part.from > now)?.from ?? until;
      const next = Math.min(edge3, until);
      if (now + left2 * rate < next) return now + left2 * rate;
      left2 -= (next - now) / rate;
      now = next;
    }
    return Math.min(now, until);
  }
  function rateText(rate) {
    return rate < 1 ? `1/${Math.round(1 / rate)}` : `${rate}×`;
  }

  // src/scene/time/player.js
  var SAME = 1e-12;
  var STEP = 0.04;
  var STILL = 1;
  var LONGEST_FRAME = 0.1;
  var Player = class {
    time = 0;
    own = 0;
    // s that the reader has watched since the start
    playing = false;
    speed = 1;
    slow = true;
    until = 1;
    seen = Infinity;
    ended = () => {
    };
    // what to do at the end of the run
    stepped = () => {
    };
    parts = [];
    halts = [];
    halting = false;
    stops = [];
    stills = matchMedia("(prefers-reduced-motion: reduce)").matches;
    #waited = 0;
    // s since the last still
    #frame = 0;
    #last = 0;
    constructor(changed) {
      this.changed = changed;
    }
    get #parts() {
      return this.slow ? this.parts : [];
    }
    get rate() {
      return Math.min(this.speed, slowAt(this.#parts, this.time)?.rate ?? this.speed);
    }
    get isSlow() {
      return this.rate < this.speed;
    }
    toggle() {
      if (this.playing) this.pause();
      else this.play();
    }
    play() {
      if (this.playing) return;
      if (this.time >= this.until) this.#move(0);
      if (this.time === 0) this.own = 0;
      this.playing = true;
      this.#last = 0;
      this.#waited = 0;
      this.changed(this.time, false);
      this.#frame = requestAnimationFrame((now) => this.#tick(now));
    }
    pause() {
      if (!this.playing) return;
      this.playing = false;
      cancelAnimationFrame(this.#frame);
      this.changed(this.time, false);
    }
    seek(t3) {
      this.#move(Math.min(t3, this.seen));
      if (t3 <= 0) this.own = 0;
      this.#tell(this.time, false);
    }
    show(t3) {
      this.seen = Math.max(this.seen, t3);
      this.seek(t3);
    }
    step(way, count2 = 1) {
      this.pause();
      const start = this.time;
      for (let k = 0; k < count2; k += 1) {
        const before = this.time;
        const target = before + way * STEP * this.rate;
        const event = way > 0 ? this.stops.find((t3) => t3 > before + SAME) : this.stops.findLast((t3) => t3 < before - SAME);
        const passed = event !== void 0 && (way > 0 ? event < target : event > target);
        this.#move(passed ? event : target);
        this.#tell(before, way > 0);
      }
      this.stepped(start);
    }
    #tick(now) {
      if (!this.playing) return;
      const seconds = this.#last ? Math.min(LONGEST_FRAME, (now - this.#last) / 1e3) : 0;
      this.#last = now;
      const before = this.time;
      this.own += seconds;
      this.#waited += seconds;
      if (this.stills && this.#waited < STILL) {
        this.#frame = requestAnimationFrame((next2) => this.#tick(next2));
        return;
      }
      const shown3 = this.stills ? this.#waited : seconds;
      this.#waited = 0;
      let next = advance(before, shown3, this.speed, this.#parts, this.until);
      if (this.stills) next = this.stops.find((t3) => t3 > before + SAME && t3 < next) ?? next;
      const halt = this.halting ? this.halts.find((t3) => t3 > before + SAME && t3 <= next) : void 0;
      this.#move(halt ?? next);
      if (halt !== void 0 || this.time >= this.until) this.playing = false;
      this.#tell(before, true);
      if (this.playing) this.#frame = requestAnimationFrame((next2) => this.#tick(next2));
    }
    #move(t3) {
      this.time = Math.min(this.until, Math.max(0, t3));
      this.seen = Math.max(this.seen, this.time);
    }
    #tell(before, playing) {
      this.changed(before, playing);
      if (this.time >= this.until) this.ended();
    }
  };

  // src/shared/waiting.js
  function frame() {
    return new Promise((resolve) => requestAnimationFrame(resolve));
  }
  var RESET = "carts-reset";
  var MEASURES = 200;
  function waited(name, at3) {
    if (performance.getEntriesByName(name).length >= MEASURES) performance.clearMeasures(name);
    performance.measure(name, { start: at3, end: performance.now() });
  }
  async function drawn(scene, at3, detail) {
    await frame();
    waited("carts:update", at3);
    scene.dispatchEvent(new CustomEvent("carts-update", { bubbles: true, detail }));
  }
  function deferred() {
    const made4 = {};
    made4.promise = new Promise((resolve, reject) => Object.assign(made4, { resolve, reject }));
    return made4;
  }
  function refusal(problems) {
    const [first] = problems;
    if (!first) return new Error(tr("This value does not work."));
    const message = told(first.message);
    const text = first.hint ? `${message}: ${told(first.hint)}` : message;
    return Object.assign(new Error(text), { path: first.path, refused: true });
  }

  // src/shared/working.js
  var still = (event) => event.repeat && event.preventDefault();
  function passOn(from, to) {
    if (document.activeElement !== from) return;
    to.addEventListener("keydown", still);
    to.focus();
  }
  function showWorking(root, name, on) {
    const part = (what) => need(root, `.carts-${name}-${what}`);
    const [from, to] = on ? [part("go"), part("stop")] : [part("stop"), part("go")];
    to.hidden = false;
    passOn(from, to);
    from.hidden = true;
    const progress = part("progress");
    progress.hidden = !on;
    progress.value = 0;
  }

  // ../view/markup.js
  var ESCAPED = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;" };
  var Markup = class {
    constructor(text) {
      this.text = text;
    }
    toString() {
      return this.text;
    }
  };
  function html2(strings, ...values) {
    let written2 = strings[0] ?? "";
    values.forEach((value, k) => {
      const quote = strings[k]?.endsWith("=") ? '"' : "";
      written2 += quote + asText(value) + quote + (strings[k + 1] ?? "");
    });
    return new Markup(written2);
  }
  function asText(value) {
    if (Array.isArray(value)) return value.map(asText).join("");
    if (value instanceof Markup) return value.text;
    if (value === false || value === null || value === void 0) return "";
    return String(value).replace(/[&<>"']/g, (sign) => ESCAPED[sign] ?? sign);
  }

  // ../view/cost/breaks.js
  var [LEFT, TOP, RIGHT, BOTTOM] = [62, 10, 510, 322];
  var TICKS_Y = BOTTOM + 16;
  var MADE = tr("energy was made");
  var UNITS = { stiffness: "N/m", mass: "kg" };
  var cell = (count2) => ({ wide: (RIGHT - LEFT) / count2, high: (BOTTOM - TOP) / count2 });
  function squares({ parts: parts2 }, map, method) {
    const { wide, high } = cell(parts2.length);
    const paths = {};
    [...map.letters[method] ?? ""].forEach((letter, k) => {
      const [column, row] = [Math.floor(k / parts2.length), k % parts2.length];
      const [x2, y2] = [px(LEFT + column * wide), px(BOTTOM - (row + 1) * high)];
      const box2 = `M${x2} ${y2}h${px(wide)}v${px(high)}h-${px(wide)}Z`;
      paths[letter] = (paths[letter] ?? "") + box2;
    });
    return Object.entries(paths).sort();
  }
  function theory({ parts: parts2, limits }, map, method) {
    const { wide } = cell(parts2.length);
    const limit = limits[method];
    const path3 = (steps2) => steps2.map((h2, k) => [LEFT + (k + 0.5) * wide, yOf(parts2, h2)]).filter(([, y2]) => Number(y2) >= TOP && Number(y2) <= BOTTOM).map(([x2, y2], k) => `${k ? "L" : "M"}${px(Number(x2))} ${px(Number(y2))}`).join("");
    return [path3(map.lines.contact), limit ? path3(map.lines.swing.map((h2) => h2 * limit)) : ""];
  }
  function yOf(parts2, h2) {
    const [short_, long] = [1 / Number(parts2[0]), 1 / Number(parts2.at(-1))];
    const part = Math.log(h2 / short_) / Math.log(long / short_);
    const { high } = cell(parts2.length);
    return BOTTOM - high / 2 - part * (BOTTOM - TOP - high);
  }
  function ring({ parts: parts2 }, { column, row }) {
    const { wide, high } = cell(parts2.length);
    const [x2, y2] = [LEFT + column * wide, BOTTOM - (row + 1) * high];
    return { x: px(x2 - 1), y: px(y2 - 1), width: px(wide + 2), height: px(high + 2) };
  }
  function pointAt({ parts: parts2 }, x2, y2) {
    const { wide, high } = cell(parts2.length);
    const within = (k) => Math.min(parts2.length - 1, Math.max(0, Math.floor(k)));
    return { column: within((x2 - LEFT) / wide), row: within((BOTTOM - y2) / high) };
  }
  function valueText(map, value) {
    const unit = UNITS[map.path.at(-1) ?? ""];
    return unit ? `${short(value)} ${unit}` : short(value);
  }
  function found({ parts: parts2 }, map, method, { column, row }) {
    const letter = map.letters[method]?.[column * parts2.length + row] ?? "";
    return tr("{method}, {quantity} {value}, {steps} steps in 1 s: {found}.", {
      method: METHODS[method]?.label ?? method,
      quantity: map.name,
      value: valueText(map, Number(map.values[column])),
      steps: Number(parts2[row]),
      found: letter === "x" ? MADE : digitsText(Number(letter))
    });
  }
  var digitsText = (n3) => counted("1 right digit", "{n} right digits", n3);
  function sceneOf({ scene }, map, column) {
    const plain3 = structuredClone(scene);
    let place4 = plain3;
    for (const key of map.path.slice(0, -1)) place4 = place4[key];
    place4[map.path.at(-1) ?? ""] = map.values[column];
    return plain3;
  }
  function command(scene, method, parts2) {
    return `echo '${JSON.stringify(scene)}' | carts run - --method ${method} --step ${1 / parts2}`;
  }
  function ticks(map) {
    const [low, high] = [Number(map.values[0]), Number(map.values.at(-1))];
    const { wide } = cell(map.values.length);
    const grows = high / low > 100 && map.path.at(-1) !== "restitution";
    const places = grows ? [-3, -2, -1, 0, 1, 2, 3, 4, 5, 6, 7, 8].map((k) => 10 ** k) : [0.2, 0.4, 0.6, 0.8, 1];
    const part = (v2) => grows ? Math.log(v2 / low) / Math.log(high / low) : (v2 - low) / (high - low);
    return places.filter((v2) => part(v2) > -0.03 && part(v2) < 1.03).map((v2) => [
      LEFT + wide / 2 + part(v2) * (RIGHT - LEFT - wide),
      grows && (v2 >= 1e3 || v2 < 0.01) ? `10${superscript(Math.round(Math.log10(v2)))}` : short(v2)
    ]);
  }
  function unitText(map) {
    const unit = UNITS[map.path.at(-1) ?? ""];
    return unit ? tr("{label} in {unit}", { label: map.name, unit }) : map.name;
  }

  // src/cost/breaks.js
  var PARTS = ["method", "map", "value", "step", "run"];
  var BreaksFigure = class {
    constructor(root, breaks, run) {
      this.root = root;
      this.breaks = breaks;
      for (const part of PARTS) this.#part(part).disabled = false;
      this.#part("method").addEventListener("change", () => this.#draw());
      this.#part("map").addEventListener("change", () => this.#draw(true));
      this.#part("value").addEventListener("change", () => this.#tell());
      this.#part("step").addEventListener("change", () => this.#tell());
      this.#part("run").addEventListener("click", () => {
        const { point, scene, method, parts: parts2 } = this.#chosen;
        run({ scene, method, parts: parts2, told: found(this.breaks, this.#map, method, point) });
      });
      const picture2 = need(root, ".carts-breaks-picture");
      picture2.addEventListener("click", (event) => {
        const { left: left2, top, width, height } = picture2.getBoundingClientRect();
        const { clientX, clientY } = event;
        const [wide, high] = (picture2.getAttribute("viewBox") ?? "").split(" ").slice(2).map(Number);
        const x2 = (clientX - left2) / width * Number(wide);
        const { column, row } = pointAt(breaks, x2, (clientY - top) / height * Number(high));
        this.#part("value").value = String(column);
        this.#part("step").value = String(row);
        this.#tell();
      });
    }
    #part(part) {
      return need(this.root, `.carts-breaks-${part}`);
    }
    get #map() {
      return this.breaks.maps[Number(this.#part("map").value)];
    }
    get #chosen() {
      const point = {
        column: Number(this.#part("value").value),
        row: Number(this.#part("step").value)
      };
      const method = this.#part("method").value;
      const parts2 = Number(this.breaks.parts[point.row]);
      return { point, method, parts: parts2, scene: sceneOf(this.breaks, this.#map, point.column) };
    }
    #draw(values) {
      const [map, method] = [this.#map, this.#part("method").value];
      const kinds = squares(this.breaks, map, method).map(
        ([kind2, d2]) => svg("path", { class: `carts-breaks-${kind2}`, d: d2 })
      );
      need(this.root, ".carts-breaks-squares").replaceChildren(...kinds);
      const [contact, limit] = theory(this.breaks, map, method);
      put(need(this.root, ".carts-breaks-picture > .carts-breaks-contact"), "d", contact);
      put(need(this.root, ".carts-breaks-picture > .carts-breaks-limit"), "d", limit);
      if (values) {
        const texts = ticks(map).map(([x2, text]) => {
          const made4 = svg("text", { class: "carts-tick-x", x: px(x2), y: TICKS_Y });
          made4.textContent = text;
          return made4;
        });
        need(this.root, ".carts-breaks-ticks").replaceChildren(...texts);
        say(need(this.root, ".carts-breaks-unit"), unitText(map));
        const options = map.values.map((value, k) => {
          const option2 = html("option", "", valueText(map, value));
          option2.setAttribute("value", String(k));
          return option2;
        });
        this.#part("value").replaceChildren(...options);
      }
      this.#tell();
    }
    #tell() {
      const { point, method, parts: parts2, scene } = this.#chosen;
      const mark2 = need(this.root, ".carts-breaks-ring");
      for (const [name, value] of Object.entries(ring(this.breaks, point))) put(mark2, name, value);
      put(mark2, "visibility", "visible");
      say(need(this.root, ".carts-breaks-found"), found(this.breaks, this.#map, method, point));
      const line3 = need(this.root, ".carts-breaks-command");
      line3.hidden = false;
      say(line3, command(scene, method, parts2));
    }
  };

  // src/cost/measuring.js
  var ADAPTIVE = ["rk45", "adaptive"];
  var PACKAGES = ["numpy", "scipy"];
  async function measureAll(client2, root, scene, { going, rows, refused, tell: tell2 }) {
    const ask = async (what) => {
      const request = () => ({ kind: "cost", scene, ...what });
      const { header } = await client2.ask(need(root, ".carts-cost-go"), request);
      if (going() && !header.ok) throw refusal(header.problems ?? []);
      return header;
    };
    await client2.need(PACKAGES);
    const found3 = [];
    for (let row = 0, of = 1; row < of; row += 1) {
      if (!going()) return false;
      const answer = await ask({ row });
      if (!going()) return false;
      of = answer.of;
      found3.push(...answer.rows);
      rows(found3);
      if (answer.not_run) refused(answer.not_run.method, told(answer.not_run.reason));
      const progress = need(root, ".carts-cost-progress");
      progress.value = (row + 1) / of;
      say(
        need(root, ".carts-cost-say"),
        tr("{done} of {all} runs measured", { done: row + 1, all: of })
      );
    }
    const { floor, digits } = await ask({ digits: found3 });
    if (going()) tell2(floor, digits);
    return going();
  }

  // src/cost/choice.js
  var Choice = class {
    constructor(root) {
      this.root = root;
    }
    of(part) {
      return need(this.root, `.carts-cost-${part}`);
    }
    get scene() {
      return this.of("scene").value;
    }
    get adaptive() {
      return ADAPTIVE.includes(this.of("method").value);
    }
    get all() {
      const number = (part) => Number(this.of(part).value);
      return { method: this.of("method").value, rtol: number("rtol"), parts: number("step") };
    }
    asked(parts2) {
      const { method, rtol, parts: chosen } = this.all;
      this.of("step").hidden = this.adaptive;
      this.of("rtol").hidden = !this.adaptive;
      return this.adaptive ? { method, rtol } : { method, parts: parts2 ?? chosen };
    }
    follow(scene, method) {
      this.of("scene").addEventListener("change", scene);
      for (const part of ["method", "step", "rtol"]) this.of(part).addEventListener("change", method);
    }
  };

  // ../view/cost/figure.js
  var [LEFT2, TOP2, RIGHT2, BOTTOM2] = [62, 14, 506, 330];
  var FLOOR = 1e-17;
  var [LOW_X, HIGH_X] = [0.5, 1e6];
  var HIGH_Y = 10;
  function xAt(ratio) {
    const part = Math.log(Math.max(ratio, LOW_X) / LOW_X) / Math.log(HIGH_X / LOW_X);
    return LEFT2 + Math.min(1, part) * (RIGHT2 - LEFT2);
  }
  function yAt(error) {
    const seen = Math.min(HIGH_Y, Math.max(error, FLOOR));
    return BOTTOM2 - Math.log(seen / FLOOR) / Math.log(HIGH_Y / FLOOR) * (BOTTOM2 - TOP2);
  }
  function errorOf(row) {
    return row.error_v ?? (row.method === "exact" ? 0 : null);
  }
  function lineOf(rows, method, floor = 0) {
    const points = rows.filter((row) => row.method === method && errorOf(row) !== null).map((row) => [px(xAt(row.time_ratio)), px(yAt(errorOf(row) || floor))]);
    return { line: points.map(([x2, y2], k) => `${k ? "L" : "M"}${x2} ${y2}`).join(""), points };
  }
  function levelAt(floor) {
    return floor ? `M${LEFT2} ${px(yAt(floor))}H${RIGHT2}` : "";
  }
  function digitText(factor) {
    return factor ? tr("one more digit: × {factor}", { factor: short(factor, 2) }) : "";
  }

  // src/cost/figure.js
  var CostFigure = class {
    constructor(root) {
      this.root = root;
      this.ring = need(root, ".carts-cost-ring");
      this.floor = void 0;
    }
    show(rows) {
      for (const group2 of this.root.querySelectorAll("[data-method]")) {
        const method = group2.getAttribute("data-method") ?? "";
        const { line: line3, points } = lineOf(rows, method, this.floor);
        const d2 = METHODS[method]?.mark ?? "";
        group2.replaceChildren(
          svg("path", { class: "carts-cost-line", d: line3 }),
          ...points.map(
            ([x2, y2]) => svg("path", { class: "carts-cost-point", transform: `translate(${x2} ${y2})`, d: d2 })
          )
        );
      }
    }
    tell(floor, digits) {
      this.floor = floor;
      put(need(this.root, ".carts-cost-floor"), "d", levelAt(floor));
      say(need(this.root, ".carts-cost-floor-name"), floor ? tr("rounding of a double") : "");
      for (const place4 of this.root.querySelectorAll(".carts-cost-digit")) {
        say(place4, digitText(digits[place4.getAttribute("data-of") ?? ""]));
      }
    }
    mark(row) {
      const error = row ? errorOf(row) : null;
      put(this.ring, "visibility", row && error !== null ? "visible" : "hidden");
      if (!row || error === null) return;
      put(this.ring, "cx", px(xAt(row.time_ratio)));
      put(this.ring, "cy", px(yAt(error || this.floor || 0)));
    }
  };

  // ../view/cost/guess.js
  var errorText2 = (error) => `10${superscript(Math.round(Math.log10(error)))} m/s`;
  function cheapest(rows, method, error) {
    const names = method === null ? stepping() : [method];
    return rows.filter((row) => names.includes(row.method) && row.error_v !== null && row.error_v <= error).sort((a2, b2) => a2.time_ratio - b2.time_ratio)[0];
  }
  function verdict(rows, { error, bet, times: times2 }) {
    const best = cheapest(rows, null, error);
    const label = (name) => METHODS[name]?.label ?? name;
    const exact = errorText2(error);
    if (!best)
      return tr("No method that steps was measured to be right to {error}.", { error: exact });
    const first = tr("For {error}: {method}, {ratio} times as long as the exact outcome.", {
      error: exact,
      method: label(best.method),
      ratio: short(best.time_ratio, 2)
    });
    const parts2 = [
      first,
      bet && ofChoice(label(bet), bet === best.method, cheapest(rows, bet, error))
    ];
    if (Number.isFinite(times2)) parts2.push(tr("You said {ratio} times.", { ratio: short(times2) }));
    return joined(parts2);
  }
  function ofChoice(method, best, own) {
    if (best) return tr("As you said.");
    if (!own) {
      return tr("Your choice, {method}, does not get there with the steps that were measured.", {
        method
      });
    }
    return tr("Your choice, {method}: {ratio} times as long.", {
      method,
      ratio: short(own.time_ratio, 2)
    });
  }

  // src/question/marking/notation.js
  var RAISED = { "⁻": "-", "⁺": "+" };
  for (const [digit, raised] of [..."⁰¹²³⁴⁵⁶⁷⁸⁹"].entries()) RAISED[raised] = String(digit);
  var POWER_OF_TEN = /\s*[×xX*·]\s*10(?:([⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]{1,3})|\s*(?:\^|\*\*)\s*(\(?[+-]?\d{1,3}\)?))/;
  var plain2 = (text) => text.replace(/[−‐‑–]/g, "-").replace(/μ/g, "µ");
  var lowered = (text) => [...text].map((sign) => RAISED[sign] ?? sign).join("");
  function withExponent(text) {
    return plain2(text).replace(POWER_OF_TEN, (_2, raised, power2) => {
      return `e${lowered(raised ?? power2).replace(/[()]/g, "")}`;
    });
  }

  // src/shared/typed.js
  var LONGEST = 40;
  var GROUPED = /^[+-]?[1-9]\d{0,2}(,\d{3})+(?![\d,])(\.\d*)?/;
  function readTyped(typed) {
    const text = withExponent(tidy(typed));
    if (!text) return { problem: tr("Type a number, for example 0.5") };
    if (text.length > LONGEST) return { problem: tr("That is too long for a number.") };
    const grouped = twoReadings(text);
    if (grouped) return { problem: grouped };
    if (/^[+-]?(\d+([.,]\d*)?|[.,]\d+)(e[+-]?\d+)?$/i.test(text)) {
      const value = Number(text.replace(",", "."));
      return Number.isFinite(value) ? { value } : { problem: tr("{text} is too large.", { text }) };
    }
    if (/^[+-]?[\d.,]+(e[+-]?\d+)?\s*[a-zA-Zµ°%][a-zA-Zµ°%⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺^/·⋅*(). \d-]*$/.test(text)) {
      return { text: text.replace(/(\d),(\d)/, "$1.$2") };
    }
    return { problem: noNumber(text) };
  }
  var noNumber = (text) => tr("“{text}” is not a number. Type for example 0.5", { text });
  function outside({ label, unit }, low, high) {
    const range = tr("{low} to {high}", { low, high });
    return tr("{label}: {range}, please.", { label, range: `${range} ${unit}`.trim() });
  }
  var withoutNewtons = (typed) => typed.replace(/\s*N\s*$/i, "");
  var APART = /^([+\-−–]?[1-9]\d{0,2})((?:[ \u00a0\u2009\u202f]\d{3})+)(?!\d)/;
  function tidy(typed) {
    const narrow = (sign) => String.fromCharCode(sign.charCodeAt(0) - 65248);
    return typed.trim().replace(/[０-９．，＋－]/g, narrow).replace(/^([+\-−–])\s+(?=[\d.,])/, "$1").replace(APART, (whole) => whole.replace(/\s/g, ""));
  }
  function twoReadings(typed) {
    const text = GROUPED.exec(typed)?.[0];
    if (!text) return "";
    const whole = text.replaceAll(",", "");
    if (/[,.].*[,.]/.test(text)) return tr("Type {number} without commas.", { number: whole });
    const decimal = String(Number(text.replace(",", ".")));
    return tr("{text} can mean {decimal} or {whole}: type {decimal} or {whole}", {
      text,
      decimal,
      whole
    });
  }

  // src/shared/number-box.js
  function numberIn({ value }) {
    const read = readTyped(value);
    return "value" in read ? read.value : null;
  }
  function problemIn({ value }) {
    const read = readTyped(value);
    if ("text" in read) return noNumber(read.text);
    return "problem" in read ? read.problem : "";
  }
  var ifTyped = (box2) => box2.value.trim() ? problemIn(box2) : "";
  function complain(box2, problem) {
    const place4 = box2.closest("label, [data-hand]") ?? box2.parentElement;
    const told4 = place4.querySelector(".carts-error") ?? html("span", "carts-error");
    if (!problem) return told4.remove();
    told4.setAttribute("role", "alert");
    place4.append(told4);
    say(told4, problem);
  }

  // src/cost/guess.js
  function guessFirst(root, rows) {
    const [form2, known2] = [need(root, ".carts-cost-guess"), need(root, ".carts-cost-known")];
    const error = need(root, ".carts-cost-error");
    const bet = need(root, ".carts-cost-bet");
    const times2 = need(root, ".carts-cost-times");
    const [told4, line3] = [need(root, ".carts-cost-verdict"), need(root, ".carts-cost-asked")];
    const skip = need(root, ".carts-cost-skip");
    form2.hidden = false;
    known2.hidden = true;
    const open2 = () => {
      known2.hidden = false;
      skip.hidden = true;
    };
    skip.addEventListener("click", () => {
      open2();
      need(root, ".carts-cost-show").focus();
    });
    need(root, ".carts-cost-show").addEventListener("click", () => {
      if (known2.hidden && !bet.value) {
        say(told4, tr("Choose a method first: a wrong guess is worth more than none."));
        return bet.focus();
      }
      const problem = ifTyped(times2);
      complain(times2, problem);
      if (problem) return times2.focus();
      open2();
      const asked4 = Number(error.value);
      const said = { error: asked4, bet: bet.value, times: numberIn(times2) ?? Number.NaN };
      say(told4, verdict(rows(), said));
      put(line3, "d", `M${LEFT2} ${px(yAt(asked4))}H${RIGHT2}`);
    });
    return () => {
      say(told4, "");
      put(line3, "d", "");
    };
  }

  // ../view/scales.js
  var STEP_SLACK = 1e-9;
  var HEADROOM = 0.05;
  var NOUGHT = 1e-12;
  function axisDecimals(axis2) {
    return Math.max(0, -exponent(axis2.step));
  }
  function ticks2(axis2) {
    const first = Math.ceil(axis2.low / axis2.step - STEP_SLACK);
    const last = Math.floor(axis2.high / axis2.step + STEP_SLACK);
    const found3 = [];
    for (let k = first; k <= last; k += 1) found3.push(k * axis2.step);
    return found3;
  }
  function niceAbove(value) {
    const power2 = Number(`1e${exponent(value)}`);
    for (const factor of [1, 2, 5]) {
      if (value <= factor * power2 * (1 + STEP_SLACK)) return factor * power2;
    }
    return 10 * power2;
  }
  function axis(low, high, count2) {
    const bottom = low < -NOUGHT ? low : 0;
    const above = high > NOUGHT ? high : 0;
    const top = above === bottom ? 1 : above;
    const room = HEADROOM * (top - bottom);
    return { low: bottom - room, high: top + room, step: niceAbove((top - bottom) / count2) };
  }
  function span(low, high, count2) {
    return { low, high, step: niceAbove((high - low) / count2) };
  }

  // src/cost/stage.js
  var [WIDTH, FLOOR_Y, SIDE] = [640, 84, 20];
  var [LOWEST, TALLEST] = [16, 58];
  var ENERGY = { left: 60, top: 10, right: 388, bottom: 160 };
  var MOST = 3;
  function measureOf(exact) {
    const [start, most] = [Number(exact[0]), Math.max(...exact)];
    return inParts(start, most) ? { whole: start, unit: "%", ticked: 100 } : { whole: most || 1, unit: "J", ticked: most || 1 };
  }
  var CostStage = class {
    constructor(root) {
      this.stage = need(root, ".carts-cost-stage");
      this.energy = need(root, ".carts-cost-energy");
      this.carts = [];
      this.ghosts = [];
      this.cursor = null;
    }
    show(header, numbers) {
      this.header = header;
      const { rows, bodies } = header;
      const column = (k) => Array.from({ length: rows }, (_2, row) => Number(numbers[k * rows + row]));
      this.t = column(0);
      const count2 = bodies.length;
      this.x = bodies.map((_2, k) => column(1 + k));
      this.exact = bodies.map((_2, k) => column(1 + count2 + k));
      this.#lay();
      this.#plot(column(1 + 2 * count2), column(2 + 2 * count2));
      this.at(0);
    }
    #lay() {
      const { bodies, track } = this.header;
      const paths = this.exact ?? [];
      const ends = bodies.flatMap(({ length }, k) => {
        const all = paths[k] ?? [0];
        return [Math.min(...all) - length, Math.max(...all) + length];
      });
      const left2 = track.left === "wall" ? 0 : Math.min(...ends);
      const right = track.right === "wall" ? Number(track.length) : Math.max(...ends);
      this.scale = (WIDTH - 2 * SIDE) / (right - left2);
      this.left = left2;
      const heaviest = Math.max(...bodies.map(({ mass }) => mass));
      const shape = (k, name) => {
        const { mass, length } = bodies[k];
        const height = LOWEST + (TALLEST - LOWEST) * mass / heaviest;
        const width = length * Number(this.scale);
        const box2 = {
          x: px(-width / 2),
          y: px(FLOOR_Y - height),
          width: px(width),
          height: px(height)
        };
        return svg("rect", { class: name, rx: 3, ...box2 });
      };
      const group2 = (k) => {
        const made4 = svg("g", { class: `carts-b${k % 8}` });
        const name = svg("text", { class: "carts-name", y: FLOOR_Y + 16, "text-anchor": "middle" });
        name.textContent = bodies[k]?.name ?? "";
        made4.append(shape(k, "carts-box"), name);
        return made4;
      };
      this.carts = bodies.map((_2, k) => group2(k));
      this.ghosts = bodies.map((_2, k) => shape(k, `carts-cost-ghost carts-b${k % 8}`));
      const floor = svg("path", { class: "carts-rule", d: `M0 ${FLOOR_Y}H${WIDTH}` });
      const walls = [];
      if (track.left === "wall") walls.push(this.#place(0));
      if (track.right === "wall") walls.push(this.#place(Number(track.length)));
      this.stage.replaceChildren(
        floor,
        ...walls.map((x2) => svg("path", { class: "carts-wall-face", d: `M${px(x2)} 14V${FLOOR_Y}` })),
        ...this.carts,
        ...this.ghosts
      );
    }
    #place(x2) {
      return SIDE + (x2 - Number(this.left)) * Number(this.scale);
    }
    #plot(stepped, exact) {
      const { until } = this.header;
      const { whole, unit, ticked } = measureOf(exact);
      const { left: left2, top, right, bottom } = ENERGY;
      const finite = stepped.map((value) => Number.isFinite(value) ? value / whole : MOST);
      const high = Math.min(MOST, Math.max(1, ...finite, ...exact.map((value) => value / whole)));
      const scale = axis(0, ticked * high, 4);
      const y2 = (part) => bottom - ticked * Math.min(part, high) / scale.high * (bottom - top);
      const x2 = (t3) => left2 + t3 / until * (right - left2);
      const path3 = (values) => values.map((value, k) => `${k ? "L" : "M"}${px(x2(Number(this.t?.[k])))} ${px(y2(value))}`).join("");
      const parts2 = ticks2(scale).filter((tick) => tick >= 0).flatMap((tick) => {
        const label = svg("text", {
          class: "carts-tick-y",
          x: left2 - 6,
          y: px(y2(tick / ticked) + 4)
        });
        label.textContent = `${short(tick)} ${unit}`;
        return [
          svg("path", { class: "carts-grid", d: `M${left2} ${px(y2(tick / ticked))}H${right}` }),
          label
        ];
      });
      const last = svg("text", { class: "carts-tick-x", x: right, y: bottom + 20 });
      last.textContent = `${short(until)} s`;
      const first = svg("text", { class: "carts-tick-x", x: left2, y: bottom + 20 });
      first.textContent = "0";
      this.cursor = svg("path", { class: "carts-cost-cursor" });
      this.energy.replaceChildren(
        ...parts2,
        first,
        last,
        svg("path", {
          class: "carts-cost-line carts-cost-true",
          d: path3(exact.map((e2) => e2 / whole))
        }),
        svg("path", { class: "carts-cost-line carts-cost-made", d: path3(finite) }),
        this.cursor
      );
    }
    at(time) {
      const times2 = this.t ?? [];
      let k = times2.findLastIndex((t3) => t3 <= time);
      k = Math.min(Math.max(k, 0), Math.max(0, times2.length - 2));
      const [a2, b2] = [Number(times2[k]), Number(times2[k + 1])];
      const part = b2 > a2 ? Math.min(1, (time - a2) / (b2 - a2)) : 0;
      const between2 = (xs) => {
        const here = Number(xs?.[k]);
        const x3 = this.#place(here + part * (Number(xs?.[k + 1] ?? here) - here));
        return Number.isFinite(x3) ? Math.min(5e3, Math.max(-5e3, x3)) : 5e3;
      };
      for (const [cart, shape] of this.carts.entries()) {
        put(shape, "transform", `translate(${px(between2(this.x?.[cart]), 2)} 0)`);
      }
      for (const [cart, shape] of this.ghosts.entries()) {
        put(shape, "transform", `translate(${px(between2(this.exact?.[cart]), 2)} 0)`);
      }
      const { left: left2, top, right, bottom } = ENERGY;
      const x2 = left2 + time / Number(this.header?.until ?? 1) * (right - left2);
      if (this.cursor) put(this.cursor, "d", `M${px(x2)} ${top}V${bottom}`);
    }
  };

  // src/cost/table.js
  function fill(table, lines4) {
    const body2 = lines4.map(([head = "", ...values]) => {
      const line3 = html("tr");
      const first = html("th", "", head);
      first.setAttribute("scope", "row");
      line3.append(first, ...values.map((value) => html("td", "", value)));
      return line3;
    });
    table.querySelector("tbody")?.replaceChildren(...body2);
  }

  // src/cost/words.js
  var POINT_RUNS = tr("The point of the map is being run …");
  var LOADING = tr("Python’s scipy is being loaded …");
  var LOADING_BOTH = tr("Python’s numpy and scipy are being loaded …");
  var [PLAY, PAUSE] = [tr("Play"), tr("Pause")];
  var fromMap = (point) => tr("From the map below: {point} Change anything here to go back.", { point });
  var stoppedWords = (n3) => tr("Stopped after {n} rows.", { n: n3 });
  function doneWords(refused) {
    const just = tr("Measured just now, by Python in this browser.");
    const left2 = [...refused].map(
      ([method, reason]) => tr("{method}: {reason}.", { method, reason })
    );
    return joined([just, ...left2]);
  }
  var measuredWords = (when) => when ? tr("Measured {when}.", { when }) : tr("Not measured yet.");
  var keptWords = (reason) => tr("{reason} What was prepared stays as it is.", { reason });

  // src/cost/element.js
  function costElement(client2) {
    return class CartsCost extends HTMLElement {
      #facts = null;
      rows = [];
      run = null;
      complete = Promise.resolve();
      choice = new Choice(this);
      #generation = 0;
      #measuring = 0;
      #forgetGuess = () => {
      };
      #fresh = 0;
      // rows of the newest measurement
      #stage = null;
      #figure = null;
      #player = null;
      connectedCallback() {
        if (this.#facts) return;
        const facts = JSON.parse(need(this, ".carts-cost-baked").textContent ?? "");
        this.#facts = facts;
        this.#stage = new CostStage(this);
        this.#figure = new CostFigure(this);
        this.#player = new Player(() => this.#frame());
        for (const part of ["scene", "method", "step", "rtol", "play", "scrub", "go"]) {
          need(this, `.carts-cost-${part}`).disabled = false;
        }
        const known2 = facts.measured[this.choice.scene];
        this.rows = known2?.rows ?? [];
        this.#figure.floor = known2?.floor;
        this.#show(facts.run);
        this.#mark();
        this.#forgetGuess = guessFirst(this, () => this.rows);
        if (facts.breaks) {
          new BreaksFigure(this, facts.breaks, (point) => {
            this.scrollIntoView();
            void this.compute(point);
          });
        }
        this.choice.follow(
          () => this.#newScene(),
          () => void this.compute()
        );
        need(this, ".carts-cost-play").addEventListener("click", () => this.#player?.toggle());
        const scrub = need(this, ".carts-cost-scrub");
        scrub.addEventListener("input", () => {
          this.#player?.pause();
          this.#player?.seek(scrub.valueAsNumber);
        });
        need(this, ".carts-cost-go").addEventListener("click", () => void this.measure());
        need(this, ".carts-cost-stop").addEventListener("click", () => this.stop());
      }
      disconnectedCallback() {
        this.#player?.pause();
        this.stop();
      }
      get #scene() {
        return this.#facts?.scenes[this.choice.scene];
      }
      get #until() {
        return Number(this.#facts?.untils[this.choice.scene]);
      }
      async compute(point) {
        this.#generation += 1;
        const generation = this.#generation;
        if (point) {
          this.choice.of("method").value = point.method;
          this.#note(POINT_RUNS);
        }
        const asked4 = this.choice.asked(point?.parts);
        try {
          if (this.choice.adaptive) {
            this.#note(LOADING);
            await client2.need(PACKAGES);
            if (generation !== this.#generation) return;
          }
          const scene = point?.scene ?? this.#scene;
          const message = { kind: "cost", scene, ...asked4 };
          const { header, numbers } = await client2.ask(this, () => message);
          if (generation !== this.#generation) return;
          if (!header.ok) throw refusal(header.problems ?? []);
          this.#live();
          this.#note(point ? fromMap(point.told) : "");
          this.#show({ header, numbers });
          if (!point) this.#mark();
          this.dispatchEvent(new CustomEvent("carts-update", { bubbles: true }));
        } catch (error) {
          if (generation === this.#generation) this.#fail(error);
        }
      }
      measure() {
        this.complete = this.#measure();
        return this.complete;
      }
      stop() {
        if (!this.#measuring) return;
        this.#measuring = 0;
        showWorking(this, "cost", false);
        say(need(this, ".carts-cost-say"), stoppedWords(this.#fresh));
      }
      async #measure() {
        const turn = Math.random() + 1;
        this.#measuring = turn;
        this.#fresh = 0;
        showWorking(this, "cost", true);
        say(need(this, ".carts-cost-say"), LOADING_BOTH);
        const refused = /* @__PURE__ */ new Map();
        try {
          const done = await measureAll(client2, this, this.#scene, {
            going: () => this.#measuring === turn,
            rows: (rows) => {
              this.#live();
              this.#rows(rows);
              this.#fresh = rows.length;
            },
            refused: (method, reason) => refused.set(method, reason),
            tell: (floor, digits) => this.#figure?.tell(floor, digits)
          });
          if (!done) return;
          this.#measuring = 0;
          say(need(this, ".carts-cost-say"), doneWords(refused));
        } catch (error) {
          this.#measuring = 0;
          this.#fail(error);
          say(need(this, ".carts-cost-say"), "");
        } finally {
          if (this.#measuring === 0 || this.#measuring === turn) showWorking(this, "cost", false);
        }
      }
      #newScene() {
        this.stop();
        this.#forgetGuess();
        const known2 = this.#facts?.measured[this.choice.scene];
        this.#figure?.tell(known2?.floor, known2?.digits ?? {});
        this.#rows(known2?.rows ?? []);
        say(need(this, ".carts-cost-say"), measuredWords(known2?.measured));
        void this.compute();
      }
      #rows(rows) {
        this.rows = [...rows];
        this.#figure?.show(rows);
        this.#mark();
        const lines4 = rows.map((row) => cells(row, this.#until));
        fill(need(this, ".carts-cost-table table"), lines4);
      }
      #mark() {
        this.#figure?.mark(rowOf(this.rows, this.#until, this.choice.all));
      }
      #show(run) {
        this.run = run;
        this.#stage?.show(run.header, run.numbers);
        fill(need(this, ".carts-cost-told"), told2(run.header));
        need(this, ".carts-cost-scrub").max = String(
          run.header.until
        );
        if (!this.#player) return;
        this.#player.until = run.header.until;
        this.#player.speed = run.header.until / 4;
        this.#player.seek(this.#player.playing ? this.#player.time : run.header.until);
      }
      #frame() {
        const player = this.#player;
        this.#stage?.at(player.time);
        this.classList.toggle("carts-is-playing", player.playing);
        say(need(this, ".carts-cost-play"), player.playing ? PAUSE : PLAY);
        need(this, ".carts-cost-scrub").valueAsNumber = player.time;
        say(need(this, ".carts-cost-clock"), `${fixed(player.time, 2)} s`);
      }
      #live() {
        this.dataset.state = "live";
        need(this, ".carts-mark").setAttribute("aria-label", LIVE);
      }
      #fail(error) {
        this.dataset.reason = error.reason ?? "failed";
        this.#note(keptWords(error.message));
      }
      #note(message) {
        const note2 = need(this, ".carts-note");
        say(note2, message);
        note2.hidden = !message;
      }
    };
  }

  // ../view/hard/words.js
  var VERDICTS = {
    right: tr("right"),
    "blows-up": tr("blows up"),
    "passes-through": tr("carts pass through each other"),
    misses: tr("misses contacts"),
    "makes-energy": tr("makes energy from nothing"),
    "loses-energy": tr("loses energy"),
    sticks: tr("carts stick together"),
    wrong: tr("wrong")
  };
  var UNITS2 = { v: " m/s", x: " m", last: " s", count: "" };
  var NAMES = {
    warmed: tr("warmed the bumpers"),
    count: tr("contacts"),
    last: tr("last contact")
  };
  var LOADING2 = tr("Python’s numpy and scipy are being loaded …");
  var progressWords = (done, of) => tr("{done} of {all}", { done, all: of });
  var stoppedWords2 = (n3) => tr("Stopped after {n} cases; the others are as prepared.", { n: n3 });
  var doneWords2 = (good, of, seconds) => tr(
    "{good} of {all} came out as they must, just now in this browser; exact runs took {seconds} s in all.",
    { good, all: of, seconds: short(seconds, 2) }
  );
  var COPY = tr("Copy");
  var COPIED = tr("Copied");
  var keptWords2 = (reason) => tr("{reason} What was prepared stays as it is.", { reason });
  function measure(what) {
    const { kind: kind2, name } = parts(what);
    if (kind2 === "v" || kind2 === "x") {
      const [last, first] = name.split("-");
      const of = (cart = "") => tr("{letter} of {cart}", { letter: kind2, cart });
      return first ? `${of(last)} − ${of(first)}` : of(name);
    }
    return NAMES[kind2] ?? (kind2 === "work" ? tr("work of {name}", { name }) : kind2);
  }
  function parts(what) {
    const [kind2 = "", ...rest] = what.split(".");
    return { kind: kind2, name: rest.join(".") };
  }
  function amount(what, value, figures2) {
    const { kind: kind2 } = parts(what);
    if (kind2 === "count") return String(Math.round(value));
    return (short(value, figures2) + (UNITS2[kind2] ?? " J")).replaceAll(" ", " ");
  }
  function cameOut(wanted2, got, figures2) {
    let worst = "";
    let [error, came] = [0, 0];
    for (const [k, [what, right]] of wanted2.entries()) {
      const value = got[k];
      if (value === null || value === void 0) return "";
      const distance = Math.abs(value - right);
      if (!worst || distance > error) [worst, error, came] = [what, distance, value];
    }
    const off = error ? tr("off by {amount}", { amount: amount(worst, error, 2) }) : tr("no error");
    return tr("{quantity}: {amount}, {off}", {
      quantity: measure(worst),
      amount: amount(worst, came, figures2),
      off
    });
  }
  function exactCell(wanted2, { got }) {
    return cameOut(wanted2, got, 6);
  }
  function steppedCell(wanted2, { verdict: verdict2, got }) {
    return [VERDICTS[verdict2] ?? verdict2, verdict2 === "blows-up" ? "" : cameOut(wanted2, got, 3)];
  }
  var METHODS2 = { euler: "Euler", "semi-implicit": tr("semi-implicit Euler"), rk4: "RK4" };

  // src/hard/element.js
  function hardElement(client2) {
    return class CartsHard extends HTMLElement {
      #cases = null;
      answers = {};
      complete = Promise.resolve();
      #turn = 0;
      connectedCallback() {
        if (this.#cases) return;
        this.#cases = JSON.parse(need(this, ".carts-hard-baked").textContent ?? "");
        const go = need(this, ".carts-hard-go");
        go.disabled = false;
        go.addEventListener("click", () => {
          this.complete = this.#run();
        });
        need(this, ".carts-hard-stop").addEventListener("click", () => this.stop());
        for (const block of this.querySelectorAll("pre")) offerCopy(block);
      }
      disconnectedCallback() {
        this.stop();
      }
      stop() {
        if (!this.#turn) return;
        this.#turn = 0;
        this.#working(false);
        this.#say(stoppedWords2(Object.keys(this.answers).length));
      }
      async #run() {
        const turn = Math.random() + 1;
        this.#turn = turn;
        this.answers = {};
        this.#working(true);
        const all = Object.entries(this.#cases ?? {});
        all.sort(([, a2], [, b2]) => a2.packages.length - b2.packages.length);
        let [good, seconds] = [0, 0];
        try {
          for (const [k, [name, one]] of all.entries()) {
            if (one.packages.length) {
              this.#say(LOADING2);
              await client2.need(one.packages);
            }
            if (this.#turn !== turn) return;
            const message = { kind: "hard", ...asked(one) };
            const { header } = await client2.ask(this, () => message);
            if (this.#turn !== turn) return;
            if (!header.ok) throw refusal(header.problems ?? []);
            this.#live();
            const answer = header;
            this.answers[name] = answer;
            this.#show(name, one, answer);
            seconds += answer.exact.seconds;
            good += isGood(one, answer.exact.got) ? 1 : 0;
            const bar2 = need(this, ".carts-hard-progress");
            bar2.value = k + 1;
            this.#say(progressWords(k + 1, all.length));
          }
          this.#say(doneWords2(good, all.length, seconds));
        } catch (error) {
          if (this.#turn === turn) this.#fail(error);
        } finally {
          if (this.#turn === turn) this.#working(false);
          if (this.#turn === turn) this.#turn = 0;
        }
      }
      #show(name, one, answer) {
        const row = need(this, `[data-case="${name}"]`);
        say(need(row, '[data-part="exact"]'), exactCell(one.expected, answer.exact));
        for (const [k, cell3] of [...row.querySelectorAll('[data-part="stepped"]')].entries()) {
          const stepped = answer.stepped[k];
          if (!stepped) continue;
          const [verdict2, distance] = steppedCell(one.expected, stepped);
          cell3.setAttribute("data-verdict", stepped.verdict);
          say(need(cell3, "b"), verdict2);
          say(need(cell3, "span"), distance);
        }
        row.classList.add("carts-hard-fresh");
      }
      #working(on) {
        showWorking(this, "hard", on);
        if (!on) return;
        need(this, ".carts-note").hidden = true;
        for (const row of this.querySelectorAll(".carts-hard-fresh"))
          row.classList.remove("carts-hard-fresh");
      }
      #live() {
        this.dataset.state = "live";
        need(this, ".carts-mark").setAttribute("aria-label", LIVE);
      }
      #fail(error) {
        this.dataset.reason = error.reason ?? "failed";
        const note2 = need(this, ".carts-note");
        say(note2, keptWords2(error.message));
        note2.hidden = false;
        this.#say("");
      }
      #say(text) {
        say(need(this, ".carts-hard-say"), text);
      }
    };
  }
  function asked({ scene, expected, events }) {
    return { scene, expected, events };
  }
  function isGood({ expected, within }, got) {
    return expected.every(([, right], k) => {
      return Math.abs(Number(got[k] ?? Number.NaN) - right) <= Number(within[k]);
    });
  }
  function offerCopy(block) {
    const button = html("button", "carts-sign carts-hard-copy", COPY);
    button.setAttribute("type", "button");
    button.addEventListener("click", async () => {
      const selection = getSelection();
      selection?.selectAllChildren(block);
      const copied = await navigator.clipboard?.writeText(block.textContent ?? "").then(
        () => true,
        () => false
      );
      if (copied) say(button, COPIED);
    });
    block.before(button);
  }

  // ../view/map/words.js
  var SMALLER = 2;
  var EXACT = 12;
  function valueText2(value, { low, high }) {
    if (Number.isNaN(value)) return tr("no value");
    const most = decimalsFor(Math.max(Math.abs(low), Math.abs(high)) || 1) + SMALLER;
    const text = fixed(value, Math.min(decimalsFor(value || 1), most));
    return /[1-9]/.test(text) ? text : fixed(0, most - SMALLER);
  }
  function shown(value, { per }) {
    return Number((value / per).toPrecision(EXACT));
  }
  function axisDecimals2(axis2) {
    const [first = 0, second = 0] = axis2.values.map((value) => shown(value, axis2));
    return Math.max(decimalsOf(first), decimalsOf(second - first, 3));
  }

  // src/shared/enter.js
  var isEnter = ({ key, isComposing, keyCode }) => key === "Enter" && !isComposing && keyCode !== 229;
  function onEnter(box2, act) {
    box2?.addEventListener("keydown", (event) => isEnter(event) && !event.repeat && act());
  }

  // ../view/bodies.js
  var THINGS = {
    foam: () => ({ body: tr("the foam"), brief: tr("foam") }),
    spring: () => ({ body: tr("the spring"), brief: tr("spring") }),
    board: () => ({ body: tr("the board"), brief: tr("board") })
  };
  function isWall(name) {
    return name === "left" || name === "right";
  }
  function whatIs(name, { left_is = "wall", right_is = "wall" }) {
    return name === "left" ? left_is : right_is;
  }
  function body(name, track) {
    if (!isWall(name)) return name;
    const thing = thingAt(name, track, "body");
    if (thing) return thing;
    if (!hasTwoWalls(track)) return tr("the wall");
    return name === "left" ? tr("the left wall") : tr("the right wall");
  }
  function brief(name, track) {
    if (!isWall(name)) return name;
    const thing = thingAt(name, track, "brief");
    if (thing) return thing;
    if (!hasTwoWalls(track)) return tr("wall");
    return name === "left" ? tr("left wall") : tr("right wall");
  }
  function hasTwoWalls(track) {
    return ["left", "right"].every(
      (side) => track[side] === "wall" && whatIs(side, track) === "wall"
    );
  }
  function isWord(name) {
    return name.length > 2;
  }
  function kind(name, track) {
    return THINGS[whatIs(name, track)]?.().brief ?? tr("wall");
  }
  function thingAt(name, track, form2) {
    const thing = THINGS[whatIs(name, track)]?.()[form2];
    if (!thing || whatIs("left", track) !== whatIs("right", track)) return thing ?? "";
    return name === "left" ? tr("{thing} on the left", { thing }) : tr("{thing} on the right", { thing });
  }
  function forceOn(on, by) {
    return tr("force on {on} by {by}", { on, by });
  }
  function listed(names) {
    const [first = "", second] = names;
    if (second === void 0) return first;
    const rest = inRow(names.slice(0, -1));
    return tr("{first} and {last}", { first: rest, last: String(names.at(-1)) });
  }
  function onBy(on, by, track) {
    return tr("on {on} by {by}", { on: body(on, track), by: body(by, track) });
  }
  function dashed(names, track) {
    return names.map((name) => brief(name, track)).join("–");
  }
  function bodiesOf(names, track) {
    return listed(names.map((name) => body(name, track)));
  }

  // ../effects/drag/view.js
  var view_default = {
    name: tr("air resistance"),
    row: 4,
    side: () => "above",
    agent: () => tr("the air"),
    around: tr("air"),
    warms: () => tr("air"),
    phrase({ numbers: { linear, quadratic } }, { everyone, on, seen }) {
      const sizes = [
        linear ? tr("{size} N per {unit}", { size: short(linear), unit: "m/s" }) : "",
        quadratic ? tr("{size} N per {unit}", { size: short(quadratic), unit: "(m/s)²" }) : ""
      ].filter(Boolean);
      return [
        everyone ? tr("drag by the air") : tr("drag on {carts} by the air", { carts: on }),
        seen(listed(sizes) || "0 N")
      ];
    }
  };

  // ../effects/friction/view.js
  var TOOTH = 4;
  var view_default2 = {
    name: tr("friction"),
    row: 3,
    side: () => "below",
    agent: () => tr("the track"),
    around: tr("track"),
    earth: true,
    warms: () => tr("track"),
    phrase({ numbers: { coefficient = 0, static: held = coefficient } }, { everyone, on, seen }) {
      const size = `μ = ${short(coefficient)}`;
      const rest = tr("(at rest up to {coefficient})", { coefficient: short(held) });
      return [
        everyone ? tr("friction by the track") : tr("friction on {carts} by the track", { carts: on }),
        seen(held > coefficient ? `${size} ${rest}` : size)
      ];
    },
    pieces: rough
  };
  function rough({ carts }, { key, header: { bodies, track }, layout, face: face2, centre }) {
    const piece = { cls: "carts-rough", behind: true };
    if (carts.length < bodies.length) {
      return carts.map((name) => {
        const length = (bodies.find((body2) => body2.name === name)?.length ?? 0) * layout.scale;
        const d3 = teeth(centre(name) - length / 2, length, layout.track);
        return { ...piece, key: `${key} ${name}`, d: d3 };
      });
    }
    const start = track.left === "wall" ? face2("left", "right") : -layout.width;
    const end2 = track.right === "wall" ? face2("right", "left") : 2 * layout.width;
    const tooth = 2 * TOOTH;
    const first = Math.max(start, -tooth + (start % tooth + tooth) % tooth);
    const d2 = teeth(first, Math.min(end2, layout.width) - first, layout.track);
    return [{ ...piece, key, d: d2 }];
  }
  function teeth(x2, length, y2) {
    const count2 = Math.max(0, Math.floor(length / (2 * TOOTH)));
    return `M${px(x2)} ${px(y2)}${`l${px(TOOTH)} ${px(TOOTH)}l${px(TOOTH)} ${px(-TOOTH)}`.repeat(count2)}`;
  }

  // ../effects/incline/view.js
  var STEEPEST = 22;
  var ROW = 24;
  var LENGTH = { wide: 120, narrow: 90 };
  var view_default3 = {
    name: tr("a slope"),
    row: 1,
    agent: () => tr("the Earth"),
    earth: true,
    stored: tr("as height, above the lowest point"),
    slope: ({ numbers }) => numbers.angle ?? 0,
    forceName: (on, by) => tr("part of the weight of {on}, along the track: force on {on} by {by}", { on, by }),
    label: (told4) => tr("on {on} by {by} (slope): {size} N", told4),
    phrase: ({ numbers }, { everyone, on }) => [
      everyone ? tr("a slope") : tr("a slope on {carts}", { carts: on }),
      slopeText(numbers.angle ?? 0)
    ],
    pieces({ index, carts, numbers: { angle = 0 } }, { key, header, layout }) {
      const slope = Math.abs(Math.tan(angle));
      const longest = LENGTH[layout.kind] ?? 0;
      const length = slope ? Math.min(longest, STEEPEST / slope) : longest;
      const inclines = header.effects.filter(({ kind: kind2 }) => kind2 === "incline");
      const place4 = inclines.findIndex((one) => one.index === index);
      const [x2, y2, rise] = [12, layout.tilt + ROW * Math.max(0, place4), length * slope];
      const whose = carts.length < header.bodies.length ? `${listed(carts)}: ` : "";
      const [tall, flat] = angle > 0 ? [x2, x2 + length] : [x2 + length, x2];
      const d2 = `M${px(tall)} ${px(y2)}V${px(y2 - rise)}L${px(flat)} ${px(y2)}Z`;
      const words = {
        text: whose + tiltText(angle),
        x: px(x2 + length + 10),
        y: px(y2),
        anchor: "start"
      };
      return [
        { key, cls: "carts-wedge", behind: true, d: d2 },
        { key: `${key} words`, cls: "carts-tilt", behind: true, ...words }
      ];
    }
  };
  function tiltText(angle) {
    if (!angle) return tr("the track is level: 0°");
    const words = tr("track tilted {slope}", { slope: slopeText(angle) });
    return angle > 0 ? `${words} →` : `← ${words}`;
  }
  function slopeText(angle) {
    const size = short(Math.abs(angle) * 180 / Math.PI);
    if (size === "0") return tr("0°: the track is level");
    return angle > 0 ? tr("{angle}° down to the right", { angle: size }) : tr("{angle}° down to the left", { angle: size });
  }

  // ../effects/magnets/view.js
  var POLE = 14;
  var POLES = [
    ["N", "carts-north"],
    ["S", "carts-south"]
    // only where there is room
  ];
  var view_default4 = {
    name: tr("magnets"),
    link: tr("magnets"),
    apart: true,
    stored: tr("between the magnets"),
    phrase: (_2, { both: both2 }) => [tr("magnets on {bodies}, like poles facing", { bodies: both2 })],
    pieces({ between: between2 }, { key, layout, face: face2 }) {
      const [a2, b2] = between2 ?? ["", ""];
      return [
        ...poles(`${key} ${a2}`, face2(a2, "right"), -1, layout),
        ...poles(`${key} ${b2}`, face2(b2, "left"), 1, layout)
      ];
    }
  };
  function poles(key, x2, direction, { kind: kind2, track }) {
    const top = track - 40;
    return POLES.slice(0, kind2 === "wide" ? 2 : 1).flatMap(([pole = "", cls = ""], k) => {
      const start = x2 + direction * k * POLE;
      const d2 = `M${px(start)} ${px(top)}h${px(direction * POLE)}v16h${px(-direction * POLE)}Z`;
      const letter = { text: pole, x: px(start + direction * POLE / 2), y: px(top + 13) };
      return [
        { key: `${key} ${pole}`, cls, d: d2 },
        { key: `${key} ${pole} letter`, cls: "carts-pole", anchor: "middle", ...letter }
      ];
    });
  }

  // ../view/shapes.js
  var REFERENCE_HEIGHT = 38;
  var TALLEST2 = 4;
  var LANE = 21;
  var ABOVE = 33;
  var DOT = 2.5;
  var RING = 1;
  var SHORTEST = 0.5;
  var LONGEST2 = 1.15;
  var FASTEST = 2.2;
  var EDGE = 5;
  var TORN = 6;
  var LINE = 14;
  var NAMED = 34;
  var LETTER = 9.5;
  var SPRING = [2, 10];
  var PUSH = 15.5;
  var FACE = 22;
  var WHEEL = 5.5;
  var LIFT = -3;
  var TURNS = 9;
  var LEAD = 5;
  var COIL = 7;
  function box(body2, view, layout, i2, skin) {
    const lift = layout.stagger * (i2 % layout.ranks);
    const width = bodyWidth(body2);
    const wanted2 = REFERENCE_HEIGHT * (view.alike ? 1 : body2.mass / width / view.perHeight);
    const cut = wanted2 > TALLEST2 * REFERENCE_HEIGHT * (1 + 1e-9);
    const height = Math.min(wanted2, TALLEST2 * REFERENCE_HEIGHT);
    const word = isWord(body2.name) ? body2.name.length * LETTER : 0;
    const named3 = height >= NAMED && (!word || !skin && word < width * layout.scale);
    const mass = `${short(body2.mass)} kg`;
    return {
      x: -width * layout.scale / 2,
      width: width * layout.scale,
      height,
      cut,
      nameY: named3 ? -(height + FACE) / 2 + 5 : null,
      label: named3 ? mass : `${body2.name}: ${mass}`,
      labelY: named3 ? -height - 5 - lift : -Math.max(height, FACE) - 5 - lift
    };
  }
  function wheels({ width }) {
    const x2 = px(Math.max(width / 3, width / 2 - 1.5 * WHEEL));
    return `M-${x2} ${LIFT}h0M${x2} ${LIFT}h0`;
  }
  function bodyWidth(body2) {
    return Math.max(body2.length - 2 * body2.bumper_length, 0.2 * body2.length);
  }
  function lane(i2, tallest, layout) {
    const above = Math.max(tallest, FACE) + layout.stagger * (layout.ranks - 1) + ABOVE;
    return layout.track - above - LANE * (layout.lanes - 1 - i2 % layout.lanes);
  }
  function spring(start, end2) {
    const low = SPRING[0];
    const high = SPRING[1];
    const step = (end2 - start) / 4;
    let d2 = `M${px(start)} ${px(-(low + high) / 2)}`;
    for (let k = 0; k < 4; k += 1) {
      d2 += `L${px(start + (k + 0.5) * step)} ${px(k % 2 === 0 ? -high : -low)}`;
    }
    return `${d2}L${px(end2)} ${px(-(low + high) / 2)}`;
  }
  function coil(start, end2, y2, turns = TURNS, high = COIL) {
    const span2 = Math.max(0, end2 - start);
    const lead = Math.min(LEAD, span2 / 4);
    const step = (span2 - 2 * lead) / turns;
    let d2 = `M${px(start)} ${px(y2)}L${px(start + lead)} ${px(y2)}`;
    for (let k = 0; k < turns; k += 1) {
      d2 += `L${px(start + lead + (k + 0.5) * step)} ${px(k % 2 === 0 ? y2 - high : y2 + high)}`;
    }
    return `${d2}L${px(start + span2 - lead)} ${px(y2)}L${px(start + span2)} ${px(y2)}`;
  }
  function blockArrow(x2, y2, length) {
    if (Math.abs(length) < SHORTEST) return dot(x2, y2);
    const tip = x2 + length;
    const neck = tip - Math.sign(length) * Math.min(9, Math.abs(length));
    return `M${px(x2)} ${px(y2 - 3)}L${px(neck)} ${px(y2 - 3)}L${px(neck)} ${px(y2 - 6.5)}L${px(tip)} ${px(y2)}L${px(neck)} ${px(y2 + 6.5)}L${px(neck)} ${px(y2 + 3)}L${px(x2)} ${px(y2 + 3)}Z`;
  }
  function cutArrow(x2, y2, length) {
    const half = length / 2 - Math.sign(length) * TORN / 2;
    const piece = `M${px(x2)} ${px(y2 - 3)}h${px(half)}v6h${px(-half)}Z`;
    return piece + blockArrow(x2 + length - half, y2, half);
  }
  function lineArrow(x2, y2, length) {
    if (Math.abs(length) < SHORTEST) return dot(x2, y2, RING);
    const tip = x2 + length;
    const back = tip - Math.sign(length) * Math.min(7, Math.abs(length));
    return `M${px(x2)} ${px(y2)}L${px(tip)} ${px(y2)}M${px(back)} ${px(y2 - 4.5)}L${px(tip)} ${px(y2)}L${px(back)} ${px(y2 + 4.5)}`;
  }
  function dot(x2, y2, radius = DOT) {
    const [r2, d2] = [px(radius), px(2 * radius)];
    return `M${px(x2 - radius)} ${px(y2)}a${r2} ${r2} 0 1 0 ${d2} 0a${r2} ${r2} 0 1 0 -${d2} 0Z`;
  }
  function arrowLength(value, full, length, longest = LONGEST2) {
    const exact = full ? value / full * length : 0;
    return Math.max(-longest * length, Math.min(longest * length, exact));
  }
  function isCut(value, full, longest = LONGEST2) {
    return full > 0 && Math.abs(value) > longest * full;
  }
  function velocityText(x2, length, width) {
    const room = 72;
    if (length >= 0) return x2 > room ? [x2 - 8, "end"] : [x2 + length + 8, "start"];
    return x2 < width - room ? [x2 + 8, "start"] : [x2 + length - 8, "end"];
  }
  function keptInside(x2, length, width) {
    if (x2 > EDGE && x2 < width - EDGE) {
      if (x2 + length > width - EDGE) return width - EDGE - x2;
      if (x2 + length < EDGE) return EDGE - x2;
    }
    return length;
  }
  function labelTop(box2) {
    return box2.labelY - LINE;
  }

  // ../view/trajectory.js
  function fromWire(header, numbers) {
    const { rows, columns, events } = header;
    const parts2 = { t: new Float64Array(0), x: {}, v: {}, a: {}, F: {}, dF: {}, E: {}, events };
    columns.forEach(([quantity, ...key], k) => {
      const column = numbers.subarray(k * rows, (k + 1) * rows);
      const name = String(quantity);
      if (!key.length) parts2[name] = column;
      else {
        parts2[name] ??= {};
        parts2[name][key.join(" ")] = column;
      }
    });
    return parts2;
  }
  function fromBaked(numbers, events) {
    const parts2 = { t: Float64Array.from(numbers.t), events };
    for (const quantity of ["x", "v", "a", "F", "dF", "E"]) {
      parts2[quantity] = {};
      for (const [key, column] of Object.entries(numbers[quantity] ?? {})) {
        parts2[quantity][key] = Float64Array.from(column);
      }
    }
    return parts2;
  }
  function isTold({ trajectory }) {
    return trajectory.t.length > 1;
  }
  function rowAt(times2, t3) {
    let low = 0;
    let high = times2.length;
    while (low < high) {
      const middle = low + high >> 1;
      if (times2[middle] <= t3) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }
  function valueAt(times2, values, slopes, t3) {
    const k = rowAt(times2, t3);
    if (k < 0) return Number(values[0]);
    if (k >= times2.length - 1) return Number(values[values.length - 1]);
    return hermite(times2, values, slopes, k, t3);
  }
  function hermite(times2, values, slopes, k, t3) {
    const at3 = ((c2, i2) => c2[i2]);
    const h2 = at3(times2, k + 1) - at3(times2, k);
    const s3 = (t3 - at3(times2, k)) / h2;
    if (!slopes) return at3(values, k) + (at3(values, k + 1) - at3(values, k)) * s3;
    const r2 = 1 - s3;
    const found3 = at3(values, k) * (1 + 2 * s3) * r2 * r2 + at3(slopes, k) * h2 * s3 * r2 * r2 + at3(values, k + 1) * (1 + 2 * r2) * s3 * s3 - at3(slopes, k + 1) * h2 * r2 * s3 * s3;
    return Number.isFinite(found3) ? found3 : at3(values, k);
  }
  function turnAfter(times2, values, slopes, k) {
    const [before, after] = [Number(slopes?.[k]), Number(slopes?.[k + 1])];
    const [begin, span2] = [Number(times2[k]), Number(times2[k + 1]) - Number(times2[k])];
    if (!slopes || !(before * after < 0) || !(span2 > 0)) return null;
    return hermite(times2, values, slopes, k, begin + span2 * before / (before - after));
  }

  // ../effects/push/view.js
  var LET_GO = 1.5;
  var BACK = 0.2;
  var ROOM = 16;
  var MIDDLE = 29;
  var HAND = "M-46 -6L-31 -7C-26 -9 -22 -6 -17 -3.5L-3 -3.5C1 -3.5 1 3 -3 3L-15 3C-10 3 -10 7.5 -15 7.5C-11 7.5 -11 12 -16 12C-13 12 -13 16 -18 16C-26 17 -29 14 -32 9L-46 9M-15 3h-7M-15 7.5h-6M-16 12h-5M-29 0C-24 0 -21 -1 -19 3M-38 -9h-8v20h8Z";
  var view_default5 = {
    name: tr("pushes from outside"),
    row: 2,
    side: (force2) => force2 < 0 ? "right" : "left",
    around: (_2, agent2) => agent2,
    acts: ({ numbers: { from = 0, until = Infinity } }, t3) => t3 >= from && t3 < until,
    seen: (effect, t3) => begun(effect, t3) && t3 < end(effect) + (isHand(effect) ? LET_GO : 0),
    phrase: (effect, { agent: agent2, seen }) => [
      tr("a push on {cart} by {agent}", { cart: String(effect.carts[0]), agent: agent2 }),
      seen(forceText(effect.numbers.force ?? 0)),
      times(effect)
    ],
    pieces(effect, { key, header, run, t: t3, layout, centre }) {
      const { carts, numbers } = effect;
      const name = String(carts[0]);
      const y2 = layout.track;
      const direction = (numbers.force ?? 0) >= 0 ? 1 : -1;
      const body2 = header.bodies.find((one) => one.name === name);
      const side = centre(name) - direction * ((body2 ? bodyWidth(body2) * layout.scale : 0) / 2);
      if (isHand(effect)) {
        const past = t3 - end(effect);
        if (past >= 0 && goesOn(effect, header)) return [];
        const gone = past < 0 ? 0 : direction * ROOM * Math.min(1, past / BACK);
        const left2 = past < 0 ? side : side - (place(run, name, t3) - place(run, name, end(effect))) * layout.scale;
        return [{ key, cls: "carts-hand carts-palm", d: hand(left2 - gone, y2 - MIDDLE, direction) }];
      }
      const x2 = side - 3 * direction;
      const d2 = `M${px(x2)} ${px(y2 - 38)}v14M${px(x2)} ${px(y2 - 31)}h${px(-direction * 26)}`;
      return [{ key, cls: "carts-hand", behind: true, d: d2 }];
    },
    marks({ carts, numbers: { from = 0, until: end2, force: force2 = 0 } }, agent2, until, told4) {
      const who = { cart: String(carts[0]), agent: agent2 };
      const begins = told4 ? tr("The push on {cart} by {agent} begins: {force}.", { ...who, force: forceText(force2) }) : tr("The push on {cart} by {agent} begins.", who);
      const marks3 = from <= until ? [{ t: from, sentence: begins }] : [];
      if (end2 !== void 0 && from < end2 && end2 <= until) {
        marks3.push({ t: end2, sentence: tr("The push on {cart} by {agent} ends.", who) });
      }
      return marks3;
    }
  };
  var isHand = ({ by }) => !by || by === "hand";
  var begun = ({ numbers: { from = 0 } }, t3) => t3 >= from;
  var end = ({ numbers: { until = Infinity } }) => until;
  function goesOn(effect, { effects }) {
    const on = (one) => one.active && one.kind === effect.kind && one.carts[0] === effect.carts[0] && isHand(one);
    return effects.some((one) => on(one) && one !== effect && (one.numbers.from ?? 0) >= end(effect));
  }
  function place({ trajectory: { t: times2, x: x2, v: v2 } }, name, t3) {
    return valueAt(times2, x2[name] ?? [], v2[name] ?? [], t3);
  }
  function hand(x2, y2, direction) {
    let across2 = true;
    let absolute = true;
    return HAND.replace(/[MLCvhZ]|-?[\d.]+/g, (part) => {
      if (/[a-zA-Z]/.test(part)) {
        across2 = part !== "v";
        absolute = part === part.toUpperCase();
        return part;
      }
      const number = Number(part);
      const shown3 = across2 ? direction * number + (absolute ? x2 : 0) : number + (absolute ? y2 : 0);
      across2 = absolute ? !across2 : across2;
      return ` ${px(shown3)}`;
    });
  }
  function forceText(force2) {
    const size = short(Math.abs(force2));
    return force2 >= 0 ? tr("{size} N to the right", { size }) : tr("{size} N to the left", { size });
  }
  function times({ numbers: { from = 0, until } }) {
    if (until !== void 0) {
      return tr("from {from} s to {until} s", { from: short(from), until: short(until) });
    }
    return from ? tr("from {from} s", { from: short(from) }) : "";
  }

  // ../effects/release/view.js
  var HALF = 9;
  var TURNS2 = 7;
  var HIGH = 4;
  var ABOVE2 = 28;
  var view_default6 = {
    name: tr("a release between the carts"),
    leftOut: tr("springs that are let go"),
    link: tr("spring"),
    lasts: ({ numbers }) => numbers.stiffness !== void 0,
    // else an impulse: no force to be drawn
    stored: tr("in the squeezed spring"),
    acts: ({ numbers: { at: at3 = 0, stiffness } }, t3) => t3 < at3 || stiffness !== void 0,
    phrase: ({ numbers: { energy = 0, at: at3 = 0, stiffness } }, { both: both2, seen }) => [
      stiffness === void 0 ? tr("an exploder between {bodies}", { bodies: both2 }) : tr("a squeezed spring between {bodies} that is let go", { bodies: both2 }),
      seen(`${short(energy)} J`),
      stiffness === void 0 ? "" : seen(`${short(stiffness)} N/m`),
      tr("at {time} s", { time: short(at3) })
    ],
    pieces(effect, { key, run, t: t3, layout, face: face2 }) {
      const [a2, b2] = effect.between ?? ["", ""];
      const [begun2, ended3] = pushes(effect, run);
      const low = layout.track - ABOVE2;
      const ends = [face2(a2, "right"), face2(b2, "left")].map(Number);
      if (t3 > ended3) {
        const there = edge(run, a2, ended3) - edge(run, a2, t3);
        const start2 = Number(ends[0]) + there * layout.scale - HALF;
        const long = (edge(run, b2, ended3, -1) - edge(run, a2, ended3)) * layout.scale;
        const lying = coil(start2, start2 + long + 2 * HALF, layout.track - HIGH, TURNS2, HIGH);
        return [{ key: `${key} lying`, cls: "carts-coil carts-spent", behind: true, d: lying }];
      }
      const middle = (Number(ends[0]) + Number(ends[1])) / 2;
      const [start = 0, end2 = 0] = t3 < begun2 ? [middle, middle] : ends;
      const wire = coil(start - HALF, end2 + HALF, low, TURNS2, HIGH);
      const plates = t3 < begun2 ? `M${px(start - HALF - 1)} ${px(low + 7)}v-15h20v15` : `M${px(start - HALF - 1)} ${px(low + 7)}v-14M${px(end2 + HALF + 1)} ${px(low + 7)}v-14`;
      return [
        { key, cls: "carts-coil", d: wire },
        { key: `${key} latch`, cls: "carts-latch", d: plates }
      ];
    }
  };
  function pushes({ between: between2, numbers: { at: at3 = 0 } }, { header, trajectory }) {
    const pair = between2?.join("-");
    const mine = header.events.filter(({ bodies }) => bodies.join("-") === pair);
    const begun2 = mine.find(({ kind: kind2, t: t3 }) => kind2 === "release" && t3 === at3);
    if (!begun2 || trajectory.t.length < 2) return [Infinity, Infinity];
    const ended3 = mine.find(({ kind: kind2, t: t3 }) => kind2 === "separate" && t3 > begun2.t);
    return [begun2.t, ended3?.t ?? Infinity];
  }
  function edge({ header, trajectory }, name, t3, direction = 1) {
    const half = (header.bodies.find((body2) => body2.name === name)?.length ?? 0) / 2;
    return valueAt(trajectory.t, trajectory.x[name] ?? [], trajectory.v[name] ?? [], t3) + direction * half;
  }

  // ../effects/spring/view.js
  var view_default7 = {
    name: tr("springs between the carts"),
    link: tr("spring"),
    stored: tr("in the spring"),
    warms: ({ numbers }) => (numbers.damping ?? 0) > 0 ? tr("spring") : "",
    phrase({ numbers: { stiffness = 0, length = 0, damping } }, { both: both2, seen }) {
      const natural = tr("natural length {length} m", { length: short(length) });
      return [
        tr("a spring between {bodies}", { bodies: both2 }),
        damping ? tr("damped") : "",
        seen(`${short(stiffness)} N/m, ${natural}`)
      ];
    },
    pieces({ numbers, between: between2 }, { key, layout, face: face2 }) {
      const [a2, b2] = between2 ?? ["", ""];
      const [start, end2] = [face2(a2, "right"), face2(b2, "left")];
      const length = (numbers.length ?? 0) * layout.scale;
      const middle = (start + end2) / 2;
      const low = a2 === "left" ? start : b2 === "right" ? end2 - length : middle - length / 2;
      const y2 = layout.track - PUSH - COIL - 5;
      const measure2 = `M${px(low)} ${px(y2 - 3)}v6M${px(low)} ${px(y2)}h${px(length)}m0 -3v6`;
      return [
        { key, cls: "carts-coil", d: coil(start, end2, layout.track - PUSH) },
        { key: `${key} natural`, cls: "carts-natural", d: measure2 }
      ];
    }
  };

  // ../effects/views.js
  var VIEWS = {
    drag: view_default,
    friction: view_default2,
    incline: view_default3,
    magnets: view_default4,
    push: view_default5,
    release: view_default6,
    spring: view_default7
  };

  // ../view/effects.js
  var LAST = 100;
  function viewOf(kind2) {
    return { name: kind2, row: LAST, ...VIEWS[kind2] };
  }
  function nameOf({ kind: kind2, called }) {
    const name = VIEWS[kind2]?.name ?? (called && told(called));
    if (!name) throw new Error(`nobody describes an effect of the kind “${kind2}”`);
    return name;
  }
  function agent(effect) {
    const named3 = effect.by || effect.agent;
    return viewOf(effect.kind).agent?.(effect) ?? (named3 ? told(named3) : nameOf(effect));
  }
  function actsAt(effect, t3) {
    return effect.active && (viewOf(effect.kind).acts?.(effect, t3) ?? true);
  }
  function kindsOnOne({ effects }) {
    const kinds = new Set(effects.filter(({ between: between2 }) => !between2).map(({ kind: kind2 }) => kind2));
    return [...kinds].sort((a2, b2) => viewOf(a2).row - viewOf(b2).row || (a2 < b2 ? -1 : 1));
  }
  function isLink(effect) {
    const { link, lasts } = viewOf(effect.kind);
    return effect.between !== null && link !== null && (lasts?.(effect) ?? true);
  }
  function pairsApart({ effects }) {
    return effects.flatMap(
      ({ kind: kind2, active, between: between2 }) => active && between2 && viewOf(kind2).apart ? [between2] : []
    );
  }
  function linkOf({ effects }, pair) {
    const link = effects.find(
      (effect) => effect.active && isLink(effect) && effect.between?.join("-") === pair
    );
    return link ? viewOf(link.kind).link ?? viewOf(link.kind).name : "";
  }
  function effectOf(target, { effects }) {
    const owner = target.slice(0, target.lastIndexOf("."));
    return effects.find(
      ({ kind: kind2, index }) => [kind2, `effects.${index}`, `effects.${index}.${kind2}`].includes(owner)
    );
  }

  // src/scene/switches.js
  var Switches = class {
    #boxes = /* @__PURE__ */ new Map();
    #header = null;
    constructor(root, switches, change2) {
      for (const { set } of switches) {
        const box2 = root.querySelector(`[data-switch="${CSS.escape(set)}"]`);
        if (!box2) continue;
        this.#boxes.set(set, box2);
        box2.addEventListener("change", (event) => change2(set, box2.checked, event.timeStamp));
      }
    }
    enable(on) {
      for (const box2 of this.#boxes.values()) box2.disabled = !on;
    }
    show(header, pending = /* @__PURE__ */ new Set()) {
      this.#header = header;
      for (const [set, box2] of this.#boxes) {
        if (pending.has(set)) continue;
        const effect = effectOf(set, header);
        if (effect) box2.checked = effect.active;
        need(box2.closest(".carts-switch"), ".carts-error").hidden = true;
      }
    }
    complain(target, message) {
      const box2 = this.#boxes.get(target);
      if (!box2) return false;
      if (this.#header) this.show(this.#header);
      const error = need(box2.closest(".carts-switch"), ".carts-error");
      say(error, message);
      error.hidden = false;
      return true;
    }
  };
  function effectValue(header, target) {
    const key = target.slice(target.lastIndexOf(".") + 1);
    return effectOf(target, header)?.numbers[key] ?? null;
  }
  function effectPath({ effects }, keys) {
    if (!Array.isArray(effects)) return null;
    const kind2 = keys[0] === "effects" ? "" : String(keys[0]);
    const index = kind2 ? effects.findIndex((entry3) => kind2 in entry3) : Number(keys[1]);
    const entry2 = effects[index];
    return entry2 && keys.length > 1 ? ["effects", String(index), String(Object.keys(entry2)[0]), String(keys.at(-1))] : null;
  }

  // src/scene/controls.js
  var KEYS = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 3, PageDown: -3 };
  var Controls = class {
    #views = /* @__PURE__ */ new Map();
    on = false;
    // values may be changed, here or in the picture
    constructor(root, controls, { change: change2, stops = () => void 0 }, switches = []) {
      this.switches = new Switches(root, switches, change2);
      for (const control of controls) {
        const element = root.querySelector(`.carts-control[data-set="${CSS.escape(control.set)}"]`);
        if (element) this.#views.set(control.set, new ControlView(element, control, change2, stops));
      }
    }
    enable(on) {
      this.on = on;
      for (const view of this.#views.values()) view.enable(on);
      this.switches.enable(on);
    }
    show(settings, header, pending) {
      this.switches.show(header, pending);
      for (const [target, view] of this.#views) {
        if (pending.has(target)) continue;
        const value = target in settings ? settings[target] : view.control.value;
        const number = valueIn(header, target) ?? Number(value) * view.control.per;
        if (Number.isFinite(number)) view.show(view.shown(number));
        else if (!(target in settings)) view.show(view.control.value);
      }
    }
    take(target, value, at3) {
      this.#views.get(target)?.take(value, at3);
    }
    complain(target, message) {
      this.#views.get(target)?.complain(message);
      return this.#views.has(target) || this.switches.complain(target, message);
    }
  };
  var ControlView = class {
    #sent = "";
    // the text in the box that a run was asked for with
    constructor(root, control, change2, stops) {
      this.root = root;
      this.control = control;
      this.slider = need(root, ".carts-slider");
      this.box = need(root, ".carts-number-box");
      this.error = need(root, ".carts-error");
      this.decimals = Math.max(
        ...[control.step, control.low, control.value].map((v2) => decimalsOf(v2))
      );
      this.change = change2;
      this.slider.addEventListener("input", (event) => {
        const to = this.slider.valueAsNumber;
        const values = stops(control.set);
        this.take(values?.[nearest(values, to)] ?? to, event.timeStamp);
      });
      this.slider.addEventListener("keydown", (event) => {
        const by = KEYS[event.key];
        const values = stops(control.set);
        if (!by || !values) return;
        event.preventDefault();
        const to = nearest(values, this.slider.valueAsNumber) + by;
        this.take(values[Math.max(0, Math.min(to, values.length - 1))] ?? 0, event.timeStamp);
      });
      const typed = () => this.#typed();
      this.box.addEventListener("change", typed);
      onEnter(this.box, typed);
    }
    enable(on) {
      this.slider.disabled = !on;
      this.box.disabled = !on;
    }
    take(value, at3) {
      this.#accept(value);
      this.change(this.control.set, this.#asked(value), at3);
    }
    shown(value) {
      return Number((value / this.control.per).toPrecision(12));
    }
    #asked(value) {
      return this.control.per === 1 ? value : `${value} ${this.control.unit}`;
    }
    show(value) {
      this.slider.valueAsNumber = value;
      put(this.slider, "aria-valuetext", `${this.#text(value)} ${this.control.unit}`);
      const typing = document.activeElement === this.box && this.box.value !== this.#sent;
      if (typing) return;
      this.#write(value);
      this.clear();
    }
    complain(message) {
      this.#sent = "";
      say(this.error, message);
      this.error.hidden = false;
      this.root.classList.add("carts-wrong");
      this.box.setAttribute("aria-invalid", "true");
    }
    clear() {
      this.error.hidden = true;
      this.root.classList.remove("carts-wrong");
      this.box.removeAttribute("aria-invalid");
    }
    #typed() {
      if (this.box.value === this.#sent) return;
      const at3 = performance.now();
      const { low, high, unit } = this.control;
      const read = readTyped(withoutUnit(this.box.value, unit));
      if ("problem" in read) return this.complain(read.problem);
      if ("text" in read) {
        this.#sent = this.box.value;
        return this.change(this.control.set, read.text, at3);
      }
      if (read.value < low || read.value > high)
        return this.complain(outside(this.control, this.#text(low), this.#text(high)));
      return this.take(read.value, at3);
    }
    #accept(value) {
      this.slider.valueAsNumber = value;
      put(this.slider, "aria-valuetext", `${this.#text(value)} ${this.control.unit}`);
      this.#write(value);
      this.clear();
    }
    #write(value) {
      const text = this.#text(value).replace("−", "-");
      this.#sent = text;
      if (this.box.value !== text) this.box.value = text;
    }
    #text(value) {
      return fixed(value, Math.max(this.decimals, decimalsOf(value)));
    }
  };
  function withoutUnit(typed, unit) {
    const text = typed.trim();
    const number = text.slice(0, text.length - unit.length);
    return unit && text.endsWith(unit) && /[\d.,\s]$/.test(number) ? number : text;
  }
  function nearest(values, asked4) {
    const far = (x2) => Math.abs(x2 - asked4);
    return values.reduce((best, x2, k) => far(x2) < far(values[best] ?? 0) ? k : best, 0);
  }
  function valueIn(header, target) {
    const [owner, key] = target.split(".");
    const body2 = header.bodies.find(({ name }) => name === owner);
    if (body2) return Number(body2[String(key)]);
    if (target === "until" || target === "gravity") return header[target];
    if (target === "track.length") return header.track.length;
    if (owner === "contact" && (key === "restitution" || key === "stiffness")) {
      const values = new Set(header.contacts.map((contact) => contact[key]));
      return values.size === 1 ? [...values][0] ?? null : null;
    }
    return effectValue(header, target);
  }

  // src/map/axis.js
  var AxisControl = class {
    #read = "";
    // the text in the box that was taken, or shown
    constructor(root, axis2, chosen) {
      this.root = root;
      this.axis = axis2;
      this.values = axis2.values;
      this.decimals = axisDecimals2(axis2);
      this.slider = need(root, ".carts-slider");
      this.box = need(root, ".carts-number-box");
      this.error = need(root, ".carts-error");
      this.slider.addEventListener("input", () => chosen(this.slider.valueAsNumber));
      const typed = () => this.#typed(chosen);
      this.box.addEventListener("change", typed);
      onEnter(this.box, typed);
    }
    enable(on) {
      this.slider.disabled = !on;
      this.box.disabled = !on;
    }
    show(values, place4) {
      this.values = values;
      put(this.slider, "max", String(values.length - 1));
      this.slider.valueAsNumber = place4;
      if (document.activeElement === this.box && this.box.value !== this.#read) return;
      this.#read = this.text(place4).replace("−", "-");
      this.box.value = this.#read;
      this.#complain("");
    }
    speak(place4, value) {
      put(this.slider, "aria-valuetext", `${this.text(place4)} ${this.axis.unit}: ${value}`);
    }
    text(place4) {
      return fixed(shown(Number(this.values[place4]), this.axis), this.decimals);
    }
    nearest(value, per = 1) {
      let best = 0;
      for (const [k, at3] of this.values.entries()) {
        if (Math.abs(at3 / per - value) < Math.abs(Number(this.values[best]) / per - value)) best = k;
      }
      return best;
    }
    #typed(chosen) {
      if (this.box.value === this.#read) return;
      this.#read = this.box.value;
      const { low, high, unit, label, per } = this.axis;
      const { decimals } = this;
      const read = readTyped(this.box.value);
      if ("problem" in read) return this.#complain(read.problem);
      if ("text" in read) {
        const wanted2 = tr("{label}: a number in {unit}, please.", { label, unit });
        return this.#complain(unit ? wanted2 : noNumber(read.text));
      }
      if (read.value < low || read.value > high)
        return this.#complain(outside(this.axis, fixed(low, decimals), fixed(high, decimals)));
      return chosen(this.nearest(read.value, per));
    }
    #complain(message) {
      say(this.error, message);
      this.error.hidden = !message;
      this.root.classList.toggle("carts-wrong", Boolean(message));
      if (message) this.box.setAttribute("aria-invalid", "true");
      else this.box.removeAttribute("aria-invalid");
    }
  };

  // ../view/map/palette.js
  var NONE = [176, 176, 176];
  var ZERO = [32, 32, 32];
  var EDGE2 = 0.72;
  function sequential(count2) {
    return Array.from({ length: count2 }, (_2, k) => {
      const t3 = k / Math.max(1, count2 - 1);
      return oklch(0.3 + 0.64 * t3, 0.09 + 0.05 * Math.sin(Math.PI * t3), 268 - 165 * t3);
    });
  }
  function diverging(centres) {
    const far = Math.max(...centres.map(Math.abs));
    return centres.map((centre) => {
      const size = Math.abs(centre / far);
      return oklch(0.97 - 0.47 * size, 0.145 * size, centre < 0 ? 250 : 52);
    });
  }
  function edge2([red, green, blue]) {
    return [Math.round(EDGE2 * red), Math.round(EDGE2 * green), Math.round(EDGE2 * blue)];
  }
  function oklch(lightness, chroma, hue) {
    const angle = hue * Math.PI / 180;
    const [a2, b2] = [chroma * Math.cos(angle), chroma * Math.sin(angle)];
    const long = (lightness + 0.3963377774 * a2 + 0.2158037573 * b2) ** 3;
    const middle = (lightness - 0.1055613458 * a2 - 0.0638541728 * b2) ** 3;
    const short2 = (lightness - 0.0894841775 * a2 - 1.291485548 * b2) ** 3;
    return [
      channel(4.0767416621 * long - 3.3077115913 * middle + 0.2309699292 * short2),
      channel(-1.2684380046 * long + 2.6097574011 * middle - 0.3413193965 * short2),
      channel(-0.0041960863 * long - 0.7034186147 * middle + 1.707614701 * short2)
    ];
  }
  function channel(linear) {
    const light = Math.min(1, Math.max(0, linear));
    const coded = light <= 31308e-7 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055;
    return Math.round(255 * coded);
  }

  // ../view/map/bands.js
  var BANDS = 12;
  var FLAT = 1e-9;
  function scaleFor(low, high) {
    const largest = Math.max(Math.abs(low), Math.abs(high));
    const flat = high - low <= FLAT * largest || largest === 0;
    const step = flat ? largest ? niceAbove(largest) : 1 : niceAbove((high - low) / BANDS);
    const first = Math.floor(low / step + STEP_SLACK);
    const last = Math.max(first + 1, Math.ceil(high / step - STEP_SLACK));
    const count2 = last - first;
    const centres = Array.from({ length: count2 }, (_2, k) => (first + k + 0.5) * step);
    const around = Number(centres[0]) < 0 && Number(centres.at(-1)) > 0;
    return {
      low: first * step,
      step,
      count: count2,
      colours: around ? diverging(centres) : sequential(count2),
      zero: Math.min(count2, Math.max(0, -first))
    };
  }

  // ../view/map/pixels.js
  var FINE = 400;
  var TORN2 = 3;
  function band(value, { low, step, count: count2 }) {
    if (Number.isNaN(value)) return count2;
    const place4 = Math.floor((value - low) / step + STEP_SLACK);
    return Math.min(count2 - 1, Math.max(0, place4));
  }
  function torn(before, a2, b2, after, step) {
    const apart = Math.abs(b2 - a2);
    if (apart <= TORN2 * step) return false;
    const beside2 = [a2 - before, b2 - after].map(Math.abs).filter(Number.isFinite);
    return !(apart <= TORN2 * (beside2.length ? Math.min(...beside2) : apart));
  }
  function between(values, lines4, count2, factor, next, line3, step) {
    const fine = (count2 - 1) * factor + 1;
    const found3 = new Float64Array(lines4 * fine);
    for (let i2 = 0; i2 < lines4; i2 += 1) {
      const value = (k) => k < 0 || k >= count2 ? Number.NaN : Number(values[i2 * line3 + k * next]);
      for (let left2 = 0; left2 < count2 - 1; left2 += 1) {
        const [a2, b2] = [value(left2), value(left2 + 1)];
        const apart = torn(value(left2 - 1), a2, b2, value(left2 + 2), step);
        for (let k = 0; k <= factor; k += 1) {
          const part = k / factor;
          const mixed = a2 * (1 - part) + b2 * part;
          found3[i2 * fine + left2 * factor + k] = !apart ? mixed : part < 0.5 ? a2 : b2;
        }
      }
    }
    return found3;
  }
  function pixels(values, columns, scale) {
    const rows = values.length / columns;
    const factor = Math.max(1, Math.ceil(FINE / (Math.max(columns, rows) - 1)));
    const width = (columns - 1) * factor + 1;
    const height = (rows - 1) * factor + 1;
    const wide = between(values, rows, columns, factor, 1, columns, scale.step);
    const fine = between(wide, width, rows, factor, width, 1, scale.step);
    const bands = new Uint8Array(width * height);
    for (let y2 = 0; y2 < height; y2 += 1) {
      for (let x2 = 0; x2 < width; x2 += 1) {
        bands[y2 * width + x2] = band(Number(fine[x2 * height + (height - 1 - y2)]), scale);
      }
    }
    return { places: lines(bands, width, scale), width, height };
  }
  function lines(bands, width, { count: count2, zero }) {
    const places = bands.slice();
    const line3 = 2 * count2 + 1;
    const compare = (at3, other) => {
      const own = Number(bands[at3]);
      const next = Number(bands[other]);
      if (next === own || own === count2) return;
      if (next !== count2 && own >= zero !== next >= zero && Math.abs(own - next) === 1) {
        places[at3] = line3;
        places[other] = line3;
      } else if (places[at3] !== line3) places[at3] = count2 + 1 + own;
    };
    for (let at3 = 0; at3 < bands.length; at3 += 1) {
      if ((at3 + 1) % width) compare(at3, at3 + 1);
      if (at3 + width < bands.length) compare(at3, at3 + width);
    }
    return places;
  }
  function palette({ colours }) {
    return [...colours, NONE, ...colours.map(edge2), ZERO];
  }

  // ../view/map/figure.js
  var [LEFT3, TOP3, RIGHT3, BOTTOM3] = [58, 10, 388, 270];
  var WIDTH2 = 400;
  var [HEIGHT, HEIGHT_OF_CURVE] = [370, 312];
  var TICKS = 5;
  var heightOf = ({ axes }) => axes.length === 1 ? HEIGHT_OF_CURVE : HEIGHT;
  var valueAxis = ({ low, high }) => axis(low, high, TICKS);
  function across(value, { low, high }) {
    return LEFT3 + (value - low) * ((RIGHT3 - LEFT3) / (high - low));
  }
  function up(value, { low, high }) {
    return BOTTOM3 - (value - low) * ((BOTTOM3 - TOP3) / (high - low));
  }
  function curve(facts, points, values) {
    const along = facts.axes[0];
    if (!along) return "";
    const [x2, y2] = [span(along.low, along.high, 1), valueAxis(facts)];
    let path3 = "";
    let pen = "M";
    for (const [k, point] of points.entries()) {
      const [before, last, value, next] = [k - 2, k - 1, k, k + 1].map((at3) => Number(values[at3]));
      if (torn(before, last, value, next, (y2.high - y2.low) / TICKS)) pen = "M";
      if (value >= y2.low && value <= y2.high) {
        path3 += `${pen}${px(across(shown(point, along), x2))} ${px(up(value, y2))}`;
        pen = "L";
      } else pen = "M";
    }
    return path3;
  }

  // src/shared/follow.js
  function followPointer(down, moved) {
    if (down.button > 0) return false;
    const leaving2 = new AbortController();
    const { signal } = leaving2;
    const follow = (now) => {
      if (now.pointerId !== down.pointerId) return;
      if (now.buttons & 1) moved(now.clientX - down.clientX, now);
      else leaving2.abort();
    };
    addEventListener("pointermove", follow, { signal });
    addEventListener("pointerup", follow, { signal });
    addEventListener("pointercancel", follow, { signal });
    return true;
  }
  var FAR = 8;
  function onPointed(place4, point) {
    place4.addEventListener("click", point);
    place4.addEventListener("pointerdown", (down) => {
      let points = down.pointerType === "mouse";
      const moved = (pixels2, now) => {
        points ||= Math.abs(pixels2) > Math.max(FAR, Math.abs(now.clientY - down.clientY));
        if (points) point(now);
      };
      if (followPointer(down, moved)) moved(0, down);
    });
  }

  // src/map/paint.js
  function paint(canvas, { values, columns }, scale) {
    const { places, width, height } = pixels(values, columns, scale);
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    const context = canvas.getContext("2d");
    if (!context) return;
    const image = context.createImageData(width, height);
    const words = new Uint32Array(image.data.buffer);
    const colours = packed(scale);
    for (let at3 = 0; at3 < places.length; at3 += 1) words[at3] = Number(colours[Number(places[at3])]);
    context.putImageData(image, 0, 0);
  }
  function packed(scale) {
    return Uint32Array.from(palette(scale), ([r2, g2, b2]) => 255 << 24 | b2 << 16 | g2 << 8 | r2);
  }

  // src/map/figure.js
  var MapFigure = class {
    #canvas = null;
    constructor(root, facts, point) {
      this.facts = facts;
      this.scale = scaleFor(facts.low, facts.high);
      this.height = heightOf(facts);
      this.holder = need(root, ".carts-map-figure");
      this.over = need(root, ".carts-map-over");
      this.axes = facts.axes.map(({ values }) => values);
      onPointed(this.over, (event) => {
        if (this.#canvas || facts.axes.length < 2) point(this.#placesAt(event));
      });
    }
    show(grid) {
      this.axes = grid.axes;
      if (grid.axes.length === 1) {
        const path3 = curve(this.facts, grid.axes[0] ?? [], grid.values);
        return put(need(this.over, '[data-part="curve"]'), "d", path3);
      }
      this.#canvas ??= this.#laid();
      paint(this.#canvas, grid, this.scale);
    }
    mark(places, value) {
      const x2 = this.#along(0, places[0] ?? 0, across);
      const flat = places.length === 1;
      const y2 = flat ? up(value, valueAxis(this.facts)) : this.#along(1, places[1] ?? 0, up);
      const across2 = flat ? "" : `M${LEFT3} ${px(y2)}H${RIGHT3}`;
      put(need(this.over, '[data-part="lines"]'), "d", `M${px(x2)} ${TOP3}V${BOTTOM3}${across2}`);
      const point = need(this.over, '[data-part="point"]');
      put(point, "cx", px(x2));
      put(point, "cy", px(Number.isNaN(y2) ? BOTTOM3 : y2));
      put(point, "visibility", Number.isNaN(y2) ? "hidden" : "visible");
    }
    #laid() {
      const canvas = html("canvas", "carts-map-canvas");
      canvas.setAttribute("aria-hidden", "true");
      canvas.style.left = `${100 * LEFT3 / WIDTH2}%`;
      canvas.style.top = `${100 * TOP3 / this.height}%`;
      canvas.style.width = `${100 * (RIGHT3 - LEFT3) / WIDTH2}%`;
      canvas.style.height = `${100 * (BOTTOM3 - TOP3) / this.height}%`;
      this.over.before(canvas);
      return canvas;
    }
    #along(k, place4, draw) {
      const along = this.facts.axes[k];
      const value = shown(Number(this.axes[k]?.[place4]), along);
      return draw(value, span(along.low, along.high, 1));
    }
    #placesAt(event) {
      const box2 = this.over.getBoundingClientRect();
      const x2 = (event.clientX - box2.left) / box2.width * WIDTH2;
      const y2 = (event.clientY - box2.top) / box2.height * this.height;
      const fractions = [(x2 - LEFT3) / (RIGHT3 - LEFT3), (BOTTOM3 - y2) / (BOTTOM3 - TOP3)];
      return this.axes.map(({ length }, k) => {
        const place4 = Math.round(Number(fractions[k]) * (length - 1));
        return Math.min(length - 1, Math.max(0, place4));
      });
    }
  };

  // src/map/filling.js
  var Filling = class {
    #turn = 0;
    #rest = null;
    #filled = Promise.resolve();
    whole = Promise.resolve();
    constructor(ask, acts) {
      this.ask = ask;
      this.acts = acts;
    }
    map(settings, draw) {
      const drawn2 = this.#map(settings, draw);
      this.whole = drawn2.catch(() => {
      }).then(() => this.#filled);
      return drawn2;
    }
    async #map(settings, draw) {
      this.#turn += 1;
      const turn = this.#turn;
      try {
        const first = await this.ask(settings, 0);
        if (turn !== this.#turn) return;
        const { ok, problems, done, runs } = first.header;
        if (!ok) throw refusal(problems ?? []);
        this.#rest = { settings, done, runs };
        await draw(first);
      } finally {
        if (turn === this.#turn && this.#rest) this.#filled = this.#fill(this.#rest, turn);
      }
    }
    async #fill(rest, turn) {
      try {
        while (rest.done < rest.runs) {
          this.acts.progress(rest.done, rest.runs);
          const { header, numbers } = await this.ask(rest.settings, rest.done);
          if (turn !== this.#turn) return this.whole;
          if (!header.ok) throw refusal(header.problems ?? []);
          this.acts.slice(numbers);
          rest.done = header.done;
        }
        this.#rest = null;
        this.acts.complete(rest.settings);
      } catch (error) {
        if (turn !== this.#turn) return this.whole;
        this.acts.failed(error);
      }
    }
  };

  // src/map/run-point.js
  async function runPoint(id, values, tell2) {
    const scene = document.getElementById(id);
    if (typeof scene?.set !== "function") return;
    try {
      tell2("");
      await scene.set(values);
      scene.time = 0;
      scene.scrollIntoView({ block: "start" });
      scene.querySelector(".carts-play")?.focus({ preventScroll: true });
    } catch (error) {
      tell2(error.message);
    }
  }

  // src/map/settings.js
  function showSettings(map, controls, settings) {
    for (const { set, per, step } of controls) {
      const value = settings[set];
      const root = map.querySelector(`.carts-control[data-set="${CSS.escape(set)}"]`);
      if (typeof value !== "number" || !root) continue;
      const shown3 = Number((value / per).toPrecision(12));
      const box2 = need(root, ".carts-number-box");
      need(root, ".carts-slider").valueAsNumber = shown3;
      if (box2 !== document.activeElement) {
        const decimals = Math.max(decimalsOf(shown3), decimalsOf(step));
        box2.value = fixed(shown3, decimals).replace("−", "-");
      }
    }
  }
  function offerOpening(map, on) {
    const button = need(map, ".carts-map-open");
    button.disabled = !on;
    for (const part of [button, need(map, ".carts-map-wait")]) part.hidden = !on;
  }
  function showProgress(map, done, runs) {
    const bar2 = need(map, ".carts-map-progress");
    bar2.value = done / runs;
    bar2.style.visibility = done < runs ? "visible" : "hidden";
  }

  // ../view/map/table.js
  var COLUMNS = 6;
  var ROWS = 11;
  function spread(count2, most) {
    const wanted2 = Math.min(most, count2);
    return Array.from(
      { length: wanted2 },
      (_2, k) => Math.floor(k * (count2 - 1) / (wanted2 - 1) + 0.5)
    );
  }
  function tableOf(columns, rows, axisText, valueText3) {
    if (rows === 1) {
      const lines5 = spread(columns, 2 * ROWS - 1).map((k) => [axisText(0, k), valueText3(k)]);
      return { head: [], lines: lines5 };
    }
    const across2 = spread(columns, COLUMNS);
    const lines4 = spread(rows, ROWS).map((row) => [
      axisText(1, row),
      ...across2.map((k) => valueText3(row * columns + k))
    ]);
    return { head: across2.map((k) => axisText(0, k)), lines: lines4 };
  }

  // src/map/table.js
  function fillTable(table, grid, axisText, facts) {
    const { head, lines: lines4 } = tableOf(
      grid.columns,
      grid.rows,
      axisText,
      (place4) => valueText2(Number(grid.values[place4]), facts)
    );
    const heads = [...table.querySelectorAll("thead tr:last-child th:not(:first-child)")];
    for (const [k, text] of head.entries()) if (heads[k]) heads[k].textContent = text;
    const body2 = lines4.map(([name = "", ...cells2]) => {
      const line3 = html("tr");
      const first = html("th", "", name);
      first.setAttribute("scope", "row");
      line3.append(first, ...cells2.map((cell3) => html("td", "", cell3)));
      return line3;
    });
    table.querySelector("tbody")?.replaceChildren(...body2);
  }

  // src/map/element.js
  function mapElement(client2) {
    return class CartsMap extends HTMLElement {
      #facts = null;
      #figure = null;
      #axes = [];
      #controls = null;
      #grid = null;
      #places = [];
      #settings = {};
      #opening = null;
      #filling = new Filling(
        (set, from) => client2.ask(this, () => ({ kind: "map", map: this.#facts?.map, set, from })),
        {
          slice: (numbers) => this.#take(numbers),
          progress: (done, all) => showProgress(this, done, all),
          complete: (detail) => {
            showProgress(this, 1, 1);
            this.dispatchEvent(new CustomEvent("carts-update", { bubbles: true, detail }));
          },
          failed: (error) => this.#fail(error)
        }
      );
      #leaving = new AbortController();
      // ends what it hears of the page
      connectedCallback() {
        this.#leaving = new AbortController();
        const { signal } = this.#leaving;
        addEventListener("beforeprint", () => this.#fillTable(), { signal });
        if (this.#facts) return;
        const facts = JSON.parse(need(this, ".carts-map-baked").textContent ?? "");
        this.#facts = facts;
        this.#places = facts.here;
        this.#figure = new MapFigure(this, facts, (places) => this.#choose(places));
        const roots = this.querySelectorAll(".carts-map-axis");
        this.#axes = facts.axes.map((axis2, k) => {
          const root = roots[k];
          return new AxisControl(
            root,
            axis2,
            (place4) => this.#choose(this.#places.map((old, other) => other === k ? place4 : old))
          );
        });
        this.#controls = new Controls(this, facts.controls, {
          change: (target, value, at3) => void this.set({ [target]: value }, at3).catch(
            (error) => this.#controls?.complain(target, error.message)
          )
        });
        this.#figure.mark(facts.here, facts.at ?? Number.NaN);
        offerOpening(this, true);
        need(this, ".carts-map-open").addEventListener("click", () => void this.open());
        this.querySelector(".carts-map-run")?.addEventListener("click", () => {
          const values = { ...this.#settings, ...this.point };
          void runPoint(facts.of ?? "", values, (message) => this.#tell(message));
        });
        need(this, ".carts-map-table").addEventListener("toggle", () => this.#fillTable());
      }
      disconnectedCallback() {
        this.#leaving.abort();
      }
      get grid() {
        return this.#grid;
      }
      get point() {
        const chosen = this.#axes.map(({ axis: axis2, values }, k) => [
          axis2.set,
          Number(values[Number(this.#places[k])])
        ]);
        return Object.fromEntries(chosen);
      }
      get value() {
        return this.#valueAt(this.#places);
      }
      get complete() {
        return this.#filling.whole;
      }
      open() {
        this.#opening ??= this.#open();
        return this.#opening;
      }
      async set(changes2, at3 = performance.now()) {
        const settings = { ...this.#settings, ...changes2 };
        await this.#compute(settings, at3);
      }
      async #open() {
        this.dataset.state = "starting";
        const button = need(this, ".carts-map-open");
        button.disabled = true;
        this.#tell("");
        say(need(this, ".carts-map-wait"), tr("Python is being loaded for all points at once …"));
        try {
          await client2.need(this.#facts?.packages ?? []);
          await this.#compute(this.#settings, performance.now());
          this.dataset.state = "live";
          need(this, ".carts-mark").setAttribute("aria-label", LIVE);
          const focused = button === document.activeElement;
          offerOpening(this, false);
          showProgress(this, 1, 1);
          for (const control of this.#axes) control.enable(true);
          this.#controls?.enable(true);
          const run = this.querySelector(".carts-map-run");
          if (run instanceof HTMLButtonElement) run.disabled = false;
          if (focused) this.#axes[0]?.slider.focus();
        } catch (error) {
          this.#fail(error);
        }
      }
      #fail(error) {
        this.#opening = null;
        this.dataset.state = "failed";
        this.dataset.reason = error.reason ?? "failed";
        this.#tell(
          tr("{reason} The picture and the table stay as they were prepared.", {
            reason: error.message
          })
        );
        showProgress(this, 1, 1);
        say(need(this, ".carts-map-wait"), "");
        offerOpening(this, client2.state !== "failed");
      }
      #tell(message) {
        const note2 = need(this, ".carts-note");
        say(note2, message);
        note2.hidden = !message;
      }
      #compute(settings, at3) {
        return this.#filling.map(settings, async ({ header, numbers }) => {
          this.#settings = settings;
          showSettings(this, this.#facts?.controls ?? [], settings);
          const { axes, rows, columns, why } = header;
          this.#draw({ axes, rows, columns, why, values: numbers });
          await frame();
          waited("carts:map", at3);
        });
      }
      #take(numbers) {
        if (!this.#grid) return;
        const half = numbers.length / 2;
        for (let k = 0; k < half; k += 1) {
          this.#grid.values[Number(numbers[k])] = Number(numbers[half + k]);
        }
        this.#draw(this.#grid);
      }
      #draw(grid) {
        const before = this.#grid?.axes;
        this.#grid = grid;
        this.#figure?.show(grid);
        if (before !== grid.axes) {
          const point = before ? this.point : null;
          this.#places = this.#axes.map((control, k) => {
            const { set, values } = control.axis;
            const wanted2 = point?.[set] ?? values[Number(this.#facts?.here[k])];
            control.show(grid.axes[k] ?? [], 0);
            return control.nearest(Number(wanted2));
          });
        }
        this.#choose(this.#places);
        if (this.querySelector(".carts-map-table[open]")) this.#fillTable();
        say(need(this, ".carts-map-why"), told(grid.why));
      }
      #choose(places) {
        if (!this.#grid) return;
        this.#places = places;
        const value = this.#valueAt(places);
        const facts = this.#facts;
        const number = valueText2(value, facts);
        const text = Number.isNaN(value) ? number : `${number} ${facts.unit}`;
        for (const [k, control] of this.#axes.entries()) {
          control.show(this.#grid.axes[k] ?? [], Number(places[k]));
          control.speak(Number(places[k]), text);
        }
        this.#figure?.mark(places, value);
        say(need(this, ".carts-map-number"), text);
      }
      #valueAt([column = 0, row = 0]) {
        return Number(this.#grid?.values[row * (this.#grid?.columns ?? 0) + column]);
      }
      #fillTable() {
        if (!this.#grid || !this.#facts) return;
        const axisText = (k, place4) => this.#axes[k]?.text(place4) ?? "";
        fillTable(need(this, ".carts-map-table table"), this.#grid, axisText, this.#facts);
      }
    };
  }

  // src/runtime/client.js
  var RESTARTS = 3;
  var Client = class extends EventTarget {
    state = "idle";
    error = null;
    #runtime = null;
    #waiting = [];
    #flying = null;
    #restarts = 0;
    #lastId = 0;
    #more = [];
    #growing = Promise.resolve();
    constructor(start) {
      super();
      this.start = start;
    }
    wake() {
      if (this.state === "idle") void this.#boot();
    }
    need(names) {
      if (this.#has(names)) return Promise.resolve();
      const needed = this.#growing.then(() => this.#grow(names));
      this.#growing = needed.catch(() => {
      });
      return needed;
    }
    #has(names) {
      return names.every((name) => this.#more.includes(name));
    }
    async #grow(names) {
      if (this.#has(names)) return;
      this.wake();
      await this.#settled();
      if (this.state === "failed") throw this.error;
      const more = [.../* @__PURE__ */ new Set([...this.#more, ...names])];
      this.#use(await this.start(more));
      this.#more = more;
      this.#become("ready");
      this.#next();
    }
    #settled() {
      if (this.state !== "starting") return Promise.resolve();
      return new Promise((resolve) => {
        this.addEventListener("state", () => resolve(this.#settled()), { once: true });
      });
    }
    ask(owner, message) {
      if (this.state === "failed") return Promise.reject(this.error);
      this.wake();
      return new Promise((resolve, reject) => {
        const settle = { resolve, reject };
        const older = this.#waiting.find((job) => job.owner === owner);
        if (older) {
          older.message = message;
          older.settle.push(settle);
        } else this.#waiting.push({ owner, message, settle: [settle] });
        this.#next();
      });
    }
    #next() {
      if (this.#flying || !this.#runtime) return;
      const job = this.#waiting.shift();
      if (!job) return;
      this.#flying = job;
      const runtime = this.#runtime;
      this.#lastId += 1;
      const sent = { ...job.message(), id: this.#lastId };
      const landed = () => {
        if (runtime !== this.#runtime || this.#flying !== job) return false;
        this.#flying = null;
        return true;
      };
      runtime.request(sent).then(
        (reply) => {
          if (!landed()) return;
          this.#restarts = 0;
          for (const { resolve } of job.settle) resolve({ ...reply, sent });
          this.#next();
        },
        (error) => {
          if (error?.reason !== "request-failed") return this.#lost(runtime, error);
          if (!landed()) return;
          for (const { reject } of job.settle) reject(error);
          this.#next();
        }
      );
    }
    async #boot() {
      const more = this.#more;
      this.#become("starting");
      try {
        const runtime = await this.start(more);
        if (more !== this.#more) return runtime.stop();
        this.#use(runtime);
        this.#become("ready");
        this.#next();
      } catch (error) {
        if (more === this.#more) this.#fail(error);
      }
    }
    #lost(runtime, reason) {
      if (runtime !== this.#runtime) return;
      this.#runtime = null;
      runtime.stop();
      this.#takeBack();
      this.#restarts += 1;
      if (this.#restarts > RESTARTS) this.#fail(reason);
      else void this.#boot();
    }
    #use(runtime) {
      const older = this.#runtime;
      runtime.onlost = (reason) => this.#lost(runtime, reason);
      this.#runtime = runtime;
      older?.stop();
      this.#takeBack();
    }
    #takeBack() {
      const job = this.#flying;
      this.#flying = null;
      if (!job) return;
      const newer = this.#waiting.find(({ owner }) => owner === job.owner);
      if (newer) newer.settle.unshift(...job.settle);
      else this.#waiting.unshift(job);
    }
    #fail(reason) {
      this.error = reason instanceof Error ? reason : new Error(String(reason ?? "the worker stopped"));
      this.#become("failed");
      for (const { settle } of this.#waiting.splice(0)) {
        for (const { reject } of settle) reject(this.error);
      }
    }
    #become(state) {
      this.state = state;
      this.dispatchEvent(new Event("state"));
    }
  };

  // src/runtime/line.js
  var PAUSES = [1e3, 2e3, 4e3];
  var AT_ONCE = 2;
  var isOnWeb = () => /^https?:$/.test(globalThis.location?.protocol ?? "");
  var isFetching = () => isOnWeb() && !globalThis.__cartsInside;
  async function areKept(addresses) {
    if (!globalThis.navigator?.serviceWorker?.controller) return false;
    const asked4 = addresses.map((one) => caches.match(one, { ignoreSearch: true }));
    return (await Promise.all(asked4).catch(() => [null])).every(Boolean);
  }
  async function persistently(ask, pauses = isOnWeb() ? PAUSES : []) {
    for (const pause of pauses) {
      try {
        return await ask();
      } catch {
        await new Promise((resolve) => setTimeout(resolve, pause));
      }
    }
    return ask();
  }
  var Line = class {
    constructor(atOnce = isFetching() ? AT_ONCE : Number.POSITIVE_INFINITY) {
      this.free = atOnce;
      this.waiting = [];
    }
    async take(task) {
      if (this.free > 0) this.free -= 1;
      else await new Promise((resolve) => this.waiting.push(() => resolve(void 0)));
      try {
        return await task();
      } finally {
        const next = this.waiting.shift();
        if (next) next();
        else this.free += 1;
      }
    }
  };

  // src/runtime/failure.js
  var MESSAGES = {
    "not-packed": tr("This page was built without Python. It shows only the runs that came with it."),
    "payload-missing": tr(
      "A file of this page is missing, so Python can't start. Copy the whole folder again."
    ),
    "payload-damaged": tr(
      "A file of this page is damaged, so Python can't start. Copy the whole folder again."
    ),
    "no-wasm": tr(
      "This browser has no WebAssembly, so Python can't start here. Try another browser."
    ),
    "wasm-refused": tr(
      "This browser, or the rules of this network, do not allow Python to start. Try another browser."
    ),
    "too-old": tr(
      "This browser is too old to run Python. Try Chrome or Edge 103, Firefox 113, Safari 16.4, or newer."
    ),
    "no-memory": tr(
      "This computer has too little memory free for Python. Close other programs and load the page again."
    ),
    "no-worker": tr("This browser has no workers, so Python can't start here. Try another browser."),
    "worker-refused": tr("This browser does not let the page start Python. Try another browser."),
    "worker-lost": tr("Python stopped. It may have run out of memory."),
    "snapshot-refused": tr("Python could not start the quick way."),
    "python-failed": tr(
      "Python could not start. Copy the whole folder again or try another browser."
    ),
    "request-failed": tr("This cannot be computed with these values."),
    stalled: tr("Python does not answer. Close other programs and load the page again."),
    stopped: tr("Python was stopped.")
  };
  var CAME_NOT = tr("The network was interrupted, or this site was renewed: load the page again.");
  var ON_WEB = {
    "payload-missing": CAME_NOT,
    "payload-damaged": CAME_NOT,
    "python-failed": tr("Python could not start. Load the page again, or try another browser.")
  };
  var told3 = (reason) => isOnWeb() && ON_WEB[reason] || MESSAGES[reason];
  var RuntimeFailure = class extends Error {
    constructor(reason, detail = "", file = "") {
      super(told3(reason) ?? told3("python-failed"));
      this.name = "RuntimeFailure";
      this.reason = reason;
      this.detail = detail;
      this.file = file;
    }
  };

  // src/runtime/leaving.js
  var STAYS = 3e3;
  var leaving = false;
  var waiting = [];
  function stay() {
    leaving = false;
    for (const go of waiting) go();
    waiting = [];
  }
  addEventListener("beforeunload", () => {
    leaving = true;
    setTimeout(stay, STAYS);
  });
  addEventListener("pagehide", () => {
    leaving = true;
  });
  addEventListener("pageshow", stay);
  if (navigator.userAgent.includes("Firefox/")) addEventListener("unload", () => {
  });
  var isLeaving = () => leaving;
  function staying() {
    return leaving ? new Promise((resolve) => waiting.push(resolve)) : Promise.resolve();
  }

  // src/runtime/watch.js
  var SECOND = 1e3;
  var SLOW_AFTER = 3;
  var PATIENCE = 8;
  var AT_WORK = 60;
  var LOST = 60;
  var HELD = 180;
  function watch(patience, late) {
    let [left2, spent] = [patience, 0];
    const timer = setInterval(() => {
      left2 -= 1;
      spent += 1;
      if (left2 > 0) return;
      clearInterval(timer);
      late();
    }, SECOND);
    return {
      get spent() {
        return spent;
      },
      progress() {
        left2 = patience;
      },
      stop() {
        clearInterval(timer);
      }
    };
  }

  // src/runtime/payload.js
  var page = self;
  var indexes = /* @__PURE__ */ new Map();
  var runScript = (src, name) => persistently(() => runOnce(src, name));
  function runOnce(src, name) {
    return new Promise((resolve, reject) => {
      const script = document.createElement("script");
      script.src = src;
      script.async = true;
      const missing = () => reject(new RuntimeFailure("payload-missing", src, name));
      const settle = (then) => () => {
        held?.stop();
        script.remove();
        then();
      };
      const held = isOnWeb() ? watch(HELD, settle(missing)) : null;
      script.onload = settle(resolve);
      script.onerror = settle(() => {
        if (isLeaving()) staying().then(() => runOnce(src, name).then(resolve, reject));
        else missing();
      });
      document.head.append(script);
    });
  }
  function indexOf(base) {
    return new URL(`index.js${new URL(base).search}`, base).href;
  }
  function patiently(promise) {
    if (isOnWeb()) return promise;
    return new Promise((resolve, reject) => {
      const waiting2 = watch(PATIENCE, () => reject(new RuntimeFailure("stalled", "index.js")));
      promise.then(resolve, reject).finally(waiting2.stop);
    });
  }
  function loadIndex(base) {
    const known2 = indexes.get(base);
    if (known2) return known2;
    const inside2 = Boolean(page.__cartsInside);
    const read = inside2 ? Promise.resolve() : patiently(runScript(indexOf(base), "index.js"));
    const loading = read.then(() => {
      const index = page.__cartsRuntime;
      if (!inside2) delete page.__cartsRuntime;
      if (!index) throw new RuntimeFailure("payload-damaged", "index.js", "index.js");
      if (!index.files) throw new RuntimeFailure("not-packed", index.missing);
      return index;
    });
    loading.catch(() => indexes.delete(base));
    indexes.set(base, loading);
    return loading;
  }
  async function loadPart(base, name, number, part) {
    const address = new URL(part.src, base);
    try {
      return await checkedPart(address.href, name, number, part);
    } catch (error) {
      const damaged = error instanceof RuntimeFailure && error.reason === "payload-damaged";
      if (!damaged || !isFetching()) throw error;
      address.searchParams.set("again", "1");
      return checkedPart(address.href, name, number, part);
    }
  }
  async function checkedPart(address, name, number, part) {
    const inside2 = Boolean(page.__cartsInside);
    if (!inside2) await runScript(address, name);
    const key = `${name}.${number}`;
    const text = page.__cartsParts?.[key];
    if (text === void 0) throw new RuntimeFailure("payload-damaged", part.src, name);
    if (!inside2) delete page.__cartsParts[key];
    const bytes = decode(text, part.src, name);
    if (bytes.length !== part.size || !await matches(bytes, part.sha256)) {
      throw new RuntimeFailure("payload-damaged", part.src, name);
    }
    return bytes;
  }
  function decode(text, src, name) {
    try {
      const fast = Uint8Array;
      return fast.fromBase64 ? fast.fromBase64(text) : Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    } catch {
      throw new RuntimeFailure("payload-damaged", src, name);
    }
  }
  async function matches(bytes, sha256) {
    if (!globalThis.crypto?.subtle) return true;
    const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
    return [...digest].map((byte) => byte.toString(16).padStart(2, "0")).join("") === sha256;
  }
  async function gunzip(parts2) {
    const zip = new DecompressionStream("gzip");
    const writer = zip.writable.getWriter();
    const written2 = Promise.all([...parts2.map((part) => writer.write(part)), writer.close()]);
    const [bytes] = await Promise.all([new Response(zip.readable).arrayBuffer(), written2]);
    return bytes;
  }

  // as-text:src/runtime/unpacker.js
  var unpacker_default = '"use strict";\n(() => {\n  // src/runtime/unpacker.js\n  var writers = /* @__PURE__ */ new Map();\n  function begin(name) {\n    const zip = new DecompressionStream("gzip");\n    const tell = (bytes) => self.postMessage({ name, bytes }, { transfer: [bytes] });\n    const damaged = (error) => self.postMessage({ name, error: String(error) });\n    new Response(zip.readable).arrayBuffer().then(tell, damaged);\n    return zip.writable.getWriter();\n  }\n  self.onmessage = ({ data: { name, bytes, last } }) => {\n    const writer = writers.get(name) ?? begin(name);\n    writers.set(name, writer);\n    writer.write(bytes).catch(() => {\n    });\n    if (last) writer.close().catch(() => {\n    });\n  };\n})();\n';

  // src/runtime/unpack.js
  function workerOf(texts) {
    const address = URL.createObjectURL(new Blob(texts, { type: "text/javascript" }));
    try {
      return { worker: new Worker(address), address };
    } catch (error) {
      throw new RuntimeFailure("worker-refused", String(error));
    }
  }
  var Unpacker = class {
    constructor(reject) {
      const { worker, address } = workerOf([unpacker_default]);
      this.worker = worker;
      this.address = address;
      this.waiting = /* @__PURE__ */ new Map();
      worker.onmessage = ({ data }) => {
        if (data.bytes) this.waiting.get(data.name)?.(data.bytes);
        else reject(new RuntimeFailure("payload-damaged", data.error, data.name));
      };
      worker.onerror = (event) => {
        event.preventDefault();
        reject(new RuntimeFailure("worker-refused", event.message));
      };
    }
    async unpack(name, parts2) {
      const unpacked = new Promise((resolve) => this.waiting.set(name, resolve));
      for (const [number, part] of parts2.entries()) {
        const bytes = await part;
        this.worker.postMessage({ name, bytes, last: number === parts2.length - 1 }, [bytes.buffer]);
      }
      return unpacked;
    }
    stop() {
      this.worker.terminate();
      URL.revokeObjectURL(this.address);
    }
  };

  // src/runtime/memory.js
  var isOutOfMemory = (error) => error instanceof RangeError || /memory|allocat/i.test(String(error));

  // src/runtime/wasm.js
  var NOTHING = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0]);
  function requireWasm() {
    if (typeof WebAssembly !== "object") throw new RuntimeFailure("no-wasm");
    try {
      new WebAssembly.Module(NOTHING);
    } catch (error) {
      const old = !("findLast" in Array.prototype);
      throw new RuntimeFailure(old ? "too-old" : "wasm-refused", String(error));
    }
  }
  function compileFailure(error) {
    const reason = isOutOfMemory(error) ? "no-memory" : "too-old";
    return new RuntimeFailure(reason, String(error), "pyodide.asm.wasm");
  }
  async function compile(parts2) {
    const zip = new DecompressionStream("gzip");
    const headers = { "Content-Type": "application/wasm" };
    const compiled = WebAssembly.compileStreaming(new Response(zip.readable, { headers }));
    const written2 = write(zip.writable.getWriter(), parts2);
    const [module] = await Promise.all([compiled, written2]);
    return module;
  }
  async function write(writer, parts2) {
    for (const part of parts2) await writer.write(await part);
    await writer.close();
  }

  // as-text:src/runtime/worker.js
  var worker_default = '"use strict";\n(() => {\n  // src/runtime/memory.js\n  var isOutOfMemory = (error) => error instanceof RangeError || /memory|allocat/i.test(String(error));\n  var isNotAllocated = (error) => error instanceof RangeError && /memory|allocat/i.test(error.message);\n\n  // src/runtime/picture.js\n  function putPicture(memory, picture) {\n    const words = new Uint32Array(picture.buffer, picture.byteOffset, picture.byteLength >> 2);\n    const [size, filled, sum, count] = words;\n    if (memory.length !== size) throw new Error(`${memory.length} bytes of memory, not ${size}`);\n    const stretches = words.subarray(4, 4 + 2 * count);\n    if (sumBetween(memory, stretches, filled) !== sum) throw new Error("another machine code");\n    let from = 4 * (4 + 2 * count);\n    let last = filled;\n    for (let i = 0; i < stretches.length; i += 2) {\n      const [start, end] = stretches.subarray(i, i + 2);\n      if (start > last) memory.fill(0, last, start);\n      memory.set(picture.subarray(from, from + end - start), start);\n      from += end - start;\n      last = Math.max(last, end);\n    }\n  }\n  function sumBetween(memory, stretches, filled) {\n    const words = new Uint32Array(memory.buffer, memory.byteOffset, memory.byteLength >> 2);\n    let sum = 0;\n    let at = 0;\n    for (let i = 0; i <= stretches.length && at < filled; i += 2) {\n      const start = Math.min(stretches[i] ?? filled, filled);\n      for (let word = at >> 2; word < start >> 2; word += 1) sum = sum + words[word] >>> 0;\n      at = stretches[i + 1] ?? filled;\n    }\n    return sum;\n  }\n\n  // src/runtime/wheel.js\n  var END = 101010256;\n  var ENTRY = 33639248;\n  var END_BYTES = 22;\n  var ENTRY_BYTES = 46;\n  var LOCAL_BYTES = 30;\n  function entries(archive) {\n    const view = new DataView(archive.buffer, archive.byteOffset, archive.byteLength);\n    const end = archive.length - END_BYTES;\n    if (end < 0 || view.getUint32(end, true) !== END) return null;\n    const found = /* @__PURE__ */ new Map();\n    const text = new TextDecoder();\n    let at = view.getUint32(end + 16, true);\n    for (let left = view.getUint16(end + 10, true); left > 0; left -= 1) {\n      if (view.getUint32(at, true) !== ENTRY || view.getUint16(at + 10, true) !== 0) return null;\n      const [name, extra, comment] = [28, 30, 32].map((place) => view.getUint16(at + place, true));\n      const local = view.getUint32(at + 42, true);\n      const skipped = view.getUint16(local + 26, true) + view.getUint16(local + 28, true);\n      const from = local + LOCAL_BYTES + skipped;\n      const bytes = archive.subarray(from, from + view.getUint32(at + 24, true));\n      found.set(text.decode(archive.subarray(at + ENTRY_BYTES, at + ENTRY_BYTES + name)), bytes);\n      at += ENTRY_BYTES + name + extra + comment;\n    }\n    return found;\n  }\n  function unpackByOurselves(python2) {\n    const api = python2._api;\n    const usual = api.package_loader;\n    const unpack = (given) => {\n      const { buffer, extract_dir } = given;\n      const files2 = entries(buffer);\n      if (!files2) return usual.unpack_buffer.callKwargs(given);\n      const folder = String(extract_dir);\n      const made = /* @__PURE__ */ new Set();\n      for (const [name, bytes] of files2) {\n        const path = `${folder}/${name}`;\n        const parent = path.slice(0, path.lastIndexOf("/"));\n        if (!made.has(parent)) python2.FS.mkdirTree(parent);\n        made.add(parent);\n        python2.FS.writeFile(path, bytes, { canOwn: true });\n      }\n      return [...files2.keys()].filter((name) => name.endsWith(".so")).map((name) => `${folder}/${name}`);\n    };\n    api.package_loader = {\n      get_install_dir: (where) => usual.get_install_dir(where),\n      unpack_buffer: { callKwargs: unpack }\n    };\n  }\n\n  // src/runtime/worker.js\n  var scope = self;\n  var BASE = "https://runtime.invalid/";\n  var WASM = "pyodide.asm.wasm";\n  var STDLIB = "python.zip";\n  var SNAPSHOT = "memory.snapshot";\n  var MORE = "python-more.zip";\n  var stdlib;\n  var files = /* @__PURE__ */ new Map();\n  var python;\n  var answer;\n  var current = 0;\n  var seen = Number.NEGATIVE_INFINITY;\n  var tell = (message, transfer = []) => scope.postMessage(message, transfer);\n  var fail = (reason, error, name = "") => tell({ tell: "failed", reason, detail: String(error), file: name });\n  var progress = (stage) => tell({ tell: "progress", stage });\n  function file(name) {\n    const known = files.get(name);\n    if (known) return known;\n    let take = (_) => {\n    };\n    const come = new Promise((resolve) => {\n      take = resolve;\n    });\n    const made = { come, take };\n    files.set(name, made);\n    return made;\n  }\n  var bytesOf = (name) => file(name).come;\n  scope.fetch = async (address) => {\n    const name = String(address).split("/").pop() ?? "";\n    if (name === WASM) return new Response();\n    if (name === STDLIB) return stdlib;\n    return new Response(await bytesOf(name));\n  };\n  async function wholeStdlib(tableAt) {\n    if (!tableAt) return new Response(await bytesOf(STDLIB));\n    const [first, more] = await Promise.all([bytesOf(STDLIB), bytesOf(MORE)]);\n    const whole = new Uint8Array(tableAt + more.length);\n    whole.set(first.subarray(0, tableAt));\n    whole.set(more, tableAt);\n    return new Response(whole);\n  }\n  var giveWasm = () => {\n  };\n  var wasm = new Promise((resolve) => {\n    giveWasm = resolve;\n  });\n  function useCompiledWasm() {\n    const api = WebAssembly;\n    api.instantiateStreaming = async (_, imports) => {\n      const module = await wasm;\n      try {\n        return { module, instance: await WebAssembly.instantiate(module, imports) };\n      } catch (error) {\n        fail(isOutOfMemory(error) ? "no-memory" : "too-old", error);\n        throw error;\n      }\n    };\n  }\n  scope.addEventListener("unhandledrejection", ({ reason }) => {\n    if (isNotAllocated(reason)) fail("no-memory", reason);\n  });\n  async function boot({ lock, snapshot, tableAt, load, modules, entry }) {\n    try {\n      useCompiledWasm();\n      stdlib = wholeStdlib(tableAt);\n      const { loadPyodide, createPyodideModule } = scope.__pyodide;\n      python = await loadPyodide({\n        indexURL: BASE,\n        packageBaseUrl: BASE,\n        stdLibURL: BASE + STDLIB,\n        lockFileContents: lock,\n        createPyodideModule,\n        _loadSnapshot: snapshot ? bytesOf(SNAPSHOT) : void 0,\n        _putPicture: putPicture,\n        args: [],\n        env: { HOME: "/home/pyodide" }\n      });\n      python._api.config._loadSnapshot = void 0;\n      progress("python");\n      if (snapshot) reseed();\n      tellOfImports();\n    } catch (error) {\n      if (isNotAllocated(error)) return fail("no-memory", error);\n      return fail(snapshot ? "snapshot-refused" : "python-failed", error);\n    }\n    try {\n      if (load.length) await loadPackages(load);\n      for (const name of modules) {\n        importIfPossible(name);\n        progress(name);\n      }\n      const module = python.pyimport(entry);\n      module.listen?.(alive);\n      answer = module.answer;\n    } catch (error) {\n      return fail("python-failed", error);\n    }\n    files.clear();\n    return tell({ tell: "ready", start: snapshot ? "snapshot" : "plain" });\n  }\n  function reseed() {\n    python.runPython(`\nimport sys\nif "random" in sys.modules:\n    sys.modules["random"].seed()\n`);\n  }\n  function alive() {\n    if (performance.now() - seen < 1e3) return;\n    seen = performance.now();\n    if (current) tell({ tell: "alive", number: current });\n    else progress("packages");\n  }\n  function tellOfImports() {\n    const locals = python.toPy({ alive });\n    python.runPython(\n      `\nimport sys\nclass Alive:\n    @staticmethod\n    def find_spec(name, path=None, target=None, alive=alive):\n        alive()\nsys.meta_path.insert(0, Alive)\n`,\n      { globals: locals }\n    );\n  }\n  async function loadPackages(names) {\n    unpackByOurselves(python);\n    const alive2 = setInterval(() => progress("packages"), 1e3);\n    try {\n      await python.loadPackage(names, { messageCallback: () => {\n      } });\n    } finally {\n      clearInterval(alive2);\n    }\n    progress("packages");\n  }\n  function importIfPossible(name) {\n    try {\n      python.pyimport(name).destroy();\n    } catch (error) {\n      if (\n        /** @type {any} */\n        error?.type !== "ModuleNotFoundError"\n      ) throw error;\n    }\n  }\n  function respond({ number, text }) {\n    tell({ tell: "begun", number });\n    current = number;\n    try {\n      const [header, numbers] = answer(text);\n      tell({ tell: "answer", number, header, numbers }, [numbers.buffer]);\n    } catch (error) {\n      tell({ tell: "broken", number, detail: String(error), dead: isDead() });\n    }\n  }\n  function isDead() {\n    try {\n      return python.runPython("1") !== 1;\n    } catch {\n      return true;\n    }\n  }\n  scope.onmessage = ({ data }) => {\n    if (data.do === "boot") boot(data);\n    else if (data.do === "file") file(data.name).take(new Uint8Array(data.bytes));\n    else if (data.do === "wasm") giveWasm(data.module);\n    else if (data.do === "request") respond(data);\n  };\n  tell({ tell: "hello" });\n})();\n';

  // src/runtime/start.js
  var SLOW3 = "slow";
  var SLOW_LINE = "slow-line";
  var SNAPSHOT = "memory.snapshot";
  var LOADER = "pyodide.js";
  var WASM = "pyodide.asm.wasm";
  var STDLIB = "python.zip";
  var MORE = "python-more.zip";
  async function slowStage(files, folder) {
    const kept = !isFetching() || await areKept(files.map((file) => new URL(file, folder)));
    return kept ? SLOW3 : SLOW_LINE;
  }
  var modules = /* @__PURE__ */ new Map();
  var Start = class {
    constructor({ folder, index, packages: packages2, onProgress, patience = LOST }, snapshot) {
      this.folder = folder;
      this.index = index;
      this.packages = packages2;
      this.onProgress = onProgress;
      this.patience = patience;
      this.snapshot = snapshot;
      this.worker = null;
      this.unpacker = null;
      this.over = false;
      this.line = new Line();
      this.done = 0;
      this.names = this.files();
      this.total = this.names.flatMap((name) => index.files[name].parts).reduce((sum, part) => sum + part.size, 0);
    }
    files() {
      const { index, packages: packages2, snapshot } = this;
      const names = modules.has(this.folder) ? [LOADER] : [LOADER, WASM];
      if (snapshot) names.push(SNAPSHOT);
      names.push(STDLIB);
      if (packages2.length && index.tableAt) names.push(MORE);
      names.push(...this.toLoad().map((name) => index.wheels[name]));
      if (names.every((name) => name in index.files)) return names;
      throw new RuntimeFailure("not-packed", index.missing || packages2.join());
    }
    toLoad() {
      const { index, packages: packages2, snapshot } = this;
      if (!snapshot) return [index.package, ...packages2];
      return packages2.length && index.later.length ? [index.rest, ...packages2] : packages2;
    }
    async run() {
      let reject = () => {
      };
      const failed = new Promise((_2, no) => {
        reject = no;
      });
      this.giveUp = () => reject(new RuntimeFailure("stalled"));
      this.guard();
      try {
        const unpacker = new Unpacker(reject);
        this.unpacker = unpacker;
        return await Promise.race([failed, this.boot(unpacker, reject)]);
      } catch (error) {
        this.worker?.terminate();
        throw error;
      } finally {
        this.over = true;
        this.slow?.stop();
        this.watch?.stop();
        this.unpacker?.stop();
      }
    }
    load(name, reject) {
      return this.index.files[name].parts.map(async (part, number) => {
        try {
          const bytes = await this.line.take(async () => {
            if (this.over) throw new RuntimeFailure("stopped");
            return loadPart(this.folder, name, number, part);
          });
          this.done += part.size;
          if (!this.over && this.done === this.total && isFetching()) this.guard();
          this.progress(name);
          return bytes;
        } catch (error) {
          reject(error);
          return new Promise(() => {
          });
        }
      });
    }
    guard() {
      this.slow?.stop();
      const loading = isFetching() && this.done < this.total;
      this.slow = watch(SLOW_AFTER, async () => {
        const parts2 = this.names.flatMap((name) => this.index.files[name].parts);
        const stage = loading ? await slowStage(
          parts2.map((part) => part.src),
          this.folder
        ) : SLOW3;
        if (!this.over) this.onProgress({ fraction: this.fraction, stage });
      });
      if (!loading) this.watch = watch(this.patience, () => this.giveUp?.());
    }
    progress(stage) {
      if (this.over) return;
      this.slow?.progress();
      this.watch?.progress();
      this.onProgress({ fraction: this.fraction, stage });
    }
    get fraction() {
      return 0.9 * this.done / this.total;
    }
    async boot(unpacker, reject) {
      const load = (name) => this.load(name, reject);
      const loading = load(LOADER);
      await Promise.all(loading);
      const compiling = this.module(this.names.includes(WASM) ? load(WASM) : []);
      compiling.catch((error) => reject(compileFailure(error)));
      const rest = this.names.filter((name) => name !== LOADER && name !== WASM);
      const files = rest.map((name) => ({ name, unpacked: unpacker.unpack(name, load(name)) }));
      const loader = await gunzip(await Promise.all(loading));
      if (this.over) return null;
      const { worker, address } = workerOf([loader, worker_default]);
      this.worker = worker;
      const ready = new Promise((resolve) => {
        worker.onmessage = ({ data }) => {
          if (data.tell === "hello") URL.revokeObjectURL(address);
          else if (data.tell === "ready") resolve(data);
          else if (data.tell === "failed") {
            reject(new RuntimeFailure(data.reason, data.detail, data.file));
          }
          this.progress(data.stage ?? data.tell);
        };
        worker.onerror = (event) => {
          event.preventDefault();
          reject(new RuntimeFailure("worker-refused", event.message));
        };
      });
      const { index, packages: packages2, snapshot } = this;
      worker.postMessage({
        do: "boot",
        lock: index.lock,
        entry: index.entry,
        snapshot,
        tableAt: packages2.length ? index.tableAt : 0,
        load: this.toLoad(),
        modules: packages2.length ? [...packages2, ...index.later] : []
      });
      for (const { name, unpacked } of files) {
        unpacked.then((bytes) => worker.postMessage({ do: "file", name, bytes }, [bytes]));
      }
      worker.postMessage({ do: "wasm", module: await compiling });
      this.progress(WASM);
      const { start } = await ready;
      this.onProgress({ fraction: 1, stage: "ready" });
      return { worker, start };
    }
    async module(parts2) {
      const module = modules.get(this.folder) ?? await compile(parts2);
      modules.set(this.folder, module);
      return module;
    }
  };

  // src/runtime/runtime.js
  var PICK_UP = 3;
  var LONG = ["certify", "class", "cost", "hard", "law", "measured", "relevance", "teach"];
  async function startRuntime({ base, packages: packages2 = [], patience, onProgress = () => {
  } }) {
    requireWasm();
    if (typeof Worker !== "function") throw new RuntimeFailure("no-worker");
    if (typeof DecompressionStream !== "function") throw new RuntimeFailure("too-old");
    const folder = new URL(base, document.baseURI).href;
    let read = false;
    const late = watch(SLOW_AFTER, async () => {
      const stage = await slowStage(["index.js"], folder);
      if (!read) onProgress({ fraction: 0, stage });
    });
    const index = await loadIndex(folder).finally(late.stop);
    read = true;
    const options = { folder, index, packages: order(packages2), onProgress, patience };
    const start = (snapshot) => new Start(options, snapshot).run();
    if (!(SNAPSHOT in index.files)) return new Runtime(await start(false));
    try {
      return new Runtime(await start(true));
    } catch (error) {
      if (!(error instanceof RuntimeFailure) || !snapshotIsToBlame(error)) throw error;
      console.warn(`Python starts the plain way: ${error.reason} ${error.detail}`);
      return new Runtime(await start(false));
    }
  }
  var snapshotIsToBlame = ({ reason, file }) => reason === "snapshot-refused" || file === SNAPSHOT;
  var order = (packages2) => [
    ...new Set(packages2.flatMap((name) => name === "scipy" ? ["numpy", "scipy"] : [name]))
  ];
  var Runtime = class {
    constructor({ worker, start }) {
      this.start = start;
      this.onlost = () => {
      };
      this.worker = worker;
      this.gone = "";
      this.number = 0;
      this.queue = [];
      worker.onmessage = ({ data }) => this.hear(data);
      worker.onerror = (event) => {
        event.preventDefault();
        this.lose("worker-lost", event.message);
      };
    }
    request(message) {
      if (this.gone) return Promise.reject(new RuntimeFailure(this.gone));
      return new Promise((resolve, reject) => {
        this.number += 1;
        const patience = LONG.includes(String(message.kind)) ? AT_WORK : PATIENCE;
        const text = JSON.stringify(message);
        this.queue.push({ number: this.number, text, patience, resolve, reject });
        if (this.queue.length === 1) this.send();
      });
    }
    stop() {
      this.end("stopped", "");
    }
    send() {
      const next = this.queue[0];
      if (!next) return;
      this.watch = watch(PICK_UP, () => this.lose("worker-lost", "no sign of life"));
      this.worker.postMessage({ do: "request", number: next.number, text: next.text });
    }
    hear(data) {
      const current = this.queue[0];
      if (!current || data.number !== current.number) return;
      if (data.tell === "alive") return void this.watch?.progress();
      this.watch?.stop();
      if (data.tell === "begun") {
        const { patience } = current;
        this.watch = watch(patience - PICK_UP, () => this.lose("worker-lost", "no answer"));
        return;
      }
      this.queue.shift();
      if (data.tell === "answer") {
        current.resolve({ header: JSON.parse(data.header), numbers: data.numbers });
      } else {
        current.reject(new RuntimeFailure(data.dead ? "worker-lost" : "request-failed", data.detail));
        if (data.dead) this.lose("worker-lost", data.detail);
      }
      if (!this.gone) this.send();
    }
    lose(reason, detail) {
      if (this.end(reason, detail)) this.onlost(new RuntimeFailure(reason, detail));
    }
    end(reason, detail) {
      if (this.gone) return false;
      this.gone = reason;
      this.watch?.stop();
      this.worker.terminate();
      for (const { reject } of this.queue.splice(0)) reject(new RuntimeFailure(reason, detail));
      return true;
    }
  };

  // src/runtime/page-python.js
  function pagePython(packages2) {
    const base = besideScript("runtime/");
    const onProgress = ({ stage }) => {
      if (stage === SLOW3 || stage === SLOW_LINE) client2.dispatchEvent(new Event(stage));
    };
    const client2 = new Client(
      (more) => startRuntime({ base, packages: [...packages2(), ...more], onProgress })
    );
    client2.addEventListener("state", () => tell(client2.state));
    return client2;
  }
  function besideScript(folder) {
    const script = document.currentScript;
    const own = new URL(script?.src || document.baseURI);
    return new URL(`${folder}${own.search}`, own).href;
  }
  function startWhenIdle(client2) {
    tell("starting");
    if (typeof requestIdleCallback === "function") {
      requestIdleCallback(() => client2.wake(), { timeout: 1e3 });
    } else setTimeout(() => client2.wake(), 200);
  }
  function tell(state) {
    document.documentElement.dataset.python = state;
  }

  // ../view/words.js
  var QUANTITIES = {
    x: [tr("Position"), "x", "m"],
    v: [tr("Velocity"), "v", "m/s"],
    a: [tr("Acceleration"), "a", "m/s²"],
    F: [tr("Contact force"), "F", "N"],
    R: [tr("Resultant force"), "R", "N"],
    p: [tr("Momentum"), "p", "kg m/s"],
    energy: [tr("Kinetic energy"), "E", "J"]
  };
  var APART2 = "apart";
  var IMPULSE_ONLY = tr("too large and too short to draw: see the impulses under “What happens”");
  var JUMP_ONLY = tr("where v jumps, the acceleration is too large and too short to draw");
  function motion(velocity3, decimals, scale) {
    if (isRest(velocity3, scale)) return tr("at rest");
    const [per, unit] = speedUnit(scale);
    const speed = `${fixed(Math.abs(velocity3) / per, decimals)} ${unit}`;
    return velocity3 > 0 ? tr("{speed} to the right", { speed }) : tr("{speed} to the left", { speed });
  }
  function lawsOf(header) {
    const laws = Object.fromEntries(header.contacts.map(({ pair, law }) => [pair, law]));
    for (const bodies of pairsApart(header)) laws[bodies.join("-")] = APART2;
    return laws;
  }
  function bareOf({ bodies, contacts }) {
    const sprung = bodies.filter((one) => one.bumper_length > 0).map(({ name }) => name);
    const bare = contacts.filter((contact) => !contact.bodies.some((name) => sprung.includes(name)));
    return new Set(bare.map(({ pair }) => pair));
  }
  function isRest(velocity3, scale) {
    return Math.abs(velocity3) < NOISE * scale;
  }
  function eventSentence(event, telling2, laws, bare, track) {
    const { decimals, scale, camera, forces: forces2 } = telling2;
    const names = event.bodies;
    const pair = capital(bodiesOf(names, track));
    const impulse = event.impulse ?? 0;
    const speeds = names.filter((name) => !isWall(name) && name in (event.after ?? {})).map((name) => `${name}: ${motion((event.after[name] ?? 0) - camera, decimals.v ?? 2, scale)}`);
    const after = speeds.map(ended).join(" ");
    const size = `${figures(impulse)} N s`;
    const shown3 = forces2 && impulse ? tr("Impulse on each: {size}.", { size }) : "";
    const told4 = (...sentences) => sentences.filter(Boolean).join(" ");
    switch (event.kind) {
      case "contact": {
        if (impulse && laws[names.join("-")] === "velcro") {
          return told4(tr("{pair} hit and stay together.", { pair }), shown3, after);
        }
        if (impulse && joined2(event, scale)) return told4(...hitAndGoOn(event, telling2, pair), shown3);
        if (impulse) {
          return told4(tr("{pair} hit each other and part at once.", { pair }), shown3, after);
        }
        const [mover, other] = names[0] === "left" ? [names[1], names[0]] : [names[0], names[1]];
        return tr("{mover} touches {other}.", {
          mover: String(mover),
          other: body(String(other), track)
        });
      }
      case "peak":
        return peakSentence(event, telling2, laws, bare, pair);
      case "separate": {
        if (!joined2(event, scale)) return told4(tr("{pair} separate.", { pair }), shown3, after);
        const ended3 = { pair: bodiesOf(names, track) };
        const rest = isWall(String(names[0])) || isWall(String(names.at(-1)));
        if (rest) {
          const stay2 = tr("The push between {pair} has ended; they stay together.", ended3);
          return told4(stay2, shown3, after);
        }
        return told4(pushEnded(event, telling2, ended3.pair), shown3);
      }
      case "stick":
        return told4(tr("{pair} stay together.", { pair }), after);
      case "stop":
        return names[1] ? tr("{pair} stop: the track holds them.", { pair }) : tr("{cart} stops: the track holds it.", { cart: pair });
      case "start":
        return names[1] ? tr("{pair} start to move.", { pair }) : tr("{cart} starts to move.", { cart: pair });
      case "release":
        if (impulse || !event.force) {
          return told4(tr("The exploder between {pair} releases.", { pair }), shown3, after);
        }
        return forces2 ? tr("The spring between {pair} is let go: {force} on each.", {
          pair,
          force: `${fixed(event.force, decimals.F ?? 2)} N`
        }) : tr("The spring between {pair} is let go.", { pair });
      case "end":
        return tr("End of the run.");
      default:
        return `${event.kind}: ${pair}.`;
    }
  }
  function peakSentence({ bodies, force: greatest4 }, { decimals, forces: forces2 }, laws, bare, pair) {
    const key = bodies.join("-");
    const force2 = `${fixed(greatest4 ?? 0, decimals.F ?? 2)} N`;
    if (laws[key] === APART2) {
      return forces2 ? tr("{pair} are nearest: {force} on each.", { pair, force: force2 }) : tr("{pair} are nearest.", { pair });
    }
    const told4 = forces2 && greatest4;
    if (laws[key] !== "bumper") {
      return told4 ? tr("{pair} push hardest: {force} on each.", { pair, force: force2 }) : tr("{pair} push hardest.", { pair });
    }
    if (told4) {
      return bare.has(key) ? tr("{pair}: squeezed the most, {force} on each.", { pair, force: force2 }) : tr("{pair}: bumpers squeezed the most, {force} on each.", { pair, force: force2 });
    }
    return bare.has(key) ? tr("{pair}: squeezed the most.", { pair }) : tr("{pair}: bumpers squeezed the most.", { pair });
  }
  function joined2({ bodies, after }, scale) {
    const [left2, right] = bodies.map((name) => isWall(name) ? 0 : Number(after[name]));
    return isRest(Number(left2) - Number(right), scale);
  }
  function hitAndGoOn(event, telling2, pair) {
    const how = together(event, telling2);
    return how === null ? [tr("{pair} hit and stay together, at rest.", { pair })] : [tr("{pair} hit and go on together at {velocity}.", { pair, velocity: how })];
  }
  function pushEnded(event, telling2, pair) {
    const how = together(event, telling2);
    return how === null ? tr("The push between {pair} has ended; they stay together, at rest.", { pair }) : tr("The push between {pair} has ended; they go on together at {velocity}.", {
      pair,
      velocity: how
    });
  }
  function together({ bodies, after }, { decimals, scale, camera }) {
    const cart = bodies.find((name) => !isWall(name)) ?? "";
    const seen = Number(after[cart]) - camera;
    return isRest(seen, scale) ? null : motion(seen, decimals.v ?? 2, scale);
  }
  function exitSentence({ name, side, velocity: velocity3 }, decimals, scale) {
    const [per, unit] = speedUnit(scale);
    const speed = `${fixed(Math.abs(velocity3) / per, decimals)} ${unit}`;
    return side === "right" ? tr("{name} leaves the picture on the right, still {speed}.", { name, speed }) : tr("{name} leaves the picture on the left, still {speed}.", { name, speed });
  }
  function graphNote(quantity, events, curves) {
    const struck = events.some((event) => event.kind === "contact" && event.impulse);
    if (struck && quantity === "F") return IMPULSE_ONLY;
    if (struck && (quantity === "a" || quantity === "R")) return JUMP_ONLY;
    return quantity === "F" && !curves ? tr("no contact force in this run") : "";
  }
  function lower(name) {
    return name.slice(0, 1).toLowerCase() + name.slice(1);
  }
  function capital(text) {
    return text.slice(0, 1).toUpperCase() + text.slice(1);
  }

  // src/answers/outline.js
  var found2 = null;
  function outline() {
    const text = found2 ? null : document.getElementById("carts-lesson")?.textContent;
    if (text) found2 = JSON.parse(text);
    return found2;
  }
  function itemOf(entry2) {
    const form2 = entry2?.form ?? "worksheet";
    return outline()?.items.find((item) => item.id === entry2?.id && item.form === form2) ?? null;
  }
  function placeOf(entry2) {
    if (entry2?.type === "challenge") return entry2.id;
    return entry2?.type === "found-force" ? entry2.id.replace(/-forces$/, "") : "";
  }
  function isHere(entry2) {
    const place4 = placeOf(entry2);
    return Boolean(itemOf(entry2) ?? (place4 && document.getElementById(place4)));
  }
  function isCurrent(entry2) {
    const item = itemOf(entry2);
    return !item || !entry2.hash || entry2.hash === item.hash;
  }
  function stamped(entry2) {
    const page2 = outline();
    if (!page2 || !isHere(entry2)) return entry2;
    const { form: form2 = "worksheet", hash = "" } = itemOf(entry2) ?? {};
    return { form: form2, lesson: page2.lesson, lessonHash: page2.hash, hash, ...entry2 };
  }

  // src/shared/code-word.js
  var STUDENT = "student";

  // src/answers/entry.js
  var MOST_EARLIER = 500;
  function isEmpty(value) {
    if (typeof value === "string") return !value.trim();
    if (value === null || value === void 0) return true;
    return typeof value === "object" && Object.keys(value).length === 0;
  }
  function keepEarlier(old, value) {
    if (!old || typeof old !== "object" || typeof value !== "object" || value === null) return value;
    const opened2 = old.locked && old.locked !== value.locked;
    if (opened2 && sameAnswer(old, value)) return { ...together2(old, value), locked: old.locked };
    const same = old.hash === value.hash && old.type === value.type;
    if (old.locked && !value.locked && same) {
      return withEarlier(old, old.earlier, value.earlier, alone(value));
    }
    const other = opened2 || old.hash && value.hash && old.hash !== value.hash;
    return withEarlier(value, old.earlier, value.earlier, other ? alone(old) : []);
  }
  function merged(a2, b2) {
    if (!a2) return b2;
    if (!b2) return a2;
    const [old, young] = String(a2.last ?? "") <= String(b2.last ?? "") ? [a2, b2] : [b2, a2];
    const first = [a2.first, b2.first].filter(Boolean).sort()[0] ?? null;
    if (sameAnswer(old, young)) return { ...together2(old, young), first };
    const cleared = isEmpty(young.value) && !isEmpty(old.value);
    const [loser, winner] = cleared ? [young, old] : [old, young];
    return withEarlier({ ...winner, first }, old.earlier, young.earlier, alone(loser));
  }
  function together2(old, young) {
    const said = Object.entries(young).filter(([, part]) => (part ?? "") !== "");
    const both2 = { ...young, ...old, ...Object.fromEntries(said) };
    return withEarlier(both2, old.earlier, young.earlier);
  }
  function sameAnswer(a2, b2) {
    return a2.hash === b2.hash && JSON.stringify(a2.value) === JSON.stringify(b2.value);
  }
  function alone({ earlier: _2, ...entry2 }) {
    return isEmpty(entry2.value) ? [] : [entry2];
  }
  function withEarlier(entry2, ...lists) {
    const found3 = /* @__PURE__ */ new Map();
    for (const one of lists.flatMap((list) => list ?? [])) {
      const name = JSON.stringify([one.hash, one.value]);
      const before = found3.get(name);
      found3.set(name, before ? together2(before, one) : one);
    }
    const all = [...found3.values()];
    all.sort((x2, y2) => String(x2.last ?? "").localeCompare(String(y2.last ?? "")));
    return all.length ? { ...entry2, earlier: all.slice(-MOST_EARLIER) } : entry2;
  }

  // src/shared/tab.js
  var TAB = () => sessionStorage;
  var BROWSER = () => localStorage;
  function recall(key, where = TAB) {
    try {
      return JSON.parse(where().getItem(key) ?? "null");
    } catch {
      return null;
    }
  }
  function retain(key, value, where = TAB) {
    try {
      where().setItem(key, JSON.stringify(value));
    } catch {
    }
  }

  // src/store/text-store.js
  var beginning = (site) => `carts:${site}:`;
  function textStore(site) {
    try {
      localStorage.setItem(`${beginning(site)}probe`, "1");
      localStorage.removeItem(`${beginning(site)}probe`);
    } catch {
      return null;
    }
    return keptAsText(site);
  }
  function keptAsText(site) {
    const before = beginning(site);
    const get = (key) => {
      try {
        return JSON.parse(localStorage.getItem(before + key) ?? "null");
      } catch {
        return null;
      }
    };
    return {
      kind: "kept",
      how: "text",
      get: async (key) => get(key),
      put: async (key, value) => localStorage.setItem(before + key, JSON.stringify(keepEarlier(get(key), value))),
      remove: async (key) => localStorage.removeItem(before + key),
      entries: async () => Object.keys(localStorage).filter((name) => name.startsWith(before)).map((name) => [name.slice(before.length), get(name.slice(before.length))])
    };
  }

  // src/store/brought-over.js
  var PATIENCE2 = 5e3;
  var marked = (site) => `carts-database:${site}`;
  async function takeTexts(store, site) {
    void remember(store, site);
    const texts = keptAsText(site);
    const found3 = await texts.entries().catch(() => []);
    if (found3.length === 0) return;
    const take = () => takeOver(store, texts).catch(() => {
    });
    const taken = Promise.resolve(navigator.locks?.request(`carts-texts:${site}`, take) ?? take());
    const late = new Promise((resolve) => setTimeout(resolve, PATIENCE2));
    await Promise.race([taken.catch(take), late]);
  }
  async function remember(store, site) {
    const { code = "" } = await store.get(STUDENT).catch(() => null) ?? {};
    if (recall(marked(site), BROWSER)?.code !== code) retain(marked(site), { code }, BROWSER);
  }
  async function instead(texts, site) {
    const before = recall(marked(site), BROWSER);
    if (!before) return texts;
    if (before.code && !await texts.get(STUDENT)) {
      await texts.put(STUDENT, { code: before.code, last: "" }).catch(() => {
      });
    }
    return { ...texts, behind: true };
  }
  async function takeOver(store, texts) {
    for (const [key, text] of await texts.entries()) {
      if (text === null) continue;
      const value = both(await store.get(key), text);
      if (value === null) continue;
      await store.put(key, value);
      await texts.remove(key);
    }
  }
  function both(kept, text) {
    if (kept === void 0 || kept === null) return text;
    if ("type" in Object(kept) && "type" in Object(text)) return merged(kept, text);
    if (!("last" in Object(kept) && "last" in Object(text))) return null;
    return String(kept.last) > String(text.last) ? kept : text;
  }

  // src/store/newest-first.js
  var GONE = /* @__PURE__ */ Symbol("forgotten");
  function newestFirst(put2) {
    const flights = /* @__PURE__ */ new Map();
    function start(key, value, alone3) {
      const now = put2(key, value, alone3);
      flights.set(key, { now, next: null });
      const over = () => {
        if (flights.get(key)?.now === now && !flights.get(key)?.next) flights.delete(key);
      };
      now.then(over, over);
      return now;
    }
    return (key, value, alone3 = false) => {
      const flight = flights.get(key);
      if (!flight) return start(key, value, alone3);
      if (flight.next) {
        flight.next.value = value;
        flight.next.alone &&= alone3;
        flight.next.anew ||= value === GONE;
        return flight.next.written;
      }
      const next = { value, alone: alone3, anew: value === GONE, written: Promise.resolve() };
      const begin = () => start(key, next.value, next.alone || next.anew);
      next.written = flight.now.then(begin, begin);
      flight.next = next;
      return next.written;
    };
  }

  // src/store/indexed-store.js
  var SETTLED = "settled";
  var STORE = "answers";
  var PATIENCE3 = 2e4;
  var SETTLE_AFTER = 400;
  function open(name) {
    return new Promise((resolve, reject) => {
      const request = indexedDB.open(name, 1);
      request.onupgradeneeded = () => request.result.createObjectStore(STORE);
      request.onsuccess = () => {
        request.result.onversionchange = () => request.result.close();
        resolve(request.result);
      };
      request.onerror = () => reject(request.error);
      request.onblocked = () => reject(new Error("another page holds an older version"));
      setTimeout(() => reject(new Error("no answer")), PATIENCE3);
    });
  }
  async function reopening(name) {
    let base = await open(name);
    return async (mode, durability = "relaxed") => {
      try {
        return base.transaction(STORE, mode, { durability });
      } catch {
        base = await open(name);
        return base.transaction(STORE, mode, { durability });
      }
    };
  }
  async function indexed(name) {
    const begin = await reopening(name);
    const read = async (ask) => answered(ask((await begin("readonly")).objectStore(STORE)));
    const put2 = newestFirst(
      (key, value, alone3) => write2(begin, (answers) => {
        if (value === GONE) answers.delete(key);
        else if (alone3) {
          answers.put(value, key);
          answers.transaction.commit();
        } else {
          const request = answers.get(key);
          request.onsuccess = () => answers.put(keepEarlier(request.result, value), key);
        }
      })
    );
    return {
      kind: "kept",
      how: "indexed",
      get: (key) => read((answers) => answers.get(key)),
      put: put2,
      remove: (key) => put2(key, GONE),
      entries: async () => {
        const answers = (await begin("readonly")).objectStore(STORE);
        const [keys, values] = await Promise.all([
          answered(answers.getAllKeys()),
          answered(answers.getAll())
        ]);
        return keys.map((key, k) => [String(key), values[k]]);
      }
    };
  }
  function answered(request) {
    return new Promise((resolve, reject) => {
      request.onsuccess = () => resolve(request.result);
      request.onerror = () => reject(request.error);
    });
  }
  var settling;
  async function write2(begin, act) {
    await transaction(begin, act, "relaxed");
    clearTimeout(settling);
    settling = setTimeout(() => {
      const mark2 = (answers) => void answers.put(Date.now(), SETTLED);
      transaction(begin, mark2, "strict").catch(() => {
      });
    }, SETTLE_AFTER);
  }
  async function transaction(begin, act, durability) {
    const work = await begin("readwrite", durability);
    return new Promise((resolve, reject) => {
      act(work.objectStore(STORE));
      work.oncomplete = () => resolve();
      work.onerror = () => reject(work.error);
      work.onabort = () => reject(work.error);
    });
  }

  // src/store/shelter.js
  function shelter(site) {
    const page2 = globalThis;
    const name = /* @__PURE__ */ Symbol.for(`carts-shelter:${site}`);
    page2[name] ??= /* @__PURE__ */ new Map();
    return page2[name];
  }
  function sheltered(store, site) {
    const refused = shelter(site);
    return {
      ...store,
      put: async (key, value, alone3) => {
        try {
          await store.put(key, value, alone3);
          refused.delete(key);
        } catch (error) {
          refused.set(key, keepEarlier(refused.get(key), value));
          throw error;
        }
      },
      remove: async (key) => {
        refused.delete(key);
        await store.remove(key);
      },
      entries: async () => [...new Map([...await store.entries(), ...refused])]
    };
  }
  function memory(site) {
    const kept = shelter(site);
    return {
      kind: "memory",
      how: "memory",
      get: async (key) => kept.get(key),
      put: async (key, value) => void kept.set(key, keepEarlier(kept.get(key), value)),
      remove: async (key) => void kept.delete(key),
      entries: async () => [...kept]
    };
  }

  // src/store/staying.js
  var asked2 = false;
  function letItStay() {
    const storage = navigator.storage;
    if (asked2 || !storage?.persist || location.protocol === "file:") return;
    if (CSS.supports("-moz-appearance", "none")) return;
    asked2 = true;
    storage.persist().catch(() => {
    });
  }

  // src/store/tabs.js
  function telling(store, site) {
    const channel2 = channelOf(`carts:${site}`);
    return {
      ...store,
      student: "",
      put: async (key, value, alone3) => {
        await store.put(key, value, alone3);
        channel2?.postMessage({ key, gone: false });
      },
      remove: async (key) => {
        await store.remove(key);
        channel2?.postMessage({ key, gone: true });
      },
      hear: (act, signal) => {
        channel2?.addEventListener(
          "message",
          ({ data }) => act(String(data.key), data.gone),
          signal && { signal }
        );
      }
    };
  }
  function channelOf(name) {
    try {
      return new BroadcastChannel(name);
    } catch {
      return null;
    }
  }

  // src/store/storage.js
  var opened = /* @__PURE__ */ new Map();
  function openAll(site) {
    const found3 = opened.get(site) ?? openOnce(site);
    opened.set(site, found3);
    return found3;
  }
  async function openStore(site) {
    const all = await openAll(site);
    return forStudent(all, await readStudent(all));
  }
  async function readStudent(all) {
    const found3 = await all.get(STUDENT).catch(() => null);
    return typeof found3?.code === "string" ? found3.code : "";
  }
  function forStudent(all, code) {
    const before = code ? `@${code}/` : "";
    const mine = (key) => before ? key.startsWith(before) : !key.startsWith("@") && key !== STUDENT && key !== SETTLED;
    return {
      kind: all.kind,
      how: all.how,
      student: code,
      get: (key) => all.get(before + key),
      put: (key, value, alone3) => {
        letItStay();
        return all.put(before + key, stamped(value), alone3);
      },
      remove: (key) => all.remove(before + key),
      hear: (act, signal) => all.hear((key, gone) => mine(key) && act(key.slice(before.length), gone), signal),
      entries: async () => (await all.entries()).filter(([key]) => mine(key)).map(([key, value]) => [key.slice(before.length), value])
    };
  }
  async function openOnce(site) {
    try {
      const store = telling(sheltered(await indexed(`carts:${site}`), site), site);
      await takeTexts(store, site);
      return store;
    } catch {
      const texts = textStore(site);
      return telling(texts ? await instead(sheltered(texts, site), site) : memory(site), site);
    }
  }
  function place2() {
    const { cartsSite, cartsPage } = document.documentElement.dataset;
    const meta = (name) => document.querySelector(`meta[name="${name}"]`)?.getAttribute("content");
    const path3 = location.pathname.split("/").slice(-2).join("/");
    return {
      site: cartsSite ?? meta("carts-site") ?? "site",
      page: cartsPage ?? meta("carts-page") ?? path3
    };
  }

  // src/store/kept.js
  var Kept = class {
    #key = "";
    #store;
    constructor(id) {
      const { site, page: page2 } = place2();
      this.#key = `${page2}#${id}`;
      this.#store = openStore(site);
    }
    async lasts() {
      return (await this.#store).kind === "kept";
    }
    async named() {
      return (await this.#store).student !== "";
    }
    async get() {
      const store = await this.#store;
      return await store.get(this.#key).catch(() => null) ?? null;
    }
    async put(entry2) {
      await (await this.#store).put(this.#key, entry2);
      document.dispatchEvent(new CustomEvent("carts-kept", { detail: this.#key }));
    }
    async forget() {
      await (await this.#store).remove(this.#key);
      document.dispatchEvent(new CustomEvent("carts-forgotten", { detail: this.#key }));
    }
    async hear(act, signal) {
      (await this.#store).hear(async (key, gone) => {
        if (key !== this.#key) return;
        const found3 = await this.get();
        if (found3 || gone) act(found3);
      }, signal);
    }
  };

  // ../view/windows.js
  function touches(events, until) {
    const open2 = /* @__PURE__ */ new Map();
    const peaks = /* @__PURE__ */ new Map();
    const anew = /* @__PURE__ */ new Map();
    const found3 = [];
    for (const event of events) {
      const { bodies, before, t: start } = event;
      const pair = bodies.join("-");
      const touch = { pair, bodies, start, end: start };
      if (event.kind === "contact" && !event.impulse) {
        const old = open2.get(pair);
        if (old) found3.push({ ...old.touch, end: start });
        if (old) anew.set(pair, start);
        open2.set(pair, { touch, before });
      } else if (event.kind === "release" && !event.impulse) {
        open2.set(`loose ${pair}`, { touch: { ...touch, loose: true }, before });
      } else if (event.kind === "peak") {
        peaks.set(pair, event.t);
      } else if (event.kind === "separate" && anew.get(pair) === start) {
        anew.delete(pair);
      } else if (event.kind === "separate" || event.kind === "stick") {
        const keys = [`loose ${pair}`, pair].filter((key2) => open2.has(key2));
        const key = keys.length < 2 || begunWith(before, open2.get(String(keys[0]))) ? keys[0] : pair;
        const over = key && open2.get(key);
        if (!over) continue;
        open2.delete(key);
        found3.push({ ...over.touch, end: event.t });
      }
    }
    for (const { touch } of open2.values()) {
      const peak = touch.loose ? until : peaks.get(touch.pair) ?? until;
      found3.push({ ...touch, end: peak > touch.start ? peak : until, lasts: true });
    }
    return found3.filter((touch) => touch.end > touch.start).sort((a2, b2) => a2.start - b2.start);
  }
  function begunWith(before, one) {
    return Object.entries(one?.before ?? {}).every(([name, v2]) => before[name] === v2);
  }
  var ROUNDED = 1 + 1e-9;
  var FELT = 0.1;
  function windowsOf({ header, trajectory }) {
    const found3 = touches(header.events, header.until);
    const { t: t3, F: F2 } = trajectory;
    for (const event of header.events) {
      const pair = event.bodies.join("-");
      const column = F2[pair];
      const within = found3.some(
        (touch) => touch.pair === pair && touch.start <= event.t && event.t <= touch.end
      );
      if (event.kind !== "peak" || within || !column || t3.length < 2) continue;
      const felt = (k) => Number(column[k]) > FELT * (event.force ?? 0);
      let [first, last] = [rowAt(t3, event.t), rowAt(t3, event.t)];
      while (first > 0 && felt(first)) first -= 1;
      while (last < t3.length - 1 && felt(last)) last += 1;
      const window = { start: Number(t3[first]), end: Number(t3[last]) };
      found3.push({ pair, bodies: event.bodies, ...window, near: true });
    }
    for (const bodies of pairsApart(header)) {
      const pair = bodies.join("-");
      const end2 = letGo(t3, F2[pair] ?? []);
      const within = found3.some((touch) => touch.pair === pair && touch.start <= 0);
      if (end2 && !within) found3.push({ pair, bodies, start: 0, end: end2, near: true });
    }
    return found3.sort((a2, b2) => a2.start - b2.start);
  }
  function letGo(t3, force2) {
    const first = Number(force2[0]);
    for (let row = 1; row < force2.length; row += 1) {
      const now = Number(force2[row]);
      if (now > first * ROUNDED) return 0;
      if (now < FELT * first) return Number(t3[row]);
    }
    return 0;
  }
  function latestTouch(windows, t3) {
    return windows.findLast((touch) => touch.start <= t3);
  }

  // src/predict/mean-forces.js
  var ALONE = 0.02;
  function meanForces(run) {
    const found3 = [];
    for (const touch of ended2(run)) {
      const { bodies, start, end: end2 } = touch;
      const impulse = impulseOf(run, touch);
      const carts = bodies.filter((name) => !isWall(name));
      const whole = (cart) => cart === bodies[0] ? -impulse : impulse;
      if (!impulse || !carts.every((cart) => isAlone(run, touch, cart, whole(cart)))) continue;
      for (const cart of carts) {
        const other = String(bodies.find((name) => name !== cart));
        if (found3.some((one) => one.cart === cart && one.other === other)) continue;
        found3.push({ cart, other, value: whole(cart) / (end2 - start), start, end: end2 });
      }
    }
    return found3;
  }
  function anyTouch(run) {
    return ended2(run).length > 0;
  }
  function massOf({ header }, name) {
    return header.bodies.find((one) => one.name === name)?.mass ?? 0;
  }
  function velocity({ trajectory }, name, t3) {
    return valueAt(trajectory.t, trajectory.v[name] ?? [], trajectory.a[name] ?? [], t3);
  }
  function ended2({ header }) {
    return touches(header.events, header.until).filter(
      ({ end: end2, lasts }) => !lasts && end2 < header.until
    );
  }
  function impulseOf({ header }, { pair, end: end2 }) {
    const all = header.events.filter(({ t: t3, bodies }) => t3 === end2 && bodies.join("-") === pair);
    return Math.max(0, ...all.map(({ impulse }) => impulse ?? 0));
  }
  function isAlone(run, { start, end: end2 }, cart, impulse) {
    const change2 = velocity(run, cart, end2) - velocity(run, cart, start);
    return Math.abs(massOf(run, cart) * change2 - impulse) <= ALONE * Math.abs(impulse);
  }

  // src/predict/find-forces.js
  var NEAR = 0.05;
  var MANY2 = 3;
  var TYPE = "found-force";
  var FindForces = class {
    #means = [];
    #run = null;
    #tries = 0;
    #tried = "";
    // the number that was checked last, and for which force: once more it is no other try
    #found = /* @__PURE__ */ new Map();
    constructor(root, id, found3) {
      this.id = `${id}-forces`;
      this.kept = new Kept(this.id);
      this.found = found3;
      this.which = need(root, ".carts-find-which");
      this.box = need(root, ".carts-find-value input");
      this.button = need(root, ".carts-find-form button");
      this.note = need(root, ".carts-find-note");
      need(root, ".carts-find-form").addEventListener("submit", (event) => {
        event.preventDefault();
        void this.#check();
      });
    }
    show(run) {
      const first = !this.#run;
      this.#run = run;
      if (first) void this.#restore();
      this.#means = meanForces(run);
      this.#found = this.#ofThisRun(this.#found);
      const names = this.#means.map(
        ({ cart, other }) => tr("{cart}, while it touches {other}", { cart, other: body(other, run.header.track) })
      );
      const same = [...this.which.options].map((one) => one.text).join() === names.join();
      if (!same) this.which.replaceChildren(...names.map((name) => new Option(name)));
      for (const control of [this.which, this.box, this.button]) control.disabled = !names.length;
      if (names.length && this.#found.size) return this.#tell();
      say(this.note, names.length ? "" : whyNone(run));
    }
    async #restore() {
      const kept = await this.kept.get();
      if (kept?.type !== TYPE) return;
      if (!Array.isArray(kept.found)) return this.found([]);
      this.#found = this.#ofThisRun(new Map(kept.found));
      if (this.#found.size) this.#tell();
    }
    #ofThisRun(found3) {
      if (isWhole(found3)) return found3;
      const now = new Map(this.#means.map((mean) => [keyOf(mean), this.#said(mean)]));
      return new Map([...found3].filter(([key, said]) => now.get(key) === said));
    }
    #said({ cart, other, value }) {
      const track = this.#run.header.track;
      const told4 = { cart, other: body(other, track), force: short(value) };
      return tr("mean force on {cart} by {other}: {force} N", told4);
    }
    #tell() {
      if (!this.#found.size) return;
      if (isWhole(this.#found)) return this.found([...this.#found.values()]);
      const [cart = "", other = ""] = JSON.parse([...this.#found.keys()].at(-1) ?? "[]");
      const text = tr("Right. Now find the force on {other} too, from its own mass and velocities.", {
        other
      });
      say(this.note, text);
      const next = this.#means.findIndex((mean) => mean.cart === other && mean.other === cart);
      if (next >= 0) this.which.selectedIndex = next;
    }
    async #check() {
      const mean = this.#means[this.which.selectedIndex];
      const read = readTyped(withoutNewtons(this.box.value));
      if (!mean || !this.#run) return;
      if (!("value" in read)) {
        return say(this.note, "problem" in read ? read.problem : tr("Type the number only, in N."));
      }
      const tried = `${keyOf(mean)} ${mean.value} ${read.value}`;
      if (tried !== this.#tried) this.#tries += 1;
      this.#tried = tried;
      const off = read.value / mean.value - 1;
      if (Math.abs(off) > NEAR) return say(this.note, this.#advice(mean, read.value));
      this.#found.set(keyOf(mean), this.#said(mean));
      await this.#keep(this.box.value);
      this.box.value = "";
      this.#tell();
    }
    #advice(mean, typed) {
      const ratio = typed / mean.value;
      if (Math.abs(ratio + 1) <= NEAR) {
        return tr("The size is right. Which way does the force point? + is to the right.");
      }
      const mass = massOf(this.#run, mean.cart);
      const others = isWall(mean.other) ? [] : [massOf(this.#run, mean.other)];
      if (others.some((other) => Math.abs(Math.abs(ratio * mass / other) - 1) <= NEAR)) {
        return tr(
          "That would fit the mass of {other}. The velocity of {cart} goes with the mass of {cart}.",
          { other: mean.other, cart: mean.cart }
        );
      }
      const steps2 = tr(
        "Not yet. Δv is the velocity of {cart} after minus before, with signs; Δt is how long the two touch.",
        { cart: mean.cart }
      );
      if (this.#tries < MANY2) return steps2;
      const v2 = (t3) => short(velocity(this.#run, mean.cart, t3));
      const here = tr(
        "Here: m = {mass} kg, v before {before} m/s, v after {after} m/s, Δt = {time} s.",
        {
          mass: short(mass),
          before: v2(mean.start),
          after: v2(mean.end),
          time: short(mean.end - mean.start)
        }
      );
      return `${steps2} ${here}`;
    }
    async #keep(typed) {
      const now = (/* @__PURE__ */ new Date()).toISOString();
      const before = await this.kept.get();
      const elsewhere = Array.isArray(before?.found) ? before.found : [];
      this.#found = new Map([...this.#ofThisRun(new Map(elsewhere)), ...this.#found]);
      const entry2 = {
        id: this.id,
        type: TYPE,
        value: typed,
        first: before?.first ?? now,
        last: now,
        said: [...this.#found.values()].join("; "),
        found: [...this.#found],
        tries: this.#tries,
        asked: tr("Find a force of this scene")
      };
      await this.kept.put(entry2).catch(() => {
      });
    }
  };
  function whyNone(run) {
    return anyTouch(run) ? tr(
      "In this run another force acts while two touch: there, m Δv/Δt is not the force of one body on the other."
    ) : tr("In this run no two touch for a time that can be read off.");
  }
  var keyOf = ({ cart, other }) => JSON.stringify([cart, other]);
  function isWhole(found3) {
    return [...found3.keys()].some((key) => {
      const [cart = "", other = ""] = JSON.parse(key);
      return isWall(other) || found3.has(JSON.stringify([other, cart]));
    });
  }
  function forgetForces(id) {
    delete document.getElementById(id)?.dataset.found;
    new Kept(`${id}-forces`).forget().catch(() => {
    });
  }
  function showForces(element, said) {
    const template = need(element, "template.carts-shown");
    const script = need(element, "script.carts-baked");
    const baked = JSON.parse(script.textContent ?? "");
    const differs = JSON.parse(template.dataset.baked ?? "");
    const frame2 = need(element, ".carts-frame");
    frame2.replaceWith(template.content);
    script.textContent = JSON.stringify({ ...baked, ...differs });
    template.remove();
    element.dataset.found = "";
    element.dispatchEvent(new Event("carts-found", { bubbles: true }));
    const note2 = element.querySelector(".carts-found");
    if (!note2) return;
    note2.replaceChildren(
      html("b", "", tr("You found the forces.")),
      " ",
      said.map((sentence) => `${capital(sentence)}. `).join(""),
      tr(
        "Now they are shown at each instant. Yours are the means: the steady forces that would do the same in the same time."
      )
    );
    note2.hidden = false;
  }

  // src/scene/baked.js
  function readBaked(element) {
    return bakedOf(JSON.parse(need(element, "script.carts-baked").textContent ?? ""));
  }
  function bakedOf({ fence, view, numbers, ...header }) {
    const known2 = header;
    return { fence, view, run: { header: known2, trajectory: fromBaked(numbers, known2.events) } };
  }

  // ../view/markers.js
  var MARKERS = {
    b0: "M-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0Z",
    b1: "M-3.5 -3.5H3.5V3.5H-3.5Z",
    b2: "M0 -5L5 0L0 5L-5 0Z",
    b3: "M-4.5 3.5L0 -4.5L4.5 3.5Z",
    b4: "M-4.5 -3.5L0 4.5L4.5 -3.5Z",
    b5: "M-4 -1.5H-1.5V-4H1.5V-1.5H4V1.5H1.5V4H-1.5V1.5H-4Z",
    b6: "M-4.5 -2.5H4.5V2.5H-4.5Z",
    b7: "M-2.5 -4.5H2.5V4.5H-2.5Z",
    wall: "M-3 -3L3 3M-3 3L3 -3",
    total: "M-2.5 0a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0 -5 0Z"
  };
  function styleOf(index) {
    return `b${index % 8}`;
  }

  // ../view/ledger-effects.js
  var WANTED = "carts-energy-wanted";
  var [BUMPERS, WARMED] = ["bumpers", "warmed"];
  var AROUND = tr("surroundings");
  function needsParts({ fence }) {
    return (fence.scene.effects ?? []).length > 0;
  }
  function askParts(root) {
    return new Promise((resolve) => {
      const detail = { answer: resolve, heard: false };
      root.dispatchEvent(new CustomEvent(WANTED, { bubbles: true, detail }));
      if (!detail.heard) resolve(null);
    });
  }
  function ledgerWithEffects(header, parts2) {
    const column = (name) => parts2.columns[parts2.names.indexOf(name)] ?? new Float64Array(parts2.t.length);
    const bands = parts2.moving.map((values, i2) => ({
      label: tr("motion of {cart}", { cart: header.bodies[i2]?.name ?? "" }),
      style: styleOf(i2),
      over: false,
      values,
      slopes: null
    }));
    for (const name of parts2.names.filter((one) => one !== WARMED)) {
      const [label, style] = name === BUMPERS ? [tr("in squeezed bumpers"), "squeezed"] : [stored(name, header), "stored"];
      if (!label) continue;
      const values = column(name);
      const lowest = values.reduce((least, value) => Math.min(least, value), 0);
      const above = Float64Array.from(values, (value) => value - lowest);
      bands.push({ label, style, over: false, values: above, slopes: null });
    }
    const warm = { values: column(WARMED), style: "warmed", over: false, slopes: null };
    bands.push({ ...warm, label: warmed(header) });
    return bands;
  }
  function stored(kind2, { effects }) {
    const { lasts, stored: where = "" } = viewOf(kind2);
    return !lasts || effects.some((one) => one.kind === kind2 && lasts(one)) ? where : "";
  }
  function warmed({ contacts, effects }) {
    const what = contacts.length ? [tr("bumpers")] : [];
    for (const effect of effects.filter(({ active }) => active)) {
      what.push(viewOf(effect.kind).warms?.(effect) ?? "");
    }
    const names = [...new Set(what.filter(Boolean))];
    const things = listed(names) || AROUND;
    return tr("has warmed the {things}", { things });
  }

  // src/predict/again.js
  var Again = class {
    constructor(root, forget) {
      this.row = need(root, ".carts-again-row");
      this.button = need(root, ".carts-again");
      this.question = need(root, ".carts-forget");
      const keep = need(root, ".carts-forget-no");
      this.button.addEventListener("click", () => {
        this.#ask(true);
        keep.focus();
      });
      keep.addEventListener("click", () => {
        this.#ask(false);
        this.button.focus();
      });
      need(root, ".carts-forget-yes").addEventListener("click", forget);
    }
    offer() {
      this.row.hidden = false;
    }
    #ask(on) {
      this.question.hidden = !on;
      this.button.hidden = on;
    }
  };

  // src/predict/arrow-parts.js
  var ALIKE = 0.06;
  var LONG2 = 120;
  function asked3(element, { contacts, track }) {
    const { pair = "", on = "" } = element.dataset;
    const bodies = contacts.find((contact) => contact.pair === pair)?.bodies ?? [on, on];
    const side = bodies[0] === on ? "left" : "right";
    const by = (side === "left" ? bodies[1] : bodies[0]) ?? "";
    return {
      pair,
      on,
      name: forceOn(body(on, track), body(by, track)),
      side,
      style: element.className.split(" ").find((name) => /^carts-(b\d|wall)$/.test(name)) ?? "",
      slider: need(element, 'input[type="range"]')
    };
  }
  function greatest(run, pair) {
    const [left2, right] = run.header.contacts.find((contact) => contact.pair === pair)?.bodies ?? [];
    const peak = run.header.events.find(
      (event) => event.kind === "peak" && event.bodies[0] === left2 && event.bodies[1] === right
    );
    if (typeof peak?.force === "number") return peak.force;
    return Math.max(0, ...Array.from(run.trajectory.F[pair] ?? []));
  }
  function pulled(length, className, side, cut = false) {
    const width = Math.max(length, 6) + 4;
    const picture2 = svg("svg", {
      viewBox: `0 0 ${width} 20`,
      width,
      height: 20,
      "aria-hidden": "true"
    });
    const draw = cut ? cutArrow : blockArrow;
    const d2 = side === "left" ? draw(width, 10, -length) : draw(0, 10, length);
    picture2.append(svg("path", { class: className, d: d2 }));
    return picture2;
  }

  // src/predict/arrows.js
  var MOST2 = 10;
  var ArrowsForm = class {
    #rows;
    constructor(root, baked, draw, changed) {
      this.full = baked.view.force || 10;
      this.decimals = baked.view.decimals.F ?? 2;
      this.draw = draw;
      const { header } = baked.run;
      const elements = root.querySelectorAll(".carts-guess");
      this.#rows = [...elements].map((element) => {
        const row = {
          ...asked3(element, header),
          size: null,
          good: null,
          // the last size that was not taken back: half-typed numbers do not count
          box: need(element, 'input[type="text"]'),
          error: need(element, ".carts-error")
        };
        row.slider.addEventListener(
          "input",
          () => this.#take(row, row.slider.valueAsNumber, changed)
        );
        row.box.addEventListener("input", () => this.#typed(row, changed, false));
        row.box.addEventListener("change", () => this.#typed(row, changed, true));
        return row;
      });
    }
    get value() {
      return this.#rows.map(({ pair, on, size }) => ({ pair, on, size }));
    }
    get said() {
      const rows = this.#rows.filter(({ size }) => size !== null);
      return rows.map((row) => `${row.name}: ${fixed(row.size ?? 0, this.decimals)} N`).join("; ");
    }
    set value(value) {
      for (const saved of Array.isArray(value) ? value : []) {
        const row = this.#rows.find(({ pair, on }) => pair === saved.pair && on === saved.on);
        if (row && typeof saved.size === "number") this.#show(row, saved.size);
      }
      this.#picture();
    }
    enable(on) {
      for (const { slider, box: box2 } of this.#rows) {
        slider.disabled = !on;
        box2.disabled = !on;
      }
    }
    ready() {
      this.#picture();
    }
    problem() {
      const missing = this.#rows.filter((row) => row.size === null);
      if (!missing.length) return null;
      const refused = missing.filter((row) => row.box.value.trim());
      if (refused.length) {
        const names = inRow(refused.map(({ name }) => name));
        const problem = tr("This number does not work yet: {names}.", { names });
        return `${problem} ${this.#range()}`;
      }
      return tr("Set every arrow first: {names}. Zero counts too: type 0.", {
        names: inRow(missing.map(({ name }) => name))
      });
    }
    compare(run) {
      this.draw([]);
      const pairs = [...new Set(this.#rows.map(({ pair }) => pair))];
      const tables = pairs.map((pair) => {
        const rows = this.#rows.filter((row) => row.pair === pair);
        const actual = greatest(run, pair);
        const grid = html("div", "carts-compare");
        const newtons = (size) => `${fixed(size, this.decimals)} N`;
        const spoken = rows.map(
          (row) => tr("{force}: you {yours}, the run {actual}.", {
            force: row.name,
            yours: newtons(row.size ?? 0),
            actual: newtons(actual)
          })
        );
        grid.setAttribute("role", "img");
        grid.setAttribute("aria-label", spoken.join(" "));
        grid.append(
          html("span"),
          ...rows.map((row) => html("b", `${row.style} ${row.side}`, row.name))
        );
        for (const [who, style] of [
          [tr("you"), "carts-guessed"],
          [tr("the run"), "carts-block-arrow"]
        ]) {
          grid.append(html("span", "", who));
          for (const row of rows) {
            const size = style === "carts-guessed" ? row.size ?? 0 : actual;
            const cell3 = html("span", `carts-compare-arrow ${row.style} ${row.side}`);
            cell3.append(
              arrow(size, this.full, style, row.side),
              ` ${newtons(size)}${isCut(size, this.full) ? tr(", arrow cut") : ""}`
            );
            grid.append(cell3);
          }
        }
        return grid;
      });
      const text = tr(
        "The run’s arrows are those at greatest compression, with the values that you predicted for. Play it in slow motion and look at other instants too."
      );
      return [...tables, html("p", "", text)];
    }
    #typed(row, changed, done) {
      const read = readTyped(withoutNewtons(row.box.value));
      let problem = "";
      if ("problem" in read) problem = read.problem;
      else if ("text" in read) problem = tr("Type a number; the unit is N.");
      else if (read.value < 0 || read.value > MOST2 * this.full) problem = this.#range();
      if (done && problem) {
        const size = row.good === null ? "" : fixed(row.good, this.decimals);
        const kept = tr("{size} N is kept.", { size });
        say(row.error, size ? `${problem} ${kept}` : problem);
        row.error.hidden = false;
        this.#restore(row, changed);
      }
      if (!("value" in read) || problem) return;
      if (done) this.#show(row, read.value);
      else this.#set(row, read.value);
      this.#picture();
      changed();
    }
    #range() {
      return tr("0 to {most} N, please.", { most: short(MOST2 * this.full) });
    }
    #restore(row, changed) {
      if (row.size === row.good) return;
      if (row.good === null) row.size = null;
      else this.#set(row, row.good);
      this.#picture();
      changed();
    }
    #take(row, size, changed) {
      this.#show(row, size);
      this.#picture();
      changed();
    }
    #set(row, size) {
      row.size = size;
      row.slider.valueAsNumber = size;
      row.slider.setAttribute(
        "aria-valuetext",
        tr("{size} newtons", { size: fixed(size, this.decimals) })
      );
    }
    #show(row, size) {
      this.#set(row, size);
      row.good = size;
      row.box.value = fixed(size, this.decimals);
      row.error.hidden = true;
    }
    #picture() {
      this.draw(
        this.#rows.map(({ pair, on, side, size, slider }) => ({ pair, on, side, size, slider }))
      );
    }
  };
  function arrow(size, full, className, side) {
    return pulled(arrowLength(size, full, LONG2), className, side, isCut(size, full));
  }

  // ../view/pad.js
  var LEFT4 = 40;
  var STEP2 = 77.5;
  var POINTS = 5;
  var HIGHEST = 10;
  var TOP4 = 10;
  var BOTTOM4 = 130;
  function pad(quantity) {
    const low = quantity === "F" ? 0 : -HIGHEST;
    const per = (BOTTOM4 - TOP4) / (HIGHEST - low);
    return { low, zero: TOP4 + HIGHEST * per, per };
  }
  function path({ zero, per }, heights) {
    const step = (POINTS - 1) * STEP2 / (heights.length - 1);
    const points = Array.from(
      heights,
      (height, k) => `${px(LEFT4 + k * step)} ${px(zero - per * height)}`
    );
    return `M${points.join("L")}`;
  }

  // src/predict/curve-features.js
  var LITTLE = 0.05;
  var FEATURES = { F: force, v: velocity2, x: position };
  function features(quantity, mine, run) {
    return FEATURES[quantity]().map(([name, has]) => [name, has(mine), has(run)]);
  }
  function force() {
    return [
      [tr("starts from zero"), (h2) => none(h2, 0)],
      [
        tr("is greatest in between"),
        (h2) => Math.max(...h2.slice(1, -1)) > Math.max(at2(h2, 0), at2(h2, -1))
      ],
      [tr("goes up once and down once"), (h2) => hills(h2) === 1],
      [tr("is zero again at the end"), (h2) => none(h2, -1)]
    ];
  }
  function velocity2() {
    return [
      [tr("starts at rest"), (h2) => none(h2, 0)],
      [tr("stays the same from start to end"), (h2) => Math.max(...h2) - Math.min(...h2) <= little(h2)],
      [
        tr("is faster at the end than at the start"),
        (h2) => Math.abs(at2(h2, -1)) - Math.abs(at2(h2, 0)) > little(h2)
      ],
      [
        tr("changes evenly in the first half"),
        (h2) => {
          const [first, second] = steps(h2);
          const least = Math.min(Math.abs(first), Math.abs(second));
          return least > little(h2) && even([first, second], little(h2));
        }
      ],
      [tr("stays the same in the last quarter"), (h2) => Math.abs(at2(steps(h2), -1)) <= little(h2)],
      [tr("turns round"), (h2) => Math.max(...h2) > little(h2) && Math.min(...h2) < -little(h2)],
      [tr("is at rest at the end"), (h2) => none(h2, -1)]
    ];
  }
  function position() {
    return [
      [tr("equal distances in equal times, all the way"), (h2) => even(steps(h2), little(h2))],
      [
        tr("goes farther in the last quarter than in the first"),
        (h2) => {
          const gone = steps(h2).map(Math.abs);
          return at2(gone, -1) - at2(gone, 0) > little(h2);
        }
      ],
      [
        tr("turns round"),
        (h2) => Math.max(...steps(h2)) > little(h2) && Math.min(...steps(h2)) < -little(h2)
      ],
      [tr("stays where it is at the end"), (h2) => Math.abs(at2(steps(h2), -1)) <= little(h2)]
    ];
  }
  function steps(h2) {
    const quarter = (h2.length - 1) / 4;
    return [1, 2, 3, 4].map((k) => at2(h2, k * quarter) - at2(h2, (k - 1) * quarter));
  }
  function even(gone, little2) {
    return Math.max(...gone) - Math.min(...gone) <= little2;
  }
  function none(h2, k) {
    return Math.abs(at2(h2, k)) <= little(h2);
  }
  function little(h2) {
    return LITTLE * Math.max(...h2.map(Math.abs));
  }
  function at2(h2, k) {
    return h2.at(k) ?? 0;
  }
  function hills(heights) {
    let found3 = 0;
    let rising = false;
    heights.forEach((height, k) => {
      const before = heights[k - 1] ?? 0;
      if (height > before) rising = true;
      if (height < before && rising) {
        found3 += 1;
        rising = false;
      }
    });
    return found3 + (rising ? 1 : 0);
  }

  // src/predict/pad-labels.js
  var INSET = 6;
  var ROWS2 = {
    1: [
      [6.6, 10, 24],
      [3.7, 6.6, 44]
    ],
    0: [
      [0.5, 3.7, 61],
      [-3.7, -0.5, 87]
    ],
    "-1": [
      [-10, -6.6, 126],
      [-6.6, -3.7, 107]
    ]
  };
  function placeLabels(pad2, curves) {
    for (const text of pad2.querySelectorAll("[data-way]")) {
      const way = text.getAttribute("data-way") ?? "";
      const middle = way === "0";
      const gaps = Array.from({ length: POINTS - 1 }, (_2, k) => middle ? POINTS - 2 - k : k);
      const rows = ROWS2[way] ?? [];
      const places = middle ? gaps.flatMap((gap2) => rows.map((row2) => ({ gap: gap2, row: row2 }))) : rows.flatMap((row2) => gaps.map((gap2) => ({ gap: gap2, row: row2 })));
      const free = places.find(
        ({ gap: gap2, row: [low, high] }) => curves.every((heights) => !crosses(heights, gap2, low, high))
      );
      const { gap, row } = free ?? places[0];
      text.setAttribute("x", px(LEFT4 + STEP2 * gap + (middle ? STEP2 / 2 : INSET)));
      text.setAttribute("y", String(row[2]));
    }
  }
  function crosses(heights, gap, low, high) {
    const per = (heights.length - 1) / (POINTS - 1);
    const within = Array.from(heights).slice(gap * per, (gap + 1) * per + 1);
    return Math.max(...within) > low && Math.min(...within) < high;
  }

  // src/predict/curve.js
  var FINE2 = 48;
  var CurveForm = class {
    #heights = Array(POINTS).fill(null);
    #enabled = false;
    #seen = [];
    constructor(root, spec, changed) {
      this.cart = spec.cart ?? "";
      this.quantity = spec.quantity;
      this.place = pad(spec.quantity);
      this.changed = changed;
      this.pad = need(root, ".carts-pad");
      this.boxes = [...root.querySelectorAll(".carts-height")];
      this.boxes.forEach((box2, k) => {
        box2.addEventListener("input", () => this.#set(k, this.#beyond(box2) ? null : numberIn(box2)));
        box2.addEventListener("change", () => {
          const beyond = this.#beyond(box2);
          complain(box2, beyond || problemIn(box2));
          if (!beyond) this.#show(k);
        });
      });
      this.pad.addEventListener("pointerdown", (event) => {
        if (!this.#enabled || event.button > 0) return;
        this.pad.setPointerCapture(event.pointerId);
        this.#point(event);
      });
      this.pad.addEventListener("pointermove", (event) => {
        if (this.#enabled && event.buttons & 1) this.#point(event);
      });
    }
    get value() {
      return [...this.#heights];
    }
    get said() {
      return tr("heights {heights}", {
        heights: this.#heights.map((height) => height ?? "–").join(", ")
      });
    }
    set value(value) {
      if (Array.isArray(value) && value.length === this.#heights.length) this.#heights = [...value];
      this.boxes.forEach((_2, k) => {
        this.#show(k);
      });
      this.#draw();
    }
    enable(on) {
      this.#enabled = on;
      for (const box2 of this.boxes) box2.disabled = !on;
    }
    problem() {
      if (this.#heights.every((height) => height !== null)) return null;
      return tr("Give all five heights first, also where you think it is 0.");
    }
    compare(run) {
      const seen = this.quantity === "F" ? this.#force(run) : this.#motion(run);
      if (!seen)
        return [html("p", "", tr("In this run nothing touches {cart}.", { cart: this.cart }))];
      const top = Math.max(...seen.values.map(Math.abs)) || 1;
      const scaled = seen.values.map((value) => HIGHEST * value / top);
      put(need(this.pad, '[data-part="answer"]'), "d", path(this.place, scaled));
      this.#seen = [scaled];
      this.#draw();
      const list = html("ul");
      for (const [feature, yours, theirs] of features(
        this.quantity,
        this.#heights.map(Number),
        scaled
      )) {
        if (!yours && !theirs) continue;
        const said = (yes) => yes ? tr("yes") : tr("no");
        const both2 = { feature, yours: said(yours), theirs: said(theirs) };
        list.append(html("li", "", tr("{feature}: your curve {yours}, the run {theirs}", both2)));
      }
      return [html("p", "", seen.title), list];
    }
    #force({ header, trajectory: { t: t3, F: F2, dF } }) {
      const touch = touches(header.events, header.until).find(
        ({ bodies }) => bodies.includes(this.cart)
      );
      if (!touch) return null;
      const values = evenly(
        touch.start,
        touch.end,
        (at3) => valueAt(t3, F2[touch.pair] ?? [0], dF[touch.pair] ?? [0], at3)
      );
      const other = touch.bodies.find((name) => name !== this.cart) ?? "";
      const title = tr(
        "Force on {cart} by {other}: dashed is yours, solid is the run. Only the shape counts.",
        { cart: this.cart, other: body(other, header.track) }
      );
      return { values, title };
    }
    #motion({ header, trajectory: { t: t3, x: x2, v: v2, a: a2 } }) {
      const [values, slopes] = this.quantity === "v" ? [v2, a2] : [x2, v2];
      const start = this.quantity === "v" ? 0 : Number(values[this.cart]?.[0]);
      const title = this.quantity === "v" ? tr("Velocity of {cart}: dashed is yours, solid is the run. Only the shape counts.", {
        cart: this.cart
      }) : tr(
        "Displacement of {cart} from the start: dashed is yours, solid is the run. Only the shape counts.",
        {
          cart: this.cart
        }
      );
      const at3 = (time) => valueAt(t3, values[this.cart] ?? [0], slopes[this.cart] ?? [0], time) - start;
      return { values: evenly(0, header.until, at3), title };
    }
    #beyond(box2) {
      const height = numberIn(box2) ?? 0;
      if (height >= this.place.low && height <= HIGHEST) return "";
      const label = box2.closest("label")?.firstChild?.textContent?.trim() ?? "";
      return outside({ label, unit: "" }, fixed(this.place.low, 0), fixed(HIGHEST, 0));
    }
    #point(event) {
      const frame2 = this.pad.getBoundingClientRect();
      const scale = 360 / frame2.width;
      const k = Math.round(((event.clientX - frame2.left) * scale - LEFT4) / STEP2);
      const height = (this.place.zero - (event.clientY - frame2.top) * scale) / this.place.per;
      if (k >= 0 && k < this.#heights.length) {
        this.#set(k, Math.round(2 * height) / 2);
        this.#show(k);
      }
    }
    #set(k, height) {
      this.#heights[k] = height === null ? null : Math.min(HIGHEST, Math.max(this.place.low, height));
      this.#draw();
      this.changed();
    }
    #show(k) {
      const [box2, height] = [this.boxes[k], this.#heights[k] ?? null];
      if (!box2 || numberIn(box2) === height) return;
      box2.value = String(height ?? "");
      complain(box2, "");
    }
    #draw() {
      this.#heights.forEach((height, k) => {
        const knob = this.pad.querySelector(`[data-index="${k}"]`);
        if (knob) put(knob, "cy", String(this.place.zero - this.place.per * (height ?? 0)));
      });
      const drawn2 = this.#heights.map((height) => height ?? 0);
      put(need(this.pad, '[data-part="sketch"]'), "d", path(this.place, drawn2));
      placeLabels(this.pad, [drawn2, ...this.#seen]);
    }
  };
  function evenly(from, to, value) {
    return Array.from({ length: FINE2 + 1 }, (_2, k) => value(from + (to - from) * k / FINE2));
  }

  // src/predict/keeping.js
  var Keeping = class {
    #kept;
    constructor(root, id, signal) {
      this.root = root;
      this.signal = signal;
      this.saved = need(root, ".carts-saved");
      this.#kept = new Kept(id);
    }
    async open(type, elsewhere) {
      const current = (found4) => found4?.type === type && isCurrent(found4);
      void this.#kept.hear((found4) => {
        if (this.root.isConnected && (!found4 || current(found4))) elsewhere(found4);
      }, this.signal);
      if (!await this.#kept.lasts()) {
        say(
          this.saved,
          tr("This browser keeps nothing: your prediction is lost when you close the page.")
        );
      }
      const found3 = await this.#kept.get();
      return current(found3) ? found3 : null;
    }
    async put(entry2) {
      const lasts = await this.#kept.lasts();
      if (lasts) say(this.saved, tr("Saving…"));
      try {
        await this.#kept.put(entry2);
        if (lasts) say(this.saved, tr("Saved."));
      } catch {
        say(this.saved, tr("Not saved: this browser refuses to keep it. Write it on paper too."));
      }
    }
    async forget({ id, type, locked, again = locked ?? void 0 }) {
      await this.#kept.forget();
      if (!again || !await this.#kept.named()) return;
      const nothing = { value: null, first: null, last: null, tries: 0, locked: null };
      await this.#kept.put({ id, type, ...nothing, again }).catch(() => {
      });
    }
  };

  // src/predict/relative.js
  var RelativeArrows = class {
    #rows;
    #told = "";
    // names of the arrows that were said to be missing
    constructor(root, baked, draw, changed) {
      this.full = baked.view.force || 10;
      this.draw = draw;
      this.relation = need(root, ".carts-relation");
      const { header } = baked.run;
      const elements = root.querySelectorAll(".carts-guess");
      this.#rows = [...elements].map((element) => {
        const row = { ...asked3(element, header), share: null };
        row.slider.addEventListener("input", () => {
          row.share = row.slider.valueAsNumber;
          this.#show();
          changed();
        });
        return row;
      });
    }
    get value() {
      return this.#rows.map(({ pair, on, share }) => ({ pair, on, share }));
    }
    set value(value) {
      for (const saved of Array.isArray(value) ? value : []) {
        const row = this.#rows.find(({ pair, on }) => pair === saved.pair && on === saved.on);
        if (!row || typeof saved.share !== "number") continue;
        row.share = saved.share;
        row.slider.valueAsNumber = saved.share;
      }
      this.#show();
    }
    get said() {
      return this.#pairs.map((rows) => relation(rows, (row) => row.share)).join(" ");
    }
    enable(on) {
      for (const { slider } of this.#rows) slider.disabled = !on;
    }
    ready() {
      this.#show();
    }
    problem() {
      const missing = this.#rows.filter(({ share }) => share === null);
      const names = inRow(missing.map(({ name }) => name));
      const told4 = names === this.#told;
      this.#told = names;
      if (!names) return null;
      if (!told4) {
        return tr("Not set yet: {names}. Is there no such force? Then lock once more.", { names });
      }
      for (const row of missing) row.share = 0;
      this.#show();
      return null;
    }
    compare(run) {
      this.draw([]);
      return this.#pairs.map((rows) => {
        const actual = greatest(run, rows[0]?.pair ?? "");
        const most = Math.max(...rows.map(({ share }) => share ?? 0));
        const grid = html("div", "carts-compare");
        const yours = relation(rows, (row) => row.share);
        const seen = relation(rows, () => actual);
        grid.setAttribute("role", "img");
        grid.setAttribute(
          "aria-label",
          tr("You: {yours} The run: {seen}", { yours: yours || "–", seen })
        );
        grid.append(
          html("span"),
          ...rows.map((row) => html("b", `${row.style} ${row.side}`, row.name)),
          html("span", "", tr("you")),
          ...rows.map((row) => cell2(row, most ? (row.share ?? 0) / most : 0, "carts-guessed")),
          html("span", "", tr("the run")),
          ...rows.map((row) => cell2(row, actual ? 1 : 0, "carts-block-arrow"))
        );
        const place4 = html("div");
        const words = html("p", "", tr("You: {yours} The run: {seen}", { yours, seen }));
        words.setAttribute("aria-hidden", "true");
        place4.append(grid, words);
        return place4;
      });
    }
    get #pairs() {
      const pairs = [...new Set(this.#rows.map(({ pair }) => pair))];
      return pairs.map((pair) => this.#rows.filter((row) => row.pair === pair));
    }
    #show() {
      for (const { slider, share } of this.#rows) {
        const part = `${Math.round(100 * (share ?? 0))} %`;
        slider.setAttribute("aria-valuetext", share ? part : tr("no arrow"));
      }
      say(this.relation, this.said);
      this.draw(
        this.#rows.map(({ pair, on, side, share, slider }) => {
          return { pair, on, side, size: share === null ? null : share * this.full, slider };
        })
      );
    }
  };
  function relation(rows, of) {
    const [one, other] = rows;
    if (!one || !other) return "";
    const [a2, b2] = [of(one), of(other)];
    if (a2 === null || b2 === null) return "";
    const most = Math.max(a2, b2);
    if (!most) return tr("no force on either.");
    if (Math.abs(a2 - b2) <= ALIKE * most) return tr("both forces are equally large.");
    const [large, small] = a2 > b2 ? [one, other] : [other, one];
    if (!Math.min(a2, b2)) return tr("only the {force}.", { force: large.name });
    return tr("the {large} is larger than the {small}.", { large: large.name, small: small.name });
  }
  function cell2({ style, side }, part, look) {
    const made4 = html("span", `carts-compare-arrow ${style} ${side}`);
    made4.append(pulled(part * LONG2, look, side));
    return made4;
  }

  // src/predict/sure.js
  var Sure = class {
    #asked = false;
    constructor(root, chosen) {
      const radios = root.querySelectorAll(".carts-certainty input");
      this.radios = [...radios];
      for (const radio of this.radios) radio.addEventListener("change", () => chosen(radio.value));
    }
    passedOver() {
      const said = this.radios.some((radio) => radio.checked);
      if (said || this.#asked || !this.radios.length) return "";
      this.#asked = true;
      return tr("How sure are you? Choose one, or lock without it.");
    }
    show(word, open2) {
      for (const radio of this.radios) {
        radio.checked = radio.value === word;
        radio.disabled = !open2;
      }
    }
  };

  // src/predict/talk.js
  var Talk = class {
    constructor(root, { change: change2, run }) {
      this.box = need(root, ".carts-talk");
      need(this.box, ".carts-talk-change").addEventListener("click", () => {
        change2();
        need(root, ".carts-guess input, .carts-height, input:checked, textarea").focus();
      });
      need(this.box, ".carts-talk-run").addEventListener("click", run);
    }
    show(on, asked4) {
      this.box.hidden = !on;
      if (on && asked4) this.box.focus();
    }
  };
  var Why = class {
    constructor(root, changed) {
      this.line = need(root, ".carts-why");
      this.box = need(this.line, "textarea");
      this.box.addEventListener("input", () => changed(this.box.value));
    }
    show(text) {
      this.line.hidden = false;
      if (this.box.value !== text) this.box.value = text;
    }
  };

  // src/predict/once-more.js
  var OnceMore = class {
    constructor(radios) {
      this.options = radios.map((radio) => ({
        value: radio.value,
        text: radio.closest("label")?.textContent?.trim() ?? ""
      }));
      this.name = `${radios[0]?.name}-now`;
    }
    said(value) {
      return this.options.find((option2) => option2.value === value)?.text ?? "";
    }
    draw(now, choose) {
      const set = html("fieldset", "carts-once-more");
      set.append(html("legend", "", tr("When you have seen enough, the same question once more:")));
      for (const { value, text } of this.options) {
        const line3 = html("label");
        const radio = document.createElement("input");
        Object.assign(radio, { type: "radio", name: this.name, value, checked: value === now });
        radio.autocomplete = "off";
        radio.addEventListener("change", () => choose(value));
        line3.append(radio, html("span", "", text));
        set.append(line3);
      }
      return set;
    }
  };

  // src/predict/words.js
  var ChoiceForm = class {
    constructor(root, changed) {
      this.radios = [
        ...root.querySelectorAll('.carts-options input[type="radio"]')
        // not those of how sure one is
      ];
      for (const radio of this.radios) radio.addEventListener("change", changed);
      this.once = new OnceMore(this.radios);
    }
    get value() {
      return this.radios.find((radio) => radio.checked)?.value ?? null;
    }
    get said() {
      const radio = this.radios.find((one) => one.checked);
      return radio?.closest("label")?.textContent?.trim() ?? "";
    }
    set value(value) {
      for (const radio of this.radios) radio.checked = radio.value === value;
    }
    enable(on) {
      for (const radio of this.radios) radio.disabled = !on;
    }
    problem() {
      return this.value === null ? tr("Choose one first.") : null;
    }
    compare() {
      return [html("p", "", tr("You said: “{said}”", { said: this.said }))];
    }
  };
  var WordsForm = class {
    constructor(root, changed) {
      this.box = need(root, ".carts-words");
      this.box.addEventListener("input", changed);
    }
    get value() {
      return this.box.value;
    }
    get said() {
      return this.box.value.trim();
    }
    set value(value) {
      this.box.value = String(value ?? "");
    }
    enable(on) {
      this.box.disabled = !on;
    }
    problem() {
      return this.box.value.trim() ? null : tr("Write your prediction first; a few words are enough.");
    }
    compare() {
      return [html("p", "", tr("Compare what you saw with what you wrote."))];
    }
  };

  // src/predict/predict.js
  var Predict = class {
    #entry;
    #keeping;
    constructor(root, baked, draw, locked, forgotten, signal) {
      const spec = baked.fence.predict;
      this.root = root;
      this.spec = spec;
      this.forgotten = forgotten;
      this.locked = (now) => {
        draw([]);
        say(need(root, ".carts-heading"), tr("Your prediction"));
        root.classList.add("carts-locked");
        locked(now);
      };
      this.#keeping = new Keeping(root, baked.fence.id, signal);
      this.error = need(root, ".carts-predict-error");
      this.button = need(root, ".carts-lock");
      this.#entry = {
        id: baked.fence.id,
        type: spec.kind,
        value: null,
        first: null,
        last: null,
        tries: 0,
        locked: null
      };
      const changed = () => void this.#changed();
      const forms = {
        arrows: () => new (spec.scale === "newtons" ? ArrowsForm : RelativeArrows)(root, baked, draw, changed),
        curve: () => new CurveForm(root, spec, changed),
        choice: () => new ChoiceForm(root, changed),
        text: () => new WordsForm(root, changed)
      };
      this.form = forms[spec.kind]();
      this.sure = new Sure(root, (word) => {
        this.#entry.sure = word;
        void this.#keep();
      });
      this.button.addEventListener("click", () => void this.#lock());
      this.talk = new Talk(root, { change: () => this.#change(), run: () => void this.#finish() });
      this.why = new Why(root, (text) => {
        this.#entry.why = text;
        this.#told();
        void this.#keep();
      });
      this.again = new Again(root, async () => {
        if (await this.#forget()) forgotten(true);
      });
    }
    get isLocked() {
      return Boolean(this.#entry.locked);
    }
    get watched() {
      return Boolean(this.#entry.watched);
    }
    async restore() {
      const found3 = await this.#keeping.open(this.spec.kind, (found4) => this.#elsewhere(found4));
      this.#back(found3 ?? this.#entry);
      if (found3?.last) say(this.#keeping.saved, tr("Saved."));
    }
    #elsewhere(found3) {
      if (!found3) return this.forgotten(false);
      if (!this.isLocked) return this.#back(found3);
      if (!found3.locked) return;
      this.#entry = found3;
      if (this.watched) this.why.show(found3.why ?? "");
    }
    #back(entry2) {
      this.#entry = entry2;
      if (entry2.value !== null) this.form.value = entry2.value;
      const talking = Boolean(this.#entry.talk) && !this.#entry.before;
      const open2 = !this.isLocked && !talking;
      this.form.enable(open2);
      this.sure.show(this.#entry.sure, open2);
      this.button.disabled = !open2;
      this.talk.show(!this.isLocked && talking, false);
      if (this.#entry.before) this.#showAgain();
      if (!this.isLocked) return this.form.ready?.();
      this.again.offer();
      this.locked(false);
    }
    compare(run) {
      const place4 = need(this.root, ".carts-compared");
      place4.replaceChildren(...this.form.compare(run));
      const { before, why } = this.#entry;
      if (before) {
        const both2 = tr("First you said: {first}. After talking you said: {second}.", {
          first: before.said.replace(/[.。]$/, ""),
          second: this.form.said.replace(/[.。]$/, "")
        });
        place4.append(html("p", "", both2));
      }
      const once = this.form.once?.draw(this.#entry.now ?? null, (now) => {
        this.#entry.now = now;
        this.#told();
        void this.#keep();
      });
      place4.append(once ?? "");
      place4.hidden = false;
      if (!this.#entry.watched) {
        this.#entry.watched = (/* @__PURE__ */ new Date()).toISOString();
        void this.#keep();
      }
      this.why.show(why ?? "");
      this.again.offer();
    }
    get spoken() {
      const parts2 = this.root.querySelectorAll(
        ".carts-compared > [aria-label], .carts-compared p, .carts-compared li"
      );
      const texts = [...parts2].map((part) => part.getAttribute("aria-label") ?? part.textContent);
      return `${tr("Your prediction.")} ${texts.join(" ")}`;
    }
    complain(message) {
      say(this.error, message);
      this.error.hidden = !message;
    }
    async #changed() {
      if (this.isLocked) return;
      this.#entry.value = this.form.value;
      this.#entry.asked = this.spec.ask;
      this.#told();
      this.#entry.first ??= (/* @__PURE__ */ new Date()).toISOString();
      this.#entry.tries += 1;
      this.complain("");
      await this.#keep();
    }
    async #lock() {
      const problem = this.form.problem() || this.sure.passedOver();
      if (problem) return this.complain(problem);
      this.#entry.value = this.form.value;
      this.#entry.asked = this.spec.ask;
      this.#entry.first ??= (/* @__PURE__ */ new Date()).toISOString();
      this.#told();
      this.form.enable(false);
      this.sure.show(this.#entry.sure, false);
      this.button.disabled = true;
      this.complain("");
      if (!this.spec.talk || this.#entry.talk) return this.#finish();
      this.#entry.talk = (/* @__PURE__ */ new Date()).toISOString();
      await this.#keep();
      this.talk.show(true, true);
    }
    #change() {
      this.#entry.before = { value: this.#entry.value, said: this.form.said };
      this.talk.show(false, true);
      this.form.enable(true);
      this.sure.show(this.#entry.sure, true);
      this.#showAgain();
      this.button.disabled = false;
      void this.#keep();
    }
    #showAgain() {
      say(this.button, tr("Lock the changed prediction and show the run"));
    }
    async #finish() {
      this.#entry.locked = (/* @__PURE__ */ new Date()).toISOString();
      this.talk.show(false, true);
      await this.#keep();
      this.again.offer();
      this.locked(true);
    }
    #told() {
      const { before, why, now } = this.#entry;
      const parts2 = [this.form.said];
      if (now) parts2.push(tr("After the run: {said}", { said: this.form.once?.said(now) ?? "" }));
      if (before) parts2.push(tr("First: {said}", { said: before.said }));
      if (why) parts2.push(tr("Why: {said}", { said: why }));
      this.#entry.said = parts2.filter(Boolean).join(" · ");
    }
    async #forget() {
      try {
        await this.#keeping.forget(this.#entry);
        return true;
      } catch {
        this.complain(tr("This browser refuses to forget it."));
        return false;
      }
    }
    async #keep() {
      this.#entry.last = (/* @__PURE__ */ new Date()).toISOString();
      await this.#keeping.put(this.#entry);
    }
  };

  // src/shared/bring.js
  function bring(name, address) {
    const known2 = () => globalThis[name] ?? null;
    if (known2()) return Promise.resolve(known2());
    return new Promise((resolve) => {
      const script = document.createElement("script");
      script.src = address;
      script.onload = () => resolve(known2());
      script.onerror = () => {
        script.remove();
        resolve(null);
      };
      document.head.append(script);
    });
  }

  // src/scene/time/watch.js
  var PROJECTED = "carts-projector";
  var WATCHED = "carts-watched";
  var Watch = class {
    over = false;
    // a run was seen to its end: values may be changed
    whole = false;
    // and so was that of each ready-made setting
    constructor(element, baked, player, presets, acts) {
      this.element = element;
      this.player = player;
      this.presets = presets;
      this.acts = acts;
      this.first = baked.fence.watch === "first";
      this.asked = baked.fence.predict !== null;
      this.button = element.querySelector(".carts-end");
      this.button?.addEventListener("click", () => {
        if (this.whole) return compared(element).focus();
        player.pause();
        player.show(player.until);
      });
      if (this.first) player.seen = 0;
      player.ended = () => this.finish(element.classList.contains(PROJECTED));
      const before = this.first ? remembered() : [];
      presets.seen(presets.names.filter((name) => !this.first || before.includes(this.#of(name))));
      if (!this.asked && before.includes(this.#name)) this.#end();
    }
    finish(all = false) {
      const begun2 = this.over;
      const hidden = this.player.seen !== Infinity;
      const here = all ? this.presets.names : this.presets.pressed;
      this.over = true;
      this.player.seen = Infinity;
      if (!this.whole) {
        this.presets.seen(here);
        if (!all) remember2(here.map((name) => this.#of(name)));
        this.#offer(false);
      }
      const done = !this.whole && this.presets.left.length === 0;
      if (done) this.#end();
      if (!begun2 || done || hidden) this.player.seek(this.player.time);
      if (!begun2) this.acts.first();
      if (done) {
        this.acts.all();
        this.#lead();
      }
    }
    preset(name, draw) {
      const { player } = this;
      const waits = this.first && this.presets.left.includes(name);
      const before = player.seen;
      player.pause();
      if (waits) player.seen = 0;
      player.seek(0);
      void draw().then((drawn2) => {
        if (!drawn2) {
          player.seen = before;
          return player.seek(0);
        }
        if (!waits) {
          if (this.first) player.seen = Infinity;
          return player.seek(player.time);
        }
        this.#offer(true);
        player.play();
      });
    }
    back() {
      const waits = this.presets.pressed.some((name) => this.presets.left.includes(name));
      if (this.over && !waits) {
        this.player.seen = Infinity;
        if (!this.whole) this.#offer(false);
      }
      this.player.seek(0);
    }
    #end() {
      this.over = true;
      this.whole = true;
      this.player.seen = Infinity;
      this.presets.seen(this.presets.names);
      this.#offer(false);
      if (!this.asked) remember2([this.#name]);
      this.element.dataset.watched = "";
      this.element.dispatchEvent(new CustomEvent(WATCHED, { bubbles: true }));
    }
    #lead() {
      if (!this.button || !this.asked || compared(this.element).hidden) return;
      say(this.button, tr("My prediction ↓"));
      this.#offer(true);
    }
    #offer(on) {
      if (this.button) this.button.style.visibility = on ? "" : "hidden";
    }
    get #name() {
      return nameOf2(this.element);
    }
    #of(preset) {
      return `${this.#name}/${preset}`;
    }
  };
  var compared = (element) => need(element, ".carts-compared");
  var KEY = "carts-watched";
  function remembered() {
    return recall(KEY) ?? [];
  }
  function forgetWatched(element) {
    const name = nameOf2(element);
    delete element.dataset.watched;
    const others = remembered().filter((one) => one !== name && !one.startsWith(`${name}/`));
    retain(KEY, others);
    element.dispatchEvent(new Event("carts-unwatched", { bubbles: true }));
  }
  var nameOf2 = (element) => `${location.pathname}#${element.id}`;
  function remember2(names) {
    if (names.length) retain(KEY, [.../* @__PURE__ */ new Set([...remembered(), ...names])]);
  }

  // src/scene/how/words.js
  var LOCKED = tr(
    "Make your prediction and lock it first. Then you can see how the run is computed."
  );
  var UNWATCHED = tr("Watch the run to its end first: this tells what happens in it.");
  var PLAN = tr("The plan, found before anything moves:");
  var MEASURING = tr("Measuring on this computer …");
  var NO_PYTHON = tr("Python does not run here, so nothing can be measured.");
  var SWITCH = tr(
    "What if a program went step by step? The run then plays as that method computes it. Dashed: exact."
  );
  var LOADING3 = tr("Python’s scipy is being loaded …");
  var METHOD = tr("method");
  var STEP3 = tr("step");
  var TOLERANCE = tr("tolerance");
  var EXACT2 = tr("exact (as always)");
  var FAILED = tr("The exact run is shown.");
  var METHODS3 = {
    euler: "Euler",
    "semi-implicit": tr("semi-implicit Euler"),
    verlet: tr("velocity Verlet"),
    rk4: "RK4",
    "rk4-events": tr("RK4 + located touches"),
    rk45: tr("adaptive RK45 + located touches"),
    adaptive: tr("adaptive DOP853 + located touches")
  };
  var SOLVERS = {
    "free-flight": tr("free flight, exact"),
    flight: tr("flight with forces, exact"),
    "pair-contact": tr("one contact at a time, exact"),
    "power-series": tr("several forces at once, exact to rounding"),
    adaptive: tr("no formula: an adaptive method with located touches")
  };
  var USED = {
    "free-flight": tr("free flights"),
    flight: tr("flights"),
    "pair-contact": tr("contacts"),
    "pair-phase": tr("contacts with other forces"),
    "power-series": tr("series for several forces"),
    modes: tr("sums of swings"),
    adaptive: tr("steps of an adaptive method"),
    instant: tr("impacts")
  };
  function phaseWords({ from, until, solver, why }, decimals) {
    const times2 = tr("{from} to {until} s", {
      from: fixed(from, decimals),
      until: fixed(until, decimals)
    });
    const sentence = ended(capital(told(why)));
    return [times2, SOLVERS[solver] ?? solver, sentence];
  }
  function duration(seconds) {
    if (seconds >= 1) return `${short(seconds, 2)} s`;
    if (seconds >= 1e-3) return `${short(1e3 * seconds, 2)} ms`;
    return `${short(1e6 * seconds, 2)} µs`;
  }
  function formulasWords(solvers) {
    const used = Object.entries(solvers).map(([name, count2]) => `${USED[name] ?? name}: ${count2}`);
    return used.length ? tr("Formulas worked out, {counts}.", { counts: inRow(used) }) : "";
  }
  function costWords({ cost }) {
    const all = cost.solution + cost.points;
    return tr(
      "On this computer, just now: {all}, of which {motion} for the motion and {points} for the points of the curves.",
      { all: duration(all), motion: duration(cost.solution), points: duration(cost.points) }
    );
  }
  function sizeWords({ step, rtol, steps: steps2 }) {
    if (rtol) return tr("tolerance {size}", { size: toleranceWords(rtol) });
    return counted("1 step of {step}", "{n} steps of {step}", Number(steps2), {
      step: duration(Number(step))
    });
  }
  function stepWords(until, parts2) {
    return tr("{step} (run / {parts})", { step: duration(until / parts2), parts: parts2 });
  }
  function toleranceWords(rtol) {
    return `1e${Math.round(Math.log10(rtol))}`;
  }
  function signWords(how) {
    return tr("Step by step: {method}, {size}. Not exact. Dashed: exact.", {
      method: String(METHODS3[how.method]),
      size: sizeWords(how)
    });
  }
  var BEYOND = tr("beyond all numbers");
  var UNKNOWN = tr("not known: the exact run was stopped before");
  var MANY3 = 10;
  function comparedWords(how) {
    const { error, energy, seconds, evaluations, blown, whole } = how;
    const rows = [
      [tr("largest error of a velocity at the end"), whole ? amount2(error.v, "m/s") : UNKNOWN],
      [tr("largest error of a position at the end"), whole ? amount2(error.x, "m") : UNKNOWN],
      [tr("energy made from nothing"), made(energy)],
      [tr("times that all forces were computed"), String(evaluations)],
      [tr("time on this computer"), ratioWords(seconds)]
    ];
    if (blown !== null) {
      const until = tr("at {time} s; drawn up to there", { time: fixed(blown, 2) });
      rows.unshift([tr("the numbers blow up"), until]);
    }
    return rows;
  }
  function amount2(value, unit) {
    return value === null ? BEYOND : `${short(value, 2)} ${unit}`;
  }
  function made({ made: joules2, initial }) {
    if (joules2 === null) return BEYOND;
    if (!(initial > 0)) return `${short(joules2, 2)} J`;
    const part = joules2 / initial;
    const size = {
      energy: `${short(joules2, 2)} J`,
      part: short(part, 2),
      percent: short(100 * part, 2)
    };
    return Math.abs(part) < MANY3 ? tr("{energy}, {percent} % of the energy at the start", size) : tr("{energy}, {part} times the energy at the start", size);
  }
  function ratioWords({ stepped, exact }) {
    const ratio = stepped / exact;
    const both2 = { stepped: duration(stepped), exact: duration(exact) };
    return ratio >= 1 ? tr("{stepped}, {ratio} times the exact run’s {exact}", { ...both2, ratio: short(ratio, 2) }) : tr("{stepped}; the exact run takes {ratio} times as long, {exact}", {
      ...both2,
      ratio: short(1 / ratio, 2)
    });
  }

  // src/scene/how/panel.js
  var EXACT3 = "exact";
  var PARTS2 = [19, 37, 61, 103, 211, 499, 997, 1999, 4999];
  var OPENS_AT = 3;
  var TOLERANCES = [1e-3, 1e-6, 1e-9, 1e-12];
  var ADAPTIVE2 = ["rk45", "adaptive"];
  var HowPanel = class {
    constructor(place4, scipy, changed) {
      this.until = 1;
      this.plan = html("ol", "carts-how-plan");
      this.plan.tabIndex = 0;
      this.plan.setAttribute("aria-label", tr("Plan"));
      this.cost = html("p", "carts-how-cost");
      this.method = document.createElement("select");
      this.method.className = "carts-how-method";
      this.method.append(option(EXACT3, EXACT2));
      for (const [name, label] of Object.entries(METHODS3)) {
        if (scipy || !ADAPTIVE2.includes(name)) this.method.append(option(name, label));
      }
      this.slider = document.createElement("input");
      this.slider.type = "range";
      this.slider.className = "carts-how-step";
      this.slider.min = "0";
      this.size = html("output");
      this.kind = html("span");
      this.stepRow = html("label");
      this.stepRow.append(this.kind, " ", this.slider, " ", this.size);
      const methodRow = html("label", "", `${METHOD} `);
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
      place4.replaceChildren(
        html("p", "carts-how-head", PLAN),
        this.plan,
        this.cost,
        html("p", "carts-how-head", SWITCH),
        row,
        this.note,
        this.table
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
    get choice() {
      const method = this.method.value;
      if (method === EXACT3) return null;
      const place4 = this.slider.valueAsNumber;
      return ADAPTIVE2.includes(method) ? { method, rtol: TOLERANCES[place4] ?? 1e-9 } : { method, parts: PARTS2[place4] ?? 103 };
    }
    reset() {
      this.method.value = EXACT3;
      this.#range();
      this.tell([]);
      say(this.note, "");
    }
    show({ header }, decimals) {
      this.until = header.until;
      this.#size();
      const lines4 = header.plan.map((phase) => {
        const [times2, how, why] = phaseWords(phase, decimals);
        const line3 = html("li");
        line3.append(html("b", "", times2), ` ${how}. `, html("span", "carts-quiet", why));
        return line3;
      });
      this.plan.replaceChildren(...lines4);
    }
    tell(lines4) {
      this.table.hidden = lines4.length === 0;
      const rows = lines4.map(([head, value]) => {
        const row = html("tr");
        const first = html("th", "", head);
        first.setAttribute("scope", "row");
        row.append(first, html("td", "", value));
        return row;
      });
      this.told.replaceChildren(...rows);
    }
    #range() {
      const adaptive = ADAPTIVE2.includes(this.method.value);
      const kind2 = adaptive ? TOLERANCE : STEP3;
      if (this.kind.textContent !== kind2) {
        this.slider.max = String((adaptive ? TOLERANCES : PARTS2).length - 1);
        this.slider.value = String(adaptive ? 1 : OPENS_AT);
      }
      say(this.kind, kind2);
      this.stepRow.hidden = this.method.value === EXACT3;
      this.#size();
    }
    #size() {
      const chosen = this.choice;
      if (!chosen) return;
      const text = "rtol" in chosen ? toleranceWords(chosen.rtol) : stepWords(this.until, chosen.parts);
      say(this.size, text);
      this.slider.setAttribute("aria-valuetext", text);
    }
  };
  function option(value, text) {
    const made4 = html("option", "", text);
    made4.setAttribute("value", value);
    return made4;
  }

  // src/scene/how/how.js
  var PACKAGES2 = ["numpy", "scipy"];
  var PROOF = besideScript("proof.js");
  var REST = 400;
  var How = class {
    #panel = null;
    #exact = null;
    #sign = null;
    #turn = 0;
    #timer = 0;
    #measuring = {};
    // an owner of its own: a measurement is no newer run
    #proof = null;
    constructor(root, view, client2, message, signal) {
      this.root = root;
      this.view = view;
      this.client = client2;
      this.message = message;
      this.details = need(root, ".carts-how");
      this.details.addEventListener("toggle", () => this.#opened());
      root.addEventListener(WATCHED, () => this.#opened(), { signal });
    }
    async follow(run) {
      this.#exact = run;
      this.#turn += 1;
      this.#proof?.forget();
      this.#opened();
      if (this.#panel?.choice) await this.#step();
      else this.#showExact();
    }
    reset() {
      this.#panel?.reset();
      this.#turn += 1;
    }
    #showExact() {
      this.#sign?.remove();
      this.#sign = null;
      if (this.#exact) this.view.show(this.#exact);
    }
    #opened() {
      clearTimeout(this.#timer);
      const run = this.#exact ?? this.view.run;
      if (!this.details.open) return;
      const place4 = need(this.details, ".carts-how-body");
      const watched = this.view.player.seen === Infinity;
      if (!isTold(run) || !watched) {
        this.#panel = this.#proof = null;
        place4.replaceChildren(html("p", "", isTold(run) ? UNWATCHED : LOCKED));
        return;
      }
      if (!this.#panel) {
        this.#panel = new HowPanel(place4, canHaveScipy(), () => void this.#chosen());
        void this.#offerProof(this.#panel, place4);
      }
      this.#panel.show(run, this.view.baked.view.decimals.t ?? 2);
      if (this.#panel.choice) return;
      say(this.#panel.cost, this.client.state === "failed" ? NO_PYTHON : MEASURING);
      this.#timer = setTimeout(() => void this.#measure(), this.view.player.playing ? REST : 0);
    }
    async #offerProof(panel, place4) {
      const Proof = await bring("cartsProof", PROOF);
      if (!Proof || panel !== this.#panel) return;
      this.#proof = new Proof(this.view, place4, this.client, this.message);
    }
    async #measure() {
      const turn = this.#turn;
      try {
        const { header } = await this.client.ask(this.#measuring, () => this.message({}));
        if (turn !== this.#turn || !this.#panel) return;
        const answer = header;
        const used = this.#exact?.header?.evaluations?.solvers ?? {};
        const formulas = formulasWords(used);
        if (header.ok) say(this.#panel.cost, `${formulas} ${costWords(answer)}`.trim());
      } catch {
        if (this.#panel) say(this.#panel.cost, NO_PYTHON);
      }
    }
    async #chosen() {
      this.#turn += 1;
      if (this.#panel?.choice) return this.#step();
      this.#panel?.reset();
      this.#showExact();
      this.#opened();
    }
    async #step() {
      const panel = this.#panel;
      const exact = this.#exact ?? this.view.run;
      this.#exact = exact;
      const turn = this.#turn;
      if (!panel?.choice) return;
      try {
        if ("rtol" in panel.choice && !pageHasScipy()) {
          say(panel.note, LOADING3);
          await this.client.need(PACKAGES2);
        }
        const { header, numbers } = await this.client.ask(
          this,
          () => this.message({ ...panel.choice })
        );
        if (turn !== this.#turn) return;
        if (!header.ok) throw refusal(header.problems ?? []);
        const how = header.how;
        this.view.show({ header, trajectory: fromWire(header, numbers) }, exact);
        panel.tell(comparedWords(how));
        say(panel.note, "");
        this.#tellBeside(signWords(how));
      } catch (error) {
        if (turn !== this.#turn) return;
        this.#showExact();
        panel.tell([]);
        say(panel.note, `${error.message} ${FAILED}`);
      }
    }
    #tellBeside(text) {
      if (!this.#sign) {
        this.#sign = html("p", "carts-how-sign");
        this.#sign.setAttribute("role", "status");
        need(this.root, ".carts-world").append(this.#sign);
      }
      say(this.#sign, text);
    }
  };
  function pageHasScipy() {
    return document.querySelector('carts-scene[data-packages~="scipy"]') !== null;
  }
  function canHaveScipy() {
    return pageHasScipy() || document.querySelector("carts-cost") !== null;
  }

  // src/scene/ladder.js
  var REST2 = 400;
  var Ladder = class {
    #run = null;
    #turn = 0;
    #timer = 0;
    #owner = {};
    // of its own: an estimate is no newer run
    constructor(root, client2, message) {
      this.client = client2;
      this.message = message;
      this.details = need(root, ".carts-model");
      this.details.addEventListener("toggle", () => this.#opened(0));
    }
    follow(run) {
      this.#run = run;
      this.#turn += 1;
      this.#opened(REST2);
    }
    #opened(wait) {
      clearTimeout(this.#timer);
      if (!this.details.open || !this.#run || !isTold(this.#run)) return;
      this.#timer = setTimeout(() => void this.#ask(), wait);
    }
    async #ask() {
      const turn = this.#turn;
      const place4 = this.#place();
      const note2 = need(place4, ".carts-ladder-note");
      say(note2, tr("The scene is run once with each effect and once without …"));
      try {
        const { header } = await this.client.ask(this.#owner, this.message);
        if (turn !== this.#turn) return;
        const { ok, rungs, reads } = header;
        if (!ok) throw new Error("refused");
        need(place4, ".carts-ladder").replaceChildren(...lines2(rungs, reads));
        say(note2, "");
      } catch {
        if (turn !== this.#turn) return;
        need(place4, ".carts-ladder").replaceChildren();
        say(note2, tr("What effects would change cannot be computed here."));
      }
    }
    #place() {
      const there = this.details.querySelector(".carts-ladder-box");
      if (there) return there;
      const box2 = html("div", "carts-ladder-box");
      const note2 = html("p", "carts-ladder-note carts-quiet");
      note2.setAttribute("role", "status");
      box2.append(
        html("p", "carts-how-head", tr("What does this scene call for? Largest first:")),
        html("ol", "carts-ladder"),
        note2
      );
      this.details.append(box2);
      return box2;
    }
  };
  function lines2(rungs, reads) {
    const known2 = rungs.filter(({ changes: changes2, listed: listed2 }) => changes2 || listed2);
    const shown3 = known2.filter(({ visible }) => visible).map(line);
    const hidden = known2.filter(({ visible }) => !visible).map(line);
    const between2 = html(
      "li",
      "carts-ladder-line",
      tr("What is less than {part} % of its height, a graph cannot show:", {
        part: short(100 * reads)
      })
    );
    return [...shown3, between2, ...hidden];
  }
  function line({ sentence, source, listed: listed2 }) {
    const item = html("li", listed2 ? "carts-ladder-listed" : "");
    item.append(capital(told(sentence)));
    if (source) item.append(" ", html("span", "carts-quiet", `(${told(source)})`));
    return item;
  }

  // src/scene/presets.js
  var Presets = class {
    #seen = /* @__PURE__ */ new Set();
    constructor(root, fence, choose) {
      this.presets = fence.presets;
      this.numbers = fence.presetNumbers;
      this.buttons = root.querySelectorAll(".carts-preset");
      this.line = root.querySelector(".carts-presets-left");
      for (const button of this.buttons) {
        button.addEventListener("click", () => {
          choose(this.#of(button), button.dataset.preset ?? "");
        });
      }
    }
    get names() {
      return Object.keys(this.presets);
    }
    get pressed() {
      return [...this.buttons].filter((button) => button.getAttribute("aria-pressed") === "true").map((button) => button.dataset.preset ?? "");
    }
    get left() {
      return this.names.filter((name) => !this.#seen.has(name));
    }
    #of(button) {
      return this.presets[button.dataset.preset ?? ""] ?? {};
    }
    show(settings, header) {
      for (const button of this.buttons) {
        const values = Object.entries(this.#of(button));
        const numbers = this.numbers[button.dataset.preset ?? ""];
        const asked4 = values.every(([target, value]) => settings[target] === value);
        const same = values.every(([target, value]) => {
          const what = thingIn(header, target);
          return what ? what === value : valueIn(header, target) === numbers?.[target];
        });
        put(button, "aria-pressed", String(values.length > 0 && (asked4 || same)));
      }
    }
    seen(names) {
      for (const name of names) this.#seen.add(name);
      if (!this.line) return;
      for (const button of this.buttons) {
        button.toggleAttribute("data-seen", this.#seen.has(button.dataset.preset ?? ""));
      }
      if (!this.#seen.size) return;
      const left2 = inRow(this.left);
      say(this.line, left2 ? tr("Still to watch: {names}", { names: left2 }) : tr("All watched."));
    }
  };
  function thingIn({ track }, target) {
    const side = /^track\.(left|right)_is$/.exec(target)?.[1];
    return side ? whatIs(side, track) : "";
  }

  // src/scene/projector.js
  var MOST_HANDS = 999;
  var listening = /* @__PURE__ */ new WeakSet();
  function offerProjector(scene) {
    const button = need(scene, ".carts-project");
    button.disabled = false;
    const bar2 = html("p", "carts-project-bar");
    const [reveal, next] = [
      made2("carts-button", tr("Reveal")),
      made2("carts-button", tr("Next scene"))
    ];
    bar2.append(reveal, " ", next);
    need(scene, ".carts-frame").append(bar2);
    button.addEventListener("click", () => void project(scene, !isOn(scene)));
    reveal.addEventListener("click", () => void scene.reveal?.());
    next.addEventListener("click", () => {
      const all = [...document.querySelectorAll("carts-scene")];
      const following = all[(all.indexOf(scene) + 1) % all.length];
      if (following) void project(following, true);
    });
    for (const option2 of scene.querySelectorAll(".carts-options label")) count(scene, option2);
    if (listening.has(scene)) return;
    listening.add(scene);
    scene.addEventListener("keydown", (event) => {
      const typing = event.target.matches(
        "input:not([type=range]), textarea, select"
      );
      if (typing || event.repeat || event.ctrlKey || event.metaKey || event.altKey) return;
      if (event.key.toLowerCase() === "p") void project(scene, !isOn(scene));
    });
  }
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") for (const scene of shown2()) void project(scene, false);
  });
  var left = 0;
  document.addEventListener("fullscreenchange", () => {
    const own = left > 0;
    left = document.fullscreenElement ? 0 : Math.max(0, left - 1);
    if (document.fullscreenElement || own) return;
    for (const scene of shown2()) mark(scene, false);
  });
  var shown2 = () => document.querySelectorAll(`.${PROJECTED}`);
  var isOn = (scene) => scene.classList.contains(PROJECTED);
  async function project(scene, on) {
    for (const other of shown2()) if (other !== scene) mark(other, false);
    mark(scene, on);
    if (!on) {
      if (!document.fullscreenElement) return;
      left += 1;
      await document.exitFullscreen().catch(() => left = 0);
      return;
    }
    await document.documentElement.requestFullscreen?.().catch(() => {
    });
    need(scene, ".carts-project").focus();
  }
  function mark(scene, on) {
    if (!on && isOn(scene)) void scene.conceal?.();
    scene.classList.toggle(PROJECTED, on);
    document.documentElement.classList.toggle("carts-projecting", shown2().length > 0);
    const button = scene.querySelector(".carts-project");
    if (button) say(button, on ? tr("Leave projector (Esc)") : tr("projector"));
  }
  function count(scene, option2) {
    const line3 = html("span", "carts-hands");
    const box2 = document.createElement("input");
    box2.type = "number";
    box2.min = "0";
    box2.max = String(MOST_HANDS);
    box2.setAttribute(
      "aria-label",
      tr("hands for: {option}", { option: String(option2.textContent?.trim()) })
    );
    const bar2 = document.createElement("meter");
    bar2.setAttribute("aria-hidden", "true");
    const part = html("span");
    line3.append(box2, bar2, part);
    option2.after(line3);
    box2.addEventListener("input", () => {
      const boxes = scene.querySelectorAll(".carts-hands input");
      const hands = (one) => Math.min(MOST_HANDS, Math.max(0, Math.round(one.valueAsNumber || 0)));
      const all = [...boxes].reduce((sum, one) => sum + hands(one), 0);
      for (const one of boxes) {
        const share = all ? hands(one) / all : 0;
        const meter = one.nextElementSibling;
        meter.value = share;
        say(
          meter.nextElementSibling,
          tr("{part} of {all}", { part: hands(one), all })
        );
      }
    });
  }
  function made2(className, text) {
    const button = document.createElement("button");
    button.type = "button";
    button.className = className;
    button.textContent = text;
    return button;
  }

  // src/shared/spreadsheet.js
  var CELL = /("(?:[^"]|"")*"|[^,\r\n"]*)(,|\r?\n|$)/g;
  var NUMBER = /^-?\d+(?:\.\d+)?(?:e[+-]?\d+)?$/i;
  function forSpreadsheet(csv2, language = navigator.language) {
    if (!hasComma(language)) return csv2;
    return csv2.replace(CELL, (_2, cell3, end2) => written(cell3) + (end2 === "," ? ";" : end2));
  }
  function written(cell3) {
    if (NUMBER.test(cell3)) return cell3.replace(".", ",");
    return cell3.includes(";") && !cell3.startsWith('"') ? `"${cell3}"` : cell3;
  }
  function hasComma(language) {
    try {
      return new Intl.NumberFormat(language).format(0.5).includes(",");
    } catch {
      return false;
    }
  }

  // src/shared/download.js
  var FORGOTTEN_AFTER = 6e4;
  function download(name, text, type) {
    const saved = type === "text/csv" ? forSpreadsheet(text) : text;
    downloadBlob(name, new Blob([saved], { type }));
  }
  function downloadBlob(name, blob) {
    const link = document.createElement("a");
    const address = URL.createObjectURL(blob);
    link.href = address;
    link.download = name;
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(address), FORGOTTEN_AFTER);
  }

  // src/shared/picture.js
  var PROPERTIES = [
    "fill",
    "fill-opacity",
    "stroke",
    "stroke-width",
    "stroke-dasharray",
    "stroke-linecap",
    "stroke-linejoin",
    "opacity",
    "visibility",
    "font-family",
    "font-size",
    "font-weight",
    "font-style",
    "text-anchor",
    "paint-order",
    "x",
    "y",
    "height"
  ];
  var WIDTH3 = 720;
  var GAP = 12;
  var LINE2 = 20;
  var SIZE = 13;
  var PIXELS = 2;
  function picture(scene) {
    const paper = getComputedStyle(scene).getPropertyValue("--carts-paper") || "#fff";
    const ink = getComputedStyle(scene).color;
    const whole = svg("svg", { xmlns: "http://www.w3.org/2000/svg", width: WIDTH3 });
    const sheet = svg("rect", { width: WIDTH3, fill: paper });
    whole.append(sheet);
    let y2 = GAP;
    const write4 = (text, x2, at3, weight, width) => {
      const lines4 = broken(text, width, weight);
      lines4.forEach((words, k) => {
        const line3 = svg("text", {
          x: x2,
          y: at3 + LINE2 * k,
          fill: ink,
          "font-family": "sans-serif",
          "font-size": SIZE,
          "font-weight": weight
        });
        line3.textContent = words;
        whole.append(line3);
      });
      return lines4.length;
    };
    const title = scene.querySelector(".carts-title")?.textContent ?? "";
    y2 += LINE2 * write4(title, GAP, y2 + 12, "700", WIDTH3 - 2 * GAP) + 4;
    const stage = [...scene.querySelectorAll(".carts-stage")].find((one) => one.clientWidth);
    if (stage) {
      const drawn2 = alone2(stage);
      const height = place3(drawn2, 0, y2, WIDTH3);
      const sky = getComputedStyle(stage.closest(".carts-world") ?? stage).backgroundColor;
      whole.append(svg("rect", { y: y2, width: WIDTH3, height, fill: sky }), drawn2);
      y2 += height + GAP;
    }
    const graphs = [...scene.querySelectorAll(".carts-graph")];
    const half = WIDTH3 / 2;
    for (let k = 0; k < graphs.length; k += 2) {
      let tallest = 0;
      graphs.slice(k, k + 2).forEach((graph2, column) => {
        const plot2 = graph2.querySelector(".carts-plot");
        if (!plot2) return;
        const x2 = column * half;
        const name = graph2.querySelector(".carts-graph-name")?.textContent ?? "";
        write4(name, x2 + GAP, y2 + 12, "700", WIDTH3);
        const drawn2 = alone2(plot2);
        const height = place3(drawn2, x2, y2 + LINE2, half - GAP);
        whole.append(drawn2);
        const entries = [...graph2.querySelectorAll(".carts-key > span")];
        let rows = 0;
        for (const entry2 of entries) {
          const at3 = y2 + LINE2 + height + 14 + LINE2 * rows;
          const sample = entry2.querySelector("svg");
          if (sample) {
            const swatch = alone2(sample);
            place3(swatch, x2 + GAP, at3 - 10, 26);
            whole.append(swatch);
          }
          const indent = GAP + (sample ? 34 : 0);
          rows += write4(entry2.textContent ?? "", x2 + indent, at3, "400", half - indent - GAP);
        }
        tallest = Math.max(tallest, LINE2 + height + LINE2 * rows);
      });
      y2 += tallest + GAP;
    }
    for (const part of [whole, sheet]) part.setAttribute("height", String(Math.ceil(y2)));
    whole.setAttribute("viewBox", `0 0 ${WIDTH3} ${Math.ceil(y2)}`);
    return new XMLSerializer().serializeToString(whole);
  }
  function alone2(original) {
    const copy = original.cloneNode(true);
    const [from, to] = [
      [original, ...original.querySelectorAll("*")],
      [copy, ...copy.querySelectorAll("*")]
    ];
    from.forEach((part, i2) => {
      const style = getComputedStyle(part);
      const made4 = to[i2];
      if (style.display === "none" && part.closest("defs") === null)
        made4.setAttribute("display", "none");
      for (const property of PROPERTIES) {
        const value = style.getPropertyValue(property);
        const geometry = ["x", "y", "height"].includes(property);
        if (geometry && (part.tagName !== "rect" || made4.hasAttribute(property))) continue;
        if (value && value !== "auto") made4.setAttribute(property, value.replaceAll('"', "'"));
      }
      made4.removeAttribute("class");
    });
    return copy;
  }
  function broken(text, width, weight) {
    const pen = document.createElement("canvas").getContext("2d");
    if (!pen) return [text];
    pen.font = `${weight} ${SIZE}px sans-serif`;
    const lines4 = [""];
    for (const part of text.trim().split(/(?<=\s)|(?<=[\u3000-\u9fff])/u)) {
      const longer = `${lines4.at(-1)}${part}`;
      if (lines4.at(-1) && pen.measureText(longer.trimEnd()).width > width) lines4.push(part);
      else lines4[lines4.length - 1] = longer;
    }
    return lines4.map((line3) => line3.trimEnd());
  }
  function place3(drawn2, x2, y2, width) {
    const [, , w2 = 1, h2 = 1] = (drawn2.getAttribute("viewBox") ?? "0 0 1 1").split(" ").map(Number);
    const height = width * h2 / w2;
    for (const [name, value] of Object.entries({ x: x2, y: y2, width, height })) {
      drawn2.setAttribute(name, String(value));
    }
    return height;
  }
  async function asPng(text) {
    const image = new Image();
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = image.naturalWidth * PIXELS;
    canvas.height = image.naturalHeight * PIXELS;
    canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
    return new Promise((resolve, reject) => {
      canvas.toBlob(
        (blob) => blob ? resolve(blob) : reject(new Error("no picture was made")),
        "image/png"
      );
    });
  }

  // ../view/effects-forces.js
  var FEW2 = 3;
  function forcesAt({ header, trajectory }, t3, always = false) {
    const found3 = [];
    for (const kind2 of kindsOnOne(header)) {
      const acting = header.effects.filter(
        (effect) => effect.kind === kind2 && (always ? effect.active : actsAt(effect, t3))
      );
      for (const { name } of header.bodies) {
        const own = acting.filter((effect) => effect.carts.includes(name));
        const column = trajectory.E[`${kind2} ${name}`];
        if (!own.length || !column?.length) continue;
        const peak = greatest2(column);
        const on = own.some((effect) => actsAt(effect, t3));
        const exact = on ? valueAt(trajectory.t, column, null, t3) : 0;
        const value = Math.abs(exact) <= NOISE * peak ? 0 : exact;
        const size = value ? fixed(Math.abs(value), decimalsFor(peak || 1)) : "0";
        found3.push({ kind: kind2, on: name, by: listed([...new Set(own.map(agent))]), value, size });
      }
    }
    return found3;
  }
  function partsOf(header, run, name) {
    return kindsOnOne(header).flatMap((kind2) => {
      const own = header.effects.filter(
        (effect) => effect.kind === kind2 && effect.active && effect.carts.includes(name)
      );
      const column = run.E[`${kind2} ${name}`];
      return own.length && column?.length ? [{ by: listed([...new Set(own.map(agent))]), column }] : [];
    });
  }
  function labels({ kind: kind2, on, by, size }) {
    const told4 = { on, by, size };
    const brief2 = { ...told4, by: by.replaceAll("the ", "") };
    return [
      viewOf(kind2).label?.(told4) ?? tr("on {on} by {by}: {size} N", told4),
      tr("on {on} by {by}: {size} N", brief2),
      tr("by {by}: {size} N", brief2)
      // whose force it is tells the line from the cart
    ];
  }
  function outside2(header) {
    const { effects, track } = header;
    const sides = ["left", "right"];
    const walls = sides.filter((side) => track[side] === "wall").map((side) => kind(side, track));
    const kinds = kindsOnOne(header).map(viewOf);
    const media = kinds.map(({ around }) => typeof around === "string" ? around : "");
    const others = effects.map((effect) => {
      const { around } = viewOf(effect.kind);
      return typeof around === "function" ? around(effect, agent(effect)) : "";
    });
    const earth = walls.length || kinds.some((view) => view.earth) ? tr("Earth") : "";
    const parts2 = [...walls, ...media, ...others, earth];
    return [...new Set(parts2.filter(Boolean))].join(" + ");
  }
  var known = /* @__PURE__ */ new WeakMap();
  function greatest2(column) {
    const before = known.get(column);
    if (before !== void 0) return before;
    let most = 0;
    for (let k = 0; k < column.length; k += 1) most = Math.max(most, Math.abs(Number(column[k])));
    known.set(column, most);
    return most;
  }

  // ../view/series.js
  function seriesOf(quantity, header, run, camera, signed = false, per = 1) {
    if (quantity === "F") return forces(header, run, signed);
    if (quantity === "R") return resultants(header, run);
    const times2 = Float64Array.from(run.t);
    const curves = header.bodies.map((body2, i2) => {
      const { name, mass } = body2;
      const [x2, v2, a2] = [run.x[name] ?? [], run.v[name] ?? [], run.a[name] ?? []];
      const seen = Float64Array.from(v2, (speed) => speed - camera);
      const curve2 = { label: name, style: styleOf(i2), over: false };
      switch (quantity) {
        case "x": {
          const values = Float64Array.from(x2, (place4, k) => place4 - camera * Number(times2[k]));
          return { ...curve2, values, slopes: seen };
        }
        case "v":
          return {
            ...curve2,
            values: seen.map((speed) => speed / per),
            slopes: Float64Array.from(a2, (rate) => rate / per)
          };
        case "a":
          return { ...curve2, values: a2, slopes: jerk(header, run, body2, 1 / mass) };
        case "p":
          return {
            ...curve2,
            values: seen.map((speed) => mass * speed),
            slopes: Float64Array.from(a2, (value) => mass * value)
          };
        default:
          return {
            ...curve2,
            values: seen.map((speed) => mass * speed * speed / 2),
            slopes: Float64Array.from(a2, (rate, k) => mass * Number(seen[k]) * rate)
          };
      }
    });
    if (quantity === "p" && outside2(header)) curves.push(partner(curves, outside2(header)));
    if ((quantity === "p" || quantity === "energy") && curves.length > 1) curves.push(total(curves));
    return curves;
  }
  function resultants(header, run) {
    return header.bodies.flatMap((body2, i2) => {
      const { name, mass } = body2;
      const style = styleOf(i2);
      const values = Float64Array.from(run.a[name] ?? [], (rate) => mass * rate);
      const parts2 = partsOf(header, run, name).map(({ by, column }) => ({
        label: tr("on {on} by {by}", { on: body(name, header.track), by }),
        style,
        over: true,
        values: column,
        slopes: null
      }));
      const slopes = jerk(header, run, body2, 1);
      return [{ label: name, style, over: false, values, slopes }, ...parts2];
    });
  }
  function jerk(header, run, { name }, per) {
    if (header.effects.some(({ active, carts }) => active && carts.includes(name))) return null;
    const found3 = new Float64Array(run.t.length);
    for (const { pair, bodies } of header.contacts) {
      const column = bodies.includes(name) ? run.dF[pair] : null;
      const sign = bodies[0] === name ? -per : per;
      for (let k = 0; column && k < found3.length; k += 1) {
        found3[k] = Number(found3[k]) + sign * Number(column[k]);
      }
    }
    return found3;
  }
  function partner(curves, label) {
    const { values, slopes } = total(curves);
    const start = Number(values[0]);
    return {
      label,
      style: "wall",
      over: false,
      values: Float64Array.from(values, (value) => start - value),
      slopes: slopes && Float64Array.from(slopes, (slope) => -slope)
    };
  }
  function total(curves) {
    const sum = (columns) => {
      const rows = Float64Array.from(columns[0] ?? []);
      for (const column of columns.slice(1)) {
        for (let k = 0; k < rows.length; k += 1) rows[k] = Number(rows[k]) + Number(column?.[k]);
      }
      return rows;
    };
    return {
      label: curves.some(({ style }) => style === "wall") ? tr("all together") : tr("all carts"),
      style: "total",
      over: false,
      values: sum(curves.map((c2) => c2.values)),
      slopes: curves.every((c2) => c2.slopes) ? sum(curves.map((c2) => c2.slopes)) : null
    };
  }
  function forces(header, run, signed) {
    const styles = new Map(header.bodies.map((body2, i2) => [body2.name, styleOf(i2)]));
    const sign = signed ? -1 : 1;
    const curves = [];
    for (const contact of header.contacts) {
      let force2 = run.F[contact.pair];
      let slope = run.dF[contact.pair];
      if (!force2 || !slope || !Array.prototype.some.call(force2, (f2) => f2 !== 0)) continue;
      if (!signed) {
        const pulls = Array.from(force2, (f2) => f2 < 0);
        slope = Float64Array.from(slope, (s3, k) => pulls[k] ? -s3 : s3);
        force2 = Float64Array.from(force2, Math.abs);
      }
      const [left2, right] = contact.bodies;
      curves.push({
        label: onBy(left2, right, header.track),
        style: styles.get(left2) ?? "wall",
        over: false,
        values: Float64Array.from(force2, (f2) => sign * f2),
        slopes: Float64Array.from(slope, (s3) => sign * s3)
      });
      curves.push({
        label: onBy(right, left2, header.track),
        style: styles.get(right) ?? "wall",
        over: true,
        values: force2,
        slopes: slope
      });
    }
    return curves;
  }

  // src/scene/take-along/csv.js
  function csv(run, quantities, camera, seen = Infinity) {
    if (!isTold(run)) return "";
    const { header, trajectory } = run;
    const columns = [[tr("t in s"), trajectory.t]];
    for (const quantity of quantities) {
      const [title, symbol, unit] = QUANTITIES[quantity] ?? ["", quantity, ""];
      for (const { label, over, values } of seriesOf(quantity, header, trajectory, camera, true)) {
        columns.push([named2(quantity, { title, symbol, label, over }) + inUnit(unit), values]);
      }
    }
    if (quantities.includes("F")) columns.push(...effectColumns(run));
    const lines4 = [columns.map(([name]) => quoted(name)).join(",")];
    for (let k = 0; k < trajectory.t.length && Number(trajectory.t[k]) <= seen; k += 1) {
      lines4.push(columns.map(([, values]) => String(Number(values[k]) || 0)).join(","));
    }
    return `${lines4.join("\r\n")}\r
`;
  }
  function effectColumns({ header, trajectory }) {
    return Object.entries(trajectory.E).map(([key, values]) => {
      const [kind2, on] = [key.slice(0, key.indexOf(" ")), key.slice(key.indexOf(" ") + 1)];
      const own = header.effects.filter(
        (effect) => effect.kind === kind2 && effect.active && effect.carts.includes(on)
      );
      const by = listed([...new Set(own.map(agent))]);
      return [`${forceOn(on, by)} (${viewOf(kind2).name})${inUnit("N")}`, values];
    });
  }
  function named2(quantity, { title, symbol, label, over }) {
    const whole = title.toLowerCase();
    if (quantity === "F") return `${whole} F ${label}`;
    if (quantity === "R" && over) return `F ${label}`;
    return tr("{quantity} of {cart}", { quantity: `${whole} ${symbol}`, cart: label });
  }
  var inUnit = (unit) => tr(" in {unit}", { unit });
  function quoted(text) {
    return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  }

  // ../../node_modules/lean-qr/index.mjs
  var t = [0.2, 3 / 8, 5 / 9, 2 / 3];
  var o = (o3, e2) => (r2) => {
    const n3 = 4 * o3 + r2 - 4, s3 = "*-04-39?2$%%$%%'$%''%'''%')(%'))%(++'(++'(+.'+-.',/3',33)-/5)-43).36)058*18<+37<+4:<,4:E,5<A-7>C/8@F/:EH/<EK0=FM1?IP2@KS3BNV4DPY5FS\\6HV_6IXb7K[e8N^i9Pam;Rdp<Tgt".charCodeAt(n3) - 35, f2 = n3 > 8 ? s3 : 1, c2 = e2 / f2 | 0, i2 = e2 % f2, l2 = f2 - i2, a2 = n3 > 8 ? c2 * t[r2] + (o3 > 5) & -2 : s3, _2 = c2 - a2;
    return { t: l2 * _2 + i2 * _2 + i2, o: [[l2, _2], [i2, _2 + 1]], i: a2 };
  };
  var r = (t3) => new Uint8Array(t3);
  var n = (t3) => {
    const o3 = new Error(`lean-qr error ${t3}`);
    throw o3.code = t3, o3;
  };
  var s = (t3) => "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ $%*+-./:".indexOf(t3);
  var f = (t3) => t3.charCodeAt(0);
  var c = (...t3) => (o3, e2) => t3.forEach((t4) => t4(o3, e2));
  var i = (t3) => (o3) => {
    o3.eci !== t3 && (o3.push(7, 4), t3 < 128 ? o3.push(t3, 8) : t3 < 16384 ? o3.push(32768 | t3, 16) : o3.push(12582912 | t3, 24), o3.eci = t3);
  };
  var l = (t3) => (o3, e2) => {
    o3.push(4, 4), o3.push(t3.length, 8 + 8 * (e2 > 9)), t3.forEach((t4) => o3.push(t4, 8));
  };
  var a = (t3, o3, e2, r2, n3 = (t4, o4) => e2(t4.length, o4), s3 = r2 ? (o4) => c(i(r2), t3(o4)) : t3) => (s3.test = o3, s3.l = e2, s3.est = n3, s3.eci = r2 && [r2], s3);
  var _ = a((t3) => (o3, e2) => {
    o3.push(1, 4), o3.push(t3.length, 10 + 2 * (e2 > 26) + 2 * (e2 > 9));
    let r2 = 0;
    for (; r2 < t3.length - 2; r2 += 3) o3.push(+t3.slice(r2, r2 + 3), 10);
    r2 < t3.length - 1 ? o3.push(+t3.slice(r2), 7) : r2 < t3.length && o3.push(+t3[r2], 4);
  }, (t3) => /[0-9]/.test(t3), (t3, o3) => 14 + 2 * (o3 > 26) + 2 * (o3 > 9) + 10 * t3 / 3);
  var u = a((t3) => (o3, e2) => {
    o3.push(2, 4), o3.push(t3.length, 9 + 2 * (e2 > 26) + 2 * (e2 > 9));
    let r2 = 0;
    for (; r2 < t3.length - 1; r2 += 2) o3.push(45 * s(t3[r2]) + s(t3[r2 + 1]), 11);
    r2 < t3.length && o3.push(s(t3[r2]), 6);
  }, (t3) => s(t3) >= 0, (t3, o3) => 13 + 2 * (o3 > 26) + 2 * (o3 > 9) + 5.5 * t3);
  var d = a((t3) => l([...t3].map(f)), (t3) => f(t3) < 128, (t3, o3) => 12 + 8 * (o3 > 9) + 8 * t3);
  d._ = true, d.u = true;
  var p = a(d, (t3) => f(t3) < 256, d.l, 3);
  p._ = true;
  var m = new TextEncoder();
  var h = a((t3) => l(m.encode(t3)), () => 1, 0, 26, (t3, o3) => 12 + 8 * (o3 > 9) + 8 * m.encode(t3).length);
  h._ = true;
  var w = () => {
    const t3 = /* @__PURE__ */ new Map(), o3 = new TextDecoder("sjis"), e2 = r(2);
    for (let r2 = 0; r2 < 7973; ++r2) e2[0] = r2 / 192 + 129 + 64 * (r2 > 5951), e2[1] = r2 % 192 + 64, t3.set(o3.decode(e2), r2);
    return t3.delete("�"), w = () => t3, t3;
  };
  var y = a((t3) => (o3, e2) => {
    o3.push(8, 4), o3.push(t3.length, 8 + 2 * (e2 > 26) + 2 * (e2 > 9));
    for (const e3 of t3) o3.push(w().get(e3), 13);
  }, (t3) => w().has(t3), (t3, o3) => 12 + 2 * (o3 > 26) + 2 * (o3 > 9) + 13 * t3);
  y._ = true;
  var g = [_, u, d, p, y, h];
  var b = { auto: (t3, { modes: o3 = g } = {}) => (e2, r2) => {
    const s3 = o3.map((o4, e3) => {
      const n3 = /* @__PURE__ */ new Map(), s4 = (t4, o5) => (n3.has(t4) || n3.set(t4, o5(t4, r2)), n3.get(t4));
      return { m: o4, h: 1 << e3, C: o4.est("", r2), S: o4.l ? (t4, e4) => s4(e4 - t4, o4.l) : (e4, r3) => s4(t3.slice(e4, r3), o4.est) };
    });
    let f2 = [{ v: 0 }], c2 = 0, i2 = 0, l2 = -1;
    for (const o4 of [...t3, ""]) {
      let t4 = 0;
      if (o4) for (const e3 of s3) e3.m.test(o4) && (t4 |= e3.h);
      if (!o4 || t4 !== l2) {
        if (-1 !== l2) {
          const t5 = new Set(f2.map((t6) => t6.D)), o5 = [];
          for (const { m: e3, C: r3, S: n3, h: a3 } of s3) if (l2 & a3) {
            const s4 = n3(c2, i2);
            for (const l3 of e3.eci ?? t5) if (!e3.u || !l3) {
              let t6;
              for (const o6 of f2) if (o6.D === l3 || e3.eci) {
                const f3 = o6.m === e3 && o6.D === l3, a4 = f3 ? o6.V : o6, _2 = e3._ && f3 ? o6.v + s4 - r3 : a4.v + 12 * (a4.D !== l3) + (f3 ? n3(f3 ? o6.$ : c2, i2) : s4);
                (!t6 || _2 < t6.v) && (t6 = { $: f3 ? o6.$ : c2, V: a4, m: e3, D: l3, A: i2, v: _2 });
              }
              t6 && o5.push(t6);
            }
          }
          f2 = o5;
        }
        l2 = t4, c2 = i2;
      }
      i2 += o4.length;
    }
    f2.length || n(5);
    const a2 = [];
    for (let o4 = f2.reduce((t4, o5) => o5.v < t4.v ? o5 : t4); o4.m; o4 = o4.V) a2.push(o4.m(t3.slice(o4.$, o4.A)));
    a2.reverse().forEach((t4) => t4(e2, r2));
  }, multi: c, eci: i, bytes: l, numeric: _, alphaNumeric: u, ascii: d, iso8859_1: p, shift_jis: y, utf8: h };
  var C = () => ({ F: r(2956), I: 0, push(t3, o3) {
    for (let e2 = o3, r2 = 8 - (7 & this.I); e2 > 0; e2 -= r2, r2 = 8) this.F[this.I >> 3] |= t3 << r2 >> e2, this.I += e2 < r2 ? e2 : r2;
  } });
  var x = (t3, o3 = t3 * t3, e2 = r(o3)) => ({ size: t3, K: e2, get: (o4, r2) => o4 >= 0 && o4 < t3 && !!(1 & e2[r2 * t3 + o4]), toString({ on: o4 = "##", off: e3 = "  ", lf: r2 = "\n", pad: n3 = 4, padX: s3 = n3, padY: f2 = n3 } = {}) {
    let c2 = "";
    for (let n4 = -f2; n4 < t3 + f2; ++n4) {
      for (let r3 = -s3; r3 < t3 + s3; ++r3) c2 += this.get(r3, n4) ? o4 : e3;
      c2 += r2;
    }
    return c2;
  }, toImageData(o4, { on: e3 = [0, 0, 0], off: r2 = [0, 0, 0, 0], pad: n3 = 4, padX: s3 = n3, padY: f2 = n3 } = {}) {
    const c2 = t3 + 2 * s3, i2 = t3 + 2 * f2, l2 = o4.createImageData(c2, i2), a2 = new Uint32Array(l2.data.buffer);
    l2.data.set([...e3, 255]);
    const _2 = a2[0];
    l2.data.set([...r2, 255]);
    const u2 = a2[0];
    for (let t4 = 0; t4 < i2; ++t4) for (let o5 = 0; o5 < c2; ++o5) a2[t4 * c2 + o5] = this.get(o5 - s3, t4 - f2) ? _2 : u2;
    return l2;
  }, toCanvas(t4, o4) {
    const e3 = t4.getContext("2d"), r2 = this.toImageData(e3, o4);
    t4.width = r2.width, t4.height = r2.height, e3.putImageData(r2, 0, 0);
  }, toDataURL({ type: t4 = "image/png", scale: o4 = 1, ...e3 } = {}) {
    const r2 = document.createElement("canvas"), n3 = r2.getContext("2d"), s3 = this.toImageData(n3, e3);
    return r2.width = s3.width * o4, r2.height = s3.height * o4, n3.putImageData(s3, 0, 0), n3.imageSmoothingEnabled = false, n3.globalCompositeOperation = "copy", n3.drawImage(r2, 0, 0, s3.width, s3.height, 0, 0, r2.width, r2.height), r2.toDataURL(t4, 1);
  } });
  var z = [(t3, o3) => 1 & (t3 ^ o3), (t3, o3) => 1 & o3, (t3) => t3 % 3, (t3, o3) => (t3 + o3) % 3, (t3, o3) => 1 & (t3 / 3 ^ o3 >> 1), (t3, o3) => (t3 & o3 & 1) + t3 * o3 % 3, (t3, o3) => (t3 & o3) + t3 * o3 % 3 & 1, (t3, o3) => (t3 ^ o3) + t3 * o3 % 3 & 1];
  var E = r(511);
  for (let t3 = 0, o3 = 1; t3 < 255; o3 = 2 * o3 ^ 285 * (o3 > 127)) E[E[o3 + 255] = t3++] = o3;
  var M = (t3) => E[t3 % 255];
  var S = (t3) => E[t3 + 255];
  var v = (t3, o3) => {
    const e2 = r(t3.length + o3.length - 1);
    for (let r2 = 0; r2 < t3.length; ++r2) for (let n3 = 0; n3 < o3.length; ++n3) e2[r2 + n3] ^= M(t3[r2] + o3[n3]);
    return e2.map(S);
  };
  var D = (t3, o3) => {
    const e2 = r(t3.length + o3.length - 1);
    e2.set(t3, 0);
    for (let r2 = 0; r2 < t3.length; ++r2) if (e2[r2]) {
      const t4 = S(e2[r2]);
      for (let n3 = 0; n3 < o3.length; ++n3) e2[r2 + n3] ^= M(o3[n3] + t4);
    }
    return e2.slice(t3.length);
  };
  var L = [[0], [0, 0]];
  for (let t3 = 1; t3 < 30; ++t3) L.push(v(L[t3], [0, t3]));
  var V = (t3, o3) => {
    const e2 = [[], []];
    let n3 = 0, s3 = 0;
    for (const [r2, f3] of o3.o) for (let c2 = 0; c2 < r2; ++c2, n3 += f3) {
      const r3 = t3.slice(n3, n3 + f3);
      e2[0].push(r3), e2[1].push(D(r3, L[o3.i])), s3 += f3 + o3.i;
    }
    const f2 = r(s3);
    s3 = 0;
    for (const t4 of e2) for (let o4 = 0, e3 = -1; e3 < s3; ++o4) {
      e3 = s3;
      for (const e4 of t4) o4 < e4.length && (f2[s3++] = e4[o4]);
    }
    return f2;
  };
  var $ = (t3, o3, e2) => {
    let r2 = t3 <<= e2;
    for (let t4 = 134217728; t4 >>= 1; ) r2 & t4 && (r2 ^= o3 * (t4 >> e2));
    return r2 | t3;
  };
  var A = ({ size: t3, K: o3 }, e2) => {
    const r2 = (e3, r3, n4, s4) => {
      for (; n4-- > 0; e3 += t3) o3.fill(s4, e3, e3 + r3);
    }, n3 = (o4, e3, n4) => {
      for (let s4 = 0; s4++ < 3; n4 -= 2) r2(e3 * t3 + o4 - (n4 >> 1) * (t3 + 1), n4, n4, 2 | s4);
    }, s3 = 2 * ((t3 - 13) / (1 + (e2 / 7 | 0)) / 2 + 0.75 | 0);
    if (e2 > 1) for (let o4 = t3 - 7; o4 > 8; o4 -= s3) {
      for (let t4 = o4; t4 > 8; t4 -= s3) n3(o4, t4, 5);
      o4 < t3 - 7 && n3(o4, 6, 5);
    }
    if (e2 > 6) for (let r3 = $(e2, 7973, 12), n4 = 1; n4 < 7; ++n4) for (let e3 = 12; e3-- > 9; r3 >>= 1) o3[n4 * t3 - e3] = 2 | 1 & r3;
    r2(7, 2, 9, 2), r2(t3 - 8, 8, 9, 2);
    for (let e3 = 0; e3 < t3; ++e3) o3[6 * t3 + e3] = 3 ^ 1 & e3;
    n3(3, 3, 7), n3(t3 - 4, 3, 7);
    for (let e3 = 0; e3 < t3; ++e3) for (let r3 = e3; r3 < t3; ++r3) o3[r3 * t3 + e3] = o3[e3 * t3 + r3];
    o3[(t3 - 8) * t3 + 8] = 3;
  };
  var F = ({ size: t3, K: o3 }) => {
    const e2 = [];
    for (let r2 = t3 - 2, n3 = t3, s3 = -1; r2 >= 0; r2 -= 2) {
      for (5 === r2 && (r2 = 4); n3 += s3, -1 !== n3 && n3 !== t3; ) {
        const s4 = n3 * t3 + r2;
        o3[s4 + 1] || e2.push(s4 + 1), o3[s4] || e2.push(s4);
      }
      s3 *= -1;
    }
    return e2;
  };
  var H = ({ K: t3 }, o3, e2) => o3.forEach((o4, r2) => t3[o4] = e2[r2 >> 3] >> (7 & ~r2) & 1);
  var I = ({ size: t3, K: o3 }, e2, r2, n3) => {
    for (let r3 = 0; r3 < t3; ++r3) for (let n4 = 0; n4 < t3; ++n4) {
      const s4 = r3 * t3 + n4;
      o3[s4] ^= !(e2(n4, r3) || 2 & o3[s4]);
    }
    let s3 = 21522 ^ $((1 ^ n3) << 3 | r2, 1335, 10);
    for (let e3 = 0; e3++ < 8; s3 >>= 1) o3[(e3 - (e3 < 7)) * t3 + 8] = 1 & s3, o3[9 * t3 - e3] = 1 & s3;
    for (let e3 = 8; --e3, s3; s3 >>= 1) o3[8 * t3 + e3 - (e3 < 7)] = 1 & s3, o3[(t3 - e3) * t3 + 8] = 1 & s3;
  };
  var K = ({ size: t3, K: o3 }, e2 = 0, r2 = 0) => {
    for (let n3 = 0; n3 < t3; ++n3) {
      for (let s3 = 0; s3 < 2; ++s3) for (let f2, c2 = 0, i2 = 0, l2 = 2; c2 < t3; ++c2) {
        const a2 = 1 & o3[s3 ? n3 * t3 + c2 : c2 * t3 + n3];
        r2 += a2, i2 = (i2 >> 1 | 2098176) & (3047517 ^ a2 - 1), 2049 & i2 && (e2 += 40), a2 ^ l2 && (f2 = 0), l2 = a2, e2 += 5 === ++f2 ? 3 : f2 > 5;
      }
      if (n3) for (let r3 = t3 + n3, s3 = 5 * o3[n3 - 1] ^ o3[n3]; r3 < t3 * t3; r3 += t3) {
        const t4 = 5 * o3[r3 - 1] ^ o3[r3];
        e2 += 3 * !(1 & (s3 | t4) | 4 & (s3 ^ t4)), s3 = t4;
      }
    }
    return e2 + 10 * (10 * Math.abs(r2 / (t3 * t3) - 1) | 0);
  };
  var N = [];
  var P = (t3 = n(1), { minCorrectionLevel: e2 = 0, maxCorrectionLevel: r2 = 3, minVersion: s3 = 1, maxVersion: f2 = 40, mask: c2, trailer: i2 = 60433, ...l2 } = {}) => {
    r2 < e2 && n(3), f2 < s3 && n(2), "string" == typeof t3 && (t3 = b.auto(t3, l2));
    for (let n3 = s3, l3 = 0; n3 <= f2; ++n3) {
      let s4 = N[n3];
      s4 || (N[n3] = s4 = x(4 * n3 + 17), A(s4, n3), s4.p = F(s4));
      const f3 = o(n3, s4.p.length >> 3);
      if (8 * f3(e2).t < l3) continue;
      const a2 = C();
      t3(a2, n3), l3 = a2.I;
      for (let t4 = r2; t4 >= e2; --t4) {
        const o3 = f3(t4);
        if (8 * o3.t < l3) continue;
        for (a2.I = l3 + 11 & -8; a2.I < 8 * o3.t; ) a2.push(i2, 16);
        const e3 = x(s4.size, s4.K);
        return H(e3, s4.p, V(a2.F, o3)), (z[c2] ? [z[c2]] : z).map((o4, r3) => {
          const n4 = x(e3.size, e3.K);
          return I(n4, o4, c2 ?? r3, t4), n4.s = z[c2] ? 0 : K(n4), n4;
        }).reduce((t5, o4) => o4.s < t5.s ? o4 : t5);
      }
    }
    n(4);
  };
  P.with = (...t3) => (o3, e2) => P(o3, { modes: [...g, ...t3], ...e2 });

  // ../../node_modules/lean-qr/extras/svg.mjs
  var t2 = "http://www.w3.org/2000/svg";
  var e = (e2, i2, o3, n3 = [], s3 = e2.createElementNS(t2, i2)) => (Object.entries(o3).map(([t3, e3]) => s3.setAttribute(t3, e3)), s3.replaceChildren(...n3), s3);
  var o2 = (t3) => {
    const e2 = [];
    let i2 = "";
    for (let o3 = 0; o3 <= t3.size; ++o3) for (let n3 = 0; n3 <= t3.size; ++n3) {
      const s3 = t3.get(n3, o3), l2 = n3 << 8 | o3;
      let r2 = t3.get(n3 - 1, o3) ^ s3 && l2 + 1, a2 = t3.get(n3, o3 - 1) ^ s3 && l2 + 256;
      if (r2 || a2) {
        s3 || ([r2, a2] = [a2, r2]);
        const t4 = e2[r2 || l2] ||= [], o4 = e2[a2 || l2];
        r2 && t4.push(l2), a2 && t4.push(a2), t4 === o4 ? i2 += `M${t4.map((t5) => `${t5 >> 8} ${255 & t5}`).join("L")}Z` : (o4 && t4.push(...o4), e2[t4[t4.length - 1]] = t4);
      }
    }
    return i2;
  };
  var n2 = (e2, { on: i2 = "black", off: n3, pad: s3 = 4, padX: l2 = s3, padY: r2 = s3, width: a2, height: c2, scale: g2 = 1 }, h2, $2, d2) => {
    const p2 = e2.size + 2 * l2, w2 = e2.size + 2 * r2;
    return h2($2, "svg", { xmlns: t2, version: "1.1", viewBox: `${-l2} ${-r2} ${p2} ${w2}`, width: a2 ?? p2 * g2, height: c2 ?? w2 * g2, "shape-rendering": "crispedges" }, [n3 ? h2($2, "rect", { x: -l2, y: -r2, width: p2, height: w2, fill: n3 }) : "", h2($2, "path", { d: o2(e2), fill: i2 })], d2);
  };
  var s2 = (t3, i2, o3 = {}) => i2.body ? n2(t3, o3, e, i2) : n2(t3, o3, e, i2.ownerDocument, i2);

  // src/scene/take-along/qr.js
  function qrCode(link) {
    if (!/^https?:/.test(link)) return [];
    const picture2 = s2(P(link), document, { on: "#000", off: "#fff", pad: 4, scale: 4 });
    picture2.setAttribute("role", "img");
    picture2.setAttribute("aria-label", tr("QR code of the link"));
    return [picture2, html("p", "carts-quiet", tr("A phone that reads this opens the same state."))];
  }

  // src/scene/take-along/share.js
  var MARK = "carts:";
  var MOST_KEYS = 60;
  var LONGEST3 = 4e3;
  var LONGEST_VALUE = 40;
  var TARGET = /^[A-Za-z][\w-]*(\.[\w-]+){0,3}$/;
  function linkTo(id, settings, t3) {
    const parts2 = Object.entries({ ...settings, t: Number(t3.toPrecision(6)) });
    return `${MARK}${id}?${parts2.map(([key, value]) => `${key}=${encodeURIComponent(value)}`).join("&")}`;
  }
  function readLink(hash, id) {
    const text = hash.replace(/^#/, "");
    if (!text.startsWith(`${MARK}${id}?`)) return null;
    if (text.length > LONGEST3) return { problem: tr("This link is too long: it was not used.") };
    const settings = {};
    let t3 = 0;
    const parts2 = text.slice(MARK.length + id.length + 1).split("&");
    for (const part of parts2.filter(Boolean).slice(0, MOST_KEYS)) {
      const [key = "", value = ""] = [part.split("=")[0], decoded(part.slice(part.indexOf("=") + 1))];
      if (!TARGET.test(key) || !value || value.length > LONGEST_VALUE) {
        return { problem: tr("This link is damaged: it was not used.") };
      }
      if (key === "t") t3 = Number(value);
      else if (/^(true|false)$/.test(value)) settings[key] = value === "true";
      else settings[key] = Number.isFinite(Number(value)) ? Number(value) : value;
    }
    return { settings, t: Number.isFinite(t3) ? Math.max(0, t3) : 0 };
  }
  async function followLink(scene, runs, say2) {
    const asked4 = readLink(location.hash, scene.id);
    if (!asked4) return;
    if ("problem" in asked4) return say2(asked4.problem);
    try {
      await runs.become(asked4.settings);
      scene.time = asked4.t;
      scene.scrollIntoView();
    } catch (error) {
      const { message } = error;
      say2(tr("This link does not fit this scene: {why}", { why: message }));
    }
  }
  function decoded(text) {
    try {
      return decodeURIComponent(text);
    } catch {
      return "";
    }
  }
  function sceneBlock(fence, settings) {
    const scene = structuredClone(fence.scene);
    for (const [target, value] of Object.entries(settings)) change(scene, target, value);
    const lines4 = [`id: ${fence.id}-copy`];
    for (const [key, value] of Object.entries(scene)) {
      if (key === "carts") {
        lines4.push("carts:");
        for (const [name, cart] of Object.entries(value)) {
          lines4.push(`  ${name}: ${flow(cart)}`);
        }
      } else lines4.push(`${key}: ${flow(value)}`);
    }
    lines4.push(`show: ${flow(fence.show)}`);
    if (fence.opened?.length) lines4.push(`with: ${flow(fence.opened)}`);
    if (fence.watch === "free") lines4.push("watch: free");
    if (fence.slow !== "auto") lines4.push(`slow: ${fence.slow}`);
    if (fence.boxes === "alike") lines4.push(`boxes: ${fence.boxes}`);
    if (fence.forces !== "shown") lines4.push(`forces: ${fence.forces}`);
    if (fence.camera) lines4.push(`view: moving ${fence.camera} m/s`);
    const switches = fence.switches ?? [];
    if (fence.controls.length || switches.length) lines4.push("controls:");
    for (const { set, low, high, step, unit } of fence.controls) {
      const part = (value) => `${value} ${unit}`.trim();
      lines4.push(`  - {set: ${set}, from: ${part(low)}, to: ${part(high)}, step: ${part(step)}}`);
    }
    for (const { set } of switches) lines4.push(`  - {switch: ${set.replace(/\.active$/, "")}}`);
    const presets = Object.entries(fence.presets ?? {});
    if (presets.length) lines4.push("presets:");
    for (const [name, values] of presets) lines4.push(`  ${JSON.stringify(name)}: ${flow(values)}`);
    return `\`\`\`scene
${lines4.join("\n")}
\`\`\`
`;
  }
  function change(scene, target, value) {
    const keys = target.split(".");
    const path3 = scene.carts?.[String(keys[0])] ? ["carts", ...keys] : effectPath(scene, keys) ?? keys;
    let place4 = scene;
    for (const key of path3.slice(0, -1)) {
      place4[key] ??= {};
      place4 = place4[key];
    }
    place4[String(path3.at(-1))] = value;
  }
  function flow(value) {
    if (Array.isArray(value)) return `[${value.map(flow).join(", ")}]`;
    if (value && typeof value === "object") {
      return `{${Object.entries(value).map(([key, item]) => `${key}: ${flow(item)}`).join(", ")}}`;
    }
    if (typeof value !== "string") return String(value);
    return /^[A-Za-z0-9.+−-][\w .+/·²³^-]*$/.test(value) && !/^(no|yes|on|off|true|false|null)$/i.test(value) ? value : JSON.stringify(value);
  }

  // src/scene/take-along/take-along.js
  var KINDS = [
    ["csv", tr("values (CSV)")],
    ["svg", tr("picture (SVG)")],
    ["png", tr("picture (PNG)")],
    ["link", tr("link to this state")],
    ["block", tr("scene block")],
    ["program", tr("Python program")]
  ];
  var TakeAlong = class {
    constructor(root, baked, state, program) {
      const place4 = need(root, ".carts-take");
      const { fence } = baked;
      const text = document.createElement("textarea");
      text.readOnly = true;
      text.hidden = true;
      text.rows = 4;
      text.setAttribute("aria-label", tr("Text to copy"));
      const note2 = html("p", "carts-take-note");
      note2.setAttribute("role", "status");
      const row = html("p", "carts-take-row");
      for (const [key, name] of KINDS) {
        const button = html("button", "carts-button", name);
        button.setAttribute("type", "button");
        button.dataset.take = key;
        row.append(button);
      }
      const code = html("div", "carts-take-code");
      place4.append(row, note2, text, code);
      const offer = async (made4) => {
        text.hidden = false;
        text.value = made4;
        text.select();
        const copied = await navigator.clipboard?.writeText(made4).then(
          () => true,
          () => false
        );
        say(note2, copied ? tr("It is copied.") : tr("Copy it from the box."));
      };
      const acts = {
        csv: () => {
          const { run, quantities, seen } = state();
          const table = csv(run, quantities, fence.camera, seen);
          download(`${fence.id}.csv`, `\uFEFF${table}`, "text/csv");
        },
        svg: () => download(`${fence.id}.svg`, picture(root), "image/svg+xml"),
        png: async () => downloadBlob(`${fence.id}.png`, await asPng(picture(root))),
        link: () => {
          const { settings, t: t3 } = state();
          const link = `${location.href.split("#")[0]}#${linkTo(fence.id, settings, t3)}`;
          code.replaceChildren(...qrCode(link));
          return offer(link);
        },
        program: async () => {
          const text2 = await program();
          download(`${fence.id}.py`, text2, "text/x-python");
          return offer(text2);
        },
        block: () => offer(sceneBlock(fence, state().settings))
      };
      place4.addEventListener("click", async (event) => {
        const button = event.target.closest("button");
        const act = acts[button?.dataset.take ?? ""];
        if (!act) return;
        try {
          say(note2, "");
          code.replaceChildren();
          await act();
        } catch (error) {
          const { message } = error;
          say(note2, tr("This browser could not do it: {why}", { why: message }));
        }
      });
    }
  };

  // src/scene/inside.js
  var lives = /* @__PURE__ */ new WeakMap();
  function wireInside(element, baked, view, client2, acts) {
    lives.get(element)?.abort();
    const life = new AbortController();
    lives.set(element, life);
    element.querySelector(".carts-reset")?.addEventListener("click", acts.reset);
    element.querySelector(".carts-undo")?.addEventListener("click", acts.undo);
    const presets = new Presets(element, baked.fence, acts.preset);
    presets.show({}, baked.run.header);
    const { scene, controls, switches } = baked.fence;
    const sliders = new Controls(element, controls, acts, switches);
    view.draggable({
      ready: () => sliders.on && acts.told() && view.player.time === 0 && !view.player.playing,
      value: (target) => valueIn(view.run.header, target),
      change: (control, value, at3) => sliders.take(control.set, value, at3)
    });
    const [writing, counting] = [{}, {}];
    const program = async () => {
      const set = { ...acts.settings() };
      const { header } = await client2.ask(writing, () => ({ kind: "model", scene, set }));
      if (!header.ok) throw refusal(header.problems ?? []);
      return String(header.text);
    };
    new TakeAlong(element, baked, () => ({ ...view.now, settings: acts.settings() }), program);
    offerProjector(element);
    need(element, ".carts-frame").addEventListener(WANTED, (event) => {
      const { detail } = event;
      detail.heard = true;
      const set = { ...acts.settings() };
      client2.ask(counting, () => ({ kind: "energy", scene, set })).then(
        ({ header, numbers }) => detail.answer(header.ok ? columnsOf(header, numbers) : null),
        () => detail.answer(null)
      );
    });
    const find = element.querySelector(".carts-find") ? new FindForces(element, baked.fence.id, acts.found) : null;
    const how = new How(
      element,
      view,
      client2,
      (more) => {
        return { kind: "how", scene, set: { ...acts.settings() }, ...more };
      },
      life.signal
    );
    const ladder = new Ladder(element, client2, () => {
      return { kind: "relevance", scene, set: { ...acts.settings() } };
    });
    const follow = (run) => {
      ladder.follow(run);
      return how.follow(run);
    };
    const show = (values, header) => {
      const pending = client2.state === "ready" ? values.pending : /* @__PURE__ */ new Set();
      sliders.show(values.good, header, pending);
      presets.show(values.good, header);
    };
    return { controls: sliders, presets, show, find, how, follow };
  }
  function askFirst(element, baked, view, { locked, forgotten }) {
    const ask = element.querySelector(".carts-predict");
    if (!(ask instanceof HTMLElement)) return null;
    const draw = (guesses) => {
      for (const stage of view.stages) stage.guess(guesses);
    };
    const { signal } = lives.get(element);
    return new Predict(ask, baked, draw, locked, forgotten, signal);
  }
  function columnsOf({ parts: parts2, carts, rows }, numbers) {
    const column = (k) => numbers.subarray(k * rows, (k + 1) * rows);
    return {
      names: parts2,
      t: column(0),
      columns: parts2.map((_2, k) => column(k + 1)),
      moving: Array.from({ length: carts }, (_2, k) => column(parts2.length + k + 1))
    };
  }

  // src/scene/live.js
  var Live = class {
    #waiting = deferred();
    #linked = "";
    // the address of a state that was followed
    constructor(element, client2, acts) {
      this.element = element;
      this.client = client2;
      this.acts = acts;
      this.#waiting.promise.catch(() => {
      });
    }
    get ready() {
      return this.#waiting.promise;
    }
    listen(signal) {
      this.client.addEventListener("state", () => this.follow(), { signal });
      for (const what of ["slow", "slow-line"]) {
        this.client.addEventListener(what, () => this.#slow(what), { once: true, signal });
      }
      addEventListener("hashchange", () => this.#link(), { signal });
      this.element.addEventListener(WATCHED, () => this.#link(), { signal });
    }
    #link() {
      const { state } = this.element.dataset;
      const able = state === "live" || state === "failed" && this.acts.stepwise();
      if (!able || !this.acts.told()) return;
      if (this.#linked === location.hash) return;
      this.#linked = location.hash;
      this.acts.link();
    }
    still() {
      for (const kind2 of ["pointerdown", "keydown", "focusin"]) {
        this.element.addEventListener(kind2, () => this.client.wake(), { once: true, passive: true });
      }
      requestAnimationFrame(() => requestAnimationFrame(() => performance.mark("carts:still")));
    }
    #slow(what) {
      if (this.element.dataset.state !== "starting") return;
      const told4 = slow(what, this.acts.told() && this.acts.stepwise());
      passing(this.element, told4, true);
      this.#waiting.promise.then(() => passing(this.element, told4, false)).catch(() => {
      });
    }
    follow() {
      const { state } = this.client;
      const { dataset } = this.element;
      if (state === "starting" || state === "idle") {
        dataset.state = state === "idle" ? "still" : "starting";
      } else if (state === "failed") this.#fail();
      else if (dataset.state !== "live") void this.#begin();
      else this.#mark();
    }
    async #begin(again = true) {
      try {
        await this.acts.first();
        await frame();
        if (this.client.state !== "ready") return;
        this.element.dataset.state = "live";
        this.#mark();
        performance.mark("carts:live");
        this.#waiting.resolve(void 0);
        this.#link();
      } catch (error) {
        if (this.client.state === "failed") return;
        if (again && error.refused) return this.#begin(false);
        this.#fail(error);
      }
    }
    #mark() {
      need(this.element, ".carts-mark").setAttribute("aria-label", LIVE);
    }
    get #nothing() {
      const more = this.element.querySelector(".carts-find, .carts-preset");
      return !this.acts.stepwise() && (!this.acts.told() || more !== null);
    }
    #fail(error = this.client.error ?? new Error(NOT_STARTED)) {
      const { dataset } = this.element;
      dataset.state = "failed";
      dataset.reason = error.reason ?? "failed";
      if (this.#nothing) dataset.unshown = "";
      this.acts.failed();
      const note2 = need(this.element, ".carts-note");
      note2.dataset.why = `${error.message} ${without(this.acts.told(), this.acts.stepwise())}`;
      note(this.element, note2.dataset.why);
      this.#waiting.reject(error);
      this.#link();
      this.element.dispatchEvent(new CustomEvent("carts-error", { bubbles: true, detail: error }));
    }
  };

  // src/shared/settings.js
  var asText2 = (settings) => JSON.stringify(Object.entries(settings).sort());

  // src/scene/prepared.js
  var TEXT_AT = 8;
  var Prepared = class {
    #loading = null;
    constructor(scene, { controls, switches = [] }, folder) {
      const { parts: parts2 = [], stops = {} } = JSON.parse(scene.dataset.prepared ?? "{}");
      this.parts = parts2;
      this.stops = stops;
      this.name = scene.id;
      this.controls = controls;
      this.switches = switches;
      this.folder = folder;
    }
    get there() {
      return this.parts.length > 0 && typeof DecompressionStream === "function";
    }
    async nearest(wanted2) {
      this.#loading ??= this.#load().catch((error) => {
        this.#loading = null;
        throw error;
      });
      const table = await this.#loading;
      const place4 = presetOf(table, wanted2) ?? this.#onGrid(table, wanted2);
      return { ...runAt(table, place4.number), set: place4.set };
    }
    #onGrid({ axes, presets }, wanted2) {
      const others = Object.keys(wanted2).filter((key) => !axes.some((axis2) => axis2.set === key));
      if (others.length) {
        const ready = presets.some((one) => others.every((key) => one[key] === wanted2[key]));
        throw new Error(
          ready ? tr("Ready-made values can be changed with Python only. Press: Reset all values.") : tr("This change needs Python, which does not run here.")
        );
      }
      const set = {};
      let number = 0;
      for (const axis2 of axes) {
        const asked4 = wanted2[axis2.set];
        const place4 = nearest(axis2.numbers, this.#number(axis2, asked4));
        number = number * axis2.values.length + place4;
        if (asked4 !== void 0) set[axis2.set] = axis2.values[place4] ?? asked4;
      }
      return { number, set };
    }
    #number(axis2, asked4) {
      const control = this.controls.find(({ set }) => set === axis2.set);
      const box2 = this.switches.find(({ set }) => set === axis2.set);
      if (asked4 === void 0) return control ? control.value * control.per : Number(box2?.value);
      if (typeof asked4 !== "string") return Number(asked4);
      const text = asked4.trim();
      const unit = control?.unit ?? "";
      const number = text.endsWith(unit) ? text.slice(0, text.length - unit.length) : "";
      if (!control || number.trim() === "" || Number.isNaN(Number(number))) {
        throw new Error(tr("A number without a unit, please: Python does not run here."));
      }
      return Number(number) * control.per;
    }
    async #load() {
      const parts2 = await Promise.all(
        this.parts.map((part, k) => loadPart(this.folder, this.name, k, part))
      );
      const bytes = await gunzip(parts2);
      const length = new DataView(bytes).getUint32(0, true);
      const text = new TextDecoder().decode(new Uint8Array(bytes, TEXT_AT, length));
      return { ...JSON.parse(text), numbers: new Float64Array(bytes, TEXT_AT + length) };
    }
  };
  function presetOf({ axes, presets }, wanted2) {
    const k = presets.findIndex((preset) => asText2(preset) === asText2(wanted2));
    if (k < 0) return null;
    const before = axes.reduce((product, axis2) => product * axis2.values.length, 1);
    return { number: before + k, set: wanted2 };
  }
  function runAt({ headers, numbers }, place4) {
    const sizeOf = (header2) => header2.ok ? header2.rows * header2.columns.length : 0;
    const start = headers.slice(0, place4).reduce((sum, header2) => sum + sizeOf(header2), 0);
    const header = headers[place4];
    return { header, numbers: numbers.subarray(start, start + sizeOf(header)) };
  }

  // src/shared/ask-scene.js
  var ASKED = "carts-asked";

  // src/scene/values.js
  var ONE_CHANGE = 1e3;
  var MOST3 = 50;
  var Values = class {
    good = {};
    wanted = {};
    #before = [];
    #last = { target: "", at: 0 };
    ask(changes2) {
      const target = Object.keys(changes2).join();
      if (!target) return;
      const now = performance.now();
      if (target !== this.#last.target || now - this.#last.at > ONE_CHANGE) {
        this.#before.push({ ...this.wanted });
        if (this.#before.length > MOST3) this.#before.shift();
      }
      this.#last = { target, at: now };
      Object.assign(this.wanted, changes2);
    }
    get pending() {
      const keys = Object.keys(this.wanted);
      return new Set(keys.filter((key) => this.wanted[key] !== this.good[key]));
    }
    giveUp(changes2) {
      for (const [key, value] of Object.entries(changes2)) {
        if (this.wanted[key] !== value) continue;
        const good = this.good[key];
        if (good === void 0) delete this.wanted[key];
        else this.wanted[key] = good;
      }
      if (JSON.stringify(this.#before.at(-1)) !== JSON.stringify(this.wanted)) return;
      this.#before.pop();
      this.#last.target = "";
    }
    replace(changes2) {
      const before = [...this.#before];
      if (asText2(this.wanted) !== asText2(changes2)) {
        this.#before.push({ ...this.wanted });
      }
      this.wanted = { ...changes2 };
      this.#last.target = "";
      return () => {
        this.wanted = { ...this.good };
        this.#before = before;
        this.#last.target = "";
      };
    }
    get canUndo() {
      return this.#before.length > 0;
    }
    undo() {
      this.wanted = this.#before.pop() ?? {};
      this.#last.target = "";
    }
    reset() {
      if (Object.keys(this.wanted).length) this.#before.push({ ...this.wanted });
      this.wanted = {};
      this.good = {};
      this.#last.target = "";
    }
    forget() {
      this.reset();
      this.#before = [];
    }
  };

  // src/scene/runs.js
  var Runs = class {
    values = new Values();
    prepared = null;
    #generation = 0;
    // of resets: what was asked for before one is not shown after it
    #changes = 0;
    // and resets so far: a prepared run is shown for the newest only, and before the exact one
    constructor(owner, client2, acts) {
      this.owner = owner;
      this.client = client2;
      this.acts = acts;
    }
    answerOthers(signal) {
      const owner = {};
      const answer = ({ detail }) => {
        const asked4 = { scene: this.acts.scene(), set: { ...this.values.good }, ...detail.message };
        detail.answer(this.client.ask(owner, () => asked4));
      };
      this.owner.addEventListener(ASKED, answer, { signal });
    }
    get stepwise() {
      return Boolean(this.prepared?.there);
    }
    get able() {
      return this.client.state !== "failed" || this.stepwise;
    }
    stops(target) {
      return this.client.state === "failed" ? this.prepared?.stops[target] : void 0;
    }
    async compute(changes2, at3) {
      this.#changes += 1;
      if (this.client.state === "idle" || this.client.state === "starting") void this.#meanwhile();
      const run = await this.ask(changes2);
      if (!run) return;
      this.#changes += 1;
      await this.acts.draw(run);
      await drawn(this.owner, at3, { ...this.values.good });
    }
    undo() {
      this.values.undo();
      this.compute({}, performance.now()).catch((error) => this.acts.say(error.message));
    }
    preset(changes2) {
      return this.become(changes2).then(
        () => true,
        (error) => {
          this.acts.say(error.message);
          return false;
        }
      );
    }
    become(changes2) {
      const back = this.values.replace(changes2);
      const done = this.compute(changes2, performance.now());
      const newest = this.#changes;
      return done.catch((error) => {
        if (newest === this.#changes) back();
        throw error;
      });
    }
    async ask(changes2 = {}) {
      const generation = this.#generation;
      const { header, numbers, set } = await this.#answer().catch((error) => {
        this.values.giveUp(changes2);
        throw error;
      });
      if (!header.ok) {
        this.values.giveUp(changes2);
        throw refusal(header.problems ?? []);
      }
      if (generation !== this.#generation) return null;
      this.values.good = set;
      if (this.client.state === "failed") this.values.wanted = { ...set };
      return { header, trajectory: fromWire(header, numbers) };
    }
    async #answer() {
      let long = false;
      const clock = watch(SLOW_AFTER, () => {
        long = this.client.state === "ready";
        if (long) this.acts.long(true);
      });
      try {
        const { header, numbers, sent } = await this.client.ask(this.owner, () => {
          return { kind: "run", scene: this.acts.scene(), set: { ...this.values.wanted } };
        });
        return { header, numbers, set: sent.set };
      } catch (error) {
        if (this.client.state !== "failed" || !this.prepared?.there) throw error;
        return this.prepared.nearest(this.values.wanted);
      } finally {
        clock.stop();
        if (long) this.acts.long(false);
      }
    }
    async #meanwhile() {
      if (!this.prepared?.there) return;
      const newest = this.#changes;
      const found3 = await this.prepared.nearest(this.values.wanted).catch(() => null);
      if (!found3?.header.ok || newest !== this.#changes) return;
      this.values.good = found3.set;
      const { header, numbers } = found3;
      await this.acts.draw({ header, trajectory: fromWire(header, numbers) });
    }
    reset() {
      this.#generation += 1;
      this.#changes += 1;
      this.values.reset();
      this.owner.dispatchEvent(new Event(RESET, { bubbles: true }));
    }
  };

  // ../view/effects-words.js
  function actingSentences(header, numbers) {
    if (!header.effects.length) return "";
    const acting = header.effects.filter(({ active }) => active).map((effect) => phrase(effect, header, numbers));
    const inside2 = acting.length ? acting.join("; ") : tr("nothing but the contacts between the carts");
    const leftOut = header.notSimulated.map((kind2) => viewOf(kind2).leftOut ?? viewOf(kind2).name);
    const model = tr("In this model: {effects}.", { effects: inside2 });
    if (!leftOut.length) return model;
    const outside3 = tr("Left out: {effects}.", { effects: inRow(leftOut) });
    return `${model} ${outside3}`;
  }
  function phrase(effect, header, numbers) {
    const { kind: kind2, carts, between: between2 } = effect;
    const view = viewOf(kind2);
    const told4 = {
      everyone: carts.length === header.bodies.length,
      on: listed(carts),
      both: bodiesOf(between2 ?? carts, header.track),
      agent: agent(effect),
      seen: (text) => numbers ? text : ""
    };
    const parts2 = view.phrase?.(effect, told4) ?? [nameOf(effect)];
    return parts2.filter(Boolean).join(", ");
  }
  function forceName({ effects }) {
    return effects.some(isLink) ? tr("Force between them") : tr("Contact force");
  }
  function sizeName({ effects }) {
    return effects.some(isLink) ? tr("Size of the force between them") : tr("Size of the contact force");
  }
  function marks({ effects, until }, forces2) {
    return effects.filter(({ active }) => active).flatMap((effect) => viewOf(effect.kind).marks?.(effect, agent(effect), until, forces2) ?? []);
  }

  // src/scene/announcer.js
  var MOST4 = 3;
  var Announcer = class {
    constructor(root) {
      this.world = need(root, ".carts-world");
      this.region = need(root, ".carts-announcer");
    }
    leadTo(next, sentence) {
      const focused = document.activeElement;
      if (!focused || focused === document.body || focused.matches(".carts-lock")) {
        next.focus({ preventScroll: true });
      }
      const { top, height } = this.world.getBoundingClientRect();
      const upper = top < 0 || height > innerHeight / 2;
      this.world.scrollIntoView({ block: upper ? "start" : "nearest" });
      this.tell([sentence]);
    }
    tell(sentences) {
      if (sentences.length) this.region.textContent = sentences.slice(-MOST4).join(" ");
    }
  };

  // ../view/forces.js
  function contactForce({ trajectory }, pair, t3, zero) {
    const column = trajectory.F[pair];
    if (!column) return 0;
    const force2 = valueAt(trajectory.t, column, trajectory.dF[pair] ?? null, t3);
    return Math.abs(force2) < zero ? 0 : force2;
  }
  function resultant(run, name, t3, zero) {
    return summed(forcesAlong(run, name, t3, zero));
  }
  var summed = (along) => along.reduce((sum, { value }) => sum + value, 0);
  function forcesAlong(run, name, t3, zero) {
    return [...contactForces(run, name, t3, zero), ...effectForces(run, name, t3)];
  }
  function contactForces(run, name, t3, zero) {
    return run.header.contacts.filter(({ bodies }) => bodies.includes(name)).map((contact) => ({ ...contact, size: contactForce(run, contact.pair, t3, zero) })).filter(({ pair, stiffness, size }) => size || stiffness || linkOf(run.header, pair)).map(({ bodies: [left2, right], size }) => {
      const isLeft = left2 === name;
      const by = isLeft ? right : left2;
      return {
        name: forceOn(body(name, run.header.track), body(by, run.header.track)),
        on: name,
        by,
        way: "along",
        side: isLeft ? "right" : "left",
        value: isLeft ? -size : size
      };
    }).sort((a2, b2) => a2.side < b2.side ? -1 : 1);
  }
  function effectForces(run, name, t3) {
    return forcesAt(run, t3, true).filter(({ on }) => on === name).map(({ kind: kind2, on, by, value, size }) => {
      const { forceName: forceName2 = forceOn, side } = viewOf(kind2);
      const at3 = side?.(value) ?? "middle";
      return { name: forceName2(on, by), on, by, way: "along", side: at3, value, size };
    });
  }
  function verticalNote(header) {
    return header.bodies.some(({ name }) => slopeOf(header, name)) ? tr(
      "On a slope the support balances only the part of the weight across the track; the rest of the weight acts along it. Weight and support are no third-law pair: the partner of the weight pulls on the Earth."
    ) : tr(
      "Weight and support are equal and opposite here, but both act on one cart: they balance. They are no third-law pair: the partner of the weight pulls on the Earth."
    );
  }
  function slopeOf({ effects }, name) {
    return effects.filter(({ active, carts }) => active && carts.includes(name)).reduce((sum, effect) => sum + (viewOf(effect.kind).slope?.(effect) ?? 0), 0);
  }
  function verticalForces({ header }, name) {
    const mass = header.bodies.find((one) => one.name === name)?.mass ?? 0;
    const slope = slopeOf(header, name);
    const weight = mass * header.gravity * Math.cos(slope);
    return [
      {
        name: slope ? tr("part of the weight of {name}, across the track: force on {name} by the Earth", {
          name
        }) : tr("weight of {name}: force on {name} by the Earth", { name }),
        by: "Earth",
        value: -weight
      },
      {
        name: tr("support: force on {name} by the track", { name }),
        by: "track",
        value: weight
      }
    ].map((force2) => ({ ...force2, on: name, way: "up", side: "middle" }));
  }

  // ../view/instant.js
  var FEW3 = 6;
  function instant(run, t3, view, camera, forces2) {
    const { header, trajectory } = run;
    const { decimals } = view;
    const time = tr("At {time} s:", { time: fixed(t3, decimals.t ?? 3) });
    const names = header.bodies.slice(0, FEW3).map(({ name }) => name);
    const carts = names.map((name) => {
      const [x2, v2, a2] = [trajectory.x[name], trajectory.v[name], trajectory.a[name]];
      const place4 = valueAt(trajectory.t, x2 ?? [], v2 ?? [], t3) - camera * t3;
      const speed = valueAt(trajectory.t, v2 ?? [], a2 ?? [], t3) - camera;
      const seen = Math.abs(speed) < NOISE * view.velocity ? 0 : speed;
      return tr("{cart} at {place} m, {velocity}.", {
        cart: name,
        place: fixed(place4, decimals.x ?? 3),
        velocity: motion(seen, decimals.v ?? 2, view.velocity)
      });
    });
    return [time, ...carts, ...forces2 ? pushes2(run, t3, view, names) : []].join(" ");
  }
  function pushes2(run, t3, view, carts) {
    const zero = NOISE * (view.force || 1);
    return ["left", ...carts, "right"].flatMap(
      (name) => forcesAlong(run, name, t3, zero).flatMap(({ name: force2, value, size: written2 }) => {
        const size = written2 ?? fixed(Math.abs(value), view.decimals.F ?? 2);
        if (!value || !Number(size)) return [];
        const told4 = { force: capital(force2), size: `${size} N` };
        return value < 0 ? tr("{force}: {size} to the left.", told4) : tr("{force}: {size} to the right.", told4);
      })
    );
  }

  // src/scene/described.js
  var REST3 = 250;
  var Described = class {
    #timer = 0;
    #told = false;
    #start = null;
    constructor(root, { fence, view }) {
      this.place = root.querySelector(`#${CSS.escape(fence.id)}-described`);
      this.fence = fence;
      this.view = view;
    }
    words(run, t3) {
      return instant(run, t3, this.view, this.fence.camera, this.fence.forces === "shown");
    }
    at(run, t3, moving) {
      clearTimeout(this.#timer);
      if (moving || !this.place || run.trajectory.t.length < 2) return;
      if (t3 === 0 && !this.#told) {
        const start = JSON.stringify(run.header.bodies);
        this.#start ??= start;
        if (start === this.#start) return;
      }
      this.#told = true;
      this.#timer = setTimeout(() => {
        if (this.place) say(this.place, this.words(run, t3));
      }, REST3);
    }
  };

  // src/scene/drag.js
  var Drag = class {
    constructor(stage, layout, baked, acts) {
      const { controls } = baked.fence;
      for (const { name } of baked.run.header.bodies) {
        for (const [key, part, metres] of [
          ["position", "carts-cart", 1 / layout.scale],
          ["velocity", "carts-velocity", baked.view.velocity / layout.velocity]
        ]) {
          const control = controls.find(({ set }) => set === `${name}.${key}`);
          const group2 = stage.querySelector(`.${part}[data-body="${name}"]`);
          if (!control || !group2) continue;
          group2.classList.add("carts-draggable");
          group2.addEventListener("pointerdown", (event) => {
            const value = acts.value(control.set);
            if (!acts.ready() || value === null) return;
            const unit = layout.width / stage.getBoundingClientRect().width;
            const from = value / control.per;
            const perUnit = metres * unit / control.per;
            let sent = from;
            event.preventDefault();
            followPointer(event, (pixels2, { timeStamp }) => {
              const to = onStep(from + pixels2 * perUnit, control);
              if (to === sent) return;
              sent = to;
              acts.change(control, to, timeStamp);
            });
          });
        }
      }
    }
  };
  function onStep(value, { low, high, step }) {
    const near = low + Math.round((value - low) / step) * step;
    return Number(Math.min(high, Math.max(low, near)).toPrecision(12));
  }

  // src/scene/beside/bars.js
  var HALF2 = 60;
  var Bars = class {
    #run = null;
    #curves = [];
    #windows = [];
    #full = 1;
    #first = 0;
    // of the lesson's own run, so that runs can be compared
    constructor(root, baked) {
      this.root = root;
      this.camera = baked.fence.camera;
      this.decimals = baked.view.decimals.p ?? 2;
      this.rows = root.querySelectorAll("tbody tr");
      this.since = need(root, ".carts-touch-note");
    }
    show(run, windows) {
      this.#run = run;
      this.#windows = windows.filter(({ near }) => !near);
      this.#curves = seriesOf("p", run.header, run.trajectory, this.camera);
      let most = this.#first;
      for (const { values } of this.#curves) {
        for (let k = 0; k < values.length; k += 1) most = Math.max(most, Math.abs(Number(values[k])));
      }
      if (!this.#first) this.#first = most;
      this.#full = most || 1;
    }
    at(t3) {
      const run = this.#run;
      if (!run) return;
      const start = latestTouch(this.#windows, t3)?.start ?? 0;
      say(this.since, tr("at {time} s", { time: fixed(start, 2) }));
      this.rows.forEach((row, k) => {
        const curve2 = this.#curves[k];
        row.hidden = !curve2;
        if (!curve2) return;
        const at3 = (when) => {
          const value = valueAt(run.trajectory.t, curve2.values, curve2.slopes, when);
          return Math.abs(value) < NOISE * this.#full ? 0 : value;
        };
        const [before, now] = [at3(start), at3(t3)];
        say(need(row, "th"), curve2.label);
        const texts = [before, now, now - before].map((value) => fixed(value, this.decimals));
        row.querySelectorAll("td[data-when]").forEach((cell3, i2) => {
          say(cell3, texts[i2] ?? "");
        });
        bar(need(row, '[data-part="before"]'), before / this.#full);
        bar(need(row, '[data-part="now"]'), now / this.#full);
      });
    }
  };
  function bar(rect, part) {
    const length = HALF2 * Math.min(1, Math.abs(part));
    put(rect, "x", px(part < 0 ? HALF2 + 4 - length : HALF2 + 4));
    put(rect, "width", px(length));
  }

  // src/scene/beside/free-body.js
  var WIDTH4 = 260;
  var HEIGHT2 = 60;
  var BOX = { left: 20, right: 240, top: 8, bottom: 52 };
  var AXIS = 38;
  var MIDDLE2 = WIDTH4 / 2;
  var APART3 = 8;
  var FULL = 95;
  var FreeBody = class {
    #run = null;
    #windows = [];
    #vertical = false;
    constructor(root, baked, redraw) {
      this.root = root;
      this.view = baked.view;
      this.per = speedUnit(baked.view.velocity)[0];
      this.zero = NOISE * (baked.view.force || 1);
      this.note = need(root, ".carts-touch-note");
      const vertical = need(root, ".carts-vertical");
      vertical.addEventListener("change", () => {
        this.#vertical = vertical.checked;
        this.root.classList.toggle("carts-with-vertical", vertical.checked);
        redraw();
      });
    }
    show(run, windows) {
      this.#run = run;
      say(need(this.root, ".carts-vertical-note"), verticalNote(run.header));
      this.#windows = windows.filter(({ near }) => !near);
    }
    at(t3) {
      const run = this.#run;
      if (!run) return;
      const touch = latestTouch(this.#windows, t3);
      const since = touch && tr("since the touch at {time} s", { time: fixed(touch.start, 2) });
      say(this.note, since || tr("since the start"));
      const room = this.#vertical ? this.#roomFor(run) : 0;
      for (const { name, mass } of run.header.bodies) {
        const along = forcesAlong(run, name, t3, this.zero);
        this.#draw(name, this.#vertical ? [...along, ...verticalForces(run, name)] : along, room);
        const whole = summed(along);
        const { t: times2, v: v2, a: a2 } = run.trajectory;
        const speed = (at3) => valueAt(times2, v2[name] ?? [], a2[name] ?? [], at3);
        const change2 = speed(t3) - speed(touch?.start ?? 0);
        const { decimals, velocity: velocity3 } = this.view;
        const seen = Math.abs(change2) < NOISE * velocity3 ? 0 : change2 / this.per;
        this.#say(name, "F", fixed(whole, decimals.F ?? 2));
        this.#say(name, "mass", short(mass));
        this.#say(name, "a", fixed(whole / mass, decimals.a ?? 2));
        this.#say(name, "dv", fixed(seen, decimals.v ?? 2));
      }
    }
    #say(name, quantity, text) {
      const cell3 = this.root.querySelector(`td[data-body="${name}"][data-quantity="${quantity}"]`);
      if (cell3) say(cell3, text);
    }
    #roomFor({ header }) {
      const weights = header.bodies.map(({ mass }) => mass * header.gravity);
      const longest = arrowLength(Math.max(...weights), this.view.force, FULL);
      return Math.ceil(Math.max(0, longest - (BOX.bottom - BOX.top) / 2) + 6);
    }
    #draw(name, forces2, room) {
      const card = need(this.root, `.carts-alone[data-body="${name}"]`);
      const group2 = need(card, '[data-part="forces"]');
      const list = need(card, "ul");
      while (group2.children.length < forces2.length) group2.append(svg("path"));
      while (group2.children.length > forces2.length) group2.lastElementChild?.remove();
      while (list.children.length < forces2.length) list.append(document.createElement("li"));
      while (list.children.length > forces2.length) list.lastElementChild?.remove();
      forces2.forEach((force2, k) => {
        const length = arrowLength(force2.value, this.view.force, FULL);
        const cut = isCut(force2.value, this.view.force);
        const path3 = group2.children[k];
        const [x2, y2] = tail(force2);
        put(path3, "class", "carts-block-arrow");
        put(path3, "d", (cut ? cutArrow : blockArrow)(x2, y2, length));
        put(path3, "transform", force2.way === "up" ? `rotate(-90 ${px(x2)} ${px(y2)})` : "");
        say(list.children[k], this.#sentence(force2, cut));
      });
      const picture2 = need(card, "svg");
      put(picture2, "viewBox", `0 ${-room} ${WIDTH4} ${HEIGHT2 + 2 * room}`);
      put(picture2, "height", String(HEIGHT2 + 2 * room));
    }
    #sentence({ name, way, value, size: written2 }, cut) {
      const size = `${written2 ?? fixed(Math.abs(value), this.view.decimals.F ?? 2)} N`;
      const told4 = { name, size };
      const ways = way === "up" ? [tr("{name}: {size} down", told4), tr("{name}: {size} up", told4)] : [tr("{name}: {size} to the left", told4), tr("{name}: {size} to the right", told4)];
      const said = value === 0 ? `${name}: ${size}` : ways[value < 0 ? 0 : 1];
      return `${said}${cut ? tr(", arrow cut") : ""}`;
    }
  };
  function tail({ way, side, value }) {
    if (way === "up") {
      const middle = (BOX.top + BOX.bottom) / 2;
      return value < 0 ? [MIDDLE2 - APART3, middle] : [MIDDLE2 + APART3, BOX.bottom];
    }
    if (side === "middle") return [MIDDLE2, AXIS];
    if (side === "below") return [MIDDLE2, BOX.bottom];
    if (side === "above") return [MIDDLE2, BOX.top];
    return [side === "left" ? BOX.left : BOX.right, AXIS];
  }

  // ../view/deformation/bubbles.js
  var APART4 = 13;
  var RADIUS = 3.5;
  var SMALL = 0.6;
  function bubbles(front, back, depth, [top, foot], size = 1) {
    const columns = Math.max(2, Math.round(depth / (APART4 * size)));
    const rows = Math.max(2, Math.floor((foot - top) / (APART4 * size)));
    let d2 = "";
    for (let row = 0; row < rows; row += 1) {
      const y2 = top + (row + 0.5) * (foot - top) / rows;
      const room = back - front(y2);
      const squeezed = Math.min(1, Math.abs(room) / depth);
      for (let column = 0; column < columns; column += 1) {
        const x2 = front(y2) + room * (column + (row % 2 ? 0.7 : 0.3)) / columns;
        d2 += bubble(x2, y2, size * RADIUS * ((row + column) % 3 ? 1 : SMALL), squeezed);
      }
    }
    return d2;
  }
  function bubble(x2, y2, radius, squeezed) {
    const wide = px(radius * squeezed);
    const across2 = px(2 * radius * squeezed);
    const half = `a${wide} ${px(radius)} 0 1 0`;
    return `M${px(x2 - Number(wide))} ${px(y2)}${half} ${across2} 0${half} -${across2} 0`;
  }

  // ../view/deformation/walls.js
  var LEAST = 64;
  var THICK = 2e3;
  var ROOM2 = 3;
  var SEEN = 1;
  function wallAt(side, length, layout, tallest) {
    const x2 = side === "left" ? 0 : Number(length);
    const edge3 = layout.origin + x2 * layout.scale;
    return { edge: edge3, way: side === "left" ? -1 : 1, top: layout.track - Math.max(tallest, LEAST) };
  }
  function wallPaths({ edge: edge3, way, top }, { track, beam }, dent, height) {
    const high = Math.max(top, track - height - ROOM2);
    const shoulder = Math.max(top, high - dent);
    const pressed2 = `V${px(shoulder)}L${px(edge3 + way * dent)} ${px(high)}V${px(track)}H${px(edge3)}`;
    const face2 = `M${px(edge3)} ${px(top)}${dent > 0 ? pressed2 : ""}V${px(track + beam)}`;
    const was = dent < SEEN ? "" : `M${px(edge3)} ${px(shoulder)}V${px(track)}`;
    return { body: `${face2}h${way * THICK}V${px(top)}Z`, face: face2, was };
  }

  // ../view/deformation/things.js
  var SHARE = 0.5;
  var LEAST2 = 30;
  var MOST5 = 60;
  var SHALLOW = 0.6;
  var SOLID = 8;
  var ARM = 12;
  var PLATE = 4;
  var PLANK = 8;
  var PITCH = 9;
  var HIGH2 = 13;
  var MADE2 = {
    foam(place4) {
      const { x: x2, heights, back, depth } = place4;
      const [top, foot] = endsOf(heights);
      const above = `M${px(x2(top))} ${px(top)}H${px(back)}`;
      const inside2 = bubbles(x2, back, depth, [top, foot]);
      return { own: [...face(place4), [back, foot], [back, top]], lines: above + inside2 };
    },
    spring(place4) {
      const { x: x2, heights, back, depth } = place4;
      const [top, foot] = endsOf(heights);
      const [from, to] = [x2(top, PLATE), back].sort((a2, b2) => a2 - b2);
      const turns = Math.round(depth / PITCH);
      const wire = coil(Number(from), Number(to), (top + foot) / 2, turns, HIGH2);
      const plate = slab(place4, PLATE);
      return { own: plate, lines: area(plate) + wire };
    },
    board(place4) {
      const plank = slab(place4, PLANK);
      return { own: plank, lines: area(plank) + line2(face(place4, PLANK / 2)) };
    }
  };
  function depthOf(what, { edge: edge3, way }, { width }) {
    const beyond = way > 0 ? width - edge3 : edge3;
    const depth = Math.max(LEAST2, Math.min(MOST5, SHARE * beyond));
    return what === "board" ? SHALLOW * depth : depth;
  }
  function thingPaths(what, wall, layout, dent, height) {
    const place4 = pressed(what, wall, layout, dent, height);
    const { own, lines: lines4 } = MADE2[what](place4);
    const inner = mounting(what, wall, layout, place4.back);
    const far = wall.edge + wall.way * THICK;
    const behind = area([...inner, [far, wall.top], [far, layout.track + layout.beam]]);
    const [begin = 0] = place4.heights.slice(-3);
    return {
      body: behind + area(own),
      hatch: behind,
      face: line2(face(place4)) + line2(inner),
      was: dent < SEEN ? "" : `M${px(wall.edge)} ${px(begin)}V${px(layout.track)}`,
      lines: lines4
    };
  }
  function pressed(what, wall, layout, dent, height) {
    const { edge: edge3, way, top } = wall;
    const foot = layout.track;
    const depth = depthOf(what, wall, layout);
    const back = edge3 + way * Math.max(depth, dent + SOLID);
    const place4 = (heights, give) => ({
      x: (y2, behind = 0) => edge3 + way * (give(y2) + behind),
      heights,
      back,
      depth
    });
    if (what === "spring" || dent === 0) return place4([top, foot], () => dent);
    const high = Math.max(top, foot - height - ROOM2);
    const shoulder = Math.max(top, Math.min(high, what === "board" ? top + ARM : high - dent));
    const part = (y2) => y2 < high ? (y2 - shoulder) / (high - shoulder) : 1;
    return place4([top, shoulder, high, foot], (y2) => dent * Math.max(0, part(y2)));
  }
  function mounting(what, { edge: edge3, way, top }, { track, beam }, back) {
    const held = edge3 + way * PLANK;
    const arm = what === "board" ? [
      [back, top + ARM],
      [held, top + ARM],
      [held, top]
    ] : [[back, top]];
    return [[edge3, track + beam], [edge3, track], [back, track], ...arm];
  }
  function endsOf(heights) {
    return [Math.min(...heights), Math.max(...heights)];
  }
  function face({ x: x2, heights }, behind = 0) {
    return heights.map((y2) => [x2(y2, behind), y2]);
  }
  function slab(place4, thick) {
    return [...face(place4), ...face(place4, thick).reverse()];
  }
  function line2(points) {
    return `M${points.map(([x2, y2]) => `${px(x2)} ${px(y2)}`).join("L")}`;
  }
  function area(points) {
    return `${line2(points)}Z`;
  }

  // src/scene/beside/lens-thing.js
  var TOP5 = 22;
  var FOOT = 88;
  var ARM2 = 12;
  var THICK2 = { spring: 12, board: 24 };
  var SOLID2 = 12;
  var FAR2 = 720;
  var PITCH2 = 16;
  var HIGH3 = 20;
  var BUBBLE = 1.4;
  function drawThing(group2, what, thing) {
    const rect = need(group2, '[data-part="body"]');
    const parts2 = ["mounting", "thing"].map((name) => group2.querySelector(`[data-part="${name}"]`));
    if (what === "wall") {
      for (const part of parts2) part?.remove();
      put(rect, "width", String(FAR2));
      return;
    }
    const [mounting2, lines4] = parts2[0] && parts2[1] ? parts2 : added(rect);
    const { end: end2, was, out, depth } = thing;
    const back = was + out * Math.max(depth, Math.abs(end2 - was) + (THICK2[what] ?? 0) + SOLID2);
    const thick = THICK2[what] ?? Math.abs(back - end2);
    put(rect, "x", px(out > 0 ? end2 : end2 - thick));
    put(rect, "width", px(thick));
    const behind = end2 + out * thick;
    const from = what === "board" ? `M${px(back)} ${TOP5 + ARM2}H${px(behind)}V${TOP5}` : `M${px(back)} ${TOP5}`;
    put(mounting2, "d", `${from}h${out * FAR2}V${FOOT}H${px(back)}Z`);
    put(lines4, "class", what === "spring" ? "carts-coil" : "carts-fine");
    put(lines4, "d", inside(what, { ...thing, back, behind }));
  }
  function inside(what, { end: end2, depth, back, behind }) {
    if (what === "board") return `M${px((end2 + behind) / 2)} ${TOP5}V${FOOT}`;
    if (what === "foam") return bubbles(() => end2, back, depth, [TOP5, FOOT], BUBBLE);
    const [low, high] = [Math.min(behind, back), Math.max(behind, back)];
    return coil(low, high, (TOP5 + FOOT) / 2, Math.round(depth / PITCH2), HIGH3);
  }
  function added(rect) {
    const mounting2 = svg("path", { "data-part": "mounting", class: "carts-box" });
    const lines4 = svg("path", { "data-part": "thing" });
    rect.after(mounting2, lines4);
    return [mounting2, lines4];
  }

  // src/scene/beside/lens.js
  var TIMES = [10, 5, 2, 1];
  var MARGIN = 16;
  var WIDTH5 = 360;
  var TRACK = 96;
  var BAR = 70;
  var NAME = 42;
  var ABOVE3 = 16;
  var SCALE = 3;
  var Lens = class {
    #run = null;
    #windows = [];
    #perMetre = 3e3;
    // units
    #picture = 300;
    // units that one metre would take as large as in the picture
    #perForce = 100;
    // units of the full scale
    #t = 0;
    constructor(root, baked, redraw) {
      this.root = root;
      this.view = baked.view;
      [this.layout] = baked.view.layouts;
      this.scene = root.closest("carts-scene");
      this.plot = need(root, "svg");
      this.note = need(root, ".carts-lens-note");
      onResize(root, () => {
        this.#measure();
        redraw();
      });
    }
    #measure() {
      for (const layout of this.view.layouts) {
        const stage = this.scene.querySelector(`.carts-stage-${layout.kind}`);
        const [shown3, own] = [stage?.clientWidth ?? 0, this.plot.clientWidth];
        if (!shown3 || !own) continue;
        const unit = shown3 / layout.width * (WIDTH5 / own);
        this.layout = layout;
        this.#picture = layout.scale * unit;
        this.#perForce = layout.force * unit;
      }
      this.#enlarge();
    }
    #enlarge() {
      const give = Math.max(this.view.gives, this.#run ? wallGives(this.#run) : 0);
      const room = WIDTH5 / 2 - MARGIN;
      const times2 = TIMES.find((one) => give * one * this.#picture <= room) ?? 1;
      this.#perMetre = times2 * this.#picture;
      say(need(this.root, ".carts-heading"), tr("Lens on the contact, ×{times}", { times: times2 }));
      const length = niceAbove(BAR / this.#perMetre / 2.5);
      const bar2 = px(length * this.#perMetre);
      put(need(this.root, '[data-part="bar"]'), "d", `M10 16v-5m0 2.5h${bar2}m0 -2.5v5`);
      const text = need(this.root, '[data-part="bar-text"]');
      put(text, "x", px(Number(bar2) + 16));
      say(text, length < 0.01 ? `${short(length * 1e3)} mm` : `${short(length * 100)} cm`);
    }
    show(run, windows) {
      this.#run = run;
      this.#windows = windows;
      this.#enlarge();
    }
    at(t3) {
      const run = this.#run;
      const coming = this.#windows.find(({ end: end2 }) => t3 <= end2);
      const past = latestTouch(this.#windows, t3);
      const touch = coming ?? past;
      put(this.plot, "visibility", touch ? "visible" : "hidden");
      this.root.classList.toggle(
        "carts-is-slow",
        Boolean(touch && t3 >= touch.start && t3 <= touch.end)
      );
      if (!run || !touch) return say(this.note, tr("Nothing touches in this run."));
      this.#t = t3;
      const faces = [this.#side(run, touch, 0).face, this.#side(run, touch, 1).face];
      const out = (Number(faces[1]) - Number(faces[0])) * this.#perMetre > WIDTH5;
      const over = past && t3 > past.end && (out || t3 >= run.header.until);
      say(need(this.root, '[data-part="when"]'), over ? tr("when they pushed hardest") : "");
      if (over) this.#t = hardest(run, past);
      this.#show(run, over ? past : touch);
    }
    #show(run, touch) {
      const t3 = this.#t;
      const [left2, right] = [this.#side(run, touch, 0), this.#side(run, touch, 1)];
      const overlap = Math.max(0, left2.face - right.face);
      const give = Math.min(overlap, left2.bumper + right.bumper);
      const share = Math.min(left2.bumper, left2.bumper && right.bumper ? give / 2 : give);
      const touched = isWall(left2.name) ? right.face + give : left2.face - share;
      const middle = overlap > 0 ? touched : (left2.face + right.face) / 2;
      const faces = overlap > 0 ? [touched, touched] : [left2.face, right.face];
      const force2 = contactForce(run, touch.pair, t3, NOISE * (this.view.force || 1));
      [left2, right].forEach((side, k) => {
        this.#draw(run, k, side, Number(faces[k]), middle, force2);
      });
      const pushed = touch.loose && t3 >= touch.start && t3 <= touch.end;
      const at3 = (x2) => WIDTH5 / 2 + (x2 - middle) * this.#perMetre;
      const wall = [left2, right].find(({ name }) => isWall(name));
      const was = wall && overlap > 0 ? `M${px(at3(wall.face))} 22V${TRACK}` : "";
      put(need(this.root, '[data-part="was"]'), "d", was);
      const wire = coil(at3(left2.face), at3(right.face), TRACK - 14, void 0, 6);
      put(need(this.root, '[data-part="between"]'), "d", pushed ? wire : "");
      const pair = bodiesOf(touch.bodies, run.header.track);
      const gap = right.face - left2.face;
      const apart = gap > 0 ? tr("{length} apart", { length: lengthText(gap) }) : tr("squeezed by {length}", { length: lengthText(overlap) });
      const size = fixed(force2, this.view.decimals.F ?? 2);
      const push = tr("{size} on each", { size: `${size} N` });
      say(this.note, `${pair}: ${apart}, ${push}; t = ${fixed(t3, 4)} s`);
    }
    #side({ header, trajectory }, touch, k) {
      const name = String(touch.bodies[k]);
      const cart = header.bodies.find((one) => one.name === name);
      if (!cart) {
        const wall = name === "left" ? 0 : header.track.length ?? 0;
        return { name, edge: wall, face: wall, bumper: 0 };
      }
      const { t: t3, x: x2, v: v2 } = trajectory;
      const centre = valueAt(t3, x2[name] ?? [], v2[name] ?? [], this.#t);
      const way = k === 0 ? 1 : -1;
      const face2 = centre + way * cart.length / 2;
      return { name, face: face2, edge: face2 - way * cart.bumper_length, bumper: cart.bumper_length };
    }
    #draw(run, k, side, face2, middle, force2) {
      const at3 = (x2) => WIDTH5 / 2 + (x2 - middle) * this.#perMetre;
      const group2 = need(this.root, `[data-side="${k}"]`);
      const { bodies, track } = run.header;
      const index = bodies.findIndex(({ name: name2 }) => name2 === side.name);
      put(group2, "class", index < 0 ? "carts-wall" : `carts-b${index % 8}`);
      const way = k === 0 ? 1 : -1;
      const end2 = at3(face2);
      const edge3 = index < 0 ? end2 : at3(side.edge);
      const rect = need(group2, '[data-part="body"]');
      put(rect, "x", px(k === 0 ? edge3 - 2 * WIDTH5 : edge3));
      const what = index < 0 ? whatIs(side.name, track) : "wall";
      const depth = this.#depth(side.name, what, track.length);
      drawThing(group2, what, { end: end2, was: at3(side.face), out: way > 0 ? -1 : 1, depth });
      const bent = need(group2, '[data-part="spring"]');
      put(bent, "d", side.bumper ? spring(edge3 / SCALE, end2 / SCALE) : "");
      put(bent, "transform", `translate(0 ${TRACK}) scale(${SCALE})`);
      const plate = need(group2, '[data-part="face"]');
      put(plate, "transform", `translate(${px(end2 - 3 * way)} 0)`);
      const name = need(group2, '[data-part="name"]');
      const inside2 = Math.min(WIDTH5 - 34, Math.max(34, edge3 - 22 * way));
      put(name, "x", px(inside2));
      put(name, "y", String(what === "wall" ? NAME : ABOVE3));
      say(name, index < 0 ? kind(side.name, track) : side.name);
      const arrow2 = need(group2, '[data-part="arrow"]');
      const cut = isCut(force2, this.view.force);
      const length = -way * arrowLength(force2, this.view.force, this.#perForce);
      put(arrow2, "d", (cut ? cutArrow : blockArrow)(end2, TRACK - 46, length));
    }
    #depth(side, what, length) {
      if (!this.layout || what === "wall") return 0;
      const wall = wallAt(side === "left" ? "left" : "right", length, this.layout, 0);
      return depthOf(what, wall, this.layout) / this.layout.scale * this.#perMetre;
    }
  };
  function hardest({ header }, { pair, start, end: end2 }) {
    const peak = header.events.find(
      (one) => one.kind === "peak" && one.bodies.join("-") === pair && one.t >= start && one.t <= end2
    );
    return peak?.t ?? start;
  }
  function wallGives({ header: { bodies, track }, trajectory: { x: x2 } }) {
    const ends = [
      { wall: track.left, at: 0, cart: bodies[0], way: -1 },
      { wall: track.right, at: track.length ?? 0, cart: bodies.at(-1), way: 1 }
    ];
    const gives = ends.map(({ wall, at: at3, cart, way }) => {
      if (wall !== "wall" || !cart) return 0;
      const reach = cart.length / 2 - cart.bumper_length;
      return Array.from(x2[cart.name] ?? []).reduce(
        (most, centre) => Math.max(most, way * (centre - at3) + reach),
        0
      );
    });
    return Math.max(...gives);
  }
  function lengthText(metres) {
    return metres < 0.1 ? `${fixed(metres * 1e3, 1)} mm` : `${fixed(metres * 100, 1)} cm`;
  }

  // src/scene/beside/views.js
  var KINDS2 = {
    "free-body": [tr("forces on each cart"), FreeBody],
    lens: [tr("lens on the contact"), Lens],
    bars: [tr("momentum before and now"), Bars]
  };
  var Views = class {
    #views = [];
    #now = null;
    constructor(root, baked) {
      this.frames = root.querySelectorAll(".carts-views");
      for (const section of root.querySelectorAll(".carts-view")) {
        const element = section;
        const kind2 = KINDS2[element.dataset.view ?? ""];
        if (kind2) this.#views.push(new kind2[1](element, baked, () => this.#again()));
      }
    }
    get choices() {
      return this.#views.map(({ root }) => {
        const key = root.dataset.view ?? "";
        return { key, label: KINDS2[key]?.[0] ?? key, seen: !root.hidden };
      });
    }
    choose(key, seen) {
      for (const { root } of this.#views) if (root.dataset.view === key) root.hidden = !seen;
      this.#again();
    }
    show(run, windows, t3) {
      if (!isTold(run)) return;
      for (const frame2 of this.frames) frame2.hidden = false;
      this.#now = { run, windows, t: t3 };
      for (const view of this.#views) view.show(run, windows);
    }
    at(t3) {
      if (!this.#now) return;
      this.#now.t = t3;
      for (const view of this.#views) if (!view.root.hidden) view.at(t3);
    }
    #again() {
      if (this.#now) this.at(this.#now.t);
    }
  };

  // ../view/graph.js
  var LEFT5 = 52;
  var RIGHT4 = 350;
  var TOP6 = 8;
  var BOTTOM5 = 127;
  var WIDTH6 = 360;
  var HEIGHT3 = 160;
  var GAP2 = 5;
  var WIDEST = 9.2;
  var LETTER2 = 8;
  var BELOW_LINE = 5;
  var [FEW4, ENOUGH, MANY4] = [5, 4, 8];
  var HARDLY = 0.05;
  var NEAR2 = 0.7;
  var LONG3 = 8;
  var PIECES = 8;
  var STRAIGHT = 0.05;
  function timeX(plane, t3) {
    return LEFT5 + (t3 - plane.time.low) * ((RIGHT4 - LEFT5) / (plane.time.high - plane.time.low));
  }
  function valueY(plane, value) {
    return BOTTOM5 - (value - plane.value.low) * ((BOTTOM5 - TOP6) / (plane.value.high - plane.value.low));
  }
  function extent(curves, times2) {
    let low = 0;
    let high = 0;
    const take = (value) => {
      if (value < low) low = value;
      if (value > high) high = value;
    };
    for (const { values, slopes } of curves) {
      for (let k = 0; k < values.length; k += 1) {
        take(Number(values[k]));
        const turned = turnAfter(times2, values, slopes, k);
        if (turned !== null) take(turned);
      }
    }
    return [low, high];
  }
  function reached(run, [low, high, factor, room], mirrored = false) {
    const down = Math.min(run[0] * factor, mirrored ? -high : low);
    const up2 = Math.max(run[1] * factor, high);
    const most = room * Math.max(-run[0], run[1]);
    return most > 0 ? [Math.max(down, -most), Math.min(up2, most)] : [down, up2];
  }
  function planeFor(values, window) {
    return { time: span(window[0], window[1], 6), value: readable(values[0], values[1]) };
  }
  function readable(low, high) {
    const plain3 = axis(low, high, FEW4);
    const found3 = ticks2(plain3);
    const hardly = HARDLY * (high - low);
    const sides = (low >= -hardly || found3.some((v2) => v2 < 0)) && (high <= hardly || found3.some((v2) => v2 > 0));
    return found3.length >= ENOUGH && sides ? plain3 : axis(low, high, MANY4);
  }
  function path2(curve2, times2, plane, seen = Infinity) {
    const { values, slopes } = curve2;
    const kx = (RIGHT4 - LEFT5) / (plane.time.high - plane.time.low);
    const ky = (BOTTOM5 - TOP6) / (plane.value.high - plane.value.low);
    const last = times2.length - 1;
    let drawn2 = 0;
    let x0 = timeX(plane, Number(times2[0]));
    let y0 = valueY(plane, Number(values[0]));
    let d2 = `M${px(x0)} ${px(y0)}`;
    const isLong = (k, x2) => k < last && timeX(plane, Number(times2[k + 1])) - x2 > LONG3;
    for (let k = 1; k <= last; k += 1) {
      if (Number(times2[k]) > seen) return d2 + tail2(curve2, times2, plane, Number(times2[k - 1]), seen);
      const x2 = timeX(plane, Number(times2[k]));
      const y2 = valueY(plane, Number(values[k]));
      const near = Math.abs(x2 - x0) < NEAR2 && Math.abs(y2 - y0) < NEAR2;
      if (k < last && near && !isLong(k, x2)) continue;
      const third = (Number(times2[k]) - Number(times2[k - 1])) / 3;
      let bent = false;
      if (slopes && drawn2 === k - 1 && third > 0) {
        const [x1, x22] = [x0 + third * kx, x2 - third * kx];
        const y1 = y0 - Number(slopes[k - 1]) * third * ky;
        const y22 = y2 + Number(slopes[k]) * third * ky;
        bent = Math.abs(y1 - (2 * y0 + y2) / 3) > STRAIGHT || Math.abs(y22 - (y0 + 2 * y2) / 3) > STRAIGHT;
        if (bent) d2 += `C${px(x1)} ${px(y1)} ${px(x22)} ${px(y22)} ${px(x2)} ${px(y2)}`;
      }
      if (!bent) d2 += `L${px(x2)} ${px(y2)}`;
      drawn2 = k;
      x0 = x2;
      y0 = y2;
    }
    return d2;
  }
  function tail2({ values, slopes }, times2, plane, from, to) {
    let d2 = "";
    for (let k = 1; k <= PIECES; k += 1) {
      const t3 = from + (to - from) * k / PIECES;
      d2 += `L${px(timeX(plane, t3))} ${px(valueY(plane, valueAt(times2, values, slopes, t3)))}`;
    }
    return d2;
  }
  function timeMarks(plane) {
    const decimals = axisDecimals(plane.time);
    return ticks2(plane.time).map((t3) => {
      const at3 = timeX(plane, t3);
      const label = fixed(t3, decimals);
      const wide = LETTER2 * (label.length - (decimals > 0 ? 0.5 : 0));
      return { at: px(at3), textX: px(Math.min(at3, WIDTH6 - wide / 2)), label };
    });
  }
  function valueMarks(plane) {
    const power2 = valuePower(plane);
    const decimals = power2 ? power2 - exponent(plane.value.step) : axisDecimals(plane.value);
    return ticks2(plane.value).map((v2) => ({
      at: px(valueY(plane, v2)),
      textY: px(valueY(plane, v2) + BELOW_LINE),
      label: fixed(v2 / Number(`1e${power2}`), Math.max(0, decimals)),
      zero: v2 === 0
    }));
  }
  function valuePower({ value }) {
    const decimals = axisDecimals(value);
    const widths = ticks2(value).map(
      (v2) => WIDEST * (fixed(v2, decimals).length - (decimals ? 0.5 : 0))
    );
    if (Math.max(...widths) <= LEFT5 - GAP2) return 0;
    return exponent(Math.max(Math.abs(value.low), Math.abs(value.high)));
  }

  // src/scene/how/ghost.js
  var Ghost = class {
    #run = null;
    #group = null;
    constructor(stage) {
      this.stage = stage;
    }
    show(run) {
      this.#run = run;
      this.#group?.remove();
      this.#group = null;
      if (!run) return;
      const { layout, view, root } = this.stage;
      const group2 = svg("g", { class: "carts-ghosts", "aria-hidden": "true" });
      for (const body2 of run.header.bodies) {
        const half = body2.length * layout.scale / 2;
        const { height } = box(body2, view, layout, 0);
        const shape = {
          x: px(-half),
          y: px(-height),
          width: px(2 * half),
          height: px(height),
          rx: 3
        };
        group2.append(svg("rect", { class: "carts-ghost", ...shape }));
      }
      const first = root.querySelector(".carts-cart");
      first?.parentNode?.insertBefore(group2, first);
      this.#group = group2;
    }
    at(t3) {
      if (!this.#run || !this.#group) return;
      const { header, trajectory } = this.#run;
      const { layout, camera } = this.stage;
      header.bodies.forEach(({ name }, i2) => {
        const [x2, v2] = [trajectory.x[name] ?? [], trajectory.v[name] ?? []];
        const place4 = layout.origin + (valueAt(trajectory.t, x2, v2, t3) - camera * t3) * layout.scale;
        const at3 = `translate(${px(place4)} ${px(layout.track)})`;
        this.#group?.children[i2]?.setAttribute("transform", at3);
      });
    }
  };
  function ghostCurves(plot2, curves, times2, plane) {
    const found3 = plot2.querySelector('[data-part="ghost"]');
    if (!curves.length) return found3?.remove();
    const front = plot2.querySelector('[data-part="curves"]');
    const clip = front?.getAttribute("clip-path") ?? "none";
    const group2 = found3 ?? svg("g", { "data-part": "ghost", "clip-path": clip });
    if (!found3) front?.before(group2);
    group2.replaceChildren(
      ...curves.filter(({ over }) => !over).map((curve2) => svg("path", { class: "carts-pale", d: path2(curve2, times2, plane) }))
    );
  }

  // src/scene/graphs/axes.js
  function drawAxes(root, plane) {
    const times2 = timeMarks(plane);
    const rows = valueMarks(plane);
    marks2(need(root, '[data-part="times"]'), times2.length, (line3, text, i2) => {
      const { at: at3, textX, label } = times2[i2];
      put(line3, "class", "carts-grid");
      put(line3, "d", `M${at3} ${TOP6}V${BOTTOM5}`);
      put(text, "class", "carts-tick-x");
      put(text, "x", textX);
      put(text, "y", String(BOTTOM5 + 15));
      say(text, label);
    });
    marks2(need(root, '[data-part="values"]'), rows.length, (line3, text, i2) => {
      const { at: at3, textY, label, zero } = rows[i2];
      put(line3, "class", zero ? "carts-zero" : "carts-grid");
      put(line3, "d", `M${LEFT5} ${at3}H${RIGHT4}`);
      put(text, "class", "carts-tick-y");
      put(text, "x", String(LEFT5 - GAP2));
      put(text, "y", textY);
      say(text, label);
    });
    power(need(root, ".carts-plot"), valuePower(plane));
  }
  function power(plot2, exponent2) {
    const found3 = plot2.querySelector('[data-part="power"]');
    if (!exponent2) return found3?.remove();
    const at3 = { class: "carts-unit", "data-part": "power", x: LEFT5 + 4, y: TOP6 + 10 };
    const text = found3 ?? plot2.appendChild(svg("text", at3));
    say(text, `× 10${superscript(exponent2)}`);
  }
  function marks2(group2, count2, draw) {
    while (group2.children.length > 2 * count2) group2.lastElementChild?.remove();
    while (group2.children.length < 2 * count2) group2.append(svg("path"), svg("text"));
    for (let i2 = 0; i2 < count2; i2 += 1) {
      draw(
        group2.children[2 * i2],
        group2.children[2 * i2 + 1],
        i2
      );
    }
  }

  // ../view/impulse.js
  function area2({ trajectory }, pair, from, to) {
    const { t: t3, F: F2, dF } = trajectory;
    const [values, slopes] = [F2[pair] ?? [], dF[pair] ?? []];
    let sum = 0;
    for (let k = Math.max(0, rowAt(t3, from)); k < t3.length - 1 && Number(t3[k]) < to; k += 1) {
      const [low, high] = [Math.max(from, Number(t3[k])), Math.min(to, Number(t3[k + 1]))];
      if (high <= low) continue;
      const at3 = (when) => hermite(t3, values, slopes, k, when);
      sum += (high - low) / 6 * (at3(low) + 4 * at3((low + high) / 2) + at3(high));
    }
    return sum;
  }
  function changes({ header, trajectory }, windows, touch, t3) {
    const felt = (pair) => header.events.some(
      (event) => event.bodies?.join("-") === pair && event.t <= t3 && (event.t >= touch.start || trajectory.F[pair])
    );
    return touch.bodies.map((name) => {
      const mass = header.bodies.find((body2) => body2.name === name)?.mass;
      const others = windows.some(
        (one) => one !== touch && one.bodies.includes(name) && one.start < t3 && one.end > touch.start
      );
      const acting = header.effects.some(
        (effect) => effect.active && effect.carts.includes(name) && !(isLink(effect) && effect.between?.join("-") === touch.pair)
        // what a pair's own spring does is in its F
      );
      const brief2 = header.contacts.some(
        ({ pair, bodies, stiffness }) => pair !== touch.pair && !stiffness && bodies.includes(name) && felt(pair)
      );
      if (mass === void 0 || others || acting || brief2) return { name, change: null };
      const v2 = (at3) => valueAt(trajectory.t, trajectory.v[name] ?? [], trajectory.a[name] ?? [], at3);
      return { name, change: mass * (v2(t3) - v2(touch.start)) };
    });
  }

  // src/scene/graphs/impulse-layer.js
  var ImpulseLayer = class {
    constructor(root, view) {
      this.shade = need(root, '[data-part="areas"]');
      this.note = need(root, ".carts-area-note");
      this.decimals = Math.max(3, view.decimals.p ?? 3);
      this.windows = [];
    }
    show({ header }) {
      this.windows = touches(header.events, header.until).map(
        (touch) => touch.lasts ? { ...touch, end: header.until } : touch
      );
    }
    at(run, plane, t3, signed) {
      const touch = latestTouch(this.windows, t3);
      const paths = this.shade.children;
      for (const path3 of paths) put(path3, "d", "");
      if (!touch) {
        const hint = tr("Move into a touch: the shaded area is the impulse.");
        return say(this.note, this.windows.length ? hint : "");
      }
      const end2 = Math.min(t3, touch.end);
      const outline2 = (sign) => under(run, touch, plane, end2, sign);
      put(paths[0], "d", outline2(1));
      if (signed) put(paths[1], "d", outline2(-1));
      const impulse = area2(run, touch.pair, touch.start, end2);
      const names = dashed(touch.bodies, run.header.track);
      const amount3 = fixed(impulse, this.decimals);
      const parts2 = changes(run, this.windows, touch, end2).filter(({ change: change2 }) => change2 !== null).map(
        ({ name, change: change2 }) => tr("m Δv of {name}: {change}", { name, change: fixed(change2 ?? 0, this.decimals) })
      );
      const shaded = t3 >= touch.end ? tr("{names}, shaded area: {amount}", { names, amount: amount3 }) : tr("{names}, shaded area so far: {amount}", { names, amount: amount3 });
      const values = [shaded, ...parts2].join("; ");
      const told4 = parts2.length ? tr("{values}, all in N s.", { values }) : `${values} N s`;
      say(this.note, told4);
    }
  };
  function under({ trajectory: { t: t3, F: F2, dF } }, touch, plane, end2, sign) {
    const force2 = F2[touch.pair];
    const first = rowAt(t3, touch.start);
    if (!force2 || first < 0) return "";
    const length = Math.min(rowAt(t3, end2) + 2, t3.length) - first;
    const part = (column, factor) => Float64Array.from({ length }, (_2, k) => factor * Number(column[first + k]));
    const [values, slope] = [part(force2, sign), dF[touch.pair]];
    const slopes = slope ? part(slope, sign) : null;
    const curve2 = { label: "", style: "", over: false, values, slopes };
    const drawn2 = path2(curve2, part(t3, 1), plane, end2);
    const zero = px(valueY(plane, 0));
    return `M${px(timeX(plane, Number(t3[first])))} ${zero}L${drawn2.slice(1)}V${zero}Z`;
  }

  // src/scene/graphs/key.js
  var Key = class {
    #told = "";
    constructor(root) {
      this.root = root;
    }
    show(curves, note2) {
      const wanted2 = [...curves.map((c2) => `${c2.style}${c2.over}${c2.label}`), note2].join("|");
      if (this.#told === wanted2 && this.root.firstChild) return;
      this.#told = wanted2;
      this.root.replaceChildren(...curves.map(entry), ...note2 ? [html("span", "", note2)] : []);
    }
    forget() {
      this.#told = "";
    }
  };
  function entry({ style, over, label }) {
    const made4 = html("span", `carts-${style}`);
    const size = { viewBox: "0 0 26 10", width: 26, height: 10, "aria-hidden": "true" };
    const sample = svg("svg", size);
    const line3 = { class: `carts-curve carts-${style}${over ? " carts-over" : ""}`, d: "M0 5H26" };
    const marker = { class: `carts-dot carts-${style}`, d: MARKERS[style] ?? "" };
    sample.append(svg("path", line3), svg("path", { ...marker, transform: "translate(13 5)" }));
    made4.append(sample, label);
    return made4;
  }

  // ../view/ledger.js
  var HELD2 = 1e-3;
  function ledger({ header, trajectory }, windows, camera) {
    const moving = seriesOf("energy", header, trajectory, camera).filter((c2) => c2.style !== "total");
    const times2 = trajectory.t;
    const sum = (k) => moving.reduce((s3, c2) => s3 + Number(c2.values[k]), 0);
    const start = sum(0);
    const squeezed = new Float64Array(times2.length);
    const warmed2 = new Float64Array(times2.length);
    const last = Math.max(0, start - sum(times2.length - 1));
    const held = Number(header.energy?.parts.bumpers?.final ?? 0) > HELD2 * last;
    const groups = together3(
      windows.map((touch) => held && touch.lasts ? { ...touch, end: Infinity } : touch)
    );
    let kept = 0;
    for (let k = 0; k < times2.length; k += 1) {
      const t3 = Number(times2[k]);
      const away = Math.max(0, start - sum(k));
      const on = groups.some((group2) => t3 >= group2.start && t3 < group2.end);
      if (!on) kept = away;
      warmed2[k] = Math.min(kept, away);
      squeezed[k] = away - Number(warmed2[k]);
    }
    return [
      ...moving.map((curve2) => ({ ...curve2, label: tr("motion of {cart}", { cart: curve2.label }) })),
      {
        label: tr("in squeezed bumpers"),
        style: "squeezed",
        over: false,
        values: squeezed,
        slopes: null
      },
      {
        label: tr("has warmed the {things}", { things: tr("bumpers") }),
        style: "warmed",
        over: false,
        values: warmed2,
        slopes: null
      }
    ];
  }
  function together3(windows) {
    const groups = [];
    for (const { start, end: end2 } of windows) {
      const last = groups.at(-1);
      if (last && start < last.end) last.end = Math.max(last.end, end2);
      else groups.push({ start, end: end2 });
    }
    return groups;
  }
  function stacked(entries) {
    let below = new Float64Array(entries[0]?.values.length ?? 0);
    return entries.map((entry2) => {
      below = Float64Array.from(below, (value, k) => value + Number(entry2.values[k]));
      return { ...entry2, values: below };
    });
  }

  // src/scene/graphs/ledger-layer.js
  var NEAR3 = 0.5;
  function hasLedger(baked) {
    const { left: left2, right } = baked.run.header.track;
    return !baked.fence.camera || left2 !== "wall" && right !== "wall" && !needsParts(baked);
  }
  var LedgerLayer = class {
    times = [];
    #of = null;
    entries = [];
    tops = [];
    waits = "";
    // why it is not there yet, or not at all
    constructor(root, baked) {
      this.areas = need(root, '[data-part="areas"]');
      this.key = need(root, ".carts-key");
      this.root = root;
      this.asks = needsParts(baked);
      this.camera = baked.fence.camera;
      this.decimals = baked.view.decimals.energy ?? 3;
    }
    show(run, open2, changed) {
      const { events, until } = run.header;
      if (!this.asks) {
        this.#take(run.trajectory.t, ledger(run, touches(events, until), this.camera));
      } else if (open2 && this.#of !== run) {
        this.#of = run;
        this.waits = tr("Computing …");
        void askParts(this.root).then((parts2) => {
          if (this.#of !== run) return;
          this.waits = parts2 ? "" : tr("This change needs Python, which does not run here.");
          this.#take(parts2?.t ?? [], parts2 ? ledgerWithEffects(run.header, parts2) : []);
          changed();
        });
      }
    }
    #take(times2, entries) {
      this.times = times2;
      this.entries = entries;
      this.tops = stacked(entries);
    }
    clear() {
      this.areas.replaceChildren();
    }
    draw(plane) {
      while (this.areas.children.length < this.tops.length) this.areas.append(svg("path"));
      while (this.areas.children.length > this.tops.length) this.areas.lastElementChild?.remove();
      this.tops.forEach((top, i2) => {
        const path3 = this.areas.children[i2];
        put(path3, "class", `carts-band carts-${top.style}`);
        put(path3, "d", band2(this.times, plane, top.values, this.tops[i2 - 1]?.values));
      });
      this.key.replaceChildren(
        ...this.entries.map(({ style }) => {
          const entry2 = document.createElement("span");
          const swatch = svg("svg", { viewBox: "0 0 14 12", width: 14, height: 12 });
          swatch.setAttribute("aria-hidden", "true");
          swatch.append(svg("path", { class: `carts-band carts-${style}`, d: "M1 1H13V11H1Z" }));
          entry2.className = `carts-${style}`;
          entry2.append(swatch, document.createElement("b"));
          return entry2;
        })
      );
    }
    at(t3) {
      this.entries.forEach(({ label, values }, i2) => {
        const now = Math.max(0, valueAt(this.times, values, null, t3));
        const text = this.key.children[i2]?.querySelector("b");
        if (text) say(text, `${label}: ${fixed(now, this.decimals)} J`);
      });
    }
  };
  function band2(times2, plane, top, bottom) {
    const above = [];
    const below = [];
    let [x0, y0, z0] = [-9, -9, -9];
    for (let k = 0; k < times2.length; k += 1) {
      const x2 = timeX(plane, Number(times2[k]));
      const [y2, z2] = [Number(top[k]), Number(bottom?.[k] ?? 0)].map((v2) => valueY(plane, v2));
      const moved = Math.max(Math.abs(x2 - x0), Math.abs(Number(y2) - y0), Math.abs(Number(z2) - z0));
      if (moved < NEAR3 && k < times2.length - 1) continue;
      [x0, y0, z0] = [x2, Number(y2), Number(z2)];
      above.push(`${px(x2)} ${px(y0)}`);
      below.unshift(`${px(x2)} ${px(z0)}`);
    }
    return `M${above.join("L")}L${below.join("L")}Z`;
  }

  // src/scene/graphs/table.js
  var ROWS3 = 10;
  var MOST_EVENTS = 24;
  var WITHIN = 9;
  var MOST_CONTACTS = 3;
  var OF_CONTACTS = ["F", "R", "a"];
  var REST4 = 250;
  var Table = class {
    #waiting = null;
    #timer = 0;
    #seen = Infinity;
    // s, as far as the run was watched
    #shown = null;
    #rows = 0;
    constructor(details, quantity, view) {
      this.details = details;
      this.quantity = quantity;
      this.view = view;
      details.addEventListener("toggle", () => {
        this.#waiting = this.#shown;
        this.fill();
      });
    }
    show(run, curves, rows) {
      this.#waiting = { run, curves, rows };
      this.#shown = this.#waiting;
      clearTimeout(this.#timer);
      this.#timer = setTimeout(() => this.fill(), this.details.open ? 0 : REST4);
    }
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
      const unit = this.quantity === "v" ? speed : QUANTITIES[this.quantity]?.[2] ?? "";
      const head = html("tr");
      head.append(
        heading(tr("t in s")),
        ...curves.map((curve2) => heading(`${curve2.label}, ${unit}`))
      );
      need(this.details, "thead").replaceChildren(head);
      const decimals = this.view.decimals[this.quantity] ?? 3;
      const scale = greatest3(curves);
      const times2 = this.#times(run);
      this.#rows = times2.length;
      const rows = times2.map((t3) => {
        const row = html("tr");
        row.append(html("td", "", fixed(t3, this.view.decimals.t ?? 3)));
        for (const { values, slopes } of curves) {
          const value = valueAt(instants, values, slopes, t3);
          row.append(html("td", "", fixed(Math.abs(value) < NOISE * scale ? 0 : value, decimals)));
        }
        return row;
      });
      need(this.details, "tbody").replaceChildren(...rows);
    }
    #times(run) {
      const told4 = this.details.open && OF_CONTACTS.includes(this.quantity);
      const within = told4 ? contactTimes(run) : [];
      const times2 = /* @__PURE__ */ new Set([...tableTimes(run), ...within]);
      return [...times2].filter((t3) => t3 <= this.#seen).sort((a2, b2) => a2 - b2);
    }
  };
  function contactTimes(run) {
    const { trajectory } = run;
    const last = Number(trajectory.t[trajectory.t.length - 1]);
    return windowsOf(run).slice(0, MOST_CONTACTS).flatMap(
      ({ start, end: end2 }) => Array.from({ length: WITHIN }, (_2, k) => start + (k + 1) / (WITHIN + 1) * (end2 - start))
    ).filter((t3) => t3 <= last);
  }
  function tableTimes({ header, trajectory }) {
    const times2 = /* @__PURE__ */ new Set([...ticks2(span(0, header.until, ROWS3)), header.until]);
    for (const event of header.events.slice(0, MOST_EVENTS)) times2.add(event.t);
    const last = Number(trajectory.t[trajectory.t.length - 1]);
    return [...times2].filter((t3) => t3 <= last).sort((a2, b2) => a2 - b2);
  }
  function heading(text) {
    const cell3 = html("th", "", text);
    cell3.setAttribute("scope", "col");
    return cell3;
  }
  function greatest3(curves) {
    let found3 = 0;
    for (const { values } of curves) {
      for (let k = 0; k < values.length; k += 1) found3 = Math.max(found3, Math.abs(Number(values[k])));
    }
    return found3 || 1;
  }

  // src/scene/graphs/graph-view.js
  var GraphView = class {
    #curves = [];
    #run = null;
    #first = null;
    #plane = planeFor([0, 1], [0, 1]);
    #dots = [];
    behind = null;
    drawn = () => {
    };
    #pressed = false;
    // “with sign”, “as a ledger”
    #t = 0;
    // s, the instant shown
    #seen = Infinity;
    // s, as far as the run was watched
    #window = null;
    constructor(root, baked, seek) {
      this.root = root;
      this.quantity = root.dataset.quantity ?? "x";
      this.camera = baked.fence.camera;
      this.signedName = forceName(baked.run.header);
      this.name = sizeName(baked.run.header);
      this.reach = baked.view.reach[this.quantity] ?? [0, 0, 1, 0];
      this.per = speedUnit(baked.view.velocity)[0];
      this.plot = need(root, ".carts-plot");
      this.key = new Key(need(root, ".carts-key"));
      this.table = new Table(need(root, "details"), this.quantity, baked.view);
      this.button = root.querySelector(".carts-sign");
      this.impulse = this.quantity === "F" ? new ImpulseLayer(root, baked.view) : null;
      this.ledger = this.quantity === "energy" && hasLedger(baked) ? new LedgerLayer(root, baked) : null;
      if (this.quantity === "energy" && !this.ledger && this.button) this.button.hidden = true;
      this.button?.addEventListener("click", () => this.#toggle());
      onPointed(this.plot, (event) => {
        const frame2 = this.plot.getBoundingClientRect();
        const x2 = (event.clientX - frame2.left) / frame2.width * WIDTH6;
        const part = Math.min(1, Math.max(0, (x2 - LEFT5) / (RIGHT4 - LEFT5)));
        const { low, high } = this.#plane.time;
        seek(low + part * (high - low));
      });
    }
    enable() {
      if (this.button) this.button.disabled = false;
    }
    show(run, t3) {
      if (!isTold(run)) return;
      this.#run = run;
      if (run.trajectory.t.length > 1) this.#first ??= run;
      this.impulse?.show(run);
      this.ledger?.show(run, this.#pressed, () => this.show(run, this.#t));
      this.#draw(t3);
      const told4 = this.#stacked ? this.ledger?.entries ?? [] : this.#curves;
      this.table.show(run, told4, this.#times(run));
    }
    grow(seen) {
      this.#seen = seen;
      this.table.grow(seen);
      if (this.#run) seen === Infinity ? this.#draw(this.#t) : this.#lines(this.#run);
    }
    zoom(window, t3) {
      this.#window = window;
      if (this.#run) this.#draw(t3);
    }
    at(t3) {
      this.#t = t3;
      const run = this.#run;
      if (!run) return;
      const x2 = px(timeX(this.#plane, t3));
      this.impulse?.at(run, this.#plane, t3, this.#pressed);
      if (this.#stacked) this.ledger?.at(t3);
      put(need(this.root, ".carts-cursor"), "transform", `translate(${x2} 0)`);
      this.#curves.forEach((curve2, i2) => {
        const y2 = valueY(this.#plane, valueAt(this.#times(run), curve2.values, curve2.slopes, t3));
        const dot2 = this.#dots[i2];
        if (dot2) put(dot2, "transform", `translate(${x2} ${px(y2)})`);
      });
    }
    get #signed() {
      return this.#pressed && this.quantity === "F";
    }
    get #stacked() {
      return this.#pressed && this.ledger !== null && this.ledger.entries.length > 0;
    }
    #times(run) {
      return this.#stacked ? this.ledger?.times ?? [] : run.trajectory.t;
    }
    #toggle() {
      this.#pressed = !this.#pressed;
      this.button?.setAttribute("aria-pressed", String(this.#pressed));
      this.#name();
      this.root.dispatchEvent(new CustomEvent("carts-redraw", { bubbles: true }));
    }
    #name() {
      const [title, symbol, rest] = this.ledger ? [this.#stacked ? tr("Energy") : tr("Kinetic energy"), "E", tr(" in {unit}", { unit: "J" })] : this.#pressed ? [this.signedName, "F", tr(" in N, + is right")] : [this.name, "|F|", tr(" in {unit}", { unit: "N" })];
      const italic = Object.assign(document.createElement("i"), { textContent: symbol });
      need(this.root, ".carts-graph-name").replaceChildren(`${title} `, italic, rest);
    }
    #draw(t3) {
      const run = this.#run;
      const { header } = run;
      this.#curves = this.#curvesOf(run);
      const behind = this.behind && !this.#stacked ? this.#curvesOf(this.behind) : [];
      const first = this.#first ? extent(this.#curvesOf(this.#first), this.#times(this.#first)) : [0, 0];
      const all = [
        extent(this.#curves, this.#times(run)),
        extent(behind, this.behind?.trajectory.t ?? []),
        reached(first, this.reach, this.#signed)
      ];
      const low = Math.min(...all.map((one) => one[0]));
      const high = Math.max(...all.map((one) => one[1]));
      this.#plane = planeFor([low, high], this.#window ?? [0, header.until]);
      drawAxes(this.root, this.#plane);
      const group2 = need(this.root, '[data-part="curves"]');
      fit(group2, this.#curves.length, () => svg("path"));
      this.#curves.forEach((curve2, i2) => {
        const line3 = group2.children[i2];
        put(line3, "class", `carts-curve carts-${curve2.style}${curve2.over ? " carts-over" : ""}`);
      });
      this.#lines(run);
      ghostCurves(this.plot, behind, this.behind?.trajectory.t ?? [], this.#plane);
      this.drawn(this, this.#plane);
      this.#cursor();
      if (this.#stacked) {
        this.ledger?.draw(this.#plane);
        this.key.forget();
      } else {
        this.ledger?.clear();
        const whole = this.#seen === Infinity;
        const note2 = whole ? graphNote(this.quantity, header.events, this.#curves.length) : "";
        this.key.show(this.#curves, this.#pressed && this.ledger?.waits || note2);
      }
      if (this.ledger) this.#name();
      this.at(t3);
    }
    #lines(run) {
      const group2 = need(this.root, '[data-part="curves"]');
      this.#curves.forEach((curve2, i2) => {
        const line3 = group2.children[i2];
        put(line3, "d", path2(curve2, this.#times(run), this.#plane, this.#seen));
      });
      const room = this.root.querySelector(".carts-seen rect");
      const end2 = Math.min(RIGHT4, Math.max(LEFT5, timeX(this.#plane, this.#seen)));
      if (room) put(room, "width", px(end2 - LEFT5 + 1));
    }
    #curvesOf({ header, trajectory }) {
      if (this.#stacked) return this.ledger?.tops ?? [];
      return seriesOf(this.quantity, header, trajectory, this.camera, this.#signed, this.per);
    }
    #cursor() {
      const group2 = need(this.root, '[data-part="cursor"]');
      fit(group2, this.#curves.length + 1, () => svg("path"));
      this.#dots = [...group2.children].slice(1);
      this.#dots.forEach((dot2, i2) => {
        const style = this.#curves[i2]?.style ?? "b0";
        put(dot2, "class", `carts-dot carts-${style}`);
        put(dot2, "d", MARKERS[style] ?? "");
      });
    }
  };

  // src/scene/readouts.js
  var Readouts = class {
    #run = null;
    constructor(root, baked) {
      this.camera = baked.fence.camera;
      this.decimals = baked.view.decimals;
      this.per = speedUnit(baked.view.velocity)[0];
      this.zero = NOISE * (baked.view.force || 1);
      this.cards = baked.run.header.bodies.map(({ name }) => {
        const card = need(root, `.carts-card[data-body="${name}"]`);
        const outputs = card.querySelectorAll(".carts-value");
        return { name, outputs: new Map([...outputs].map((o3) => [o3.dataset.quantity ?? "", o3])) };
      });
    }
    show(run) {
      this.#run = run;
    }
    at(t3) {
      const run = this.#run;
      if (!run) return;
      const { t: times2, x: x2, v: v2, a: a2 } = run.trajectory;
      const told4 = isTold(run);
      for (const { name, outputs } of this.cards) {
        const mass = run.header.bodies.find((body2) => body2.name === name)?.mass ?? 0;
        const force2 = told4 ? resultant(run, name, t3, this.zero) : null;
        const values = /* @__PURE__ */ new Map([
          ["x", valueAt(times2, x2[name] ?? [], v2[name] ?? [], t3) - this.camera * t3],
          ["v", (valueAt(times2, v2[name] ?? [], a2[name] ?? [], t3) - this.camera) / this.per],
          ["F", force2],
          ["a", force2 === null ? null : force2 / mass]
        ]);
        for (const [quantity, output] of outputs) {
          if (quantity === "mass") {
            say(output, short(mass));
            continue;
          }
          const value = values.get(quantity) ?? null;
          const decimals = this.decimals[quantity] ?? 3;
          say(output, value === null ? "–" : fixed(value, decimals));
        }
      }
    }
  };

  // ../view/deformation/squeezes.js
  function squeezes(carts, centres, faces) {
    const left2 = carts.map(() => 0);
    const right = carts.map(() => 0);
    const dents = { left: 0, right: 0 };
    for (let gap = 0; gap <= carts.length; gap += 1) {
      const [a2, b2] = [carts[gap - 1], carts[gap]];
      const end2 = a2 ? Number(centres[gap - 1]) + a2.half : faces.left;
      const start = b2 ? Number(centres[gap]) - b2.half : faces.right;
      if (end2 === null || start === null) continue;
      const overlap = Math.max(0, end2 - start);
      const share = Math.min(a2?.bumper ?? 0, b2 ? overlap / 2 : overlap);
      const rest = Math.min(b2?.bumper ?? 0, overlap - share);
      if (b2) left2[gap] = rest;
      if (a2) right[gap - 1] = Math.min(a2.bumper, overlap - rest);
      if (!a2) dents.left = overlap - rest;
      if (!b2) dents.right = overlap - share;
    }
    return { left: left2, right, dents };
  }

  // ../view/skins.js
  var NARROW = 24;
  var GAP3 = 5;
  var SADDLE = 6;
  var SKINS = {
    cart: { wheels: true, lift: 0, corner: 4, lines: () => "" },
    van: { wheels: true, lift: 0, corner: 7, lines: van },
    truck: { wheels: true, lift: 0, corner: 3, lines: truck },
    trailer: { wheels: true, lift: 0, corner: 1, lines: trailer },
    box: { wheels: false, lift: 0, corner: 1, lines: crate },
    puck: { wheels: false, lift: 0, corner: 12, lines: puck },
    glider: { wheels: false, lift: GAP3, corner: 4, lines: glider }
  };
  function van(box2, front) {
    return lines3(box2, front, [
      [
        [0.06, 0.9],
        [0.34, 0.9],
        [0.46, 0.68],
        [0.06, 0.68],
        [0.06, 0.9]
      ],
      [
        [-0.42, 0.9],
        [-0.08, 0.9],
        [-0.08, 0.68],
        [-0.42, 0.68],
        [-0.42, 0.9]
      ],
      [
        [0.4, 0.26],
        [0.5, 0.26]
      ]
    ]);
  }
  function truck(box2, front) {
    return lines3(box2, front, [
      [
        [0.22, 0],
        [0.22, 1]
      ],
      [
        [0.28, 0.9],
        [0.42, 0.9],
        [0.46, 0.66],
        [0.28, 0.66],
        [0.28, 0.9]
      ],
      [
        [-0.5, 0.16],
        [0.22, 0.16]
      ]
    ]);
  }
  function trailer(box2, front) {
    return lines3(box2, front, [
      [
        [-0.5, 0.2],
        [0.5, 0.2]
      ],
      ...[-0.4, -0.27, 0.27, 0.4].map(
        (x2) => [
          [x2, 0.2],
          [x2, 1]
        ]
      )
    ]);
  }
  function crate(box2, front) {
    return lines3(box2, front, [
      [
        [-0.4, 0.1],
        [0.4, 0.1],
        [0.4, 0.9],
        [-0.4, 0.9],
        [-0.4, 0.1]
      ],
      [
        [-0.4, 0.3],
        [-0.22, 0.1]
      ],
      [
        [0.4, 0.3],
        [0.22, 0.1]
      ],
      [
        [-0.4, 0.7],
        [-0.22, 0.9]
      ],
      [
        [0.4, 0.7],
        [0.22, 0.9]
      ]
    ]);
  }
  function puck(box2, front) {
    return lines3(box2, front, [
      [
        [-0.48, 0.15],
        [0.48, 0.15]
      ],
      [
        [-0.48, 0.85],
        [0.48, 0.85]
      ]
    ]);
  }
  function glider(box2, front) {
    const top = Math.min(SADDLE / box2.height, 0.4);
    return lines3(box2, front, [
      [
        [-0.5, top],
        [0.5, top]
      ],
      ...[-0.42, -0.28, 0.28, 0.42].map(
        (x2) => [
          [x2, 0],
          [x2, top]
        ]
      )
    ]);
  }
  function lines3({ width, height }, front, strokes) {
    if (width < NARROW) return "";
    const at3 = ([x2, y2]) => `${px(front * x2 * width)} ${px(-y2 * height)}`;
    return strokes.map((points) => `M${points.map(at3).join("L")}`).join("");
  }

  // src/predict/pull.js
  function pullable(stage, slider, full, width) {
    const group2 = svg("g", {});
    group2.addEventListener("pointerdown", (event) => {
      const down = event;
      if (slider.disabled) return;
      event.preventDefault();
      const start = slider.valueAsNumber || 0;
      const perPixel = width / stage.getBoundingClientRect().width * Number(slider.max) / full;
      followPointer(down, (pixels2) => {
        if (slider.disabled) return;
        const before = slider.value;
        slider.valueAsNumber = start + pixels2 * perPixel;
        if (slider.value !== before || slider.dataset.pulled === void 0) {
          slider.dataset.pulled = "";
          slider.dispatchEvent(new Event("input", { bubbles: true }));
        }
      });
    });
    return group2;
  }

  // ../view/effects-props.js
  function isSeen(effect, t3) {
    const { seen } = viewOf(effect.kind);
    return seen ? effect.active && seen(effect, t3) : actsAt(effect, t3);
  }
  function props(run, layout, t3, face2, centre) {
    const { header } = run;
    return header.effects.filter((effect) => isSeen(effect, t3)).flatMap((effect) => {
      const key = `${effect.kind} ${effect.index}`;
      return viewOf(effect.kind).pieces?.(effect, { key, header, run, t: t3, layout, face: face2, centre }) ?? [];
    });
  }

  // src/scene/effects.js
  var PER_CHARACTER = 8.4;
  var SLIVER = 1.5;
  var GAP4 = 8;
  var Effects = class {
    #run = null;
    #drawn = /* @__PURE__ */ new Map();
    constructor(root, layout, full, forces2) {
      this.layout = layout;
      this.full = full;
      this.forces = forces2;
      this.behind = need(root, '[data-part="effects-behind"]');
      this.front = need(root, '[data-part="effects-front"]');
      for (const group2 of [this.behind, this.front]) {
        for (const element of group2.querySelectorAll("[data-key]")) {
          this.#drawn.set(
            element.getAttribute("data-key") ?? "",
            element
          );
        }
      }
    }
    show(run) {
      this.#run = run;
    }
    at(t3, face2, centre) {
      const run = this.#run;
      if (!run?.header.effects.length) return;
      const pieces = props(run, this.layout, t3, face2, centre);
      if (this.forces && isTold(run)) pieces.push(...arrows(run, this.layout, this.full, t3, centre));
      const seen = new Set(pieces.map(({ key }) => key));
      for (const [key, element] of this.#drawn) {
        if (!seen.has(key)) {
          element.remove();
          this.#drawn.delete(key);
        }
      }
      for (const piece of pieces) this.#draw(piece);
    }
    #draw({ key, cls, behind, d: d2, text, x: x2, y: y2, anchor }) {
      let element = this.#drawn.get(key);
      if (!element) {
        element = svg(d2 === void 0 ? "text" : "path", { "data-key": key, class: cls });
        const group2 = behind ? this.behind : this.front;
        if (cls.startsWith("carts-leader")) group2.prepend(element);
        else group2.append(element);
        this.#drawn.set(key, element);
      }
      if (d2 !== void 0) return put(element, "d", d2);
      put(element, "x", x2 ?? "0");
      put(element, "y", y2 ?? "0");
      put(element, "text-anchor", anchor ?? "start");
      say(element, text ?? "");
    }
  };
  function arrows(run, layout, full, t3, centre) {
    const styles = new Map(run.header.bodies.map(({ name }, i2) => [name, `carts-${styleOf(i2)}`]));
    const named3 = run.header.bodies.length <= FEW2;
    const pieces = [];
    const lowest = /* @__PURE__ */ new Map();
    for (const force2 of forcesAt(run, t3)) {
      const key = `${force2.kind} ${force2.on}`;
      const x2 = centre(force2.on);
      const y2 = layout.slots[key] ?? layout.track;
      const exact = arrowLength(force2.value, full, layout.force);
      const length = Math.abs(exact) < SLIVER ? 0 : exact;
      const cut = isCut(force2.value, full);
      const style = styles.get(force2.on);
      lowest.set(force2.on, Math.max(y2, lowest.get(force2.on) ?? y2));
      const d2 = (cut ? cutArrow : blockArrow)(x2, y2, length);
      pieces.push({ key: `arrow ${key}`, cls: `carts-block-arrow carts-acts ${style}`, d: d2 });
      const row = `row ${force2.kind}`;
      if (named3) {
        const told4 = labels(force2).map((one) => one + (cut ? tr(", arrow cut") : ""));
        const text = told4.find((one) => fits(x2, length, one, layout.width)) ?? String(told4.at(-1));
        const [at3, anchor] = beside(x2, length, text.length * PER_CHARACTER, layout.width);
        const cls = `carts-acts-name ${style}`;
        pieces.push({ key: `name ${key}`, cls, text, x: px(at3), y: px(y2 + 5), anchor });
      } else if (!pieces.some((piece) => piece.key === row)) {
        const text = tr("by {by}", { by: force2.by });
        pieces.push({ key: row, cls: "carts-acts-row", text, x: "6", y: px(y2 + 5), anchor: "start" });
      }
    }
    const leaders = [...lowest].map(([name, y2]) => ({
      key: `leader ${name}`,
      cls: `carts-leader carts-acts ${styles.get(name)}`,
      d: `M${px(centre(name))} ${px(layout.track)}V${px(y2)}`
    }));
    return [...leaders, ...pieces];
  }
  function fits(x2, length, text, picture2) {
    const needed = text.length * PER_CHARACTER + GAP4 + 4;
    return Math.min(x2, x2 + length) >= needed || Math.max(x2, x2 + length) <= picture2 - needed;
  }
  function beside(x2, length, width, picture2) {
    const left2 = Math.min(x2, x2 + length) - GAP4;
    const right = Math.max(x2, x2 + length) + GAP4;
    const toLeft = left2 - width >= 4;
    const toRight = right + width <= picture2 - 4;
    if (toLeft && (length >= 0 || !toRight)) return [left2, "end"];
    if (toRight) return [right, "start"];
    return left2 > picture2 - right ? [4, "start"] : [picture2 - 4, "end"];
  }

  // src/scene/ground.js
  var TRACK2 = "track.length";
  var Ground = class {
    #lines = [];
    #numbers = [];
    constructor(root, layout, { fence, run: { header } }) {
      this.layout = layout;
      this.moves = header.track.right === "wall" && fence.controls.some((control) => control.set === TRACK2);
      if (!this.moves) return;
      const ground = need(root, '[data-part="ground"]');
      this.beam = need(ground, ".carts-beam");
      this.rule = need(ground, ".carts-rule");
      this.#numbers = [...ground.querySelectorAll(".carts-number")];
      this.#lines = Array.from(ground.querySelectorAll(".carts-fine"), (drawn2) => ({
        drawn: drawn2,
        pieces: (drawn2.getAttribute("d") ?? "").split(/(?=M)/).filter(Boolean).map((d2) => ({ x: Number.parseFloat(d2.slice(1)), d: d2 }))
      }));
    }
    show({ length }) {
      if (!this.beam || !this.rule) return;
      const end2 = this.layout.origin + Number(length) * this.layout.scale;
      const inside2 = (x2) => x2 <= end2 + 1;
      const start = Number(this.beam.getAttribute("x"));
      put(this.beam, "width", px(end2 - start));
      put(this.rule, "d", `M${px(start)} ${px(this.layout.track)}H${px(end2)}`);
      for (const { drawn: drawn2, pieces } of this.#lines) {
        const d2 = pieces.filter(({ x: x2 }) => inside2(x2)).map((piece) => piece.d);
        put(drawn2, "d", d2.join(""));
      }
      for (const number of this.#numbers) {
        const seen = inside2(Number(number.getAttribute("x")));
        put(number, "visibility", seen ? "visible" : "hidden");
      }
    }
  };

  // src/scene/pushes.js
  var PER_CHARACTER2 = 9.1;
  var ROW2 = 21;
  var GAP5 = 12;
  var EDGE3 = 6;
  var Pushes = class {
    #pushes = [];
    #run = null;
    #windows = [];
    constructor(root, layout, view) {
      this.root = root;
      this.layout = layout;
      this.view = view;
    }
    show(run, windows) {
      this.#run = run;
      this.#windows = windows;
      this.#pushes = [];
      run.header.contacts.forEach((contact, k) => {
        const groups = contact.bodies.map(
          (name) => this.root.querySelector(`.carts-push[data-pair="${contact.pair}"][data-on="${name}"]`)
        );
        if (groups[0] && groups[1]) {
          const row = this.layout.rows[k] ?? 0;
          this.#pushes.push({
            pair: contact.pair,
            bodies: contact.bodies,
            row,
            groups: [groups[0], groups[1]]
          });
        }
      });
    }
    at(t3, face2) {
      const run = this.#run;
      if (!run) return;
      const { layout, view } = this;
      const told4 = [];
      for (const push of this.#pushes) {
        const forces2 = forcesOn(run, push, t3).map(
          (force2) => Math.abs(force2) < NOISE * view.force ? 0 : force2
          // springs pull: below 0
        );
        const sizes = forces2.map(Math.abs);
        const size = Math.max(...sizes);
        const y2 = layout.track - PUSH;
        const [left2, right] = push.bodies;
        const ends = [face2(left2, "right"), face2(right, "left")];
        push.groups.forEach((group2, side) => {
          const way = side === 0 ? -1 : 1;
          const draw = isCut(Number(sizes[side]), view.force) ? cutArrow : blockArrow;
          const length = arrowLength(Number(forces2[side]), view.force, layout.force);
          put(need(group2, '[data-part="arrow"]'), "d", draw(Number(ends[side]), y2, way * length));
        });
        const touching = this.#windows.some(
          ({ pair, loose, near, start, end: end2, lasts }) => pair === push.pair && !(loose || near) && t3 >= start && (t3 <= end2 || Boolean(lasts && size > 0))
          // carts that never part go on pushing
        );
        const link = touching ? "" : linkOf(run.header, push.pair);
        if (touching || link && size > 0) {
          told4.push({ push, sizes, x: (Number(ends[0]) + Number(ends[1])) / 2, link });
        }
      }
      this.#names(told4);
    }
    #names(told4) {
      const [only] = told4;
      for (const { pair, groups } of this.#pushes) {
        const on = told4.some(({ push }) => push.pair === pair);
        for (const group2 of groups) {
          put(need(group2, '[data-part="text"]'), "visibility", on ? "visible" : "hidden");
        }
      }
      if (told4.length === 1 && only && this.#inFull(only)) return;
      const taken = [];
      const [low, high] = this.#between();
      for (const { push, sizes, x: x2 } of told4) {
        const size = Math.max(...sizes);
        const [text, other] = push.groups.map((group2) => need(group2, '[data-part="text"]'));
        if (!text || !other) continue;
        const label = tr("{size} on each", { size: this.#value(size) });
        const half = label.length * PER_CHARACTER2 / 2;
        const at3 = Math.min(Math.max(x2, low + half), high - half);
        const free = [...new Set(this.layout.rows)].find(
          (y2) => taken.every(([row, from, to]) => row !== y2 || at3 + half < from || at3 - half > to)
        );
        put(other, "visibility", "hidden");
        if (free === void 0) put(text, "visibility", "hidden");
        else {
          taken.push([free, at3 - half, at3 + half]);
          write3(text, label, at3, free, "middle");
        }
      }
    }
    #inFull(told4) {
      return this.#named(told4, told4.link && ` (${told4.link})`) || this.#named(told4, "");
    }
    #named({ push, sizes, x: x2 }, through) {
      const [first, second] = push.groups.map((group2) => need(group2, '[data-part="text"]'));
      const { track } = this.#run.header;
      const labels2 = push.bodies.map((on, side) => {
        const by = push.bodies[1 - side] ?? "";
        return `${onBy(on, by, track)}${through}: ${this.#value(Number(sizes[side]))}`;
      });
      const [left2, right] = labels2.map((label) => label.length * PER_CHARACTER2);
      if (!first || !second || !left2 || !right) return false;
      const [low, high] = this.#between();
      if (high - low >= left2 + right + 2 * GAP5 && !push.bodies.some(isWall)) {
        const begin = Math.min(Math.max(x2 + GAP5, low + left2 + 2 * GAP5), high - right);
        const end2 = Math.max(low + left2, Math.min(x2 - GAP5, begin - 2 * GAP5));
        write3(first, labels2[0] ?? "", end2, push.row, "end");
        write3(second, labels2[1] ?? "", begin, push.row, "start");
        return true;
      }
      const longest = Math.max(left2, right);
      const taken = new Set(Object.values(this.layout.slots)).size;
      if (this.layout.beam < (2 + taken) * ROW2 || high - low < longest) return false;
      const top = Math.min(...this.layout.rows);
      const way = push.bodies[0] === "left" ? 0 : push.bodies[1] === "right" ? 1 : 0.5;
      const start = Math.min(Math.max(x2 - way * longest, low), high - longest);
      write3(first, labels2[0] ?? "", start, top, "start");
      write3(second, labels2[1] ?? "", start, top + ROW2, "start");
      return true;
    }
    #between() {
      const { origin, scale, width } = this.layout;
      const track = this.#run?.header.track;
      const end2 = origin + (track?.length ?? 0) * scale;
      return [
        track?.left === "wall" ? Math.max(EDGE3, origin + GAP5) : EDGE3,
        track?.right === "wall" ? Math.min(width - EDGE3, end2 - GAP5) : width - EDGE3
      ];
    }
    #value(size) {
      const cut = isCut(size, this.view.force) ? tr(", arrow cut") : "";
      return `${fixed(size, this.view.decimals.F ?? 2)} N${cut}`;
    }
  };
  function forcesOn({ trajectory }, { pair, bodies }, t3) {
    const { t: times2, F: F2, dF, on } = trajectory;
    const [left2, right] = bodies.map((name) => on?.[`${pair} ${name}`]);
    if (left2 && right) return [valueAt(times2, left2, null, t3), valueAt(times2, right, null, t3)];
    const [column, slopes] = [F2[pair], dF[pair]];
    const force2 = column && slopes ? valueAt(times2, column, slopes, t3) : 0;
    return [force2, force2];
  }
  function write3(text, label, x2, y2, anchor) {
    put(text, "x", px(x2));
    put(text, "y", px(y2));
    put(text, "text-anchor", anchor);
    say(text, label);
  }

  // src/scene/walls.js
  var THING = '[data-part="thing"]';
  var Walls = class {
    #walls = [];
    constructor(root, layout, { run: { header }, view }) {
      this.layout = layout;
      this.tallest = view.tallest;
      this.was = need(root, ".carts-was");
      this.#walls = Array.from(root.querySelectorAll("[data-wall]"), (group2) => {
        const side = group2.getAttribute("data-wall") === "left" ? "left" : "right";
        const wall = wallAt(side, header.track.length, layout, view.tallest);
        return { side, what: "wall", wall, group: group2 };
      });
    }
    show(track) {
      for (const one of this.#walls) {
        one.what = whatIs(one.side, track);
        one.wall = wallAt(one.side, track.length, this.layout, this.tallest);
        const drawn2 = one.group.querySelector(THING);
        if (one.what === "wall") drawn2?.remove();
        else if (!drawn2) one.group.append(svg("path", { "data-part": "thing" }));
      }
    }
    faces(shift) {
      const at3 = (side) => {
        const found3 = this.#walls.find((one) => one.side === side);
        return found3 ? found3.wall.edge - shift : null;
      };
      return { left: at3("left"), right: at3("right") };
    }
    at(pressed2, shift) {
      const lines4 = this.#walls.map((one) => this.#draw(one, pressed2[one.side]));
      put(this.was, "d", lines4.join(""));
      put(this.was, "transform", `translate(${px(-shift)} 0)`);
    }
    #draw({ what, wall, group: group2 }, { dent, height }) {
      const { body: body2, hatch, face: face2, was, lines: lines4 } = what === "wall" ? { ...wallPaths(wall, this.layout, dent, height), hatch: null, lines: "" } : thingPaths(what, wall, this.layout, dent, height);
      put(need(group2, ".carts-wall"), "d", body2);
      put(need(group2, "[fill]"), "d", hatch ?? body2);
      put(need(group2, ".carts-wall-face"), "d", face2);
      if (lines4) {
        const thing = need(group2, THING);
        put(thing, "class", what === "spring" ? "carts-coil" : "carts-fine");
        put(thing, "d", lines4);
      }
      return was;
    }
  };

  // src/scene/stage.js
  var HANDLE = 9;
  var Stage = class {
    #run;
    #carts = [];
    #walls;
    #ground;
    #pushes;
    #effects;
    constructor(root, baked) {
      const layout = baked.view.layouts.find((one) => one.kind === root.dataset.kind);
      if (!layout) throw new Error(`no layout for ${root.dataset.kind}`);
      this.root = root;
      this.torn = false;
      this.layout = layout;
      this.view = baked.view;
      this.camera = baked.fence.camera;
      this.skins = baked.fence.skins;
      this.starts = baked.run.header.bodies.map(({ velocity: velocity3 }) => velocity3);
      this.#run = baked.run;
      this.#walls = new Walls(root, layout, baked);
      this.#ground = new Ground(root, layout, baked);
      this.#pushes = new Pushes(root, layout, baked.view);
      this.#effects = new Effects(root, layout, baked.view.force, baked.fence.forces === "shown");
    }
    show(run, windows) {
      this.#run = run;
      const { layout, view } = this;
      const boxes = run.header.bodies.map(
        (body2, i2) => box(body2, view, layout, i2, this.skins[body2.name])
      );
      this.torn = boxes.some((box2) => box2.cut);
      const tallest = Math.max(...boxes.map((box2) => box2.height));
      this.#carts = run.header.bodies.map((body2, i2) => {
        const group2 = need(this.root, `.carts-cart[data-body="${body2.name}"]`);
        const box2 = boxes[i2];
        drawBox(group2, body2.name, box2);
        const skin = SKINS[this.skins[body2.name] ?? ""];
        const front = Number(this.starts[i2]) < 0 ? -1 : 1;
        const lift = skin?.lift ?? 0;
        if (skin) put(need(group2, '[data-part="skin"]'), "d", skin.lines(box2, front));
        return {
          half: body2.length * layout.scale / 2,
          edge: -box2.x,
          bumper: Math.max(0, body2.length * layout.scale / 2 + box2.x),
          height: box2.height + lift,
          lift,
          top: layout.track - lift + labelTop(box2),
          lane: lane(i2, tallest, layout),
          group: group2,
          mass: this.#mass(body2.name, box2, lift),
          velocity: need(this.root, `.carts-velocity[data-body="${body2.name}"]`)
        };
      });
      this.#walls.show(run.header.track);
      this.#ground.show(run.header.track);
      this.#pushes.show(run, windows);
      this.#effects.show(run);
    }
    at(t3) {
      const { header, trajectory } = this.#run;
      const shift = this.camera * t3;
      put(
        need(this.root, '[data-part="ground"]'),
        "transform",
        `translate(${px(-shift * this.layout.scale)} 0)`
      );
      const centres = header.bodies.map((body2) => {
        const x2 = valueAt(
          trajectory.t,
          trajectory.x[body2.name] ?? [],
          trajectory.v[body2.name] ?? [],
          t3
        );
        return this.layout.origin + (x2 - shift) * this.layout.scale;
      });
      const walls = this.#walls.faces(shift * this.layout.scale);
      const { left: left2, right, dents } = squeezes(this.#carts, centres, walls);
      this.#walls.at(
        {
          left: { dent: dents.left, height: this.#carts[0]?.height ?? 0 },
          right: { dent: dents.right, height: this.#carts.at(-1)?.height ?? 0 }
        },
        shift * this.layout.scale
      );
      this.#carts.forEach((cart, i2) => {
        const centre = Number(centres[i2]);
        const faces = [
          -cart.half + Number(left2[i2]),
          cart.half - Number(right[i2])
        ];
        const foot = this.layout.track - cart.lift;
        put(cart.group, "transform", `translate(${px(centre)} ${px(foot)})`);
        put(cart.mass, "x", px(centre));
        put(need(cart.group, '[data-part="spring-left"]'), "d", spring(-cart.edge, faces[0]));
        put(need(cart.group, '[data-part="spring-right"]'), "d", spring(cart.edge, faces[1]));
        put(need(cart.group, '[data-part="face-left"]'), "transform", `translate(${px(faces[0])} 0)`);
        put(
          need(cart.group, '[data-part="face-right"]'),
          "transform",
          `translate(${px(faces[1])} 0)`
        );
        this.#velocity(cart, header.bodies[i2]?.name ?? "", centre, t3);
      });
      const face2 = (name, side) => {
        const i2 = header.bodies.findIndex((body2) => body2.name === name);
        if (i2 < 0) {
          const wall = name === "left" ? 0 : header.track.length ?? 0;
          const dent = name === "left" ? -dents.left : dents.right;
          return this.layout.origin + (wall - shift) * this.layout.scale + dent;
        }
        const half = this.#carts[i2]?.half ?? 0;
        const centre = Number(centres[i2]);
        return side === "left" ? centre - half + Number(left2[i2]) : centre + half - Number(right[i2]);
      };
      this.#pushes.at(t3, face2);
      this.#effects.at(
        t3,
        face2,
        (name) => Number(centres[header.bodies.findIndex((body2) => body2.name === name)])
      );
    }
    guess(guesses) {
      const { header } = this.#run;
      const group2 = need(this.root, '[data-part="guess"]');
      const full = this.view.force || 10;
      const parts2 = guesses.flatMap(({ pair, on, side, size, slider }) => {
        const i2 = header.bodies.findIndex((body3) => body3.name === on);
        const body2 = header.bodies[i2];
        const half = (body2?.length ?? 0) / 2;
        const wall = on === "left" ? 0 : header.track.length ?? 0;
        const x2 = body2 ? body2.position + (side === "left" ? half : -half) : wall;
        const way = side === "left" ? -1 : 1;
        const length = way * arrowLength(size ?? 0, full, this.layout.force);
        const from = this.layout.origin + x2 * this.layout.scale;
        const y2 = this.layout.track - PUSH;
        const draw = isCut(size ?? 0, full) ? cutArrow : blockArrow;
        const style = `carts-${i2 < 0 ? "wall" : styleOf(i2)}`;
        const arrow2 = svg("path", {
          class: `carts-guessed ${style}`,
          d: draw(from, y2, length),
          "data-pair": pair,
          "data-on": on
        });
        const tip = from + length + way * HANDLE;
        const handle = pullable(this.root, slider, way * this.layout.force, this.layout.width);
        handle.setAttribute("class", `carts-pull ${style}`);
        handle.append(
          svg("circle", { cx: px(tip), cy: px(y2), r: 16, class: "carts-pull-room" }),
          svg("circle", { cx: px(tip), cy: px(y2), r: 8 }),
          svg("path", {
            d: `M${px(tip - 2.5)} ${px(y2 - 2.5)}l-2.5 2.5l2.5 2.5M${px(tip + 2.5)} ${px(y2 - 2.5)}l2.5 2.5l-2.5 2.5`
          })
        );
        return size === null ? [handle] : [arrow2, handle];
      });
      group2.replaceChildren(...parts2);
    }
    #mass(name, box2, lift) {
      const mass = need(this.root, `.carts-mass[data-body="${name}"]`);
      put(mass, "y", px(this.layout.track - lift + box2.labelY));
      say(mass, box2.label);
      return mass;
    }
    #velocity(cart, name, x2, t3) {
      const { trajectory } = this.#run;
      const { layout, view } = this;
      const v2 = valueAt(trajectory.t, trajectory.v[name] ?? [], trajectory.a[name] ?? [], t3) - this.camera;
      const seen = Math.abs(v2) < NOISE * view.velocity ? 0 : v2;
      const exact = arrowLength(seen, view.velocity, layout.velocity, FASTEST);
      const length = keptInside(x2, exact, layout.width);
      const [at3, anchor] = velocityText(x2, length, layout.width);
      put(need(cart.velocity, '[data-part="arrow"]'), "d", lineArrow(x2, cart.lane, length));
      put(
        need(cart.velocity, '[data-part="leader"]'),
        "d",
        `M${px(x2)} ${px(cart.lane)}V${px(cart.top)}`
      );
      const shortened = length !== exact || isCut(seen, view.velocity, FASTEST);
      const cut = shortened ? tr(", arrow cut") : "";
      const [per, unit] = speedUnit(view.velocity);
      const speed = `${fixed(seen / per, view.decimals.v ?? 2)} ${unit}${cut}`;
      const text = need(cart.velocity, '[data-part="text"]');
      const outside3 = x2 < 0 || x2 > layout.width;
      put(text, "x", px(outside3 ? x2 < 0 ? 8 : layout.width - 8 : at3));
      put(text, "y", px(cart.lane + 5));
      put(text, "text-anchor", outside3 ? x2 < 0 ? "start" : "end" : anchor);
      say(text, outside3 ? tr("{name} is outside: {speed}", { name, speed }) : speed);
    }
  };
  function drawBox(group2, name, box2) {
    const rect = need(group2, '[data-part="box"]');
    put(rect, "x", px(box2.x));
    put(rect, "y", px(-box2.height));
    put(rect, "width", px(box2.width));
    put(rect, "height", px(box2.height));
    const wheels2 = group2.querySelector('[data-part="wheels"]');
    if (wheels2) put(wheels2, "d", wheels(box2));
    const cut = need(group2, '[data-part="break"]');
    put(cut, "visibility", box2.cut ? "visible" : "hidden");
    const title = need(group2, '[data-part="name"]');
    put(title, "y", px(box2.nameY ?? 0));
    put(title, "visibility", box2.nameY === null ? "hidden" : "visible");
    say(title, name);
  }

  // ../view/exits.js
  var HALVINGS = 40;
  function exits({ header, trajectory }, { low, high }, camera) {
    const { t: times2, x: places, v: v2, a: a2 } = trajectory;
    const found3 = [];
    for (const { name, length } of header.bodies) {
      const half = length / 2;
      const place4 = (t3) => valueAt(times2, places[name] ?? [], v2[name] ?? [], t3) - camera * t3;
      const isOut = (t3) => Math.max(place4(t3) - half - high, low - place4(t3) - half) > 0;
      const row = Array.prototype.findIndex.call(times2, isOut);
      if (row < 1) continue;
      let before = Number(times2[row - 1]);
      let after = Number(times2[row]);
      for (let k = 0; k < HALVINGS; k += 1) {
        const middle = (before + after) / 2;
        if (isOut(middle)) after = middle;
        else before = middle;
      }
      const velocity3 = valueAt(times2, v2[name] ?? [], a2[name] ?? [], after) - camera;
      found3.push({ t: after, name, side: place4(after) > high ? "right" : "left", velocity: velocity3 });
    }
    return found3;
  }

  // ../view/model-words.js
  var BOTH_FORCES = tr(
    "Each contact has one force in the program: it acts on both bodies, equally hard, in opposite directions. So the program assumes Newton’s third law; it cannot prove it."
  );
  function modelSentences(header, numbers) {
    const acting = header.effects.filter(({ active }) => active);
    const sentences = acting.map((effect) => ended(capital(phrase(effect, header, numbers))));
    if (!acting.length) {
      sentences.push(
        tr("Where nothing touches, nothing pushes along the track: every cart keeps its velocity.")
      );
    }
    sentences.push(...contactSentences(header));
    if (header.contacts.some(({ stiffness }) => stiffness)) sentences.push(BOTH_FORCES);
    const leftOut = header.notSimulated.map((kind2) => viewOf(kind2).name);
    if (leftOut.length) {
      sentences.push(tr("Left out of this model: {effects}.", { effects: listed(leftOut) }));
    }
    return sentences;
  }
  function contactSentences(header) {
    const laws = lawsOf(header);
    const alike = /* @__PURE__ */ new Map();
    for (const contact of header.contacts) {
      if (laws[contact.pair] === APART2) continue;
      const key = `${contact.restitution === null} ${contact.stiffness === null}`;
      alike.set(key, [...alike.get(key) ?? [], contact]);
    }
    return [...alike.values()].map((contacts) => {
      const [one] = contacts;
      const names = contacts.map(({ bodies }) => bodiesOf(bodies, header.track)).join("; ");
      const how = one?.stiffness ? tr("bumpers push like springs, the harder the more they are squeezed") : one?.restitution === null ? tr("whoever touches stays together") : tr("a hit takes no time");
      return ended(alike.size > 1 ? `${names}: ${how}` : capital(how));
    });
  }

  // src/scene/story.js
  var MOST_EVENTS2 = 60;
  var IN_FULL = 10;
  var Story = class {
    told = [];
    #seen = Infinity;
    // s, as far as the run was watched
    #listed = -1;
    // sentences that stand there
    #last = false;
    // whether the model stands there
    constructor(root, baked, seek) {
      const { fence, view } = baked;
      this.root = root;
      this.view = view;
      this.header = null;
      this.layout = view.layouts[0];
      this.telling = {
        decimals: view.decimals,
        scale: view.velocity,
        camera: fence.camera,
        forces: fence.forces === "shown"
      };
      this.list = need(root, ".carts-events");
      this.model = need(root, ".carts-model ul");
      this.list.addEventListener("click", (event) => {
        const button = event.target.closest("button");
        if (button?.dataset.time) seek(Number(button.dataset.time));
      });
    }
    show(run) {
      const { header } = run;
      const decimals = this.view.decimals.v ?? 2;
      const laws = lawsOf(header);
      const bare = bareOf(header);
      this.told = [
        ...isTold(run) ? marks(header, this.telling.forces) : [],
        ...header.events.map((event) => ({
          t: event.t,
          sentence: eventSentence(event, this.telling, laws, bare, header.track)
        })),
        ...exits(run, this.layout, this.telling.camera).map((exit) => ({
          t: exit.t,
          sentence: exitSentence(exit, decimals, this.view.velocity)
        }))
      ].sort((a2, b2) => a2.t - b2.t);
      this.header = header;
      this.#listed = -1;
      this.grow(this.#seen);
    }
    grow(seen) {
      this.#seen = seen;
      const seenOnes = this.told.filter(({ t: t3 }) => t3 <= seen);
      const whole = seen === Infinity;
      if (!this.header || seenOnes.length === this.#listed && whole === this.#last) return;
      [this.#listed, this.#last] = [seenOnes.length, whole];
      const items = seenOnes.slice(0, MOST_EVENTS2).map((one) => this.#item(one));
      const more = seenOnes.length - items.length;
      if (more > 0)
        items.push(
          html(
            "li",
            "carts-more-events",
            counted("… and 1 more event.", "… and {n} more events.", more)
          )
        );
      this.list.replaceChildren(...items);
      const scrolled = items.length > IN_FULL;
      put(this.list, "class", scrolled ? "carts-events carts-events-scrolled" : "carts-events");
      if (scrolled) put(this.list, "tabindex", "0");
      else this.list.removeAttribute("tabindex");
      const open2 = whole && this.header.plan.length > 0;
      const hides = this.root.querySelector(".carts-find") !== null;
      const model = open2 && !hides ? modelSentences(this.header, this.telling.forces) : [];
      this.model.replaceChildren(...model.map((text) => html("li", "", text)));
      need(this.root, ".carts-model").hidden = !whole || hides;
    }
    #item({ t: t3, sentence }) {
      const item = html("li");
      const button = html("button", "", `${fixed(t3, this.view.decimals.t ?? 3)} s`);
      button.setAttribute("type", "button");
      button.className = "carts-jump";
      button.dataset.time = String(t3);
      item.append(button, " ", html("span", "", sentence));
      return item;
    }
    between(before, now) {
      const after = before || -1;
      return this.told.filter(({ t: t3 }) => t3 > after && t3 <= now).map(({ sentence }) => sentence);
    }
  };

  // src/scene/time/timeline.js
  var MOST_EVENTS3 = 60;
  var BAND = { class: "carts-contact-band", y: 0, height: 18 };
  var Timeline = class {
    #until = 0;
    // s, as far as the axis goes
    #seen = Infinity;
    // s, as far as the run was watched
    #touches = [];
    #events = [];
    constructor(root, seek) {
      this.scrub = need(root, ".carts-scrub");
      this.bands = need(root, '.carts-ticks [data-part="contacts"]');
      this.marks = need(root, '.carts-ticks [data-part="events"]');
      this.numbers = need(root, '.carts-ticks [data-part="numbers"]');
      this.scrub.addEventListener("input", () => seek(this.scrub.valueAsNumber));
    }
    show(run, windows) {
      const { header } = run;
      const pushes3 = isTold(run) ? marks(header, false) : [];
      this.#touches = windows;
      this.#events = [
        ...header.events.slice(0, MOST_EVENTS3).filter((event) => event.kind !== "end"),
        ...pushes3.map(({ t: t3 }) => ({ t: t3, kind: "push" }))
      ];
      if (this.#until !== header.until) this.#renumber(header.until);
      this.#mark();
    }
    grow(seen) {
      this.#seen = seen;
      if (this.#until) this.#mark();
    }
    #mark() {
      const at3 = (t3) => `${px(100 * t3 / this.#until, 3)}%`;
      const touches2 = this.#touches.filter(({ start }) => start <= this.#seen);
      const events = this.#events.filter(({ t: t3 }) => t3 <= this.#seen);
      fit(this.bands, touches2.length, () => svg("rect", BAND));
      touches2.forEach(({ start, end: end2 }, k) => {
        const band3 = this.bands.children[k];
        put(band3, "x", at3(start));
        put(band3, "width", at3(Math.min(end2, this.#seen) - start));
      });
      fit(this.marks, events.length, () => svg("line", { y1: 1, y2: 17 }));
      events.forEach(({ t: t3, kind: kind2 }, k) => {
        const mark2 = this.marks.children[k];
        put(mark2, "class", `carts-event carts-event-${kind2}`);
        put(mark2, "x1", at3(t3));
        put(mark2, "x2", at3(t3));
      });
    }
    at(t3, spoken) {
      this.scrub.valueAsNumber = t3;
      put(this.scrub, "aria-valuetext", spoken);
    }
    #renumber(until) {
      this.#until = until;
      put(this.scrub, "max", String(until));
      const axis2 = span(0, until, 6);
      const times2 = ticks2(axis2);
      this.numbers.replaceChildren(
        ...times2.flatMap((t3, i2) => {
          const x2 = `${px(100 * t3 / until, 3)}%`;
          const text = svg("text", { class: "carts-number", x: x2, y: 32 });
          text.textContent = fixed(t3, axisDecimals(axis2)) + (i2 === times2.length - 1 ? " s" : "");
          return [svg("line", { class: "carts-fine", x1: x2, x2, y1: 14, y2: 20 }), text];
        })
      );
    }
  };

  // src/scene/drawing.js
  var Drawing = class {
    run;
    windows = [];
    #seen = Infinity;
    constructor(root, baked, seek = () => {
    }) {
      this.root = root;
      this.baked = baked;
      this.run = baked.run;
      const stages = root.querySelectorAll(".carts-stage");
      this.stages = [...stages].map((stage) => new Stage(stage, baked));
      const graphs = root.querySelectorAll(".carts-graph");
      this.graphs = [...graphs].map((graph2) => new GraphView(graph2, baked, seek));
      this.views = new Views(root, baked);
      this.readouts = new Readouts(root, baked);
      this.timeline = new Timeline(root, seek);
      this.story = new Story(root, baked, seek);
      this.torn = root.querySelectorAll(".carts-torn");
      this.acting = root.querySelector(".carts-acting");
      this.warnings = need(root, ".carts-warnings");
      this.zoom = need(root, ".carts-window");
    }
    show(run, t3) {
      this.run = run;
      this.windows = windowsOf(run);
      this.#words();
      this.stand();
      for (const graph2 of this.graphs) graph2.show(run, t3);
      this.views.show(run, this.windows, t3);
      this.readouts.show(run);
      this.timeline.show(run, this.windows);
      this.story.show(run);
      this.#offerWindows();
    }
    grow(seen) {
      if (seen === this.#seen) return;
      this.#seen = seen;
      for (const graph2 of this.graphs) graph2.grow(seen);
      this.timeline.grow(seen);
      this.story.grow(seen);
      this.#offerWindows();
    }
    at(t3) {
      for (const stage of this.stages) stage.at(t3);
      for (const graph2 of this.graphs) graph2.at(t3);
      this.views.at(t3);
      this.readouts.at(t3);
      this.timeline.at(t3, tr("{time} seconds", { time: fixed(t3, 2) }));
    }
    stand() {
      for (const stage of this.stages) stage.show(this.run, this.windows);
      const torn2 = this.stages.some((stage) => stage.torn);
      for (const sign of this.torn) {
        if (torn2) sign.removeAttribute("hidden");
        put(sign, "data-now", torn2 ? "yes" : "no");
      }
    }
    #words() {
      const { header } = this.run;
      const numbers = isTold(this.run) && this.baked.fence.forces === "shown";
      if (this.acting) say(this.acting, actingSentences(header, numbers));
      this.warnings.hidden = header.warnings.length === 0;
      this.warnings.replaceChildren(
        ...header.warnings.map(({ message }) => html("p", "", told(message)))
      );
    }
    #offerWindows() {
      const begun2 = this.windows.filter(({ start }) => start <= this.#seen);
      const texts = begun2.map(({ bodies, start }) => {
        const names = dashed(bodies, this.run.header.track);
        return tr("{names} at {time} s", { names, time: fixed(start, 2) });
      });
      const whole = need(this.zoom, "option");
      const there = [...this.zoom.options].slice(1);
      if (there.map(({ text }) => text).join("\n") === texts.join("\n")) return;
      const chosen = this.zoom.selectedIndex;
      const options = texts.map((text, i2) => {
        const option2 = html("option", "", text);
        option2.setAttribute("value", String(i2));
        return option2;
      });
      this.zoom.replaceChildren(whole, ...options);
      this.zoom.selectedIndex = chosen <= options.length ? chosen : 0;
    }
  };

  // ../view/skeleton/graph.js
  var WITH_SIGN = html2` <button type="button" class="carts-sign" aria-pressed="false" disabled title=${tr("Show the direction: + means to the right")}>${tr("with sign")}</button>`;
  var LEDGER = html2` <button type="button" class="carts-sign carts-stack" aria-pressed="false" disabled title=${tr("Kinetic energy, squeezed bumpers and warmth on top of each other")}>${tr("as a ledger")}</button>`;
  var TOGGLES = { F: WITH_SIGN, energy: LEDGER };
  function graph({ fence, view, run }, quantity) {
    const [title, symbol, unit] = QUANTITIES[quantity] ?? ["", "", ""];
    const isForce = quantity === "F";
    const name = isForce ? sizeName(run.header) : title;
    const camera = fence.camera && ["x", "v"].includes(quantity) ? tr("seen from the camera, ") : "";
    const measured = quantity === "v" ? speedUnit(view.velocity)[1] : unit;
    const label = tr("{quantity} against time", { quantity: name });
    const table = tr("Table: {quantity}", { quantity: lower(name) });
    return html2`<div class="carts-graph" data-quantity=${quantity} role="group" aria-label=${label}>
<p class="carts-graph-title"><span class="carts-graph-name">${name} ${camera}<i>${isForce ? "|F|" : symbol}</i>${tr(" in {unit}", { unit: measured })}</span>${TOGGLES[quantity]}</p>
${plot(`${fence.id}-${quantity}-clip`, isForce, fence.watch === "first")}
<p class="carts-key"></p>
${isForce && html2`<p class="carts-area-note carts-quiet">\u00a0</p>`}
<details class="carts-more"><summary>${table}</summary>
<div class="carts-scroll"><table class="carts-table"><thead><tr><th scope="col">${tr("t in s")}</th></tr></thead><tbody></tbody></table></div></details>
</div>`;
  }
  function plot(clip, isForce, growing) {
    const inside2 = html2`clip-path="url(#${clip})"`;
    const shade = html2`<path class="carts-impulse" d=""/>`;
    const room = html2`<rect x=${LEFT5} y=${TOP6 - 4} width=${RIGHT4 - LEFT5 + 1} height=${BOTTOM5 - TOP6 + 8}/>`;
    const seen = `${clip}-seen`;
    return html2`<svg class="carts-plot" viewBox="0 0 ${WIDTH6} ${HEIGHT3}" width=${WIDTH6} height=${HEIGHT3} aria-hidden="true">
<defs><clipPath id=${clip}>${room}</clipPath>${growing && html2`<clipPath id=${seen} class="carts-seen">${room}</clipPath>`}</defs>
<g data-part="times"></g>
<g data-part="values"></g>
<text class="carts-unit" x=${RIGHT4} y=${HEIGHT3 - 3} text-anchor="end">${tr("time t in s")}</text>
<g data-part="areas" clip-path="url(#${growing ? seen : clip})">${isForce && [shade, shade]}</g>
<g data-part="curves" ${inside2}></g>
<g data-part="cursor" ${inside2}><path class="carts-cursor" d="M0 ${TOP6}V${BOTTOM5}" transform="translate(${LEFT5} 0)"/></g>
</svg>`;
  }

  // src/scene/graphs/choose.js
  var AREAS = tr("boxes as large as the masses");
  var STILLS = tr("in stills, without motion");
  var STOPS = tr("stops at touch, greatest force and parting");
  var SOUND = tr("a click at each contact, as loud as its force");
  var FORCES = ["F", "R", "a"];
  var Choose = class {
    constructor(root, baked, views, now, acts) {
      const place4 = need(root, ".carts-choices");
      const { show, forces: forces2, slow: slow2 } = baked.fence;
      const graphs = Object.keys(QUANTITIES).filter((quantity) => forces2 === "shown" || !FORCES.includes(quantity)).map((quantity) => ({
        key: quantity,
        label: `${lower(QUANTITIES[quantity]?.[0] ?? "")} ${QUANTITIES[quantity]?.[1]}`,
        seen: show.includes(quantity)
      }));
      const lasting = baked.run.header.contacts.some(({ stiffness }) => stiffness);
      const areas = { key: "areas", label: AREAS, seen: !baked.view.alike };
      const still2 = { key: "stills", label: STILLS, seen: now.stills };
      const sound = { key: "sound", label: SOUND, seen: now.sound };
      const stops = { key: "stops", label: STOPS, seen: slow2 === "stops" };
      place4.replaceChildren(
        group(tr("Graphs"), graphs, acts.graph),
        group(tr("Views"), views, acts.view),
        group(tr("Picture"), [areas], (_2, on) => acts.areas(on)),
        group(
          tr("Playing"),
          [
            ...lasting && slow2 !== "never" ? [stops] : [],
            still2,
            ...baked.run.header.contacts.length ? [sound] : []
          ],
          acts.playing
        )
      );
    }
  };
  function group(title, choices, act) {
    const set = document.createElement("fieldset");
    set.append(html("legend", "", title));
    for (const { key, label, seen } of choices) {
      const line3 = html("label");
      const box2 = document.createElement("input");
      box2.type = "checkbox";
      box2.checked = seen;
      box2.dataset.choice = key;
      box2.addEventListener("change", () => act(key, box2.checked));
      line3.append(box2, ` ${label}`);
      set.append(line3);
    }
    set.hidden = choices.length === 0;
    return set;
  }
  function emptyGraph(baked, quantity) {
    return parsed(graph(baked, quantity).text);
  }

  // src/scene/time/sound.js
  var KEY2 = "carts-sound";
  var LASTS = 0.08;
  var FADES = 60;
  var SOFTEST = 0.05;
  var wanted = recall(KEY2) === true;
  var made3 = null;
  var Sound = class {
    get on() {
      return wanted;
    }
    set(on) {
      wanted = on;
      retain(KEY2, on);
      for (const box2 of document.querySelectorAll('[data-choice="sound"]')) {
        box2.checked = on;
      }
      if (on) this.#click(SOFTEST);
    }
    between(events, before, now) {
      if (!this.on) return;
      const after = before || -1;
      const loudest = Math.max(...events.map(strength));
      for (const event of events) {
        const part = strength(event) / loudest;
        if (event.t > after && event.t <= now && part > 0) this.#click(Math.max(part, SOFTEST));
      }
    }
    #click(loud) {
      try {
        made3 ??= new AudioContext();
        const machine = made3;
        void machine.resume();
        const noise = machine.createBuffer(1, machine.sampleRate * LASTS, machine.sampleRate);
        const samples = noise.getChannelData(0);
        samples.forEach((_2, k) => {
          const t3 = k / machine.sampleRate;
          samples[k] = loud * Math.exp(-FADES * t3) * (2 * Math.random() - 1);
        });
        const source = machine.createBufferSource();
        source.buffer = noise;
        source.connect(machine.destination);
        source.start();
      } catch {
        this.set(false);
      }
    }
  };
  function strength({ kind: kind2, force: force2, impulse }) {
    if (kind2 === "peak") return force2 ?? 0;
    return kind2 === "contact" || kind2 === "release" ? impulse ?? 0 : 0;
  }

  // src/scene/time/transport.js
  var Transport = class {
    constructor(root, player, decimals) {
      this.player = player;
      this.decimals = decimals;
      this.bar = need(root, ".carts-transport");
      this.world = need(root, ".carts-world");
      this.play = need(root, ".carts-play");
      this.playText = need(this.play, "span");
      this.clock = need(root, ".carts-clock");
      this.ownClock = root.querySelector(".carts-own-clock");
      this.rate = root.querySelector(".carts-rate");
      this.scrub = need(root, ".carts-scrub");
      const click = (selector, act) => need(root, selector).addEventListener("click", act);
      click(".carts-start", () => {
        player.pause();
        player.seek(0);
      });
      click(".carts-back", () => player.step(-1));
      click(".carts-play", () => player.toggle());
      click(".carts-forward", () => player.step(1));
      const speed = need(root, ".carts-speed");
      player.speed = Number(speed.value);
      speed.addEventListener("change", () => {
        player.speed = Number(speed.value);
        player.changed(player.time, false);
      });
      const slow2 = root.querySelector(".carts-slow");
      player.slow = slow2?.checked ?? false;
      slow2?.addEventListener("change", () => {
        player.slow = slow2.checked;
        player.changed(player.time, false);
      });
      this.world.addEventListener("keydown", (event) => {
        if (event.target === this.world) this.#key(event);
      });
      this.scrub.addEventListener("keydown", (event) => this.#key(event));
      this.scrub.addEventListener("pointerdown", () => player.pause());
    }
    show() {
      const { player } = this;
      say(this.clock, fixed(player.time, player.isSlow ? 4 : this.decimals.t ?? 3));
      say(this.playText, this.#name());
      this.bar.classList.toggle("carts-is-playing", player.playing);
      this.bar.classList.toggle("carts-is-slow", player.isSlow);
      this.world.classList.toggle("carts-is-slow", player.isSlow);
      if (this.rate) say(this.rate, rateText(player.rate));
      if (this.ownClock) say(this.ownClock, fixed(player.own, 1));
    }
    #name() {
      if (this.player.playing) return tr("Pause");
      return this.player.time >= this.player.until ? tr("Again") : tr("Play");
    }
    #key(event) {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const act = {
        " ": () => event.repeat || this.player.toggle(),
        ArrowLeft: () => this.player.step(-1),
        ArrowDown: () => this.player.step(-1),
        ArrowRight: () => this.player.step(1),
        ArrowUp: () => this.player.step(1),
        PageDown: () => this.player.step(-1, 10),
        PageUp: () => this.player.step(1, 10),
        Home: () => this.player.seek(0),
        End: () => this.player.seek(this.player.until)
      }[event.key];
      if (!act || this.scrub.disabled) return;
      event.preventDefault();
      act();
    }
  };

  // src/scene/scene-view.js
  var HALTS = /* @__PURE__ */ new Set(["contact", "peak", "separate", "stick", "release"]);
  var SceneView = class {
    behind = null;
    #drawn = () => {
    };
    constructor(root, baked) {
      this.root = root;
      this.baked = baked;
      this.player = new Player((before, forward) => this.#moved(before, forward));
      this.player.halting = baked.fence.slow === "stops";
      this.seek = (t3) => {
        this.player.pause();
        this.player.seek(t3);
      };
      this.drawing = new Drawing(root, baked, this.seek);
      this.ghosts = this.drawing.stages.map((stage) => new Ghost(stage));
      this.sound = new Sound();
      this.#offerChoices();
      this.transport = new Transport(root, this.player, baked.view.decimals);
      this.announcer = new Announcer(root);
      this.described = new Described(root, baked);
      this.player.stepped = (before) => this.#stepped(before);
      this.drawing.zoom.addEventListener("change", () => this.#zoom());
      for (const summary of root.querySelectorAll(".carts-model > summary, .carts-how > summary")) {
        summary.addEventListener(
          "click",
          () => summary.parentElement?.setAttribute("data-reader", "")
        );
      }
      need(root, ".carts-frame").addEventListener("carts-redraw", () => {
        for (const graph2 of this.drawing.graphs) graph2.show(this.run, this.player.time);
      });
    }
    get run() {
      return this.drawing.run;
    }
    get stages() {
      return this.drawing.stages;
    }
    get now() {
      const quantities = this.drawing.graphs.map((graph2) => graph2.quantity);
      const { time: t3, seen } = this.player;
      return { run: this.run, t: t3, quantities, seen };
    }
    show(run, behind = null) {
      const { header } = run;
      this.behind = behind;
      for (const ghost of this.ghosts) ghost.show(behind);
      for (const graph2 of this.drawing.graphs) graph2.behind = behind;
      if (this.player.seen < Infinity) this.player.seen = this.player.time;
      this.drawing.grow(this.player.seen);
      this.drawing.show(run, this.player.time);
      this.player.until = header.until;
      this.player.parts = slowParts(this.drawing.windows);
      const pushes3 = isTold(run) ? marks(header, false) : [];
      this.player.stops = [...header.events, ...pushes3].map(({ t: t3 }) => t3).sort((a2, b2) => a2 - b2);
      this.player.halts = header.events.filter(({ kind: kind2 }) => HALTS.has(kind2)).map(({ t: t3 }) => t3);
      this.#zoom();
      this.player.seek(this.player.time);
    }
    redraw(drawn2) {
      this.#drawn = drawn2;
      for (const graph2 of this.drawing.graphs) {
        graph2.drawn = drawn2;
        graph2.show(this.run, this.player.time);
      }
    }
    draggable(acts) {
      for (const stage of this.stages) new Drag(stage.root, stage.layout, this.baked, acts);
    }
    enable(on) {
      const parts2 = ".carts-reset, .carts-preset, .carts-transport button, .carts-transport select, .carts-transport input, .carts-scrub, .carts-window";
      for (const part of this.root.querySelectorAll(parts2)) {
        part.disabled = !on;
      }
      if (on) for (const graph2 of this.drawing.graphs) graph2.enable();
    }
    print(open2) {
      for (const { table } of this.drawing.graphs) {
        const { details } = table;
        if (open2 && !details.open) details.dataset.printed = "";
        if (open2 || "printed" in details.dataset) details.open = open2;
        if (!open2) delete details.dataset.printed;
        table.fill();
      }
    }
    #moved(before, forward) {
      const t3 = this.player.time;
      this.drawing.grow(this.player.seen);
      this.drawing.at(t3);
      for (const ghost of this.ghosts) ghost.at(t3);
      this.transport.show();
      this.described.at(this.run, t3, this.player.playing);
      if (!forward || t3 === before) return;
      this.announcer.tell(this.drawing.story.between(before, t3));
      this.sound.between(this.run.header.events, before, t3);
    }
    #stepped(before) {
      const t3 = this.player.time;
      const events = t3 > before ? this.drawing.story.between(before, t3) : [];
      if (t3 !== before) this.announcer.tell([...events, this.described.words(this.run, t3)]);
    }
    #offerChoices() {
      const { views } = this.drawing;
      const now = { stills: this.player.stills, sound: this.sound.on };
      new Choose(this.root, this.baked, views.choices, now, {
        graph: (quantity, seen) => this.#chooseGraph(quantity, seen),
        view: (key, seen) => views.choose(key, seen),
        areas: (on) => {
          this.baked.view.alike = !on;
          this.drawing.stand();
          this.player.seek(this.player.time);
        },
        playing: (key, on) => {
          if (key === "sound") this.sound.set(on);
          else this.player[key === "stills" ? "stills" : "halting"] = on;
        }
      });
    }
    #chooseGraph(quantity, seen) {
      const place4 = need(this.root, ".carts-graphs");
      const { graphs } = this.drawing;
      const there = graphs.find((graph3) => graph3.quantity === quantity);
      if (!seen && there) {
        this.drawing.graphs = graphs.filter((graph3) => graph3 !== there);
        there.root.remove();
      }
      if (!seen || there) return;
      const graph2 = new GraphView(emptyGraph(this.baked, quantity), this.baked, this.seek);
      place4.insertBefore(graph2.root, need(place4, ".carts-story"));
      graphs.push(graph2);
      graph2.enable();
      graph2.behind = this.behind;
      graph2.drawn = this.#drawn;
      graph2.grow(this.player.seen);
      graph2.show(this.run, this.player.time);
      this.#zoom();
    }
    #zoom() {
      const { zoom, windows, graphs } = this.drawing;
      const touch = zoom.value ? windows[Number(zoom.value)] : void 0;
      const room = touch ? 0.3 * (touch.end - touch.start) : 0;
      const window = touch ? [Math.max(0, touch.start - room), Math.min(this.run.header.until, touch.end + room)] : null;
      for (const graph2 of graphs) graph2.zoom(window, this.player.time);
    }
  };

  // src/scene/element.js
  function sceneElement(client2, folder) {
    return class CartsScene extends HTMLElement {
      #view = null;
      #baked = null;
      #predict = null;
      #lesson = null;
      #runs = new Runs(this, client2, {
        scene: () => this.#baked?.fence.scene,
        draw: (run) => this.#draw(run),
        say: (message) => note(this, message),
        long: (on) => passing(this, LONG_RUN, on)
      });
      #inside = null;
      #watch = null;
      asBaked = "";
      // the inside of the element as the generator wrote it, for “Start again”
      #live = new Live(this, client2, {
        first: () => this.#first(),
        told: () => this.#told,
        link: () => void followLink(this, this.#runs, (text) => noteBeside(this, text)),
        failed: () => this.#inside?.controls.enable(this.#runs.stepwise && this.#free),
        stepwise: () => this.#runs.stepwise
      });
      #leaving = new AbortController();
      // ends what the element hears of page and worker
      #restored = Promise.resolve();
      // when the reader's earlier prediction is back
      connectedCallback() {
        this.#listen();
        if (this.#view) return;
        if (this.querySelector(".carts-predict")) this.asBaked = this.innerHTML;
        this.#adopt();
        this.#live.still();
      }
      disconnectedCallback() {
        this.#leaving.abort();
      }
      #listen() {
        this.#leaving = new AbortController();
        const { signal } = this.#leaving;
        this.#live.listen(signal);
        this.#runs.answerOthers(signal);
        addEventListener("beforeprint", () => this.#view?.print(true), { signal });
        addEventListener("afterprint", () => this.#view?.print(false), { signal });
      }
      #adopt() {
        const baked = readBaked(this);
        const view = new SceneView(this, baked);
        this.#baked = baked;
        this.#view = view;
        this.#runs.prepared ??= new Prepared(this, baked.fence, folder);
        const inside2 = wireInside(this, baked, view, client2, {
          reset: () => this.#reset(),
          undo: () => this.#runs.undo(),
          preset: (changes2, name) => this.#watch?.preset(name, () => this.#runs.preset(changes2)),
          found: (said) => void this.#showForces(said),
          settings: () => this.#values.good,
          stops: (target) => this.#runs.stops(target),
          told: () => this.#free,
          change: (target, value, at3) => void this.set({ [target]: value }, at3).catch((error) => this.#complain(target, error))
        });
        this.#inside = inside2;
        this.#predict = askFirst(this, baked, view, {
          locked: (now) => void this.#reveal(now),
          forgotten: (now) => void this.#startAgain(now)
        });
        this.#watch = new Watch(this, baked, view.player, inside2.presets, {
          first: () => this.#told && inside2.controls.enable(this.#runs.able),
          all: () => this.#watched()
        });
        if (!this.#predict) this.#lesson = baked.run;
        if (this.#lesson) inside2.find?.show(baked.run);
        void inside2.follow(baked.run);
        if (this.#watch.over) view.show(baked.run);
        view.enable(!this.#predict);
        inside2.controls.enable(!this.#predict);
        this.#restored = this.#predict?.restore() ?? Promise.resolve();
        this.#live.follow();
      }
      async #startAgain(lead) {
        this.#reset();
        this.#values.forget();
        this.#lesson = null;
        forgetWatched(this);
        forgetForces(this.id);
        this.innerHTML = this.asBaked;
        this.classList.add("carts-asks");
        this.#adopt();
        await this.#restored;
        if (lead) need(this, ".carts-predict :is(input, textarea):enabled").focus();
      }
      async #showForces(said) {
        const [t3, values] = [this.time, { ...this.#values.good }];
        this.#view?.player.pause();
        showForces(this, said);
        this.#adopt();
        await this.#restored;
        if (!this.#told) return;
        if (Object.keys(values).length) await this.set({}).catch(() => {
        });
        this.time = t3;
      }
      get ready() {
        return this.#live.ready;
      }
      get trajectory() {
        return this.#told && this.#view?.run.trajectory || null;
      }
      get plan() {
        return this.#told ? planOf(this.#view?.run) : [];
      }
      get time() {
        return this.#view?.player.time ?? 0;
      }
      set time(t3) {
        if (!this.#told) return;
        this.#view?.player.pause();
        this.#view?.player.show(Number(t3));
      }
      async set(changes2, at3 = performance.now()) {
        if (!this.#told) throw new Error(ASK_FIRST);
        this.#values.ask(changes2);
        await this.#runs.compute(changes2, at3);
      }
      get #values() {
        return this.#runs.values;
      }
      get #told() {
        return !this.#predict || this.#lesson !== null;
      }
      get #free() {
        return this.#told && (!this.#predict || Boolean(this.#watch?.over));
      }
      #draw(run) {
        const shown3 = this.#inside?.follow(run);
        this.#inside?.show(this.#values, run.header);
        this.#inside?.find?.show(run);
        offerUndo(this, this.#told && this.#values.canUndo);
        return shown3;
      }
      #reset() {
        this.#runs.reset();
        this.#inside?.how.reset();
        this.#view?.player.pause();
        if (this.#lesson) this.#draw(this.#lesson);
        this.#watch?.back();
      }
      async #first() {
        const run = await this.#runs.ask();
        if (run && this.#told && !this.#view?.player.playing) this.#draw(run);
      }
      async reveal() {
        if (!this.#told) await this.#reveal(false, false);
      }
      async conceal() {
        if (this.#told && this.#predict && !this.#predict.isLocked) await this.#startAgain(false);
      }
      async #reveal(now, own = true) {
        this.#predict?.complain("");
        try {
          const run = await this.#runs.ask();
          if (!run) return;
          this.#lesson = run;
          this.classList.remove("carts-asks");
          need(this, ".carts-results").hidden = false;
          this.#draw(run);
          this.#view?.enable(true);
          if (now) this.#view?.announcer.leadTo(need(this, ".carts-play"), "");
          if (this.#predict?.watched) this.#watch?.finish(true);
          else if (!this.#watch?.first) this.#watched();
          else if (now || !own) this.#view?.player.play();
        } catch (error) {
          const { message } = error;
          this.#predict?.complain(`${message} ${PREDICTION_KEPT}`);
        }
      }
      #watched() {
        if (!this.#predict || !this.#lesson) return;
        this.#inside?.controls.enable(this.#runs.able);
        if (!this.#predict.isLocked) return;
        this.#predict.compare(this.#lesson);
        this.#view?.announcer.tell([this.#predict.spoken]);
      }
      #complain(target, error) {
        this.#inside?.controls.complain(target, error.message);
        this.dispatchEvent(new CustomEvent("carts-error", { bubbles: true, detail: error }));
      }
    };
  }

  // src/main.js
  function packages() {
    const scenes = [...document.querySelectorAll("carts-scene")];
    const names = scenes.flatMap((scene) => (scene.getAttribute("data-packages") ?? "").split(" "));
    return [...new Set(names.filter(Boolean))];
  }
  var client = pagePython(packages);
  customElements.define("carts-scene", sceneElement(client, besideScript("prepared/")));
  customElements.define("carts-map", mapElement(client));
  customElements.define("carts-cost", costElement(client));
  customElements.define("carts-hard", hardElement(client));
  if (document.querySelector("carts-scene")) startWhenIdle(client);
  document.documentElement.dataset.cartsScenes = "";
})();
