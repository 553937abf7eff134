/** Which keys and words may stand at the cursor, by the schema of a case (`hawser schema`). */
import type { Completion, CompletionContext, CompletionResult } from '@codemirror/autocomplete';
import { isMap, isScalar, isSeq, type Node } from 'yaml';
import { parsed, type Path } from './splice';

/** What the desk reads of a JSON Schema. */
export interface Schema {
  $ref?: string;
  $defs?: Record<string, Schema>;
  properties?: Record<string, Schema>;
  additionalProperties?: Schema | boolean;
  items?: Schema;
  anyOf?: Schema[];
  oneOf?: Schema[];
  enum?: unknown[];
  default?: unknown;
  description?: string;
  'x-absent'?: string;
  'x-quantity'?: string;
  'x-unit'?: string;
}

/** All forms of a place in the schema; of a reference what it leads to. */
function forms(schema: Schema | undefined, top: Schema): Schema[] {
  if (!schema) return [];
  const to = schema.$ref ? top.$defs?.[decodeURIComponent(schema.$ref.replace('#/$defs/', ''))] : undefined;
  const others = [...(schema.anyOf ?? []), ...(schema.oneOf ?? [])].flatMap((one) => forms(one, top));
  return [schema, ...(to ? forms(to, top) : []), ...others];
}

function below(schemas: Schema[], step: string | number, top: Schema): Schema[] {
  const found = schemas.flatMap((one) => {
    if (typeof step === 'number') return one.items ? [one.items] : [];
    const own = one.properties?.[step];
    const any = typeof one.additionalProperties === 'object' ? one.additionalProperties : undefined;
    return own ? [own] : any ? [any] : [];
  });
  return found.flatMap((one) => forms(one, top));
}

/** The map that the cursor is in, by its path: of maps in blocks the one whose keys stand at the cursor's column. */
function mapAt(text: string, at: number): Path {
  const column = at - (text.lastIndexOf('\n', at - 1) + 1);
  const word = /[\w-]*$/.exec(text.slice(0, at))?.[0].length ?? 0;
  let found: Path = [];
  const walk = (node: unknown, path: Path): void => {
    if (isMap(node)) {
      const begin = (node as Node).range?.[0] ?? 0;
      const end = (node as Node).range?.[1] ?? 0;
      if (
        node.flow
          ? begin < at && at < end
          : begin <= at && begin - (text.lastIndexOf('\n', begin - 1) + 1) === column - word
      )
        found = path;
      for (const pair of node.items) if (isScalar(pair.key)) walk(pair.value, [...path, String(pair.key.value)]);
    }
    if (isSeq(node)) (node.items as Node[]).forEach((item, i) => walk(item, [...path, i]));
  };
  walk(parsed(text).contents, []);
  return found;
}

function detail(schemas: Schema[]): string {
  const of = <K extends keyof Schema>(key: K) => schemas.find((one) => one[key] !== undefined)?.[key];
  const absent = of('default') ?? of('x-absent');
  return [of('x-quantity'), absent === undefined ? '' : `default ${JSON.stringify(absent).replace(/^"(.*)"$/, '$1')}`]
    .filter(Boolean)
    .join(', ');
}

export function completions(top: Schema): (context: CompletionContext) => CompletionResult | null {
  return (context) => {
    const text = context.state.doc.toString();
    const before = context.matchBefore(/[\w-]*/);
    if (!before || (before.from === before.to && !context.explicit)) return null;
    const key = /([\w-]+):\s*[\w-]*$/.exec(text.slice(text.lastIndexOf('\n', context.pos - 1) + 1, context.pos))?.[1];
    let here = forms(top, top);
    for (const step of mapAt(text, before.from)) here = below(here, step, top);
    if (key) {
      const words = below(here, key, top).flatMap((one) => one.enum ?? []);
      return words.length
        ? { from: before.from, options: words.map((word) => ({ label: String(word), type: 'enum' })) }
        : null;
    }
    const options: Completion[] = here.flatMap((one) =>
      Object.keys(one.properties ?? {}).map((name) => {
        const schemas = below([one], name, top);
        const info = schemas.find((each) => each.description)?.description ?? '';
        return { label: name, apply: `${name}: `, type: 'property', detail: detail(schemas), info };
      }),
    );
    return options.length ? { from: before.from, options, validFor: /^[\w-]*$/ } : null;
  };
}

/** What the schema says of a key: its help, quantity and default. English: it is the program's. */
export function about(top: Schema, path: Path): string {
  let here = forms(top, top);
  for (const step of path) here = below(here, step, top);
  const info = here.find((one) => one.description)?.description ?? '';
  return [info, detail(here)].filter(Boolean).join(' \u2013 ');
}

const LISTED = 20; // items of a list that are looked into

/** Paths of values that a text does not have, in its maps and in those that could stand in them. */
export function absent(top: Schema, text: string): string[] {
  const found: string[] = [];
  const walk = (schemas: Schema[], node: unknown, path: Path): void => {
    if (isSeq(node)) node.items.slice(0, LISTED).forEach((item, i) => walk(below(schemas, i, top), item, [...path, i]));
    if (isSeq(node) || isScalar(node)) return;
    const own = isMap(node) ? node.items.map((pair) => String(isScalar(pair.key) ? pair.key.value : '')) : [];
    for (const name of new Set([...own, ...schemas.flatMap((one) => Object.keys(one.properties ?? {}))])) {
      const here = below(schemas, name, top);
      const map = here.some((one) => one.properties);
      if (own.includes(name)) walk(here, isMap(node) ? node.get(name, true) : undefined, [...path, name]);
      else if (map && path.length < 2) walk(here, undefined, [...path, name]);
      else if (!map && !here.some((one) => one.items)) found.push([...path, name].join('.'));
    }
  };
  walk(forms(top, top), parsed(text).contents, []);
  return found;
}

/** All keys that a case may hold, by section, with what the schema says of them. */
export function keys(top: Schema): { key: string; words: string }[] {
  const sections: [string, Schema][] = [['', top], ...Object.entries(top.$defs ?? {})];
  return sections.flatMap(([section, schema]) =>
    Object.keys(schema.properties ?? {}).map((name) => {
      const here = below([schema], name, top);
      const info = here.find((one) => one.description)?.description ?? '';
      const choices = here.flatMap((one) => one.enum ?? []).join(', ');
      return {
        key: section ? `${section}.${name}` : name,
        words: [info, choices, detail(here)].filter(Boolean).join(' \u2013 '),
      };
    }),
  );
}
