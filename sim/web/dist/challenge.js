"use strict";
(() => {
  // ../view/language.js
  var catalogue = globalThis.cartsWords ?? {};
  var RULE = catalogue["\0"] ?? "";
  function tr(sentence, values = {}) {
    return filled(catalogue[sentence] ?? sentence, values);
  }
  function inRow(parts) {
    const [head = "", ...tail] = parts;
    return tail.reduce((first, second) => tr("{first}, {second}", { first, second }), head);
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
      const [digits = "", tens] = Math.abs(value2).toExponential(figures - 1).split("e");
      return `${value2 < 0 ? "−" : ""}${trim(digits)} × 10${superscript(Number(tens))}`;
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
    const found2 = root.querySelector(selector);
    if (!found2) throw new Error(`this page lacks ${selector}; it was built by another version`);
    return found2;
  }

  // src/shared/settings.js
  var asText = (settings) => JSON.stringify(Object.entries(settings).sort());

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
  function retain(key, value2, where = TAB) {
    try {
      where().setItem(key, JSON.stringify(value2));
    } catch {
    }
  }

  // src/answers/outline.js
  var found = null;
  function outline() {
    const text = found ? null : document.getElementById("carts-lesson")?.textContent;
    if (text) found = JSON.parse(text);
    return found;
  }
  function itemOf(entry) {
    const form = entry?.form ?? "worksheet";
    return outline()?.items.find((item) => item.id === entry?.id && item.form === form) ?? null;
  }
  function placeOf(entry) {
    if (entry?.type === "challenge") return entry.id;
    return entry?.type === "found-force" ? entry.id.replace(/-forces$/, "") : "";
  }
  function isHere(entry) {
    const place2 = placeOf(entry);
    return Boolean(itemOf(entry) ?? (place2 && document.getElementById(place2)));
  }
  function stamped(entry) {
    const page = outline();
    if (!page || !isHere(entry)) return entry;
    const { form = "worksheet", hash = "" } = itemOf(entry) ?? {};
    return { form, lesson: page.lesson, lessonHash: page.hash, hash, ...entry };
  }

  // src/shared/code-word.js
  var STUDENT = "student";

  // src/answers/entry.js
  var MOST_EARLIER = 500;
  function isEmpty(value2) {
    if (typeof value2 === "string") return !value2.trim();
    if (value2 === null || value2 === void 0) return true;
    return typeof value2 === "object" && Object.keys(value2).length === 0;
  }
  function keepEarlier(old, value2) {
    if (!old || typeof old !== "object" || typeof value2 !== "object" || value2 === null) return value2;
    const opened2 = old.locked && old.locked !== value2.locked;
    if (opened2 && sameAnswer(old, value2)) return { ...together(old, value2), locked: old.locked };
    const same = old.hash === value2.hash && old.type === value2.type;
    if (old.locked && !value2.locked && same) {
      return withEarlier(old, old.earlier, value2.earlier, alone(value2));
    }
    const other = opened2 || old.hash && value2.hash && old.hash !== value2.hash;
    return withEarlier(value2, old.earlier, value2.earlier, other ? alone(old) : []);
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
    const found2 = /* @__PURE__ */ new Map();
    for (const one of lists.flatMap((list) => list ?? [])) {
      const name = JSON.stringify([one.hash, one.value]);
      const before = found2.get(name);
      found2.set(name, before ? together(before, one) : one);
    }
    const all = [...found2.values()];
    all.sort((x, y) => String(x.last ?? "").localeCompare(String(y.last ?? "")));
    return all.length ? { ...entry, earlier: all.slice(-MOST_EARLIER) } : entry;
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
      put: async (key, value2) => localStorage.setItem(before + key, JSON.stringify(keepEarlier(get(key), value2))),
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
    const found2 = await texts.entries().catch(() => []);
    if (found2.length === 0) return;
    const take = () => takeOver(store, texts).catch(() => {
    });
    const taken = Promise.resolve(navigator.locks?.request(`carts-texts:${site}`, take) ?? take());
    const late = new Promise((resolve) => setTimeout(resolve, PATIENCE));
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
      const value2 = both(await store.get(key), text);
      if (value2 === null) continue;
      await store.put(key, value2);
      await texts.remove(key);
    }
  }
  function both(kept2, text) {
    if (kept2 === void 0 || kept2 === null) return text;
    if ("type" in Object(kept2) && "type" in Object(text)) return merged(kept2, text);
    if (!("last" in Object(kept2) && "last" in Object(text))) return null;
    return String(kept2.last) > String(text.last) ? kept2 : text;
  }

  // src/store/newest-first.js
  var GONE = /* @__PURE__ */ Symbol("forgotten");
  function newestFirst(put) {
    const flights = /* @__PURE__ */ new Map();
    function start(key, value2, alone2) {
      const now = put(key, value2, alone2);
      flights.set(key, { now, next: null });
      const over = () => {
        if (flights.get(key)?.now === now && !flights.get(key)?.next) flights.delete(key);
      };
      now.then(over, over);
      return now;
    }
    return (key, value2, alone2 = false) => {
      const flight = flights.get(key);
      if (!flight) return start(key, value2, alone2);
      if (flight.next) {
        flight.next.value = value2;
        flight.next.alone &&= alone2;
        flight.next.anew ||= value2 === GONE;
        return flight.next.written;
      }
      const next = { value: value2, alone: alone2, anew: value2 === GONE, written: Promise.resolve() };
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
      setTimeout(() => reject(new Error("no answer")), PATIENCE2);
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
    const put = newestFirst(
      (key, value2, alone2) => write(begin, (answers) => {
        if (value2 === GONE) answers.delete(key);
        else if (alone2) {
          answers.put(value2, key);
          answers.transaction.commit();
        } else {
          const request = answers.get(key);
          request.onsuccess = () => answers.put(keepEarlier(request.result, value2), key);
        }
      })
    );
    return {
      kind: "kept",
      how: "indexed",
      get: (key) => read((answers) => answers.get(key)),
      put,
      remove: (key) => put(key, GONE),
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
    const page = globalThis;
    const name = /* @__PURE__ */ Symbol.for(`carts-shelter:${site}`);
    page[name] ??= /* @__PURE__ */ new Map();
    return page[name];
  }
  function sheltered(store, site) {
    const refused = shelter(site);
    return {
      ...store,
      put: async (key, value2, alone2) => {
        try {
          await store.put(key, value2, alone2);
          refused.delete(key);
        } catch (error) {
          refused.set(key, keepEarlier(refused.get(key), value2));
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
    const kept2 = shelter(site);
    return {
      kind: "memory",
      how: "memory",
      get: async (key) => kept2.get(key),
      put: async (key, value2) => void kept2.set(key, keepEarlier(kept2.get(key), value2)),
      remove: async (key) => void kept2.delete(key),
      entries: async () => [...kept2]
    };
  }

  // src/store/staying.js
  var asked = false;
  function letItStay() {
    const storage = navigator.storage;
    if (asked || !storage?.persist || location.protocol === "file:") return;
    if (CSS.supports("-moz-appearance", "none")) return;
    asked = true;
    storage.persist().catch(() => {
    });
  }

  // src/store/tabs.js
  function telling(store, site) {
    const channel = channelOf(`carts:${site}`);
    return {
      ...store,
      student: "",
      put: async (key, value2, alone2) => {
        await store.put(key, value2, alone2);
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
  var opened = /* @__PURE__ */ new Map();
  function openAll(site) {
    const found2 = opened.get(site) ?? openOnce(site);
    opened.set(site, found2);
    return found2;
  }
  async function openStore(site) {
    const all = await openAll(site);
    return forStudent(all, await readStudent(all));
  }
  async function readStudent(all) {
    const found2 = await all.get(STUDENT).catch(() => null);
    return typeof found2?.code === "string" ? found2.code : "";
  }
  function forStudent(all, code) {
    const before = code ? `@${code}/` : "";
    const mine = (key) => before ? key.startsWith(before) : !key.startsWith("@") && key !== STUDENT && key !== SETTLED;
    return {
      kind: all.kind,
      how: all.how,
      student: code,
      get: (key) => all.get(before + key),
      put: (key, value2, alone2) => {
        letItStay();
        return all.put(before + key, stamped(value2), alone2);
      },
      remove: (key) => all.remove(before + key),
      hear: (act, signal) => all.hear((key, gone) => mine(key) && act(key.slice(before.length), gone), signal),
      entries: async () => (await all.entries()).filter(([key]) => mine(key)).map(([key, value2]) => [key.slice(before.length), value2])
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
  function place() {
    const { cartsSite, cartsPage } = document.documentElement.dataset;
    const meta = (name) => document.querySelector(`meta[name="${name}"]`)?.getAttribute("content");
    const path = location.pathname.split("/").slice(-2).join("/");
    return {
      site: cartsSite ?? meta("carts-site") ?? "site",
      page: cartsPage ?? meta("carts-page") ?? path
    };
  }

  // src/store/kept.js
  var Kept = class {
    #key = "";
    #store;
    constructor(id) {
      const { site, page } = place();
      this.#key = `${page}#${id}`;
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
    async put(entry) {
      await (await this.#store).put(this.#key, entry);
      document.dispatchEvent(new CustomEvent("carts-kept", { detail: this.#key }));
    }
    async forget() {
      await (await this.#store).remove(this.#key);
      document.dispatchEvent(new CustomEvent("carts-forgotten", { detail: this.#key }));
    }
    async hear(act, signal) {
      (await this.#store).hear(async (key, gone) => {
        if (key !== this.#key) return;
        const found2 = await this.get();
        if (found2 || gone) act(found2);
      }, signal);
    }
  };

  // src/question/challenge-kept.js
  var TYPE = "challenge";
  function triedKeeper(id) {
    const kept2 = new Kept(id);
    return {
      hear: (act, signal) => void kept2.hear(act, signal),
      async get() {
        const entry = await kept2.get();
        const { runs, found: found2, values } = entry?.type === TYPE && entry.value || {};
        if (!Number.isInteger(runs)) return null;
        return { runs, found: Number.isInteger(found2) ? found2 : 0, values: String(values ?? "") };
      },
      async put(asked2, tried, said) {
        if (!outline()) return;
        const now = (/* @__PURE__ */ new Date()).toISOString();
        const first = (await kept2.get())?.first ?? now;
        const entry = { id, type: TYPE, value: tried, first, last: now, tries: tried.runs };
        await kept2.put({ ...entry, asked: asked2, said }).catch(() => {
        });
      }
    };
  }

  // src/shared/waiting.js
  var RESET = "carts-reset";

  // ../view/trajectory.js
  function rowAt(times, t) {
    let low = 0;
    let high = times.length;
    while (low < high) {
      const middle = low + high >> 1;
      if (times[middle] <= t) low = middle + 1;
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
    const at = ((c, i) => c[i]);
    const h = at(times, k + 1) - at(times, k);
    const s = (t - at(times, k)) / h;
    if (!slopes) return at(values, k) + (at(values, k + 1) - at(values, k)) * s;
    const r = 1 - s;
    const found2 = at(values, k) * (1 + 2 * s) * r * r + at(slopes, k) * h * s * r * r + at(values, k + 1) * (1 + 2 * r) * s * s - at(slopes, k + 1) * h * r * s * s;
    return Number.isFinite(found2) ? found2 : at(values, k);
  }
  function turnAfter(times, values, slopes, k) {
    const [before, after] = [Number(slopes?.[k]), Number(slopes?.[k + 1])];
    const [begin, span] = [Number(times[k]), Number(times[k + 1]) - Number(times[k])];
    if (!slopes || !(before * after < 0) || !(span > 0)) return null;
    return hermite(times, values, slopes, k, begin + span * before / (before - after));
  }

  // src/question/marking/own-run.js
  var NOUGHT = 1e-12;
  function reading(run, mass, quantity, at) {
    const [what, ...rest] = quantity.split(".");
    const whose = rest.join(".");
    const column = (what === "p" ? run.v : run[String(what)])?.[whose];
    if (!column?.length) return null;
    const factor = what === "p" ? mass[whose] ?? Number.NaN : 1;
    const slopes = { x: run.v, v: run.a, p: run.a, F: run.dF }[String(what)]?.[whose] ?? null;
    if (at === "largest") {
      let most = 0;
      const take = (value2) => {
        if (Math.abs(value2) > Math.abs(most)) most = value2;
      };
      column.forEach(take);
      for (let k = 0; k < column.length; k += 1) take(turnAfter(run.t, column, slopes, k) ?? 0);
      return most * factor;
    }
    let scale = 0;
    for (const value2 of column) scale = Math.max(scale, Math.abs(value2));
    const t = at === "end" ? run.t[run.t.length - 1] : at === "start" ? run.t[0] : Number(at);
    const found2 = valueAt(run.t, column, slopes, t);
    return Math.abs(found2) <= NOUGHT * scale ? 0 : found2 * factor;
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
      const found2 = FACTOR.exec(text);
      if (!found2 || at === 0 && found2[1]) return null;
      const power = number(lowered(found2[3] ?? "") || found2[4] || found2[5] || "1");
      const symbol = String(found2[2]);
      powers.set(symbol, (powers.get(symbol) ?? 0) + (found2[1] === "/" ? -power : power));
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
  var GROUPED = /^[+-]?[1-9]\d{0,2}(,\d{3})+(?![\d,])(\.\d*)?/;
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

  // src/question/marking/typed-number.js
  var LONGEST2 = 40;
  var NUMBER = /^([+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?)\s*(.*)$/;
  var INTERVAL = /^\(?(.+?)\s*(?:±|\+\/?-)\s*[\d.,]+\)?/;
  function readNumber(typed, units) {
    const text = withExponent(tidy(typed)).replace(INTERVAL, "$1");
    if (!text) return { problem: tr("Type a number, for example 0.5") };
    if (text.length > LONGEST2) return { problem: tr("That is too long for a number.") };
    const grouped2 = twoReadings(text);
    if (grouped2) return { problem: grouped2 };
    const found2 = NUMBER.exec(text);
    if (!found2 || /^[.,]/.test(found2[2] ?? ""))
      return { problem: tr("“{text}” is not a number. Type for example 0.5", { text }) };
    const number2 = String(found2[1]);
    const unit = (found2[2] ?? "").replace(/(.)\.$/, "$1").replace(/\bK[gG]\b/, "kg");
    const known = Object.keys(units).filter(Boolean);
    const own = unit ? known.find((one) => sameUnit(one, unit)) : "";
    const factor = unit ? own ? units[own] : void 0 : 1;
    if (factor === void 0) return { problem: unfit(unit, units) };
    const value2 = Number((Number(number2.replace(",", ".")) * factor).toPrecision(15));
    return Number.isFinite(value2) ? { value: value2 } : { problem: tr("{text} is too large.", { text }) };
  }
  function unfit(unit, units) {
    if (/^\/\s*\d/.test(unit))
      return tr("A fraction is not read here: work it out and type for example 0.5");
    const [own = "", ...others] = Object.keys(units);
    if (!own) return tr("“{unit}” does not fit here: it is a number without a unit.", { unit });
    const close = (one) => one.replace(/\s/g, "");
    const told2 = [own, ...others].filter(
      (one, place2, all) => one && (one === own || !one.includes("⁻")) && !all.slice(0, place2).some((other) => close(other) === close(one))
    );
    return tr("“{unit}” does not fit here. Units: {units}", { unit, units: told2.join(", ") });
  }

  // src/question/forms/run.js
  var KILOGRAMS = { kg: 1, g: 1e-3, mg: 1e-6, t: 1e3 };
  var changes = /* @__PURE__ */ new WeakMap();
  document.addEventListener("carts-update", (event) => {
    const { target, detail } = event;
    if (target instanceof Element) changes.set(target, detail);
  });
  document.addEventListener(RESET, ({ target }) => {
    if (target instanceof Element) changes.delete(target);
  });
  function setBy(scene) {
    return changes.get(scene) ?? {};
  }
  function masses(scene) {
    const found2 = {};
    const baked = scene?.querySelector("script.carts-baked")?.textContent;
    for (const body of JSON.parse(baked ?? "{}").bodies ?? []) found2[body.name] = body.mass;
    for (const [path, value2] of Object.entries(setBy(scene))) {
      if (!path.endsWith(".mass")) continue;
      const mass = readNumber(String(value2), KILOGRAMS);
      if ("value" in mass) found2[path.slice(0, -".mass".length)] = mass.value;
    }
    return found2;
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
    const [left, right] = [`${name}-`, `-${name}`];
    const others = /* @__PURE__ */ new Set([...Object.keys(run.x), "left", "right"]);
    return Object.keys(run.F).filter(
      (pair) => pair.startsWith(left) && others.has(pair.slice(left.length)) || pair.endsWith(right) && others.has(pair.slice(0, -right.length))
    );
  }
  function largest(quantity, run, mass) {
    const what = quantity.charAt(0);
    const names = Object.keys((what === "p" ? run.v : run[what]) ?? {});
    const all = names.map((name) => reading(run, mass, `${what}.${name}`, "largest") ?? 0);
    return Math.max(0, ...all.map(Math.abs));
  }

  // src/question/plain-text.js
  function plainText(place2) {
    if (!place2) return "";
    const copy = place2.cloneNode(true);
    for (const part of copy.querySelectorAll(".katex-html, annotation")) part.remove();
    for (const part of copy.querySelectorAll("img")) part.replaceWith(part.alt);
    for (const fraction of [...copy.querySelectorAll("mfrac")].reverse()) {
      fraction.textContent = [...fraction.children].map(grouped).join("/");
    }
    return (copy.textContent ?? "").replace(/\s+/g, " ").trim();
  }
  function grouped(side) {
    const text = (side.textContent ?? "").trim();
    return /[+−\-/·\s]/.test(text) ? `(${text})` : text;
  }

  // src/question/challenge.js
  var SETTLED2 = 800;
  var ChallengeElement = class extends HTMLElement {
    #facts = JSON.parse("{}");
    #tries = { before: 0, tried: [], found: null };
    #keeper = null;
    #leaving = new AbortController();
    #timer = 0;
    #restored = Promise.resolve();
    // when what was tried at earlier visits is known
    connectedCallback() {
      this.#facts = JSON.parse(need(this, ".carts-challenge-facts").textContent ?? "{}");
      this.#tries = kept(this.#name);
      this.#leaving = new AbortController();
      const { signal } = this.#leaving;
      for (const kind of ["carts-update", "carts-watched"]) {
        document.addEventListener(kind, (event) => this.#heard(event), { signal });
      }
      this.#show();
      this.#keeper ??= triedKeeper(this.id);
      this.#keeper.hear(() => void this.#restore(), signal);
      this.#restored = this.#restore();
    }
    disconnectedCallback() {
      clearTimeout(this.#timer);
      this.#leaving.abort();
    }
    async #restore() {
      const earlier = await this.#keeper?.get();
      if (!earlier || earlier.runs <= this.#runs) return;
      this.#tries.before = earlier.runs - this.#tries.tried.length;
      if (earlier.found) this.#tries.found ??= { run: earlier.found, values: earlier.values };
      this.#show();
    }
    get #runs() {
      return this.#tries.before + this.#tries.tried.length;
    }
    #heard({ target }) {
      if (!(target instanceof HTMLElement) || target.id !== this.#facts.scene) return;
      clearTimeout(this.#timer);
      this.#timer = setTimeout(() => {
        void this.#restored.then(() => this.#count(target));
      }, SETTLED2);
    }
    #count(scene) {
      const run = scene.trajectory;
      const first = scene.querySelector(".carts-end") !== null;
      if (!run || first && !("watched" in scene.dataset)) return;
      const set = setBy(scene);
      const again = this.#tries.before > 0 && Object.keys(set).length === 0;
      if (again) return;
      const key = asText(set);
      const { tried } = this.#tries;
      if (tried.includes(key)) return;
      tried.push(key);
      const { goal, near } = this.#facts;
      if (!this.#tries.found && isMet(goal, run, masses(scene), near)) {
        this.#tries.found = { run: this.#runs, values: this.#told(set) };
      }
      retain(this.#name, this.#tries);
      const said = this.#show();
      const { found: found2 } = this.#tries;
      const told2 = { runs: this.#runs, found: found2?.run ?? 0, values: found2?.values ?? "" };
      void this.#keeper?.put(plainText(need(this, ".carts-q-ask")), told2, said);
    }
    #told(set) {
      const parts = Object.entries(set).map(([path, value2]) => {
        const { label, unit, per } = this.#facts.labels[path] ?? { label: path, unit: "", per: 1 };
        const shown = typeof value2 === "number" ? `${short(value2 / per)} ${unit}` : String(value2);
        return `${label} ${shown}`.trim();
      });
      return parts.length ? listed(parts) : tr("as the lesson sets it");
    }
    #show() {
      const { found: found2 } = this.#tries;
      const count = String(this.#runs);
      const tries = need(this, ".carts-challenge-tries");
      const words = found2 ? tr("Found in run {run} of {count}.", { run: String(found2.run), count }) : tr("Runs you have tried: {count}. None of them does it.", { count });
      tries.hidden = this.#runs === 0;
      say(tries, words);
      const place2 = need(this, ".carts-challenge-found");
      place2.hidden = !found2;
      if (found2) say(place2, tr("✓ {values}", { values: found2.values }));
      return [words, found2?.values ?? ""].join(" ").trim();
    }
    get #name() {
      return `carts-challenge ${location.pathname}#${this.id}`;
    }
  };
  function kept(name) {
    const { before, tried, found: found2 } = recall(name) ?? {};
    return {
      before: Number.isInteger(before) ? before : 0,
      tried: Array.isArray(tried) ? tried : [],
      found: found2 ?? null
    };
  }

  // src/challenge-main.js
  customElements.define("carts-challenge", ChallengeElement);
})();
