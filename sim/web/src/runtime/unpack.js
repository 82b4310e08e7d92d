// The page's side of unpacker.js.
import { RuntimeFailure } from "./failure.js";
// @ts-expect-error: the bundler puts the worker's text here
import unpackerText from "./unpacker.js?text";

/** A worker of these texts. @param {BlobPart[]} texts */
export function workerOf(texts) {
  const address = URL.createObjectURL(new Blob(texts, { type: "text/javascript" }));
  try {
    return { worker: new Worker(address), address };
  } catch (error) {
    throw new RuntimeFailure("worker-refused", String(error));
  }
}

/** Unpacks files beside the page. */
export class Unpacker {
  /** @param {(error: RuntimeFailure) => void} reject told of a damaged file, and if it can't work at all */
  constructor(reject) {
    const { worker, address } = workerOf([unpackerText]);
    this.worker = worker;
    this.address = address;
    /** @type {Map<string, (bytes: ArrayBuffer) => void>} */
    this.waiting = new Map();
    worker.onmessage = ({ data }) => {
      if (data.bytes) this.waiting.get(data.name)?.(data.bytes);
      else reject(new RuntimeFailure("payload-damaged", data.error, data.name));
    };
    worker.onerror = (event) => {
      event.preventDefault();
      reject(new RuntimeFailure("worker-refused", event.message));
    };
  }

  /**
   * @param {string} name
   * @param {Promise<Uint8Array<ArrayBuffer>>[]} parts gzip; given away
   * @returns {Promise<ArrayBuffer>} one that never comes has been told of
   */
  async unpack(name, parts) {
    /** @type {Promise<ArrayBuffer>} */
    const unpacked = new Promise((resolve) => this.waiting.set(name, resolve));
    for (const [number, part] of parts.entries()) {
      const bytes = await part;
      this.worker.postMessage({ name, bytes, last: number === parts.length - 1 }, [bytes.buffer]);
    }
    return unpacked;
  }

  stop() {
    this.worker.terminate();
    URL.revokeObjectURL(this.address);
  }
}
