/** What can be answered on this page, as the generator wrote it into the page. */

/** @typedef {{lesson: string, hash: string, items: {id: string, hash: string, type: string, form: string, level: string}[]}} Outline */

/** @type {Outline | null} */
let found = null; // until the page was read so far

/** @returns {Outline | null} */
export function outline() {
  const text = found ? null : document.getElementById("carts-lesson")?.textContent;
  if (text) found = JSON.parse(text);
  return found;
}

/** The item of this page that an answer belongs to. @param {any} entry */
function itemOf(entry) {
  const form = entry?.form ?? "worksheet";
  return outline()?.items.find((item) => item.id === entry?.id && item.form === form) ?? null;
}

/** What of this page an answer belongs to that is no question: a scene whose force was found, a challenge; else empty. @param {any} entry @returns {string} */
function placeOf(entry) {
  if (entry?.type === "challenge") return entry.id;
  return entry?.type === "found-force" ? entry.id.replace(/-forces$/, "") : "";
}

/** Whether what was answered is on this page. @param {any} entry */
export function isHere(entry) {
  const place = placeOf(entry);
  return Boolean(itemOf(entry) ?? (place && document.getElementById(place)));
}

/** The answers in the order of what they answer on the page; last what is not there. @param {[string, any][]} entries */
export function inPageOrder(entries) {
  const places = [...document.querySelectorAll("[id]")].map(({ id }) => id);
  const place = (/** @type {any} */ entry) => {
    const at = places.indexOf(placeOf(entry) || entry.id);
    return at < 0 ? places.length : at;
  };
  return [...entries].sort(([, one], [, other]) => place(one) - place(other));
}

/** Whether an answer belongs to the question as it is today. @param {any} entry @returns {boolean} */
export function isCurrent(entry) {
  const item = itemOf(entry);
  return !item || !entry.hash || entry.hash === item.hash;
}

/** An answer with the lesson and the form of what it answers. @param {any} entry */
export function stamped(entry) {
  const page = outline();
  if (!page || !isHere(entry)) return entry;
  const { form = "worksheet", hash = "" } = itemOf(entry) ?? {};
  return { form, lesson: page.lesson, lessonHash: page.hash, hash, ...entry };
}
