/** The page on paper: with the answers, or empty, to be filled in by hand. */

const OPTIONAL = "carts-optional";

/** @param {boolean} empty without the answers, and without what the lesson marks as for who has time */
export function print(empty) {
  const { classList } = document.documentElement;
  classList.toggle("carts-print-empty", empty);
  addEventListener("afterprint", () => classList.remove("carts-print-empty"), { once: true });
  for (const dialog of document.querySelectorAll("dialog")) dialog.close();
  markOptional();
  window.print();
}

/** Marks what stands below a heading of an optional part, up to the next heading of its kind. */
function markOptional() {
  let optional = false;
  for (const one of document.querySelector(".md-content__inner")?.children ?? []) {
    if (/^H[12]$/.test(one.tagName)) optional = one.classList.contains("more");
    one.classList.toggle(OPTIONAL, optional);
  }
}
