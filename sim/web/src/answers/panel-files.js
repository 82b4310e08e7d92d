/** Files: save, table for a spreadsheet, print, and bring answers back in from a file. */

import { counted, tr } from "../../../view/language.js";
import { html, say } from "../shared/dom.js";
import { download } from "../shared/download.js";
import { onEnter } from "../shared/enter.js";
import { readCode } from "./codes.js";
import { csvText } from "./csv.js";
import { fileName, makeFiles, readFile, tooLarge } from "./file.js";
import { button, clock, codeBox, fault, part, status } from "./parts.js";

const NAMES = /** @type {Record<string, string>} */ ({
  worksheet: tr("lesson"),
  pre: tr("test before"),
  post: tr("test after"),
  delayed: tr("last test"),
});
const AFTER_SAVING = 1500; // ms: the browser has the file, and the message can be read

/** @param {import("./book.js").Book} book @returns {{root: HTMLElement, draw: () => void}} */
export function filesPart(book) {
  const root = part("files", tr("Hand in: save a file"));
  const table = html("div", "carts-answers-table");
  const told = status();
  root.append(table, told, importRow(book, told));
  const draw = () => {
    if (table.querySelector(".carts-answers-whose > *")) return; // a code word is being typed
    table.replaceChildren(...rows(book, told, draw));
  };
  draw();
  return { root, draw };
}

/** @param {import("./book.js").Book} book @param {HTMLElement} told @param {() => void} draw @returns {Node[]} */
function rows(book, told, draw) {
  const files = makeFiles(book.entries(), book, new Date().toISOString());
  files.sort((a, b) => Number(b.page === book.page) - Number(a.page === book.page));
  if (!files.length) return [html("p", "carts-quiet", tr("Nothing has been answered yet."))];
  return files.map((file) => {
    const row = html("div", "carts-answers-file");
    const last = file.content.items
      .map((/** @type {any} */ item) => item.last)
      .sort()
      .pop();
    const name = html("span", "carts-answers-name");
    name.append(
      html("strong", "", titleOf(book, file)),
      ` · ${NAMES[file.form]} · ${held(book, file)}`,
    );
    if (last) name.append(html("span", "carts-quiet", ` · ${clock(last)}`));
    const asked = html("p", "carts-answers-whose");
    const keep = (/** @type {string} */ student) => {
      const now = new Date().toISOString();
      const [fresh] = makeFiles(book.entries(), { site: book.site, student }, now).filter(
        (one) => one.page === file.page && one.form === file.form,
      );
      const { name, content } = fresh ?? file;
      download(name, `${JSON.stringify(content, null, 1)}\n`, "application/json");
      document.dispatchEvent(new CustomEvent("carts-file-saved", { detail: name }));
      say(
        told,
        tr(
          "Saved as {file}. Look in your folder “Downloads” and give this file to your teacher. Keep it until it has arrived.",
          { file: name },
        ),
      );
    };
    const save = button(
      tr("Save file"),
      () => (book.student ? keep(book.student) : askWhose(asked, book, keep, draw)),
      "carts-answers-save",
    );
    const csv = button(
      tr("Table (CSV)"),
      () => {
        download(fileName(file.content, "csv"), csvText(file.content), "text/csv");
        say(told, tr("Saved. A spreadsheet program opens it."));
      },
      "carts-answers-csv",
    );
    row.append(name, save, " ", csv, asked);
    return row;
  });
}

/** @param {import("./book.js").Book} book @param {import("./file.js").AnswerFile} file */
function titleOf(book, { page, lesson }) {
  const title = page === book.page && document.querySelector("h1")?.firstChild?.textContent;
  return title || lesson;
}

/**
 * How much a file holds; that of this page as the line at the foot counts it, and what goes beyond: parts for
 * who has time, found forces, earlier answers. Two numbers for one page would be a riddle.
 * @param {import("./book.js").Book} book @param {import("./file.js").AnswerFile} file @returns {string}
 */
function held(book, { form, page, content }) {
  const all = content.items.length;
  const { done, of } = book.progress();
  if (form !== "worksheet" || page !== book.page || !of)
    return counted("1 answer", "{n} answers", all);
  const asked = tr("{part} of {all} answered", { part: done, all: of });
  const more = all - done;
  return more > 0 ? `${asked} + ${counted("1 more answer", "{n} more answers", more)}` : asked;
}

