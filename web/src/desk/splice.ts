/** Changes of a case's text that leave everything else as it is: the parser only finds the place, and the text is cut there. */
import { isMap, isScalar, isSeq, parseDocument, type Document, type Node } from 'yaml';

export type Path = (string | number)[];

export interface Change {
  from: number;
  to: number;
  insert: string;
}

export function parsed(text: string): Document {
  return parseDocument(text, { keepSourceTokens: true, strict: false });
}

/** "surfaces.ducts.0.friction.mu" as a path; numbers are places in a list. */
export function pathOf(key: string): Path {
  return key.split('.').map((part) => (/^\d+$/.test(part) ? Number(part) : part));
}

export function nodeAt(document: Document, path: Path): Node | undefined {
  return (document.getIn(path, true) as Node | null | undefined) ?? undefined;
}

/** A value as YAML writes it in a flow or a block: in quotes where it could be taken for something else. */
export function written(value: string): string {
  return /^[\w.+\-/ %°·²*^()]+$/.test(value) && value.trim() === value && value ? value : JSON.stringify(value);
}

/** Replaces a value that is there, or adds a key to the map above it; undefined: the text has neither. */
export function setValue(text: string, path: Path, value: string): Change | undefined {
  const document = parsed(text);
  const node = nodeAt(document, path);
  const insert = written(value);
  if (node && isScalar(node) && node.range) return { from: node.range[0], to: node.range[1], insert };
  if (node) return undefined;
  const key = path[path.length - 1];
  const above = path.length > 1 ? nodeAt(document, path.slice(0, -1)) : (document.contents ?? undefined);
  if (!above || !isMap(above) || !above.range || typeof key !== 'string') return undefined;
  const last = above.items[above.items.length - 1];
  if (above.flow) {
    const at = text.lastIndexOf('}', above.range[1]);
    const end = text.slice(0, at).trimEnd().length;
    return { from: end, to: at, insert: `${last ? ', ' : ''}${key}: ${insert}` };
  }
  const first = above.items[0]?.key as Node | undefined;
  if (!first?.range) return undefined;
  const column = first.range[0] - (text.lastIndexOf('\n', first.range[0] - 1) + 1);
  const end = text.slice(0, above.range[1]).trimEnd().length;
  return { from: end, to: end, insert: `\n${' '.repeat(column)}${key}: ${insert}` };
}

/** Takes a key out of a map, with what separates it from the next; undefined: it is not there. */
export function removeKey(text: string, path: Path): Change | undefined {
  const map = nodeAt(parsed(text), path.slice(0, -1));
  if (!map || !isMap(map)) return undefined;
  const i = map.items.findIndex((pair) => isScalar(pair.key) && pair.key.value === path[path.length - 1]);
  const own = map.items[i];
  const begin = (own?.key as Node | undefined)?.range?.[0];
  const end = ((own?.value ?? own?.key) as Node | undefined)?.range?.[1];
  if (begin === undefined || end === undefined) return undefined;
  if (!map.flow) {
    const line = text.lastIndexOf('\n', begin - 1) + 1;
    const next = text.indexOf('\n', end - 1);
    return i === 0 ? undefined : { from: line, to: next < 0 ? text.length : next + 1, insert: '' };
  }
  const after = map.items[i + 1]?.key as Node | undefined;
  const before = map.items[i - 1];
  if (after?.range) return { from: begin, to: after.range[0], insert: '' };
  const left = ((before?.value ?? before?.key) as Node | undefined)?.range?.[1];
  return { from: left ?? begin, to: end, insert: '' };
}

/** Adds an item, one line of flow, behind the item `after` of a list (-1: at its end); undefined: there is no such list. */
export function addItem(text: string, path: Path, after: number, item: string): Change | undefined {
  const list = nodeAt(parsed(text), path);
  if (!list || !isSeq(list) || !list.range) return undefined;
  const items = list.items as Node[];
  const at = items[after < 0 ? items.length - 1 : after];
  if (!at?.range) return undefined;
  if (list.flow) return { from: at.range[1], to: at.range[1], insert: `, ${item}` };
  const dash = text.lastIndexOf('-', at.range[0]);
  const column = dash - (text.lastIndexOf('\n', dash) + 1);
  const end = text.slice(0, at.range[1]).trimEnd().length;
  return { from: end, to: end, insert: `\n${' '.repeat(column)}- ${item}` };
}

/** Takes an item out of a list; the last one stays. */
export function removeItem(text: string, path: Path, i: number): Change | undefined {
  const list = nodeAt(parsed(text), path);
  if (!list || !isSeq(list)) return undefined;
  const items = list.items as Node[];
  const own = items[i];
  const next = items[i + 1];
  if (items.length < 2 || !own?.range) return undefined;
  if (list.flow) {
    const before = items[i - 1];
    return next?.range
      ? { from: own.range[0], to: next.range[0], insert: '' }
      : { from: before?.range?.[1] ?? own.range[0], to: own.range[1], insert: '' };
  }
  const line = text.lastIndexOf('\n', text.lastIndexOf('-', own.range[0])) + 1;
  const behind = next?.range
    ? text.lastIndexOf('\n', text.lastIndexOf('-', next.range[0])) + 1
    : text.slice(0, own.range[1]).trimEnd().length;
  return next ? { from: line, to: behind, insert: '' } : { from: line - 1, to: behind, insert: '' };
}
