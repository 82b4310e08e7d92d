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

/** The scene whose force was found; empty for answers to questions. @param {any} entry @returns {string} */
const sceneOf = (entry) => (entry?.type === "found-force" ? entry.id.replace(/-forces$/, "") : "");

/** Whether what was answered is on this page. @param {any} entry */
export function isHere(entry) {
  const scene = sceneOf(entry);
  return Boolean(itemOf(entry) ?? (scene && document.getElementById(scene)));
}

/** The answers in the order of what they answer on the page; last what is not there. @param {[string, any][]} entries */
export function inPageOrder(entries) {
  const places = [...document.querySelectorAll("[id]")].map(({ id }) => id);
  const place = (/** @type {any} */ entry) => {
    const at = places.indexOf(sceneOf(entry) || entry.id);
    return at < 0 ? places.length : at;
  };
  return [...entries].sort(([, one], [, other]) => place(one) - place(other));
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
