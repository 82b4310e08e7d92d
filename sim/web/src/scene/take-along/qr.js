/** The link as a QR code, for phones and tablets in the room. */

import { generate } from "lean-qr";
import { toSvg } from "lean-qr/extras/svg";
import { tr } from "../../../../view/language.js";
import { html } from "../../shared/dom.js";

/** @param {string} link @returns {Node[]} nothing where the page is a file of this computer, which no phone can open */
export function qrCode(link) {
  if (!/^https?:/.test(link)) return [];
  const picture = toSvg(generate(link), document, { on: "#000", off: "#fff", pad: 4, scale: 4 });
  picture.setAttribute("role", "img");
  picture.setAttribute("aria-label", tr("QR code of the link"));
  return [picture, html("p", "carts-quiet", tr("A phone that reads this opens the same state."))];
}