/** A file without a code word tells the teacher nothing of whose it is: asked for once more. */
/** @param {HTMLElement} place @param {import("./book.js").Book} book @param {(student: string) => void} keep @param {() => void} draw */
function askWhose(place, book, keep, draw) {
  const { label, box } = codeBox(tr("Whose file is it? Code word from your card"));
  const above = document.querySelector(".carts-answers-who .carts-answers-code");
  box.value = /** @type {HTMLInputElement | null} */ (above)?.value ?? ""; // typed and not confirmed
  const told = status();
  const withCode = async () => {
    const found = readCode(box.value);
    if ("problem" in found) return fault(told, found.problem);
    const { code } = found;
    keep(code);
    // Mistyped, it may be the code word of somebody who worked here before.
    if (await book.has(code).catch(() => true)) {
      return say(
        told,
        tr(
          "Saved. Answers of {code} are on this computer already: if you are {code}, type it above too.",
          { code },
        ),
      );
    }
    // What was answered here belongs to this student from now on; if the browser refuses, the file has it.
    const anew = await book.become(code, true).catch(() => false);
    if (book.student === code) end();
    if (anew) setTimeout(() => location.reload(), AFTER_SAVING);
  };
  onEnter(box, () => void withCode());
  const end = () => {
    place.replaceChildren();
    draw();
  };
  const without = () => {
    end();
    keep("");
  };
  place.replaceChildren(
    label,
    " ",
    button(tr("Save with this code word"), () => void withCode(), "carts-answers-with-code"),
    " ",
    button(tr("Save without a code word"), without, "carts-answers-without-code"),
    told,
  );
  box.focus();
}

/** What to do to see answers that are not this page's or this student's; empty: nothing. */
/** @param {{student: string, lesson: string, entries: [string, any][]}} found @param {import("./book.js").Book} book */
function elsewhere(found, book) {
  const words = [];
  if (found.student !== book.student) {
    const whose = found.student || tr("somebody without a code word");
    words.push(tr("This file is of {whose}.", { whose }));
  }
  if (!found.entries.some(([key]) => key.startsWith(`${book.page}#`))) {
    // Firefox keeps what a page of a folder has for that page alone.
    const alone = location.protocol === "file:" && navigator.userAgent.includes("Firefox/");
    const page = { page: found.lesson };
    words.push(
      alone
        ? tr("It belongs to the page “{page}”: open that page and bring the file back there.", page)
        : tr("It belongs to the page “{page}”: open that page to see its answers.", page),
    );
  }
  return words.join(" ");
}

/** As typed above, with what is asked there. @param {string} student */
function continueAs(student) {
  return button(tr("Continue as {student}", { student }), () => {
    const who = document.querySelector(".carts-answers-who");
    const box = /** @type {HTMLInputElement | null | undefined} */ (who?.querySelector("input"));
    if (box) box.value = student;
    who?.scrollIntoView();
    /** @type {HTMLElement | null | undefined} */ (who?.querySelector("button"))?.click();
  });
}

/** @param {import("./book.js").Book} book @param {HTMLElement} told */
function importRow(book, told) {
  const row = html("p", "carts-answers-import");
  const label = html("label", "carts-button", tr("Bring answers back from a file"));
  const box = /** @type {HTMLInputElement} */ (html("input", "carts-answers-open carts-hidden"));
  Object.assign(box, { type: "file", accept: ".json,application/json" });
  label.append(box);
  row.append(label);
  box.addEventListener("change", async () => {
    const file = box.files?.[0];
    if (!file) return;
    const found = tooLarge(file.size) ?? readFile(await file.text().catch(() => ""), book.site);
    box.value = ""; // the same file may be chosen again
    if ("problem" in found) return fault(told, `${file.name}: ${found.problem}`);
    const changed = await book.take(found.student, found.entries).catch(() => -1);
    if (changed < 0)
      return fault(told, tr("This browser refuses to keep the answers of this file."));
    const where = elsewhere(found, book);
    const count = counted("1 answer", "{n} answers", changed);
    const taken = tr("{count} taken from the file; nothing that was here is lost.", { count });
    say(told, `${taken} ${where}`.trim());
    const { student } = found;
    if (student && student !== book.student) told.append(" ", continueAs(student));
    // A scene takes its prediction up only when the page is read.
    const predicted = found.entries.some(([, entry]) => entry.locked);
    if (!where && changed && predicted && book.lasts) setTimeout(() => location.reload(), 1500);
  });
  return row;
}
