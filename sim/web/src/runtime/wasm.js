// Python's machine code, compiled by the page while it still comes, and only once: a worker that has
// to be replaced gets the same module.
import { RuntimeFailure } from "./failure.js";
import { isOutOfMemory } from "./memory.js";

/** The empty module. */
const NOTHING = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0]);

/** Says so before anything large is loaded, where there is no WebAssembly or no leave to use it. */
export function requireWasm() {
  if (typeof WebAssembly !== "object") throw new RuntimeFailure("no-wasm");
  try {
    new WebAssembly.Module(NOTHING);
  } catch (error) {
    // Chromium before 97 does not know the word by which our policy allows WebAssembly, nor `findLast`.
    const old = !("findLast" in Array.prototype);
    throw new RuntimeFailure(old ? "too-old" : "wasm-refused", String(error));
  }
}

/** Why compiling failed. @param {unknown} error */
export function compileFailure(error) {
  const reason = isOutOfMemory(error) ? "no-memory" : "too-old";
  return new RuntimeFailure(reason, String(error), "pyodide.asm.wasm");
}

/**
 * @param {Promise<Uint8Array<ArrayBuffer>>[]} parts gzip
 * @returns {Promise<WebAssembly.Module>}
 */
export async function compile(parts) {
  const zip = new DecompressionStream("gzip");
  const headers = { "Content-Type": "application/wasm" };
  const compiled = WebAssembly.compileStreaming(new Response(zip.readable, { headers }));
  const written = write(zip.writable.getWriter(), parts);
  const [module] = await Promise.all([compiled, written]);
  return module;
}

/**
 * @param {WritableStreamDefaultWriter<BufferSource>} writer
 * @param {Promise<Uint8Array<ArrayBuffer>>[]} parts
 */
async function write(writer, parts) {
  for (const part of parts) await writer.write(await part);
  await writer.close();
}
