/** Formulas in what was made anew, drawn as site/formulas.js draws those of a page. */

/** @param {ParentNode} root @param {string} assets address of assets/carts/ */
export async function drawFormulas(root, assets) {
  const waiting = [...root.querySelectorAll(".arithmatex")].filter(
    (element) => !element.querySelector(".katex"),
  );
  if (!waiting.length) return;
  const page = /** @type {any} */ (globalThis);
  if (!page.katex) await loadKatex(assets);
  // The page's policy forbids style attributes; the same text through the style object is allowed.
  const { setAttribute } = Element.prototype;
  /** @this {HTMLElement} @param {string} name @param {string} value */
  Element.prototype.setAttribute = function (name, value) {
    if (name === "style") this.style.cssText = value;
    else setAttribute.call(this, name, value);
  };
  try {
    for (const element of waiting) {
      const source = (element.textContent ?? "").trim();
      const displayMode = source.startsWith("\\[");
      const tex = source.replace(/^\\[[(]|\\[\])]$/g, "");
      page.katex.render(tex, element, { displayMode, throwOnError: false });
    }
  } finally {
    Element.prototype.setAttribute = setAttribute;
  }
}

/** @param {string} assets */
function loadKatex(assets) {
  const style = document.createElement("link");
  style.rel = "stylesheet";
  style.href = new URL("katex/katex.min.css", assets).href;
  const script = document.createElement("script");
  script.src = new URL("katex/katex.min.js", assets).href;
  document.head.append(style, script);
  return new Promise((resolve, reject) => {
    script.onload = resolve;
    script.onerror = reject;
  });
}
