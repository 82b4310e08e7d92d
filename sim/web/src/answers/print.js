/** The page on paper: with the answers, or empty, to be filled in by hand. */

const EMPTY = "carts-print-empty";
const CORE = "carts-print-core"; // without what the lesson marks as for who has time

/** @param {boolean} empty without the answers, and the core of the lesson only */
export function print(empty) {
  const { classList } = document.documentElement;
  for (const name of [EMPTY, CORE]) classList.toggle(name, empty);
  for (const dialog of document.querySelectorAll("dialog")) dialog.close();
  window.print();
}

/** On paper a page on which nothing was done is one to be filled in, whichever way it is printed. @param {import("./book.js").Book} book */
export function printUntouchedEmpty(book) {
  const { classList } = document.documentElement;
  addEventListener("beforeprint", () => {
    if (book.untouched) classList.add(EMPTY);
  });
  addEventListener("afterprint", () => classList.remove(EMPTY, CORE));
}
