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
  for (const kind of [Array, Float64Array, Uint8Array]) {
    add(kind.prototype, "findLast", findLast);
    add(kind.prototype, "findLastIndex", findLastIndex);
    add(kind.prototype, "at", at);
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
  function counted(one, more, n, values = {}) {
    return filled(form(one, more, n), { n, ...values });
  }
  function form(one, more, n) {
    const ours = catalogue[more]?.split(FORMS);
    if (!ours) return n === 1 ? one : more;
    const english = n === 1 ? 0 : 1;
    const asked2 = RULE ? Number(RULE[n < RULE.length ? n : 100 + n % 100]) : english;
    return String(ours[Math.min(asked2, ours.length - 1)]);
  }
  function filled(template, values) {
    return template.replace(/\{(\w+)\}/g, (whole2, name) => String(values[name] ?? whole2));
  }

  // src/shared/dom.js
  var SVG = "http://www.w3.org/2000/svg";
  function svg(tag, attributes = {}) {
    const made2 = document.createElementNS(SVG, tag);
    for (const [name, value] of Object.entries(attributes)) made2.setAttribute(name, String(value));
    return made2;
  }
  function html(tag, className = "", text = "") {
    const made2 = document.createElement(tag);
    if (className) made2.className = className;
    if (text) made2.textContent = text;
    return made2;
  }
  function put(element, name, value) {
    if (element.getAttribute(name) !== value) element.setAttribute(name, value);
  }
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

  // src/shared/tab.js
  var TAB = () => sessionStorage;
  var OURS = "carts";
  var BROWSER = () => localStorage;
  function recall(key, where = TAB) {
    try {
      return JSON.parse(where().getItem(key) ?? "null");
    } catch {
      return null;
    }
  }
  function recallOnce(key, where = TAB) {
    const kept = recall(key, where);
    try {
      where().removeItem(key);
    } catch {
    }
    return kept;
  }
  function forgetTab() {
    try {
      for (const key of Object.keys(TAB())) if (key.startsWith(OURS)) TAB().removeItem(key);
    } catch {
    }
  }
  function retain(key, value, where = TAB) {
    try {
      where().setItem(key, JSON.stringify(value));
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
    const form2 = entry?.form ?? "worksheet";
    return outline()?.items.find((item2) => item2.id === entry?.id && item2.form === form2) ?? null;
  }
  function placeOf(entry) {
    if (entry?.type === "challenge") return entry.id;
    return entry?.type === "found-force" ? entry.id.replace(/-forces$/, "") : "";
  }
  function isHere(entry) {
    const place2 = placeOf(entry);
    return Boolean(itemOf(entry) ?? (place2 && document.getElementById(place2)));
  }
  function inPageOrder(entries) {
    const places = [...document.querySelectorAll("[id]")].map(({ id }) => id);
    const place2 = (entry) => {
      const at2 = places.indexOf(placeOf(entry) || entry.id);
      return at2 < 0 ? places.length : at2;
    };
    return [...entries].sort(([, one], [, other]) => place2(one) - place2(other));
  }
  function isCurrent(entry) {
    const item2 = itemOf(entry);
    return !item2 || !entry.hash || entry.hash === item2.hash;
  }
  function stamped(entry) {
    const page = outline();
    if (!page || !isHere(entry)) return entry;
    const { form: form2 = "worksheet", hash: hash2 = "" } = itemOf(entry) ?? {};
    return { form: form2, lesson: page.lesson, lessonHash: page.hash, hash: hash2, ...entry };
  }

  // src/answers/bar.js
  var CAME = "carts-just-came";
  var GREETS = 6e3;
  var SHEET = "M3 1.5h7l3 3v10H3zM5.5 7.5h5M5.5 10.5h3";
  function sheet() {
    const drawn = svg("svg", {
      class: "carts-bar-sheet",
      viewBox: "0 0 16 16",
      width: 18,
      height: 18,
      "aria-hidden": "true"
    });
    drawn.append(svg("path", { d: SHEET }));
    return drawn;
  }
  var Bar = class {
    constructor(book2, openPanel) {
      this.book = book2;
      this.root = html("aside", "carts carts-bar");
      this.root.setAttribute("aria-label", tr("My answers"));
      this.who = html("button", "carts-bar-who");
      this.who.setAttribute("type", "button");
      this.who.addEventListener("click", openPanel);
      this.meter = document.createElement("progress");
      this.count = html("span", "carts-bar-count");
      this.count.title = tr("answered on this page, predictions too");
      this.meter.setAttribute("aria-label", this.count.title);
      const button2 = html("button", "carts-button carts-bar-open");
      button2.append(sheet(), html("span", "carts-bar-name", tr("My answers")));
      button2.setAttribute("type", "button");
      button2.setAttribute("aria-haspopup", "dialog");
      button2.addEventListener("click", openPanel);
      this.warning = html("p", "carts-bar-warning");
      this.warning.setAttribute("role", "alert");
      this.warning.hidden = true;
      const row = html("div", "carts-bar-row");
      row.append(this.who, this.meter, this.count, button2);
      this.root.append(this.warning, row);
      if (!outline()) this.root.classList.add("carts-bar-small");
      this.onPaper = html("p", "carts-print-head");
      const main = document.querySelector("main, article") ?? document.body.firstChild;
      if (outline()) main?.before(this.onPaper);
      book2.addEventListener("change", () => this.show());
      void book2.ready.then(() => {
        this.show();
        this.root.dataset.ready = "";
        this.#place();
        this.#greet();
      });
    }
    #place() {
      const title = outline() ? null : document.querySelector(".md-header__title");
      if (title) title.after(this.root);
      else document.body.append(this.root);
    }
    #greet() {
      const { student } = this.book;
      if (recallOnce(CAME) !== student) return;
      const told2 = html("p", "carts-bar-told");
      told2.setAttribute("role", "status");
      this.root.prepend(told2);
      const words3 = student ? tr("These are the answers of {student}.", { student }) : tr("Cleared. The next student can begin.");
      setTimeout(() => say(told2, words3), 0);
      setTimeout(() => told2.remove(), GREETS);
    }
    show() {
      const { done, of } = this.book.progress(practised());
      this.meter.hidden = of === 0;
      this.meter.max = of || 1;
      this.meter.value = done;
      say(this.count, of ? tr("{part} of {all}", { part: done, all: of }) : "");
      this.count.dataset.short = of ? `${done}/${of}` : "";
      say(this.who, this.book.student || (outline() ? tr("no code word yet") : ""));
      this.who.hidden = !this.who.textContent;
      const code = this.book.student;
      say(this.onPaper, tr("Code word: {code}", { code: code || "____________________" }));
      const warning = this.#warning();
      say(this.warning, warning);
      this.warning.hidden = !warning;
    }
    #warning() {
      if (!outline()) return "";
      if (this.book.refused) {
        return tr("This browser refuses to keep more. Press “My answers” and save your file now.");
      }
      if (this.book.unread) {
        return tr(
          "What you answered before could not be opened. It is not lost: close other windows and load the page again."
        );
      }
      if (!this.book.lasts) {
        return tr(
          "This browser keeps nothing: your answers are lost when you close the page. Save your file before you leave."
        );
      }
      return "";
    }
  };
  function practised() {
    const quizzes = document.querySelectorAll('carts-quiz[data-mode="practice"]');
    return [...quizzes].map((quiz) => quiz.dataset.form ?? "");
  }

  // src/shared/code-word.js
  var STUDENT = "student";
  function codeWord(typed) {
    const parts = typed.normalize("NFKC").toUpperCase().split(/[+&]/).map((part2) => part2.trim().replace(/[\s–—−_]+/g, "-"));
    return [...new Set(parts)].sort().join("+");
  }

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
    const said = Object.entries(young).filter(([, part2]) => (part2 ?? "") !== "");
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
    function start(key, value, alone2) {
      const now = put2(key, value, alone2);
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
    const read = async (ask2) => answered(ask2((await begin("readonly")).objectStore(STORE)));
    const put2 = newestFirst(
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
  async function write(begin, act) {
    await transaction(begin, act, "relaxed");
    clearTimeout(settling);
    settling = setTimeout(() => {
      const mark3 = (answers) => void answers.put(Date.now(), SETTLED);
      transaction(begin, mark3, "strict").catch(() => {
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
    const found2 = opened.get(site) ?? openOnce(site);
    opened.set(site, found2);
    return found2;
  }
  async function readStudent(all) {
    const found2 = await all.get(STUDENT).catch(() => null);
    return typeof found2?.code === "string" ? found2.code : "";
  }
  function writeStudent(all, code) {
    return all.put(STUDENT, { code, last: (/* @__PURE__ */ new Date()).toISOString() });
  }
  function hearStudent(all, act) {
    all.hear((key, gone) => key === STUDENT && !gone && act());
  }
  function forStudent(all, code) {
    const before = code ? `@${code}/` : "";
    const mine = (key) => before ? key.startsWith(before) : !key.startsWith("@") && key !== STUDENT && key !== SETTLED;
    return {
      kind: all.kind,
      how: all.how,
      student: code,
      get: (key) => all.get(before + key),
      put: (key, value, alone2) => {
        letItStay();
        return all.put(before + key, stamped(value), alone2);
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
  function place() {
    const { cartsSite, cartsPage } = document.documentElement.dataset;
    const meta = (name) => document.querySelector(`meta[name="${name}"]`)?.getAttribute("content");
    const path2 = location.pathname.split("/").slice(-2).join("/");
    return {
      site: cartsSite ?? meta("carts-site") ?? "site",
      page: cartsPage ?? meta("carts-page") ?? path2
    };
  }

  // src/answers/optional.js
  var OPTIONAL = "carts-optional";
  function markOptional() {
    let optional = false;
    for (const one of document.querySelector(".md-content__inner")?.children ?? []) {
      if (/^H[12]$/.test(one.tagName)) optional = one.classList.contains("more");
      one.classList.toggle(OPTIONAL, optional);
    }
  }
  function isOptional(id) {
    return Boolean(document.getElementById(id)?.closest(`.${OPTIONAL}`));
  }

  // src/answers/book.js
  var Book = class extends EventTarget {
    student = "";
    store = null;
    all = null;
    #known = /* @__PURE__ */ new Map();
    refused = false;
    unread = false;
    #own = /* @__PURE__ */ new Set();
    #writing = /* @__PURE__ */ new Set();
    constructor() {
      super();
      const { site, page } = place();
      this.site = site;
      this.page = page;
      this.ready = this.#open();
    }
    key(form2, id) {
      return form2 === "worksheet" ? `${this.page}#${id}` : `${this.page}#${form2}:${id}`;
    }
    get(form2, id) {
      return this.#known.get(this.key(form2, id)) ?? null;
    }
    entries() {
      return [...this.#known];
    }
    async put(form2, entry) {
      const blind = !this.store;
      await this.ready;
      const key = this.key(form2, entry.id);
      const blindly = blind || this.unread && !this.#known.has(key);
      const known2 = this.#known.get(key) ?? (blindly ? await this.#before(key) : void 0);
      const full = (blindly ? merged : keepEarlier)(known2, { ...entry, form: form2 });
      this.#known.set(key, full);
      const work = this.#write(key, full);
      this.#writing.add(work);
      try {
        await work;
      } finally {
        this.#writing.delete(work);
        this.#changed();
      }
    }
    async take(student, found2) {
      await this.ready;
      if (!this.all) return 0;
      const mine = student === this.student;
      const theirs = mine && this.store ? this.store : forStudent(this.all, student);
      const here = new Map(await theirs.entries());
      const changed = found2.map(([key, entry]) => ({ key, old: here.get(key), both: merged(entry, here.get(key)) })).filter(({ old, both: both2 }) => JSON.stringify(both2) !== JSON.stringify(old));
      await Promise.all(changed.map(({ key, both: both2 }) => theirs.put(key, both2)));
      for (const { key, both: both2 } of mine ? changed : []) this.#known.set(key, both2);
      await this.#read();
      this.#changed();
      for (const [key] of mine ? found2 : []) {
        this.dispatchEvent(new CustomEvent("elsewhere", { detail: key }));
      }
      return changed.length;
    }
    async become(code, carry = false) {
      await this.ready;
      if (!this.all) return false;
      if (!this.lasts && (carry || this.#known.size === 0)) {
        this.student = code;
        this.dispatchEvent(new Event("student"));
        this.#changed();
        return false;
      }
      if (carry) {
        const mine = forStudent(this.all, this.student);
        const found2 = await mine.entries();
        await this.take(code, found2);
        for (const [key] of found2) await mine.remove(key);
      }
      await writeStudent(this.all, code);
      return true;
    }
    get lasts() {
      return this.store?.how !== "memory";
    }
    async has(code) {
      await this.ready;
      return this.all ? (await forStudent(this.all, code).entries()).length > 0 : false;
    }
    async forget(everybody) {
      await this.ready;
      await Promise.allSettled(this.#writing);
      if (!this.all || !this.store) return;
      const readings = await openAll(`${this.site}${READINGS}`);
      for (const store of [everybody ? this.all : this.store, readings]) {
        for (const [key] of await store.entries()) await store.remove(key);
      }
      await writeStudent(this.all, "");
      this.#known.clear();
    }
    progress(forms = []) {
      const items2 = (outline()?.items ?? []).filter(
        ({ id, form: form2, level, type }) => (form2 === "worksheet" || forms.includes(form2)) && level !== "stretch" && type !== "drawn" && !isOptional(id)
      );
      const done = items2.filter((item2) => {
        const entry = this.get(item2.form, item2.id);
        const predicted = ["arrows", "curve", "choice", "text"].includes(item2.type);
        const unread = item2.type === "number" && typeof entry?.value === "string";
        return entry && isCurrent(entry) && (predicted ? entry.locked : !isEmpty(entry.value) && !unread);
      });
      return { done: done.length, of: items2.length };
    }
    #changed() {
      this.dispatchEvent(new Event("change"));
    }
    async #open() {
      markOptional();
      this.all = await openAll(this.site);
      this.student = await readStudent(this.all);
      this.store = forStudent(this.all, this.student);
      await this.#read();
      this.store.hear((key, gone) => void this.#hear(key, gone));
      hearStudent(this.all, () => this.#leave());
      for (const kind of ["carts-kept", "carts-forgotten"]) {
        document.addEventListener(kind, (event) => {
          void this.#hear(event.detail, kind === "carts-forgotten");
        });
      }
    }
    async #before(key) {
      try {
        return await this.store?.get(key);
      } catch (error) {
        this.refused = true;
        throw error;
      }
    }
    async #read() {
      const found2 = await this.store?.entries().catch(() => null);
      this.unread = !found2 || this.all?.behind === true;
      for (const [key, entry] of found2 ?? []) {
        const known2 = this.#known.get(key);
        if (!known2 || String(known2.last ?? "") <= String(entry?.last ?? "")) {
          this.#known.set(key, entry);
        }
      }
    }
    async refresh() {
      await this.#read();
      this.#changed();
    }
    async #write(key, entry) {
      try {
        await this.store?.put(key, entry, this.#own.has(key));
        this.#own.add(key);
      } catch (error) {
        this.refused = true;
        throw error;
      }
    }
    #leave() {
      forgetTab();
      location.reload();
    }
    async #hear(key, gone) {
      this.#own.delete(key);
      const entry = await this.store?.get(key).catch(() => null);
      if (entry) this.#known.set(key, entry);
      else if (gone) this.#known.delete(key);
      else return;
      this.#changed();
      this.dispatchEvent(new CustomEvent("elsewhere", { detail: key }));
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

  // src/shared/enter.js
  var isEnter = ({ key, isComposing, keyCode }) => key === "Enter" && !isComposing && keyCode !== 229;
  function onEnter(box, act) {
    box?.addEventListener("keydown", (event) => isEnter(event) && !event.repeat && act());
  }

  // src/answers/codes.js
  var MOST = 80;
  var HAN = new RegExp("\\p{Script=Han}", "u");
  function readCode(typed) {
    const code = codeWord(typed);
    const codes = code.split("+");
    if (!typed.trim()) return { problem: tr("Type the code word from your card.") };
    if (code.length > MOST) return { problem: tr("That is too long for a code word.") };
    if (!codes.every((part2) => /^[\p{L}\p{M}\p{N}]+(-[\p{L}\p{M}\p{N}]+)*$/u.test(part2))) {
      return { problem: tr("A code word has letters, digits and hyphens: BLUE-FOX-27") };
    }
    if (codes.some((part2) => part2.length < (HAN.test(part2) ? 2 : 4))) {
      return { problem: tr("A code word has at least four letters or digits.") };
    }
    return { code };
  }

  // src/answers/csv.js
  var COLUMNS = [
    "lesson",
    "form",
    "student",
    "id",
    "type",
    "asked",
    "value",
    "unit",
    "said",
    "sure",
    "tries",
    "first",
    "last",
    "hash"
  ];
  var RISKY = /^\s|^(?!%$)[\u200b-\u200f\u202a-\u202e\u2060-\u2069\ufeff"']*[=+\-@|%＝＋－＠]/u;
  function csvCell(value) {
    if (typeof value === "number" && Number.isFinite(value)) return String(value);
    const text = typeof value === "string" ? value : value === null || value === void 0 ? "" : JSON.stringify(value);
    const clean2 = text.replaceAll("\0", "");
    return `"${(RISKY.test(clean2) ? `'${clean2}` : clean2).replaceAll('"', '""')}"`;
  }
  function csvText(content) {
    const rows2 = content.items.map(
      (item2) => COLUMNS.map(
        (name) => csvCell(
          name in item2 ? item2[name] : ["lesson", "form", "student"].includes(name) ? content[name] : ""
        )
      ).join(",")
    );
    return `\uFEFF${[COLUMNS.join(","), ...rows2].join("\r\n")}\r
`;
  }

  // src/answers/file.js
  var FORMAT = 1;
  var KIND = "newtons-carts-answers";
  var MOST_BYTES = 2e6;
  var MOST_ITEMS = 2e3;
  var LONGEST = 2e4;
  var LARGEST = 1e300;
  var MOST_TRIES = 1e6;
  var TEXTS = ["unit", "sure", "said", "asked", "locked", "again", "why", "now"];
  var FORMS2 = ["worksheet", "pre", "post", "delayed"];
  var ID = /^[a-z_][a-z0-9-]{0,79}$/;
  var HASH = /^[0-9a-f]{12}$/;
  var TIME = /^\d{4}-\d{2}-\d{2}T\d{2}:\d{2}:\d{2}(\.\d{1,3})?Z$/;
  function makeFiles(entries, { site, student }, now) {
    const groups = /* @__PURE__ */ new Map();
    for (const [key, entry] of entries) {
      if (!entry || typeof entry !== "object" || typeof entry.id !== "string") continue;
      const page = key.slice(0, key.lastIndexOf("#"));
      const form2 = FORMS2.includes(entry.form) ? entry.form : "worksheet";
      const lesson = entry.lesson ?? page.split("/").pop() ?? "page";
      const name = `${page} ${form2}`;
      const group = groups.get(name) ?? { lesson, form: form2, page, kept: [] };
      group.kept.push(entry);
      groups.set(name, group);
    }
    return [...groups.values()].map(({ lesson, form: form2, page, kept }) => {
      const last = [...kept].sort((a, b) => String(a.last).localeCompare(String(b.last))).pop();
      const state = kept.find((entry) => entry.type === "form");
      const content = {
        format: FORMAT,
        kind: KIND,
        site,
        lesson,
        lessonHash: last?.lessonHash ?? "",
        student,
        form: form2,
        created: kept.map((entry) => entry.first).filter(Boolean).sort()[0] ?? now,
        saved: now,
        page,
        ...state?.handed ? { handed: state.handed, code: state.code ?? "" } : {},
        items: kept.filter((entry) => entry.type !== "form").flatMap(items)
      };
      return { lesson, form: form2, page, name: fileName(content, "carts.json"), content };
    });
  }
  function fileName({ lesson, form: form2, student, created }, ending) {
    const safe = (text) => text.replace(/[^\p{L}\p{M}\p{N}+_-]+/gu, "-").slice(0, 80);
    const begun = created.slice(5, 19).replace(/[^\dT]/g, "").replace("T", "-");
    return `${safe(lesson)}.${form2}.${safe(student) || `no-code-${begun}`}.${ending}`;
  }
  function items(entry) {
    const all = [...entry.earlier ?? [], entry];
    return all.filter((one) => !isEmpty(one.value) || one.tries).map(item);
  }
  function item(entry) {
    const { id, hash: hash2 = "", type, value, first = null, last = null, tries = 0 } = entry;
    const made2 = {
      id,
      hash: hash2,
      type,
      value,
      first,
      last,
      tries
    };
    for (const name of [...TEXTS, "own", "set", "found", "right", "before"]) {
      const more = entry[name];
      if (more !== void 0 && more !== null && more !== "") made2[name] = more;
    }
    return made2;
  }
  function tooLarge(bytes) {
    if (bytes <= MOST_BYTES) return null;
    return { problem: tr("This file is too large to be a file of answers.") };
  }
  function readFile(text, site) {
    const large = tooLarge(text.length);
    if (large) return large;
    let content;
    try {
      content = JSON.parse(text.replace(/^\uFEFF/, ""));
    } catch {
      return { problem: tr("This file is damaged, or it is not a file of answers.") };
    }
    const problem = wrong(content, site);
    if (problem) return { problem };
    const { page, lesson, form: form2, lessonHash } = content;
    const found2 = /* @__PURE__ */ new Map();
    for (const row of content.items) {
      const entry = clean(row);
      if (!entry)
        return { problem: tr("An answer in this file is damaged. Nothing was taken from it.") };
      const key = form2 === "worksheet" ? `${page}#${entry.id}` : `${page}#${form2}:${entry.id}`;
      const other = found2.get(key);
      const full = { ...entry, form: form2, lesson, lessonHash };
      found2.set(
        key,
        other ? { ...full, earlier: [...other.earlier ?? [], { ...other, earlier: void 0 }] } : full
      );
    }
    if (TIME.test(content.handed ?? "")) found2.set(`${page}#${form2}:_form`, handedIn(content));
    return { student: content.student, form: form2, lesson, entries: [...found2] };
  }
  function wrong(content, site) {
    const isTable = typeof content === "object" && content !== null && !Array.isArray(content);
    if (!isTable || content.kind !== KIND) return tr("This is not a file of answers.");
    if (!Number.isInteger(content.format) || content.format < 1)
      return tr("This is not a file of answers.");
    if (content.format > FORMAT) {
      return tr("This file comes from a newer version of the lessons. Open it there.");
    }
    if (content.site !== site) return tr("This file belongs to another site.");
    const texts = [content.lesson, content.student, content.page].every(
      (text) => typeof text === "string" && text.length <= 200 && !new RegExp("\\p{Cc}", "u").test(text)
    );
    const foreign = /[#@]/.test(content.student) || /^@/.test(content.page);
    const hash2 = content.lessonHash === "" || HASH.test(String(content.lessonHash));
    if (!texts || foreign || !hash2 || !content.page || !FORMS2.includes(content.form)) {
      return tr("This file is damaged. Nothing was taken from it.");
    }
    if (!Array.isArray(content.items) || content.items.length > MOST_ITEMS) {
      return tr("This file is damaged. Nothing was taken from it.");
    }
    return "";
  }
  function clean(row) {
    if (typeof row !== "object" || row === null) return null;
    const { id, hash: hash2, type, value, first, last, tries } = row;
    const good = typeof id === "string" && ID.test(id) && (hash2 === "" || HASH.test(String(hash2))) && typeof type === "string" && /^[a-z][a-z-]{2,23}$/.test(type) && [first, last].every((time) => time === null || TIME.test(String(time))) && Number.isInteger(tries) && tries >= 0 && tries <= MOST_TRIES && isPlain(value, 0);
    if (!good) return null;
    const entry = {
      id,
      hash: hash2,
      type,
      value,
      first,
      last,
      tries
    };
    for (const name of TEXTS) {
      if (typeof row[name] === "string" && row[name].length <= LONGEST) entry[name] = row[name];
    }
    if (Number.isFinite(row.own) && isPlain(row.own, 0)) entry.own = row.own;
    if (isPlain(row.set, 1) && row.set) entry.set = row.set;
    if (Number.isInteger(row.right) && row.right >= 0 && row.right <= tries) entry.right = row.right;
    if (row.before && isPlain(row.before, 0)) entry.before = row.before;
    if (Array.isArray(row.found) && isPlain(row.found, 1)) entry.found = row.found;
    return entry;
  }
  function isPlain(value, depth) {
    if (value === null || value === void 0 || typeof value === "boolean") return true;
    if (typeof value === "string") return value.length <= LONGEST;
    if (typeof value === "number") return Math.abs(value) < LARGEST;
    if (depth > 3 || typeof value !== "object") return false;
    const parts = Object.entries(value);
    return parts.length <= 200 && parts.every(
      ([key, part2]) => /^[\w.+-]{1,64}$/.test(key) && !key.startsWith("__") && isPlain(part2, depth + 1)
    );
  }
  function handedIn({ handed, code, created, form: form2, lesson, lessonHash }) {
    const known2 = typeof code === "string" && /^[0-9A-Z-]{0,14}$/.test(code) ? code : "";
    return {
      id: "_form",
      type: "form",
      form: form2,
      lesson,
      lessonHash,
      value: { handed, code: known2 },
      handed,
      code: known2,
      words: [],
      first: TIME.test(String(created)) ? created : null,
      last: handed,
      tries: 0
    };
  }

  // src/answers/parts.js
  function part(name, title) {
    const made2 = html("section", `carts-answers-part carts-answers-${name}`);
    made2.append(html("h3", "", title));
    return made2;
  }
  function button(text, act, name = "") {
    const made2 = html("button", `carts-button ${name}`.trim(), text);
    made2.type = "button";
    made2.addEventListener("click", act);
    return made2;
  }
  var count = 0;
  function askingButton(text, question, yes, act, name, not = tr("No")) {
    const row = html("p", `carts-answers-asking ${name}`);
    const first = button(text, () => ask2(true));
    const asked2 = html("span");
    const words3 = html("span", "", question);
    count += 1;
    words3.id = `${name}-${count}`;
    const no = button(not, () => ask2(false), "carts-answers-no");
    const go = () => {
      ask2(false);
      act();
    };
    const does = button(yes, go, "carts-answers-yes");
    for (const one of [does, no]) one.setAttribute("aria-describedby", words3.id);
    asked2.append(words3, " ", does, " ", no);
    asked2.hidden = true;
    row.append(first, asked2);
    function ask2(on) {
      first.hidden = on;
      asked2.hidden = !on;
      (on ? no : first).focus();
    }
    return row;
  }
  function codeBox(text) {
    const label = html("label", "", `${text} `);
    const box = html("input", "carts-answers-code");
    Object.assign(box, { type: "text", maxLength: 90, autocomplete: "off", spellcheck: false });
    box.placeholder = "BLUE-FOX-27";
    label.append(box);
    return { label, box };
  }
  function status() {
    const made2 = html("p", "carts-answers-status");
    made2.setAttribute("role", "status");
    return made2;
  }
  function fault(line, problem) {
    line.replaceChildren(html("b", "carts-answers-fault", problem));
  }
  function clock(time) {
    const date = new Date(time ?? "");
    return Number.isNaN(date.getTime()) ? "" : date.toLocaleString(document.documentElement.lang || [], {
      dateStyle: "medium",
      timeStyle: "short"
    });
  }

  // src/answers/panel-files.js
  var NAMES = {
    worksheet: tr("lesson"),
    pre: tr("test before"),
    post: tr("test after"),
    delayed: tr("last test")
  };
  var AFTER_SAVING = 1500;
  function filesPart(book2) {
    const root = part("files", tr("Hand in: save a file"));
    const table = html("div", "carts-answers-table");
    const told2 = status();
    root.append(table, told2, importRow(book2, told2));
    const draw = () => {
      if (table.querySelector(".carts-answers-whose > *")) return;
      table.replaceChildren(...rows(book2, told2, draw));
    };
    draw();
    return { root, draw };
  }
  function rows(book2, told2, draw) {
    const files = makeFiles(book2.entries(), book2, (/* @__PURE__ */ new Date()).toISOString());
    files.sort((a, b) => Number(b.page === book2.page) - Number(a.page === book2.page));
    if (!files.length) return [html("p", "carts-quiet", tr("Nothing has been answered yet."))];
    return files.map((file) => {
      const row = html("div", "carts-answers-file");
      const last = file.content.items.map((item2) => item2.last).sort().pop();
      const name = html("span", "carts-answers-name");
      name.append(
        html("strong", "", titleOf(book2, file)),
        ` · ${NAMES[file.form]} · ${held(book2, file)}`
      );
      if (last) name.append(html("span", "carts-quiet", ` · ${clock(last)}`));
      const asked2 = html("p", "carts-answers-whose");
      const keep = (student) => {
        const now = (/* @__PURE__ */ new Date()).toISOString();
        const [fresh] = makeFiles(book2.entries(), { site: book2.site, student }, now).filter(
          (one) => one.page === file.page && one.form === file.form
        );
        const { name: name2, content } = fresh ?? file;
        download(name2, `${JSON.stringify(content, null, 1)}
`, "application/json");
        document.dispatchEvent(new CustomEvent("carts-file-saved", { detail: name2 }));
        say(
          told2,
          tr(
            "Saved as {file}. Look in your folder “Downloads” and give this file to your teacher. Keep it until it has arrived.",
            { file: name2 }
          )
        );
      };
      const save = button(
        tr("Save file"),
        () => book2.student ? keep(book2.student) : askWhose(asked2, book2, keep, draw),
        "carts-answers-save"
      );
      const csv = button(
        tr("Table (CSV)"),
        () => {
          download(fileName(file.content, "csv"), csvText(file.content), "text/csv");
          say(told2, tr("Saved. A spreadsheet program opens it."));
        },
        "carts-answers-csv"
      );
      row.append(name, save, " ", csv, asked2);
      return row;
    });
  }
  function titleOf(book2, { page, lesson }) {
    const title = page === book2.page && document.querySelector("h1")?.firstChild?.textContent;
    return title || lesson;
  }
  function held(book2, { form: form2, page, content }) {
    const all = content.items.length;
    const { done, of } = book2.progress();
    if (form2 !== "worksheet" || page !== book2.page || !of)
      return counted("1 answer", "{n} answers", all);
    const asked2 = tr("{part} of {all} answered", { part: done, all: of });
    const more = all - done;
    return more > 0 ? `${asked2} + ${counted("1 more answer", "{n} more answers", more)}` : asked2;
  }
  function askWhose(place2, book2, keep, draw) {
    const { label, box } = codeBox(tr("Whose file is it? Code word from your card"));
    const above = document.querySelector(".carts-answers-who .carts-answers-code");
    box.value = above?.value ?? "";
    const told2 = status();
    const withCode = async () => {
      const found2 = readCode(box.value);
      if ("problem" in found2) return fault(told2, found2.problem);
      const { code } = found2;
      keep(code);
      if (await book2.has(code).catch(() => true)) {
        return say(
          told2,
          tr(
            "Saved. Answers of {code} are on this computer already: if you are {code}, type it above too.",
            { code }
          )
        );
      }
      const anew = await book2.become(code, true).catch(() => false);
      if (book2.student === code) end();
      if (anew) setTimeout(() => location.reload(), AFTER_SAVING);
    };
    onEnter(box, () => void withCode());
    const end = () => {
      place2.replaceChildren();
      draw();
    };
    const without = () => {
      end();
      keep("");
    };
    place2.replaceChildren(
      label,
      " ",
      button(tr("Save with this code word"), () => void withCode(), "carts-answers-with-code"),
      " ",
      button(tr("Save without a code word"), without, "carts-answers-without-code"),
      told2
    );
    box.focus();
  }
  function elsewhere(found2, book2) {
    const words3 = [];
    if (found2.student !== book2.student) {
      const whose = found2.student || tr("somebody without a code word");
      words3.push(tr("This file is of {whose}.", { whose }));
    }
    if (!found2.entries.some(([key]) => key.startsWith(`${book2.page}#`))) {
      const alone2 = location.protocol === "file:" && navigator.userAgent.includes("Firefox/");
      const page = { page: found2.lesson };
      words3.push(
        alone2 ? tr("It belongs to the page “{page}”: open that page and bring the file back there.", page) : tr("It belongs to the page “{page}”: open that page to see its answers.", page)
      );
    }
    return words3.join(" ");
  }
  function continueAs(student) {
    return button(tr("Continue as {student}", { student }), () => {
      const who = document.querySelector(".carts-answers-who");
      const box = who?.querySelector("input");
      if (box) box.value = student;
      who?.scrollIntoView();
      who?.querySelector("button")?.click();
    });
  }
  function importRow(book2, told2) {
    const row = html("p", "carts-answers-import");
    const label = html("label", "carts-button", tr("Bring answers back from a file"));
    const box = html("input", "carts-answers-open carts-hidden");
    Object.assign(box, { type: "file", accept: ".json,application/json" });
    label.append(box);
    row.append(label);
    box.addEventListener("change", async () => {
      const file = box.files?.[0];
      if (!file) return;
      const found2 = tooLarge(file.size) ?? readFile(await file.text().catch(() => ""), book2.site);
      box.value = "";
      if ("problem" in found2) return fault(told2, `${file.name}: ${found2.problem}`);
      const changed = await book2.take(found2.student, found2.entries).catch(() => -1);
      if (changed < 0)
        return fault(told2, tr("This browser refuses to keep the answers of this file."));
      const where = elsewhere(found2, book2);
      const count2 = counted("1 answer", "{n} answers", changed);
      const taken = tr("{count} taken from the file; nothing that was here is lost.", { count: count2 });
      say(told2, `${taken} ${where}`.trim());
      const { student } = found2;
      if (student && student !== book2.student) told2.append(" ", continueAs(student));
      const predicted = found2.entries.some(([, entry]) => entry.locked);
      if (!where && changed && predicted && book2.lasts) setTimeout(() => location.reload(), 1500);
    });
    return row;
  }

  // src/answers/panel-leave.js
  function leavePart(book2) {
    const root = part("leave", tr("Before you leave this computer"));
    const told2 = status();
    const forget = async (everybody) => {
      try {
        await book2.forget(everybody);
      } catch {
        return say(
          told2,
          tr(
            "This browser refuses to delete: answers are still on this computer. Try again, or clear the browser's data."
          )
        );
      }
      forgetTab();
      retain(CAME, "");
      location.reload();
    };
    root.append(
      html("p", "carts-answers-where", whereKept(book2)),
      askingButton(
        tr("Clear my answers here"),
        tr("Is your file saved? Your answers on this computer will be gone."),
        tr("Clear my answers"),
        () => void forget(false),
        "carts-answers-clear",
        tr("Keep them")
      ),
      askingButton(
        tr("Delete everything"),
        tr("This deletes the answers of everybody who worked on this computer."),
        tr("Delete all of them"),
        () => void forget(true),
        "carts-answers-delete",
        tr("Keep them")
      ),
      told2
    );
    return root;
  }
  function whereKept(book2) {
    if (!book2.lasts)
      return tr("This browser keeps nothing after the page is closed. Save your file now.");
    const words3 = [tr("Your answers are kept in this browser on this computer, and nowhere else.")];
    if (book2.store?.how === "text")
      words3.push(tr("If the computer crashes, the last seconds may be lost."));
    if (location.protocol === "file:" && navigator.userAgent.includes("Firefox/")) {
      words3.push(
        tr(
          "Firefox keeps them for this page in this folder: if the folder is moved or renamed, bring your file back in."
        )
      );
    } else if (location.protocol === "file:") {
      words3.push(tr("They are still there if the folder is moved or renamed."));
    }
    words3.push(
      tr(
        "A private window, or a laptop that is wiped when you log out, may forget them: save your file before you leave."
      )
    );
    return words3.join(" ");
  }

  // src/question/handin.js
  var ALPHABET = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";
  var ANSWER_BITS = 44n;
  var CHECK_BITS = 16n;
  function fits(options) {
    const all = options.length > 0 && options.every((count2) => count2 > 0);
    return all && options.reduce((size, count2) => size * BigInt(count2 + 1), 1n) <= 1n << ANSWER_BITS;
  }
  function encode(options, chosen3, form2) {
    let number3 = 0n;
    options.forEach((count2, k) => {
      number3 = number3 * BigInt(count2 + 1) + BigInt(chosen3[k] ?? 0);
    });
    const whole2 = number3 << CHECK_BITS | BigInt(check(number3, form2));
    const letters = Array.from(
      { length: 12 },
      (_, k) => ALPHABET[Number(whole2 >> BigInt(55 - 5 * k) & 31n)]
    );
    return [0, 4, 8].map((k) => letters.slice(k, k + 4).join("")).join("-");
  }
  function check(number3, form2) {
    const bytes = [...new TextEncoder().encode(form2)];
    for (let k = 5n; k >= 0n; k -= 1n) bytes.push(Number(number3 >> 8n * k & 255n));
    let crc = 65535;
    for (const byte of bytes) {
      crc ^= byte << 8;
      for (let bit = 0; bit < 8; bit += 1) {
        crc = (crc & 32768 ? crc << 1 ^ 4129 : crc << 1) & 65535;
      }
    }
    return crc;
  }

  // src/question/opening.js
  var NAMES2 = {
    pre: tr("the test before the lesson"),
    post: tr("the test after the lesson"),
    delayed: tr("the last test")
  };
  function reasons(rule, state) {
    const why = [];
    if (rule.word && !state.words.includes(rule.word)) {
      why.push(tr("It opens with your teacher's word."));
    }
    if (rule.date && today(state.now) < rule.date) {
      why.push(tr("It opens on {date}.", { date: rule.date }));
    }
    if (rule.done === "worksheet" && !state.answered) {
      why.push(tr("It opens when every question of the worksheet above is answered."));
    } else if (rule.done && rule.done !== "worksheet") {
      const handed = state.handed[rule.done];
      if (!handed) {
        const form2 = NAMES2[rule.done] ?? rule.done;
        why.push(tr("It opens when {form} is handed in.", { form: form2 }));
      } else if (rule.days) {
        const day = new Date(handed);
        day.setDate(day.getDate() + rule.days);
        if (today(state.now) < today(day)) why.push(tr("It opens on {date}.", { date: today(day) }));
      }
    }
    return why;
  }
  function isOver(rule, now) {
    return Boolean(rule.date) && today(now) > String(rule.date);
  }
  function wordSum(scope, word) {
    const text = `${scope}:${word.replace(/\s+/g, "").toUpperCase()}`;
    let crc = ~0;
    for (const byte of new TextEncoder().encode(text)) {
      crc ^= byte;
      for (let bit = 0; bit < 8; bit += 1) crc = crc & 1 ? crc >>> 1 ^ 3988292384 : crc >>> 1;
    }
    return (~crc >>> 0).toString(16).padStart(8, "0");
  }
  function today(date) {
    const two = (n) => String(n).padStart(2, "0");
    return `${date.getFullYear()}-${two(date.getMonth() + 1)}-${two(date.getDate())}`;
  }

  // src/question/shuffle.js
  var LETTERS = "ABCDEFGHIJKL";
  function shuffleOptions(quiz, student) {
    for (const question of quiz.querySelectorAll("carts-question")) {
      const body = question.querySelector(".carts-q-options");
      const labels = [...body?.querySelectorAll("label") ?? []];
      const order = new Map(
        labels.map((label) => [label, hash(`${student}/${question.id}/${label.dataset.option}`)])
      );
      labels.sort((a, b) => (order.get(a) ?? 0) - (order.get(b) ?? 0));
      labels.forEach((label, k) => {
        body?.append(label);
        const letter = label.querySelector(".carts-q-letter");
        if (letter) letter.textContent = LETTERS[k] ?? "";
      });
    }
  }
  function hash(text) {
    let sum = 2166136261;
    for (const byte of new TextEncoder().encode(text)) sum = Math.imul(sum ^ byte, 16777619);
    sum = Math.imul(sum ^ sum >>> 15, 739982445);
    return (sum ^ sum >>> 13) >>> 0;
  }

  // src/question/quiz.js
  var STATE = "_form";
  function quizElement(book2) {
    return class CartsQuiz extends HTMLElement {
      #leaving = new AbortController();
      // ends what the form hears of the answers
      connectedCallback() {
        this.#leaving = new AbortController();
        const { signal } = this.#leaving;
        book2.addEventListener("change", () => this.#follow(), { signal });
        if (this.facts) return;
        this.facts = JSON.parse(need(this, "script.carts-quiz-facts").textContent ?? "{}");
        this.#listen();
        void book2.ready.then(() => {
          if (this.facts.shuffle && book2.student) shuffleOptions(this, book2.student);
          this.#follow();
        });
      }
      disconnectedCallback() {
        this.#leaving.abort();
      }
      #listen() {
        const word = need(this, ".carts-quiz-word");
        need(this, ".carts-quiz-open").addEventListener(
          "click",
          () => void this.#tryWord(word.value)
        );
        onEnter(word, () => void this.#tryWord(word.value));
        need(this, ".carts-quiz-hand-in").addEventListener("click", () => this.#ask(true));
        need(this, ".carts-quiz-no").addEventListener("click", () => this.#ask(false));
        need(this, ".carts-quiz-yes").addEventListener("click", () => void this.#handIn());
        this.addEventListener("carts-answer", () => this.#count());
      }
      get state() {
        const found2 = book2.get(this.facts.form, STATE);
        return found2 ?? {
          id: STATE,
          type: "form",
          value: null,
          words: [],
          first: null,
          last: null,
          tries: 0
        };
      }
      #questions() {
        return [...this.querySelectorAll("carts-question")];
      }
      #follow() {
        const { handed, words: words3 } = this.state;
        const now = /* @__PURE__ */ new Date();
        const all = {
          now,
          words: words3 ?? [],
          answered: this.#worksheetDone(),
          handed: handedForms(book2)
        };
        const over = isOver(this.facts.close, now);
        const why = handed ? [] : over ? [tr("This form is closed.")] : reasons(this.facts.open, all);
        const review = handed && this.facts.review && reasons(this.facts.review, all).length === 0;
        const wantsWord = handed ? !review && this.facts.review?.word : !over && this.facts.open.word && !all.words.includes(this.facts.open.word);
        const open2 = !why.length && (!handed || review);
        need(this, ".carts-quiz-items").hidden = !open2;
        need(this, ".carts-quiz-gate").hidden = open2 && !wantsWord;
        const again = handed && wantsWord ? [tr("To look at your answers again:")] : why;
        say(need(this, ".carts-quiz-why"), again.join(" "));
        need(this, ".carts-quiz-ask").hidden = !wantsWord;
        need(this, ".carts-quiz-foot").hidden = !open2 || Boolean(handed);
        for (const question of this.#questions()) question.close(Boolean(handed));
        if (open2 && !handed) this.#count();
        this.#done(handed, Boolean(review));
      }
      #worksheetDone() {
        const { done, of } = book2.progress();
        return of > 0 && done === of;
      }
      async #tryWord(typed) {
        const sum = wordSum(this.facts.id, typed);
        const { open: open2, review } = this.facts;
        if (![open2.word, review?.word].includes(sum)) {
          say(need(this, ".carts-quiz-why"), tr("That is not the word. Ask your teacher."));
          return;
        }
        const state = this.state;
        const now = (/* @__PURE__ */ new Date()).toISOString();
        await this.#keep({
          ...state,
          words: [...state.words ?? [], sum],
          first: state.first ?? now,
          last: now
        });
      }
      #count() {
        const left = this.#questions().filter((question) => !question.answered).length;
        say(
          need(this, ".carts-quiz-left"),
          left ? tr("{count} not answered yet", { count: left }) : tr("All answered.")
        );
      }
      #ask(on) {
        const left = this.#questions().filter((question) => !question.answered).length;
        const missing = counted(
          "1 question is not answered.",
          "{n} questions are not answered.",
          left
        );
        const unread = this.#questions().filter((question) => question.unread).length;
        const unclear = counted("1 number cannot be read.", "{n} numbers cannot be read.", unread);
        const words3 = [
          left ? missing : "",
          unread ? unclear : "",
          book2.student ? "" : tr("You have typed no code word yet: My answers."),
          tr("After handing in you cannot change anything.")
        ];
        say(need(this, ".carts-quiz-sure-text"), words3.filter(Boolean).join(" "));
        need(this, ".carts-quiz-sure").hidden = !on;
        need(this, ".carts-quiz-hand-in").hidden = on;
        need(this, on ? ".carts-quiz-no" : ".carts-quiz-hand-in").focus();
      }
      async #handIn() {
        const now = (/* @__PURE__ */ new Date()).toISOString();
        const state = this.state;
        const code = this.#code();
        const value = { handed: now, code, hash: this.facts.hash };
        await this.#keep({
          ...state,
          value,
          handed: now,
          code,
          first: state.first ?? now,
          last: now
        });
        this.#ask(false);
        this.#follow();
        const done = need(this, ".carts-quiz-done");
        done.tabIndex = -1;
        done.focus();
        this.dispatchEvent(
          new CustomEvent("carts-handed-in", { bubbles: true, detail: this.facts.form })
        );
      }
      #code() {
        const options = this.facts.items.map((item2) => item2[1]);
        if (!fits(options)) return "";
        const chosen3 = this.#questions().map((question) => {
          return isEmpty(question.value) ? 0 : question.facts.options.indexOf(question.value) + 1;
        });
        return encode(options, chosen3, `${this.facts.form}:${this.facts.hash}`);
      }
      async #keep(state) {
        try {
          await book2.put(this.facts.form, state);
        } catch {
        }
      }
      #done(handed, review) {
        const place2 = need(this, ".carts-quiz-done");
        place2.hidden = !handed;
        if (!handed) return;
        const { code } = this.state;
        const words3 = [
          tr("Handed in on {when}.", { when: clock(handed) }),
          code ? tr("Hand-in code: {code}.", { code }) : "",
          tr("Save your file under “My answers”."),
          review ? "" : tr("The questions are hidden until your teacher opens them again.")
        ];
        say(place2, words3.filter(Boolean).join(" "));
      }
    };
  }
  function handedForms(book2) {
    const found2 = {};
    for (const form2 of ["pre", "post", "delayed"]) {
      const handed = book2.get(form2, STATE)?.handed;
      if (handed) found2[form2] = handed;
    }
    return found2;
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

  // src/answers/print.js
  var EMPTY = "carts-print-empty";
  var ALL = "carts-print-all";
  var chosen = false;
  function print(empty) {
    chosen = true;
    const undo = empty ? emptied([EMPTY, ALL]) : () => {
    };
    for (const dialog of document.querySelectorAll("dialog")) dialog.close();
    printWith(() => {
      chosen = false;
      undo();
    });
  }
  function emptyWhereUntouched(book2) {
    addEventListener("beforeprint", () => {
      const answered2 = book2.entries().some(([key]) => key.startsWith(`${book2.page}#`));
      const worked = answered2 || document.querySelector("[data-watched], [data-printing]");
      if (chosen || worked || !outline()) return;
      const how = tr("To print the questions that wait, too: “My answers”, “Print empty”.");
      addEventListener("afterprint", emptied([EMPTY], `${how} `), { once: true });
    });
  }
  function emptied(names, how = "") {
    const { classList } = document.documentElement;
    classList.add(...names);
    const back = blanked(how);
    return () => {
      classList.remove(...names);
      for (const undo of back) undo();
    };
  }
  function blanked(how) {
    const scenes = [...document.querySelectorAll("carts-scene")].map(blank);
    const head = document.querySelector(".carts-print-head");
    if (!head) return scenes;
    const text = head.textContent;
    say(head, how + tr("Code word: {code}", { code: "____________________" }));
    return [...scenes, () => say(head, text)];
  }
  function blank(scene) {
    const { asBaked } = scene;
    const untouched = scene.matches(".carts-asks:not(:has(.carts-saved:not(:empty)))");
    if (!asBaked || untouched) return () => {
    };
    const sheet2 = document.createElement("carts-blank");
    sheet2.className = `${scene.className} carts-asks`;
    sheet2.innerHTML = asBaked;
    scene.after(sheet2);
    return () => sheet2.remove();
  }

  // src/answers/panel-list.js
  function listPart(book2) {
    const root = part("list", tr("On this page"));
    const mine = book2.entries().filter(([key, entry]) => key.startsWith(`${book2.page}#`) && entry?.type !== "form");
    const handed = handedForms(book2);
    const shown = mine.filter(([, entry]) => !handed[entry.form] && !isEmpty(entry.value));
    const hidden = mine.filter(([, entry]) => handed[entry.form]).length;
    if (outline()) {
      const row = html("p");
      row.append(
        button(tr("Print with my answers"), () => print(false)),
        " ",
        button(tr("Print empty"), () => print(true))
      );
      const counts = tr(
        "Counted at the foot of the page: questions and predictions, without those “for more” and those after the end of the lesson."
      );
      root.append(row, html("p", "carts-quiet", counts));
    }
    if (!shown.length && !hidden)
      root.append(html("p", "carts-quiet", tr("No answers on this page yet.")));
    if (hidden)
      root.append(
        html(
          "p",
          "carts-quiet",
          counted(
            "1 answer of a form that was handed in is kept and not shown.",
            "{n} answers of a form that was handed in are kept and not shown.",
            hidden
          )
        )
      );
    const list = html("dl", "carts-answers-said");
    for (const [, entry] of inPageOrder(shown)) {
      const note = isHere(entry) ? "" : ` ${tr("(no longer on this page)")}`;
      list.append(html("dt", "", `${entry.asked || entry.id}${note}`));
      list.append(html("dd", "", entry.said || plainValue(entry.value)));
      for (const old of entry.earlier ?? []) {
        list.append(
          html(
            "dd",
            "carts-quiet",
            tr("earlier: {answer}", { answer: old.said || plainValue(old.value) })
          )
        );
      }
    }
    root.append(list);
    return root;
  }
  function plainValue(value) {
    return typeof value === "string" ? value : JSON.stringify(value);
  }

  // src/question/gate.js
  var OPEN_ALL = "carts-open-questions";
  function wait(element, signal) {
    const id = element.dataset.after;
    if (!id) return;
    const open2 = () => element.dataset.opened ??= "";
    const seen = element.dataset.found === void 0 ? "watched" : "found";
    const look = () => {
      const scene = document.getElementById(id);
      if (!scene || [seen, "unshown"].some((name) => name in scene.dataset)) open2();
    };
    if (element.answered) open2();
    queueMicrotask(() => signal.aborted || look());
    for (const kind of ["carts-watched", "carts-found", "carts-error"]) {
      document.addEventListener(kind, look, { signal });
    }
    const byKey = () => element.dataset.opened = "key";
    document.addEventListener(OPEN_ALL, byKey, { signal });
    const close = ({ target }) => {
      const again = target.id === id && element.dataset.opened === "";
      if (again && !element.answered) delete element.dataset.opened;
    };
    document.addEventListener("carts-unwatched", close, { signal });
  }
  var CartsAfter = class extends HTMLElement {
    #leaving = new AbortController();
    connectedCallback() {
      this.#leaving = new AbortController();
      wait(this, this.#leaving.signal);
    }
    disconnectedCallback() {
      this.#leaving.abort();
    }
  };
  function anyWaits() {
    return document.querySelector("[data-after]:not([data-opened])") !== null;
  }
  function openAll2() {
    document.dispatchEvent(new Event(OPEN_ALL));
  }

  // src/teach/door.js
  var OPEN = "carts-teach";
  var teachersWord = () => document.querySelector('meta[name="carts-teacher"]')?.getAttribute("content") ?? "";
  var draftMark = () => `carts-draft ${place().page}`;
  function tellDraft(link) {
    link.dataset.words ??= link.textContent ?? "";
    const kept = recall(draftMark(), BROWSER) ? " (your draft is kept)" : "";
    link.textContent = link.dataset.words + kept;
  }
  function teacherDoor() {
    const link = document.querySelector(".carts-teach-door a");
    if (!(link instanceof HTMLAnchorElement)) return;
    const lesson = new URL(link.dataset.lesson ?? "", document.baseURI);
    const beside = (name) => new URL(`../${name}${lesson.search}`, lesson).href;
    tellDraft(link);
    let loaded = null;
    const open2 = async () => {
      if (!await letIn()) return;
      loaded ??= Promise.all([
        arrives("link", { rel: "stylesheet", href: beside("teacher.css") }),
        arrives("script", { src: beside("teacher.js") })
      ]);
      link.textContent = tr("Opening …");
      try {
        await loaded;
        tellDraft(link);
        document.dispatchEvent(new Event(OPEN));
      } catch {
        loaded = null;
        link.textContent = "Teacher mode cannot be loaded: a file of this site is missing.";
      }
    };
    const letIn = () => {
      const sum = teachersWord();
      return !sum || recall(KEY) === sum || ask(link, sum);
    };
    const wanted2 = () => location.hash === "#teacher" || new URLSearchParams(location.search).has("teacher");
    link.addEventListener("click", (event) => {
      event.preventDefault();
      history.pushState(null, "", link.href);
      void open2();
    });
    addEventListener("hashchange", () => {
      if (location.hash === "#teacher") void open2();
    });
    if (wanted2()) void open2();
  }
  function arrives(tag, given) {
    return new Promise((onload, onerror) => {
      const made2 = document.createElement(tag);
      document.head.append(Object.assign(made2, given, { onload, onerror }));
    });
  }
  var KEY = "carts-teacher-word";
  function ask(link, sum) {
    const place2 = link.parentElement;
    const asking = place2.querySelector("input");
    asking?.focus();
    if (asking) return Promise.resolve(false);
    const form2 = html("form", "carts");
    const label = html("label", "", `${tr("Your teacher's word")} `);
    const box = document.createElement("input");
    Object.assign(box, { type: "text", autocomplete: "off", maxLength: 60, spellcheck: false });
    const button2 = Object.assign(html("button", "carts-button", tr("Open")), { type: "submit" });
    const wrong2 = html("span", "carts-error");
    wrong2.setAttribute("role", "alert");
    label.append(box);
    form2.append(label, " ", button2, " ", wrong2);
    place2.append(form2);
    box.focus();
    if (document.readyState !== "complete")
      addEventListener("load", () => requestAnimationFrame(() => box.focus()), { once: true });
    return new Promise((resolve) => {
      form2.addEventListener("submit", (event) => {
        event.preventDefault();
        if (wordSum("teacher", box.value) !== sum) {
          wrong2.textContent = tr("That is not the word.");
          box.setAttribute("aria-invalid", "true");
          box.select();
          return;
        }
        retain(KEY, sum);
        form2.remove();
        resolve(true);
      });
    });
  }

  // src/answers/panel-teachers.js
  function teachersPart() {
    if (!anyWaits()) return "";
    const root = html("details", "carts-answers-part carts-answers-teachers");
    const told2 = status();
    const sum = wanted();
    const box = document.createElement("input");
    Object.assign(box, { type: "text", autocomplete: "off", maxLength: 60, spellcheck: false });
    const label = html("label", "", `${tr("Your teacher's word")} `);
    label.append(box);
    const key = askingButton(
      tr("Open all questions"),
      tr(
        "All questions and texts of this page that wait for a run open at once, and tell what it shows. Open them?"
      ),
      tr("Open them now"),
      () => {
        if (sum && wordSum("teacher", box.value) !== sum) {
          return fault(told2, tr("That is not the word."));
        }
        if (sum) retain(KEY, sum);
        openAll2();
        label.remove();
        key.remove();
        return say(told2, tr("All questions of this page are open now."));
      },
      "carts-answers-open-all"
    );
    root.addEventListener("toggle", () => root.scrollIntoView({ block: "nearest" }));
    root.append(html("summary", "", tr("For teachers")), ...sum ? [label] : [], key, told2);
    return root;
  }
  function wanted() {
    const sum = teachersWord();
    return recall(KEY) === sum ? "" : sum;
  }

  // src/answers/panel-who.js
  function whoPart(book2) {
    const root = part("who", tr("Who works here"));
    const { student } = book2;
    const now = student ? tr("These are the answers of {student}.", { student }) : tr("No code word yet: the next person at this computer sees these answers.");
    const { label, box } = codeBox(
      student ? tr("Somebody else? Code word") : tr("Code word from your card")
    );
    const told2 = status();
    const choices = html("p", "carts-answers-choices");
    const go = button(tr("Continue"), () => void look(), "carts-answers-go");
    onEnter(box, () => void look());
    const row = html("p");
    row.append(label, " ", go);
    const two = html(
      "p",
      "carts-quiet",
      `${tr("A code word has at least four letters or digits.")} ${tr("Two students at one computer: both code words with a +.")}`
    );
    root.append(html("p", "carts-answers-now", now), row, told2, choices, two);
    async function look() {
      choices.replaceChildren();
      const found2 = readCode(box.value);
      if ("problem" in found2) return fault(told2, found2.problem);
      const { code } = found2;
      if (code === student) return say(told2, tr("That is who works here now."));
      const here = book2.entries().length > 0;
      const known2 = here && student ? await book2.has(code) : false;
      if (!here || known2) return become(code, false);
      say(
        told2,
        student ? tr("The answers here stand under {student}. Is {code} somebody else?", { student, code }) : tr("Somebody has answered here without a code word. Was that you?")
      );
      choices.append(
        button(
          student ? tr("No, that is me: correct the code word, take them along") : tr("They are mine: take them along"),
          () => void become(code, true),
          "carts-answers-mine"
        ),
        " ",
        button(
          student ? tr("Yes, somebody else: begin anew") : tr("Leave them"),
          () => void become(code, false),
          "carts-answers-leave-them"
        )
      );
      choices.querySelector("button")?.focus();
    }
    async function become(code, carry) {
      try {
        const anew = await book2.become(code, carry);
        if (!carry) forgetTab();
        if (!anew) return;
        retain(CAME, code);
        location.reload();
      } catch {
        say(
          told2,
          tr("This browser refuses to keep more. Press “My answers” and save your file now.")
        );
      }
    }
    return root;
  }

  // src/answers/panel.js
  var Panel = class {
    constructor(book2) {
      this.book = book2;
      this.root = document.createElement("dialog");
      this.root.className = "carts carts-answers";
      this.root.setAttribute("aria-labelledby", "carts-answers-title");
      document.body.append(this.root);
      book2.addEventListener("change", () => {
        if (this.root.open) this.#files?.();
      });
      book2.addEventListener("student", () => {
        const now = whoPart(book2);
        this.#who?.replaceWith(now);
        this.#who = now;
      });
    }
    #files = null;
    #who = null;
    async open() {
      await this.book.ready;
      await this.book.refresh();
      const title = html("h2", "carts-answers-title", tr("My answers"));
      title.id = "carts-answers-title";
      const close = html("button", "carts-button carts-answers-close", tr("Close"));
      close.setAttribute("type", "button");
      close.addEventListener("click", () => this.root.close());
      const head = html("div", "carts-answers-head");
      head.append(title, close);
      const files = filesPart(this.book);
      this.#files = files.draw;
      this.#who = whoPart(this.book);
      this.root.replaceChildren(
        head,
        this.#who,
        files.root,
        listPart(this.book),
        leavePart(this.book),
        teachersPart()
      );
      if (!this.root.open) this.root.showModal();
    }
  };

  // src/question/beside-run.js
  function sceneBeside(question) {
    const { after } = question.dataset;
    if (after) return document.getElementById(after);
    let above = null;
    for (const part2 of document.querySelectorAll("h2, carts-scene")) {
      const below = question.compareDocumentPosition(part2) & Node.DOCUMENT_POSITION_FOLLOWING;
      if (below && above) break;
      if (part2.localName === "h2") {
        if (below) break;
        above = null;
      } else if (below) return part2;
      else above = part2;
    }
    return above;
  }
  function whenWatched(question, act, signal) {
    const watched = ({ target }) => {
      if (target === sceneBeside(question)) act();
    };
    document.addEventListener("carts-watched", watched, { signal });
  }
  function atTheRun(entry) {
    const { value, said } = entry;
    return "before" in entry || isEmpty(value) ? entry : { ...entry, before: { value, said } };
  }
  function changing(question, entry) {
    const watched = sceneBeside(question)?.hasAttribute("data-watched") ?? false;
    return watched && !("before" in entry) ? { ...entry, before: null } : entry;
  }
  function tried(entry) {
    return entry.judged ? entry : { ...entry, tries: (entry.tries ?? 0) + 1, judged: true };
  }
  function checked(entry, verdict) {
    const right = entry.right || (verdict === "right" ? entry.tries : 0);
    return right === entry.right ? entry : { ...entry, right };
  }

  // src/question/earlier.js
  function showEarlier(question, earlier, hash2) {
    const place2 = need(question, ".carts-q-earlier");
    const old = earlier.filter((entry) => !isEmpty(entry.value));
    place2.hidden = old.length === 0;
    place2.replaceChildren(
      ...old.map((entry) => {
        const line = html("p");
        const head = entry.hash !== hash2 ? tr("Your answer to an earlier version of this question:") : tr("Your other answer:");
        line.append(html("strong", "", head), " ", entry.said || JSON.stringify(entry.value));
        return line;
      })
    );
  }
  function showFirstIdea(question, first) {
    const place2 = need(question, ".carts-q-first");
    place2.hidden = !first || isEmpty(first.value);
    if (place2.hidden) return;
    say(place2, tr("Your first idea was: {said}", { said: first.said || String(first.value) }));
  }

  // ../view/numbers.js
  var SUPERSCRIPT = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  function exponent(value) {
    return value ? Number(Math.abs(value).toExponential(16).split("e")[1]) : 0;
  }
  function fixed(value, decimals) {
    const text = Math.abs(value).toFixed(decimals);
    return value < 0 && /[1-9]/.test(text) ? `−${text}` : text;
  }
  function short(value, figures = 3) {
    const power = exponent(value);
    if (value && (power <= -4 || power >= 6)) {
      const [digits = "", tens] = Math.abs(value).toExponential(figures - 1).split("e");
      return `${value < 0 ? "−" : ""}${trim(digits)} × 10${superscript(Number(tens))}`;
    }
    return trim(fixed(value, Math.max(0, figures - 1 - power)));
  }
  function superscript(power) {
    const digits = String(Math.abs(power)).replace(/\d/g, (d) => SUPERSCRIPT[Number(d)] ?? "");
    return power < 0 ? `⁻${digits}` : digits;
  }
  function trim(text) {
    return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  }
  function px(value, decimals = 1) {
    const factor = 10 ** decimals;
    const rounded = Math.floor(value * factor + 0.5) / factor;
    return String(rounded === 0 ? 0 : rounded);
  }

  // src/question/marking/link-name.js
  var WAYS = ["contact", "distance"];
  function linkName(objects, between, by) {
    if (!Array.isArray(between) || between.length !== 2 || typeof by !== "string" || !WAYS.includes(by))
      return "";
    const [a, b] = between.map((one) => objects.indexOf(one)).sort((one, other) => one - other);
    return a === void 0 || b === void 0 || a < 0 || a === b ? "" : `${a + 1}-${b + 1}-${by}`;
  }

  // src/question/marking/plain.js
  var POINT = "";
  function plain(text) {
    return text.replace(/´/g, "'").replace(/[⁺⁻⁰¹²³⁴-⁹]+/g, "^$&").normalize("NFKC").toLowerCase().replace(/[−–‐]/g, "-").replaceAll(POINT, "").replace(/[.,]*[0-9]+(?:[.,]+[0-9]+)*/g, number).replace(/[\s.,;:!?“”„"'’`()。、«»‹›‘…¿¡「」『』]+/g, " ").replace(/^ | $/g, "").replace(/ ?([=+\-*/·×÷<>≤≥≈±^%°|&]) ?/g, "$1").replace(/([0-9]) ([^0-9 ])/g, "$1$2").replace(/([^0-9 ]) ([0-9])/g, "$1$2").replaceAll(POINT, ".");
  }
  function number(found2, at2, whole2) {
    const one = /^([0-9]*)[.,]([0-9]+)$/.exec(found2);
    const glued = one && !one[1] && new RegExp("\\p{L}$", "u").test(whole2.slice(Math.max(0, at2 - 2), at2));
    if (!one || glued) return found2.replace(/[.,]/g, " ");
    return `${one[1] || 0}${POINT}${one[2]}`;
  }

  // src/question/marking/mark.js
  var NEAR = 1 + 1e-9;
  var LAST_BITS = 1e-12;
  function mark(facts, value, own = null) {
    const of = facts.marks;
    if (isEmpty(value)) return made("empty", 0, of);
    const rule = RULES[facts.type];
    if (!rule) return made("unclear", 0, of);
    return rule(facts, value, own);
  }
  var RULES = {
    single({ options, key, marks }, value) {
      if (!options.includes(value)) return made("unclear", 0, marks);
      return chosen2([value], key, key.correct.includes(value), false, marks);
    },
    multiple({ options, key, marks }, value) {
      if (!Array.isArray(value) || !value.every((item2) => options.includes(item2))) {
        return made("unclear", 0, marks);
      }
      const picked = options.filter((item2) => value.includes(item2));
      const right = picked.filter((item2) => key.correct.includes(item2));
      const exact = right.length === picked.length && right.length === key.correct.length;
      return chosen2(picked, key, exact, right.length > 0, marks);
    },
    number: ({ key, marks }, value) => near(value, key.answer, key.tolerance, marks, key),
    reading({ key, marks }, value, own) {
      if (own === null) return made("open", null, marks);
      return near(value, own, key.relative ? Math.abs(own) * key.tolerance : key.tolerance, marks);
    },
    long: ({ marks }, value) => written2(value, marks),
    short({ key, marks }, value) {
      if (typeof value !== "string" || !key.accept.length) return written2(value, marks);
      const said = plain(value);
      const named = (texts) => texts.some((text) => plain(text) === said);
      if (named(key.accept)) return whole(true, false, marks);
      const k = key.wrong.findIndex((known2) => named(known2.texts));
      return known(key, k, marks);
    },
    ordering({ key, marks }, value) {
      const right = key.order;
      const same = Array.isArray(value) && [...value].sort().join() === [...right].sort().join();
      if (!same) return made("unclear", 0, marks);
      const followed = right.slice(1).map((line, k) => `${right[k]}${line}`);
      const kept = value.slice(1).filter(
        (line, k) => followed.includes(`${value[k]}${line}`)
      );
      return whole(value.join() === right.join(), 2 * kept.length >= followed.length, marks);
    },
    matching({ key, right, marks }, value) {
      const entries = Object.entries(value);
      const fits2 = !Array.isArray(value) && typeof value === "object";
      if (!fits2 || !entries.every(([left, letter]) => left in key.pairs && right.includes(letter))) {
        return made("unclear", 0, marks);
      }
      const names = Object.keys(key.pairs);
      const good = names.filter((left) => value[left] === key.pairs[left]);
      const shown = good.map((left) => `pair-${left}`);
      return whole(good.length === names.length, good.length > 0, marks, shown);
    },
    table({ key, marks }, value) {
      const names = Object.keys(key.cells);
      const fits2 = typeof value === "object" && !Array.isArray(value);
      if (!fits2 || !Object.keys(value).every((name) => names.includes(name))) {
        return made("unclear", 0, marks);
      }
      const good = names.filter((name) => {
        const { answer, tolerance } = key.cells[name];
        return near(value[name], answer, tolerance, 1).verdict === "right";
      });
      const shown = good.map((name) => `cell-${name}`);
      return whole(good.length === names.length, good.length > 0, marks, shown);
    },
    interactions: ({ objects, key, marks }, value) => {
      const drawn = Array.isArray(value) ? value.map((link) => linkName(objects, link?.between, link?.by)) : [""];
      if (drawn.includes("")) return made("unclear", 0, marks);
      const right = key.links.map(
        (link) => linkName(objects, link.between, link.by)
      );
      const lost = right.filter((link) => !drawn.includes(link));
      const invented = drawn.filter((link) => !right.includes(link));
      const fits2 = (row, links) => row.by.some((by) => links.includes(linkName(objects, row.between, by)));
      const told2 = (name, links) => key[name].map(
        (row, k) => fits2(row, links) ? `${name}-${k + 1}` : ""
      ).filter((row) => key.feedback.includes(row));
      const good = right.filter((link) => drawn.includes(link));
      const names = good.map((link) => `link-${link}`);
      const shown = [...names, ...told2("missing", lost).slice(0, 1), ...told2("wrong", invented)];
      const rows2 = key.wrong.filter((row) => row.belief && fits2(row, invented));
      const beliefs = rows2.map((row) => row.belief);
      const half = !invented.length && 2 * lost.length <= right.length;
      return whole(!lost.length && !invented.length, half, marks, shown, beliefs);
    },
    confidence: ({ options }, value) => options.includes(value) ? made("open", null, 0) : made("unclear", null, 0),
    drawn: () => made("open", null, 0),
    idea: ({ options }, value) => typeof value === "string" && (!options.length || options.includes(value)) ? made("open", null, 0) : made("unclear", null, 0)
  };
  function made(verdict, marks, of, shown = [], beliefs = []) {
    return { verdict, marks, of, shown, beliefs };
  }
  function whole(right, some, of, shown = [], beliefs = []) {
    if (right) return made("right", of, of, [...shown, "explain"]);
    return made(some ? "partly" : "wrong", 0, of, shown, beliefs);
  }
  function chosen2(picked, key, right, some, of) {
    const shown = picked.map((item2) => `option-${item2}`).filter((name) => key.feedback.includes(name));
    const beliefs = picked.flatMap(
      (item2) => Object.hasOwn(key.beliefs, item2) ? key.beliefs[item2] : []
    );
    return whole(right, some, of, shown, beliefs);
  }
  function written2(value, of) {
    return typeof value === "string" ? made("open", null, of, ["explain"]) : made("unclear", 0, of);
  }
  function known(key, k, of) {
    if (k < 0) return whole(false, false, of);
    const shown = key.feedback.includes(`wrong-${k}`) ? [`wrong-${k}`] : [];
    return whole(false, false, of, shown, key.wrong[k].belief ? [key.wrong[k].belief] : []);
  }
  function near(value, answer, tolerance, of, key = null) {
    if (typeof value !== "number" || !Number.isFinite(value)) return made("unclear", 0, of);
    const edge = tolerance * NEAR + LAST_BITS * Math.abs(answer);
    if (Math.abs(value - answer) <= edge) return whole(true, false, of);
    const k = (key?.wrong ?? []).findIndex(
      (wrong2) => Math.abs(value - wrong2.value) <= wrong2.tolerance * NEAR
    );
    return known(key, k, of);
  }

  // src/question/feedback.js
  var WORDS = {
    right: tr("Right."),
    partly: tr("Partly right. Look again."),
    wrong: tr("Not yet. Think again."),
    open: tr("Written down."),
    empty: tr("Answer first."),
    unclear: tr("This cannot be read.")
  };
  var TOLD = tr("Not quite right. Read why.");
  var SHOW_AFTER = 3;
  var Feedback = class {
    constructor(root, attempt, marked2 = () => {
    }) {
      this.marked = marked2;
      this.root = root;
      this.place = need(root, ".carts-q-feedback");
      const check2 = root.querySelector(".carts-q-check");
      const box = root.querySelector("input.carts-q-typed");
      onEnter(box, () => check2?.click());
      check2?.addEventListener("click", () => {
        const tried2 = attempt();
        if (!tried2) return;
        this.place.removeAttribute("aria-live");
        this.marked(...this.#show(tried2));
      });
      const hints = [...need(root, ".carts-q-hints").children];
      const more = root.querySelector(".carts-q-hint");
      more?.addEventListener("click", () => {
        const next = hints.find((hint) => hint.hidden);
        if (next) next.hidden = false;
        more.disabled = !hints.some((hint) => hint.hidden);
      });
    }
    stale() {
      this.place.replaceChildren();
      delete this.root.dataset.verdict;
    }
    again(tried2) {
      this.place.setAttribute("aria-live", "off");
      return this.#show(tried2)[0];
    }
    #show({ value, own, tries }) {
      const facts = this.root.facts;
      const found2 = mark(facts, value, own);
      this.root.dataset.verdict = found2.verdict;
      const names = new Set(found2.shown);
      if (tries >= SHOW_AFTER) names.add("explain");
      const told2 = names.has("explain") && this.root.querySelector('template[data-for="explain"]');
      let words3 = WORDS[found2.verdict];
      if (told2 && ["wrong", "partly"].includes(found2.verdict)) words3 = TOLD;
      else if (found2.verdict === "wrong" && !found2.shown.length && !found2.beliefs.length)
        words3 = unknown(facts, value, own) || words3;
      this.place.replaceChildren(html("p", "carts-q-verdict", words3));
      if (own !== null && tries >= SHOW_AFTER && found2.verdict !== "right") {
        this.place.append(
          html(
            "p",
            "",
            tr("Your run says {value} {unit}.", {
              value: short(own),
              unit: facts.unit
            })
          )
        );
      }
      for (const name of names) {
        const template = this.root.querySelector(`template[data-for="${CSS.escape(name)}"]`);
        if (template instanceof HTMLTemplateElement) {
          const part2 = html("div", "carts-q-said");
          part2.append(template.content.cloneNode(true));
          this.place.append(part2);
        }
      }
      return [found2.shown, found2.verdict];
    }
  };
  function unknown(facts, value, own) {
    if (facts.type === "short") {
      return tr("This page does not know that answer. Say it in fewer words, or think again.");
    }
    const turned = typeof value === "number" && mark(facts, -value, own).verdict === "right";
    return turned ? tr("The size is right. What about its sign?") : "";
  }

  // src/question/plain-text.js
  function plainText(place2) {
    if (!place2) return "";
    const copy = place2.cloneNode(true);
    for (const part2 of copy.querySelectorAll(".katex-html, annotation")) part2.remove();
    for (const part2 of copy.querySelectorAll("img")) part2.replaceWith(part2.alt);
    for (const fraction of [...copy.querySelectorAll("mfrac")].reverse()) {
      fraction.textContent = [...fraction.children].map(grouped).join("/");
    }
    return (copy.textContent ?? "").replace(/\s+/g, " ").trim();
  }
  function grouped(side) {
    const text = (side.textContent ?? "").trim();
    return /[+−\-/·\s]/.test(text) ? `(${text})` : text;
  }

  // src/question/forms/part-mark.js
  function mark2(place2, verdict) {
    const sign = place2.querySelector(".carts-q-cell-mark");
    const words3 = { right: tr("right"), wrong: tr("not yet"), "": "" };
    place2.dataset.verdict = verdict;
    sign.textContent = verdict && (verdict === "right" ? "✓ " : "✗ ") + words3[verdict];
  }

  // src/question/forms/arrange.js
  function orderForm(root, changed) {
    const list = root.querySelector(".carts-q-lines");
    let touched = false;
    const items2 = () => [...list.children];
    const buttons = () => [...list.querySelectorAll("button")];
    list.addEventListener("click", ({ target }) => {
      const button2 = target.closest("button");
      const item2 = button2?.closest("li");
      if (!button2 || !item2) return;
      const up = button2.classList.contains("carts-q-up");
      const other = up ? item2.previousElementSibling : item2.nextElementSibling;
      if (other) list.insertBefore(up ? item2 : other, up ? other : item2);
      touched = true;
      button2.focus();
      changed();
      const [k, all] = [items2().indexOf(item2) + 1, items2().length];
      const told2 = tr("Now {k} of {all}: {text}", { k, all, text: textOf(item2) });
      say(need(root, ".carts-q-picked"), told2);
    });
    return {
      get value() {
        return touched ? items2().map((item2) => item2.dataset.line) : null;
      },
      set value(value) {
        touched = Array.isArray(value) && value.length > 0;
        const order = Array.isArray(value) && touched ? value : [...items2().map((item2) => item2.dataset.line)].sort();
        for (const line of order) {
          const item2 = items2().find((one) => one.dataset.line === line);
          if (item2) list.append(item2);
        }
      },
      enable(on) {
        for (const button2 of buttons()) button2.disabled = !on;
      },
      said: () => touched ? items2().map(textOf).join(" → ") : ""
    };
  }
  function matchForm(root, changed) {
    const rows2 = [...root.querySelectorAll("[data-left]")];
    const select = (row) => row.querySelector("select");
    for (const row of rows2) {
      select(row).addEventListener("change", () => {
        for (const other of rows2) mark2(other, "");
        changed();
      });
    }
    const chosen3 = () => rows2.filter((row) => select(row).value);
    return {
      get value() {
        return Object.fromEntries(chosen3().map((row) => [row.dataset.left, select(row).value]));
      },
      set value(value) {
        for (const row of rows2) {
          const left = String(row.dataset.left);
          select(row).value = value && Object.hasOwn(value, left) ? String(value[left]) : "";
          mark2(row, "");
        }
      },
      enable(on) {
        for (const row of rows2) select(row).disabled = !on;
      },
      said: () => chosen3().map((row) => {
        const right = root.querySelector(`[data-right="${CSS.escape(select(row).value)}"]`);
        return `${textOf(row)} – ${textOf(right)}`;
      }).join("; "),
      marked: (shown) => {
        for (const row of chosen3())
          mark2(row, shown.includes(`pair-${row.dataset.left}`) ? "right" : "wrong");
      }
    };
  }
  function textOf(line) {
    return plainText(line?.querySelector(".carts-q-text"));
  }

  // src/question/forms/choice.js
  function choiceForm(root, changed) {
    const body = root.querySelector(".carts-q-body");
    const inputs = [...body.querySelectorAll("input")];
    const several = inputs.some((input) => input.type === "checkbox");
    for (const input of inputs) input.addEventListener("change", changed);
    const picked = () => inputs.filter((input) => input.checked);
    return {
      get value() {
        const values = picked().map((input) => input.value);
        return several ? values.sort() : values[0] ?? null;
      },
      set value(value) {
        const values = several ? Array.isArray(value) ? value : [] : [value];
        for (const input of inputs) input.checked = values.includes(input.value);
      },
      enable(on) {
        for (const input of inputs) input.disabled = !on;
      },
      said: () => picked().map((input) => words(input.closest("label"))).join("; ")
    };
  }
  function words(label) {
    const letter = label?.querySelector(".carts-q-letter")?.textContent;
    const text = plainText(label?.querySelector(".carts-q-text"));
    return letter ? `${letter}: ${text}` : text;
  }

  // ../view/bodies.js
  function forceOn(on, by) {
    return tr("force on {on} by {by}", { on, by });
  }

  // src/question/forms/diagram.js
  var APART = 7;
  var NEXT = {
    ArrowRight: 1,
    ArrowDown: 1,
    ArrowLeft: -1,
    ArrowUp: -1
  };
  var Diagram = class {
    #picked = null;
    #open = false;
    constructor(root, names, join) {
      this.names = names;
      this.join = join;
      this.picture = root.querySelector(".carts-q-diagram");
      this.drawn = root.querySelector(".carts-q-drawn");
      this.status = root.querySelector(".carts-q-picked");
      this.nodes = [...root.querySelectorAll(".carts-q-node")];
      put(this.picture, "role", "group");
      put(this.picture, "aria-label", tr("Choose one object, then the other."));
      for (const [k, node] of this.nodes.entries()) this.#listen(node, k);
      this.#show();
    }
    enable(on) {
      this.#open = on;
      this.#pick(null);
    }
    draw(lines) {
      const twice = ({ a, b }) => lines.filter((line) => line.a === a && line.b === b).length > 1;
      this.drawn.replaceChildren(
        ...lines.map((line) => {
          const side = twice(line) ? line.by === "contact" ? APART : -APART : 0;
          const d = path(this.#centre(line.a), this.#centre(line.b), side);
          return svg("path", { class: `carts-q-${line.by}`, "data-verdict": line.verdict, d });
        })
      );
    }
    #listen(node, k) {
      put(node, "role", "button");
      put(node, "aria-label", this.names[k] ?? "");
      put(node, "tabindex", k ? "-1" : "0");
      node.addEventListener("pointerdown", (event) => {
        if (!this.#open || event.button > 0) return;
        node.setPointerCapture(event.pointerId);
        const move = (now) => this.#rubber(k, now);
        node.addEventListener("pointermove", move);
        const end = (now) => {
          for (const kind of ["pointerup", "pointercancel"]) {
            node.removeEventListener(kind, end);
          }
          node.removeEventListener("pointermove", move);
          this.drawn.querySelector(".carts-q-rubber")?.remove();
          const to = this.#under(now);
          if (now.type === "pointercancel" || to < 0) return;
          if (to === k) this.#choose(k);
          else this.#done(k, to);
        };
        node.addEventListener("pointerup", end);
        node.addEventListener("pointercancel", end);
      });
      node.addEventListener("keydown", (event) => this.#key(event, k));
      node.addEventListener("click", ({ detail }) => {
        if (!detail) this.#choose(k);
      });
    }
    #key(event, k) {
      const step = NEXT[event.key];
      if (step) this.#focus((k + step + this.nodes.length) % this.nodes.length);
      else if (event.key === "Escape") this.#pick(null);
      else if (["Enter", " "].includes(event.key)) this.#choose(k);
      else return;
      event.preventDefault();
    }
    #focus(k) {
      for (const [other, node] of this.nodes.entries())
        put(node, "tabindex", other === k ? "0" : "-1");
      this.nodes[k]?.focus();
    }
    #choose(k) {
      if (!this.#open) return;
      const first = this.#picked;
      if (first === null) this.#pick(k);
      else if (first === k) this.#pick(null);
      else this.#done(first, k);
    }
    #done(from, to) {
      this.#pick(null);
      this.join(Math.min(from, to), Math.max(from, to));
    }
    #pick(k) {
      this.#picked = k;
      this.#show();
    }
    #show() {
      const first = this.#picked;
      for (const [k, node] of this.nodes.entries()) put(node, "aria-pressed", String(k === first));
      const words3 = tr("{object} and … ? Choose the other object.", {
        object: this.names[first ?? 0] ?? ""
      });
      say(this.status, first === null ? "" : words3);
    }
    #under({ clientX: x, clientY: y }) {
      return this.nodes.findIndex((node) => {
        const { left, right, top, bottom } = node.getBoundingClientRect();
        return left <= x && x <= right && top <= y && y <= bottom;
      });
    }
    #rubber(k, event) {
      const from = this.#centre(k);
      const box = this.picture.getBoundingClientRect();
      const scale = this.picture.viewBox.baseVal.width / box.width;
      const to = { x: (event.clientX - box.left) * scale, y: (event.clientY - box.top) * scale };
      const old = this.drawn.querySelector(".carts-q-rubber");
      const line = old ?? this.drawn.appendChild(svg("path", { class: "carts-q-rubber" }));
      put(line, "d", path(from, to, 0));
    }
    #centre(k) {
      const place2 = /translate\(([\d.]+) ([\d.]+)\)/.exec(
        this.nodes[k]?.getAttribute("transform") ?? ""
      );
      return { x: Number(place2?.[1]), y: Number(place2?.[2]) };
    }
  };
  function path(from, to, side) {
    const [dx, dy] = [to.x - from.x, to.y - from.y];
    const far = Math.hypot(dx, dy) || 1;
    const [sx, sy] = [-dy / far * side, dx / far * side];
    const at2 = (x, y) => `${x.toFixed(1)} ${y.toFixed(1)}`;
    return `M${at2(from.x + sx, from.y + sy)}L${at2(to.x + sx, to.y + sy)}`;
  }

  // src/question/forms/interactions.js
  function words2({ between: [a, b], by }) {
    return by === "contact" ? tr("{a} and {b} touch", { a, b }) : tr("{a} and {b}, without touching", { a, b });
  }
  function interactionsForm(root, changed, { objects, focus, key }) {
    const links = /* @__PURE__ */ new Map();
    let verdicts = {};
    let open2 = null;
    const radios = [
      ...root.querySelectorAll(".carts-q-ways input")
    ];
    const adder = need(root, ".carts-q-add");
    const [first, how, second] = [
      ...adder.querySelectorAll("select")
    ];
    const add2 = need(adder, "button");
    const list = need(root, ".carts-q-linked");
    const status2 = need(root, ".carts-q-picked");
    if (!first || !how || !second) throw new Error("this diagram lacks its lists");
    const way = () => radios.find((radio) => radio.checked)?.value ?? "contact";
    const name = ({ between, by }) => linkName(objects, between, by);
    const sorted = () => [...links].sort(([a], [b]) => a.localeCompare(b, "en")).map(([, link]) => link);
    const diagram = new Diagram(root, objects, (a, b) => toggle(a, b));
    function toggle(a, b, by = way()) {
      const link = { between: [objects[a], objects[b]], by };
      const gone = links.delete(name(link));
      if (!gone) links.set(name(link), link);
      touched(link, gone);
    }
    function touched(link, gone) {
      verdicts = {};
      changed();
      show();
      const said = { link: words2(link) };
      say(status2, gone ? tr("Removed: {link}", said) : tr("Added: {link}", said));
    }
    function show() {
      diagram.draw(
        sorted().map((link) => {
          const [a = 0, b = 0] = link.between.map((one) => objects.indexOf(one));
          return { a, b, by: link.by, verdict: verdicts[name(link)] ?? "" };
        })
      );
      list.replaceChildren(...sorted().map(row));
      for (const object of focus) forcesOn(object);
    }
    function row(link) {
      const [a, b] = link.between;
      const line = html("li");
      const verdict = verdicts[name(link)] ?? "";
      const remove = html("button", "carts-button", "×");
      put(remove, "type", "button");
      put(remove, "aria-label", tr("Remove: {link}", { link: words2(link) }));
      remove.disabled = add2.disabled;
      remove.addEventListener("click", () => {
        links.delete(name(link));
        touched(link, true);
        const next = list.querySelector("button");
        (next ?? first)?.focus();
      });
      const said = html("span", "carts-q-text");
      said.append(
        html("strong", "", words2(link)),
        html("span", "carts-q-pair-forces", `${forceOn(a, b)} · ${forceOn(b, a)}`)
      );
      const sign = { right: `✓ ${tr("right")}`, wrong: `✗ ${tr("not yet")}` }[verdict] ?? "";
      line.dataset.verdict = verdict;
      line.append(said, html("span", "carts-q-cell-mark", sign), remove);
      return line;
    }
    function forcesOn(object) {
      const place2 = root.querySelector(`[data-focus="${CSS.escape(object)}"] ul`);
      const acting = sorted().filter(({ between }) => between.includes(object));
      place2?.replaceChildren(
        ...acting.map(({ between: [a, b], by }) => {
          const line = html("li", "", forceOn(object, object === a ? b : a));
          line.classList.add(`carts-q-by-${by}`);
          return line;
        })
      );
    }
    const choose = (by) => {
      for (const radio of radios) radio.checked = radio.value === by;
      how.value = by;
    };
    for (const radio of radios) radio.addEventListener("change", () => choose(radio.value));
    how.addEventListener("change", () => choose(how.value));
    add2.addEventListener("click", () => {
      const ends = [first, second].map((select) => objects.indexOf(select.value)).sort();
      const [a = -1, b = -1] = ends;
      if (a < 0 || a === b) return say(status2, tr("Choose two different objects."));
      const known2 = linkName(objects, [objects[a], objects[b]], how.value);
      if (links.has(known2)) return say(status2, tr("This link is there already."));
      toggle(a, b, how.value);
      first.value = second.value = "";
      first.focus();
    });
    choose("contact");
    show();
    return {
      get value() {
        return links.size ? sorted() : null;
      },
      set value(value) {
        links.clear();
        verdicts = {};
        for (const link of Array.isArray(value) ? value : []) {
          const known2 = linkName(objects, link?.between, link?.by);
          const [a, b, by] = known2.split("-");
          const between = [a, b].map((k) => objects[Number(k) - 1]);
          if (known2) links.set(known2, { between, by: String(by) });
        }
        show();
      },
      enable(on) {
        if (on === open2) return;
        open2 = on;
        for (const one of [...radios, first, how, second, add2]) one.disabled = !on;
        diagram.enable(on);
        show();
      },
      said: () => sorted().map(words2).join("; "),
      marked: (shown) => {
        verdicts = Object.fromEntries(
          [...links.keys()].map((one) => [one, shown.includes(`link-${one}`) ? "right" : "wrong"])
        );
        show();
        const lost = (key?.links ?? []).some((link) => !links.has(name(link)));
        say(status2, lost ? tr("Somewhere a line is still missing.") : "");
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
    const at2 = ((c, i) => c[i]);
    const h = at2(times, k + 1) - at2(times, k);
    const s = (t - at2(times, k)) / h;
    if (!slopes) return at2(values, k) + (at2(values, k + 1) - at2(values, k)) * s;
    const r = 1 - s;
    const found2 = at2(values, k) * (1 + 2 * s) * r * r + at2(slopes, k) * h * s * r * r + at2(values, k + 1) * (1 + 2 * r) * s * s - at2(slopes, k + 1) * h * r * s * s;
    return Number.isFinite(found2) ? found2 : at2(values, k);
  }
  function turnAfter(times, values, slopes, k) {
    const [before, after] = [Number(slopes?.[k]), Number(slopes?.[k + 1])];
    const [begin, span] = [Number(times[k]), Number(times[k + 1]) - Number(times[k])];
    if (!slopes || !(before * after < 0) || !(span > 0)) return null;
    return hermite(times, values, slopes, k, begin + span * before / (before - after));
  }

  // src/question/marking/own-run.js
  var NOUGHT = 1e-12;
  function reading(run, mass, quantity, at2) {
    const [what, ...rest] = quantity.split(".");
    const whose = rest.join(".");
    const column = (what === "p" ? run.v : run[String(what)])?.[whose];
    if (!column?.length) return null;
    const factor = what === "p" ? mass[whose] ?? Number.NaN : 1;
    const slopes = { x: run.v, v: run.a, p: run.a, F: run.dF }[String(what)]?.[whose] ?? null;
    if (at2 === "largest") {
      let most = 0;
      const take = (value) => {
        if (Math.abs(value) > Math.abs(most)) most = value;
      };
      column.forEach(take);
      for (let k = 0; k < column.length; k += 1) take(turnAfter(run.t, column, slopes, k) ?? 0);
      return most * factor;
    }
    let scale = 0;
    for (const value of column) scale = Math.max(scale, Math.abs(value));
    const t = at2 === "end" ? run.t[run.t.length - 1] : at2 === "start" ? run.t[0] : Number(at2);
    const found2 = valueAt(run.t, column, slopes, t);
    return Math.abs(found2) <= NOUGHT * scale ? 0 : found2 * factor;
  }

  // src/question/marking/notation.js
  var RAISED = { "⁻": "-", "⁺": "+" };
  for (const [digit, raised] of [..."⁰¹²³⁴⁵⁶⁷⁸⁹"].entries()) RAISED[raised] = String(digit);
  var FACTOR = /\s*([/·⋅*.]?)\s*([A-Za-zµ°%]+)(?:([⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)|(?:\^|\*\*)\(?([+-]?\d(?:\.\d|\/\d)?)\)?|([+-]?\d))?/y;
  var POWER_OF_TEN = /\s*[×xX*·]\s*10(?:([⁺⁻]?[⁰¹²³⁴⁵⁶⁷⁸⁹]{1,3})|\s*(?:\^|\*\*)\s*(\(?[+-]?\d{1,3}\)?))/;
  var LONGEST2 = 30;
  var plain2 = (text) => text.replace(/[−‐‑–]/g, "-").replace(/μ/g, "µ");
  var lowered = (text) => [...text].map((sign) => RAISED[sign] ?? sign).join("");
  function number2(power) {
    const [above, below] = power.split("/").map(Number);
    return Number(above) / (below ?? 1);
  }
  function factors(unit) {
    const text = plain2(unit.trim());
    if (!text || text.length > LONGEST2) return null;
    const powers = /* @__PURE__ */ new Map();
    for (let at2 = 0; at2 < text.length; at2 = FACTOR.lastIndex) {
      FACTOR.lastIndex = at2;
      const found2 = FACTOR.exec(text);
      if (!found2 || at2 === 0 && found2[1]) return null;
      const power = number2(lowered(found2[3] ?? "") || found2[4] || found2[5] || "1");
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
    return plain2(text).replace(POWER_OF_TEN, (_, raised, power) => {
      return `e${lowered(raised ?? power).replace(/[()]/g, "")}`;
    });
  }

  // src/shared/typed.js
  var GROUPED = /^[+-]?[1-9]\d{0,2}(,\d{3})+(?![\d,])(\.\d*)?/;
  var APART2 = /^([+\-−–]?[1-9]\d{0,2})((?:[ \u00a0\u2009\u202f]\d{3})+)(?!\d)/;
  function tidy(typed) {
    const narrow = (sign) => String.fromCharCode(sign.charCodeAt(0) - 65248);
    return typed.trim().replace(/[０-９．，＋－]/g, narrow).replace(/^([+\-−–])\s+(?=[\d.,])/, "$1").replace(APART2, (whole2) => whole2.replace(/\s/g, ""));
  }
  function twoReadings(typed) {
    const text = GROUPED.exec(typed)?.[0];
    if (!text) return "";
    const whole2 = text.replaceAll(",", "");
    if (/[,.].*[,.]/.test(text)) return tr("Type {number} without commas.", { number: whole2 });
    const decimal = String(Number(text.replace(",", ".")));
    return tr("{text} can mean {decimal} or {whole}: type {decimal} or {whole}", {
      text,
      decimal,
      whole: whole2
    });
  }

  // src/question/marking/typed-number.js
  var LONGEST3 = 40;
  var NUMBER2 = /^([+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d+)?)\s*(.*)$/;
  var BARE = /^[\s+\-−–±\d.,eE]*$/;
  var INTERVAL = /^\(?(.+?)\s*(?:±|\+\/?-)\s*[\d.,]+\)?/;
  function withUnit(typed, unit) {
    const text = typed.trim();
    return text && unit && BARE.test(tidy(text)) ? `${text} ${unit}` : text;
  }
  function withoutUnit(said, unit) {
    return unit && said.endsWith(` ${unit}`) ? said.slice(0, -unit.length - 1) : said;
  }
  function readNumber(typed, units) {
    const text = withExponent(tidy(typed)).replace(INTERVAL, "$1");
    if (!text) return { problem: tr("Type a number, for example 0.5") };
    if (text.length > LONGEST3) return { problem: tr("That is too long for a number.") };
    const grouped2 = twoReadings(text);
    if (grouped2) return { problem: grouped2 };
    const found2 = NUMBER2.exec(text);
    if (!found2 || /^[.,]/.test(found2[2] ?? ""))
      return { problem: tr("“{text}” is not a number. Type for example 0.5", { text }) };
    const number3 = String(found2[1]);
    const unit = (found2[2] ?? "").replace(/(.)\.$/, "$1").replace(/\bK[gG]\b/, "kg");
    const known2 = Object.keys(units).filter(Boolean);
    const own = unit ? known2.find((one) => sameUnit(one, unit)) : "";
    const factor = unit ? own ? units[own] : void 0 : 1;
    if (factor === void 0) return { problem: unfit(unit, units) };
    const value = Number((Number(number3.replace(",", ".")) * factor).toPrecision(15));
    return Number.isFinite(value) ? { value } : { problem: tr("{text} is too large.", { text }) };
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
  function ownReading(facts) {
    const scene = document.getElementById(facts.scene);
    const run = scene?.trajectory;
    const set = setBy(scene);
    if (!run) return { own: null, set };
    const value = reading(run, masses(scene), facts.quantity, facts.at);
    return { own: value === null ? null : value / facts.per, set };
  }
  function readOff(facts, entry) {
    const { own, set } = ownReading(facts);
    delete entry.own;
    delete entry.set;
    return own === null ? entry : Object.assign(entry, { own, set });
  }
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
    for (const [path2, value] of Object.entries(setBy(scene))) {
      if (!path2.endsWith(".mass")) continue;
      const mass = readNumber(String(value), KILOGRAMS);
      if ("value" in mass) found2[path2.slice(0, -".mass".length)] = mass.value;
    }
    return found2;
  }
  function drawnForm(root, _changed, facts) {
    const done = root.querySelector(".carts-q-done");
    return {
      value: null,
      enable: () => {
      },
      said: () => "",
      follow: (book2) => {
        const entry = book2.get("worksheet", facts.scene);
        const locked = entry && !isEmpty(entry.value) && entry.locked;
        done.textContent = locked ? tr("✓ done") : "";
      }
    };
  }

  // ../view/scales.js
  var STEP_SLACK = 1e-9;
  var HEADROOM = 0.05;
  var NOUGHT2 = 1e-12;
  function axisDecimals(axis2) {
    return Math.max(0, -exponent(axis2.step));
  }
  function ticks(axis2) {
    const first = Math.ceil(axis2.low / axis2.step - STEP_SLACK);
    const last = Math.floor(axis2.high / axis2.step + STEP_SLACK);
    const found2 = [];
    for (let k = first; k <= last; k += 1) found2.push(k * axis2.step);
    return found2;
  }
  function niceAbove(value) {
    const power = Number(`1e${exponent(value)}`);
    for (const factor of [1, 2, 5]) {
      if (value <= factor * power * (1 + STEP_SLACK)) return factor * power;
    }
    return 10 * power;
  }
  function axis(low, high, count2) {
    const bottom = low < -NOUGHT2 ? low : 0;
    const above = high > NOUGHT2 ? high : 0;
    const top = above === bottom ? 1 : above;
    const room = HEADROOM * (top - bottom);
    return { low: bottom - room, high: top + room, step: niceAbove((top - bottom) / count2) };
  }

  // src/question/forms/table.js
  var [LEFT, RIGHT, TOP, BOTTOM] = [50, 305, 15, 160];
  var COUNT = 4;
  function tableForm(root, changed, facts) {
    const places = [...root.querySelectorAll("[data-cell]")];
    const name = (place2) => String(place2.dataset.cell);
    const box = (place2) => place2.querySelector("input");
    const label = (place2) => box(place2).getAttribute("aria-label") ?? "";
    const unit = (place2) => facts.cells[name(place2)]?.unit ?? "";
    const read = (place2) => readNumber(box(place2).value, facts.cells[name(place2)]?.units ?? {});
    const filled2 = () => places.filter((place2) => box(place2).value.trim());
    const draw = () => facts.plot && plot(root, facts, typed());
    const typed = () => Object.fromEntries(
      filled2().map((place2) => {
        const found2 = read(place2);
        return [name(place2), "value" in found2 ? found2.value : box(place2).value];
      })
    );
    for (const place2 of places) {
      box(place2).addEventListener("input", () => {
        for (const other of places) mark2(other, "");
        changed();
        draw();
      });
    }
    draw();
    return {
      get value() {
        return typed();
      },
      set value(value) {
        for (const place2 of places) {
          const kept = value && Object.hasOwn(value, name(place2)) ? value[name(place2)] : "";
          box(place2).value = String(kept);
          mark2(place2, "");
        }
        draw();
      },
      recall(said, value) {
        this.value = value;
        const parts = said.split("; ");
        for (const place2 of filled2()) {
          const part2 = parts.find((one) => one.startsWith(`${label(place2)}: `));
          const { value: plain3 } = box(place2);
          if (part2) box(place2).value = withoutUnit(part2.slice(label(place2).length + 2), unit(place2));
          if (typed()[name(place2)] !== value[name(place2)]) box(place2).value = plain3;
        }
      },
      enable(on) {
        for (const place2 of places) box(place2).readOnly = !on;
      },
      said: () => filled2().map((place2) => `${label(place2)}: ${withUnit(box(place2).value, unit(place2))}`).join("; "),
      problem: () => {
        for (const place2 of filled2()) {
          const found2 = read(place2);
          if ("problem" in found2) return `${label(place2)}: ${found2.problem}`;
        }
        return "";
      },
      marked: (shown) => {
        for (const place2 of filled2())
          mark2(place2, shown.includes(`cell-${name(place2)}`) ? "right" : "wrong");
      }
    };
  }
  function plot(root, { rows: rows2, plot: plot2, given }, value) {
    const known2 = { ...given, ...value };
    const [x, y] = plot2 ?? [1, 2];
    const points = rows2.map((_, r) => [known2[`${r + 1}-${x}`], known2[`${r + 1}-${y}`]]).filter((pair) => pair.every((number3) => typeof number3 === "number"));
    const columns = [0, 1].map((k) => points.map((point) => point[k]));
    const [across, up] = columns.map((all) => axis(Math.min(0, ...all), Math.max(0, ...all), COUNT));
    if (!across || !up) return;
    const at2 = (number3) => px(LEFT + (number3 - across.low) / (across.high - across.low) * (RIGHT - LEFT));
    const high = (number3) => px(BOTTOM - (number3 - up.low) / (up.high - up.low) * (BOTTOM - TOP));
    const numbers = (one) => ticks(one).map((tick) => ({ tick, text: fixed(tick, axisDecimals(one)) }));
    const lines = (xs, ys) => xs.map((one) => `M${at2(one)} ${TOP}V${BOTTOM}`).join("") + ys.map((one) => `M${LEFT} ${high(one)}H${RIGHT}`).join("");
    const part2 = (name) => root.querySelector(`.carts-q-plot .${name}`);
    put(part2("carts-grid"), "d", lines(ticks(across), ticks(up)));
    put(part2("carts-q-axes"), "d", lines([0], [0]));
    const place2 = root.querySelector(".carts-q-points");
    place2.replaceChildren(
      ...numbers(across).map(
        ({ tick, text }) => tickText(text, at2(tick), `${BOTTOM + 16}`, "middle")
      ),
      ...numbers(up).map(({ tick, text }) => tickText(text, `${LEFT - 6}`, high(tick), "end")),
      ...points.map(([a, b]) => svg("circle", { cx: at2(Number(a)), cy: high(Number(b)), r: 4.5 }))
    );
  }
  function tickText(text, x, y, anchor) {
    const made2 = svg("text", { x, y, "text-anchor": anchor });
    made2.textContent = text;
    return made2;
  }

  // src/question/forms/typed.js
  function wordsForm(root, changed) {
    const box = typedBox(root, changed);
    return {
      get value() {
        return box.value;
      },
      set value(value) {
        box.value = typeof value === "string" ? value : "";
      },
      enable: (on) => {
        box.readOnly = !on;
      },
      said: () => box.value
    };
  }
  function numberForm(root, changed, facts) {
    const box = typedBox(root, changed);
    const read = () => readNumber(box.value, facts.units);
    return {
      get value() {
        if (!box.value.trim()) return null;
        const found2 = read();
        return "value" in found2 ? found2.value : box.value;
      },
      set value(value) {
        box.value = value === null || value === void 0 ? "" : String(value);
      },
      enable: (on) => {
        box.readOnly = !on;
      },
      said: () => withUnit(box.value, facts.unit),
      recall: (said) => {
        box.value = withoutUnit(said, facts.unit);
      },
      problem: () => {
        const found2 = read();
        return "problem" in found2 ? found2.problem : "";
      }
    };
  }
  function typedBox(root, changed) {
    const box = root.querySelector(".carts-q-typed");
    box.addEventListener("input", changed);
    return box;
  }

  // src/question/forms/kinds.js
  var FORMS3 = {
    single: choiceForm,
    multiple: choiceForm,
    confidence: choiceForm,
    number: numberForm,
    reading: numberForm,
    short: wordsForm,
    long: wordsForm,
    ordering: orderForm,
    matching: matchForm,
    table: tableForm,
    interactions: interactionsForm,
    drawn: drawnForm,
    idea: (root, changed, { options }) => (options.length ? choiceForm : wordsForm)(root, changed)
  };

  // src/question/unread.js
  var PAUSE = 1500;
  var waiting = /* @__PURE__ */ new WeakMap();
  function complain(question, problem) {
    clearTimeout(waiting.get(question));
    const place2 = need(question, ".carts-q-error");
    say(place2, problem);
    place2.hidden = !problem;
  }
  function complainSoon(question) {
    complain(question, "");
    const timer = window.setTimeout(() => complain(question, question.unread), PAUSE);
    waiting.set(question, timer);
  }

  // src/question/element.js
  var NOT_SAVED = tr("Not saved");
  var SOON = 400;
  var LATE = 4e3;
  var ASKED = 300;
  function questionElement(book2) {
    return class CartsQuestion extends HTMLElement {
      #form = null;
      #feedback = null;
      #entry = null;
      #writes = 0;
      closed = false;
      #leaving = new AbortController();
      // ends what the question hears of page and answers
      #ready = false;
      // what was answered before is back: until then no field takes a key
      connectedCallback() {
        this.#leaving = new AbortController();
        if (!this.#form) this.#adopt();
        if (this.#form) this.#listen(this.#leaving.signal);
      }
      disconnectedCallback() {
        this.#leaving.abort();
      }
      #adopt() {
        this.facts = JSON.parse(need(this, "script.carts-q-facts").textContent ?? "{}");
        this.formName = this.closest("carts-quiz")?.getAttribute("data-form") ?? "worksheet";
        const make = FORMS3[this.facts.type];
        if (!make) return;
        this.#form = make(this, () => this.#changed(), this.facts);
        this.#entry = this.#fresh();
        for (const radio of this.#certainty()) {
          radio.addEventListener("change", () => this.#changed());
        }
        setTimeout(() => this.#ready || this.#say(tr("Opening your answers …")), SOON);
        if (this.facts.key)
          this.#feedback = new Feedback(
            this,
            () => this.#attempt(),
            (shown, verdict) => this.#marked(shown, verdict)
          );
        void book2.ready.then(() => this.#restore());
      }
      #listen(signal) {
        const elsewhere2 = ({ detail }) => detail === book2.key(this.formName ?? "worksheet", this.facts.id) && this.#show();
        book2.addEventListener("elsewhere", elsewhere2, { signal });
        book2.addEventListener("change", () => this.#form?.follow?.(book2), { signal });
        whenWatched(this, () => this.#ready && this.#keepAs(atTheRun(this.#entry)), signal);
        if (this.#ready) wait(this, signal);
      }
      get answered() {
        return !isEmpty(this.#form?.value);
      }
      get unread() {
        return this.answered && this.#form?.problem?.() || "";
      }
      get value() {
        return this.#form?.value ?? null;
      }
      close(closed) {
        this.closed = closed;
        this.#enable();
        need(this, ".carts-q-row").hidden = closed || !this.#feedback;
      }
      #enable() {
        const open2 = this.#ready && !this.closed;
        this.#form?.enable(open2);
        for (const radio of this.#certainty()) radio.disabled = !open2;
      }
      #fresh() {
        const { id, hash: hash2, type } = this.facts;
        return { id, hash: hash2, type, value: null, first: null, last: null, tries: 0 };
      }
      #certainty() {
        return [...this.querySelectorAll(".carts-q-sure input")];
      }
      #restore() {
        this.#say("");
        this.#show();
        this.#ready = true;
        this.#enable();
        this.dataset.ready = "";
        this.#form?.follow?.(book2);
        wait(this, this.#leaving.signal);
      }
      #show() {
        const found2 = book2.get(this.formName ?? "worksheet", this.facts.id);
        if (!found2 || !this.#form) return;
        const current = found2.hash === this.facts.hash && found2.type === this.facts.type;
        const earlier = [
          ...found2.earlier ?? [],
          ...current || isEmpty(found2.value) ? [] : [found2]
        ];
        if (current) {
          this.#entry = found2;
          if (this.#form.recall && typeof found2.said === "string")
            this.#form.recall(found2.said, found2.value);
          else this.#form.value = found2.value;
          for (const radio of this.#certainty()) radio.checked = radio.value === found2.sure;
          this.#say(isEmpty(found2.value) ? "" : this.#keptWord());
          const shown = found2.judged && this.#feedback?.again(this.#tried());
          if (shown) this.#form.marked?.(shown);
          else this.#feedback?.stale();
        }
        this.#print();
        showEarlier(this, earlier, this.facts.hash);
      }
      #changed() {
        if (this.closed || !this.#ready) return;
        const now = (/* @__PURE__ */ new Date()).toISOString();
        const sure = this.#certainty().find((radio) => radio.checked)?.value;
        const entry = {
          ...changing(this, this.#entry),
          judged: false,
          hash: this.facts.hash,
          value: this.#form?.value ?? null,
          said: this.#form?.said() ?? "",
          asked: plainText(need(this, ".carts-q-ask")).slice(0, ASKED),
          first: this.#entry.first ?? now,
          last: now
        };
        if (this.facts.unit) entry.unit = this.facts.unit;
        const other = entry.value !== this.#entry.value;
        if (this.facts.type === "reading" && other) readOff(this.facts, entry);
        if (sure) entry.sure = sure;
        this.#entry = entry;
        void this.#keep();
        this.#feedback?.stale();
        if (this.#feedback) complain(this, "");
        else complainSoon(this);
        this.#print();
        this.dispatchEvent(new CustomEvent("carts-answer", { bubbles: true }));
      }
      #keepAs(entry) {
        if (entry === this.#entry) return;
        this.#entry = entry;
        void this.#keep();
      }
      async #keep() {
        this.#writes += 1;
        const mine = this.#writes;
        this.#say(tr("Saving…"));
        const late = setTimeout(() => mine === this.#writes && this.#say(NOT_SAVED), LATE);
        try {
          await book2.put(this.formName ?? "worksheet", this.#entry);
          if (mine === this.#writes) this.#say(this.#keptWord());
        } catch {
          this.#say(NOT_SAVED);
        } finally {
          clearTimeout(late);
        }
      }
      #keptWord() {
        return book2.lasts ? tr("Saved") : NOT_SAVED;
      }
      #attempt() {
        if (!this.answered || this.unread) {
          complain(this, this.unread || tr("Answer first."));
          return null;
        }
        if (this.facts.type === "reading") {
          if (this.#entry.own === void 0) this.#entry = readOff(this.facts, { ...this.#entry });
          if (this.#entry.own === void 0) {
            complain(this, tr("Run the scene first: lock your prediction there."));
            return null;
          }
        }
        this.#keepAs(tried(this.#entry));
        return this.#tried();
      }
      #tried() {
        const { own = null, tries = 0 } = this.#entry;
        return { value: this.#form?.value, own, tries };
      }
      #marked(shown, verdict) {
        this.#form?.marked?.(shown);
        this.#keepAs(checked(this.#entry, verdict));
      }
      #print() {
        const said = this.#form?.said() ?? "";
        const free = ["short", "long", "number", "reading", "ordering"].includes(this.facts.type);
        say(need(this, ".carts-q-printed"), free ? said : "");
        this.toggleAttribute("data-answered", this.answered);
        const first = this.facts.idea && this.answered && book2.get("worksheet", this.facts.idea);
        showFirstIdea(this, first || null);
      }
      #say(word) {
        const place2 = need(this, ".carts-q-saved");
        say(place2, word);
        place2.classList.toggle("carts-q-unsaved", word === NOT_SAVED);
      }
    };
  }

  // src/shared/menu-key.js
  function menuByKey() {
    const box = document.getElementById("__drawer");
    const button2 = document.querySelector("label.md-header__button[for=__drawer]");
    const menu = document.querySelector("nav.md-nav--primary");
    if (!box || !menu || !button2) return;
    button2.tabIndex = 0;
    button2.setAttribute("role", "button");
    button2.setAttribute("aria-label", menu.getAttribute("aria-label") ?? "");
    const tell = () => button2.setAttribute("aria-expanded", String(box.checked));
    tell();
    box.addEventListener("change", () => {
      tell();
      if (box.checked && button2.matches(":focus-visible"))
        menu.querySelector("li a")?.focus();
    });
    button2.addEventListener("keydown", (event) => {
      if (event.key !== " ") return;
      event.preventDefault();
      button2.click();
    });
    menu.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || !box.checked) return;
      box.click();
      button2.focus();
    });
  }

  // src/answers-main.js
  var book = new Book();
  customElements.define("carts-question", questionElement(book));
  customElements.define("carts-after", CartsAfter);
  customElements.define("carts-quiz", quizElement(book));
  var panel = new Panel(book);
  new Bar(book, () => void panel.open());
  emptyWhereUntouched(book);
  void book.ready.then(() => performance.mark("carts:answers"));
  teacherDoor();
  menuByKey();
  document.documentElement.dataset.cartsAnswers = "";
})();
