/** Changes of a case's text that leave everything else as it is: the parser only finds the place, and the text is cut there. */
import { isMap, isScalar, isSeq, parseDocument, type Document, type Node } from 'yaml';

export type Path = (string | number)[];

export interface Change {
  from: number;
  to: number;
  insert: string;
}

let last: { text: string; document: Document } | undefined;

/** The document of a text; of the newest one it is kept, so nobody may change it. */
export function parsed(text: string): Document {
  if (last?.text !== text) last = { text, document: parseDocument(text, { keepSourceTokens: true, strict: false }) };
  return last.document;
}

/** "surfaces.ducts.0.friction.mu" as a path; numbers are places in a list. */
export function pathOf(key: string): Path {
  return key.split('.').map((part) => (/^\d+$/.test(part) ? Number(part) : part));
}

export function nodeAt(document: Document, path: Path): Node | undefined {
  return (document.getIn(path, true) as Node | null | undefined) ?? undefined;
}

/** A value as YAML writes it: in quotes where it could be taken for something else. */
export function written(value: string): string {
  const plain = /^(-?[\d.]|[A-Za-z+°(])[\w.+\-/ %°·²*^()]*$/.test(value) && value.trim() === value;
  return plain ? value : JSON.stringify(value);
}

type Data = Record<string | number, unknown>;

/** The change, if the text then reads as it did but for what `edit` does to its data; undefined: it would break something. */
function only(text: string, change: Change, edit: (data: Data) => void): Change | undefined {
  const before = parsed(text).toJS() as Data;
  const after = parsed(text.slice(0, change.from) + change.insert + text.slice(change.to));
  edit(before);
  return after.errors.length === 0 && JSON.stringify(after.toJS()) === JSON.stringify(before) ? change : undefined;
}

function dataAt(data: Data, path: Path): Data {
  return path.reduce<Data>((at, step) => at[step] as Data, data);
}

/** What a scalar is read as. */
const meant = (insert: string): unknown => parseDocument(insert).toJS() as unknown;

/** Where a node's text ends, without blanks and comments behind it. */
function endOf(text: string, node: Node): number {
  const begin = node.range?.[0] ?? 0;
  let end = text.slice(0, node.range?.[1] ?? 0).trimEnd().length;
  for (;;) {
    const line = text.lastIndexOf('\n', end - 1) + 1;
    if (line <= begin || !/^\s*#/.test(text.slice(line, end))) return end;
    end = text.slice(0, line).trimEnd().length;
  }
}

function lineEnd(text: string, at: number): number {
  const next = text.indexOf('\n', at);
  return next < 0 ? text.length : next;
}

/** Replaces a value that is there, or adds a key to the map above it; undefined: the text has neither, or it cannot be cut there.
 * raw: the value is YAML as it stands. */
export function setValue(text: string, path: Path, value: string, raw = false): Change | undefined {
  const document = parsed(text);
  const node = nodeAt(document, path);
  const insert = raw ? value : written(value);
  const key = path[path.length - 1];
  if (key === undefined) return undefined;
  const set = (data: Data): void => void (dataAt(data, path.slice(0, -1))[key] = meant(insert));
  if (node && isScalar(node) && node.range) {
    const [from, to] = node.range;
    return only(text, { from, to, insert: text[from - 1] === ':' ? ` ${insert}` : insert }, set);
  }
  if (node) return undefined;
  const above = path.length > 1 ? nodeAt(document, path.slice(0, -1)) : (document.contents ?? undefined);
  if (!above || !isMap(above) || !above.range || typeof key !== 'string') return undefined;
  const last = above.items[above.items.length - 1];
  if (above.flow) {
    const at = text.lastIndexOf('}', above.range[1] - 1);
    const end = text.slice(0, at).trimEnd().length;
    const comma = last && text[end - 1] !== ',' ? ', ' : last ? ' ' : '';
    return only(text, { from: end, to: at, insert: `${comma}${key}: ${insert}` }, set);
  }
  const first = above.items[0]?.key as Node | undefined;
  if (!first?.range) return undefined;
  const column = first.range[0] - (text.lastIndexOf('\n', first.range[0] - 1) + 1);
  const end = lineEnd(text, endOf(text, above));
  return only(text, { from: end, to: end, insert: `\n${' '.repeat(column)}${key}: ${insert}` }, set);
}

/** Writes a value at a path of keys, with the maps above it that are not there yet. */
export function addValue(text: string, path: Path, value: string): Change | undefined {
  let there = path.length - 1;
  while (there > 0 && !nodeAt(parsed(text), path.slice(0, there))) there--;
  const inner = path.slice(there + 1).reduceRight<string>((made, key) => `{${key}: ${made}}`, written(value));
  if (there > 0 || nodeAt(parsed(text), path.slice(0, 1))) return setValue(text, path.slice(0, there + 1), inner, true);
  return putSection(text, String(path[0]), `${path[0]}: ${inner}`);
}

/** Takes a key out of a map, with what separates it from the next; undefined: it is not there, or cannot be cut out. */
export function removeKey(text: string, path: Path): Change | undefined {
  const map = nodeAt(parsed(text), path.slice(0, -1));
  const key = path[path.length - 1];
  if (!map || !isMap(map) || key === undefined) return undefined;
  const i = map.items.findIndex((pair) => isScalar(pair.key) && pair.key.value === key);
  const own = map.items[i];
  const begin = (own?.key as Node | undefined)?.range?.[0];
  const end = ((own?.value ?? own?.key) as Node | undefined)?.range?.[1];
  if (begin === undefined || end === undefined) return undefined;
  const taken = (data: Data): void => {
    Reflect.deleteProperty(dataAt(data, path.slice(0, -1)), key);
  };
  if (!map.flow) {
    const line = text.lastIndexOf('\n', begin - 1) + 1;
    return only(text, { from: line, to: Math.min(lineEnd(text, end) + 1, text.length), insert: '' }, taken);
  }
  const after = map.items[i + 1]?.key as Node | undefined;
  const before = map.items[i - 1];
  if (after?.range) return only(text, { from: begin, to: after.range[0], insert: '' }, taken);
  const left = ((before?.value ?? before?.key) as Node | undefined)?.range?.[1];
  return only(text, { from: left ?? begin, to: end, insert: '' }, taken);
}

/** Adds an item, one line of flow, behind the item `after` of a list; undefined: there is no such list. */
export function addItem(text: string, path: Path, after: number, item: string): Change | undefined {
  const list = nodeAt(parsed(text), path);
  if (!list || !isSeq(list)) return undefined;
  const at = (list.items as Node[])[after];
  if (!at?.range) return undefined;
  const added = (data: Data): void =>
    void (dataAt(data, path) as unknown as unknown[]).splice(after + 1, 0, meant(item));
  if (list.flow) return only(text, { from: at.range[1], to: at.range[1], insert: `, ${item}` }, added);
  const line = text.lastIndexOf('\n', at.range[0] - 1) + 1;
  const column = /^( *)-/.exec(text.slice(line))?.[1];
  const end = lineEnd(text, endOf(text, at));
  return column === undefined ? undefined : only(text, { from: end, to: end, insert: `\n${column}- ${item}` }, added);
}

/** Adds an item, one line of flow, at the end of a list, which is made if there is none; what stands alone where a list may
 * stand becomes its first item. */
export function appendItem(text: string, path: Path, item: string): Change | undefined {
  const node = nodeAt(parsed(text), path);
  if (isSeq(node) && node.items.length > 0) return addItem(text, path, node.items.length - 1, item);
  if (isMap(node) && node.flow && node.range) {
    const [from, to] = node.range;
    const listed = (data: Data): void => {
      const above = dataAt(data, path.slice(0, -1));
      const key = path[path.length - 1] ?? '';
      above[key] = [above[key], meant(item)];
    };
    return only(text, { from, to, insert: `[${text.slice(from, to)}, ${item}]` }, listed);
  }
  if (node) return undefined;
  const [section, key] = path.map(String);
  if (path.length > 1 && nodeAt(parsed(text), path.slice(0, -1))) return setValue(text, path, `[${item}]`, true);
  if (path.length === 1) return putSection(text, section ?? '', `${section}:\n  - ${item}`);
  return path.length === 2 ? putSection(text, section ?? '', `${section}:\n  ${key}:\n    - ${item}`) : undefined;
}

/** Takes an item out of a list, comments around it stay; the last one stays. */
export function removeItem(text: string, path: Path, i: number): Change | undefined {
  const list = nodeAt(parsed(text), path);
  if (!list || !isSeq(list)) return undefined;
  const items = list.items as Node[];
  const own = items[i];
  const next = items[i + 1];
  if (items.length < 2 || !own?.range) return undefined;
  const taken = (data: Data): void => void (dataAt(data, path) as unknown as unknown[]).splice(i, 1);
  if (list.flow) {
    const before = items[i - 1];
    const [from, to] = next?.range ? [own.range[0], next.range[0]] : [before?.range?.[1] ?? own.range[0], own.range[1]];
    return only(text, { from, to, insert: '' }, taken);
  }
  const line = text.lastIndexOf('\n', own.range[0] - 1) + 1;
  return only(text, { from: line, to: Math.min(lineEnd(text, endOf(text, own)) + 1, text.length), insert: '' }, taken);
}

/** Texts of the case that may be names of files: they are paths from where the case is. */
export function filesOf(text: string): string[] {
  let data: Data | null;
  try {
    data = parsed(text).toJS() as Data | null;
  } catch {
    return []; // it is no YAML yet
  }
  const texts = (value: unknown): string[] =>
    typeof value === 'string' ? [value] : value && typeof value === 'object' ? Object.values(value).flatMap(texts) : [];
  return [data?.['route'], data?.['drawing'], data?.['include'], data?.['environment']].flatMap(texts);
}

/** Puts a section in place of the one that is there, or at the end; comments around it stay. */
export function putSection(text: string, key: string, section: string): Change {
  const top = parsed(text).contents;
  const pair = isMap(top) ? top.items.find((one) => isScalar(one.key) && one.key.value === key) : undefined;
  const from = (pair?.key as Node | undefined)?.range?.[0];
  if (from === undefined)
    return {
      from: text.length,
      to: text.length,
      insert: `${text === '' || text.endsWith('\n') ? '' : '\n'}${section}\n`,
    };
  return { from, to: pair?.value ? endOf(text, pair.value as Node) : lineEnd(text, from), insert: section };
}
