// The converter: a model of any kind becomes GLB. The desk has it in a worker, the program in a child process of node.
import { glbOf } from './glb';
import { readIfc } from './ifc';
import { BYTES_MOST, counted, type Model, type Node, Refused, textOf } from './model';
import { readObj, readPly, readXyz } from './plain';
import { checkRounding, readScene } from './scenes';

export { Refused };

export const UNITS: Record<string, number> = { m: 1, cm: 0.01, mm: 0.001, in: 0.0254, ft: 0.3048 };

/** What the owner says where the file does not; null: nothing. */
export interface Options {
  unit: string | null;
  up: string | null;
}

export interface Converted {
  glb: Uint8Array<ArrayBuffer>;
  triangles: number;
  points: number;
  nodes: number;
  notes: string[];
}

export const KINDS = ['ifc', 'obj', 'ply', 'dae', 'fbx', '3ds', '3mf', 'xyz'] as const;
const WARNINGS_MOST = 5;
/** What is no loss: pictures on surfaces, movements, and that the axes are turned. */
const OF_LOOKS = /texture|\bmap\b|TGA|sampler|material|skinning|Z-UP|animation/i;
type Kind = (typeof KINDS)[number];

const holds = ({ shapes, children }: Node): boolean => !!shapes?.length || !!children?.some(holds);

const kindOf = (name: string): Kind => {
  const end = name.slice(name.lastIndexOf('.') + 1).toLowerCase();
  const kind = KINDS.find((one) => one === end);
  if (kind) return kind;
  if (['glb', 'gltf', 'stl', 'dxf'].includes(end))
    throw new Refused(`.${end} is read by a case as it is and needs no conversion`);
  if (end === 'step' || end === 'stp')
    throw new Refused('STEP is not read; write it as IFC, STL or glTF with the program that drew it, or with FreeCAD');
  throw new Refused(`the kind '.${end.slice(0, 20)}' is not known; known are ${KINDS.join(', ')}`);
};

async function read(kind: Kind, bytes: Uint8Array): Promise<Model> {
  if (kind === 'ifc') return readIfc(bytes);
  if (kind === 'obj') return readObj(textOf(bytes));
  if (kind === 'xyz') return readXyz(textOf(bytes));
  if (kind === 'ply') return readPly(bytes);
  return readScene(kind, bytes);
}

/** Runs a reader, and takes what it warns of, once each, into the notes or the refusal: loaders leave out what they do not know. */
async function overheard(work: () => Promise<Model>): Promise<Model> {
  const heard = new Set<string>();
  const { warn, error } = console;
  console.warn = console.error = (...words: unknown[]) => {
    const text = words
      .map(String)
      .join(' ')
      .replace(/^THREE\./, '')
      .slice(0, 200);
    if (!OF_LOOKS.test(text) && heard.size < WARNINGS_MOST) heard.add(text);
  };
  try {
    const model = await work();
    const notes = [...model.notes, ...[...heard].map((said) => `the loader says: ${said}`)];
    if (!model.nodes.some(holds)) throw new Refused(['it holds no surface and no points', ...notes].join('; '));
    return { ...model, notes };
  } finally {
    Object.assign(console, { warn, error });
  }
}

/** Throws Refused with what is wrong; anything else that is thrown is a fault of the converter. */
export async function convert(name: string, bytes: Uint8Array, { unit, up }: Options): Promise<Converted> {
  const kind = kindOf(name);
  if (bytes.length > BYTES_MOST) throw new Refused(`it has ${bytes.length} bytes; at most ${BYTES_MOST} are read`);
  if (unit !== null && !(unit in UNITS)) throw new Refused(`unit '${unit}': one of ${Object.keys(UNITS).join(', ')}`);
  if (up !== null && up !== 'y' && up !== 'z') throw new Refused(`up '${up}': y or z`);
  const model = await overheard(() => read(kind, bytes));
  const metres = model.unit ?? (unit === null ? null : UNITS[unit]!);
  const axis = model.up ?? up;
  const asked = [
    metres === null && 'its unit (--unit m, cm, mm, in or ft)',
    axis === null && 'the axis that points up (--up y or z)',
  ];
  if (asked.some(Boolean)) throw new Refused(`the file does not say ${asked.filter(Boolean).join(' and ')}`);
  const { notes } = model;
  if (unit !== null && model.unit !== null && Math.abs(UNITS[unit]! / model.unit - 1) > 1e-9)
    notes.push(`the file says that its unit is ${model.unit} m; '${unit}' is not used`);
  if (up !== null && model.up !== null && up !== model.up && kind !== 'dae' && kind !== 'fbx' && kind !== 'ifc')
    notes.push(`the file's kind has ${model.up} up; '${up}' is not used`);
  if (kind !== 'ifc') checkRounding(model.nodes, metres!);
  const u = metres!;
  const matrix =
    axis === 'y' ? [u, 0, 0, 0, 0, u, 0, 0, 0, 0, u, 0, 0, 0, 0, 1] : [u, 0, 0, 0, 0, 0, -u, 0, 0, u, 0, 0, 0, 0, 0, 1];
  const root = { name: '', matrix, children: model.nodes, extras: { kind, ...model.extras } };
  return { glb: glbOf(root), ...counted([root]), notes };
}
