/** What a piece of a lesson is called in the panel: the first of it that a reader sees. */

/** Where there is none. */
export const EMPTY = "+ text here";

/** @param {Pick<import("./types.js").Piece, "kind" | "text" | "title" | "id">} piece */
export function titleOf({ kind, text, title, id }) {
  if (kind === "top") return seen(/^title: *(.*)/m.exec(text)?.[1] ?? "");
  if (kind === "block") {
    const said = (title ?? "").replace(TABLE, "") || title?.split("\n")[0];
    return short(seen(unbarred(said || id || text.split("\n")[0] || "")));
  }
  const heading = /^#+ +(.+)/m.exec(text)?.[1];
  const lines = heading ? [heading] : text.split("\n").map(unmarked);
  return short(lines.map(seen).find(Boolean) ?? EMPTY);
}

/** At the beginning of a question: what is asked stands below it. */
const TABLE = /^ *\|.*\n *\|[ :|-]+(?:\n *\|.*)*\s*/;

/** A row of a table as its cells. @param {string} line */
const unbarred = (line) => {
  if (!/^ *\|.*\| *$/.test(line)) return line;
  const cells = line.split("|").map((cell) => cell.trim());
  return cells.filter((cell) => /[^:-]/.test(cell)).join(", ");
};

/** @param {string} words */
const short = (words) => (words.length > 70 ? `${words.slice(0, 70)}…` : words);

/** A line without what makes it one of a list or a quotation; a # or a > within it is read. @param {string} line */
const unmarked = (line) => unbarred(line.replace(/^ *(?:#+(?: |$)|(?:> ?)+|(?:[-+*]|\d+\.) )/, ""));

/** A line of Markdown as it is read. @param {string} line */
function seen(line) {
  return line
    .replace(/^(?:!!!|\?{3}\+?) .*?"(.*)".*$/, "$1") // a box: its title
    .replace(/^(?:!!!|\?{3}\+?) (\w+).*$/, "$1") // without one: its kind
    .replace(/<!--.*?-->|\{:?[^}]*\}/g, "")
    .replace(/!?\[([^\]]*)\]\([^)]*\)/g, "$1")
    .replace(/[*_`$]/g, "")
    .trim();
}
