/** The form of a block: a field for each ordinary value. */

import { html } from "../shared/dom.js";

/** @typedef {import("./types.js").Field} Field */

const PAUSE = 300; // ms without a key until a value is taken over
let made = 0;

export class Fields {
  /** @type {Map<string, {control: HTMLInputElement | HTMLTextAreaElement | HTMLSelectElement, note: HTMLElement, field: Field, timer: number, asked: number, wrong: boolean, refused: boolean, take: () => void}>} asked: values on their way; wrong: the note is a finding; take: its value now */
  #rows = new Map();
  #form = "";

  /** @param {(field: Field, value: string, owner: object) => Promise<string>} set */
  constructor(set) {
    this.set = set;
    this.root = html("div", "carts-teach-fields");
  }

  /** @param {Field[]} fields @param {import("./types.js").Finding[]} findings of the block */
  show(fields, findings) {
    const form = JSON.stringify(fields.map(({ path, kind, group }) => [path, kind, group]));
    if (form !== this.#form) this.#build(fields);
    this.#form = form;
    for (const field of fields) {
      const row = this.#rows.get(JSON.stringify(field.path));
      if (!row) continue;
      if (row.field.value !== field.value) row.refused = false; // the text has gone on without it
      row.field = field;
      const [line, col] = field.place;
      const wrong = findings.find((one) => one.line === line && one.col === col);
      if (wrong) this.#say(row, [withoutPath(wrong), wrong.hint].filter(Boolean).join(" – "));
      else if (row.wrong) this.#say(row, "");
      row.wrong = wrong !== undefined;
      // What is being typed, is on its way or was refused is not overwritten.
      const held = row.refused || row.timer || row.asked || row.control === document.activeElement;
      if (!held && row.control.value !== field.value) {
        row.control.value = field.value;
        this.#say(row, "");
      }
    }
  }

  /** What was typed and waits for a pause, or was refused, is taken over now. */
  flush() {
    for (const { timer, refused, take } of this.#rows.values()) if (timer || refused) take();
  }

  /** An undone change takes what was refused along. */
  undo() {
    for (const row of this.#rows.values()) {
      if (!row.refused) continue;
      row.refused = false;
      row.control.value = row.field.value;
      this.#say(row, "");
    }
  }

  /** @param {Field[]} fields */
  #build(fields) {
    const before = new Map(this.#rows);
    const focused = [...this.#rows].find(([, { control }]) => control === document.activeElement);
    this.#rows.clear();
    this.root.replaceChildren();
    let group = "";
    let place = this.root;
    for (const field of fields) {
      if (field.group !== group || (!field.group && place !== this.root)) {
        group = field.group;
        place = this.root;
        if (group) {
          place = html("fieldset");
          place.append(html("legend", "", group));
          this.root.append(place);
        }
      }
      place.append(this.#row(field, before.get(JSON.stringify(field.path))));
    }
    if (focused) this.#rows.get(focused[0])?.control.focus();
  }

  /** @param {Field} field @param {{control: {value: string}, note: HTMLElement, refused: boolean}} [before] the same field, before others came or went */
  #row(field, before) {
    const line = html("label", field.kind === "area" ? "carts-teach-wide" : "");
    const control = controlFor(field);
    control.value = field.value;
    const note = html("span", "carts-teach-note");
    made += 1;
    note.id = `carts-teach-note-${made}`;
    note.setAttribute("role", "status");
    control.setAttribute("aria-describedby", note.id);
    line.append(html("span", "carts-teach-label", field.label), control);
    const take = () => {
      clearTimeout(row.timer);
      row.timer = 0;
      if (control.value !== row.field.value) return void this.#take(row);
      if (row.refused) this.#say(row, "");
      row.refused = false;
      delete control.dataset.waits;
    };
    const row = { control, note, field, timer: 0, asked: 0, wrong: false, refused: false, take };
    if (before?.refused) {
      control.value = before.control.value;
      row.refused = true;
      this.#say(row, before.note.textContent ?? "");
    }
    control.addEventListener("input", () => {
      control.dataset.waits = ""; // for who looks from outside: what stands here is not taken yet
      clearTimeout(row.timer);
      row.timer = setTimeout(take, PAUSE);
    });
    control.addEventListener("change", take);
    this.#rows.set(JSON.stringify(field.path), row);
    const whole = html("div", "carts-teach-field");
    whole.append(line, note);
    return whole;
  }

  /** @param {{control: any, note: HTMLElement, field: Field, timer: number, asked: number, refused: boolean}} row */
  async #take(row) {
    row.asked += 1;
    row.control.dataset.waits = "";
    try {
      const why = await this.set(row.field, row.control.value, row);
      row.refused = why !== "";
      this.#say(row, why);
    } catch (error) {
      row.refused = true;
      this.#say(row, /** @type {Error} */ (error).message);
    } finally {
      row.asked -= 1;
      if (!row.asked && !row.timer) delete row.control.dataset.waits;
    }
  }

  /** @param {{control: HTMLElement, note: HTMLElement}} row @param {string} text */
  #say({ control, note }, text) {
    note.textContent = text;
    control.setAttribute("aria-invalid", String(text !== ""));
  }
}

/** A finding without the keys that lead to it: its field says where. @param {import("./types.js").Finding} finding */
const withoutPath = ({ message }) => message.replace(/^[\w.-]+: /, "");

/** A finding as a teacher reads it, by the name of its field: "Effect 1: friction, mu: …". @param {Field[]} fields @param {import("./types.js").Finding} finding */
export function named(fields, finding) {
  const { line, col, message } = finding;
  const field = fields.find(({ place }) => place[0] === line && place[1] === col);
  if (!field) return message;
  return `${[field.group, field.label].filter(Boolean).join(", ")}: ${withoutPath(finding)}`;
}

/** @param {Field} field */
function controlFor(field) {
  if (field.kind === "choice") {
    const select = document.createElement("select");
    select.append(...field.options.map((option) => new Option(option)));
    return select;
  }
  if (field.kind === "area") {
    const area = document.createElement("textarea");
    area.rows = Math.min(6, Math.max(2, Math.ceil(field.value.length / 48)));
    return area;
  }
  const input = document.createElement("input");
  input.type = "text";
  return input;
}
