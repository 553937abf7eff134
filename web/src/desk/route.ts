/** The route as a table: a row for each piece, each cell a value of the text. */
import { isMap, isScalar, isSeq, type Node } from 'yaml';
import { el } from '../dom';
import { writtenAt, type Desk } from './desk';
import { messageOf } from './engine';
import { addItem, nodeAt, parsed, putSection, removeItem, removeKey, setValue, type Path } from './splice';
import { t } from './words';

const PIECES: Path = ['route', 'pieces'];
const POINTS: Path = ['route', 'points'];
const CORNERS: Column[] = [
  { key: '0', label: 'x', hint: '' },
  { key: '1', label: 'y', hint: '' },
  { key: '2', label: 'z', hint: '' },
  { key: '3', label: 'Radius', hint: '' },
];
const MOST = 400; // rows

interface Column {
  key: string;
  label: string;
  hint: string;
  /** Another name of the key. */
  alias?: string;
  /** What is offered. */
  words?: string[];
  /** There is a column where a piece has the key. */
  rare?: boolean;
}
const COLUMNS: Column[] = [
  { key: 'name', label: 'Name', hint: '' },
  { key: 'straight', alias: 'length', label: 'Straight', hint: '50 m' },
  { key: 'bend', alias: 'angle', label: 'Bend', hint: '90 deg' },
  { key: 'radius', label: 'Radius', hint: '8 m' },
  { key: 'plane', alias: 'turn', label: 'Turns', hint: 'left', words: ['left', 'right', 'up', 'down'] },
  { key: 'slope', label: 'Slope', hint: '5 %' },
  { key: 'clothoid', label: 'Clothoid', hint: '10 m', rare: true },
  { key: 'start_radius', label: 'Radius at its start', hint: '', rare: true },
  { key: 'end_radius', label: 'Radius at its end', hint: '', rare: true },
  { key: 'parabola', label: 'Parabola', hint: '10 m', rare: true },
  { key: 'end_slope', label: 'Slope at its end', hint: '0 %', rare: true },
];
/** What a piece of a kind may have. */
const KEYS: Record<string, string[]> = {
  straight: ['slope'],
  bend: ['radius', 'plane'],
  clothoid: ['start_radius', 'end_radius', 'plane'],
  parabola: ['end_slope'],
};

const hasKey = (item: Node, { key, alias }: Column): boolean =>
  isMap(item) && (item.has(key) || (alias !== undefined && item.has(alias)));

/** Whether a piece may have a value of a column. */
function fits(item: Node, column: Column): boolean {
  const kind = COLUMNS.find((one) => one.key in KEYS && hasKey(item, one))?.key;
  return (
    column.key === 'name' || column.key === kind || !!KEYS[kind ?? '']?.includes(column.key) || hasKey(item, column)
  );
}

function cell(tag: 'td' | 'th', content: string | HTMLElement): HTMLTableCellElement {
  const one = document.createElement(tag);
  one.append(content);
  return one;
}

export function button(label: string, title: string, action: () => void): HTMLButtonElement {
  const one = document.createElement('button');
  one.type = 'button';
  one.textContent = label;
  one.title = title;
  if (title) one.setAttribute('aria-label', title);
  one.addEventListener('click', action);
  return one;
}

/** An input whose value is written into the text when it is left or Enter is pressed. */
export function field(label: string, value: string, hint: string, write: (value: string) => void): HTMLInputElement {
  const input = document.createElement('input');
  input.value = value;
  input.placeholder = hint;
  input.setAttribute('aria-label', label);
  input.spellcheck = false;
  input.addEventListener('change', () => write(input.value.trim()));
  return input;
}

