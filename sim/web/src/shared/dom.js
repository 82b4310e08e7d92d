/** Small helpers for elements. Attributes are only written when they change: writing costs layout. */

const SVG = "http://www.w3.org/2000/svg";

/** @param {string} tag @param {Record<string, string | number>} attributes @returns {SVGElement} */
export function svg(tag, attributes = {}) {
  const made = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  return made;
}

/** @param {string} tag @param {string} className @param {string} text @returns {HTMLElement} */
export function html(tag, className = "", text = "") {
  const made = document.createElement(tag);
  if (className) made.className = className;
  if (text) made.textContent = text;
  return made;
}

/** @param {Element} element @param {string} name @param {string} value */
export function put(element, name, value) {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

/** Exactly `count` children. @param {Element} group @param {number} count @param {() => Element} make */
export function fit(group, count, make) {
  while (group.children.length > count) group.lastElementChild?.remove();
  while (group.children.length < count) group.append(make());
}

const TEXT = 3; // kind of a node; the build's document has no name for it

/**
 * A text that has the element for itself is changed in its place: a new one would make the browser
 * ask again which elements the sheets mean by what stands in them.
 * @param {Element} element @param {string} text
 */
export function say(element, text) {
  const only = element.firstChild;
  if (only?.nodeType === TEXT && !only.nextSibling) {
    if (only.nodeValue !== text) only.nodeValue = text;
  } else if (element.textContent !== text) element.textContent = text;
}

/**
 * The one element that a selector names; the generator wrote it, so its absence is a fault.
 * @template {Element} [T=HTMLElement] @param {ParentNode} root @param {string} selector @returns {T}
 */
export function need(root, selector) {
  const found = root.querySelector(selector);
  if (!found) throw new Error(`this page lacks ${selector}; it was built by another version`);
  return /** @type {T} */ (found);
}

/** @param {string} markup of one element @returns {HTMLElement} */
export function parsed(markup) {
  const holder = document.createElement("template");
  holder.innerHTML = markup;
  return /** @type {HTMLElement} */ (holder.content.firstElementChild);
}

/** Calls back whenever the element gets another size; when the generator draws, nothing has one. @param {Element} element @param {() => void} act */
export function onResize(element, act) {
  if (typeof ResizeObserver === "function") new ResizeObserver(act).observe(element);
}
