// Kinds that three's loaders read: COLLADA, FBX, 3DS, 3MF. Shapes, names and places are taken; pictures, lights and movements are not.
import { DOMParser, Element as XmlElement, Document as XmlDocument, onErrorStopParsing } from '@xmldom/xmldom';
import { type BufferGeometry, type Object3D, Texture, TextureLoader } from 'three';
import { ThreeMFLoader } from 'three/examples/jsm/loaders/3MFLoader.js';
import { ColladaLoader } from 'three/examples/jsm/loaders/ColladaLoader.js';
import { FBXLoader } from 'three/examples/jsm/loaders/FBXLoader.js';
import { TDSLoader } from 'three/examples/jsm/loaders/TDSLoader.js';
import { TGALoader } from 'three/examples/jsm/loaders/TGALoader.js';
import { type Model, type Node, Refused, type Shape, textOf } from './model';

const ROUNDING_MOST = 1e-3; // m

/** What the root model of the last 3MF says, which its loader does not apply. */
let unitOf3mf: string | null = null;

/** What the loaders take from a browser, and a worker and node do not have. */
function furnish(): void {
  const has = globalThis as { window?: object; DOMParser?: unknown };
  has.window ??= { innerWidth: 1, innerHeight: 1, URL };
  // The parser of XML is the same everywhere; a damaged file is refused, not repaired.
  has.DOMParser = class {
    parseFromString(text: string, type: string): unknown {
      const tree = new DOMParser({ onError: onErrorStopParsing }).parseFromString(text, type);
      if (tree.documentElement?.nodeName === 'model') unitOf3mf = tree.documentElement.getAttribute('unit');
      return tree;
    }
  };
  type Tree = XmlElement | XmlDocument;
  /** Elements below, by names with spaces between, or by an attribute; all that the loaders ask for. */
  const find = (below: Tree, selector: string): XmlElement[] => {
    const attribute = /^\[(\w+)="(.*)"\]$/s.exec(selector);
    if (attribute)
      return [...below.getElementsByTagName('*')].filter((e) => e.getAttribute(attribute[1]!) === attribute[2]);
    const found = selector
      .split(' ')
      .reduce<Tree[]>((all, name) => all.flatMap((e) => [...e.getElementsByTagName(name)]), [below]);
    return found as XmlElement[];
  };
  for (const { prototype } of [XmlElement, XmlDocument])
    Object.assign(prototype, {
      querySelectorAll(this: Tree, selector: string) {
        return find(this, selector);
      },
      querySelector(this: Tree, selector: string) {
        return find(this, selector)[0] ?? null;
      },
    });
  TextureLoader.prototype.load = TGALoader.prototype.load = (() => new Texture()) as never;
}

/** A copy of its own, since loaders read a buffer from its start. */
const own = (bytes: Uint8Array): ArrayBuffer => new Uint8Array(bytes).buffer;

function shapeOf(geometry: BufferGeometry, points: boolean, known: Map<BufferGeometry, Shape>): Shape | null {
  const found = known.get(geometry);
  if (found) return found;
  if (!geometry.hasAttribute('position')) return null;
  const from = geometry.getAttribute('position');
  if (from.count === 0) return null;
  const position = Float32Array.from({ length: 3 * from.count }, (_, i) => from.getComponent(Math.floor(i / 3), i % 3));
  let index: Uint32Array | null = null;
  if (!points) {
    const given = geometry.getIndex();
    index = given ? Uint32Array.from(given.array) : Uint32Array.from({ length: from.count }, (_, i) => i);
    if (index.length % 3) throw new Refused('the corners of its triangles are not a multiple of three');
  }
  const shape = { position, index };
  known.set(geometry, shape);
  return shape;
}

interface Drawn extends Object3D {
  isMesh?: boolean;
  isPoints?: boolean;
  isLine?: boolean;
  isSkinnedMesh?: boolean;
  geometry?: BufferGeometry;
}

/** The tree of nodes; what is neither a surface nor points is counted. */
function nodesOf(scene: Object3D): { node: Node; lines: number; skins: number } {
  const known = new Map<BufferGeometry, Shape>();
  let lines = 0;
  let skins = 0;
  const go = (object: Drawn): Node => {
    object.updateMatrix();
    const { geometry, isMesh = false, isPoints = false } = object;
    if (object.isLine) lines++;
    if (object.isSkinnedMesh) skins++;
    const shape = geometry && (isMesh || isPoints) ? shapeOf(geometry, isPoints, known) : null;
    const { originalName } = object.userData as { originalName?: unknown };
    return {
      name: typeof originalName === 'string' && originalName ? originalName : object.name,
      matrix: object.matrix.toArray(),
      ...(shape && { shapes: [shape] }),
      children: object.children.map(go).filter(({ shapes, children }) => shapes || children?.length),
    };
  };
  return { node: go(scene), lines, skins };
}

