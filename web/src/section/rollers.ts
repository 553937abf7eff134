// Loads of the rollers against their ratings, the smallest margin first.
import { rollerFigure } from '../chart/along';
import type { Context } from '../context';
import type { Value } from '../data';
import { button, el, named } from '../dom';
import { csvTools } from '../figure/table';
import { numbers, texts, type Standing } from '../run';
import { scaleOf, show, UNKNOWN } from '../units';
import { note, section, usage } from './parts';

interface Load {
  index: number;
  name: string;
  place: Value;
  steady: Value;
  peak: Value;
  rating: Value;
  /** Peak over rating; null where one of them is not known. */
  share: Value;
}

const FIRST = 12;

function loads(context: Context): Load[] {
  const table = context.run.rollers;
  const column = (name: string): Value[] => numbers(table, name) ?? [];
  const [place, steady, peak, rating] = [column('s_m'), column('steady_N'), column('peak_N'), column('rating_N')];
  const found = texts(table, 'name').map((name, index): Load => {
    const [most, bound] = [peak[index] ?? null, rating[index] ?? null];
    const share = most === null || bound === null || bound <= 0 ? null : most / bound;
    return {
      index,
      name,
      place: place[index] ?? null,
      steady: steady[index] ?? null,
      peak: most,
      rating: bound,
      share,
    };
  });
  const rank = (load: Load): number => load.share ?? -1;
  return found.sort((a, b) => rank(b) - rank(a) || (b.peak ?? 0) - (a.peak ?? 0));
}

function row(load: Load, context: Context, rated: boolean): HTMLElement {
  const { units, store } = context;
  const standing: Standing = load.share === null ? 'unjudged' : load.share > 1 ? 'unsafe' : 'safe';
  const margin = load.share === null ? UNKNOWN : show(100 * (1 - load.share), '%', units, 3);
  const number = (text: string): HTMLElement => el('td', { class: text === UNKNOWN ? 'unknown' : 'number' }, text);
  const pick = el(
    'button',
    { type: 'button', class: 'pick', onclick: () => store.set('roller', load.index), title: 'Show in the 3-D view' },
    named(load.name),
  );
  return el(
    'tr',
    { onmouseenter: () => store.set('place', load.place), onmouseleave: () => store.set('place', null) },
    el('th', { scope: 'row' }, pick),
    number(load.place === null ? 'by coordinates' : show(load.place, 'm', units)),
    number(show(load.steady, 'N', units)),
    number(show(load.peak, 'N', units)),
    ...(rated
      ? [
          number(load.rating === null ? 'not given' : show(load.rating, 'N', units)),
          number(margin),
          el('td', { class: 'usage-cell' }, load.share === null ? null : usage(load.share, standing)),
        ]
      : []),
  );
}

export function rollersSection(context: Context): HTMLElement | null {
  const all = loads(context);
  if (!context.run.rollers) return section('rollers', 'Rollers', note('These results hold no loads of rollers.'));
  if (all.length === 0) return null;
  const rated = all.some((load) => load.rating !== null);
  const caption = rated
    ? 'The smallest margin of the peak load against the rating first.'
    : 'No roller has a rating in this case, so there are no margins. The largest load first.';
  const body = el('tbody', {}, ...all.slice(0, FIRST).map((load) => row(load, context, rated)));
  const more =
    all.length > FIRST
      ? button(`Show all ${all.length} rollers`, () => {
          body.append(...all.slice(FIRST).map((load) => row(load, context, rated)));
          more?.remove();
        })
      : null;
  const heads = ['Roller', 'Place', 'Steady mean', 'Peak', ...(rated ? ['Rating', 'Margin of the peak', 'Used'] : [])];
  const table = el(
    'table',
    { class: 'rollers' },
    el('caption', {}, caption),
    el('thead', {}, el('tr', {}, ...heads.map((text) => el('th', { scope: 'col' }, text)))),
    body,
  );
  const figure = rollerFigure(context.run);
  const force = scaleOf('N', context.units, 1000);
  const length = scaleOf('m', context.units, 1);
  const scaled = (value: Value, factor: number): Value => (value === null ? null : value * factor);
  const data = () => ({
    name: 'hawser-roller-margins',
    columns: [
      { label: 'roller' },
      { label: 'place', unit: length.symbol },
      ...['steady mean', 'peak', 'rating'].map((label) => ({ label, unit: force.symbol })),
      { label: 'margin' },
    ],
    rows: all.map((load) => [
      load.name,
      scaled(load.place, length.factor),
      scaled(load.steady, force.factor),
      scaled(load.peak, force.factor),
      scaled(load.rating, force.factor),
      load.share === null ? null : 1 - load.share,
    ]),
  });
  const scroll = el('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Rollers by margin' }, table);
  return section('rollers', 'Rollers', figure ? context.figure(figure) : null, scroll, more, csvTools(data));
}
