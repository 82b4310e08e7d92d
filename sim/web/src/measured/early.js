/** What a bench does before anything is asked of it: it says that Python is there, and finds what each cart did. */

/** @typedef {import("../../../view/measured/types.js").Segment} Segment */

/** For the fit and for what happened; reading and the model by hand do without. */
export const PACKAGES = ["numpy", "scipy"];

/**
 * Says when Python is there: without readings nothing is asked, and that is all there is to wait for.
 * @param {HTMLElement} bench @param {import("../runtime/client.js").Client} client @param {AbortSignal} signal
 */
export function whenLive(bench, client, signal) {
  const live = () => {
    if (client.state === "ready") bench.dataset.state = "live";
  };
  client.addEventListener("state", live, { signal });
  live();
}

/**
 * The segments, without any fit. They take the packages of a fit: of whoever brings readings one is expected.
 * @param {import("../runtime/client.js").Client} client @param {import("./asking.js").Asking} asking
 * @returns {Promise<{names: string[], segments?: Segment[]} | null>} null where Python cannot: a fit says why
 */
export async function happened(client, asking) {
  try {
    await client.need(PACKAGES);
    return await asking.ask("segments");
  } catch {
    return null;
  }
}
