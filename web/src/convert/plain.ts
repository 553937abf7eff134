// Kinds that are rows of numbers: OBJ, PLY, XYZ. They are read in double precision, since surveyed coordinates do not fit into single.
import { ShapeUtils, Vector2 } from 'three';
import { type Model, type Node, Refused, shapeAbout } from './model';

/** The triangles of a polygon's corners: of a convex or concave one, by the ears of its projection. */
function cornersOf(polygon: readonly number[], position: ArrayLike<number>, into: number[]): void {
  if (polygon.length < 3) return;
  if (polygon.length === 3) return void into.push(...polygon);
  const normal = [0, 0, 0];
  const at = (i: number, axis: number): number => position[3 * polygon[i % polygon.length]! + axis]!;
  for (let i = 0; i < polygon.length; i++)
    for (let k = 0; k < 3; k++) {
      const [a, b] = [(k + 1) % 3, (k + 2) % 3] as const;
      normal[k]! += (at(i, a) - at(i + 1, a)) * (at(i, b) + at(i + 1, b) - 2 * at(0, b));
    }
  const size = normal.map(Math.abs);
  const across = size.indexOf(Math.max(...size));
  const [a, b] = [(across + 1) % 3, (across + 2) % 3] as const;
  const flip = normal[across]! < 0;
  const contour = polygon.map((_, i) => new Vector2(at(i, a) - at(0, a), (flip ? -1 : 1) * (at(i, b) - at(0, b))));
  for (const [i, j, k] of ShapeUtils.triangulateShape(contour, [])) into.push(polygon[i!]!, polygon[j!]!, polygon[k!]!);
}

/** The lines of a text, one by one, without making an array of them. */
function* linesOf(text: string): Generator<[string, number]> {
  for (let from = 0, number = 1; from < text.length; number++) {
    const end = text.indexOf('\n', from);
    yield [text.slice(from, end < 0 ? undefined : end).trim(), number];
    if (end < 0) return;
    from = end + 1;
  }
}

/** Only the vertices that the triangles name, in the order in which they are named. */
function compact(name: string, index: number[], position: ArrayLike<number>): Node {
  const renumbered = new Map<number, number>();
  const own: number[] = [];
  const indices = Uint32Array.from(index, (vertex) => {
    let at = renumbered.get(vertex);
    if (at === undefined) {
      at = renumbered.size;
      renumbered.set(vertex, at);
      for (let k = 0; k < 3; k++) own.push(position[3 * vertex + k]!);
    }
    return at;
  });
  return { name, ...shapeAbout(own, indices) };
}

export function readObj(text: string): Model {
  const position: number[] = [];
  const groups = new Map<string, number[]>();
  let lines = 0;
  let object = '';
  let group = '';
  for (const [line, number] of linesOf(text.replaceAll('\\\n', ' '))) {
    const words = line.split(/\s+/);
    const kind = words.shift();
    if (kind === 'v') {
      for (let k = 0; k < 3; k++) {
        const x = Number(words[k] ?? NaN);
        if (!Number.isFinite(x))
          throw new Refused(`line ${number}: a vertex has three numbers: '${line.slice(0, 60)}'`);
        position.push(x);
      }
    } else if (kind === 'f') {
      const count = position.length / 3;
      const polygon = words.map((word) => {
        const given = parseInt(word, 10);
        const vertex = given < 0 ? count + given : given - 1;
        if (!(vertex >= 0 && vertex < count))
          throw new Refused(
            `line ${number}: vertex '${word.slice(0, 20)}' of a face is not among the ${count} before it`,
          );
        return vertex;
      });
      const name = object || group || 'OBJ';
      let of = groups.get(name);
      if (!of) groups.set(name, (of = []));
      cornersOf(polygon, position, of);
    } else if (kind === 'o') object = words.join(' ');
    else if (kind === 'g') group = words.join(' ');
    else if (kind === 'l' || kind === 'curv' || kind === 'surf') lines++;
  }
  const nodes = [...groups].map(([name, index]) => compact(name, index, position));
  if (nodes.length === 0 && position.length > 0) nodes.push({ name: 'points', ...shapeAbout(position, null) });
  const notes = lines > 0 ? [`${lines} lines, curves or free-form surfaces are left out`] : [];
  return { nodes, unit: null, up: null, notes };
}

export function readXyz(text: string): Model {
  const position: number[] = [];
  for (const [line, number] of linesOf(text)) {
    if (!line || line.startsWith('#') || line.startsWith('//')) continue;
    const words = line.split(/[\s,;]+/);
    const values = [0, 1, 2].map((k) => Number(words[k] || NaN));
    if (values.every(Number.isFinite)) position.push(...values);
    // the first line may be a head or the number of points
    else if (number > 1) throw new Refused(`line ${number}: not three numbers: '${line.slice(0, 60)}'`);
  }
  return { nodes: [{ name: 'points', ...shapeAbout(position, null) }], unit: null, up: null, notes: [] };
}

