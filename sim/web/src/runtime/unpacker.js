// Unpacks files while their parts come, in a worker of its own: beside Python's, which starts meanwhile.

/** @type {Map<string, WritableStreamDefaultWriter>} */
const writers = new Map();

/** The way into a file whose first part has come. @param {string} name */
function begin(name) {
  const zip = new DecompressionStream("gzip");
  const tell = (/** @type {ArrayBuffer} */ bytes) =>
    self.postMessage({ name, bytes }, { transfer: [bytes] });
  const damaged = (/** @type {unknown} */ error) =>
    self.postMessage({ name, error: String(error) });
  new Response(zip.readable).arrayBuffer().then(tell, damaged);
  return zip.writable.getWriter();
}

self.onmessage = ({ data: { name, bytes, last } }) => {
  const writer = writers.get(name) ?? begin(name);
  writers.set(name, writer);
  writer.write(bytes).catch(() => {}); // who reads tells what is damaged
  if (last) writer.close().catch(() => {});
};
