// IFC by web-ifc: each product as a node below a node of its class's name, with its number, type and properties.
import WebIfc, { type IfcModule, type Line } from 'web-ifc-module';
import wasm from 'web-ifc-wasm';
import { type Model, type Node, Refused, type Shape } from './model';

const SCHEMAS = /^IFC(2X3|4|4X3)/i;
const SETTINGS = {
  ALLOW_INCOMPATIBLE_SCHEMA_ALIASES: true,
  COORDINATE_TO_ORIGIN: false,
  CIRCLE_SEGMENTS: 32,
  TAPE_SIZE: 1 << 26,
  MEMORY_LIMIT: 2 ** 31,
  LINEWRITER_BUFFER: 10000,
  TOLERANCE_PLANE_INTERSECTION: 1e-4,
  TOLERANCE_PLANE_DEVIATION: 1e-4,
  TOLERANCE_BACK_DEVIATION_DISTANCE: 1e-4,
  TOLERANCE_INSIDE_OUTSIDE_PERIMETER: 1e-10,
  TOLERANCE_SCALAR_EQUALITY: 1e-4,
  PLANE_REFIT_ITERATIONS: 1,
  BOOLEAN_UNION_THRESHOLD: 150,
};
const SILENT = 6;
const MEASURES = [
  'LENGTH',
  'AREA',
  'VOLUME',
  'PLANEANGLE',
  'MASS',
  'TIME',
  'THERMODYNAMICTEMPERATURE',
  'FORCE',
  'PRESSURE',
  'POWER',
];
const FLOATS_A_VERTEX = 6; // place and normal

/** An argument of a line: a text, a number, a reference, a list, or one of those with the name of its type. */
interface Typed {
  type: number;
  value?: unknown;
  typecode?: number;
}
const REFERENCE = 5;

const isTyped = (x: unknown): x is Typed => typeof x === 'object' && x !== null && 'type' in x;
const valueOf = (x: unknown): unknown => (isTyped(x) ? valueOf(x.value) : Array.isArray(x) ? x.map(valueOf) : x);
const textOf = (x: unknown): string => {
  const value = valueOf(x);
  return typeof value === 'string' ? value : '';
};
const referenceOf = (x: unknown): number | null =>
  isTyped(x) && x.type === REFERENCE && typeof x.value === 'number' ? x.value : null;
const referencesOf = (x: unknown): number[] =>
  (Array.isArray(x) ? x : [x]).map(referenceOf).filter((id): id is number => id !== null);

class Reader {
  readonly notes: string[] = [];
  private readonly shapes = new Map<number, Shape>();

  constructor(
    private readonly ifc: IfcModule,
    private readonly model: number,
  ) {}

  private line(id: number): Line | null {
    const { ifc, model } = this;
    const line = ifc.GetLines(model, [id])[0];
    return line?.arguments ? line : null; // a broken line has none
  }

  private nameOf(type: number): string {
    return this.ifc.GetNameFromTypeCode(type);
  }

  private withType(name: string): number[] {
    const { ifc, model } = this;
    const found = ifc.GetLineIDsWithType(model, [ifc.GetTypeCodeFromName(name.toUpperCase())]);
    return Array.from({ length: found.size() }, (_, i) => found.get(i));
  }

  private shape(id: number): Shape {
    const found = this.shapes.get(id);
    if (found) return found;
    const { ifc, model } = this;
    const geometry = ifc.GetGeometry(model, id);
    const from = geometry.GetVertexData() / 4;
    const vertices = ifc.HEAPF32.subarray(from, from + geometry.GetVertexDataSize());
    const first = geometry.GetIndexData() / 4;
    const index = ifc.HEAPU32.slice(first, first + geometry.GetIndexDataSize());
    const count = vertices.length / FLOATS_A_VERTEX;
    const position = Float32Array.from(
      { length: 3 * count },
      (_, i) => vertices[FLOATS_A_VERTEX * Math.floor(i / 3) + (i % 3)]!,
    );
    geometry.delete();
    const shape = { position, index };
    this.shapes.set(id, shape);
    return shape;
  }

