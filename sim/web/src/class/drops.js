/** The fields on which files are dropped, one for the class or one for each of two groups. */

import { tr } from "../../../view/language.js";
import { button } from "../answers/parts.js";
import { html, say } from "../shared/dom.js";
import { typedIn } from "./list.js";

/** @typedef {(files: File[], group: number) => void} Take */

/**
 * @param {import("./classroom.js").Classroom} classroom @param {Take} take
 * @param {() => void} changed names or number of groups are others now
 */
export function drops(classroom, take, changed) {
  const root = html("div", "carts-class-drops");
  const two = /** @type {HTMLInputElement} */ (html("input", "carts-class-two"));
  two.type = "checkbox";
  const label = html("label", "carts-class-choice");
  label.append(two, " ", tr("two groups, one beside the other"));
  const fields = html("div", "carts-class-fields");
  const draw = () => {
    two.checked = classroom.two;
    const count = classroom.two ? [0, 1] : [0];
    fields.replaceChildren(...count.map((group) => field(classroom, group, take, changed)));
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

/**
 * @param {import("./classroom.js").Classroom} classroom @param {number} group @param {Take} take
 * @param {() => void} changed
 */
function field(classroom, group, take, changed) {
  const root = html("div", "carts-class-drop");
  if (classroom.two) root.append(nameBox(classroom, group, changed));
  const says = html(
    "p",
    "",
    tr(
      "Drop answer files, a zip and the key file here, or tables of marks (CSV), one after the other or all at once; or",
    ),
  );
  root.append(says);
  const row = html("p", "carts-class-row");
  for (const [text, folder] of /** @type {[string, boolean][]} */ ([
    [tr("Choose files"), false],
    [tr("Choose a folder"), true],
  ])) {
    const box = /** @type {HTMLInputElement} */ (html("input", "carts-class-files"));
    Object.assign(box, { type: "file", multiple: true, hidden: true, tabIndex: -1 });
    if (folder) box.setAttribute("webkitdirectory", "");
    else box.accept = ".json,.zip,.csv,.tsv,application/json,application/zip,text/csv";
    box.addEventListener("change", () => {
      const chosen = [...(box.files ?? [])].filter(
        (file) => !folder || /\.(json|zip|csv|tsv)$/i.test(file.name),
      );
      box.value = "";
      if (chosen.length) take(chosen, group);
    });
    row.append(
      button(text, () => box.click(), folder ? "carts-class-folder" : "carts-class-pick"),
      box,
      " ",
    );
  }
  root.append(row);
  listen(root, says, (files) => take(files, group));
  return root;
}

/** @param {HTMLElement} root @param {HTMLElement} says @param {(files: File[]) => void} take */
function listen(root, says, take) {
  const over = (/** @type {boolean} */ on) => root.classList.toggle("carts-class-over", on);
  root.addEventListener("dragover", (event) => {
    event.preventDefault();
    over(true);
  });
  root.addEventListener("dragleave", () => over(false));
  root.addEventListener("drop", (event) => {
    event.preventDefault();
    over(false);
    const items = [...(event.dataTransfer?.items ?? [])];
    const folders = items.some((item) => item.webkitGetAsEntry?.()?.isDirectory);
    const files = [...(event.dataTransfer?.files ?? [])];
    if (folders)
      say(says, tr("For a folder use the button “Choose a folder”. Files can be dropped, or"));
    else if (files.length) take(files);
  });
}

/**
 * @param {import("./classroom.js").Classroom} classroom @param {number} group
 * @param {() => void} changed
 */
function nameBox(classroom, group, changed) {
  const label = html("label", "carts-class-name", `${tr("Group")} `);
  const box = /** @type {HTMLInputElement} */ (html("input"));
  Object.assign(box, { value: classroom.names[group], maxLength: 40 });
  const take = (/** @type {string} */ text) => {
    classroom.names[group] = text;
  };
  typedIn(box, take, changed);
  label.append(box);
  return label;
}
