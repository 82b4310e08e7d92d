/** The name of a link between two objects, as in Python's `Link.name`; empty where it is none. */

const WAYS = ["contact", "distance"];

/** @param {string[]} objects in the author's order @param {unknown} between two of them @param {unknown} by */
export function linkName(objects, between, by) {
  if (
    !Array.isArray(between) ||
    between.length !== 2 ||
    typeof by !== "string" ||
    !WAYS.includes(by)
  )
    return "";
  const [a, b] = between.map((one) => objects.indexOf(one)).sort((one, other) => one - other);
  return a === undefined || b === undefined || a < 0 || a === b ? "" : `${a + 1}-${b + 1}-${by}`;
}