  /** Units of the project by the kind of quantity, as the file names them. */
  private units(): Map<string, string> {
    const units = new Map<string, string>();
    for (const id of this.withType('IfcUnitAssignment'))
      for (const unit of referencesOf(this.line(id)?.arguments[0])) {
        const said = this.unitName(unit);
        if (said) units.set(said.kind, said.name);
      }
    return units;
  }

  private unitName(id: number): { kind: string; name: string } | null {
    const line = this.line(id);
    if (!line) return null;
    const words = line.arguments.map(textOf);
    const type = this.nameOf(line.type).toUpperCase();
    if (type === 'IFCSIUNIT')
      return { kind: words[0] ?? '', name: words.slice(1, 3).filter(Boolean).join(' ').toLowerCase() };
    if (type.startsWith('IFCCONVERSIONBASEDUNIT')) return { kind: words[1] ?? '', name: words[2] ?? '' };
    return null;
  }

  /** The value of a property, of the type that stands before it in the file, and the kind of its unit. */
  private measured(given: unknown): { value: unknown; kind: string } {
    const value = valueOf(given);
    const code = isTyped(given) ? given.typecode : undefined;
    const is = (...names: string[]): boolean =>
      names.some((name) => this.ifc.GetTypeCodeFromName(`IFC${name}`) === code);
    if (code === undefined || is('LABEL', 'TEXT', 'IDENTIFIER')) return { value, kind: '' };
    if (is('BOOLEAN', 'LOGICAL')) return { value: value === 'T' ? true : value === 'F' ? false : null, kind: '' };
    const kind = MEASURES.find((one) => ['', 'POSITIVE', 'NONNEGATIVE'].some((sign) => is(`${sign}${one}MEASURE`)));
    const number = Number(value);
    return { value: Number.isFinite(number) ? number : value, kind: kind ? `${kind}UNIT` : '' };
  }

  /** Property sets by the product that has them: set -> property -> its value, with a unit where there is one. */
  properties(): Map<number, Record<string, Record<string, unknown>>> {
    const units = this.units();
    const sets = new Map<number, [string, Record<string, unknown>] | null>();
    const found = new Map<number, Record<string, Record<string, unknown>>>();
    for (const relation of this.withType('IfcRelDefinesByProperties')) {
      const line = this.line(relation);
      for (const id of referencesOf(line?.arguments[5])) {
        if (!sets.has(id)) sets.set(id, this.set(id, units));
        const set = sets.get(id);
        if (!set) continue;
        for (const product of referencesOf(line?.arguments[4])) {
          const of = found.get(product) ?? {};
          of[set[0]] = set[1];
          found.set(product, of);
        }
      }
    }
    return found;
  }

  private set(id: number, units: Map<string, string>): [string, Record<string, unknown>] | null {
    const line = this.line(id);
    if (!line || this.nameOf(line.type).toUpperCase() !== 'IFCPROPERTYSET') return null;
    const set: Record<string, unknown> = {};
    for (const property of referencesOf(line.arguments[4])) {
      const one = this.line(property);
      if (!one || this.nameOf(one.type).toUpperCase() !== 'IFCPROPERTYSINGLEVALUE') continue;
      const { value, kind } = this.measured(one.arguments[2]);
      const own = referenceOf(one.arguments[3]);
      const unit = own ? this.unitName(own)?.name : units.get(kind);
      set[textOf(one.arguments[0])] = unit ? { value, unit } : value;
    }
    return [textOf(line.arguments[2]), set];
  }

  /** Where the model says it lies, which is kept and not applied. */
  private place(): Record<string, unknown> | null {
    const [id] = this.withType('IfcMapConversion');
    const values = id ? this.line(id)?.arguments.slice(2).map(valueOf) : undefined;
    if (!values) return null;
    this.notes.push('its IfcMapConversion is kept in the extras of the scene and is not applied');
    const keys = ['eastings', 'northings', 'height', 'x_axis_abscissa', 'x_axis_ordinate', 'scale'];
    return Object.fromEntries(keys.map((key, i) => [key, values[i] ?? null]));
  }

