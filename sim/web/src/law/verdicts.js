/** What the judge says: each law of physics, whether it holds, and where it can be seen that it does not. */

import { told, tr } from "../../../view/language.js";
import { html } from "../shared/dom.js";

/** @typedef {import("../../../view/language.js").Said} Said */
/** @typedef {{check: string, says: Said, holds: boolean, amount: number | null, sentence: Said, scene: any, yaml: string | null}} Verdict */
/** @typedef {{law: string, holds: boolean, sentence: Said, verdicts: Verdict[]}} Judged */

/** @param {Judged} judged @param {(verdict: Verdict) => void} show @returns {HTMLElement} */
export function verdicts(judged, show) {
  const root = html("div", "carts-law-verdicts");
  root.append(html("p", "carts-heading", tr("What the judge found")));
  root.append(html("p", "", told(judged.sentence)));
  const list = html("ul");
  for (const one of judged.verdicts) {
    const item = html("li", one.holds ? "carts-law-holds" : "carts-law-broken");
    item.dataset.check = one.check;
    const word = one.holds ? tr("no counterexample") : tr("broken");
    item.append(html("b", "", word), ` ${told(one.says)}`);
    if (!one.holds) item.append(...counterexample(one, show));
    list.append(item);
  }
  root.append(list);
  return root;
}

/** @param {Verdict} verdict @param {(verdict: Verdict) => void} show */
function counterexample(verdict, show) {
  const button = html("button", "carts-button", tr("Show this scene"));
  button.setAttribute("type", "button");
  button.setAttribute("aria-label", `${tr("Show this scene")}: ${told(verdict.says)}`);
  button.addEventListener("click", () => show(verdict));
  const details = html("details");
  const text = html("pre", "", verdict.yaml ?? "");
  text.tabIndex = 0;
  details.append(html("summary", "", tr("As a scene file")), text);
  return [html("p", "", told(verdict.sentence)), button, details];
}
