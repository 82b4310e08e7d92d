/** Answers that were given before: to an older wording, or on another computer. */

import { tr } from "../../../view/language.js";
import { isEmpty } from "../answers/entry.js";
import { html, need, say } from "../shared/dom.js";

/** Shows them below the question. @param {HTMLElement} question @param {any[]} earlier entries @param {string} hash of the question as it is now */
export function showEarlier(question, earlier, hash) {
  const place = need(question, ".carts-q-earlier");
  const old = earlier.filter((entry) => !isEmpty(entry.value));
  place.hidden = old.length === 0;
  place.replaceChildren(
    ...old.map((entry) => {
      const line = html("p");
      const head =
        entry.hash !== hash
          ? tr("Your answer to an earlier version of this question:")
          : tr("Your other answer:");
      line.append(html("strong", "", head), " ", entry.said || JSON.stringify(entry.value));
      return line;
    }),
  );
}

/** What was thought at the beginning, beside the answer of now. @param {HTMLElement} question @param {any} first null: nothing is shown */
export function showFirstIdea(question, first) {
  const place = need(question, ".carts-q-first");
  place.hidden = !first || isEmpty(first.value);
  if (place.hidden) return;
  say(place, tr("Your first idea was: {said}", { said: first.said || String(first.value) }));
}