  read(): Model {
    const { ifc, model, notes } = this;
    const properties = this.properties();
    const nodes: Node[] = [];
    const made = new Set<number>();
    ifc.StreamAllMeshes(
      model,
      (mesh) => {
        const line = this.line(mesh.expressID);
        const type = line ? this.nameOf(line.type) : 'IfcProduct';
        const placed: Node[] = [];
        for (let i = 0; i < mesh.geometries.size(); i++) {
          const { geometryExpressID, flatTransformation } = mesh.geometries.get(i);
          const shape = this.shape(geometryExpressID);
          if (shape.index?.length) placed.push({ name: '', matrix: [...flatTransformation], shapes: [shape] });
        }
        if (placed.length === 0) return;
        made.add(mesh.expressID);
        const [guid, , name, , objectType] = (line?.arguments ?? []).map(textOf);
        const sets = properties.get(mesh.expressID);
        const product: Node = {
          name: name || `${type} ${mesh.expressID}`,
          extras: {
            id: mesh.expressID,
            guid,
            type,
            ...(objectType && { objectType }),
            ...(sets && { properties: sets }),
          },
        };
        // a product of one shape is that shape's node; the class stands above each, so that a pattern can name it
        if (placed.length === 1) Object.assign(product, placed[0], { name: product.name });
        else product.children = placed.map((part) => ({ ...part, name: product.name }));
        nodes.push({ name: type, children: [product] });
      },
      true,
    );
    this.missing(made);
    const place = this.place();
    return { nodes, unit: 1, up: 'y', notes, ...(place && { extras: { mapConversion: place } }) };
  }

  /** Says which products have a shape in the file that could not be made, by their classes. */
  private missing(made: Set<number>): void {
    const { ifc, model, notes } = this;
    const shapes = new Set([
      ...this.withType('IfcProductDefinitionShape'),
      ...this.withType('IfcProductRepresentation'),
    ]);
    const lines = ifc.GetAllLines(model);
    const types = new Map<number, number[]>();
    for (let i = 0; i < lines.size(); i++) {
      const id = lines.get(i);
      const type = ifc.GetLineType(model, id);
      types.set(type, [...(types.get(type) ?? []), id]);
    }
    const lost: string[] = [];
    for (const [type, ids] of types) {
      // all lines of a type are products, or none is: the first that has a shape tells
      const some = ids.filter((id) => !made.has(id) && shapes.has(referenceOf(this.line(id)?.arguments[6]) ?? -1));
      if (some.length > 0) lost.push(`${some.length} ${this.nameOf(type)}`);
    }
    if (lost.length > 0)
      notes.push(
        `left out, openings and spaces on purpose and others for shapes that web-ifc does not make: ${lost.sort().join(', ')}`,
      );
  }
}

export async function readIfc(bytes: Uint8Array): Promise<Model> {
  const head = new TextDecoder('latin1').decode(bytes.subarray(0, 1 << 16));
  const schema = /FILE_SCHEMA\s*\(\s*\(\s*'([^']*)'/.exec(head)?.[1];
  if (!head.startsWith('ISO-10303-21') || !schema) throw new Refused('it is no IFC: its head does not name a schema');
  if (!SCHEMAS.test(schema))
    throw new Refused(`its schema is '${schema.slice(0, 40)}'; IFC2X3, IFC4 and IFC4X3 are read`);
  const ifc = await WebIfc({ noInitialRun: true, wasmBinary: await wasm(), print: () => {}, printErr: () => {} });
  ifc.SetLogLevel(SILENT);
  const model = ifc.OpenModel(SETTINGS, (to, from, size) => {
    const part = bytes.subarray(from, from + Math.max(0, Math.min(bytes.length - from, size)));
    ifc.HEAPU8.set(part, to);
    return part.length;
  });
  if (model < 0) throw new Refused('it cannot be read as IFC');
  try {
    return new Reader(ifc, model).read();
  } catch (error) {
    if (error instanceof Refused) throw error;
    throw new Refused('web-ifc fails on it: the file is damaged or has what web-ifc does not know');
  }
}
