// The start page in the zip: is the rest of the folder here, and can this browser run the lessons?
//
// Opened inside a zip viewer the page is alone: the viewer has unpacked this one file somewhere
// among its temporary files. Then there is no way on, only a way out: unpack first.

(() => {
  const PATIENCE = 4000; // ms for a worker to answer

  /** @param {string} id */
  const part = (id) => /** @type {HTMLElement} */ (document.getElementById(id));

  /** @param {string} id */
  function show(id) {
    part(id).hidden = false;
  }

  /** The kind of computer, for the words that fit it. */
  function system() {
    const agent = navigator.userAgent;
    if (/CrOS/.test(agent)) return "chromeos";
    if (/Android|iPhone|iPad/.test(agent) || (/Mac/.test(agent) && navigator.maxTouchPoints > 1)) {
      return "phone";
    }
    if (/Windows/.test(agent)) return "windows";
    return /Mac/.test(agent) ? "mac" : "linux";
  }

  /** Whether a file that lies beside this page can be read. @returns {Promise<boolean>} */
  function complete() {
    return new Promise((done) => {
      const picture = new Image();
      picture.addEventListener("load", () => done(true));
      picture.addEventListener("error", () => done(false));
      picture.src = "assets/images/favicon.png";
    });
  }

  /** Whether a worker may run, as the lessons need one. @returns {Promise<boolean>} */
  function worker() {
    return new Promise((done) => {
      setTimeout(() => done(false), PATIENCE);
      try {
        const blob = new Blob(["postMessage(1)"], { type: "text/javascript" });
        const made = new Worker(URL.createObjectURL(blob));
        made.addEventListener("message", () => done(true));
        made.addEventListener("error", () => done(false));
      } catch {
        done(false);
      }
    });
  }

  /** Whether answers can be kept. @returns {Promise<boolean>} */
  function storage() {
    return new Promise((done) => {
      try {
        const asked = indexedDB.open("carts-open-me");
        asked.addEventListener("success", () => {
          asked.result.close();
          indexedDB.deleteDatabase("carts-open-me");
          done(true);
        });
        asked.addEventListener("error", () => done(false));
        asked.addEventListener("blocked", () => done(false));
      } catch {
        done(false);
      }
    });
  }

  async function check() {
    part("checking").hidden = true;
    if (!(await complete())) {
      document.body.dataset.state = "alone";
      show("alone");
      show(`unpack-${system()}`);
      return;
    }
    const modern =
      typeof WebAssembly === "object" &&
      typeof DecompressionStream === "function" &&
      typeof structuredClone === "function" &&
      (await worker());
    document.body.dataset.state = modern ? "ready" : "old";
    show(modern ? "ready" : "old");
    show("open");
    if (!(await storage())) show("no-storage");
    if (/\.zip\b|\/Temp1_/i.test(decodeURIComponent(location.pathname))) show("still-zip");
  }

  void check();
})();
