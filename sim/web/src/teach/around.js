/** What the page is like while teacher mode is open, and what it says when it was left with a draft. */

import { button } from "../answers/parts.js";
import { html } from "../shared/dom.js";
import { tellDraft } from "./door.js";

const TEACHING = "carts-teaching"; // of the body
const WAITS = "carts-runs"; // under it, what waits for a run is closed: a teacher sees and changes that too

export function enter() {
  document.querySelector(".carts-teach-draft")?.remove();
  document.documentElement.classList.remove(WAITS);
  document.body.classList.add(TEACHING);
}

/** @param {import("./session.js").Session} session */
export function leave(session) {
  document.body.classList.remove(TEACHING);
  document.documentElement.classList.add(WAITS);
  const address = new URL(location.href);
  address.searchParams.delete("teacher");
  if (address.hash === "#teacher") address.hash = "";
  history.replaceState(null, "", address.href.replace(/#$/, ""));
  tellDraft(session.link);
  session.link.focus({ preventScroll: true }); // it is at the foot
  if (!session.changed) return;
  const line = draftLine(session);
  session.page.article.before(line);
  line.querySelector("button")?.focus();
}

/** @param {import("./session.js").Session} session */
function draftLine(session) {
  const line = html("p", "carts carts-teach-draft");
  const on = button("Go on changing", () => session.show(), "carts-teach-on");
  line.append(html("span", "", "You see your draft, not the published lesson."), " ", on);
  const kept = session.panel.root.dataset.kept === "true";
  const away = button("Show the published one", () => location.reload(), "carts-teach-leave");
  if (kept) line.append(" ", away); // else it would be lost
  return line;
}
