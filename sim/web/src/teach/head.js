/** The head of the panel: its name, a button that folds it away, one that closes it. */

import { button } from "../answers/parts.js";
import { html } from "../shared/dom.js";

/** @param {import("./session.js").Session} session @param {HTMLElement} panel */
export function head(session, panel) {
  const root = html("div", "carts-teach-head");
  const heading = html("h2", "", "Change this lesson");
  heading.tabIndex = -1;
  const fold = () => {
    const folded = panel.classList.toggle("carts-teach-folded");
    document.body.classList.toggle("carts-teaching-folded", folded);
    small.setAttribute("aria-expanded", String(!folded));
    small.textContent = folded ? "Show" : "Make room";
  };
  const small = button("Make room", fold, "carts-teach-fold");
  small.setAttribute("aria-expanded", "true");
  root.append(
    heading,
    small,
    button("Close", () => session.close(), "carts-teach-close"),
  );
  return { root, heading };
}
