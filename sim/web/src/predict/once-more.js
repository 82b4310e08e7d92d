/** After the run: the same question once more, beside what was said before. Kept, never marked. */

import { tr } from "../../../view/language.js";
import { html } from "../shared/dom.js";

export class OnceMore {
  /** @param {HTMLInputElement[]} radios of the prediction, whose options come back */
  constructor(radios) {
    this.options = radios.map((radio) => ({
      value: radio.value,
      text: radio.closest("label")?.textContent?.trim() ?? "",
    }));
    this.name = `${radios[0]?.name}-now`;
  }

  /** @param {string | null} value @returns {string} the words of an option */
  said(value) {
    return this.options.find((option) => option.value === value)?.text ?? "";
  }

  /** @param {string | null} now what was chosen at an earlier visit @param {(value: string) => void} choose */
  draw(now, choose) {
    const set = html("fieldset", "carts-once-more");
    set.append(html("legend", "", tr("When you have seen enough, the same question once more:")));
    for (const { value, text } of this.options) {
      const line = html("label");
      const radio = document.createElement("input");
      Object.assign(radio, { type: "radio", name: this.name, value, checked: value === now });
      radio.autocomplete = "off";
      radio.addEventListener("change", () => choose(value));
      line.append(radio, html("span", "", text));
      set.append(line);
    }
    return set;
  }
}
