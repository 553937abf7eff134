// Unpacks a field of the states: base64 -> zlib -> byte planes -> zigzag -> differences in time and along the chain -> integers.
// docs/formats.md has the format. The work is cut into slices of a few milliseconds, so that the page answers meanwhile.

/** Longest stretch of work at a time, ms. */
const SLICE_MS = 6;
/** Base64 characters that are decoded at a time; a multiple of 4. */
const CHUNK = 1 << 20;

/** Lets the browser do what waits. A message comes back sooner than the shortest timer. */
const breathe = (): Promise<void> =>
  new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(0);
  });

async function bytesOfBase64(text: string): Promise<Uint8Array<ArrayBuffer>> {
  const padding = text.endsWith('==') ? 2 : text.endsWith('=') ? 1 : 0;
  const bytes = new Uint8Array((text.length / 4) * 3 - padding);
  let at = 0;
  for (let from = 0; from < text.length; from += CHUNK) {
    const part = atob(text.slice(from, from + CHUNK));
    for (let i = 0; i < part.length; i++) bytes[at++] = part.charCodeAt(i);
    if (from + CHUNK < text.length) await breathe();
  }
  return bytes;
}

async function inflated(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/**
 * Integers q[frame][item][component] of one packed field; times the field's step they are SI values.
 * Throws where the text is damaged or of another length than the shape asks for.
 */
export async function unpackField(
  packed: string,
  frames: number,
  items: number,
  components: number,
): Promise<Int32Array<ArrayBuffer>> {
  const count = frames * items * components;
  const planes = await inflated(await bytesOfBase64(packed));
  if (planes.length !== 4 * count) throw new Error(`a field has ${planes.length} bytes, not ${4 * count}`);
  const q = new Int32Array(count);
  const row = items * components;
  let since = performance.now();
  for (let frame = 0; frame < frames; frame++) {
    unpackFrame(planes, q, count, frame * row, row, components);
    if (performance.now() - since > SLICE_MS) {
      await breathe();
      since = performance.now();
    }
  }
  return q;
}

/** One frame's integers, from the frame before it: q[f][i] = d + q[f][i-1] + q[f-1][i] - q[f-1][i-1], in 32 bits that wrap round. */
function unpackFrame(
  planes: Uint8Array,
  q: Int32Array,
  count: number,
  start: number,
  row: number,
  components: number,
): void {
  const first = start === 0;
  for (let j = 0; j < row; j++) {
    const at = start + j;
    const zigzag =
      planes[at]! | (planes[at + count]! << 8) | (planes[at + 2 * count]! << 16) | (planes[at + 3 * count]! << 24);
    let value = (zigzag >>> 1) ^ -(zigzag & 1);
    if (j >= components) value += q[at - components]! - (first ? 0 : q[at - row - components]!);
    if (!first) value += q[at - row]!;
    q[at] = value;
  }
}
