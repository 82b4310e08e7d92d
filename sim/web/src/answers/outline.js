/** What can be answered on this page, as the generator wrote it into the page. */

/** @typedef {{lesson: string, hash: string, items: {id: string, hash: string, type: string, form: string, level: string}[]}} Outline */

/** @type {Outline | null | undefined} */
let found;

/** @returns {Outline | null} */
export function outline() {
  if (found === undefined) {
    const text = document.getElementById("carts-lesson")?.textContent;
    found = text ? JSON.parse(text) : null;
  }
  return found ?? null;
}

/** The item of this page that an answer belongs to. @param {any} entry */
export function itemOf(entry) {
  const form = entry?.form ?? "worksheet";
  return outline()?.items.find((item) => item.id === entry?.id && item.form === form) ?? null;
}

/** Whether what was answered is on this page: a question, or the scene whose force was found. @param {any} entry */
export function isHere(entry) {
  const scene = entry?.type === "found-force" ? entry.id.replace(/-forces$/, "") : "";
  return Boolean(itemOf(entry) ?? (scene && document.getElementById(scene)));
}

/** Whether an answer belongs to the question as it is today. @param {any} entry @returns {boolean} */
export function isCurrent(entry) {
  const item = itemOf(entry);
  return !item || !entry.hash || entry.hash === item.hash;
}

/** An answer with the lesson and the form of the question that it answers. @param {any} entry */
export function stamped(entry) {
  const page = outline();
  const item = itemOf(entry);
  if (!page || !item) return entry;
  return {
    form: item.form,
    lesson: page.lesson,
    lessonHash: page.hash,
    hash: item.hash,
    ...entry,
  };
}
