"use strict";
(() => {
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
    const asked = RULE ? Number(RULE[n < RULE.length ? n : 100 + n % 100]) : english;
    return String(ours[Math.min(asked, ours.length - 1)]);
  }
  function filled(template, values) {
    return template.replace(/\{(\w+)\}/g, (whole, name) => String(values[name] ?? whole));
  }

  // src/shared/dom.js
  var SVG = "http://www.w3.org/2000/svg";
  function svg(tag, attributes = {}) {
    const made = document.createElementNS(SVG, tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
    return made;
  }
  function html(tag, className = "", text = "") {
    const made = document.createElement(tag);
    if (className) made.className = className;
    if (text) made.textContent = text;
    return made;
  }
  var TEXT = 3;
  function say(element, text) {
    const only = element.firstChild;
    if (only?.nodeType === TEXT && !only.nextSibling) {
      if (only.nodeValue !== text) only.nodeValue = text;
    } else if (element.textContent !== text) element.textContent = text;
  }

  // src/shared/code-word.js
  function codeWord(typed) {
    const parts = typed.normalize("NFKC").toUpperCase().split(/[+&]/).map((part) => part.trim().replace(/[\s–—−_]+/g, "-"));
    return [...new Set(parts)].sort().join("+");
  }

  // src/class/brought-along.js
  var STRING = /"(?:[^"\\]|\\.)*"/g;
  var inFull = (given) => given.map((key) => {
    if (typeof key === "string") return key;
    let n = 0;
    return given[key[0]].replace(STRING, (same) => {
      const own = key[++n];
      return typeof own === "string" ? JSON.stringify(own) : same;
    });
  });

  // src/class/nameless.js
  var Names = class {
    #given = /* @__PURE__ */ new Map();
    #taken = /* @__PURE__ */ new Set();
    #often = /* @__PURE__ */ new Map();
    of(name, begun) {
      const file = JSON.stringify([name, begun]);
      const before = this.#given.get(file);
      if (before !== void 0) return before;
      let number = (this.#often.get(name) ?? 0) + 1;
      while (this.#taken.has(numbered(name, number))) number += 1;
      this.#often.set(name, number);
      const found = numbered(name, number);
      this.#taken.add(found);
      this.#given.set(file, found);
      return found;
    }
  };
  function numbered(name, number) {
    const [, stem = "", ending = ""] = /^(.+?)(\.[^.]*)?$/s.exec(name) ?? [];
    return number < 2 ? name : `${stem} (${number})${ending}`;
  }

  // src/class/classroom.js
  var WHOLE = "class";
  var [NAME, STUDENT, CREATED] = [0, 4, 6];
  var Classroom = class {
    files = [];
    nameless = new Names();
    // the names of files without a code word
    keys = [];
    practice = inFull(globalThis.__cartsKeys ?? []);
    marks = /* @__PURE__ */ new Map();
    refused = [];
    codes = ["", ""];
    // as typed, of each group
    unfiled = false;
    // marks of this visit are in no file
    tables = [];
    most = "";
    // marks of the tests in them, as typed
    two = false;
    names = [tr("experimental"), tr("control")];
    get empty() {
      return this.noAnswers && !this.tables.length;
    }
    get noAnswers() {
      return !this.files.length && !this.keys.length && !this.refused.length && !this.typed;
    }
    get typed() {
      return this.codes.some(Boolean);
    }
    get unsaved() {
      return this.unfiled || this.typed || this.files.some(({ named }) => named);
    }
    get groups() {
      if (!this.two) return [WHOLE];
      const [one, other] = this.names.map((name, k) => name.trim() || tr("group {n}", { n: k + 1 }));
      return [one ?? "", one === other ? `${other} (2)` : other ?? ""];
    }
    take(found, group) {
      for (const row2 of found.records) {
        if (!row2[STUDENT].trim()) row2[NAME] = this.nameless.of(row2[NAME], row2[CREATED]);
        this.files.push({ row: row2, group, out: false });
      }
      for (const key of found.keys) if (!this.keys.includes(key)) this.keys.push(key);
      for (const mark of found.marks) this.give(mark);
      this.refused.push(...found.refused);
    }
    give(mark) {
      const { lesson, form: form2, student, item } = mark;
      this.marks.set(JSON.stringify([lesson, form2, codeWord(student), item]), mark);
    }
    mark(mark) {
      this.unfiled = true;
      this.give(mark);
    }
    name(file, typed) {
      const before = this.#who(file);
      file.row[STUDENT] = codeWord(typed);
      file.named = true;
      if (this.files.some((other) => this.#who(other) === before)) return;
      const [, , lesson, , , form2] = file.row;
      for (const [key, mark] of [...this.marks]) {
        if (mark.lesson !== lesson || mark.form !== form2 || codeWord(mark.student) !== before)
          continue;
        this.marks.delete(key);
        this.give({ ...mark, student: this.#who(file) });
      }
    }
    #who({ row: row2 }) {
      return codeWord(row2[STUDENT] || `no code word (${row2[NAME]})`);
    }
    told() {
      const { groups } = this;
      return {
        kind: "class",
        records: this.files.filter((file) => !file.out).map(({ row: row2, group }) => [row2, groups[this.two ? group : 0]]),
        keys: [...this.practice, ...this.keys],
        // of one form the later one counts
        marks: [...this.marks.values()],
        refused: this.refused,
        codes: this.codes,
        groups,
        now: (/* @__PURE__ */ new Date()).toISOString()
      };
    }
    toldOfTables() {
      const { groups } = this;
      const of = (table) => this.two ? table.group : 0;
      const tables = [...this.tables].sort((one, other) => of(one) - of(other)).map((table) => ({ ...table, group: groups[of(table)] }));
      return { kind: "class", tables, most: this.most };
    }
    toldOfAll() {
      return {
        ...this.noAnswers ? {} : this.told(),
        ...this.tables.length ? this.toldOfTables() : {}
      };
    }
    divide(two) {
      this.two = two;
      if (!two) this.codes = [this.codes.filter(Boolean).join("\n"), ""];
    }
    typeCodes(group, text) {
      this.codes[group] = text;
    }
    marksFile() {
      const rows = [...this.marks.values()].map((mark) => ({
        ...mark,
        student: codeWord(mark.student)
      }));
      return `${JSON.stringify({ format: 1, kind: "newtons-carts-marks", marks: rows }, null, 1)}
`;
    }
  };

  // src/answers/parts.js
  function button(text, act, name = "") {
    const made = html("button", `carts-button ${name}`.trim(), text);
    made.type = "button";
    made.addEventListener("click", act);
    return made;
  }
  var count = 0;
  function askingButton(text, question, yes, act, name, not = tr("No")) {
    const row2 = html("p", `carts-answers-asking ${name}`);
    const first = button(text, () => ask(true));
    const asked = html("span");
    const words = html("span", "", question);
    count += 1;
    words.id = `${name}-${count}`;
    const no = button(not, () => ask(false), "carts-answers-no");
    const go = () => {
      ask(false);
      act();
    };
    const does = button(yes, go, "carts-answers-yes");
    for (const one of [does, no]) one.setAttribute("aria-describedby", words.id);
    asked.append(words, " ", does, " ", no);
    asked.hidden = true;
    row2.append(first, asked);
    function ask(on) {
      first.hidden = on;
      asked.hidden = !on;
      (on ? no : first).focus();
    }
    return row2;
  }

  // src/class/list.js
  function fileList(classroom, changed) {
    const root = html("details", "carts-class-list");
    const title = html("summary", "", tr("Files"));
    const rows = html("ul");
    root.append(title, rows);
    const made = /* @__PURE__ */ new WeakMap();
    const lineOf = (file) => {
      const group = classroom.two ? ` · ${classroom.groups[file.group]}` : "";
      const [name, , lesson, , student, form2] = file.row;
      const words = JSON.stringify([name, lesson, student, form2, group]);
      const before = made.get(file);
      if (before?.words === words) return before.line;
      const line = lineFor(classroom, file, group, changed);
      made.set(file, { words, line });
      return line;
    };
    const fill = () => {
      if (!root.open) return rows.replaceChildren();
      classroom.files.map(lineOf).forEach((line, k) => {
        const before = rows.children[k];
        if (!before) rows.append(line);
        else if (before !== line) before.replaceWith(line);
      });
      while (rows.children.length > classroom.files.length) rows.lastElementChild?.remove();
    };
    root.addEventListener("toggle", fill);
    const draw = () => {
      const out = classroom.files.filter((file) => file.out).length;
      const parts = [tr("Files: {n}", { n: classroom.files.length })];
      if (out) parts.push(tr("{n} left out", { n: out }));
      parts.push(keysWord(classroom.keys.length));
      say(title, parts.join(", "));
      fill();
    };
    return { root, draw };
  }
  function lineFor(classroom, file, group, changed) {
    const line = html("li");
    const label = html("label");
    const box = html("input");
    Object.assign(box, { type: "checkbox", checked: !file.out });
    box.addEventListener("change", () => {
      file.out = !box.checked;
      changed();
    });
    const [name, , lesson, , student, form2] = file.row;
    label.append(
      box,
      " ",
      html("bdi", "", student || tr("no code word")),
      ` · ${form2} · ${lesson}${group} `,
      html("span", "carts-class-quiet", name)
    );
    line.append(label);
    if (!student || file.named) line.append(" ", codeFor(classroom, file, changed));
    return line;
  }
  function keysWord(count2) {
    if (!count2) return tr("no key file");
    return counted("key for 1 form", "key for {n} forms", count2);
  }
  function codeFor(classroom, file, changed) {
    const box = html("input", "carts-class-whose");
    Object.assign(box, { type: "text", maxLength: 90, spellcheck: false });
    box.placeholder = tr("code word");
    box.setAttribute("aria-label", tr("code word for {file}", { file: file.row[0] }));
    box.addEventListener("change", () => {
      classroom.name(file, box.value);
      changed();
    });
    return box;
  }
  var PAUSE = 500;
  function typedIn(box, take, act) {
    let timer = 0;
    box.addEventListener("input", () => {
      take(box.value);
      clearTimeout(timer);
      timer = window.setTimeout(act, PAUSE);
    });
  }
  function typedCodes(classroom, changed) {
    const root = html("details", "carts-class-codes");
    root.append(html("summary", "", tr("Typed codes")));
    const boxes = [0, 1].map((group) => codesOf(classroom, group, changed));
    const draw = () => {
      classroom.groups.forEach((_, group) => {
        const box = boxes[group];
        box?.draw();
        if (box && box.root.parentNode !== root) root.append(box.root);
      });
      if (!classroom.two) boxes[1]?.root.remove();
    };
    return { root, draw };
  }
  function codesOf(classroom, group, changed) {
    const root = html("label");
    const whose = html("bdi");
    const box = html("textarea");
    Object.assign(box, { rows: 4, spellcheck: false, placeholder: "BLUE-FOX-27 pre 7K2M-Q9ZD-03HX" });
    typedIn(box, (text) => classroom.typeCodes(group, text), changed);
    root.append(whose, tr("A line each: code word, form, code"), box);
    const draw = () => {
      say(whose, classroom.two ? `${classroom.groups[group]} · ` : "");
      const text = classroom.codes[group] ?? "";
      if (box.value !== text) box.value = text;
    };
    return { root, draw };
  }

  // src/class/drops.js
  function drops(classroom, take, changed) {
    const root = html("div", "carts-class-drops");
    const two = html("input", "carts-class-two");
    two.type = "checkbox";
    const label = html("label", "carts-class-choice");
    label.append(two, " ", tr("two groups, one beside the other"));
    const fields = html("div", "carts-class-fields");
    const draw = () => {
      two.checked = classroom.two;
      const count2 = classroom.two ? [0, 1] : [0];
      fields.replaceChildren(...count2.map((group) => field(classroom, group, take, changed)));
    };
    two.addEventListener("change", () => {
      classroom.divide(two.checked);
      draw();
      changed();
    });
    draw();
    root.append(label, fields);
    return { root, draw };
  }
  function field(classroom, group, take, changed) {
    const root = html("div", "carts-class-drop");
    if (classroom.two) root.append(nameBox(classroom, group, changed));
    const says = html(
      "p",
      "",
      tr(
        "Drop answer files, a zip and the key file here, or tables of marks (CSV), one after the other or all at once; or"
      )
    );
    root.append(says);
    const row2 = html("p", "carts-class-row");
    for (const [text, folder] of [
      [tr("Choose files"), false],
      [tr("Choose a folder"), true]
    ]) {
      const box = html("input", "carts-class-files");
      Object.assign(box, { type: "file", multiple: true, hidden: true, tabIndex: -1 });
      if (folder) box.setAttribute("webkitdirectory", "");
      else box.accept = ".json,.zip,.csv,.tsv,application/json,application/zip,text/csv";
      box.addEventListener("change", () => {
        const chosen = [...box.files ?? []].filter(
          (file) => !folder || /\.(json|zip|csv|tsv)$/i.test(file.name)
        );
        box.value = "";
        if (chosen.length) take(chosen, group);
      });
      row2.append(
        button(text, () => box.click(), folder ? "carts-class-folder" : "carts-class-pick"),
        box,
        " "
      );
    }
    root.append(row2);
    listen(root, says, (files) => take(files, group));
    return root;
  }
  function listen(root, says, take) {
    const over = (on) => root.classList.toggle("carts-class-over", on);
    root.addEventListener("dragover", (event) => {
      event.preventDefault();
      over(true);
    });
    root.addEventListener("dragleave", () => over(false));
    root.addEventListener("drop", (event) => {
      event.preventDefault();
      over(false);
      const items = [...event.dataTransfer?.items ?? []];
      const folders = items.some((item) => item.webkitGetAsEntry?.()?.isDirectory);
      const files = [...event.dataTransfer?.files ?? []];
      if (folders)
        say(says, tr("For a folder use the button “Choose a folder”. Files can be dropped, or"));
      else if (files.length) take(files);
    });
  }
  function nameBox(classroom, group, changed) {
    const label = html("label", "carts-class-name", `${tr("Group")} `);
    const box = html("input");
    Object.assign(box, { value: classroom.names[group], maxLength: 40 });
    const take = (text) => {
      classroom.names[group] = text;
    };
    typedIn(box, take, changed);
    label.append(box);
    return label;
  }

  // src/class/held-focus.js
  var BY_KEYS = "button, input:not([hidden]), select, textarea, summary";
  function holdingFocus(root, draw) {
    const places = () => [...root.querySelectorAll(BY_KEYS)];
    const held = document.activeElement;
    const at = places().indexOf(held);
    draw();
    if (at >= 0 && !held.isConnected) places()[at]?.focus({ preventScroll: true });
  }

  // src/class/intake.js
  var MOST_JSON = 3e7;
  var MOST_ZIP = 6e7;
  var PARCEL_BYTES = 1e6;
  var PARCEL_FILES = 25;
  var MOST_TABLE = 1e7;
  var isTable = ({ name }) => /\.(csv|tsv|xlsx?|ods)$/i.test(name);
  async function asTable(file, group) {
    if (file.size > MOST_TABLE) return tr("this table is too large for a page");
    const base64 = await asBase64(file);
    if (base64 === null) return tr("this file cannot be read");
    return { name: file.name, base64, form: "", group };
  }
  async function readAll(files, ask, found) {
    let done = 0;
    for (const parcel of parcels(files)) {
      const refused = [];
      const sent = [];
      for (const file of parcel) {
        const name = file.webkitRelativePath || file.name;
        const reason = tooLarge(file);
        const base64 = reason ? null : await asBase64(file);
        if (base64 === null) refused.push([name, reason || tr("this file cannot be read")]);
        else sent.push({ name, base64 });
      }
      done += parcel.length;
      if (refused.length) {
        await found({ records: [], keys: [], marks: [], refused, next: null }, done);
      }
      let from = sent.length ? 0 : null;
      let held = false;
      try {
        while (from !== null) {
          const files2 = held ? {} : { files: sent };
          const answer = await ask({ kind: "class", do: "read", from, ...files2 });
          held = !answer.lost;
          if (!held) continue;
          from = answer.next;
          await found(answer, done);
        }
      } finally {
        if (from) void ask({ kind: "class", do: "read", files: [] }).catch(() => {
        });
      }
    }
  }
  function* parcels(files) {
    let parcel = [];
    let bytes = 0;
    for (const file of files) {
      if (parcel.length && (bytes + file.size > PARCEL_BYTES || parcel.length >= PARCEL_FILES)) {
        yield parcel;
        [parcel, bytes] = [[], 0];
      }
      parcel.push(file);
      bytes += file.size;
    }
    if (parcel.length) yield parcel;
  }
  function tooLarge(file) {
    if (file.size <= MOST_JSON) return "";
    if (!file.name.toLowerCase().endsWith(".zip")) {
      return tr("this file is too large to be a file of answers");
    }
    return file.size > MOST_ZIP ? tr("this zip is too large for a page: use “carts class”") : "";
  }
  function asBase64(file) {
    return new Promise((resolve) => {
      const reader2 = new FileReader();
      reader2.onload = () => resolve(String(reader2.result).split(",")[1] ?? "");
      reader2.onerror = () => resolve(null);
      reader2.readAsDataURL(file);
    });
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

  // src/class/papers.js
  var PRINTING = "carts-class-paper-only";
  var languages = () => globalThis.__cartsPapers ?? { en: { name: "English", words: {} } };
  function spokenHere() {
    const spoken = languages();
    const own = document.documentElement.lang;
    const base = own.split("-")[0];
    const codes = Object.keys(spoken);
    const language = codes.find((c) => c === own) ?? codes.find((c) => c.split("-")[0] === base);
    return { language: language ?? "en", words: spoken[language ?? ""]?.words ?? {} };
  }
  function papers({ noAnswers, keys, ask, say: say2 }) {
    const root = html("div", "carts-class-papers");
    const shown = html("div", "carts-class-paper");
    const spoken = languages();
    const pick = html("select", "carts-class-language");
    pick.setAttribute("aria-label", tr("Language of the slips and of the page of the class"));
    pick.append(
      ...Object.entries(spoken).map(([code, { name }]) => {
        const option = html("option", "", name);
        option.value = code;
        option.lang = code;
        return option;
      })
    );
    pick.value = spokenHere().language;
    const answers = html("input", "carts-class-with-answers");
    answers.type = "checkbox";
    const label = html("label", "carts-class-choice");
    label.append(answers, " ", tr("slips with the right answers"));
    const make = (what) => async () => {
      try {
        say2(tr("Making the pages …"));
        const wanted = { what, language: pick.value, words: spoken[pick.value]?.words ?? {} };
        const dropped = what === "key" ? { keys: keys() } : {};
        const header = await ask({ do: "paper", ...wanted, ...dropped, answers: answers.checked });
        shown.innerHTML = header.html;
        shown.lang = pick.value;
        say2("");
        print();
      } catch (error) {
        say2(error.message);
      }
    };
    const row2 = html("p", "carts-class-row");
    row2.append(
      button(tr("Print slips for students"), make("slips"), "carts-class-slips"),
      button(tr("Print page of the class"), make("sheet"), "carts-class-sheet"),
      pick,
      label
    );
    const key = button(tr("Print answers and rubrics"), make("key"), "carts-class-print-key");
    const ofTeacher = html("p", "carts-class-row");
    ofTeacher.append(key);
    root.append(row2, ofTeacher);
    const draw = () => {
      row2.hidden = noAnswers();
      ofTeacher.hidden = !keys().length;
      root.hidden = row2.hidden && ofTeacher.hidden;
      shown.replaceChildren();
    };
    return { root, shown, draw };
  }
  function print() {
    const { classList } = document.documentElement;
    classList.add(PRINTING);
    printWith(() => classList.remove(PRINTING));
  }

  // src/class/reader.js
  function reader(classroom, marked) {
    const root = html("details", "carts-class-reader");
    const title = html("summary", "", tr("Read and mark"));
    const body = html("div");
    root.append(title, body);
    let questions = [];
    let chosen = "";
    let at = 0;
    const name = (one) => `${one.lesson} · ${one.form} · ${one.id}`;
    const question = () => questions.find((one) => name(one) === chosen) ?? questions[0];
    const markOf = (one, student) => classroom.marks.get(JSON.stringify([one.lesson, one.form, codeWord(student), one.id]))?.marks;
    const give = (one, marks) => {
      const answer = one.answers[at];
      if (!answer || marks > one.worth) return;
      const { lesson, form: form2, id: item } = one;
      classroom.mark({ lesson, form: form2, student: answer.student, item, marks });
      at = Math.min(at + 1, one.answers.length - 1);
      show();
      marked();
    };
    const show = () => {
      const one = question();
      root.hidden = !one;
      if (!one) return;
      at = Math.min(at, one.answers.length - 1);
      const answer = one.answers[at];
      const done = one.answers.filter(({ student }) => markOf(one, student) !== void 0).length;
      const n = questions.length;
      say(title, counted("Read and mark: 1 question", "Read and mark: {n} questions", n));
      const pick = html("select", "carts-class-question");
      pick.setAttribute("aria-label", tr("Question"));
      pick.append(...questions.map((q) => new Option(q.title, name(q), false, q === one)));
      pick.addEventListener("change", () => {
        chosen = pick.value;
        at = 0;
        show();
      });
      const card = html("div", "carts-class-answer");
      card.tabIndex = 0;
      card.setAttribute("role", "group");
      card.setAttribute("aria-label", tr("Answer; the keys 0, 1, 2 give marks"));
      if (answer) {
        const given = markOf(one, answer.student);
        const head = html("p", "carts-class-quiet");
        head.append(
          tr("{at} of {all}", { at: at + 1, all: one.answers.length }),
          " · ",
          html("bdi", "", answer.shown),
          " · ",
          given === void 0 ? tr("not marked") : tr("{marks} of {of}", { marks: given, of: one.worth })
        );
        card.append(head, html("p", "carts-class-text", answer.text));
      }
      const row2 = html("p", "carts-class-row");
      for (let marks = 0; marks <= one.worth; marks += 1) {
        row2.append(
          button(String(marks), () => give(one, marks), "carts-class-mark"),
          " "
        );
      }
      const step = (by) => () => {
        at = Math.max(0, Math.min(one.answers.length - 1, at + by));
        show();
      };
      row2.append(button(tr("Back"), step(-1)), " ", button(tr("Skip"), step(1)));
      const rubric = html("ul", "carts-class-rubric");
      for (const [marks, text] of Object.entries(one.rubric)) {
        rubric.append(html("li", "", `${marks}: ${text}`));
      }
      const focused = body.contains(document.activeElement);
      body.replaceChildren(
        pick,
        html("p", "", one.ask),
        rubric,
        card,
        row2,
        html(
          "p",
          "carts-class-quiet",
          tr("{done} of {all} marked.", { done, all: one.answers.length })
        )
      );
      if (focused) card.focus({ preventScroll: true });
    };
    body.addEventListener("keydown", (event) => {
      const one = question();
      const inBox = event.target instanceof HTMLSelectElement;
      if (!one || inBox || event.ctrlKey || event.metaKey || event.altKey) return;
      if (event.repeat) return;
      if (/^\d$/.test(event.key) && Number(event.key) <= one.worth) {
        event.preventDefault();
        give(one, Number(event.key));
      }
    });
    return {
      root,
      draw(found) {
        questions = found;
        show();
      }
    };
  }

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

  // src/shared/picture.js
  var PIXELS = 2;
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

  // src/class/plots.js
  var WIDTH = 620;
  var GAP = 16;
  var LOOKS = [
    "fill",
    "stroke",
    "stroke-width",
    "opacity",
    "font-size",
    "font-family",
    "text-anchor"
  ];
  async function plotsAsPng(report) {
    const plots = [...report.querySelectorAll(".carts-class-plot")];
    if (!plots.length) return null;
    const whole = svg("svg", { xmlns: "http://www.w3.org/2000/svg", width: WIDTH });
    const paper = getComputedStyle(report).getPropertyValue("--carts-paper").trim() || "#fff";
    const sheet = svg("rect", { width: WIDTH, fill: paper });
    whole.append(sheet);
    let y = GAP;
    for (const plot of plots) {
      const copy = plot.cloneNode(true);
      const [from, to] = [[...plot.querySelectorAll("*")], [...copy.querySelectorAll("*")]];
      from.forEach((part, k) => {
        const style = getComputedStyle(part);
        for (const look of LOOKS)
          to[k]?.setAttribute(look, style.getPropertyValue(look).replaceAll('"', "'"));
      });
      const { width, height } = plot.viewBox.baseVal;
      for (const [name, value] of Object.entries({ x: 0, y, width, height })) {
        copy.setAttribute(name, String(value));
      }
      whole.append(copy);
      y += height + GAP;
    }
    for (const part of [whole, sheet]) part.setAttribute("height", String(y));
    return asPng(new XMLSerializer().serializeToString(whole));
  }

  // src/class/saves.js
  function actions({ element, report, ask, say: say2, clear }) {
    const root = html("div", "carts-class-actions");
    const save = (what, name, type) => async () => {
      try {
        const { text } = await ask(what);
        download(name, text, type);
        say2(tr("Saved as {name}: look in your folder “Downloads”.", { name }));
      } catch (error) {
        say2(error.message);
      }
    };
    const marks = button(
      tr("Save marks"),
      () => {
        download("class.marks.json", element.classroom.marksFile(), "application/json");
        element.classroom.unfiled = false;
        say2(
          tr("Saved as {name}. Drop it here with the files next time.", { name: "class.marks.json" })
        );
      },
      "carts-class-save-marks"
    );
    const row2 = html("p", "carts-class-row");
    row2.append(
      button(tr("Print this report"), () => window.print(), "carts-class-print"),
      " ",
      button(
        tr("Save report"),
        save("html", "class-results.html", "text/html"),
        "carts-class-save-html"
      ),
      " ",
      button(
        tr("Students (CSV)"),
        save("csv", "class-students.csv", "text/csv"),
        "carts-class-save-csv"
      ),
      " ",
      button(
        tr("Questions (CSV)"),
        save("items", "class-questions.csv", "text/csv"),
        "carts-class-save-items"
      ),
      " ",
      button(
        tr("Plots (PNG)"),
        async () => {
          const picture = await plotsAsPng(report);
          if (!picture) return say2(tr("There is no plot yet: it takes five students and a key."));
          downloadBlob("class-plots.png", picture);
          return say2(tr("Saved as {name}.", { name: "class-plots.png" }));
        },
        "carts-class-save-png"
      ),
      " ",
      marks
    );
    const remove = askingButton(
      tr("Delete everything"),
      tr("Forget all files, codes and marks on this page?"),
      tr("Delete"),
      clear,
      "carts-class-clear",
      tr("Keep them")
    );
    root.append(row2, remove);
    const draw = () => {
      root.hidden = element.classroom.empty;
      marks.hidden = !element.classroom.marks.size;
    };
    return { root, draw };
  }

  // src/class/staying.js
  function stay(classroom, signal) {
    const drop = (event) => {
      const { defaultPrevented, dataTransfer } = event;
      if (defaultPrevented || !dataTransfer?.types.includes("Files")) return;
      event.preventDefault();
      dataTransfer.dropEffect = "none";
    };
    addEventListener("dragover", drop, { signal });
    addEventListener("drop", drop, { signal });
    const leave = (event) => {
      if (!classroom.unsaved) return;
      event.preventDefault();
      event.returnValue = true;
    };
    addEventListener("beforeunload", leave, { signal });
  }

  // src/class/tables.js
  var TIMES = [
    ["", tr("as the table says")],
    ["pre", tr("before teaching")],
    ["post", tr("after teaching")],
    ["later", tr("some time later")]
  ];
  function tableList(classroom, changed) {
    const root = html("div", "carts-class-tables");
    const rows = html("ul");
    const label = html(
      "label",
      "",
      `${tr("Most marks of the test, if the table gives only totals")} `
    );
    const most = html("input");
    Object.assign(most, { type: "text", size: 6, inputMode: "decimal", autocomplete: "off" });
    const take = (text) => {
      classroom.most = text;
    };
    typedIn(most, take, changed);
    label.append(most);
    root.append(html("p", "carts-class-tables-title", tr("Tables of marks")), rows, label);
    let shown = [];
    const draw = () => {
      root.hidden = classroom.tables.length === 0;
      if (most.value !== classroom.most) most.value = classroom.most;
      const { tables } = classroom;
      if (tables.length !== shown.length || tables.some((table, k) => table !== shown[k]))
        rows.replaceChildren(...tables.map((table) => row(classroom, table, changed)));
      shown = [...tables];
      for (const [k, name] of rows.querySelectorAll("bdi").entries()) {
        const { name: own, group } = tables[k];
        say(name, classroom.two ? `${own} · ${classroom.groups[group]}` : own);
      }
    };
    return { root, draw };
  }
  function row(classroom, table, changed) {
    const line = html("li");
    const when = html("select");
    when.append(...TIMES.map(([value, text]) => new Option(text, value)));
    when.value = table.form;
    when.setAttribute("aria-label", tr("which test {table} tells of", { table: table.name }));
    when.addEventListener("change", () => {
      table.form = when.value;
      changed();
    });
    const remove = button(tr("Leave out"), () => {
      classroom.tables = classroom.tables.filter((other) => other !== table);
      changed();
    });
    line.append(html("bdi"), " ", when, " ", remove);
    return line;
  }

  // src/class/element.js
  var PACKAGES = ["numpy", "scipy"];
  var SOON = 700;
  var readIn = (count2, all, seconds) => count2 === all ? counted("1 file read in {seconds} s.", "{n} files read in {seconds} s.", count2, { seconds }) : counted(
    "1 file read in {seconds} s, {all} in all.",
    "{n} files read in {seconds} s, {all} in all.",
    count2,
    { seconds, all }
  );
  function classElement(client) {
    const here = spokenHere();
    return class CartsClass extends HTMLElement {
      classroom = new Classroom();
      inference = false;
      complete = Promise.resolve();
      #statistics = null;
      #read = 0;
      #drawn = 0;
      #lifetime = 0;
      #status = html("p", "carts-class-status");
      #bar = html("progress", "carts-class-progress");
      #report = html("div", "carts-class-report");
      #parts = [];
      #reader = null;
      #leaving = new AbortController();
      // ends what the element hears of the window
      connectedCallback() {
        this.#leaving = new AbortController();
        stay(this.classroom, this.#leaving.signal);
        if (this.#parts.length) return;
        this.classList.add("carts", "carts-class");
        const change = () => void this.show();
        const field2 = drops(this.classroom, (files, group) => this.take(files, group), change);
        const list = fileList(this.classroom, change);
        const codes = typedCodes(this.classroom, change);
        const tables = tableList(this.classroom, change);
        this.#reader = reader(this.classroom, change);
        const doing = actions({
          element: this,
          report: this.#report,
          ask: (what) => this.#ask({
            ...this.classroom.toldOfAll(),
            ...{ do: "save", what, inference: this.inference, ...here }
          }),
          say: (text) => say(this.#status, text),
          clear: () => this.clear()
        });
        const paper = papers({
          noAnswers: () => !this.classroom.files.length && !this.classroom.typed,
          keys: () => this.classroom.keys,
          ask: (wanted) => this.#ask({ ...this.classroom.told(), inference: this.inference, ...wanted }),
          say: (text) => say(this.#status, text)
        });
        this.#parts = [field2.draw, list.draw, tables.draw, codes.draw, paper.draw, doing.draw];
        this.#status.setAttribute("role", "status");
        this.#bar.hidden = true;
        this.#bar.setAttribute("aria-label", tr("Files read"));
        const controls = html("div", "carts-class-controls");
        controls.append(
          field2.root,
          this.#status,
          this.#bar,
          list.root,
          tables.root,
          codes.root,
          this.#reader.root,
          paper.root,
          doing.root
        );
        this.replaceChildren(controls, paper.shown, this.#report);
        this.#redraw();
        this.dataset.state = "ready";
      }
      disconnectedCallback() {
        this.#leaving.abort();
      }
      take(files, group) {
        const lifetime = this.#lifetime;
        this.complete = this.complete.then(() => this.#take(files, group, lifetime));
        return this.complete;
      }
      async #take(files, group, lifetime) {
        for (const file of files.filter(isTable)) {
          const table = await asTable(file, group);
          if (lifetime !== this.#lifetime) return;
          if (typeof table === "string") this.classroom.refused.push([file.name, table]);
          else this.classroom.tables.push(table);
        }
        if (lifetime !== this.#lifetime) return;
        const answers = files.filter((file) => !isTable(file));
        const begun = performance.now();
        say(this.#status, client.state === "ready" ? tr("Reading …") : tr("Starting Python …"));
        Object.assign(this.#bar, { hidden: false, max: answers.length, value: 0 });
        let soon = 0;
        try {
          await readAll(
            answers,
            (message) => this.#ask(message),
            async (found, done) => {
              if (lifetime !== this.#lifetime) throw new Error("cleared");
              soon ||= performance.now() + SOON;
              this.classroom.take(found, group);
              this.#bar.value = done;
              say(this.#status, tr("{done} of {all} files read", { done, all: answers.length }));
              if (!this.#drawn && this.classroom.files.length && performance.now() > soon)
                await this.show();
            }
          );
          await this.show();
          if (lifetime !== this.#lifetime) return;
          performance.mark("carts:class-done");
          const took = ((performance.now() - begun) / 1e3).toFixed(1);
          this.#read += files.length;
          say(this.#status, readIn(files.length, this.#read, took));
          void this.#addStatistics();
        } catch (error) {
          if (lifetime !== this.#lifetime) return;
          say(this.#status, error.message);
        } finally {
          this.#bar.hidden = true;
        }
      }
      #addStatistics() {
        this.#statistics ??= client.need(PACKAGES).then(
          async () => {
            await this.#ask({ kind: "class", do: "ready" });
            this.inference = true;
            await this.show();
          },
          (error) => {
            this.#statistics = null;
            const short = tr("Means are shown; intervals and tests are not there: {message}", error);
            say(this.#status, short);
          }
        );
        return this.#statistics.then(() => {
          if (this.inference && !this.classroom.empty) this.dataset.state = "complete";
        });
      }
      async show() {
        this.#redraw();
        const { classroom } = this;
        if (classroom.empty) return this.#report.replaceChildren();
        const lifetime = this.#lifetime;
        try {
          const header = await this.#reported();
          if (lifetime !== this.#lifetime) return;
          const made = document.createElement("template");
          made.innerHTML = header.html;
          const open = [...this.#report.querySelectorAll("details[open] > summary")].map(
            (summary) => summary.textContent
          );
          this.#report.replaceChildren(made.content);
          for (const details of this.#report.querySelectorAll("details")) {
            details.open = open.includes(details.querySelector("summary")?.textContent ?? "");
          }
          this.#drawn += 1;
          if (this.#drawn === 1) performance.mark("carts:class-means");
          this.#reader?.draw(header.words);
          this.#redraw();
        } catch (error) {
          say(this.#status, error.message);
        }
      }
      async #reported() {
        const { classroom } = this;
        const asked = { do: "report", inference: this.inference, ...here };
        const none = { html: "", words: [] };
        const answers = classroom.noAnswers ? none : (await client.ask(this, () => ({ ...this.classroom.told(), ...asked }))).header;
        const tables = classroom.tables.length ? await this.#ask({ ...classroom.toldOfTables(), ...asked }) : none;
        const { html: first, words } = answers;
        return { html: first + tables.html, words };
      }
      clear() {
        this.#lifetime += 1;
        this.#read = 0;
        const kept = this.classroom;
        Object.assign(kept, new Classroom());
        this.#drawn = 0;
        this.#report.replaceChildren();
        this.#reader?.draw([]);
        this.#redraw();
        this.dataset.state = "ready";
        say(
          this.#status,
          tr("Everything is deleted from this page. The files themselves are where they were.")
        );
      }
      #redraw() {
        holdingFocus(this, () => {
          for (const draw of this.#parts) draw();
        });
      }
      async #ask(message) {
        const { header } = await client.ask({}, () => message);
        return header;
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
  var told = (reason) => isOnWeb() && ON_WEB[reason] || MESSAGES[reason];
  var RuntimeFailure = class extends Error {
    constructor(reason, detail = "", file = "") {
      super(told(reason) ?? told("python-failed"));
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
  function stay2() {
    leaving = false;
    for (const go of waiting) go();
    waiting = [];
  }
  addEventListener("beforeunload", () => {
    leaving = true;
    setTimeout(stay2, STAYS);
  });
  addEventListener("pagehide", () => {
    leaving = true;
  });
  addEventListener("pageshow", stay2);
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
      const script = document.createElement("script");
      script.src = src;
      script.async = true;
      const missing2 = () => reject(new RuntimeFailure("payload-missing", src, name));
      const settle = (then) => () => {
        held?.stop();
        script.remove();
        then();
      };
      const held = isOnWeb() ? watch(HELD, settle(missing2)) : null;
      script.onload = settle(resolve);
      script.onerror = settle(() => {
        if (isLeaving()) staying().then(() => runOnce(src, name).then(resolve, reject));
        else missing2();
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
    const text = page.__cartsParts?.[key];
    if (text === void 0) throw new RuntimeFailure("payload-damaged", part.src, name);
    if (!inside) delete page.__cartsParts[key];
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
    const written2 = write(zip.writable.getWriter(), parts);
    const [module] = await Promise.all([compiled, written2]);
    return module;
  }
  async function write(writer, parts) {
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
    const script = document.currentScript;
    const own = new URL(script?.src || document.baseURI);
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

  // src/class-main.js
  var CLASSROOM = "newtons-carts-class";
  var missing = missingFeatures();
  if (missing.length) {
    for (const place of document.querySelectorAll("carts-class")) {
      place.textContent = tr(
        "This browser is too old to read the files (missing: {missing}); Chrome or Edge 103, Firefox 113, Safari 16.4 or newer can. On the command line “carts class” does the same.",
        { missing: missing.join(", ") }
      );
    }
  } else {
    const client = pagePython(() => [CLASSROOM]);
    customElements.define("carts-class", classElement(client));
    startWhenIdle(client);
  }
})();
