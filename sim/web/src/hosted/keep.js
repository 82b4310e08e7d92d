/**
 * “Keep this on your tablet”: a site of a web server installs itself, as a file that was downloaded does
 * not open on a tablet. Browsers differ: one asks when it is told to, in others the reader has to.
 */

import { tr } from "../../../view/language.js";
import { html, say } from "../shared/dom.js";

/** @typedef {Event & {prompt: () => Promise<{outcome: string}>}} Offer what Chromium gives, once the site can be installed */

/** @param {(line: HTMLElement) => void} put called once, if there is something to say */
export function keepLine(put) {
  if (window.top !== window) return; // a learning platform's frame: what the browser keeps is its page
  if (matchMedia("(display-mode: standalone)").matches) return; // it was kept, and opened from there
  const how = byHand();
  if (how) {
    put(html("p", "carts-keep", `${tr("Keep this on your tablet:")} ${how}`));
    return;
  }
  addEventListener(
    "beforeinstallprompt",
    (event) => {
      event.preventDefault();
      put(button(/** @type {Offer} */ (event)));
    },
    { once: true },
  );
}

/** What the reader has to press where the page cannot ask; "" where it can, or nothing can. */
function byHand() {
  const { userAgent, maxTouchPoints } = navigator;
  // An iPad says that it is a Mac; a Mac has no screen to touch.
  if (/iPad|iPhone/.test(userAgent) || (/Macintosh/.test(userAgent) && maxTouchPoints > 1)) {
    return tr("press Share, then Add to Home Screen. Then it opens without a network.");
  }
  if (/Android/.test(userAgent) && /Firefox/.test(userAgent)) {
    return tr("open the menu, then Add to Home screen. Then it opens without a network.");
  }
  return "";
}

/** @param {Offer} offer */
function button(offer) {
  const line = html("p", "carts-keep");
  const press = html("button", "md-button", tr("Keep this on your tablet or computer"));
  press.setAttribute("type", "button");
  const said = html("span", "", tr("Then it opens without a network, like an app."));
  said.setAttribute("role", "status");
  press.addEventListener("click", async () => {
    const { outcome } = await offer.prompt();
    press.hidden = true; // a browser asks once for each offer
    say(said, outcome === "accepted" ? tr("Kept.") : tr("The browser's own menu can do it too."));
  });
  line.append(press, " ", said);
  return line;
}
