// Every limit with what was found, what is allowed, how much is used, and where the limit comes from.
import type { Context } from '../context';
import { el, named } from '../dom';
import type { Limit } from '../data';
import { inWords, judged, limitUnit, type Standing } from '../run';
import { digits, sentenceText, scaleOf, show, UNKNOWN } from '../units';
import { note, section, sign, usage } from './parts';
import { csvTools } from '../figure/table';

function standingOf(limit: Limit): Standing {
  if (limit.ok === null) return 'unjudged';
  return limit.ok ? 'safe' : 'unsafe';
}

const WORDS: Record<Standing, string> = {
  safe: 'holds',
  conditional: '',
  unsafe: 'broken',
  unjudged: 'not judged',
  untrusted: '',
};

function row(limit: Limit, context: Context): HTMLElement {
  const { units, store } = context;
  const unit = limitUnit(limit);
  const standing = standingOf(limit);
  const margin = limit.margin === null ? UNKNOWN : `${digits(100 * limit.margin, 3)}\u202f%`;
  const place = /^(-?\d+(?:\.\d+)?) m\b/.exec(limit.where);
  const at = place ? Number(place[1]) : null;
  const point = (on: boolean) => () => {
    if (at !== null) store.set('place', on ? at : null);
  };
  const number = (text: string): HTMLElement => el('td', { class: text === UNKNOWN ? 'unknown' : 'number' }, text);
  return el(
    'tr',
    { class: standing, onmouseenter: point(true), onmouseleave: point(false) },
    el('th', { scope: 'row' }, inWords(limit.name)),
    el(
      'td',
      { class: 'standing' },
      el('span', { class: `standing-word ${standing}` }, sign(standing), WORDS[standing]),
    ),
    number(show(limit.value, unit, units)),
    number(show(limit.limit, unit, units)),
    number(margin),
    el('td', { class: 'usage-cell' }, limit.margin === null ? null : usage(1 - limit.margin, standing)),
    el('td', {}, named(sentenceText(limit.where, units))),
    el('td', { class: 'source' }, named(sentenceText(limit.source, units))),
  );
}

const HEADINGS = ['Limit', '', 'Found', 'Allowed', 'Margin', 'Used', 'Where', 'Source, or why it was not judged'];

export function limitsSection(context: Context): HTMLElement {
  const { run, units } = context;
  const all = run.summary.limits;
  if (!all) return section('limits', 'Limits', note('These results hold no limits: they are of an older hawser.'));
  if (all.length === 0) {
    return section('limits', 'Limits', note('The case has no section “limits”, so nothing was judged.'));
  }
  const ranked = [...judged(run), ...all.filter((limit) => limit.ok === null || limit.margin === null)];
  const head = HEADINGS.map((text) => el('th', { scope: 'col', 'aria-label': text || 'Standing' }, text));
  const table = el(
    'table',
    { class: 'limits' },
    el('caption', {}, 'The smallest margin first. The line in a bar is all that is allowed.'),
    el('thead', {}, el('tr', {}, ...head)),
    el('tbody', {}, ...ranked.map((limit) => row(limit, context))),
  );
  const data = () => ({
    name: 'hawser-limits',
    columns: ['limit', 'standing', 'found', 'allowed', 'unit', 'margin', 'where', 'source'].map((label) => ({ label })),
    rows: ranked.map((limit) => {
      const { symbol, factor } = scaleOf(limitUnit(limit), units, limit.limit ?? limit.value ?? 0);
      const scaled = (value: number | null) => (value === null ? null : value * factor);
      return [
        limit.name,
        WORDS[standingOf(limit)],
        scaled(limit.value),
        scaled(limit.limit),
        symbol,
        limit.margin,
        limit.where,
        limit.source,
      ];
    }),
  });
  const scroll = el('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Table of limits' }, table);
  return section('limits', 'Limits', scroll, csvTools(data));
}
