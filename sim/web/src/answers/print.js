/** The page on paper: with the answers, or empty, to be filled in by hand. */

/** @param {boolean} empty without the answers, and without what the lesson marks as for who has time */
export function print(empty) {
  const { classList } = document.documentElement;
  classList.toggle("carts-print-empty", empty);
  addEventListener("afterprint", () => classList.remove("carts-print-empty"), { once: true });
  for (const dialog of document.querySelectorAll("dialog")) dialog.close();
  window.print();
}
