/** The route as a table: a row for each piece, each cell a value of the text. */
import { isMap, isScalar, isSeq, type Node } from 'yaml';
import { addItem, nodeAt, parsed, removeItem, removeKey, setValue, type Change, type Path } from './splice';

const PIECES: Path = ['route', 'pieces'];
const MOST = 400; // rows
const COLUMNS = [
  { key: 'name', label: 'Name', hint: '' },
  { key: 'straight', label: 'Straight', hint: '50 m' },
  { key: 'bend', label: 'Bend', hint: '90 deg' },
  { key: 'radius', label: 'Radius', hint: '8 m' },
  { key: 'plane', label: 'Turns', hint: 'left, right, up, down' },
  { key: 'slope', label: 'Slope', hint: '5 %' },
];

export interface Editing {
  text(): string;
  /** rows: the table has other rows then, and is made anew at once. */
  change(change: Change | undefined, what: string, rows?: boolean): void;
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
  one.setAttribute('aria-label', title);
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

/** The table of the text as it stands; a sentence where the route is not a list of pieces. */
export function routeView(place: HTMLElement, editing: Editing): void {
  const list = nodeAt(parsed(editing.text()), PIECES);
  if (!list || !isSeq(list)) {
    const word = document.createElement('p');
    word.textContent =
      'This route is not a list of pieces: it comes from a file or is written in another form. Change it in the text.';
    place.replaceChildren(word);
    return;
  }
  const table = document.createElement('table');
  const head = table.createTHead().insertRow();
  for (const column of [...COLUMNS.map((c) => c.label), '']) head.append(cell('th', column));
  const body = table.createTBody();
  (list.items as Node[]).slice(0, MOST).forEach((item, i) => {
    const row = body.insertRow();
    for (const { key, label, hint } of COLUMNS) {
      const path: Path = [...PIECES, i, key];
      const value = isMap(item) ? item.get(key, true) : undefined;
      const shown = isScalar(value) ? String(value.source ?? value.value ?? '') : '';
      row.append(
        cell(
          'td',
          field(`${label}, piece ${i + 1}`, shown, hint, (next) =>
            editing.change(
              next ? setValue(editing.text(), path, next) : removeKey(editing.text(), path),
              `${label} of piece ${i + 1}`,
            ),
          ),
        ),
      );
    }
    const tools = row.insertCell();
    tools.append(
      button('+', `Add a straight behind piece ${i + 1}`, () =>
        editing.change(addItem(editing.text(), PIECES, i, '{straight: 10 m}'), 'a piece', true),
      ),
      button('↷', `Add a bend behind piece ${i + 1}`, () =>
        editing.change(addItem(editing.text(), PIECES, i, '{bend: 45 deg, radius: 8 m, plane: left}'), 'a piece', true),
      ),
      button('−', `Take piece ${i + 1} out`, () =>
        editing.change(removeItem(editing.text(), PIECES, i), 'a piece', true),
      ),
    );
  });
  const more = list.items.length - MOST;
  place.replaceChildren(table, more > 0 ? `${more} more pieces: change them in the text.` : '');
}
