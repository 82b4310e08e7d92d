/** The Python of a page: one for all its elements, started when the page is idle or first touched. */

import { Client } from "./client.js";
import { SLOW, SLOW_LINE, startRuntime } from "./runtime.js";

/**
 * To be called while the page's script runs for the first time: the runtime lies beside that.
 * @param {() => string[]} packages what the page's elements need beside bare Python, asked at the start
 */
export function pagePython(packages) {
  const base = besideScript("runtime/");
  const onProgress = (/** @type {{stage: string}} */ { stage }) => {
    if (stage === SLOW || stage === SLOW_LINE) client.dispatchEvent(new Event(stage));
  };
  const client = new Client((more) =>
    startRuntime({ base, packages: [...packages(), ...more], onProgress }),
  );
  client.addEventListener("state", () => tell(client.state));
  return client;
}

/**
 * The address of a folder beside the page's script, which runs for the first time now.
 * @param {string} folder with a slash at its end
 */
export function besideScript(folder) {
  const script = /** @type {HTMLScriptElement | null} */ (document.currentScript);
  const own = new URL(script?.src || document.baseURI); // in a page that is one file it has no address
  return new URL(`${folder}${own.search}`, own).href;
}

/** Starts Python as soon as the page has nothing else to do. @param {Client} client */
export function startWhenIdle(client) {
  tell("starting");
  if (typeof requestIdleCallback === "function") {
    requestIdleCallback(() => client.wake(), { timeout: 1000 });
  } else setTimeout(() => client.wake(), 200);
}

/** @param {import("./client.js").State} state */
function tell(state) {
  document.documentElement.dataset.python = state;
}
