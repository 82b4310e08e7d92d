/** Teacher mode: a script of its own, loaded when a teacher asks for it, with a Python of its own. */

import { Client } from "./runtime/client.js";
import { startRuntime } from "./runtime/runtime.js";
import { missingFeatures } from "./shared/features.js";
import { OPEN } from "./teach/door.js";
import { Drafts } from "./teach/drafts.js";
import { Session } from "./teach/session.js";
import { loadLesson } from "./teach/source.js";

const PACKAGE = "newtons-carts-teacher";

/** @type {Promise<Session> | null} */
let session = null;

async function begin() {
  const link = /** @type {HTMLElement} */ (document.querySelector(".carts-teach-door a"));
  const address = new URL(link.dataset.lesson ?? "", document.baseURI).href;
  const assets = new URL("../", address).href;
  const told = await loadLesson(address);
  const base = new URL(`runtime/${new URL(address).search}`, assets).href;
  const client = new Client((more) => startRuntime({ base, packages: [PACKAGE, ...more] }));
  const made = new Session({ told, client, assets, drafts: new Drafts(told), link });
  await made.open();
  return made;
}

document.addEventListener(OPEN, () => {
  const missing = missingFeatures();
  if (missing.length) {
    const link = document.querySelector(".carts-teach-door a");
    if (link) link.textContent = `This browser is too old for it (missing: ${missing.join(", ")})`;
    return;
  }
  if (session) void session.then((open) => open.show());
  else {
    session = begin();
    session.catch((error) => {
      session = null;
      const link = document.querySelector(".carts-teach-door a");
      if (link) link.textContent = `Teacher mode cannot be opened: ${error.message}`;
    });
  }
});
