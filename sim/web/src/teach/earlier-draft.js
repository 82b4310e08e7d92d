/** A draft of an earlier version of the lesson, or of another tab: offered, never thrown away unasked. */

import { button, clock } from "../answers/parts.js";
import { html } from "../shared/dom.js";
import { download } from "../shared/download.js";

const NOT_DELETED = "This browser refused to delete it.";

/** @param {import("./session.js").Session} session @param {import("./drafts.js").Draft} draft @returns {HTMLElement} */
export function earlierDraft(session, draft) {
  const row = html("p", "carts-teach-earlier");
  const which =
    draft.hash === session.drafts.hash
      ? "another draft of this lesson"
      : "a draft of an earlier version of this lesson";
  row.append(
    `You have ${which}, of ${clock(draft.last)}. `,
    button("Open it", () => session.change(draft.text, ""), "carts-teach-older"),
    " ",
    button("Save it", () => download(session.name, draft.text, "text/markdown")),
    " ",
    button("Delete it", () => {
      void session.drafts.forget(draft.key).then(
        () => row.remove(),
        () => row.append(" ", NOT_DELETED),
      );
    }),
  );
  return row;
}
