/** Scripts that lie beside the page and are read only when somebody needs them. */

/**
 * What such a script puts into a global name; null where it does not lie there (a page that is one file
 * has it inside, or goes without).
 * @param {string} name the global name @param {string} address of the script @returns {Promise<any>}
 */
export function bring(name, address) {
  const known = () => /** @type {any} */ (globalThis)[name] ?? null;
  if (known()) return Promise.resolve(known());
  return new Promise((resolve) => {
    const script = document.createElement("script");
    script.src = address;
    script.onload = () => resolve(known());
    script.onerror = () => {
      script.remove();
      resolve(null);
    };
    document.head.append(script);
  });
}
