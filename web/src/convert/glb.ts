// Writes GLB, the binary form of glTF 2.0: a header, the scene as JSON, the numbers of the shapes.
import { counted, type Node, Refused, type Shape } from './model';

const TRIANGLES = 4;
const POINTS = 0;
const FLOAT = 5126;
const UINT = 5125;

interface Accessor {
  bufferView: number;
  componentType: number;
  count: number;
  type: string;
  min?: number[];
  max?: number[];
}

/** The JSON's arrays, and the numbers behind them. */
class Writer {
  readonly nodes: object[] = [];
  readonly meshes: object[] = [];
  readonly accessors: Accessor[] = [];
  readonly views: object[] = [];
  readonly parts: (Float32Array | Uint32Array)[] = [];
  size = 0;
  private readonly known = new Map<string, number>();
  private readonly numbers = new Map<Shape, number>();

  private accessor(part: Float32Array | Uint32Array, target: number, rest: Omit<Accessor, 'bufferView'>): number {
    this.views.push({ buffer: 0, byteOffset: this.size, byteLength: part.byteLength, target });
    this.parts.push(part);
    this.size += part.byteLength;
    return this.accessors.push({ bufferView: this.views.length - 1, ...rest }) - 1;
  }

  private primitive({ position, index }: Shape): object {
    const min = [Infinity, Infinity, Infinity];
    const max = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < position.length; i++) {
      const x = position[i]!;
      if (!Number.isFinite(x)) throw new Refused(`vertex ${Math.floor(i / 3) + 1} has a coordinate that is no number`);
      if (x < min[i % 3]!) min[i % 3] = x;
      if (x > max[i % 3]!) max[i % 3] = x;
    }
    const count = position.length / 3;
    for (let i = 0; i < (index?.length ?? 0); i++)
      if (index![i]! >= count) throw new Refused(`a triangle names vertex ${index![i]! + 1} of ${count}`);
    const POSITION = this.accessor(position, 34962, { componentType: FLOAT, count, type: 'VEC3', min, max });
    if (!index) return { attributes: { POSITION }, mode: POINTS };
    const indices = this.accessor(index, 34963, { componentType: UINT, count: index.length, type: 'SCALAR' });
    return { attributes: { POSITION }, indices, mode: TRIANGLES };
  }

  /** Shapes that are the same object are written once. */
  private mesh(shapes: readonly Shape[]): number {
    const key = shapes.map((shape) => {
      if (!this.numbers.has(shape)) this.numbers.set(shape, this.numbers.size);
      return this.numbers.get(shape);
    });
    const known = this.known.get(key.join());
    if (known !== undefined) return known;
    const made = this.meshes.push({ primitives: shapes.map((shape) => this.primitive(shape)) }) - 1;
    this.known.set(key.join(), made);
    return made;
  }

  node({ name, matrix, shapes, children, extras }: Node): number {
    const full = (shapes ?? []).filter(({ position, index }) => position.length > 0 && index?.length !== 0);
    const below = (children ?? []).map((child) => this.node(child));
    return (
      this.nodes.push({
        name,
        ...(matrix && { matrix }),
        ...(full.length > 0 && { mesh: this.mesh(full) }),
        ...(below.length > 0 && { children: below }),
        ...(extras && { extras }),
      }) - 1
    );
  }
}

/** The file; `root`'s coordinates are metres with y up, as glTF requires. */
export function glbOf(root: Node): Uint8Array<ArrayBuffer> {
  counted([root]);
  const writer = new Writer();
  const scene = writer.node(root);
  const json = new TextEncoder().encode(
    JSON.stringify({
      asset: { version: '2.0', generator: 'hawser' },
      scene: 0,
      scenes: [{ nodes: [scene] }],
      nodes: writer.nodes,
      meshes: writer.meshes,
      accessors: writer.accessors,
      bufferViews: writer.views,
      buffers: [{ byteLength: writer.size }],
    }),
  );
  const text = 4 * Math.ceil(json.length / 4);
  const size = 12 + 8 + text + 8 + writer.size;
  if (size > 0xffffffff) throw new Refused('it is larger than 4 GB as GLB');
  const file = new Uint8Array(size);
  const heads = new DataView(file.buffer);
  const words = [0x46546c67, 2, size, text, 0x4e4f534a];
  words.forEach((word, k) => heads.setUint32(4 * k, word, true));
  file.fill(0x20, 20 + json.length, 20 + text);
  file.set(json, 20);
  heads.setUint32(20 + text, writer.size, true);
  heads.setUint32(24 + text, 0x004e4942, true);
  let at = 28 + text;
  for (const part of writer.parts) {
    file.set(new Uint8Array(part.buffer, part.byteOffset, part.byteLength), at);
    at += part.byteLength;
  }
  return file;
}
