/** Tables of marks from elsewhere that were dropped: which test each tells of, and its most marks. */

import { tr } from "../../../view/language.js";
import { button } from "../answers/parts.js";
import { html, say } from "../shared/dom.js";
import { typedIn } from "./list.js";

/** @typedef {import("./classroom.js").Table} Table */

const TIMES = /** @type {[string, string][]} */ ([
  ["", tr("as the table says")],
  ["pre", tr("before teaching")],
  ["post", tr("after teaching")],
  ["later", tr("some time later")],
]);

/** @param {import("./classroom.js").Classroom} classroom @param {() => void} changed */
export function tableList(classroom, changed) {
  const root = html("div", "carts-class-tables");
  const rows = html("ul");
  const label = html(
    "label",
    "",
    `${tr("Most marks of the test, if the table gives only totals")} `,
  );
  const most = /** @type {HTMLInputElement} */ (html("input"));
  Object.assign(most, { type: "text", size: 6, inputMode: "decimal", autocomplete: "off" });
  const take = (/** @type {string} */ text) => {
    classroom.most = text;
  };
  typedIn(most, take, changed);
  label.append(most);
  root.append(html("p", "carts-class-tables-title", tr("Tables of marks")), rows, label);
  /** @type {Table[]} that have a row */
  let shown = [];
  const draw = () => {
    root.hidden = classroom.tables.length === 0;
    if (most.value !== classroom.most) most.value = classroom.most;
    const { tables } = classroom;
    if (tables.length !== shown.length || tables.some((table, k) => table !== shown[k]))
      rows.replaceChildren(...tables.map((table) => row(classroom, table, changed)));
    shown = [...tables];
    for (const [k, name] of rows.querySelectorAll("bdi").entries()) {
      const { name: own, group } = /** @type {Table} */ (tables[k]);
      say(name, classroom.two ? `${own} · ${classroom.groups[group]}` : own);
    }
  };
  return { root, draw };
}

/**
 * @param {import("./classroom.js").Classroom} classroom
 * @param {Table} table @param {() => void} changed
 */
function row(classroom, table, changed) {
  const line = html("li");
  const when = /** @type {HTMLSelectElement} */ (html("select"));
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
