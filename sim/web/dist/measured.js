"use strict";
(() => {
  // ../view/language.js
  var catalogue = globalThis.cartsWords ?? {};
  var FORMS = "\0";
  var RULE = catalogue["\0"] ?? "";
  function tr(sentence, values = {}) {
    return filled(catalogue[sentence] ?? sentence, values);
  }
  function form(one, more, n) {
    const ours = catalogue[more]?.split(FORMS);
    if (!ours) return n === 1 ? one : more;
    const english = n === 1 ? 0 : 1;
    const asked = RULE ? Number(RULE[n < RULE.length ? n : 100 + n % 100]) : english;
    return String(ours[Math.min(asked, ours.length - 1)]);
  }
  function told(sentence) {
    if (typeof sentence === "string") return catalogue[sentence] ?? sentence;
    const values = Object.entries(sentence.values).map(([name, value]) => [name, told(value)]);
    const { code, one } = sentence;
    const n = Number(String(sentence.values.n).replace(/,/g, ""));
    const template = one ? form(one, code, n) : catalogue[code] ?? code;
    return filled(template, Object.fromEntries(values));
  }
  function inRow(parts) {
    const [head = "", ...tail] = parts;
    return tail.reduce((first, second) => tr("{first}, {second}", { first, second }), head);
  }
  function ended(sentence) {
    return tr("{sentence}.", { sentence });
  }
  function filled(template, values) {
    return template.replace(/\{(\w+)\}/g, (whole, name) => String(values[name] ?? whole));
  }

  // ../view/bodies.js
  function listed(names) {
    const [first = "", second] = names;
    if (second === void 0) return first;
    const rest = inRow(names.slice(0, -1));
    return tr("{first} and {last}", { first: rest, last: String(names.at(-1)) });
  }

  // ../view/measured/units.js
  var CHOOSE = {
    time: () => tr("what times are in"),
    length: () => tr("what lengths are in"),
    force: () => tr("what forces are in")
  };
  var QUANTITY = {
    time: ["t", "s"],
    length: ["x", "m"],
    force: ["F", "N"],
    acceleration: ["a", "m/s²"]
  };
  var open = ({ assumed, chosen }) => assumed.filter((kind) => !chosen?.[kind]);
  function missing(read) {
    const left = open(read).map((kind) => CHOOSE[kind]());
    if (!left.length) return "";
    return tr("This file does not say its units. Choose {what}.", { what: listed(left) });
  }
  var howRead = ({ assumed, chosen, read }) => [
    ...assumed.flatMap(
      (kind) => chosen?.[kind] ? tr("{letter} in {unit} (as chosen)", { letter: QUANTITY[kind][0], unit: chosen[kind] }) : []
    ),
    ...read.map(told)
  ];
  function heads(read) {
    const left = open(read);
    const named = (kind, cart = "") => {
      const [letter, unit] = QUANTITY[kind];
      const what = cart ? tr("{letter} of {cart}", { letter, cart }) : letter;
      return left.some((one) => one === kind) ? what : tr("{letter} in {unit}", { letter: what, unit });
    };
    return {
      time: named("time"),
      value: named(read.kind),
      tracks: read.names.map((name) => named(read.kind, name))
    };
  }
  function semicolons([first = "", ...rest]) {
    return rest.reduce((before, then) => tr("{first}; {then}", { first: before, then }), first);
  }

  // src/shared/dom.js
  var SVG = "http://www.w3.org/2000/svg";
  function svg(tag, attributes = {}) {
    const made = document.createElementNS(SVG, tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
    return made;
  }
  function html(tag, className = "", text2 = "") {
    const made = document.createElement(tag);
    if (className) made.className = className;
    if (text2) made.textContent = text2;
    return made;
  }
  function put(element, name, value) {
    if (element.getAttribute(name) !== value) element.setAttribute(name, value);
  }
  var TEXT = 3;
  function say(element, text2) {
    const only = element.firstChild;
    if (only?.nodeType === TEXT && !only.nextSibling) {
      if (only.nodeValue !== text2) only.nodeValue = text2;
    } else if (element.textContent !== text2) element.textContent = text2;
  }
  function need(root, selector) {
    const found = root.querySelector(selector);
    if (!found) throw new Error(`this page lacks ${selector}; it was built by another version`);
    return found;
  }

  // src/measured/asking.js
  var Asking = class {
    #owners = { read: {}, model: {}, ready: {}, segments: {}, fit: {}, tracker: {} };
    #generation = 0;
    constructor(client, common, answered2) {
      this.client = client;
      this.common = common;
      this.answered = answered2;
    }
    async ask(what, more = {}) {
      const { header } = await this.client.ask(this.#owners[what] ?? {}, () => ({
        kind: "measured",
        do: what,
        ...this.common(),
        ...more
      }));
      this.answered();
      return header;
    }
    async newest(what, more) {
      this.#generation += 1;
      const generation = this.#generation;
      const found = await this.ask(what, more);
      return generation === this.#generation ? found : null;
    }
  };

  // src/shared/spreadsheet.js
  var CELL = /("(?:[^"]|"")*"|[^,\r\n"]*)(,|\r?\n|$)/g;
  var NUMBER = /^-?\d+(?:\.\d+)?(?:e[+-]?\d+)?$/i;
  function forSpreadsheet(csv, language = navigator.language) {
    if (!hasComma(language)) return csv;
    return csv.replace(CELL, (_, cell, end) => written(cell) + (end === "," ? ";" : end));
  }
  function written(cell) {
    if (NUMBER.test(cell)) return cell.replace(".", ",");
    return cell.includes(";") && !cell.startsWith('"') ? `"${cell}"` : cell;
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
  function download(name, text2, type) {
    const saved = type === "text/csv" ? forSpreadsheet(text2) : text2;
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

  // src/shared/printing.js
  function printWith(undo) {
    const over = new AbortController();
    const { signal } = over;
    const end = () => {
      over.abort();
      undo();
    };
    for (const kind of ["afterprint", "pointerdown", "keydown"])
      addEventListener(kind, end, { signal });
    window.print();
  }

  // src/measured/buttons.js
  function wireButtons(bench, { own, save, fit, compare, tracker, early }) {
    const on = (name, act) => bench.querySelector(`.carts-measured-${name}`)?.addEventListener("click", act);
    on("own", own);
    on("save", save);
    on("fit", fit);
    on("compare", compare);
    on("scene", () => download("real-carts.yml", told(bench.report?.scene ?? ""), "text/yaml"));
    on("tracker", async () => {
      const { text: text2 } = await tracker();
      if (text2) download("model-run.txt", text2, "text/plain;charset=utf-8");
    });
    on("print", () => {
      bench.dataset.printing = "";
      printWith(() => delete bench.dataset.printing);
    });
    const model2 = need(bench, ".carts-measured-model");
    for (const kind of ["pointerdown", "focusin"])
      model2.addEventListener(kind, early, { once: true });
  }

  // src/measured/early.js
  var PACKAGES = ["numpy", "scipy"];
  function whenLive(bench, client, signal) {
    const live = () => {
      if (client.state === "ready") bench.dataset.state = "live";
    };
    client.addEventListener("state", live, { signal });
    live();
  }
  async function happened(client, asking) {
    try {
      await client.need(PACKAGES);
      return await asking.ask("segments");
    } catch {
      return null;
    }
  }

  // src/question/marking/notation.js
  var RAISED = { "⁻": "-", "⁺": "+" };
  for (const [digit, raised] of [..."⁰¹²³⁴⁵⁶⁷⁸⁹"].entries()) RAISED[raised] = String(digit);
  var POWER_OF_TEN = /\s*[×xX*·]\s*10(?:([⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]{1,3})|\s*(?:\^|\*\*)\s*(\(?[+-]?\d{1,3}\)?))/;
  var plain = (text2) => text2.replace(/[−‐‑–]/g, "-").replace(/μ/g, "µ");
  var lowered = (text2) => [...text2].map((sign) => RAISED[sign] ?? sign).join("");
  function withExponent(text2) {
    return plain(text2).replace(POWER_OF_TEN, (_, raised, power) => {
      return `e${lowered(raised ?? power).replace(/[()]/g, "")}`;
    });
  }

  // src/shared/typed.js
  var LONGEST = 40;
  var GROUPED = /^[+-]?[1-9]\d{0,2}(,\d{3})+(?![\d,])(\.\d*)?/;
  function readTyped(typed) {
    const text2 = withExponent(tidy(typed));
    if (!text2) return { problem: tr("Type a number, for example 0.5") };
    if (text2.length > LONGEST) return { problem: tr("That is too long for a number.") };
    const grouped = twoReadings(text2);
    if (grouped) return { problem: grouped };
    if (/^[+-]?(\d+([.,]\d*)?|[.,]\d+)(e[+-]?\d+)?$/i.test(text2)) {
      const value = Number(text2.replace(",", "."));
      return Number.isFinite(value) ? { value } : { problem: tr("{text} is too large.", { text: text2 }) };
    }
    if (/^[+-]?[\d.,]+(e[+-]?\d+)?\s*[a-zA-Zµ°%][a-zA-Zµ°%⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺^/·⋅*(). \d-]*$/.test(text2)) {
      return { text: text2.replace(/(\d),(\d)/, "$1.$2") };
    }
    return { problem: noNumber(text2) };
  }
  var noNumber = (text2) => tr("“{text}” is not a number. Type for example 0.5", { text: text2 });
  function outside({ label, unit }, low, high) {
    const range = tr("{low} to {high}", { low, high });
    return tr("{label}: {range}, please.", { label, range: `${range} ${unit}`.trim() });
  }
  var APART = /^([+\-−–]?[1-9]\d{0,2})((?:[ \u00a0\u2009\u202f]\d{3})+)(?!\d)/;
  function tidy(typed) {
    const narrow = (sign) => String.fromCharCode(sign.charCodeAt(0) - 65248);
    return typed.trim().replace(/[０-９．，＋－]/g, narrow).replace(/^([+\-−–])\s+(?=[\d.,])/, "$1").replace(APART, (whole) => whole.replace(/\s/g, ""));
  }
  function twoReadings(typed) {
    const text2 = GROUPED.exec(typed)?.[0];
    if (!text2) return "";
    const whole = text2.replaceAll(",", "");
    if (/[,.].*[,.]/.test(text2)) return tr("Type {number} without commas.", { number: whole });
    const decimal = String(Number(text2.replace(",", ".")));
    return tr("{text} can mean {decimal} or {whole}: type {decimal} or {whole}", {
      text: text2,
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
  var ifTyped = (box) => box.value.trim() ? problemIn(box) : "";
  function unlessPositive(box, problem2) {
    return Number(numberIn(box) ?? 1) <= 0 ? tr("A number above 0, please.") : problem2;
  }
  function complainUnlessPositive(box, problem2) {
    complain(box, unlessPositive(box, problem2));
  }
  function complain(box, problem2) {
    const place2 = box.closest("label, [data-hand]") ?? box.parentElement;
    const told4 = place2.querySelector(".carts-error") ?? html("span", "carts-error");
    if (!problem2) return told4.remove();
    told4.setAttribute("role", "alert");
    place2.append(told4);
    say(told4, problem2);
  }

  // src/measured/hands.js
  var FASTER = 1.5;
  var RATIO = [0.1, 10];
  var LIMITS = { e: [0, 1], ratio: [1e-3, 1e3] };
  var LONGEST2 = 0.4;
  var Hands = class {
    constructor(root, changed) {
      this.rows = /* @__PURE__ */ new Map();
      for (const place2 of root.querySelectorAll(".carts-measured-hand")) {
        const slide = need(place2, "input[type=range]");
        const box = need(place2, "input[type=text]");
        const key = place2.dataset.hand ?? "";
        const row = { key, slide, box, label: need(place2, "label") };
        this.rows.set(key, row);
        slide.addEventListener("input", () => {
          put2(row, slide.valueAsNumber);
          changed();
        });
        box.addEventListener("change", () => {
          complain(box, problem(row));
          if (!box.value.trim()) put2(row, slide.valueAsNumber);
          const value = taken(row);
          if (value === null) return;
          slide.value = String(value);
          changed();
        });
      }
    }
    reach(tracks, names) {
      const times = tracks.flatMap((track) => track.t);
      const [begin, end] = [Math.min(...times), Math.max(...times)];
      const speeds = tracks.map((track) => fastest(track));
      const most = FASTER * Math.max(...speeds, 1e-3);
      const [a = "A", b = "B"] = names;
      this.#set("touch", begin, end);
      this.#set("va", -most, most, tr("velocity of {cart} before", { cart: a }));
      this.#set("vb", -most, most, tr("velocity of {cart} before", { cart: b }));
      this.#set(
        "ratio",
        Number(RATIO[0]),
        Number(RATIO[1]),
        tr("mass of {b} ÷ mass of {a}", { a, b })
      );
      this.#set("e", 0, 1);
      this.#set("duration", 1e-3, Math.min(LONGEST2, (end - begin) / 2));
    }
    #set(key, low, high, label = "") {
      const row = this.rows.get(key);
      if (!row) return;
      for (const input of [row.slide, row.box]) input.disabled = false;
      const step = 10 ** Math.floor(Math.log10((high - low) / 400));
      Object.assign(row.slide, { min: low, max: high, step });
      if (label) {
        row.slide.setAttribute("aria-label", label);
        row.label.textContent = label;
      }
    }
    set value(hand) {
      const values = { ...hand, va: hand.v[0], vb: hand.v[1] };
      for (const [key, row] of this.rows) {
        const value = Number(values[key]);
        row.slide.value = String(value);
        put2(row, value);
      }
    }
    get value() {
      const read = (key) => {
        const row = this.rows.get(key);
        return row ? taken(row) ?? row.slide.valueAsNumber : 0;
      };
      return {
        touch: read("touch"),
        x: 0,
        distance: 0,
        v: [read("va"), read("vb")],
        ratio: read("ratio"),
        e: read("e"),
        duration: read("duration")
      };
    }
  };
  function problem({ key, box, label }) {
    if (key === "duration") return unlessPositive(box, ifTyped(box));
    const [low, high] = LIMITS[key] ?? [-Infinity, Infinity];
    const value = numberIn(box);
    if (value === null || value >= low && value <= high) return ifTyped(box);
    return outside({ label: label.textContent ?? "", unit: "" }, String(low), String(high));
  }
  var taken = (row) => problem(row) ? null : numberIn(row.box);
  function put2({ box, slide }, value) {
    const finest = (Number(slide.step) || 1e-3) / 100;
    const figures = Number(value.toPrecision(4));
    const decimals = Math.max(0, Math.round(-Math.log10(finest)));
    box.value = String(Number(figures.toFixed(decimals))).replace(/^-/, "−");
    complain(box, "");
  }
  function fastest({ t, value }) {
    const apart = Math.max(1, Math.floor(t.length / 5));
    let found = 0;
    for (let k = apart; k < t.length; k += 1) {
      const speed = (Number(value[k]) - Number(value[k - apart])) / (Number(t[k]) - Number(t[k - apart]));
      found = Math.max(found, Math.abs(speed));
    }
    return found;
  }

  // src/store/kept-line.js
  var KeptLine = class {
    #puts = 0;
    constructor(owner) {
      this.owner = owner;
      this.root = html("p", "carts-unsaved");
      this.root.setAttribute("role", "status");
    }
    async hear(put3) {
      this.#puts += 1;
      const turn = this.#puts;
      const kept = Boolean(await put3);
      if (turn !== this.#puts) return;
      say(this.root, kept ? "" : tr("Not saved"));
      this.owner.toggleAttribute("data-kept", kept);
    }
  };

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
    if (opened2 && sameAnswer(old, value)) return { ...together(old, value), locked: old.locked };
    const same = old.hash === value.hash && old.type === value.type;
    if (old.locked && !value.locked && same) {
      return withEarlier(old, old.earlier, value.earlier, alone(value));
    }
    const other = opened2 || old.hash && value.hash && old.hash !== value.hash;
    return withEarlier(value, old.earlier, value.earlier, other ? alone(old) : []);
  }
  function merged(a, b) {
    if (!a) return b;
    if (!b) return a;
    const [old, young] = String(a.last ?? "") <= String(b.last ?? "") ? [a, b] : [b, a];
    const first = [a.first, b.first].filter(Boolean).sort()[0] ?? null;
    if (sameAnswer(old, young)) return { ...together(old, young), first };
    const cleared = isEmpty(young.value) && !isEmpty(old.value);
    const [loser, winner] = cleared ? [young, old] : [old, young];
    return withEarlier({ ...winner, first }, old.earlier, young.earlier, alone(loser));
  }
  function together(old, young) {
    const said = Object.entries(young).filter(([, part]) => (part ?? "") !== "");
    const both2 = { ...young, ...old, ...Object.fromEntries(said) };
    return withEarlier(both2, old.earlier, young.earlier);
  }
  function sameAnswer(a, b) {
    return a.hash === b.hash && JSON.stringify(a.value) === JSON.stringify(b.value);
  }
  function alone({ earlier: _, ...entry }) {
    return isEmpty(entry.value) ? [] : [entry];
  }
  function withEarlier(entry, ...lists) {
    const found = /* @__PURE__ */ new Map();
    for (const one of lists.flatMap((list) => list ?? [])) {
      const name = JSON.stringify([one.hash, one.value]);
      const before = found.get(name);
      found.set(name, before ? together(before, one) : one);
    }
    const all = [...found.values()];
    all.sort((x, y) => String(x.last ?? "").localeCompare(String(y.last ?? "")));
    return all.length ? { ...entry, earlier: all.slice(-MOST_EARLIER) } : entry;
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
  var PATIENCE = 5e3;
  var marked = (site) => `carts-database:${site}`;
  async function takeTexts(store, site) {
    void remember(store, site);
    const texts = keptAsText(site);
    const found = await texts.entries().catch(() => []);
    if (found.length === 0) return;
    const take = () => takeOver(store, texts).catch(() => {
    });
    const taken2 = Promise.resolve(navigator.locks?.request(`carts-texts:${site}`, take) ?? take());
    const late = new Promise((resolve) => setTimeout(resolve, PATIENCE));
    await Promise.race([taken2.catch(take), late]);
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
    for (const [key, text2] of await texts.entries()) {
      if (text2 === null) continue;
      const value = both(await store.get(key), text2);
      if (value === null) continue;
      await store.put(key, value);
      await texts.remove(key);
    }
  }
  function both(kept, text2) {
    if (kept === void 0 || kept === null) return text2;
    if ("type" in Object(kept) && "type" in Object(text2)) return merged(kept, text2);
    if (!("last" in Object(kept) && "last" in Object(text2))) return null;
    return String(kept.last) > String(text2.last) ? kept : text2;
  }

  // src/store/newest-first.js
  var GONE = /* @__PURE__ */ Symbol("forgotten");
  function newestFirst(put3) {
    const flights = /* @__PURE__ */ new Map();
    function start(key, value, alone2) {
      const now = put3(key, value, alone2);
      flights.set(key, { now, next: null });
      const over = () => {
        if (flights.get(key)?.now === now && !flights.get(key)?.next) flights.delete(key);
      };
      now.then(over, over);
      return now;
    }
    return (key, value, alone2 = false) => {
      const flight = flights.get(key);
      if (!flight) return start(key, value, alone2);
      if (flight.next) {
        flight.next.value = value;
        flight.next.alone &&= alone2;
        flight.next.anew ||= value === GONE;
        return flight.next.written;
      }
      const next = { value, alone: alone2, anew: value === GONE, written: Promise.resolve() };
      const begin = () => start(key, next.value, next.alone || next.anew);
      next.written = flight.now.then(begin, begin);
      flight.next = next;
      return next.written;
    };
  }

  // src/store/indexed-store.js
  var SETTLED = "settled";
  var STORE = "answers";
  var PATIENCE2 = 2e4;
  var SETTLE_AFTER = 400;
  function open2(name) {
    return new Promise((resolve, reject) => {
      const request = indexedDB.open(name, 1);
      request.onupgradeneeded = () => request.result.createObjectStore(STORE);
      request.onsuccess = () => {
        request.result.onversionchange = () => request.result.close();
        resolve(request.result);
      };
      request.onerror = () => reject(request.error);
      request.onblocked = () => reject(new Error("another page holds an older version"));
      setTimeout(() => reject(new Error("no answer")), PATIENCE2);
    });
  }
  async function reopening(name) {
    let base = await open2(name);
    return async (mode, durability = "relaxed") => {
      try {
        return base.transaction(STORE, mode, { durability });
      } catch {
        base = await open2(name);
        return base.transaction(STORE, mode, { durability });
      }
    };
  }
  async function indexed(name) {
    const begin = await reopening(name);
    const read = async (ask) => answered(ask((await begin("readonly")).objectStore(STORE)));
    const put3 = newestFirst(
      (key, value, alone2) => write(begin, (answers) => {
        if (value === GONE) answers.delete(key);
        else if (alone2) {
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
      put: put3,
      remove: (key) => put3(key, GONE),
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
  async function write(begin, act) {
    await transaction(begin, act, "relaxed");
    clearTimeout(settling);
    settling = setTimeout(() => {
      const mark = (answers) => void answers.put(Date.now(), SETTLED);
      transaction(begin, mark, "strict").catch(() => {
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
      put: async (key, value, alone2) => {
        try {
          await store.put(key, value, alone2);
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

  // src/store/tabs.js
  function telling(store, site) {
    const channel = channelOf(`carts:${site}`);
    return {
      ...store,
      student: "",
      put: async (key, value, alone2) => {
        await store.put(key, value, alone2);
        channel?.postMessage({ key, gone: false });
      },
      remove: async (key) => {
        await store.remove(key);
        channel?.postMessage({ key, gone: true });
      },
      hear: (act, signal) => {
        channel?.addEventListener(
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
  var READINGS = "-measured";
  var opened = /* @__PURE__ */ new Map();
  function openAll(site) {
    const found = opened.get(site) ?? openOnce(site);
    opened.set(site, found);
    return found;
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
  function place() {
    const { cartsSite, cartsPage } = document.documentElement.dataset;
    const meta = (name) => document.querySelector(`meta[name="${name}"]`)?.getAttribute("content");
    const path = location.pathname.split("/").slice(-2).join("/");
    return {
      site: cartsSite ?? meta("carts-site") ?? "site",
      page: cartsPage ?? meta("carts-page") ?? path
    };
  }

  // src/measured/keep.js
  function keeper(id, bench) {
    const line = new KeptLine(bench);
    need(bench, ".carts-measured-source").append(line.root);
    const { site, page: page2 } = place();
    const key = `${page2}/${id}`;
    const opened2 = openAll(`${site}${READINGS}`);
    const put3 = async (kept) => {
      try {
        const store = await opened2;
        await store.put(key, kept, true);
        return store.kind === "kept";
      } catch {
        return false;
      }
    };
    return {
      get: async () => (await opened2).get(key).catch(() => null),
      put: (kept) => {
        const done = put3(kept);
        const own = kept.texts.length || kept.cells.length || kept.pasted;
        void line.hear(own ? done : Promise.resolve(true));
      }
    };
  }
  function empty(facts) {
    return {
      name: "",
      texts: [],
      cells: [],
      units: facts.units ?? { length: "", time: "", force: "" },
      from: "",
      until: "",
      law: facts.law,
      effect: usual([], facts),
      distance: "",
      masses: ["", ""],
      hand: null,
      fitted: ""
    };
  }
  var usual = (texts, facts) => facts.text && !texts.length ? "none" : "called";
  function readings(kept, facts) {
    if (kept.texts?.length) return { texts: kept.texts, synthetic: false, own: true };
    return { texts: facts.text ? [facts.text] : [], synthetic: facts.synthetic, own: false };
  }

  // ../view/numbers.js
  function exponent(value) {
    return value ? Number(Math.abs(value).toExponential(16).split("e")[1]) : 0;
  }
  function fixed(value, decimals) {
    const text2 = Math.abs(value).toFixed(decimals);
    return value < 0 && /[1-9]/.test(text2) ? `−${text2}` : text2;
  }
  function px(value, decimals = 1) {
    const factor = 10 ** decimals;
    const rounded = Math.floor(value * factor + 0.5) / factor;
    return String(rounded === 0 ? 0 : rounded);
  }

  // src/scene/time/slow.js
  function slowAt(parts, t) {
    return parts.find((part) => t >= part.from && t < part.to);
  }
  function advance(t, seconds2, speed, parts, until) {
    let now = t;
    let left = seconds2;
    while (left > 0 && now < until) {
      const inside = slowAt(parts, now);
      const rate = inside ? Math.min(speed, inside.rate) : speed;
      const edge = inside ? inside.to : parts.find((part) => part.from > now)?.from ?? until;
      const next = Math.min(edge, until);
      if (now + left * rate < next) return now + left * rate;
      left -= (next - now) / rate;
      now = next;
    }
    return Math.min(now, until);
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
    seek(t) {
      this.#move(Math.min(t, this.seen));
      if (t <= 0) this.own = 0;
      this.#tell(this.time, false);
    }
    show(t) {
      this.seen = Math.max(this.seen, t);
      this.seek(t);
    }
    step(way, count = 1) {
      this.pause();
      const start = this.time;
      for (let k = 0; k < count; k += 1) {
        const before = this.time;
        const target = before + way * STEP * this.rate;
        const event = way > 0 ? this.stops.find((t) => t > before + SAME) : this.stops.findLast((t) => t < before - SAME);
        const passed = event !== void 0 && (way > 0 ? event < target : event > target);
        this.#move(passed ? event : target);
        this.#tell(before, way > 0);
      }
      this.stepped(start);
    }
    #tick(now) {
      if (!this.playing) return;
      const seconds2 = this.#last ? Math.min(LONGEST_FRAME, (now - this.#last) / 1e3) : 0;
      this.#last = now;
      const before = this.time;
      this.own += seconds2;
      this.#waited += seconds2;
      if (this.stills && this.#waited < STILL) {
        this.#frame = requestAnimationFrame((next2) => this.#tick(next2));
        return;
      }
      const shown = this.stills ? this.#waited : seconds2;
      this.#waited = 0;
      let next = advance(before, shown, this.speed, this.#parts, this.until);
      if (this.stills) next = this.stops.find((t) => t > before + SAME && t < next) ?? next;
      const halt = this.halting ? this.halts.find((t) => t > before + SAME && t <= next) : void 0;
      this.#move(halt ?? next);
      if (halt !== void 0 || this.time >= this.until) this.playing = false;
      this.#tell(before, true);
      if (this.playing) this.#frame = requestAnimationFrame((next2) => this.#tick(next2));
    }
    #move(t) {
      this.time = Math.min(this.until, Math.max(0, t));
      this.seen = Math.max(this.seen, this.time);
    }
    #tell(before, playing) {
      this.changed(before, playing);
      if (this.time >= this.until) this.ended();
    }
  };

  // ../view/scales.js
  var STEP_SLACK = 1e-9;
  function axisDecimals(axis) {
    return Math.max(0, -exponent(axis.step));
  }
  function ticks(axis) {
    const first = Math.ceil(axis.low / axis.step - STEP_SLACK);
    const last = Math.floor(axis.high / axis.step + STEP_SLACK);
    const found = [];
    for (let k = first; k <= last; k += 1) found.push(k * axis.step);
    return found;
  }
  function niceAbove(value) {
    const power = Number(`1e${exponent(value)}`);
    for (const factor of [1, 2, 5]) {
      if (value <= factor * power * (1 + STEP_SLACK)) return factor * power;
    }
    return 10 * power;
  }
  function span(low, high, count) {
    return { low, high, step: niceAbove((high - low) / count) };
  }

  // src/measured/figure.js
  var [LEFT, RIGHT, TOP, BOTTOM] = [78, 630, 10, 250];
  var LOW = { top: 8, bottom: 104 };
  var ROOM = 0.06;
  var HEAD = 1.15;
  function reach(lists) {
    let [low, high] = [Infinity, -Infinity];
    for (const list of lists) {
      for (const value of list) {
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    return [low, high];
  }
  var across = (axis, value) => LEFT + (value - axis.low) / (axis.high - axis.low) * (RIGHT - LEFT);
  var up = (axis, value, top = TOP, bottom = BOTTOM) => bottom - (value - axis.low) / (axis.high - axis.low) * (bottom - top);
  function planes(tracks) {
    const [begin, end] = reach(tracks.map((track) => track.t));
    const [low, high] = reach(tracks.map((track) => track.value));
    const room = ROOM * (high - low) || 1;
    return { t: span(begin, end, 8), x: span(low - room, high + room, 8) };
  }
  var DOT = "h0.01";
  function dots(t, values, axis, up_, room = [TOP, BOTTOM]) {
    return t.map((time, k) => `M${px(across(axis, time))} ${px(up(up_, Number(values[k]), ...room))}${DOT}`).join("");
  }
  var Figure = class {
    #cursor = null;
    #axis = null;
    constructor(place2, left) {
      this.place = place2;
      this.left = left;
    }
    show(tracks, heads2, curve, touch = null) {
      const { t, x } = planes(tracks);
      this.#axis = t;
      this.#cursor = svg("path", { class: "carts-measured-cursor" });
      this.place.replaceChildren(
        ...frame(t, x, BOTTOM, TOP, heads2),
        ...touch === null ? [] : band(t, touch, TOP, BOTTOM),
        ...tracks.map(
          (track, k) => svg("path", {
            class: `carts-measured-dots carts-b${k}`,
            d: dots(track.t, track.value, t, x)
          })
        ),
        model(curve, t, x),
        this.#cursor
      );
    }
    rest(tracks, residuals, unit, factor) {
      const { t } = planes(tracks);
      const [low, high] = reach(residuals);
      const most = HEAD * factor * Math.max(1e-12, -low, high);
      const axis = span(-most, most, 6);
      this.left.toggleAttribute("hidden", false);
      this.left.replaceChildren(
        ...frame(t, axis, LOW.bottom, LOW.top, { value: unit }),
        svg("path", {
          class: "carts-measured-zero",
          d: `M${LEFT} ${px(up(axis, 0, LOW.top, LOW.bottom))}H${RIGHT}`
        }),
        ...tracks.map(
          (track, k) => svg("path", {
            class: `carts-measured-dots carts-measured-small carts-${tracks.length > 1 ? `b${k}` : "total"}`,
            d: dots(
              track.t,
              (residuals[k] ?? []).map((value) => factor * value),
              t,
              axis,
              [LOW.top, LOW.bottom]
            )
          })
        )
      );
    }
    at(time) {
      if (!this.#cursor || !this.#axis) return;
      put(this.#cursor, "d", `M${px(across(this.#axis, time))} ${TOP}V${BOTTOM}`);
    }
  };
  function model(curve, t, x) {
    const [width, height] = [RIGHT - LEFT, BOTTOM - TOP];
    const room = svg("svg", { x: LEFT, y: TOP, width, height });
    put(room, "viewBox", `${LEFT} ${TOP} ${width} ${height}`);
    const at = (n) => px(across(t, Number(curve?.t[n])));
    for (const [k, values] of (curve?.x ?? []).entries()) {
      const d = values.map((value, n) => `${n ? "L" : "M"}${at(n)} ${px(up(x, value))}`).join("");
      room.append(svg("path", { class: `carts-measured-curve carts-b${k}`, d }));
    }
    return room;
  }
  function band(t, touch, top, bottom) {
    if (touch < t.low || touch > t.high) return [];
    return [
      svg("path", {
        class: "carts-measured-touch",
        d: `M${px(across(t, touch))} ${top}V${bottom}`
      })
    ];
  }
  function frame(t, x, bottom, top, { time, value }) {
    const parts = [];
    for (const tick of ticks(t)) {
      const at = px(across(t, tick));
      parts.push(svg("path", { class: "carts-grid", d: `M${at} ${top}V${bottom}` }));
      parts.push(text("carts-tick-x", at, bottom + 16, fixed(tick, axisDecimals(t))));
    }
    for (const tick of ticks(x)) {
      const at = px(up(x, tick, top, bottom));
      parts.push(svg("path", { class: "carts-grid", d: `M${LEFT} ${at}H${RIGHT}` }));
      parts.push(text("carts-tick-y", LEFT - 6, Number(at) + 4, fixed(tick, axisDecimals(x))));
    }
    const label = svg("text", {
      class: "carts-unit",
      transform: `translate(18 ${(top + bottom) / 2}) rotate(-90)`,
      "text-anchor": "middle"
    });
    label.textContent = value;
    parts.push(label);
    if (time) {
      const name = text("carts-unit", RIGHT, bottom + 31, time);
      put(name, "text-anchor", "end");
      parts.push(name);
    }
    return parts;
  }
  function text(name, x, y, words) {
    const made = svg("text", { class: name, x, y });
    made.textContent = words;
    return made;
  }

  // ../view/measured/table.js
  var PLACES = 4;
  function tableOf(read, residuals) {
    const { names, tracks } = read;
    const { time, tracks: its } = heads(read);
    const head = [time, ...its];
    if (residuals) head.push(...names.map((cart) => tr("residual of {cart} in mm", { cart })));
    const found = /* @__PURE__ */ new Map();
    for (const [k, track] of tracks.entries()) {
      for (const [n, t] of track.t.entries()) {
        const cells = found.get(t) ?? Array.from({ length: head.length - 1 }, () => "");
        cells[k] = fixed(Number(track.value[n]), PLACES);
        if (residuals) cells[2 + k] = fixed(1e3 * Number(residuals[k]?.[n]), 2);
        found.set(t, cells);
      }
    }
    const rows = [...found].sort(([a], [b]) => a - b).map(([t, cells]) => [fixed(t, PLACES), ...cells]);
    return { head, rows };
  }

  // src/measured/result.js
  function showResult(place2, report) {
    place2.hidden = false;
    const parts = [html("p", "carts-heading", tr("What the readings say"))];
    if (report.known) {
      const fitted = tr("Fitted with {law}.", { law: told(report.law_words) });
      parts.push(html("p", "carts-measured-law-words", fitted));
      if (report.added) parts.push(html("p", "", told(report.added)));
      if (report.doubt) parts.push(html("p", "carts-measured-doubt", told(report.doubt)));
      parts.push(table(report));
      parts.push(...notPrinted(report.untold));
    }
    const said = html("ul", "carts-measured-sentences");
    said.append(...report.sentences.map((sentence) => html("li", "", told(sentence))));
    parts.push(said);
    if (report.rungs) parts.push(ladder(report.rungs));
    place2.replaceChildren(...parts);
  }
  function notPrinted(untold) {
    const names = /* @__PURE__ */ new Map();
    for (const one of untold) {
      const reason = told(one.reason);
      names.set(reason, [...names.get(reason) ?? [], told(one.name)]);
    }
    return [...names].map(([reason, hidden]) => {
      const row = html("p", "carts-measured-untold");
      const which = tr("Not printed: {names}.", { names: semicolons(hidden) });
      row.append(html("strong", "", which), ` ${ended(upper(reason))}`);
      return row;
    });
  }
  function ladder({ line, taken: taken2, rows }) {
    const item = ({ sentence }) => html("li", "", told(sentence));
    const list = html("ol", "carts-ladder");
    list.append(
      ...rows.filter(({ verdict }) => verdict !== "not-shown").map(item),
      html("li", "carts-ladder-line", told(line)),
      ...rows.filter(({ verdict }) => verdict === "not-shown").map(item)
    );
    const root = html("details", "carts-measured-ladder");
    root.append(
      html("summary", "", tr("What do these readings call for?")),
      html("p", "", tr("Each effect alone, largest first:")),
      list,
      html("p", "carts-quiet", told(taken2))
    );
    return root;
  }
  function table(report) {
    const made = html("table", "carts-table carts-measured-known");
    const head = html("tr");
    for (const text2 of [tr("what"), tr("value ± half of the 95 % interval")]) {
      const cell = html("th", "", text2);
      cell.setAttribute("scope", "col");
      head.append(cell);
    }
    const top = html("thead");
    top.append(head);
    const body = html("tbody");
    for (const { key, name, interval } of report.known) {
      const row = html("tr");
      row.dataset.key = key;
      const title = html("th", "", told(name));
      title.setAttribute("scope", "row");
      row.append(title, html("td", "", told(interval)));
      body.append(row);
    }
    made.append(top, body);
    const scroll = html("div", "carts-scroll");
    scroll.append(made);
    return scroll;
  }
  var upper = (text2) => text2.charAt(0).toUpperCase() + text2.slice(1);
  function showTable(place2, read, residuals) {
    const { head, rows } = tableOf(read, residuals);
    const top = html("tr");
    for (const text2 of head) {
      const cell = html("th", "", text2);
      cell.setAttribute("scope", "col");
      top.append(cell);
    }
    const body = rows.map((cells) => {
      const row = html("tr");
      row.append(...cells.map((cell) => html("td", "", cell)));
      return row;
    });
    place2.querySelector("thead")?.replaceChildren(top);
    place2.querySelector("tbody")?.replaceChildren(...body);
    place2.closest("details")?.querySelector(".carts-measured-rest")?.remove();
  }

  // src/measured/decoded.js
  function decoded(bytes) {
    const start = new Uint8Array(bytes, 0, Math.min(2, bytes.byteLength));
    const mark = start[0] === 255 && start[1] === 254 ? "utf-16le" : "";
    const wide = start[0] === 254 && start[1] === 255 ? "utf-16be" : mark;
    return strictly(wide || "utf-8", bytes) ?? strictly(chinese(new Uint8Array(bytes)), bytes) ?? new TextDecoder("windows-1252").decode(bytes);
  }
  function strictly(encoding, bytes) {
    try {
      return new TextDecoder(encoding, { fatal: true }).decode(bytes);
    } catch {
      return void 0;
    }
  }
  function chinese(bytes) {
    let [beyond, inGbk, inBig5, high] = [0, 0, 0, 0];
    for (let at = 0; at < bytes.length; at += 1) {
      const first = bytes[at] ?? 0;
      if (first < 128) continue;
      const second = bytes[at + 1] ?? 0;
      const both2 = second > 160;
      beyond += 1;
      if ((first >= 176 && first <= 215 || first === 161 || first === 163) && both2) inGbk += 1;
      if (first >= 161 && first <= 198) {
        if (both2 || second >= 64 && second <= 126) inBig5 += 1;
        if (both2) high += 1;
      }
      at += second >= 48 && second <= 57 ? 3 : 1;
    }
    if (inBig5 > inGbk && 5 * inBig5 >= 4 * beyond && 4 * high >= beyond) return "big5";
    return 2 * inGbk > beyond ? "gb18030" : "windows-1252";
  }

  // src/shared/bring.js
  function bring(name, address) {
    const known = () => globalThis[name] ?? null;
    if (known()) return Promise.resolve(known());
    return new Promise((resolve) => {
      const script2 = document.createElement("script");
      script2.src = address;
      script2.onload = () => resolve(known());
      script2.onerror = () => {
        script2.remove();
        resolve(null);
      };
      document.head.append(script2);
    });
  }

  // src/measured/films.js
  var NAMED = /\.(mp4|m4v|mov|qt|webm|mkv|avi|3gp)$/i;
  var SCRIPT = "film.js";
  var isFilm = ({ name, type }) => type.startsWith("video/") || NAMED.test(name);
  var Films = class {
    #session = null;
    #filmed = () => {
    };
    // ends the camera
    #turn = 0;
    // what is waited for counts only while nothing newer is wanted
    constructor(bench, base, take, tell2) {
      this.bench = bench;
      this.base = base;
      this.take = take;
      this.tell = tell2;
      const input = need(bench, ".carts-measured-film-file");
      need(bench, ".carts-measured-film").addEventListener("click", () => input.click());
      input.addEventListener("change", () => {
        const [file] = input.files ?? [];
        if (file) void this.open(file);
        input.value = "";
      });
      const camera = need(bench, ".carts-measured-camera");
      camera.hidden = !mayFilm();
      camera.addEventListener("click", () => void this.camera());
    }
    async #script() {
      this.end();
      const turn = this.#turn;
      const { search } = new URL(this.base);
      const address = new URL(SCRIPT + search, this.base).href;
      const script2 = await bring("cartsFilm", address);
      if (turn !== this.#turn) return null;
      this.tell(script2 ? "" : tr("What reads films is missing: this page was not copied whole."));
      return script2;
    }
    async open(file) {
      const script2 = await this.#script();
      this.#session = script2?.open(this.bench, file, this.take) ?? null;
    }
    async camera() {
      const script2 = await this.#script();
      if (!script2) return;
      const turn = this.#turn;
      const end = await script2.camera(this.bench, (file) => void this.open(file), this.tell);
      if (turn === this.#turn) this.#filmed = end;
      else end();
    }
    at(time, places) {
      this.#session?.at(time, places);
    }
    end() {
      this.#turn += 1;
      this.#session?.end();
      this.#session = null;
      this.#filmed();
      this.#filmed = () => {
      };
    }
  };
  function mayFilm() {
    const hosted = location.protocol.startsWith("http") && isSecureContext;
    return hosted && Boolean(navigator.mediaDevices) && typeof MediaRecorder === "function";
  }

  // src/measured/grid.js
  var ROWS = 10;
  var MOST = 500;
  var CARTS = ["", "A", "B"];
  var Grid = class {
    constructor(body, changed) {
      this.body = body;
      this.changed = changed;
      this.grow();
      body.addEventListener("input", () => changed());
      body.addEventListener("paste", (event) => this.#paste(event));
    }
    grow(count = ROWS) {
      for (let k = 0; k < count && this.body.children.length < MOST; k += 1) {
        const number = this.body.children.length + 1;
        const row = html("tr");
        for (const cart of CARTS) {
          const column = cart ? tr("{letter} of {cart}", { letter: "x", cart }) : "t";
          const cell = html("td");
          const box = html("input");
          Object.assign(box, {
            type: "text",
            inputMode: "decimal",
            autocomplete: "off"
          });
          box.setAttribute("aria-label", tr("{column}, row {row}", { column, row: number }));
          cell.append(box);
          row.append(cell);
        }
        this.body.append(row);
      }
    }
    get cells() {
      const rows = [...this.body.children].map(
        (row) => [...row.querySelectorAll("input")].map((box) => box.value)
      );
      while (rows.length && rows.at(-1)?.every((cell) => !cell.trim())) rows.pop();
      return rows;
    }
    set cells(rows) {
      this.grow(Math.max(0, rows.length - this.body.children.length));
      const boxes = [...this.body.children].map((row) => [...row.querySelectorAll("input")]);
      for (const [k, row] of boxes.entries()) {
        for (const [j, box] of row.entries()) box.value = rows[k]?.[j] ?? "";
      }
    }
    get text() {
      const rows = this.cells.map((row) => row.map((cell) => cell.trim()).join(";"));
      return ["t;x_A;x_B", ...rows].join("\n");
    }
    #paste(event) {
      const text2 = event.clipboardData?.getData("text/plain") ?? "";
      if (!/[\t\n]/.test(text2.trim()) || !(event.target instanceof HTMLInputElement)) return;
      event.preventDefault();
      const block = text2.replace(/\r\n?/g, "\n").trimEnd().split("\n").slice(0, MOST).map((line) => line.split("	"));
      const row = event.target.closest("tr");
      const top = [...this.body.children].indexOf(row);
      const left = [...row?.querySelectorAll("input") ?? []].indexOf(event.target);
      const all = this.cells;
      for (const [k, cells] of block.entries()) {
        all[top + k] ??= CARTS.map(() => "");
        for (const [j, cell] of cells.slice(0, CARTS.length - left).entries()) {
          all[top + k][left + j] = cell;
        }
      }
      this.cells = Array.from(all, (cells) => cells ?? CARTS.map(() => ""));
      this.changed();
    }
  };

  // src/measured/source.js
  var MOST_BYTES = 4e6;
  var MOST_ZIPPED = 3e7;
  var ZIP_NAME = /\.(zip|trz)$/i;
  var FILE_NAME = /^\S+\.\w+$/;
  var ZIP = 1347093252;
  var TYPED = "typed readings";
  var LINE = "line {line}";
  var Source = class _Source {
    #open = () => {
    };
    #opened = new Promise((resolve) => {
      this.#open = resolve;
    });
    constructor(root, take, changed, tell2, unzip, base) {
      this.root = root;
      this.unzip = unzip;
      const area = root.closest("carts-measured") ?? root;
      this.films = new Films(area, base, take, tell2);
      this.take = (name, texts) => {
        this.films.end();
        take(name, texts);
      };
      this.tell = tell2;
      this.grid = new Grid(need(root, ".carts-measured-grid tbody"), changed);
      this.paste = need(root, ".carts-measured-paste textarea");
      this.paste.addEventListener("input", changed);
      const file = need(root, ".carts-measured-file");
      this.#enable(false);
      this.on("open", () => file.click());
      this.on("take", () => this.take(tr("pasted readings"), [this.paste.value]));
      this.on("typed-take", () => this.take(TYPED, [this.grid.text]));
      this.on("more", () => this.grid.grow());
      file.addEventListener("change", () => {
        void this.files([...file.files ?? []]);
        file.value = "";
      });
      area.addEventListener("dragover", (event) => event.preventDefault());
      area.addEventListener("drop", (event) => {
        event.preventDefault();
        const { dataTransfer } = event;
        void this.files([...dataTransfer?.files ?? []]);
      });
    }
    open({ cells, pasted }) {
      if (cells.length) this.grid.cells = cells;
      this.paste.value = pasted ?? "";
      this.#enable(true);
      this.#open(void 0);
    }
    #enable(on) {
      for (const input of this.root.querySelectorAll("button, textarea, select, input")) {
        input.disabled = !on;
      }
    }
    get typed() {
      return { cells: this.grid.cells, pasted: this.paste.value };
    }
    on(name, act) {
      this.root.querySelector(`.carts-measured-${name}`)?.addEventListener("click", act);
    }
    async files(files) {
      if (!files.length) return;
      await this.#opened;
      const film = files.find(isFilm);
      if (film) return this.films.open(film);
      if (files.length > 2) return this.tell(tr("Choose one file with both carts, or one for each."));
      for (const { name, size } of files) {
        const most = ZIP_NAME.test(name) ? MOST_ZIPPED : MOST_BYTES;
        if (size <= most) continue;
        const limit = tr("at most {most} MB", { most: most / 1e6 });
        return this.tell(
          tr("This file is too large to be readings of two carts: {limit}.", { limit })
        );
      }
      const texts = [];
      for (const file of files) {
        const bytes = await file.arrayBuffer().catch(() => null);
        if (!bytes) return this.tell(_Source.notRead(file.name) + tr("choose a file that is there."));
        const found = isZip(bytes) ? await this.#unzipped(bytes) : { text: decoded(bytes) };
        if ("refused" in found) {
          const why = found.refused.map((fault) => _Source.hinted(file.name, fault));
          return this.tell(_Source.notRead(file.name) + why.join(". "));
        }
        texts.push(found.text);
      }
      this.take(listed(files.map((file) => file.name)), texts);
    }
    #unzipped(bytes) {
      return this.unzip(base64(bytes)).catch(({ message }) => ({
        refused: [{ line: null, reason: message, hint: tr("a zip needs Python to be opened") }]
      }));
    }
    save(name, texts) {
      if (!texts.length)
        say(need(this.root, ".carts-measured-said"), tr("There are no readings yet."));
      const own = texts.length === 1 && FILE_NAME.test(name) && !ZIP_NAME.test(name);
      const one = own ? name : "readings.txt";
      for (const text2 of texts) download(one, text2, "text/plain;charset=utf-8");
    }
    static told(name, reason) {
      return told(withPlaces(name, reason));
    }
    static hinted(name, { reason, hint: hint2 }) {
      const found = _Source.told(name, reason);
      return hint2 ? tr("{reason} ({hint})", { reason: found, hint: told(hint2) }) : found;
    }
    static called(name) {
      return name === TYPED ? tr("typed readings") : name;
    }
    static notRead(name) {
      if (!name || name === TYPED) return "";
      const told4 = tr("{name} was not read:", { name });
      return `${told4} `;
    }
    static place(name, line) {
      if (name !== TYPED) return tr("line {line}", { line });
      return line > 1 ? tr("row {row}", { row: line - 1 }) : tr("the table");
    }
  };
  function withPlaces(name, reason) {
    if (typeof reason === "string") return reason;
    if (reason.code === LINE) return Source.place(name, Number(reason.values.line));
    const values = Object.entries(reason.values).map(([key, value]) => [
      key,
      withPlaces(name, value)
    ]);
    return { ...reason, values: Object.fromEntries(values) };
  }
  function isZip(bytes) {
    return new DataView(bytes).byteLength > 4 && new DataView(bytes).getUint32(0) === ZIP;
  }
  function base64(bytes) {
    let text2 = "";
    for (const byte of new Uint8Array(bytes)) text2 += String.fromCharCode(byte);
    return btoa(text2);
  }

  // src/measured/stage.js
  var [WIDTH, FLOOR, SIDE, TALL] = [640, 62, 16, 34];
  var USUAL = 0.2;
  var NEAR = 1.5;
  var Stage = class {
    #shown = null;
    #carts = [];
    #rings = [];
    #scale = 1;
    #left = 0;
    constructor(place2) {
      this.place = place2;
    }
    show(tracks, curve, distance, names) {
      const length = distance > 0.1 && distance < 1 ? distance : USUAL;
      this.#shown = { tracks, curve, length, names };
      const all = [...tracks.flatMap((track) => track.value), ...curve.x.flat()];
      const low = all.reduce((a, b) => Math.min(a, b)) - length / 2;
      const high = all.reduce((a, b) => Math.max(a, b)) + length / 2;
      this.#left = low;
      this.#scale = (WIDTH - 2 * SIDE) / (high - low);
      this.#carts = names.map((name, k) => {
        const width = length * this.#scale;
        const group = svg("g", { class: `carts-b${k}` });
        const box = svg("rect", {
          class: "carts-box",
          x: px(-width / 2),
          y: FLOOR - TALL,
          width: px(width),
          height: TALL,
          rx: 3
        });
        const label = svg("text", {
          class: "carts-name",
          y: FLOOR - 12,
          "text-anchor": "middle"
        });
        label.textContent = name.length > 8 ? `${name.slice(0, 7)}…` : name;
        group.append(box, label);
        return group;
      });
      this.#rings = names.map(
        (_, k) => svg("circle", {
          class: `carts-measured-ring carts-b${k}`,
          r: 7,
          cy: FLOOR - TALL - 12
        })
      );
      const ruler = span(low, high, 7);
      const decimals = Math.max(0, Math.ceil(-Math.log10(ruler.step) - 1e-9));
      this.place.replaceChildren(
        svg("path", { class: "carts-rule", d: `M0 ${FLOOR}H${WIDTH}` }),
        ...ticks(ruler).map((tick) => {
          const at = px(this.#at(tick));
          return svg("path", { class: "carts-rule", d: `M${at} ${FLOOR}v6` });
        }),
        ...ticks(ruler).map((tick) => {
          const number = svg("text", {
            class: "carts-tick-x",
            x: px(this.#at(tick)),
            y: FLOOR + 20
          });
          number.textContent = `${tick.toFixed(decimals).replace("-", "−")} m`;
          return number;
        }),
        ...this.#carts,
        ...this.#rings
      );
    }
    #at(x) {
      return SIDE + (x - this.#left) * this.#scale;
    }
    places(time) {
      const { names, curve } = this.#shown ?? { names: [], curve: { t: [], x: [] } };
      return Object.fromEntries(
        names.map((name, k) => [name, between(curve.t, curve.x[k] ?? [], time)])
      );
    }
    at(time) {
      if (!this.#shown) return;
      const { tracks, curve } = this.#shown;
      for (const [k, cart] of this.#carts.entries()) {
        const x = between(curve.t, curve.x[k] ?? [], time);
        put(cart, "transform", `translate(${px(this.#at(x), 2)} 0)`);
        const track = tracks[k];
        const ring = this.#rings[k];
        if (!track || !ring) continue;
        const nearest = closest(track.t, time);
        const frame2 = (Number(track.t.at(-1)) - Number(track.t[0])) / (track.t.length - 1);
        const seen = Math.abs(Number(track.t[nearest]) - time) <= NEAR * frame2;
        put(ring, "cx", px(this.#at(Number(track.value[nearest])), 2));
        put(ring, "visibility", seen ? "visible" : "hidden");
      }
    }
  };
  function closest(times, t) {
    let k = times.findIndex((time) => time >= t);
    if (k < 0) k = times.length - 1;
    const before = Math.max(0, k - 1);
    return Math.abs(Number(times[before]) - t) < Math.abs(Number(times[k]) - t) ? before : k;
  }
  function between(times, values, t) {
    let k = times.findLastIndex((time) => time <= t);
    k = Math.min(Math.max(k, 0), Math.max(0, times.length - 2));
    const [a, b] = [Number(times[k]), Number(times[k + 1])];
    const part = b > a ? Math.min(1, Math.max(0, (t - a) / (b - a))) : 0;
    return Number(values[k]) + part * (Number(values[k + 1]) - Number(values[k]));
  }

  // src/measured/picture.js
  var QUARTER = 0.25;
  var FINE = 0.01;
  var Picture = class {
    #begin = 0;
    watch = () => {
    };
    constructor(root) {
      this.root = root;
      this.figure = new Figure(this.#part("figure"), this.#part("left"));
      this.stage = new Stage(this.#part("stage"));
      this.player = new Player(() => this.#frame());
      this.player.speed = QUARTER;
      this.player.slow = false;
      this.scrub = this.#part("scrub");
      this.scrub.addEventListener("input", () => {
        this.player.pause();
        this.player.seek(this.scrub.valueAsNumber);
      });
      this.#part("play").addEventListener("click", () => this.player.toggle());
    }
    #part(name) {
      return need(this.root, `.carts-measured-${name}`);
    }
    forget() {
      this.#part("result").hidden = true;
      this.#part("back").hidden = true;
    }
    readings(name, read, motion) {
      this.forget();
      say(this.#part("said"), semicolons([Source.called(name), ...howRead(read)].filter(Boolean)));
      this.#part("legend").replaceChildren(...legend(read));
      this.#part("model").hidden = !motion;
      this.#part("world").hidden = !motion;
      this.#part("left").toggleAttribute(
        "hidden",
        !motion && !(read.forces && read.kind === "force")
      );
      if (read.kind !== "length") this.#forces(read);
      else if (!motion) this.#points(read);
    }
    #points(read) {
      this.figure.show(read.tracks, heads(read), null);
      showTable(need(this.root, ".carts-measured-table table"), read, null);
      say(this.#part("spread"), "");
    }
    #forces(read) {
      const { forces, kind } = read;
      const summed = kind === "force";
      const tracks = forces ? forces.F.map((F) => ({ t: forces.t, value: F })) : read.tracks;
      this.figure.show(tracks, heads(read), null);
      if (forces && summed) {
        const sum = forces.t.map((_, k) => Number(forces.F[0]?.[k]) + Number(forces.F[1]?.[k]));
        this.figure.rest([{ t: forces.t, value: sum }], [sum], tr("sum in N"), 1);
      }
      showTable(need(this.root, ".carts-measured-table table"), read, null);
      say(this.#part("spread"), forces && summed ? tr("Lower picture: the sum of both forces.") : "");
      if (read.report) showResult(this.#part("result"), read.report);
    }
    draw(read, drawn) {
      this.figure.show(read.tracks, heads(read), drawn.curve, drawn.parameters.touch);
      this.figure.rest(read.tracks, drawn.residuals, tr("rest in mm"), 1e3);
      this.stage.show(read.tracks, drawn.curve, drawn.parameters.distance, read.names);
      showTable(need(this.root, ".carts-measured-table table"), read, drawn.residuals);
      const all = read.tracks[0].t.length + read.tracks[1].t.length;
      const spread = `${fixed(1e3 * drawn.spread, drawn.spread < FINE ? 2 : 0)} mm`;
      const count = drawn.counted ?? all;
      const size = count < all ? tr("{spread} (of the {count} readings that the fit counts)", { spread, count }) : spread;
      say(
        this.#part("spread"),
        tr(
          "Lower picture: residuals, the rest (measured minus model). Their root mean square is {size}.",
          { size }
        )
      );
      this.#begin = Number(drawn.curve.t[0]);
      this.player.until = Number(drawn.curve.t.at(-1)) - this.#begin;
      this.scrub.max = String(this.player.until);
      this.player.seek(Math.min(this.player.time, this.player.until));
    }
    #frame() {
      const t = this.#begin + this.player.time;
      this.stage.at(t);
      this.watch(t, this.stage.places(t));
      this.figure.at(t);
      this.scrub.value = String(this.player.time);
      this.scrub.setAttribute("aria-valuetext", `${fixed(t, 2)} s`);
      say(this.#part("clock"), `t = ${fixed(t, 3)} s`);
      this.#part("play").classList.toggle("carts-is-playing", this.player.playing);
      say(this.#part("play"), this.player.playing ? tr("Pause") : tr("Play"));
    }
    told(report) {
      showResult(this.#part("result"), report);
      this.#part("back").hidden = false;
      const fence = this.#part("fence");
      fence.value = told(report.fence);
    }
    refuse(name, faults, what) {
      const whose = what === "read" ? Source.notRead(name) : "";
      const fit = what !== "" && what !== "read";
      const rows = faults.map((fault, k) => {
        const row = document.createElement("li");
        const help = Source.hinted(name, fault);
        const where = fault.line === null ? "" : Source.place(name, fault.line);
        const text2 = where ? tr("{name}: {text}", { name: where, text: help }) : help;
        row.textContent = `${k ? "" : whose}${text2}`;
        return row;
      });
      this.#part("unfitted").replaceChildren(...fit ? rows : []);
      if (!fit) this.#part("unread").replaceChildren(...rows);
    }
    turn() {
      this.#part("unfitted").firstElementChild?.scrollIntoView({ block: "center" });
    }
    note(textContent) {
      Object.assign(need(this.root, ".carts-note"), { hidden: !textContent, textContent });
    }
    busy(text2) {
      say(this.#part("busy"), text2);
    }
  };
  var NAMES = {
    length: (name) => name,
    force: (cart) => tr("force on {cart}", { cart }),
    acceleration: (cart) => tr("phone on {cart}", { cart })
  };
  function legend(read) {
    return read.names.flatMap((name, k) => {
      const mark = document.createElement("span");
      mark.className = `carts-measured-key carts-b${k}`;
      const text2 = document.createElement("span");
      text2.textContent = NAMES[read.kind](name);
      return [mark, text2];
    });
  }

  // src/measured/settings.js
  var Settings = class {
    #masses = [];
    #names = ["A", "B"];
    #wanted = "";
    // the run that was chosen at an earlier visit
    constructor(root, changed) {
      const find = (name) => need(root, `.carts-measured-${name}`);
      this.from = find("from");
      this.until = find("until");
      this.law = find("law");
      this.effect = find("effect");
      this.distance = find("distance");
      this.together = find("together");
      this.run = need(root, ".carts-measured-run");
      this.place = need(root, ".carts-measured-masses");
      this.units = [...root.querySelectorAll(".carts-measured-unit")].map(
        (select) => select
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
    named(names) {
      if (this.#masses.length && names.join() === this.#names.join()) return;
      const before = this.#masses.map((box) => box.value);
      this.#names = names;
      this.#masses = names.map((_, k) => {
        const box = html("input");
        Object.assign(box, {
          type: "text",
          inputMode: "decimal",
          autocomplete: "off",
          value: before[k] ?? ""
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
          label.append(this.#masses[k], " kg");
          return [label, " "];
        }),
        html("span", "carts-quiet", tr("if you have a balance"))
      );
    }
    offer({ assumed, runs = [], run = "" }) {
      for (const select of this.units) {
        const open3 = assumed.some((kind) => kind === select.dataset.kind);
        select.closest("label")?.toggleAttribute("hidden", !open3);
      }
      this.run.closest("label")?.toggleAttribute("hidden", runs.length < 2);
      if (this.run.options.length === runs.length) return;
      this.run.replaceChildren(...runs.map((name) => new Option(name)));
      this.run.value = this.#wanted;
      if (this.run.selectedIndex < 0) this.run.value = run;
    }
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
    fill(kept) {
      for (const select of this.units) {
        const kind = select.dataset.kind;
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
    get chosen() {
      const units = { time: "", length: "", force: "" };
      for (const select of this.units) {
        units[select.dataset.kind] = select.value;
      }
      return units;
    }
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
        masses: this.#masses.map((box) => box.value)
      };
    }
    get asked() {
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
        masses
      };
    }
  };

  // src/measured/kinds.js
  var KINDS = {
    rest: () => tr("rest"),
    hand: () => tr("hand"),
    coasting: () => tr("coasting"),
    friction: () => tr("slowing down"),
    contact: () => tr("contact"),
    stop: () => tr("stop")
  };
  var word = (kind) => KINDS[kind]?.() ?? kind;
  var hint = () => tr(
    "What each cart did. Drag a boundary, or move it with the arrow keys: velocities and what the readings call for are found again with it."
  );

  // src/measured/spans.js
  var SAME2 = 1e-6;
  var LEAST = 2;
  function ofCart(segments, cart) {
    return segments.filter((one) => one.cart === cart);
  }
  function limits(segments, cart, k, step) {
    const all = linked(segments, cart, k);
    const low = Math.max(...all.map(([left]) => left.from + LEAST * step));
    const high = Math.min(...all.map(([, right]) => right.until - LEAST * step));
    return [low, Math.max(low, high)];
  }
  function linked(segments, cart, k) {
    const own = ofCart(segments, cart);
    const [left, right] = [own[k], own[k + 1]];
    if (!left || !right) return [];
    const push = left.kind === "contact" ? "left" : right.kind === "contact" ? "right" : "";
    if (!push) return [[left, right]];
    const at = left.until;
    const found = [];
    for (const one of segments) {
      if (Math.abs(one.until - at) > SAME2) continue;
      const other = segments.find((s) => s.cart === one.cart && Math.abs(s.from - at) <= SAME2);
      if (other && (push === "left" ? one : other).kind === "contact") found.push([one, other]);
    }
    return found;
  }
  function move(segments, cart, k, t) {
    for (const [left, right] of linked(segments, cart, k)) {
      left.until = t;
      right.from = t;
    }
  }
  function told2(before, segments, cart, k) {
    const own = ofCart(segments, cart);
    const sides = [own[k], own[k + 1]].filter((one) => one !== void 0);
    const push = sides.find((one) => one.kind === "contact");
    const rows = (push ? [push] : sides).map(({ kind, from, until }) => {
      return { kind, from, until, cart: push ? null : cart };
    });
    const replaced = (old) => rows.some((row) => row.cart === old.cart && row.from < old.until && old.from < row.until);
    return [...before.filter((old) => !replaced(old)), ...rows];
  }
  function lanes(places, wide) {
    const ends = [];
    return places.map((x) => {
      const free = ends.findIndex((end) => end <= x - wide / 2);
      const row = free < 0 ? ends.length : free;
      ends[row] = x + wide / 2;
      return row;
    });
  }

  // src/measured/strip.js
  var WIDE = 24;
  var USUAL2 = 320;
  var WAITS = 500;
  var NAMED2 = 12;
  var STEPS = 500;
  var seconds = (t) => fixed(t, 2);
  var Strip = class {
    given = [];
    #segments = [];
    #step = 0.01;
    #timer = 0;
    constructor(place2, changed) {
      this.place = place2;
      this.changed = changed;
      new ResizeObserver(() => this.#stack()).observe(place2);
    }
    clear() {
      this.given = [];
      this.show(null);
    }
    show(found, times = []) {
      clearTimeout(this.#timer);
      const held = this.place.querySelector(":focus");
      const at = Number(held?.getAttribute("aria-valuenow"));
      this.#segments = structuredClone(found?.segments ?? []);
      this.place.hidden = !this.#segments.length;
      if (this.place.hidden) return this.place.replaceChildren();
      const frame2 = (Number(times.at(-1)) - Number(times[0])) / (times.length - 1);
      this.#step = Math.max(frame2 || 0, this.#length / STEPS);
      const made = html("div", "carts-measured-strip");
      for (const name of found?.names ?? []) {
        const row = html("div", "carts-measured-strip-row");
        row.dataset.cart = name;
        row.append(this.#bar(name), ...this.#edges(name));
        made.append(html("span", "carts-measured-strip-name", name), row);
      }
      this.place.replaceChildren(html("p", "carts-quiet", hint()), made);
      if (this.given.length) this.place.append(this.#asFound());
      this.#put();
      this.#stack();
      if (held) this.#focus(held.dataset.cart ?? "", at);
    }
    get #begin() {
      return Math.min(...this.#segments.map((one) => one.from));
    }
    get #length() {
      return Math.max(...this.#segments.map((one) => one.until)) - this.#begin;
    }
    #bar(cart) {
      const bar = html("div", "carts-measured-strip-bar");
      bar.setAttribute("role", "img");
      for (const { kind } of ofCart(this.#segments, cart)) {
        const part = html("span");
        part.dataset.kind = kind;
        bar.append(part);
      }
      return bar;
    }
    #edges(cart) {
      return ofCart(this.#segments, cart).slice(1).map((_, k) => {
        const edge = html("span", "carts-measured-edge");
        edge.dataset.cart = cart;
        edge.tabIndex = 0;
        edge.setAttribute("role", "slider");
        edge.addEventListener("pointerdown", (event) => {
          edge.setPointerCapture(event.pointerId);
          edge.focus();
          event.preventDefault();
        });
        edge.addEventListener("pointermove", (event) => {
          if (edge.hasPointerCapture(event.pointerId)) this.#drag(cart, k, event.clientX);
        });
        edge.addEventListener("pointerup", () => {
          this.#stack();
          if ("moved" in edge.dataset) this.#commit(cart, k);
        });
        edge.addEventListener("keydown", (event) => this.#key(event, cart, k));
        return edge;
      });
    }
    #drag(cart, k, x) {
      const box = this.#row(cart).getBoundingClientRect();
      this.#move(cart, k, this.#begin + (x - box.left) / box.width * this.#length);
    }
    #key(event, cart, k) {
      const [low, high] = limits(this.#segments, cart, k, this.#step);
      const now = Number(ofCart(this.#segments, cart)[k]?.until);
      const steps = {
        ArrowLeft: -1,
        ArrowDown: -1,
        ArrowRight: 1,
        ArrowUp: 1,
        PageDown: -10,
        PageUp: 10
      };
      const by = steps[event.key];
      const to = event.key === "Home" ? low : event.key === "End" ? high : now + by * this.#step;
      if (!Number.isFinite(to)) return;
      event.preventDefault();
      this.#move(cart, k, to);
      this.#stack();
      clearTimeout(this.#timer);
      this.#timer = setTimeout(() => this.#commit(cart, k), WAITS);
    }
    #move(cart, k, t) {
      const [low, high] = limits(this.#segments, cart, k, this.#step);
      move(this.#segments, cart, k, Math.min(high, Math.max(low, t)));
      const edge = this.#row(cart).querySelectorAll(".carts-measured-edge")[k];
      if (edge instanceof HTMLElement) edge.dataset.moved = "";
      this.#put();
    }
    #commit(cart, k) {
      this.given = told2(this.given, this.#segments, cart, k);
      this.changed();
    }
    #asFound() {
      const button = html("button", "carts-button carts-measured-as-found", tr("As found"));
      button.setAttribute("type", "button");
      button.addEventListener("click", () => {
        this.given = [];
        this.changed();
      });
      return button;
    }
    #row(cart) {
      const rows = [...this.place.querySelectorAll(".carts-measured-strip-row")];
      return rows.find((row) => row.dataset.cart === cart);
    }
    #put() {
      for (const cart of new Set(this.#segments.map((one) => one.cart))) {
        const own = ofCart(this.#segments, cart);
        const row = this.#row(cart);
        const spans = own.map(
          ({ kind, from, until }) => `${word(kind)} ${seconds(from)} – ${seconds(until)} s`
        );
        const bar = row.firstElementChild;
        put(bar, "aria-label", `${cart}: ${spans.join(", ")}`);
        for (const [k, { kind, from, until }] of own.entries()) {
          const part = bar.children[k];
          const named = kind === "contact" || NAMED2 * (until - from) > this.#length;
          part.textContent = named ? word(kind) : "";
          part.title = spans[k] ?? "";
          part.style.left = `${100 * (from - this.#begin) / this.#length}%`;
          part.style.width = `${100 * (until - from) / this.#length}%`;
        }
        for (const [k, edge] of [...row.querySelectorAll(".carts-measured-edge")].entries())
          this.#value(edge, cart, k);
      }
    }
    #value(edge, cart, k) {
      const own = ofCart(this.#segments, cart);
      const [low, high] = limits(this.#segments, cart, k, this.#step);
      const at = Number(own[k]?.until);
      const [first, second] = [word(own[k]?.kind ?? ""), word(own[k + 1]?.kind ?? "")];
      edge.style.left = `${100 * (at - this.#begin) / this.#length}%`;
      put(edge, "aria-label", tr("{cart}: from {first} to {second}", { cart, first, second }));
      put(edge, "aria-valuemin", String(low));
      put(edge, "aria-valuemax", String(high));
      put(edge, "aria-valuenow", String(at));
      put(
        edge,
        "aria-valuetext",
        tr("{first} until {time} s, then {second}", { first, second, time: seconds(at) })
      );
    }
    #stack() {
      for (const row of this.place.querySelectorAll(".carts-measured-strip-row")) {
        const width = row.getBoundingClientRect().width || USUAL2;
        const edges = [
          ...row.querySelectorAll(".carts-measured-edge")
        ];
        const rows = lanes(
          edges.map((edge) => Number.parseFloat(edge.style.left) / 100 * width),
          WIDE
        );
        for (const [k, edge] of edges.entries()) edge.style.setProperty("--lane", String(rows[k]));
        row.style.setProperty(
          "--lanes",
          String(Math.max(0, ...rows) + 1)
        );
      }
    }
    #focus(cart, at) {
      const off = (edge) => Math.abs(Number(edge.getAttribute("aria-valuenow")) - at);
      const within = this.#row(cart) ?? this.place;
      const edges = [...within.querySelectorAll(".carts-measured-edge")];
      const nearest = edges.sort((a, b) => off(a) - off(b))[0];
      if (nearest instanceof HTMLElement) nearest.focus();
    }
  };

  // src/measured/element.js
  function measuredElement(client, base) {
    return class CartsMeasured extends HTMLElement {
      #facts = null;
      #kept = {};
      #read = null;
      report = null;
      // of the last fit
      complete = Promise.resolve();
      #asking = new Asking(
        client,
        () => ({ ...this.#given, ...this.settings?.asked, segments: this.strip?.given ?? [] }),
        () => this.setAttribute("data-state", "live")
      );
      #tried = false;
      // a fit of these readings, refused or not: a boundary that is moved asks for it again
      #leaving = new AbortController();
      // ends what the element hears of the worker
      connectedCallback() {
        this.#leaving = new AbortController();
        if (this.#facts) return whenLive(this, client, this.#leaving.signal);
        this.#facts = JSON.parse(need(this, ".carts-measured-baked").textContent ?? "");
        const facts = this.#facts;
        this.keeper = keeper(facts.id, this);
        this.picture = new Picture(this);
        this.hands = new Hands(this, () => this.#moved());
        this.settings = new Settings(this, (again) => this.#changed(again));
        this.source = new Source(
          need(this, ".carts-measured-source"),
          (name, texts, same) => this.#take(name, texts, same),
          () => this.#keep(),
          (text2) => this.#refuse(text2 ? [{ line: null, reason: text2, hint: "" }] : []),
          (zip) => this.#asking.ask("unzip", { zip }),
          base
        );
        this.strip = new Strip(
          need(this, ".carts-measured-spans"),
          () => void (this.#tried ? this.fit(this.#kept.fitted === "compared") : this.#early())
        );
        this.picture.watch = (time, places) => this.source?.films.at(time, places);
        wireButtons(this, {
          own: () => this.source?.take("", []),
          save: () => this.source?.save(this.#name, this.#given.texts),
          fit: () => void this.fit(),
          compare: () => void this.fit(true),
          tracker: () => this.#asking.ask("tracker"),
          early: () => void client.need(PACKAGES).catch(() => {
          })
        });
        if (facts.read) this.#show(facts.read, null);
        this.complete = this.#restore();
      }
      disconnectedCallback() {
        this.#leaving.abort();
        this.picture?.player.pause();
        this.source?.films.end();
      }
      async #restore() {
        this.#kept = { ...empty(this.#facts), ...await this.keeper?.get() };
        this.settings?.fill(this.#kept);
        if (this.strip) this.strip.given = this.#kept.segments ?? [];
        this.source?.open(this.#kept);
        return this.#given.texts.length ? this.#anew() : whenLive(this, client, this.#leaving.signal);
      }
      async #anew() {
        const { hand, fitted, texts } = this.#kept;
        await this.#reading();
        if (this.#kept.texts !== texts) return;
        if (fitted) await this.#fit(fitted === "compared");
        else if (hand && this.hands && this.#read?.kind === "length") {
          this.hands.value = hand;
          await this.#byHand();
        }
      }
      get #given() {
        return readings(this.#kept, this.#facts);
      }
      get #name() {
        return this.#kept.name || this.#facts?.name || "";
      }
      #take(name, texts, same = "") {
        const other = same !== "clock";
        Object.assign(this.#kept, { name, texts }, other && { fitted: "", hand: null });
        this.settings?.clear(usual(texts, this.#facts), same);
        if (other) this.strip?.clear();
        this.complete = this.#anew();
      }
      #changed(again) {
        this.#kept.fitted = "";
        if (!again) return this.#moved();
        this.strip?.clear();
        this.complete = this.#reading();
      }
      #moved() {
        if (this.#read?.kind === "length") this.complete = this.#byHand();
      }
      #keep() {
        const segments = this.strip?.given ?? [];
        this.#kept = { ...this.#kept, ...this.settings?.kept, ...this.source?.typed, segments };
        this.keeper?.put(structuredClone(this.#kept));
      }
      async #newest(what, more, show) {
        try {
          const found = await this.#asking.newest(what, more);
          if (!found) return false;
          this.#refuse(found.refused ?? [], what);
          const story = found.report ?? found;
          if (story.segments) this.strip?.show(story, this.#read?.tracks[0].t);
          if (found.refused) return false;
          this.picture?.note("");
          show(found);
          return true;
        } catch (error) {
          this.#note(error.message);
          return false;
        }
      }
      async #reading() {
        this.#keep();
        if (!this.#given.texts.length) return;
        await this.#newest("read", {}, (found) => this.#show(found, found));
        this.dispatchEvent(new CustomEvent("carts-measured"));
      }
      async #early() {
        const read = this.#read;
        this.#keep();
        const found = await happened(client, this.#asking);
        if (found?.segments && this.#read === read && !this.#tried)
          this.strip?.show(found, read.tracks[0].t);
      }
      #show(found, drawn) {
        const read = { ...found, chosen: this.settings?.chosen ?? null };
        this.#read = read;
        this.#tried = false;
        this.settings?.offer(read);
        this.report = read.report ?? null;
        const left = drawn ? missing(read) : "";
        if (left) this.#refuse([{ line: null, reason: left, hint: "" }]);
        const motion = read.kind === "length" && !left && drawn !== null;
        this.strip?.show(null);
        this.picture?.readings(this.#name, read, motion);
        if (!motion) return;
        this.hands?.reach(read.tracks, read.names);
        this.settings?.named(read.names);
        if (this.hands) this.hands.value = drawn.parameters;
        this.picture?.draw(read, drawn);
        if (this.#kept.texts.length && !this.#kept.fitted) void this.#early();
      }
      async #byHand() {
        if (!this.hands) return;
        this.#kept.hand = this.hands.value;
        this.#kept.fitted = "";
        this.#keep();
        await this.#newest("model", { hand: this.hands.value }, (drawn) => {
          this.picture?.forget();
          this.picture?.draw(this.#read, drawn);
        });
      }
      fit(compare = false) {
        this.complete = this.#fit(compare).then(() => this.picture?.turn());
        return this.complete;
      }
      async #fit(compare) {
        this.#tried = true;
        this.picture?.busy(tr("Starting numpy and scipy …"));
        try {
          await client.need(PACKAGES);
          await this.#asking.ask("ready");
          this.picture?.busy(tr("Fitting …"));
          performance.mark("carts:measured-asked");
          if (!await this.#newest("fit", { compare }, (found) => this.#fitted(found))) return;
          performance.mark("carts:measured-fit");
          this.#kept.fitted = compare ? "compared" : "fitted";
          this.#keep();
          this.dispatchEvent(new CustomEvent("carts-fitted"));
        } catch (error) {
          this.#note(error.message);
        } finally {
          this.picture?.busy("");
        }
      }
      #fitted(found) {
        this.report = found.report;
        if (this.hands) this.hands.value = found.parameters;
        this.#kept.hand = found.parameters;
        this.picture?.draw(this.#read, found);
        this.picture?.told(found.report);
      }
      #refuse(faults, what = "") {
        this.picture?.refuse(this.#name, faults, what);
      }
      #note(text2) {
        this.picture?.note(tr("Python cannot do this here: {text}", { text: text2 }));
        if (client.state === "failed") this.dataset.state = "failed";
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
    const asked = addresses.map((one) => caches.match(one, { ignoreSearch: true }));
    return (await Promise.all(asked).catch(() => [null])).every(Boolean);
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
  var PATIENCE3 = 8;
  var AT_WORK = 60;
  var LOST = 60;
  var HELD = 180;
  function watch(patience, late) {
    let [left, spent] = [patience, 0];
    const timer = setInterval(() => {
      left -= 1;
      spent += 1;
      if (left > 0) return;
      clearInterval(timer);
      late();
    }, SECOND);
    return {
      get spent() {
        return spent;
      },
      progress() {
        left = patience;
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
      const script2 = document.createElement("script");
      script2.src = src;
      script2.async = true;
      const missing3 = () => reject(new RuntimeFailure("payload-missing", src, name));
      const settle = (then) => () => {
        held?.stop();
        script2.remove();
        then();
      };
      const held = isOnWeb() ? watch(HELD, settle(missing3)) : null;
      script2.onload = settle(resolve);
      script2.onerror = settle(() => {
        if (isLeaving()) staying().then(() => runOnce(src, name).then(resolve, reject));
        else missing3();
      });
      document.head.append(script2);
    });
  }
  function indexOf(base) {
    return new URL(`index.js${new URL(base).search}`, base).href;
  }
  function patiently(promise) {
    if (isOnWeb()) return promise;
    return new Promise((resolve, reject) => {
      const waiting2 = watch(PATIENCE3, () => reject(new RuntimeFailure("stalled", "index.js")));
      promise.then(resolve, reject).finally(waiting2.stop);
    });
  }
  function loadIndex(base) {
    const known = indexes.get(base);
    if (known) return known;
    const inside = Boolean(page.__cartsInside);
    const read = inside ? Promise.resolve() : patiently(runScript(indexOf(base), "index.js"));
    const loading = read.then(() => {
      const index = page.__cartsRuntime;
      if (!inside) delete page.__cartsRuntime;
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
    const inside = Boolean(page.__cartsInside);
    if (!inside) await runScript(address, name);
    const key = `${name}.${number}`;
    const text2 = page.__cartsParts?.[key];
    if (text2 === void 0) throw new RuntimeFailure("payload-damaged", part.src, name);
    if (!inside) delete page.__cartsParts[key];
    const bytes = decode(text2, part.src, name);
    if (bytes.length !== part.size || !await matches(bytes, part.sha256)) {
      throw new RuntimeFailure("payload-damaged", part.src, name);
    }
    return bytes;
  }
  function decode(text2, src, name) {
    try {
      const fast = Uint8Array;
      return fast.fromBase64 ? fast.fromBase64(text2) : Uint8Array.from(atob(text2), (letter) => letter.charCodeAt(0));
    } catch {
      throw new RuntimeFailure("payload-damaged", src, name);
    }
  }
  async function matches(bytes, sha256) {
    if (!globalThis.crypto?.subtle) return true;
    const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
    return [...digest].map((byte) => byte.toString(16).padStart(2, "0")).join("") === sha256;
  }
  async function gunzip(parts) {
    const zip = new DecompressionStream("gzip");
    const writer = zip.writable.getWriter();
    const written2 = Promise.all([...parts.map((part) => writer.write(part)), writer.close()]);
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
    async unpack(name, parts) {
      const unpacked = new Promise((resolve) => this.waiting.set(name, resolve));
      for (const [number, part] of parts.entries()) {
        const bytes = await part;
        this.worker.postMessage({ name, bytes, last: number === parts.length - 1 }, [bytes.buffer]);
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
  async function compile(parts) {
    const zip = new DecompressionStream("gzip");
    const headers = { "Content-Type": "application/wasm" };
    const compiled = WebAssembly.compileStreaming(new Response(zip.readable, { headers }));
    const written2 = write2(zip.writable.getWriter(), parts);
    const [module] = await Promise.all([compiled, written2]);
    return module;
  }
  async function write2(writer, parts) {
    for (const part of parts) await writer.write(await part);
    await writer.close();
  }

  // as-text:src/runtime/worker.js
  var worker_default = '"use strict";\n(() => {\n  // src/runtime/memory.js\n  var isOutOfMemory = (error) => error instanceof RangeError || /memory|allocat/i.test(String(error));\n  var isNotAllocated = (error) => error instanceof RangeError && /memory|allocat/i.test(error.message);\n\n  // src/runtime/picture.js\n  function putPicture(memory, picture) {\n    const words = new Uint32Array(picture.buffer, picture.byteOffset, picture.byteLength >> 2);\n    const [size, filled, sum, count] = words;\n    if (memory.length !== size) throw new Error(`${memory.length} bytes of memory, not ${size}`);\n    const stretches = words.subarray(4, 4 + 2 * count);\n    if (sumBetween(memory, stretches, filled) !== sum) throw new Error("another machine code");\n    let from = 4 * (4 + 2 * count);\n    let last = filled;\n    for (let i = 0; i < stretches.length; i += 2) {\n      const [start, end] = stretches.subarray(i, i + 2);\n      if (start > last) memory.fill(0, last, start);\n      memory.set(picture.subarray(from, from + end - start), start);\n      from += end - start;\n      last = Math.max(last, end);\n    }\n  }\n  function sumBetween(memory, stretches, filled) {\n    const words = new Uint32Array(memory.buffer, memory.byteOffset, memory.byteLength >> 2);\n    let sum = 0;\n    let at = 0;\n    for (let i = 0; i <= stretches.length && at < filled; i += 2) {\n      const start = Math.min(stretches[i] ?? filled, filled);\n      for (let word = at >> 2; word < start >> 2; word += 1) sum = sum + words[word] >>> 0;\n      at = stretches[i + 1] ?? filled;\n    }\n    return sum;\n  }\n\n  // src/runtime/wheel.js\n  var END = 101010256;\n  var ENTRY = 33639248;\n  var END_BYTES = 22;\n  var ENTRY_BYTES = 46;\n  var LOCAL_BYTES = 30;\n  function entries(archive) {\n    const view = new DataView(archive.buffer, archive.byteOffset, archive.byteLength);\n    const end = archive.length - END_BYTES;\n    if (end < 0 || view.getUint32(end, true) !== END) return null;\n    const found = /* @__PURE__ */ new Map();\n    const text = new TextDecoder();\n    let at = view.getUint32(end + 16, true);\n    for (let left = view.getUint16(end + 10, true); left > 0; left -= 1) {\n      if (view.getUint32(at, true) !== ENTRY || view.getUint16(at + 10, true) !== 0) return null;\n      const [name, extra, comment] = [28, 30, 32].map((place) => view.getUint16(at + place, true));\n      const local = view.getUint32(at + 42, true);\n      const skipped = view.getUint16(local + 26, true) + view.getUint16(local + 28, true);\n      const from = local + LOCAL_BYTES + skipped;\n      const bytes = archive.subarray(from, from + view.getUint32(at + 24, true));\n      found.set(text.decode(archive.subarray(at + ENTRY_BYTES, at + ENTRY_BYTES + name)), bytes);\n      at += ENTRY_BYTES + name + extra + comment;\n    }\n    return found;\n  }\n  function unpackByOurselves(python2) {\n    const api = python2._api;\n    const usual = api.package_loader;\n    const unpack = (given) => {\n      const { buffer, extract_dir } = given;\n      const files2 = entries(buffer);\n      if (!files2) return usual.unpack_buffer.callKwargs(given);\n      const folder = String(extract_dir);\n      const made = /* @__PURE__ */ new Set();\n      for (const [name, bytes] of files2) {\n        const path = `${folder}/${name}`;\n        const parent = path.slice(0, path.lastIndexOf("/"));\n        if (!made.has(parent)) python2.FS.mkdirTree(parent);\n        made.add(parent);\n        python2.FS.writeFile(path, bytes, { canOwn: true });\n      }\n      return [...files2.keys()].filter((name) => name.endsWith(".so")).map((name) => `${folder}/${name}`);\n    };\n    api.package_loader = {\n      get_install_dir: (where) => usual.get_install_dir(where),\n      unpack_buffer: { callKwargs: unpack }\n    };\n  }\n\n  // src/runtime/worker.js\n  var scope = self;\n  var BASE = "https://runtime.invalid/";\n  var WASM = "pyodide.asm.wasm";\n  var STDLIB = "python.zip";\n  var SNAPSHOT = "memory.snapshot";\n  var MORE = "python-more.zip";\n  var stdlib;\n  var files = /* @__PURE__ */ new Map();\n  var python;\n  var answer;\n  var current = 0;\n  var seen = Number.NEGATIVE_INFINITY;\n  var tell = (message, transfer = []) => scope.postMessage(message, transfer);\n  var fail = (reason, error, name = "") => tell({ tell: "failed", reason, detail: String(error), file: name });\n  var progress = (stage) => tell({ tell: "progress", stage });\n  function file(name) {\n    const known = files.get(name);\n    if (known) return known;\n    let take = (_) => {\n    };\n    const come = new Promise((resolve) => {\n      take = resolve;\n    });\n    const made = { come, take };\n    files.set(name, made);\n    return made;\n  }\n  var bytesOf = (name) => file(name).come;\n  scope.fetch = async (address) => {\n    const name = String(address).split("/").pop() ?? "";\n    if (name === WASM) return new Response();\n    if (name === STDLIB) return stdlib;\n    return new Response(await bytesOf(name));\n  };\n  async function wholeStdlib(tableAt) {\n    if (!tableAt) return new Response(await bytesOf(STDLIB));\n    const [first, more] = await Promise.all([bytesOf(STDLIB), bytesOf(MORE)]);\n    const whole = new Uint8Array(tableAt + more.length);\n    whole.set(first.subarray(0, tableAt));\n    whole.set(more, tableAt);\n    return new Response(whole);\n  }\n  var giveWasm = () => {\n  };\n  var wasm = new Promise((resolve) => {\n    giveWasm = resolve;\n  });\n  function useCompiledWasm() {\n    const api = WebAssembly;\n    api.instantiateStreaming = async (_, imports) => {\n      const module = await wasm;\n      try {\n        return { module, instance: await WebAssembly.instantiate(module, imports) };\n      } catch (error) {\n        fail(isOutOfMemory(error) ? "no-memory" : "too-old", error);\n        throw error;\n      }\n    };\n  }\n  scope.addEventListener("unhandledrejection", ({ reason }) => {\n    if (isNotAllocated(reason)) fail("no-memory", reason);\n  });\n  async function boot({ lock, snapshot, tableAt, load, modules, entry }) {\n    try {\n      useCompiledWasm();\n      stdlib = wholeStdlib(tableAt);\n      const { loadPyodide, createPyodideModule } = scope.__pyodide;\n      python = await loadPyodide({\n        indexURL: BASE,\n        packageBaseUrl: BASE,\n        stdLibURL: BASE + STDLIB,\n        lockFileContents: lock,\n        createPyodideModule,\n        _loadSnapshot: snapshot ? bytesOf(SNAPSHOT) : void 0,\n        _putPicture: putPicture,\n        args: [],\n        env: { HOME: "/home/pyodide" }\n      });\n      python._api.config._loadSnapshot = void 0;\n      progress("python");\n      if (snapshot) reseed();\n      tellOfImports();\n    } catch (error) {\n      if (isNotAllocated(error)) return fail("no-memory", error);\n      return fail(snapshot ? "snapshot-refused" : "python-failed", error);\n    }\n    try {\n      if (load.length) await loadPackages(load);\n      for (const name of modules) {\n        importIfPossible(name);\n        progress(name);\n      }\n      const module = python.pyimport(entry);\n      module.listen?.(alive);\n      answer = module.answer;\n    } catch (error) {\n      return fail("python-failed", error);\n    }\n    files.clear();\n    return tell({ tell: "ready", start: snapshot ? "snapshot" : "plain" });\n  }\n  function reseed() {\n    python.runPython(`\nimport sys\nif "random" in sys.modules:\n    sys.modules["random"].seed()\n`);\n  }\n  function alive() {\n    if (performance.now() - seen < 1e3) return;\n    seen = performance.now();\n    if (current) tell({ tell: "alive", number: current });\n    else progress("packages");\n  }\n  function tellOfImports() {\n    const locals = python.toPy({ alive });\n    python.runPython(\n      `\nimport sys\nclass Alive:\n    @staticmethod\n    def find_spec(name, path=None, target=None, alive=alive):\n        alive()\nsys.meta_path.insert(0, Alive)\n`,\n      { globals: locals }\n    );\n  }\n  async function loadPackages(names) {\n    unpackByOurselves(python);\n    const alive2 = setInterval(() => progress("packages"), 1e3);\n    try {\n      await python.loadPackage(names, { messageCallback: () => {\n      } });\n    } finally {\n      clearInterval(alive2);\n    }\n    progress("packages");\n  }\n  function importIfPossible(name) {\n    try {\n      python.pyimport(name).destroy();\n    } catch (error) {\n      if (\n        /** @type {any} */\n        error?.type !== "ModuleNotFoundError"\n      ) throw error;\n    }\n  }\n  function respond({ number, text }) {\n    tell({ tell: "begun", number });\n    current = number;\n    try {\n      const [header, numbers] = answer(text);\n      tell({ tell: "answer", number, header, numbers }, [numbers.buffer]);\n    } catch (error) {\n      tell({ tell: "broken", number, detail: String(error), dead: isDead() });\n    }\n  }\n  function isDead() {\n    try {\n      return python.runPython("1") !== 1;\n    } catch {\n      return true;\n    }\n  }\n  scope.onmessage = ({ data }) => {\n    if (data.do === "boot") boot(data);\n    else if (data.do === "file") file(data.name).take(new Uint8Array(data.bytes));\n    else if (data.do === "wasm") giveWasm(data.module);\n    else if (data.do === "request") respond(data);\n  };\n  tell({ tell: "hello" });\n})();\n';

  // src/runtime/start.js
  var SLOW = "slow";
  var SLOW_LINE = "slow-line";
  var SNAPSHOT = "memory.snapshot";
  var LOADER = "pyodide.js";
  var WASM = "pyodide.asm.wasm";
  var STDLIB = "python.zip";
  var MORE = "python-more.zip";
  async function slowStage(files, folder) {
    const kept = !isFetching() || await areKept(files.map((file) => new URL(file, folder)));
    return kept ? SLOW : SLOW_LINE;
  }
  var modules = /* @__PURE__ */ new Map();
  var Start = class {
    constructor({ folder, index, packages, onProgress, patience = LOST }, snapshot) {
      this.folder = folder;
      this.index = index;
      this.packages = packages;
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
      const { index, packages, snapshot } = this;
      const names = modules.has(this.folder) ? [LOADER] : [LOADER, WASM];
      if (snapshot) names.push(SNAPSHOT);
      names.push(STDLIB);
      if (packages.length && index.tableAt) names.push(MORE);
      names.push(...this.toLoad().map((name) => index.wheels[name]));
      if (names.every((name) => name in index.files)) return names;
      throw new RuntimeFailure("not-packed", index.missing || packages.join());
    }
    toLoad() {
      const { index, packages, snapshot } = this;
      if (!snapshot) return [index.package, ...packages];
      return packages.length && index.later.length ? [index.rest, ...packages] : packages;
    }
    async run() {
      let reject = () => {
      };
      const failed = new Promise((_, no) => {
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
        const parts = this.names.flatMap((name) => this.index.files[name].parts);
        const stage = loading ? await slowStage(
          parts.map((part) => part.src),
          this.folder
        ) : SLOW;
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
      const { index, packages, snapshot } = this;
      worker.postMessage({
        do: "boot",
        lock: index.lock,
        entry: index.entry,
        snapshot,
        tableAt: packages.length ? index.tableAt : 0,
        load: this.toLoad(),
        modules: packages.length ? [...packages, ...index.later] : []
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
    async module(parts) {
      const module = modules.get(this.folder) ?? await compile(parts);
      modules.set(this.folder, module);
      return module;
    }
  };

  // src/runtime/runtime.js
  var PICK_UP = 3;
  var LONG = ["certify", "class", "cost", "hard", "law", "measured", "relevance", "teach"];
  async function startRuntime({ base, packages = [], patience, onProgress = () => {
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
    const options = { folder, index, packages: order(packages), onProgress, patience };
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
  var order = (packages) => [
    ...new Set(packages.flatMap((name) => name === "scipy" ? ["numpy", "scipy"] : [name]))
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
        const patience = LONG.includes(String(message.kind)) ? AT_WORK : PATIENCE3;
        const text2 = JSON.stringify(message);
        this.queue.push({ number: this.number, text: text2, patience, resolve, reject });
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
  function pagePython(packages) {
    const base = besideScript("runtime/");
    const onProgress = ({ stage }) => {
      if (stage === SLOW || stage === SLOW_LINE) client.dispatchEvent(new Event(stage));
    };
    const client = new Client(
      (more) => startRuntime({ base, packages: [...packages(), ...more], onProgress })
    );
    client.addEventListener("state", () => tell(client.state));
    return client;
  }
  function besideScript(folder) {
    const script2 = document.currentScript;
    const own = new URL(script2?.src || document.baseURI);
    return new URL(`${folder}${own.search}`, own).href;
  }
  function startWhenIdle(client) {
    tell("starting");
    if (typeof requestIdleCallback === "function") {
      requestIdleCallback(() => client.wake(), { timeout: 1e3 });
    } else setTimeout(() => client.wake(), 200);
  }
  function tell(state) {
    document.documentElement.dataset.python = state;
  }

  // src/shared/features.js
  function missingFeatures() {
    const needed = [
      ["WebAssembly", typeof WebAssembly === "object"],
      [tr("workers"), typeof Worker === "function"],
      [tr("decompression"), typeof DecompressionStream === "function"]
    ];
    return needed.filter(([, there]) => !there).map(([name]) => name);
  }

  // src/measured-main.js
  var MEASURED = "newtons-carts-measured";
  var script = document.currentScript;
  var missing2 = missingFeatures();
  if (missing2.length) {
    for (const note of document.querySelectorAll("carts-measured .carts-note")) {
      note.hidden = false;
      note.textContent = `This browser is too old to fit the readings (missing: ${missing2.join(", ")}); Chrome or Edge 103, Firefox 113, Safari 16.4 or newer can. On the command line “carts fit” does the same.`;
    }
  } else {
    const client = pagePython(() => [MEASURED]);
    const base = script?.src || document.baseURI;
    customElements.define("carts-measured", measuredElement(client, base));
    startWhenIdle(client);
  }
})();
