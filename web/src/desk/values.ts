/** Every value of the text outside the route's pieces as a field, by section. */
import { isMap, isScalar, isSeq, type Node } from 'yaml';
import { el } from '../dom';
import { addValue, parsed, pathOf, setValue, type Path } from './splice';
import { about, absent, type Schema } from './complete';
import type { Editing } from './desk';
import { field } from './route';
import { t } from './words';

interface Leaf {
  path: Path;
  value: string;
}

function leaves(node: unknown, path: Path, out: Leaf[]): void {
  if (isScalar(node)) out.push({ path, value: node.source ?? '' });
  else if (isMap(node))
    for (const pair of node.items)
      if (isScalar(pair.key)) leaves(pair.value, [...path, pair.key.value as string | number], out);
  if (isSeq(node)) (node.items as Node[]).forEach((item, i) => leaves(item, [...path, i], out));
}

const isPiece = (path: Path) => path[0] === 'route' && path[1] === 'pieces';

/** schema: what a key means is said where the pointer or a reader of the screen asks for it. */
export function valuesView(place: HTMLElement, editing: Editing, schema: Schema | undefined): void {
  const found: Leaf[] = [];
  leaves(parsed(editing.text()).contents, [], found);
  const said = document.createElement('p'); // help of the field that has the focus
  said.className = 'reading';
  const sections = new Map<string, HTMLFieldSetElement>();
  for (const { path, value } of found) {
    if (isPiece(path)) continue;
    const name = path.length > 1 ? String(path[0]) : t('Case');
    let section = sections.get(name);
    if (!section) {
      section = document.createElement('fieldset');
      const legend = document.createElement('legend');
      legend.textContent = name;
      section.append(legend);
      sections.set(name, section);
    }
    const label = document.createElement('label');
    const words = (path.length > 1 ? path.slice(1) : path)
      .map((step) => (typeof step === 'number' ? step + 1 : step))
      .join(' ');
    const text = document.createElement('span');
    text.textContent = words;
    const help = schema ? about(schema, path) : '';
    label.title = help;
    label.addEventListener('focusin', () => (said.textContent = `${path.join('.')}: ${help || '–'}`));
    if (help) text.append(el('small', {}, help.split(/\. |。/)[0] ?? ''));
    label.append(
      text,
      field(path.join('.'), value, '', (next) =>
        editing.change(next ? setValue(editing.text(), path, next) : undefined, path.join('.')),
      ),
    );
    section.append(label);
  }
  place.replaceChildren(...sections.values(), ...(schema ? [adding(editing, schema, said)] : []), said);
}

/** A value that the text does not have yet: its key out of all that may stand in this case, and what it is. */
function adding(editing: Editing, schema: Schema, said: HTMLElement): HTMLElement {
  const text = editing.text();
  const offered = absent(schema, text).filter((path) => !isPiece(pathOf(path)));
  const key = el('input', { 'aria-label': t('Key'), list: 'absent', placeholder: 'limits.pull' });
  const value = el('input', { 'aria-label': t('Value'), placeholder: '20 kN' });
  const describe = (): void => void (said.textContent = `${key.value}: ${about(schema, pathOf(key.value)) || '–'}`);
  key.addEventListener('input', describe);
  const add = (): void => {
    const [path, next] = [key.value.trim(), value.value.trim()];
    if (path && next) editing.change(addValue(editing.text(), pathOf(path), next), path, true);
  };
  value.addEventListener('keydown', (event) => event.key === 'Enter' && add());
  return el(
    'fieldset',
    { class: 'adding' },
    el('legend', {}, t('Another value')),
    el('datalist', { id: 'absent' }, ...offered.map((path) => el('option', { value: path }))),
    key,
    value,
    el('button', { type: 'button', onclick: add }, t('Add')),
  );
}