/** Refuses coordinates that single precision rounds by more than a millimetre; `unit`: m. */
export function checkRounding(nodes: readonly Node[], unit: number): void {
  for (const { name, shapes, children } of nodes) {
    for (const { position } of shapes ?? []) {
      const far = position.reduce((most, x) => Math.max(most, Math.abs(x)), 0) * unit;
      if (far * 2 ** -24 > ROUNDING_MOST)
        throw new Refused(
          `'${name}' is ${Math.round(far / 1000)} km from the origin, where the single precision of this kind rounds by ${(far * 2 ** -24 * 1e3).toPrecision(2)} mm: move it nearer before it is exported`,
        );
    }
    checkRounding(children ?? [], unit);
  }
}

const CONTAINERS_3DS = [0x4d4d, 0x3d3d, 0x4000, 0x4100, 0x4120, 0xafff, 0xb000];

/** Refuses chunks that do not fit into each other, on which the loader would go round for ever. */
function checkChunks(view: DataView, from: number, to: number): void {
  for (let at = from; at + 6 <= to;) {
    const id = view.getUint16(at, true);
    const size = view.getUint32(at + 2, true);
    if (size < 6 || at + size > to)
      throw new Refused(`the chunk 0x${id.toString(16)} at byte ${at} has a wrong size, ${size}`);
    let inner = at + 6;
    if (id === 0x4000) while (inner < at + size && view.getUint8(inner++) !== 0); // its name
    if (id === 0x4120) inner += 2 + 8 * (inner + 2 <= at + size ? view.getUint16(inner, true) : 0); // its triangles
    if (CONTAINERS_3DS.includes(id)) checkChunks(view, inner, at + size);
    at += size;
  }
}

const UNITS_3MF: Record<string, number> = {
  micron: 1e-6,
  millimeter: 1e-3,
  centimeter: 1e-2,
  inch: 0.0254,
  foot: 0.3048,
  meter: 1,
};

/** Runs a loader; its own failure is a fault of the file. */
function loaded<T>(load: () => T): T {
  try {
    return load();
  } catch (error) {
    if (error instanceof Refused || error instanceof RangeError) throw error;
    throw new Refused(`it cannot be read: ${error instanceof Error ? error.message.slice(0, 200) : String(error)}`);
  }
}

export function readScene(kind: 'dae' | 'fbx' | '3ds' | '3mf', bytes: Uint8Array): Model {
  furnish();
  const notes: string[] = [];
  let unit: number | null = null;
  let up: 'y' | 'z' | null = null;
  let scene: Object3D;
  if (kind === 'dae') {
    const text = textOf(bytes);
    const parsed = loaded(() => new ColladaLoader().parse(text, ''));
    if (!parsed) throw new Refused('it cannot be read as COLLADA');
    scene = parsed.scene;
    // the loader has turned and scaled it; the standard has metres and y up where the file says nothing
    [unit, up] = [1, 'y'];
    if (
      [...text.matchAll(/<vcount>([^<]*)</g)].some(([, counts]) => /\b([5-9]|\d\d+)\b/.test(counts!)) ||
      /<polygons\b/.test(text)
    )
      notes.push('polygons of more than four corners are cut into fans, which is right for convex ones only');
  } else if (kind === 'fbx') {
    scene = loaded(() => new FBXLoader().parse(own(bytes), ''));
    const said = { ...scene.parent?.userData, ...scene.userData } as { unitScaleFactor?: number };
    const { unitScaleFactor } = said;
    unit = typeof unitScaleFactor === 'number' ? 0.01 * unitScaleFactor : null;
    up = 'y'; // the loader has turned it
  } else if (kind === '3mf') {
    scene = loaded(() => new ThreeMFLoader().parse(own(bytes)));
    unit = UNITS_3MF[unitOf3mf ?? 'millimeter'] ?? null;
    up = 'z';
  } else {
    checkChunks(new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength), 0, bytes.length);
    scene = loaded(() => new TDSLoader().parse(own(bytes), ''));
  }
  const { node, lines, skins } = nodesOf(scene);
  if (lines > 0) notes.push(`${lines} lines are left out`);
  if (skins > 0) notes.push(`${skins} skinned meshes are taken as they stand at rest`);
  return { nodes: [node], unit, up, notes };
}
