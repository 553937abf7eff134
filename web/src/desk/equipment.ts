/** What stands along the route: rollers by rule or one by one, pits and machines; with the load that theory expects of each. */
import { isMap, isSeq } from 'yaml';
import { el } from '../dom';
import { plain, quantity, read, type Desk } from './desk';
import { appendItem, nodeAt, parsed, removeItem, type Path } from './splice';
import { t } from './words';

const LISTED = 300;

/** Lists of the text whose items can be taken out here. */
const LISTS: [Path, string][] = [
  [['rollers', 'along'], 'Row of rollers'],
  [['rollers', 'list'], 'Roller'],
  [['theory', 'pits'], 'Pit'],
  [['theory', 'machines'], 'Machine'],
  [['conveyors'], 'Conveyor'],
];

export class Equipment {
  readonly root = el('div', { class: 'equipment' });

  constructor(private readonly desk: Desk) {}

  show(): void {
    this.root.replaceChildren(
      el('h3', {}, t('Rollers by rule')),
      this.byRule(),
      el('h3', {}, t('One by one')),
      this.single(),
      el('h3', {}, t('What the case has')),
      this.written(),
      el('h3', {}, t('Where it stands, with the load pulled forward')),
      this.table(),
    );
  }

  private add(path: Path, item: string, what: string): void {
    this.desk.change(appendItem(this.desk.text(), path, item), what, true);
  }

  private input(label: string, value: string): { element: HTMLElement; value: () => string } {
    const one = el('input', { value, 'aria-label': label, size: 8 });
    return {
      element: el('label', { class: 'inline' }, el('span', {}, label), one),
      value: () => one.value.trim() || value,
    };
  }

  private byRule(): HTMLElement {
    const where = el(
      'select',
      { 'aria-label': t('Where') },
      ...['straights', 'bends', 'guides'].map((one) => el('option', { value: one }, t(`where ${one}`))),
    );
    const spacing = this.input(t('every'), '2 m');
    const radius = this.input(t('radius'), '60 mm');
    const rating = this.input(t('rating'), '5 kN');
    const go = (): void =>
      this.add(
        ['rollers', 'along'],
        where.value === 'guides'
          ? `{guide: inside, spacing: ${spacing.value()}, gap: 5 mm, radius: ${radius.value()}, width: 300 mm, rating: ${rating.value()}, name: G}`
          : `{where: ${where.value}, spacing: ${spacing.value()}, radius: ${radius.value()}, width: 400 mm, rating: ${rating.value()}}`,
        t('Row of rollers'),
      );
    return el(
      'div',
      { class: 'buttons' },
      where,
      spacing.element,
      radius.element,
      rating.element,
      el('button', { type: 'button', onclick: go }, t('Add a row')),
    );
  }

  private single(): HTMLElement {
    const place = this.input(t('at'), `${plain(this.desk.place.at ?? 10, 1)} m`);
    const push = this.input(t('push'), '5 kN');
    const add = (label: string, path: Path, item: () => string): HTMLElement =>
      el('button', { type: 'button', onclick: () => this.add(path, item(), t(label)) }, t(label));
    return el(
      'div',
      { class: 'buttons' },
      place.element,
      add(
        'Add a roller',
        ['rollers', 'along'],
        () => `{at: [${place.value()}], radius: 60 mm, width: 400 mm, name: single}`,
      ),
      add('Add a pit', ['theory', 'pits'], () => `{at: ${place.value()}, back: 500 N}`),
      push.element,
      add('Add a machine', ['theory', 'machines'], () => `{at: ${place.value()}, push: ${push.value()}}`),
      add('Add a conveyor', ['conveyors'], () => this.conveyor(place.value(), push.value())),
    );
  }

  /** As long as there is room between two rollers; its grip, twice the clamp by a friction of 0.3, is 1.2 times what its drive gives. */
  private conveyor(at: string, push: string): string {
    const from = read(at)?.value ?? 0;
    const clamp = read(push)?.value ?? NaN;
    const list = nodeAt(parsed(this.desk.text()), ['conveyors']);
    const name = `${t('conveyor')} ${isSeq(list) ? list.items.length + 1 : 1}`;
    const to = plain(from + 1.6, 3);
    return `{name: ${name}, from: ${at}, to: ${to} m, clamp: ${plain(2 * clamp, 0)} N, limit: ${push}, mu: 0.3, factor: 1.02}`;
  }

  private written(): HTMLElement {
    const text = this.desk.text();
    const rows: HTMLElement[] = [];
    for (const [path, label] of LISTS) {
      const node = nodeAt(parsed(text), path);
      const items = isSeq(node) ? (node.items as { range?: [number, number, number] }[]) : isMap(node) ? [node] : [];
      items.forEach((item, i) => {
        const words = text
          .slice(item.range?.[0] ?? 0, item.range?.[1] ?? 0)
          .replace(/(^|\s)#.*$/gm, '')
          .replace(/\s+/g, ' ');
        rows.push(
          el(
            'div',
            { class: 'entry' },
            el(
              'button',
              {
                type: 'button',
                'aria-label': `${t('Remove')}: ${t(label)} ${i + 1}`,
                disabled: items.length < 2,
                onclick: () => this.desk.change(removeItem(this.desk.text(), path, i), t(label), true),
              },
              t('Remove'),
            ),
            el(
              'div',
              {},
              `${t(label)} ${i + 1}: `,
              el('code', {}, words.length > 160 ? `${words.slice(0, 160)}…` : words),
            ),
          ),
        );
      });
    }
    return rows.length ? el('div', {}, ...rows) : el('p', {}, t('The case has no equipment.'));
  }

  private table(): HTMLElement {
    const all = this.desk.along()?.stands.equipment ?? [];
    const us = this.desk.us();
    const names = ['Kind', 'Name', 'Station', 'Load', 'Rating', 'Left'];
    return el(
      'div',
      { class: 'wide', tabindex: 0, role: 'region', 'aria-label': t('Where it stands, with the load pulled forward') },
      el(
        'table',
        { class: 'list' },
        el('thead', {}, el('tr', {}, ...names.map((one) => el('th', { scope: 'col' }, t(one))))),
        el(
          'tbody',
          {},
          ...all.slice(0, LISTED).map((one) => {
            const state =
              one.margin_pct === null ? '' : one.margin_pct < 0 ? 'not_safe' : one.margin_pct < 10 ? 'safe_if' : 'safe';
            return el(
              'tr',
              { onpointerenter: () => this.desk.place.mark(one.station_m), 'data-s': one.station_m },
              el('td', {}, t(`stand ${one.kind}`)),
              el('td', {}, one.name),
              el('td', {}, quantity(one.station_m, 'm', us)),
              el('td', {}, quantity(one.load_N, 'N', us)),
              el('td', {}, quantity(one.rating_N, 'N', us)),
              el('td', { class: `mark ${state}` }, one.margin_pct === null ? '–' : `${one.margin_pct.toFixed(1)} %`),
            );
          }),
        ),
      ),
      all.length > LISTED && el('p', {}, t('{1} more', String(all.length - LISTED))),
    );
  }
}
