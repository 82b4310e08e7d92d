/** The key that ends a line, and not the one by which an input method takes a word over: that ends no answer. */

/** @param {KeyboardEvent} event whose 229 is Safari's: there the word is composed by then */
export const isEnter = ({ key, isComposing, keyCode }) =>
  key === "Enter" && !isComposing && keyCode !== 229;

/** A key that is held down acts once. @param {HTMLElement | null} box @param {() => void} act */
export function onEnter(box, act) {
  box?.addEventListener("keydown", (event) => isEnter(event) && !event.repeat && act());
}
