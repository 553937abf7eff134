/** Which keys and words may stand at the cursor, by the schema of a case (`hawser schema`). */
import type { Completion, CompletionContext, CompletionResult } from '@codemirror/autocomplete';
import { isMap, isScalar, isSeq, type Node } from 'yaml';
import { parsed, type Path } from './splice';
import { languageNow, t } from './words';

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
  deprecated?: boolean;
  'x-description'?: Record<string, string>;
  'x-form'?: string;
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

const of = <K extends keyof Schema>(schemas: Schema[], key: K): Schema[K] | undefined =>
  schemas.find((one) => one[key] !== undefined)?.[key];

/** A range or a form of values: `section ...` and numbers in every language. */
function form(words: string): string {
  const range = /^(at least|above) (.*), at most (.*)$/.exec(words);
  const section = /^section (`[^`]+`)$/.exec(words);
  if (range) return `${range[1] === 'above' ? '>' : '\u2265'} ${range[2] ?? ''}, \u2264 ${range[3] ?? ''}`;
  return section ? t('section {1}', section[1] ?? '') : t(words);
}

/** What a key means, behind it the allowed values; in English as the program writes it. */
function meaning(schemas: Schema[]): string {
  const english = of(schemas, 'description') ?? '';
  const own = of(schemas, 'x-description')?.[languageNow()];
  const more = of(schemas, 'x-form');
  return own ? `${own}${more ? ` (${form(more)})` : ''}` : english;
}

const NEUTRAL = /^([\d.e]+( \S+)?|`\w+`)$/; // numbers and words of a case

function detail(schemas: Schema[]): string {
  const absent = of(schemas, 'x-absent') ?? '';
  const given = of(schemas, 'default');
  const words = given === undefined ? (NEUTRAL.test(absent) ? absent : t(absent)) : JSON.stringify(given);
  return [t(of(schemas, 'x-quantity') ?? ''), words && t('default {1}', words.replace(/^"(.*)"$/, '$1'))]
    .filter(Boolean)
    .join(', ');
}

/** Names of the keys that a map may have; other names that people type are not offered. */
const offered = (schema: Schema): string[] =>
  Object.entries(schema.properties ?? {}).flatMap(([name, one]) => (one.deprecated ? [] : [name]));

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
      offered(one).map((name) => {
        const schemas = below([one], name, top);
        return { label: name, apply: `${name}: `, type: 'property', detail: detail(schemas), info: meaning(schemas) };
      }),
    );
    return options.length ? { from: before.from, options, validFor: /^[\w-]*$/ } : null;
  };
}

/** What the schema says of a key: its help, quantity and default. */
export function about(top: Schema, path: Path): string {
  let here = forms(top, top);
  for (const step of path) here = below(here, step, top);
  return [meaning(here), detail(here)].filter(Boolean).join(' \u2013 ');
}

const LISTED = 20; // items of a list that are looked into

/** Paths of values that a text does not have, in its maps and in those that could stand in them. */
export function absent(top: Schema, text: string): string[] {
  const found: string[] = [];
  const walk = (schemas: Schema[], node: unknown, path: Path): void => {
    if (isSeq(node)) node.items.slice(0, LISTED).forEach((item, i) => walk(below(schemas, i, top), item, [...path, i]));
    if (isSeq(node) || isScalar(node)) return;
    const own = isMap(node) ? node.items.map((pair) => String(isScalar(pair.key) ? pair.key.value : '')) : [];
    for (const name of new Set([...own, ...schemas.flatMap(offered)])) {
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
    offered(schema).map((name) => {
      const here = below([schema], name, top);
      const choices = here.flatMap((one) => one.enum ?? []).join(', ');
      return {
        key: section ? `${section}.${name}` : name,
        words: [meaning(here), choices, detail(here)].filter(Boolean).join(' \u2013 '),
      };
    }),
  );
}
