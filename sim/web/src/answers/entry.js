/**
 * One kept answer, and how two versions of it come together without losing either. Pure.
 *
 * @typedef {{id: string, form?: string, lesson?: string, lessonHash?: string, hash?: string, type: string,
 *   value: any, said?: string, asked?: string, unit?: string, sure?: string | null, own?: number | null,
 *   first: string | null, last: string | null, tries: number, judged?: boolean, locked?: string | null, again?: string,
 *   earlier?: Entry[]}} Entry
 */

const MOST_EARLIER = 500; // of one question; a file that says more is not from here

/** Whether nothing has been answered. @param {any} value @returns {boolean} */
export function isEmpty(value) {
  if (typeof value === "string") return !value.trim();
  if (value === null || value === undefined) return true;
  return typeof value === "object" && Object.keys(value).length === 0;
}

/** What is to be stored in the place of `old`. What was locked is not opened by a tab that has not heard of it. */
/** @param {any} old @param {any} value @returns {any} */
export function keepEarlier(old, value) {
  if (!old || typeof old !== "object" || typeof value !== "object" || value === null) return value;
  const opened = old.locked && old.locked !== value.locked;
  if (opened && sameAnswer(old, value)) return { ...together(old, value), locked: old.locked };
  const same = old.hash === value.hash && old.type === value.type;
  if (old.locked && !value.locked && same) {
    return withEarlier(old, old.earlier, value.earlier, alone(value));
  }
  const other = opened || (old.hash && value.hash && old.hash !== value.hash);
  return withEarlier(value, old.earlier, value.earlier, other ? alone(old) : []);
}

/** Two versions of one answer: the later one counts, of two at once `b`; the other is kept. @param {any} a @param {any} b @returns {any} */
export function merged(a, b) {
  if (!a) return b;
  if (!b) return a;
  const [old, young] = String(a.last ?? "") <= String(b.last ?? "") ? [a, b] : [b, a];
  const first = [a.first, b.first].filter(Boolean).sort()[0] ?? null;
  if (sameAnswer(old, young)) return { ...together(old, young), first };
  const cleared = isEmpty(young.value) && !isEmpty(old.value);
  const [loser, winner] = cleared ? [young, old] : [old, young];
  return withEarlier({ ...winner, first }, old.earlier, young.earlier, alone(loser));
}

/** The answer, and itself among the earlier ones: it is about to be replaced. @param {any} entry @returns {any} */
export function setAside(entry) {
  return withEarlier(entry, entry.earlier, alone(entry));
}

/** One answer with what either version says of it. @param {any} old @param {any} young */
function together(old, young) {
  const said = Object.entries(young).filter(([, part]) => (part ?? "") !== "");
  const both = { ...young, ...old, ...Object.fromEntries(said) };
  return withEarlier(both, old.earlier, young.earlier);
}

/** @param {any} a @param {any} b */
function sameAnswer(a, b) {
  return a.hash === b.hash && JSON.stringify(a.value) === JSON.stringify(b.value);
}

/** As an earlier answer; none, where nothing was answered. @param {any} entry @returns {any[]} */
function alone({ earlier: _, ...entry }) {
  return isEmpty(entry.value) ? [] : [entry];
}

/** Each earlier answer once, the oldest first. @param {any} entry @param {(any[] | undefined)[]} lists @returns {any} */
function withEarlier(entry, ...lists) {
  /** @type {Map<string, any>} */
  const found = new Map();
  for (const one of lists.flatMap((list) => list ?? [])) {
    const name = JSON.stringify([one.hash, one.value]);
    const before = found.get(name);
    found.set(name, before ? together(before, one) : one);
  }
  const all = [...found.values()];
  all.sort((x, y) => String(x.last ?? "").localeCompare(String(y.last ?? "")));
  return all.length ? { ...entry, earlier: all.slice(-MOST_EARLIER) } : entry;
}
