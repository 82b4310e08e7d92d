/**
 * The menu by keyboard, where a narrow window folds it away: the theme's button for it is a label, which
 * no key reaches. Enter is the theme's own once it does; the focus goes into the menu and comes back.
 */

export function menuByKey() {
  const box = /** @type {HTMLInputElement | null} */ (document.getElementById("__drawer"));
  /** @type {HTMLElement | null} */
  const button = document.querySelector("label.md-header__button[for=__drawer]");
  /** @type {HTMLElement | null} */
  const menu = document.querySelector("nav.md-nav--primary");
  if (!box || !menu || !button) return;
  button.tabIndex = 0;
  button.setAttribute("role", "button");
  button.setAttribute("aria-label", menu.getAttribute("aria-label") ?? "");
  const tell = () => button.setAttribute("aria-expanded", String(box.checked));
  tell();
  box.addEventListener("change", () => {
    tell();
    if (box.checked && button.matches(":focus-visible"))
      /** @type {HTMLElement | null} */ (menu.querySelector("li a"))?.focus();
  });
  button.addEventListener("keydown", (event) => {
    if (event.key !== " ") return;
    event.preventDefault(); // the page would scroll
    button.click();
  });
  menu.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !box.checked) return;
    box.click();
    button.focus();
  });
}
