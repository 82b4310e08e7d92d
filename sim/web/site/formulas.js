// Draws the formulas of a page with KaTeX. Without it the page shows the TeX source, which can
// still be read; a mistake in a formula is shown in red and does not stop the others.

(() => {
  /** @type {{render: (tex: string, element: HTMLElement, options: object) => void}} */
  const katex = /** @type {any} */ (window).katex;

  // The page's policy forbids style attributes. KaTeX writes a few; the same text through the
  // style object is allowed.
  const { setAttribute } = Element.prototype;
  /** @this {HTMLElement} @param {string} name @param {string} value */
  Element.prototype.setAttribute = function (name, value) {
    if (name === "style") this.style.cssText = value;
    else setAttribute.call(this, name, value);
  };
  // What a question says later waits in templates.
  const parts = [document, ...[...document.querySelectorAll("template")].map((t) => t.content)];
  for (const element of parts.flatMap((part) => [...part.querySelectorAll(".arithmatex")])) {
    const source = (element.textContent ?? "").trim();
    const displayMode = source.startsWith("\\[");
    const tex = source.replace(/^\\[[(]|\\[\])]$/g, "");
    katex.render(tex, /** @type {HTMLElement} */ (element), { displayMode, throwOnError: false });
  }
  Element.prototype.setAttribute = setAttribute;
})();
