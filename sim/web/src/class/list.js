/** The files that were read, each with a box to leave it out; and hand-in codes typed from paper. */

import { counted, tr } from "../../../view/language.js";
import { html, say } from "../shared/dom.js";

/** @typedef {import("./classroom.js").Held} Held */

/** @param {import("./classroom.js").Classroom} classroom @param {() => void} changed */
export function fileList(classroom, changed) {
  const root = /** @type {HTMLDetailsElement} */ (html("details", "carts-class-list"));
  const title = html("summary", "", tr("Files"));
  const rows = html("ul");
  root.append(title, rows);
  /** @type {WeakMap<Held, {words: string, line: HTMLElement}>} */
  const made = new WeakMap();
  /** The line of a file stays the same element while it says the same: what is being typed in it stays. @param {Held} file */
  const lineOf = (file) => {
    const group = classroom.two ? ` · ${classroom.groups[file.group]}` : "";
    const [name, , lesson, , student, form] = file.row;
    const words = JSON.stringify([name, lesson, student, form, group]);
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

/** @param {import("./classroom.js").Classroom} classroom @param {Held} file @param {string} group @param {() => void} changed */
function lineFor(classroom, file, group, changed) {
  const line = html("li");
  const label = html("label");
  const box = /** @type {HTMLInputElement} */ (html("input"));
  Object.assign(box, { type: "checkbox", checked: !file.out });
  box.addEventListener("change", () => {
    file.out = !box.checked;
    changed();
  });
  const [name, , lesson, , student, form] = file.row;
  label.append(
    box,
    " ",
    html("bdi", "", student || tr("no code word")),
    ` · ${form} · ${lesson}${group} `,
    html("span", "carts-class-quiet", name),
  );
  line.append(label);
  if (!student || file.named) line.append(" ", codeFor(classroom, file, changed));
  return line;
}

/** @param {number} count */
function keysWord(count) {
  if (!count) return tr("no key file");
  return counted("key for 1 form", "key for {n} forms", count);
}

/** A box for the code word of a file that has none. @param {import("./classroom.js").Classroom} classroom @param {Held} file @param {() => void} changed */
function codeFor(classroom, file, changed) {
  const box = /** @type {HTMLInputElement} */ (html("input", "carts-class-whose"));
  Object.assign(box, { type: "text", maxLength: 90, spellcheck: false });
  box.placeholder = tr("code word");
  box.setAttribute("aria-label", tr("code word for {file}", { file: file.row[0] }));
  box.addEventListener("change", () => {
    classroom.name(file, box.value);
    changed();
  });
  return box;
}

const PAUSE = 500; // ms without a key: then something was typed

/**
 * What is typed is taken at once: what is drawn before the pause is over would take it back.
 * @param {HTMLInputElement | HTMLTextAreaElement} box @param {(text: string) => void} take @param {() => void} act
 */
export function typedIn(box, take, act) {
  let timer = 0;
  box.addEventListener("input", () => {
    take(box.value);
    clearTimeout(timer);
    timer = window.setTimeout(act, PAUSE);
  });
}

/** Codes are typed for the class, or for each of two groups. @param {import("./classroom.js").Classroom} classroom @param {() => void} changed */
export function typedCodes(classroom, changed) {
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

/** @param {import("./classroom.js").Classroom} classroom @param {number} group @param {() => void} changed */
function codesOf(classroom, group, changed) {
  const root = html("label");
  const whose = html("bdi");
  const box = /** @type {HTMLTextAreaElement} */ (html("textarea"));
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
