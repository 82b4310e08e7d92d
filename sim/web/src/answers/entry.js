/**
 * One kept answer, and how two versions of it come together without losing either. Pure.
 *
 * @typedef {{id: string, form?: string, lesson?: string, lessonHash?: string, hash?: string, type: string,
 *   value: any, said?: string, asked?: string, unit?: string, sure?: string | null, own?: number | null,
 *   first: string | null, last: string | null, tries: number, judged?: boolean, locked?: string | null,
 *   earlier?: Entry[]}} Entry
 */

const MOST_EARLIER = 500; // of one question; a file that says more is not from here

/** Whether nothing has been answered. @param {any} value @returns {boolean} */
export function isEmpty(value) {
  if (typeof value === "string") return !value.trim();
  if (value === null || value === undefined) return true;
  return typeof value === "object" && Object.keys(value).length === 0;
}

/** What is to be stored in the place of `old`. @param {any} old @param {any} value @returns {any} */
export function keepEarlier(old, value) {
  if (!old || typeof old !== "object" || typeof value !== "object" || value === null) return value;
  const earlier = union(old.earlier, value.earlier);
  const other = old.hash && value.hash && old.hash !== value.hash && !isEmpty(old.value);
  const all = other ? union(earlier, [alone(old)]) : earlier;
  return all.length ? { ...value, earlier: all } : value;
}

/** Two versions of one answer: the later one counts, the other is kept. @param {any} a @param {any} b @returns {any} */
export function merged(a, b) {
  if (!a) return b;
  if (!b) return a;
  const [old, young] = String(a.last ?? "") <= String(b.last ?? "") ? [a, b] : [b, a];
  const earlier = union(old.earlier, young.earlier);
  const differs = !isEmpty(old.value) && !sameAnswer(old, young);
  const winner = isEmpty(young.value) && differs ? old : young;
  const loser = winner === young ? old : young;
  const all = differs && winner === young ? union(earlier, [alone(loser)]) : earlier;
  const first = [a.first, b.first].filter(Boolean).sort()[0] ?? null;
  return all.length ? { ...winner, first, earlier: all } : { ...winner, first };
}

/** @param {any} a @param {any} b */
function sameAnswer(a, b) {
  return a.hash === b.hash && JSON.stringify(a.value) === JSON.stringify(b.value);
}

/** @param {any} entry */
function alone({ earlier: _, ...entry }) {
  return entry;
}

/** @param {any[] | undefined} a @param {any[] | undefined} b @returns {any[]} each answer once, oldest first */
function union(a, b) {
  /** @type {Map<string, any>} */
  const found = new Map();
  for (const entry of [...(a ?? []), ...(b ?? [])]) {
    found.set(JSON.stringify([entry.hash, entry.value]), entry);
  }
  const all = [...found.values()];
  all.sort((x, y) => String(x.last ?? "").localeCompare(String(y.last ?? "")));
  return all.slice(-MOST_EARLIER);
}
