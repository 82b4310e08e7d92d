/**
 * The way into teacher mode: the link at the foot of a lesson, or an address that ends in #teacher or
 * ?teacher. Its script is loaded then, never before.
 */

import { tr } from "../../../view/language.js";
import { wordSum } from "../question/opening.js";
import { html } from "../shared/dom.js";
import { BROWSER, recall, retain } from "../shared/tab.js";
import { place } from "../store/storage.js";

export const OPEN = "carts-teach";

/** The checksum of the teacher's word; empty: the site has none. */
export const teachersWord = () =>
  document.querySelector('meta[name="carts-teacher"]')?.getAttribute("content") ?? "";

/** Under this name the browser remembers that it keeps a draft of this lesson. */
export const draftMark = () => `carts-draft ${place().page}`;

/** What the link says: also whether a draft is kept. @param {HTMLElement} link */
export function tellDraft(link) {
  link.dataset.words ??= link.textContent ?? "";
  const kept = recall(draftMark(), BROWSER) ? " (your draft is kept)" : "";
  link.textContent = link.dataset.words + kept;
}

/** Listens for a teacher. */
export function teacherDoor() {
  const link = document.querySelector(".carts-teach-door a");
  if (!(link instanceof HTMLAnchorElement)) return;
  const lesson = new URL(link.dataset.lesson ?? "", document.baseURI);
  const beside = (/** @type {string} */ name) => new URL(`../${name}${lesson.search}`, lesson).href;
  tellDraft(link);
  /** @type {Promise<unknown> | null} */
  let loaded = null;
  const open = async () => {
    if (!(await letIn())) return;
    loaded ??= Promise.all([
      arrives("link", { rel: "stylesheet", href: beside("teacher.css") }),
      arrives("script", { src: beside("teacher.js") }),
    ]);
    link.textContent = tr("Opening …"); // a slow computer takes seconds
    try {
      await loaded;
      tellDraft(link);
      document.dispatchEvent(new Event(OPEN));
    } catch {
      loaded = null;
      link.textContent = "Teacher mode cannot be loaded: a file of this site is missing.";
    }
  };
  /** Whether the teacher's word was given; asks for it where one is needed. */
  const letIn = () => {
    const sum = teachersWord();
    return !sum || recall(KEY) === sum || ask(link, sum);
  };
  const wanted = () =>
    location.hash === "#teacher" || new URLSearchParams(location.search).has("teacher");
  link.addEventListener("click", (event) => {
    // The link leads to its own paragraph, which would take the focus from the field below.
    event.preventDefault();
    history.pushState(null, "", link.href);
    void open();
  });
  addEventListener("hashchange", () => {
    if (location.hash === "#teacher") void open();
  });
  if (wanted()) void open();
}

/** @param {string} tag @param {Record<string, string>} given */
function arrives(tag, given) {
  return new Promise((onload, onerror) => {
    const made = document.createElement(tag);
    document.head.append(Object.assign(made, given, { onload, onerror }));
  });
}

export const KEY = "carts-teacher-word"; // its checksum, once it was given in this tab

/** Resolves when the word was given. @param {HTMLElement} link @param {string} sum @returns {Promise<boolean>} */
function ask(link, sum) {
  const place = /** @type {HTMLElement} */ (link.parentElement);
  const asking = place.querySelector("input");
  asking?.focus();
  if (asking) return Promise.resolve(false);
  const form = html("form", "carts");
  const label = html("label", "", `${tr("Your teacher's word")} `);
  const box = document.createElement("input");
  Object.assign(box, { type: "text", autocomplete: "off", maxLength: 60, spellcheck: false });
  const button = Object.assign(html("button", "carts-button", tr("Open")), { type: "submit" });
  const wrong = html("span", "carts-error");
  wrong.setAttribute("role", "alert");
  label.append(box);
  form.append(label, " ", button, " ", wrong);
  place.append(form);
  box.focus();
  if (document.readyState !== "complete")
    // An address with #teacher takes the focus to its paragraph when the page has been read in.
    addEventListener("load", () => requestAnimationFrame(() => box.focus()), { once: true });
  return new Promise((resolve) => {
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      if (wordSum("teacher", box.value) !== sum) {
        wrong.textContent = tr("That is not the word.");
        box.setAttribute("aria-invalid", "true");
        box.select();
        return;
      }
      retain(KEY, sum);
      form.remove();
      resolve(true);
    });
  });
}
