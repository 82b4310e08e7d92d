// Draws the formulas of a page with KaTeX. Without it the page shows the TeX source, which can
// still be read; a mistake in a formula is shown in red and does not stop the others.

/** @type {{render: (tex: string, element: HTMLElement, options: object) => void}} */
const katex = /** @type {any} */ (window).katex;

for (const element of document.querySelectorAll(".arithmatex")) {
  const source = (element.textContent ?? "").trim();
  const displayMode = source.startsWith("\\[");
  const tex = source.replace(/^\\[[(]|\\[\])]$/g, "");
  katex.render(tex, /** @type {HTMLElement} */ (element), { displayMode, throwOnError: false });
}
