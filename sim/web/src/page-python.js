/** The Python of a page: one for all its elements, started when the page is idle or first touched. */

import { Client } from "./client.js";
import { startRuntime } from "./runtime.js";

/**
 * @param {string} script address of the page's script, beside the folder of the runtime
 * @param {() => string[]} packages what the page's elements need beside bare Python, asked at the start
 */
export function pagePython(script, packages) {
  const base = new URL("runtime/", script).href;
  const client = new Client((more) => startRuntime({ base, packages: [...packages(), ...more] }));
  const tell = () => {
    document.documentElement.dataset.python = client.state;
  };
  client.addEventListener("state", tell);
  return client;
}

/** Starts Python as soon as the page has nothing else to do. @param {Client} client */
export function startWhenIdle(client) {
  document.documentElement.dataset.python = "starting";
  if (typeof requestIdleCallback === "function") {
    requestIdleCallback(() => client.wake(), { timeout: 1000 });
  } else setTimeout(() => client.wake(), 200);
}