/** One table of a list of the text: a row an item, a cell a value. `pathOf` says where the value of a column is. */
function table(
  place: HTMLElement,
  desk: Desk,
  list: Path,
  columns: Column[],
  tools: (i: number) => HTMLElement[],
  known: (item: Node, column: Column) => boolean,
  what: string,
): void {
  const text = desk.text();
  const items = (nodeAt(parsed(text), list) as unknown as { items: Node[] }).items;
  const one = document.createElement('table');
  const head = one.createTHead().insertRow();
  for (const column of columns) head.append(cell('th', t(column.label)));
  head.append(document.createElement('td'));
  const body = one.createTBody();
  items.slice(0, MOST).forEach((item, i) => {
    const row = body.insertRow();
    row.dataset['listed'] = String(i + 1);
    const here = (): void => {
      const piece = desk.along()?.pieces.find((each) => each.listed === i + 1);
      if (piece) desk.place.mark(piece.s_m + piece.length_m / 2);
    };
    row.addEventListener('pointerenter', here);
    row.addEventListener('focusin', here);
    for (const column of columns) {
      const named = column.alias !== undefined && isMap(item) && item.has(column.alias);
      const key = named ? (column.alias ?? '') : column.key;
      const path: Path = [...list, i, isSeq(item) ? Number(key) : key];
      const value = nodeAt(parsed(text), path);
      const shown = isScalar(value) ? (value.source ?? '') : '';
      const write = (next: string): void =>
        desk.change(
          next ? setValue(desk.text(), path, next) : removeKey(desk.text(), path),
          `${t(column.label)}, ${t(what)} ${i + 1}`,
        );
      const input = field(`${t(column.label)}, ${t(what)} ${i + 1}`, shown, column.hint, write);
      if (column.words) input.setAttribute('list', column.key);
      if (!known(item, column)) {
        input.placeholder = '';
        input.disabled = true;
      }
      row.append(cell('td', input));
    }
    const last = row.insertCell();
    last.append(...tools(i));
  });
  const more = items.length - MOST;
  const offered = columns.map(({ key, words = [] }) =>
    el('datalist', { id: key }, ...words.map((value) => el('option', { value }))),
  );
  const about = el(
    'p',
    {},
    t('The order is that of the pull, from the reel to the winch. A value has its unit: 150 m, 500 ft, 45 deg.'),
  );
  place.replaceChildren(one, ...offered, about, more > 0 ? t('{1} more: change them in the text.', String(more)) : '');
}

/** The table of the text as it stands; a sentence where the route is not a list of pieces or points. */
export function routeView(place: HTMLElement, desk: Desk): void {
  const document_ = parsed(desk.text());
  const add = (list: Path, i: number, item: string) => () =>
    desk.change(addItem(desk.text(), list, i, item), t('piece'), true);
  const take = (list: Path, i: number) => () => desk.change(removeItem(desk.text(), list, i), t('piece'), true);
  if (isSeq(nodeAt(document_, PIECES))) {
    const pieces = (nodeAt(document_, PIECES) as unknown as { items: Node[] }).items;
    const columns = COLUMNS.filter((column) => !column.rare || pieces.some((item) => hasKey(item, column)));
    const tool = (sign: string, word: string, title: string, action: () => void): HTMLElement => {
      const one = button(sign, title, action);
      if (word) one.append(el('span', { class: 'word' }, ` ${t(word)}`));
      return one;
    };
    const tools = (i: number): HTMLElement[] => [
      tool('+', 'straight', t('Add a straight behind piece {1}', String(i + 1)), add(PIECES, i, '{straight: 10 m}')),
      tool(
        '\u21b7',
        'bend',
        t('Add a bend behind piece {1}', String(i + 1)),
        add(PIECES, i, '{bend: 45 deg, radius: 8 m, plane: left}'),
      ),
      tool('\u2212', '', t('Take piece {1} out', String(i + 1)), take(PIECES, i)),
    ];
    table(place, desk, PIECES, columns, tools, fits, 'piece');
  } else if (isSeq(nodeAt(document_, POINTS))) {
    const tools = (i: number): HTMLElement[] => [
      button('\u2212', t('Take corner {1} out', String(i + 1)), take(POINTS, i)),
    ];
    table(place, desk, POINTS, CORNERS, tools, () => true, 'corner');
  } else {
    const word = document.createElement('p');
    word.textContent = t('This route comes from a file or is written in another form. Change it in the text.');
    place.replaceChildren(word, ...intoText(desk));
  }
}

/** A button that writes the line of a file into the case, where it has handles then; none where the case chooses more of the file. */
function intoText(desk: Desk): HTMLElement[] {
  const route = nodeAt(parsed(desk.text()), ['route']);
  const of = (key: string): string => writtenAt(desk.text(), ['route', key]) ?? '';
  const known = isMap(route) && route.items.every((pair) => ['file', 'name', 'layer'].includes(String(pair.key)));
  if (!known || !of('file')) return [];
  const one = document.createElement('button');
  one.type = 'button';
  one.textContent = t('Write the line of the file into the case');
  one.addEventListener('click', () => {
    const before = desk.text();
    void desk
      .engine()
      ?.section(of('file'), of('name'), of('layer'))
      .then((section) => before === desk.text() && desk.change(putSection(before, 'route', section), t('Route'), true))
      .catch((why: unknown) => desk.say(messageOf(why)));
  });
  return [one];
}

/** Marks the row of a piece, from 1 on; 0: none. */
export function markRoute(place: HTMLElement, listed: number): void {
  for (const row of place.querySelectorAll<HTMLElement>('tr[data-listed]'))
    row.classList.toggle('marked', row.dataset['listed'] === String(listed));
}
