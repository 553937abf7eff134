/** Variants: texts that are kept beside the case, with what theory says of each: the table for the meeting. */
import { el } from '../dom';
import { quantity, type Desk } from './desk';
import { messageOf, type Limit, type Theory } from './engine';
import { t } from './words';

const KEPT = 'hawser-desk-variants';

const NAMES = ['Variant', 'Verdict', 'Pulled forward', 'Pulled back', 'Sidewall pressure', 'Worst place'];

interface Variant {
  name: string;
  text: string;
}

function kept(): Variant[] {
  try {
    return (JSON.parse(localStorage.getItem(KEPT) ?? '[]') as Variant[]).filter((one) => one.text);
  } catch {
    return [];
  }
}

/** The limit with the least left of it; undefined: none is judged. */
export function worst(theory: Theory): Limit | undefined {
  return (theory.limits ?? [])
    .filter((one) => one.direction === 'forward' && one.margin !== null && one.limit !== null)
    .sort((a, b) => (a.margin ?? 0) - (b.margin ?? 0))[0];
}

export function forgetVariants(): void {
  try {
    localStorage.removeItem(KEPT);
  } catch {
    // nothing was kept
  }
}

export class Variants {
  readonly root = el('div', { class: 'variants' });
  private all = kept();
  private known = new Map<string, Theory | string>();

  constructor(
    private readonly desk: Desk,
    private readonly verdict: (code: string) => string,
    private readonly open: (text: string, name: string) => void,
  ) {}

  show(): void {
    const name = el('input', {
      type: 'text',
      'aria-label': t('Name of the variant'),
      placeholder: t('Name of the variant'),
    });
    const keep = (): void => {
      this.all = [
        ...this.all,
        { name: name.value.trim() || `${t('Variant')} ${this.all.length + 1}`, text: this.desk.text() },
      ];
      this.store();
      this.show();
    };
    const rows: { name: string; text: string; i: number }[] = [
      { name: t('The case as it stands'), text: this.desk.text(), i: -1 },
      ...this.all.map((one, i) => ({ ...one, i })),
    ];
    const body = el('tbody', {}, ...rows.map(({ name: label, text, i }) => this.row(label, text, i)));
    const table = el('table', { class: 'list' }, el('caption', {}, t('Variants')), this.head(true), body);
    this.root.replaceChildren(
      el(
        'div',
        { class: 'buttons' },
        name,
        el('button', { type: 'button', onclick: keep }, t('Keep the case as a variant')),
        el('button', { type: 'button', onclick: () => this.copy() }, t('Copy the table')),
        el('button', { type: 'button', onclick: () => window.print() }, t('Print the table')),
      ),
      el('div', { class: 'wide', tabindex: 0, role: 'region', 'aria-label': t('Variants') }, table),
    );
    void this.calculate(rows.map((one) => one.text));
  }

  private head(tools: boolean): HTMLElement {
    return el(
      'thead',
      {},
      el(
        'tr',
        {},
        ...NAMES.map((one) => el('th', { scope: 'col' }, t(one))),
        tools && el('th', { scope: 'col', class: 'tools' }, t('Actions')),
      ),
    );
  }

  private cells(label: string, text: string): HTMLElement[] {
    const theory = this.known.get(text);
    const us = this.desk.us();
    if (typeof theory === 'string')
      return [el('th', { scope: 'row' }, label), el('td', { colspan: 5, lang: 'en' }, theory)];
    if (!theory) return [el('th', { scope: 'row' }, label), ...Array.from({ length: 5 }, () => el('td', {}, '…'))];
    const limit = worst(theory);
    const margin = limit?.margin ?? 0;
    const left = t(margin < 0 ? '{1} over' : '{1} left', `${Math.abs(100 * margin).toFixed(1)} %`);
    // on a narrow screen each cell has its column's name before it
    const cell = (i: number, words: string, kind = ''): HTMLElement =>
      el('td', { class: kind, 'data-name': t(NAMES[i] ?? '') }, words);
    return [
      el('th', { scope: 'row' }, label),
      cell(1, this.verdict(theory.verdict_code), `mark ${theory.verdict_code}`),
      cell(2, quantity(theory.largest_force_N, 'N', us)),
      cell(3, quantity(theory.backward_largest_force_N, 'N', us)),
      cell(4, quantity(theory.max_sidewall_N_per_m, 'N/m', us)),
      cell(5, limit ? `${limit.where} – ${t(`limit ${limit.name}`)}: ${left}` : '–'),
    ];
  }

  private row(label: string, text: string, i: number): HTMLElement {
    const tool = (words: string, action: () => void): HTMLElement =>
      el('button', { type: 'button', 'aria-label': `${words}: ${label}`, onclick: action }, words);
    const tools =
      i < 0
        ? []
        : [
            tool(t('Open'), () => this.open(text, `${label}.yaml`)),
            tool(t('Remove'), () => {
              this.all = this.all.filter((_, k) => k !== i);
              this.store();
              this.show();
            }),
          ];
    return el('tr', {}, ...this.cells(label, text), el('td', { class: 'tools' }, ...tools));
  }

  private store(): void {
    try {
      localStorage.setItem(KEPT, JSON.stringify(this.all));
    } catch {
      this.desk.say(t('This browser keeps no drafts.'));
    }
  }

  private async calculate(texts: string[]): Promise<void> {
    const unknown = texts.filter((text) => !this.known.has(text));
    for (const text of unknown)
      this.known.set(text, await (this.desk.engine()?.theory(text) ?? Promise.reject(new Error())).catch(messageOf));
    const rows = [...this.root.querySelectorAll('tbody tr')];
    texts.forEach((text, i) => {
      const row = rows[i];
      const tools = row?.querySelector('td.tools');
      const label = row?.querySelector('th')?.textContent ?? '';
      if (row && tools) row.replaceChildren(...this.cells(label, text), tools);
    });
    const own = new Set(texts);
    for (const text of this.known.keys()) if (!own.has(text)) this.known.delete(text);
  }

  /** The table without its buttons, as a table for Word or a spreadsheet. */
  private copy(): void {
    const rows = [{ name: t('The case as it stands'), text: this.desk.text() }, ...this.all];
    const table = el(
      'table',
      {},
      this.head(false),
      el('tbody', {}, ...rows.map(({ name, text }) => el('tr', {}, ...this.cells(name, text)))),
    );
    document.body.append(table);
    const chosen = document.getSelection();
    chosen?.removeAllRanges();
    const range = document.createRange();
    range.selectNode(table);
    chosen?.addRange(range);
    // the only way that a page from disk has in every browser
    // eslint-disable-next-line @typescript-eslint/no-deprecated -- see above
    const good = document.execCommand('copy');
    chosen?.removeAllRanges();
    table.remove();
    this.desk.say(good ? t('The table is on the clipboard.') : t('This browser does not let the page copy.'));
  }
}
