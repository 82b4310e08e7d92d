/** Which form each kind of question has. */

import { matchForm, orderForm } from "./arrange.js";
import { choiceForm } from "./choice.js";
import { interactionsForm } from "./interactions.js";
import { drawnForm } from "./run.js";
import { tableForm } from "./table.js";
import { numberForm, wordsForm } from "./typed.js";

/** @type {Record<string, (root: HTMLElement, changed: () => void, facts: any) => import("../element.js").Form>} */
export const FORMS = {
  single: choiceForm,
  multiple: choiceForm,
  confidence: choiceForm,
  number: numberForm,
  reading: numberForm,
  short: wordsForm,
  long: wordsForm,
  ordering: orderForm,
  matching: matchForm,
  table: tableForm,
  interactions: interactionsForm,
  drawn: drawnForm,
  idea: (root, changed, { options }) => (options.length ? choiceForm : wordsForm)(root, changed),
};