interface Property {
  name: string;
  type: string;
  /** Of a list: the type of its length. */
  length?: string;
}
interface Element {
  name: string;
  count: number;
  properties: Property[];
}

const SIZES: Record<
  string,
  [number, 'Int8' | 'Uint8' | 'Int16' | 'Uint16' | 'Int32' | 'Uint32' | 'Float32' | 'Float64']
> = {
  char: [1, 'Int8'],
  int8: [1, 'Int8'],
  uchar: [1, 'Uint8'],
  uint8: [1, 'Uint8'],
  short: [2, 'Int16'],
  int16: [2, 'Int16'],
  ushort: [2, 'Uint16'],
  uint16: [2, 'Uint16'],
  int: [4, 'Int32'],
  int32: [4, 'Int32'],
  uint: [4, 'Uint32'],
  uint32: [4, 'Uint32'],
  float: [4, 'Float32'],
  float32: [4, 'Float32'],
  double: [8, 'Float64'],
  float64: [8, 'Float64'],
};

function plyHead(bytes: Uint8Array): { format: string; elements: Element[]; data: number } {
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, 1 << 16));
  const end = /(^|\n)end_header\r?\n/.exec(head);
  if (!head.startsWith('ply') || !end)
    throw new Refused('it is no PLY: its head does not begin with ply and end with end_header');
  let format = '';
  const elements: Element[] = [];
  for (const [line] of linesOf(head.slice(0, end.index))) {
    const [kind, ...words] = line.split(/\s+/);
    if (kind === 'format') format = words[0] ?? '';
    if (kind === 'element') elements.push({ name: words[0] ?? '', count: Number(words[1]), properties: [] });
    if (kind !== 'property') continue;
    const list = words[0] === 'list';
    const type = words[list ? 2 : 0] ?? '';
    for (const known of list ? [type, words[1] ?? ''] : [type])
      if (!SIZES[known]) throw new Refused(`a property of type '${known.slice(0, 20)}' is not known`);
    const property = { name: words[list ? 3 : 1] ?? '', type, ...(list && { length: words[1] ?? '' }) };
    elements[elements.length - 1]?.properties.push(property);
  }
  for (const { name, count } of elements)
    if (!Number.isInteger(count) || count < 0 || count > bytes.length)
      throw new Refused(`it states ${count} of '${name.slice(0, 20)}' in ${bytes.length} bytes`);
  return { format, elements, data: end.index + end[0].length };
}

/** The next number of the file, of a type. */
function plyNumbers(bytes: Uint8Array, format: string, data: number): (type: string) => number {
  if (format === 'ascii') {
    const words = /\S+/g;
    const text = new TextDecoder('latin1').decode(bytes.subarray(data));
    return () => {
      const value = Number(words.exec(text)?.[0] ?? NaN);
      if (Number.isNaN(value)) throw new Refused('its numbers end too early, or one of them is none');
      return value;
    };
  }
  const little = format === 'binary_little_endian';
  if (!little && format !== 'binary_big_endian') throw new Refused(`the format '${format.slice(0, 30)}' is not known`);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = data;
  return (type) => {
    const [size, name] = SIZES[type]!;
    if (at + size > view.byteLength) throw new Refused('its numbers end too early');
    const value = view[`get${name}`](at, little);
    at += size;
    return value;
  };
}

export function readPly(bytes: Uint8Array): Model {
  const { format, elements, data } = plyHead(bytes);
  const next = plyNumbers(bytes, format, data);
  const position: number[] = [];
  const index: number[] = [];
  let left = 0;
  for (const { name, count, properties } of elements) {
    const axes = properties.map((property) => ['x', 'y', 'z'].indexOf(name === 'vertex' ? property.name : ''));
    if (name === 'vertex' && axes.filter((axis) => axis >= 0).length !== 3)
      throw new Refused('its vertices have no x, y and z');
    for (let i = 0; i < count; i++)
      for (const [k, { name: property, type, length }] of properties.entries()) {
        const times = length ? next(length) : 1;
        if (!(times >= 0 && times < 1e6)) throw new Refused(`a list of ${times} numbers`);
        const values: number[] = [];
        for (let j = 0; j < times; j++) values.push(next(type));
        if (axes[k]! >= 0) position[3 * i + axes[k]!] = values[0]!;
        if (name !== 'face' || !/^vertex_ind(ex|ices)$/.test(property)) continue;
        const wrong = values.find((vertex) => !(vertex >= 0 && vertex < position.length / 3));
        if (wrong !== undefined) throw new Refused(`face ${i + 1} names vertex ${wrong} of ${position.length / 3}`);
        cornersOf(values, position, index);
      }
    if (name !== 'vertex' && name !== 'face') left += count;
  }
  const notes = left > 0 ? [`${left} elements that are neither vertices nor faces are left out`] : [];
  const faces = elements.some(({ name, count }) => name === 'face' && count > 0);
  const part = shapeAbout(position, faces ? Uint32Array.from(index) : null);
  return { nodes: [{ name: faces ? 'PLY' : 'points', ...part }], unit: null, up: null, notes };
}
