// The table behind a figure: the same figures in the same unit, to be read, copied and downloaded as CSV.
import { button, el, named } from '../dom';
import { digits, UNKNOWN } from '../units';

export interface DataTable {
  /** Begins the name of the file. */
  name: string;
  columns: { label: string; unit?: string }[];
  /** Cells: numbers in the unit of their column, text, null (not known) or undefined (there is none). */
  rows: (number | string | null | undefined)[][];
}

const ROWS_SHOWN = 400;

function cell(value: number | string | null | undefined): string {
  if (value === null || value === undefined) return '';
  if (typeof value === 'number') return Number.isFinite(value) ? String(Number(value.toPrecision(12))) : '';
  const text = /^[=+\-@]/.test(value) ? `'${value}` : value;
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

const heading = (column: DataTable['columns'][number]): string =>
  column.unit ? `${column.label}, ${column.unit}` : column.label;

/** The table as CSV: a row of names with units, empty cells where nothing is known, a point before decimals. */
export function csv(table: DataTable): string {
  const rows = [table.columns.map(heading), ...table.rows];
  return rows.map((row) => row.map(cell).join(',')).join('\r\n') + '\r\n';
}

async function copy(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    // Browsers that allow it only in a secure context still have the older way.
    const area = el('textarea', { class: 'offscreen', readonly: true });
    area.value = text;
    document.body.append(area);
    area.select();
    // eslint-disable-next-line @typescript-eslint/no-deprecated -- see above
    const done = document.execCommand('copy');
    area.remove();
    return done;
  }
}

function download(name: string, text: string): void {
  const url = URL.createObjectURL(new Blob([text], { type: 'text/csv' }));
  el('a', { href: url, download: `${name}.csv` }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** The rows of a table on the page; long ones are cut, the CSV has all. */
export function tableElement(table: DataTable, caption: string, significant = 6): HTMLElement {
  const shown = table.rows.slice(0, ROWS_SHOWN);
  const cut = table.rows.length > shown.length;
  const note = cut ? ` (the first ${shown.length} of ${table.rows.length} rows; the CSV has all)` : '';
  const body = shown.map((row) =>
    el(
      'tr',
      {},
      ...row.map((value) =>
        typeof value === 'number'
          ? el('td', { class: 'number' }, digits(value, significant))
          : el('td', {}, value === null ? UNKNOWN : named(value ?? '')),
      ),
    ),
  );
  const head = el('tr', {}, ...table.columns.map((column) => el('th', { scope: 'col' }, heading(column))));
  return el(
    'div',
    { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': caption },
    el('table', { class: 'data' }, el('caption', {}, caption + note), el('thead', {}, head), el('tbody', {}, ...body)),
  );
}

/** Buttons that copy the table as CSV and save it. */
export function csvTools(make: () => DataTable): HTMLElement {
  const said = el('span', { class: 'said', role: 'status' });
  const copyButton = button('Copy CSV', () => {
    void copy(csv(make())).then((done) => {
      said.textContent = done ? 'copied' : 'the browser does not allow copying';
      setTimeout(() => (said.textContent = ''), 4000);
    });
  });
  const save = button('Save CSV', () => {
    const table = make();
    download(table.name, csv(table));
  });
  return el('div', { class: 'tools' }, copyButton, save, said);
}

/** The same with a button that shows the table, which is made when it is first asked for, and the place where it appears. */
export function tableTools(
  make: () => DataTable,
  caption: string,
  open: boolean,
  onOpen: (open: boolean) => void,
): HTMLElement[] {
  const place = el('div', { class: 'behind' });
  const fill = (shown: boolean): void => {
    toggle.setAttribute('aria-expanded', String(shown));
    toggle.textContent = shown ? 'Hide table' : 'Table';
    place.replaceChildren(...(shown ? [tableElement(make(), caption)] : []));
  };
  const toggle = button('Table', () => {
    const shown = toggle.getAttribute('aria-expanded') !== 'true';
    fill(shown);
    onOpen(shown);
  });
  fill(open);
  const tools = csvTools(make);
  tools.prepend(toggle);
  return [tools, place];
}
